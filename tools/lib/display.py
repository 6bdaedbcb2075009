"""A display of its own for whatever draws: Xvfb on a number that is free."""

import os
import subprocess
from contextlib import contextmanager

SCREEN = "1280x800x24"
START_SECONDS = 20


@contextmanager
def display():
    """Yields the environment variables by which a program draws on a fresh Xvfb, ended afterwards."""
    read_end, write_end = os.pipe()
    # The server itself picks a free number and writes it once it takes connections.
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
        # A Wayland session of the user's would be preferred by some programs.
        yield {"DISPLAY": ":" + number, "WAYLAND_DISPLAY": ""}
    finally:
        server.terminate()
        try:
            server.wait(timeout=START_SECONDS)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()
