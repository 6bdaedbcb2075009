"""Runs the engine on a display and captures its output."""

import os
import shlex
import subprocess
from dataclasses import dataclass

import engine_log

# Options that need neither a graphics card nor a sound card.
DRAWING = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]


@dataclass
class Run:
    """The result of one run: the exit code, None after a timeout, and the output."""

    code: object
    text: str

    def problems(self):
        """Lines of the output that report errors."""
        return engine_log.problems_of(self.text)


class Engine:
    """An engine command with its environment."""

    def __init__(self, command, environment):
        self._command = shlex.split(command)
        self._environment = {**os.environ, **environment}

    def with_environment(self, variables):
        """A copy with further environment variables."""
        return Engine(shlex.join(self._command), {**self._environment, **variables})

    def run(self, arguments, seconds, drawing=True):
        """Runs the engine, for at most `seconds`."""
        command = self._command + (DRAWING if drawing else ["--headless"]) + arguments
        try:
            done = subprocess.run(command, env=self._environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds, text=True,
                                  errors="replace", check=False)
        except subprocess.TimeoutExpired as stopped:
            output = stopped.stdout or b""
            text = output.decode(errors="replace") if isinstance(output, bytes) else output
            return Run(None, text + f"\nstopped after {seconds} s\n")
        return Run(done.returncode, done.stdout)
