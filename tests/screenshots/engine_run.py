"""Runs the engine on a display and keeps what it says."""

import os
import shlex
import subprocess
from dataclasses import dataclass

import engine_log

# The renderer that runs without a graphics card, and no sound card needed.
DRAWING = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy"]


@dataclass
class Run:
    """The end of one run: its exit code (None if it was stopped for taking too long) and its output."""

    code: object
    text: str

    def problems(self):
        """Lines that no run should have."""
        return engine_log.problems_of(self.text)


class Engine:
    """An engine command, and the environment that it draws in."""

    def __init__(self, command, environment, folder=None):
        self._command = shlex.split(command)
        self._folder = folder
        self._environment = {**os.environ, **environment}

    def with_environment(self, variables):
        """The same engine with more variables."""
        return Engine(shlex.join(self._command), {**self._environment, **variables}, self._folder)

    def in_folder(self, folder):
        """The same engine, started in that folder."""
        return Engine(shlex.join(self._command), self._environment, folder)

    def run(self, arguments, seconds, drawing=True):
        """Starts the engine and waits for it, at most that long."""
        command = self._command + (DRAWING if drawing else ["--headless"]) + arguments
        try:
            done = subprocess.run(command, cwd=self._folder, env=self._environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds, text=True,
                                  errors="replace", check=False)
        except subprocess.TimeoutExpired as stopped:
            output = stopped.stdout or b""
            text = output.decode(errors="replace") if isinstance(output, bytes) else output
            return Run(None, text + f"\nstopped after {seconds} s\n")
        return Run(done.returncode, done.stdout)
