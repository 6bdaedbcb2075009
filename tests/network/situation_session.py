"""Sessions of the situations in situations/*.gd: one server and its clients, over ENet on this machine."""

import json
import os
import time

from demo_run import DemoProcess, RunFailed, START_SECONDS, free_port
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

    def start(self, engine, folder):
        folder = os.path.join(folder, self.name)
        os.makedirs(folder)
        self._go = os.path.join(folder, "go")
        port = free_port()

        def start(name, role, index):
            arguments = {"role": role, "index": index, "situation": self._situation, "port": port, "go": self._go,
                         "record": os.path.join(folder, name + ".jsonl"), "config": json.dumps(self._config)}
            process = DemoProcess(engine, name, folder, [f"--{key}={value}" for key, value in arguments.items()],
                                  script=MAIN)
            process.record_path = arguments["record"]
            return process

        self.server = start("server", "server", 0)
        self.clients = [start(f"client{index}", "client", index) for index in range(1, self._count + 1)]

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
        for session in sessions:
            session.wait()
    finally:
        for session in sessions:
            session.kill()
