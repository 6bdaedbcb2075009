"""Runs one program of a suite: shows its output at once, limits its time, and counts its results."""

import os
import re
import signal
import subprocess
import threading
import time
from dataclasses import dataclass, field

import checkout
from engine_log import EngineLog

# The last line of this project's runners, the summary of doctest, and that of a fuzz target, which counts as one test.
COUNTS = (
    re.compile(r"^\[[\w.-]+\] (?P<passed>\d+) passed, (?P<failed>\d+) failed$"),
    re.compile(r"^\[doctest\] test cases: +\d+ \| +(?P<passed>\d+) passed \| +(?P<failed>\d+) failed"),
)
FUZZED = re.compile(r"^Done [1-9]\d* runs in \d+ second\(s\)$")
COLOR = re.compile(r"\x1b\[[0-9;]*m")
SILENCE_SECONDS = 10


@dataclass
class Program:
    """A program of a suite and its limits."""

    argv: list
    seconds: float
    env: dict = field(default_factory=dict)
    # Whether the output contains an engine's log, which is checked for errors and leaks.
    engine: bool = True
    # Lines that are not shown.
    hidden: re.Pattern = None
    # Gets each line of the output by feed(line), and end() after the last.
    listener: object = None


@dataclass
class Outcome:
    """The result of a program; each problem counts as a failed test."""

    passed: int = 0
    failed: int = 0
    problems: list = field(default_factory=list)


def run(program):
    """Runs a program and returns its Outcome."""
    try:
        process = subprocess.Popen(
            program.argv, cwd=checkout.ROOT, env={**os.environ, **program.env}, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
        )
    except OSError as error:
        return Outcome(problems=[f"{program.argv[0]} cannot be started: {error.strerror}"])
    watch = Watch(process, program.seconds)
    log = EngineLog()
    counts = None
    try:
        for line in process.stdout:
            watch.heard()
            if program.listener:
                program.listener.feed(line)
            if (log.feed(line) or not program.engine) and not (program.hidden and program.hidden.match(line)):
                print(line, end="", flush=True)
            counts = read_counts(line) or counts
        process.wait()
    finally:
        watch.end()
        if program.listener:
            program.listener.end()
    outcome = Outcome(*(counts or (0, 0)))
    if watch.timed_out:
        outcome.problems.append(f"did not end within {program.seconds:g} s")
    elif counts is None:
        outcome.problems.append(f"printed no result (exit code {process.returncode})")
    elif process.returncode != 0 and outcome.failed == 0:
        outcome.problems.append(f"exit code {process.returncode}")
    elif counts == (0, 0):
        outcome.problems.append("ran no test")
    if program.engine:
        outcome.problems += log.problems()
    return outcome


def read_counts(line):
    """(passed, failed) if the line is a result, else None."""
    text = COLOR.sub("", line).strip()
    for pattern in COUNTS:
        match = pattern.match(text)
        if match:
            return int(match["passed"]), int(match["failed"])
    return (1, 0) if FUZZED.match(text) else None


class Watch:
    """Ends a process group that exceeds its time limit, and prints a line regularly while it is silent."""

    def __init__(self, process, seconds):
        self.timed_out = False
        self._process = process
        self._started = self._last_heard = time.monotonic()
        self._seconds = seconds
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._look, daemon=True)
        self._thread.start()

    def heard(self):
        """The process has printed something."""
        self._last_heard = time.monotonic()

    def end(self):
        """Ends the run and all processes that it started."""
        self._done.set()
        self._thread.join()
        self._kill()
        self._process.wait()

    def _look(self):
        while not self._done.wait(0.5):
            now = time.monotonic()
            if now - self._started > self._seconds:
                self.timed_out = True
                self._kill()
                return
            if now - self._last_heard > SILENCE_SECONDS:
                self._last_heard = now
                print(f"... {now - self._started:.0f} s", flush=True)

    def _kill(self):
        try:
            os.killpg(self._process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
