"""Sessions of the situations in situations/*.gd: one server and its clients, over ENet on this machine."""

import json
import os
import time

from demo_run import DemoProcess, RunFailed, START_SECONDS, free_port, project_command
from situation_record import Record

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "situations")
MAIN = os.path.join(FOLDER, "main.gd")
SPARE_SECONDS = 20


class Session:
    """A server and `clients` clients in the situation SITUATION.gd, configured by `config`."""

    def __init__(self, name, situation, clients=1, seconds=5.0, **config):
        self.name = name
        self.server = None
        self.clients = []
        self.seconds = seconds
        self.properties = config.get("properties", {})
        self._situation = situation
        self._count = clients
        self._config = {**config, "clients": clients, "seconds": seconds}
        # (seconds after the begin, function without arguments), for run_together().
        self.actions = []

    def start(self, engine, folder):
        self._engine = engine
        self._folder = os.path.join(folder, self.name)
        os.makedirs(self._folder)
        self._go = os.path.join(self._folder, "go")
        self.port = free_port()
        self.server = self.start_process("server", "server", 0)
        self.clients = [self.start_process(f"client{index}", "client", index) for index in range(1, self._count + 1)]

    def start_process(self, name, role, index):
        arguments = {"role": role, "index": index, "situation": self._situation, "port": self.port_of(role), "go": self._go,
                     "record": os.path.join(self._folder, name + ".jsonl"), "config": json.dumps(self._config)}
        process = DemoProcess(project_command(self._engine, script=MAIN), name, self._folder,
                              [f"--{key}={value}" for key, value in arguments.items()], self.environment_of(name))
        process.record_path = arguments["record"]
        return process

    def port_of(self, _role):
        """The port to which a process binds or connects."""
        return self.port

    def environment_of(self, _name):
        """Additional environment variables of a process."""
        return {}

    def wait_until_ready(self):
        self.server.wait_for_line("READY", START_SECONDS)

    def begin(self):
        with open(self._go, "w", encoding="utf-8"):
            pass

    def wait(self):
        """Waits until all processes have ended and reads their records."""
        end = time.monotonic() + self.seconds + SPARE_SECONDS
        for process in self.processes():
            while process.is_running():
                if time.monotonic() > end:
                    raise RunFailed(f"{self.name}: {process.name} did not end; its last line: {process.last_line()}")
                time.sleep(0.05)
        for process in self.processes():
            process.record = Record(process.record_path)

    def processes(self):
        return [self.server, *self.clients]

    def kill(self):
        for process in self.processes():
            if process is not None:
                process.kill()


def run_together(run, sessions):
    """Runs sessions at the same time; all of them begin once every process has started."""
    try:
        for session in sessions:
            session.start(run.engine, run.folder)
        for session in sessions:
            session.wait_until_ready()
        for session in sessions:
            session.begin()
        begin = time.monotonic()
        actions = [action for session in sessions for action in session.actions]
        for at, action in sorted(actions, key=lambda item: item[0]):
            time.sleep(max(0.0, begin + at - time.monotonic()))
            action()
        for session in sessions:
            session.wait()
    finally:
        for session in sessions:
            session.kill()
