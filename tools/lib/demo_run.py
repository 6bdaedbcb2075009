"""One run of the multiplayer demo: processes of a server and its clients on this machine."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
import uuid

import checkout
import engine_log

SCENE = "res://demos/multiplayer/multiplayer.tscn"
START_SECONDS = 25
LISTENING = "Server on port"
PORT_IN_USE = "Cannot listen on UDP port"
PORT_ATTEMPTS = 5
REPORT = "REPORT "


class RunFailed(Exception):
    """A run failed; the message is one line."""


def free_port():
    """A UDP port that is free at the moment."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def project_command(engine, window=None, script=None):
    """The command that starts the demo in its project, up to its arguments. `window`: its number, which determines its position,
    or None for headless; `script` replaces the demo's scene."""
    screen = ["--headless"]
    if window is not None:
        screen = ["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy", "--resolution", "1152x648",
                  "--position", f"{40 + 60 * window},{40 + 60 * window}"]
    program = ["--script", script] if script else [SCENE]
    return [*engine, *screen, "--path", checkout.PROJECT, *program, "--"]


class DemoProcess:
    """One engine process, with its output in a file."""

    def __init__(self, command, name, folder, arguments, environment=None):
        """`command`: what starts the demo, up to its arguments; `environment`: additional variables."""
        self.name = name
        self.log_path = os.path.join(folder, name + ".log")
        self.record_path = os.path.join(folder, name + ".poses")
        with open(self.log_path, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen([*command, *arguments], stdin=subprocess.DEVNULL, stdout=log,
                                            stderr=subprocess.STDOUT, start_new_session=True,
                                            env={**os.environ, **(environment or {})})

    def is_running(self):
        return self.process.poll() is None

    def log(self):
        with open(self.log_path, encoding="utf-8", errors="replace") as file:
            return file.read()

    def wait_for_line(self, start, seconds):
        """Waits for a line of output that begins with `start`; raises RunFailed after the timeout."""
        end = time.monotonic() + seconds
        while True:
            running = self.is_running()
            if any(line.startswith(start) for line in self.log().splitlines()):
                return
            if not running:
                raise RunFailed(f"{self.name} ended before it printed '{start}'; its last line: {self.last_line()}")
            if time.monotonic() > end:
                raise RunFailed(f"{self.name} did not print '{start}' within {seconds:g} s")
            time.sleep(0.05)

    def report(self):
        """The counters that the process printed at its end; raises RunFailed if there are none."""
        for line in self.log().splitlines():
            if line.startswith(REPORT):
                return json.loads(line[len(REPORT):])
        raise RunFailed(f"{self.name} printed no report; its last line: {self.last_line()}")

    def last_line(self):
        lines = [line.strip() for line in self.log().splitlines() if line.strip()]
        return lines[-1] if lines else "(no output)"

    def check_log(self):
        """Raises RunFailed if the engine logged errors or warnings."""
        problems = engine_log.problems_of(self.log())
        if problems:
            raise RunFailed(f"{self.name}: {problems[0]} ({len(problems)} such lines)")

    def kill(self):
        """Kills the process and its children."""
        if self.is_running():
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()


class DemoRun:
    """A server and its clients. A context manager that kills all processes on exit."""

    def __init__(self, engine, folder, exported=None):
        """`exported`: by role, the command that starts an exported demo, up to its arguments, instead of the project's."""
        self.engine = engine
        self.folder = folder
        self.exported = exported
        self.port = free_port()
        # Clients leave a server of another run, which may have taken the port.
        self.session = uuid.uuid4().hex[:12]
        self.server = None
        self.clients = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in [*self.clients, self.server]:
            if process is not None:
                process.kill()

    def start_server(self, *arguments, script=None):
        """Starts the server; if another process has taken the port, on another one."""
        for attempt in range(PORT_ATTEMPTS):
            self.server = self._start("server", "server", arguments, script=script)
            try:
                self.server.wait_for_line(LISTENING, START_SECONDS)
                return
            except RunFailed:
                if PORT_IN_USE not in self.server.log() or attempt == PORT_ATTEMPTS - 1:
                    raise
                self.server.kill()
                self.port = free_port()

    def start_client(self, *arguments, window=None, script=None):
        name = f"client{len(self.clients) + 1}"
        client = self._start(name, "client", [f"--name=Player {len(self.clients) + 1}", *arguments], window, script)
        self.clients.append(client)
        return client

    def wait(self, seconds, on_progress=None):
        """Waits until all processes have ended; raises RunFailed after the timeout. Calls `on_progress(elapsed seconds)`."""
        start = time.monotonic()
        while True:
            running = [process for process in [*self.clients, self.server] if process.is_running()]
            if not running:
                return
            elapsed = time.monotonic() - start
            if elapsed > seconds:
                raise RunFailed(f"{running[0].name} did not end within {seconds:g} s; its last line: {running[0].last_line()}")
            if on_progress is not None:
                on_progress(elapsed)
            time.sleep(0.1)

    def check_logs(self):
        for process in [self.server, *self.clients]:
            process.check_log()

    def _start(self, name, role, arguments, window=None, script=None):
        command = self.exported[role] if self.exported else project_command(self.engine, window=window, script=script)
        record = os.path.join(self.folder, name + ".poses")
        return DemoProcess(command, name, self.folder, [f"--role={role}", f"--port={self.port}", f"--session={self.session}",
                                                        f"--record={record}", *arguments])


def progress(phase, detail=""):
    """Shows a line that the next one replaces; if the output is not a terminal, prints each phase once."""
    if sys.stderr.isatty():
        print("\r\033[K" + phase + detail, end="", file=sys.stderr, flush=True)
    elif phase and not detail:
        print(phase, file=sys.stderr, flush=True)
