"""Sessions (situation_session.py) whose processes, network or clocks fail."""

import os
import signal
import struct
import subprocess
import time

from demo_run import START_SECONDS
from situation_session import Session
from udp_proxy import UdpProxy

SHIM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "step_clock.c")
CLOCK_STEP = 3600


class CutSession(Session):
    """Its clients reach the server through a proxy, which loses everything for `cut_seconds`."""

    def __init__(self, name, cut_at, cut_seconds, **options):
        super().__init__(name, "outage", **options)
        self._proxy = None
        self.actions = [(cut_at, lambda: self._set_cut(True)), (cut_at + cut_seconds, lambda: self._set_cut(False))]

    def port_of(self, role):
        if role == "server":
            return self.port
        self._proxy = self._proxy or UdpProxy(self.port)
        return self._proxy.port

    def kill(self):
        super().kill()
        if self._proxy is not None:
            self._proxy.close()

    def _set_cut(self, is_cut):
        self._proxy.is_cut = is_cut


class StopSession(Session):
    """The server's process, or the client's, is stopped for `stop_seconds`."""

    def __init__(self, name, stop_at, stop_seconds, stops_server, **options):
        super().__init__(name, "outage", **options)
        self._stops_server = stops_server
        self.actions = [(stop_at, lambda: self._signal(signal.SIGSTOP)),
                        (stop_at + stop_seconds, lambda: self._signal(signal.SIGCONT))]

    def _signal(self, number):
        process = self.server if self._stops_server else self.clients[0]
        process.process.send_signal(number)


class RestartSession(Session):
    """The last client is killed, then the server, which starts again on the same port without that client."""

    def __init__(self, name, kill_at, restart_at, **options):
        super().__init__(name, "outage", **options)
        self.killed = []
        self.actions = [(kill_at - 0.5, self._kill_client), (kill_at, self._kill_server), (restart_at, self._restart_server)]

    def kill(self):
        super().kill()
        for process in self.killed:
            process.kill()

    def _kill_client(self):
        self.killed.append(self.clients.pop())
        self.killed[-1].kill()

    def _kill_server(self):
        self.killed.append(self.server)
        self.server.kill()

    def _restart_server(self):
        self._config["clients"] = len(self.clients)
        self.server = self.start_process("server2", "server", 0)
        self.server.wait_for_line("READY", START_SECONDS)


class ClockSession(Session):
    """The wall clocks of its processes step, each at another time: `steps` are (seconds, process, multiple of CLOCK_STEP)."""

    def __init__(self, name, steps, **options):
        super().__init__(name, "motion", **options)
        self._begin = time.time()
        self.actions = [(at, lambda process=process, multiple=multiple: self._step(process, multiple))
                        for at, process, multiple in steps]

    def environment_of(self, name):
        library = os.path.join(os.path.dirname(self._folder), "step_clock.so")  # a path without spaces
        if not os.path.exists(library):
            subprocess.run(["cc", "-shared", "-fPIC", "-o", library, SHIM, "-ldl"], check=True)
        self._step(name, 0)
        return {"LD_PRELOAD": library, "STEP_CLOCK_FILE": self._file(name)}

    def wait(self):
        super().wait()
        for process in self.processes():
            process.record.remove_steps(CLOCK_STEP, self._begin)

    def _file(self, name):
        return os.path.join(self._folder, name + ".step")

    def _step(self, name, multiple):
        # Without a moment in which the file is shorter.
        with open(self._file(name), "r+b" if os.path.exists(self._file(name)) else "wb") as file:
            file.write(struct.pack("=q", multiple * CLOCK_STEP))
