"""A UDP proxy between clients and a server on this machine, which can cut the line."""

import select
import socket
import threading

MAX_DATAGRAM = 65536


class UdpProxy:
    """Forwards datagrams in a thread of its own. Each client gets a socket towards the server."""

    def __init__(self, server_port):
        self.is_cut = False
        self._server = ("127.0.0.1", server_port)
        self._front = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._front.bind(("127.0.0.1", 0))
        self.port = self._front.getsockname()[1]
        self._backs = {}  # by the client's address
        self._is_open = True
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self):
        self._is_open = False
        self._thread.join()
        for end in (self._front, *self._backs.values()):
            end.close()

    def _run(self):
        while self._is_open:
            ends = [self._front, *self._backs.values()]
            for end in select.select(ends, [], [], 0.1)[0]:
                try:
                    self._forward(end)
                except OSError:
                    pass  # the server or the client has left

    def _forward(self, end):
        data, sender = end.recvfrom(MAX_DATAGRAM)
        if end is self._front and sender not in self._backs:
            self._backs[sender] = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._backs[sender].bind(("127.0.0.1", 0))
        if self.is_cut:
            return
        if end is self._front:
            self._backs[sender].sendto(data, self._server)
            return
        client = next(address for address, back in self._backs.items() if back is end)
        self._front.sendto(data, client)
