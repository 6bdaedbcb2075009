"""A private X display for programs that draw: Xvfb on a free display number."""

import os
import subprocess
from contextlib import contextmanager

SCREEN = "1280x800x24"
START_SECONDS = 20


@contextmanager
def display():
    """Yields the environment variables that make a program draw on a new Xvfb, which ends afterwards."""
    read_end, write_end = os.pipe()
    # The server picks a free number and writes it when it accepts connections.
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write_end), "-screen", "0", SCREEN, "-nolisten", "tcp"],
        pass_fds=[write_end], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )
    os.close(write_end)
    try:
        with os.fdopen(read_end) as number_pipe:
            number = number_pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start: is another X server holding all displays, or /tmp full?")
        # Some programs would prefer the user's Wayland session.
        yield {"DISPLAY": ":" + number, "WAYLAND_DISPLAY": ""}
    finally:
        server.terminate()
        try:
            server.wait(timeout=START_SECONDS)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()
