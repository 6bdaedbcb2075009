"""Finds problems in an engine's output that its exit code does not report.

Godot exits with 0 after script errors, failed asserts and leaks. Each of these is
a problem, unless a test has announced the error by printing a line

    [expect] the exact message

which permits one error with that message. An announced error that is not printed
is a problem, too. The order of the two lines does not matter, because they are
printed to different streams.
"""

import re
from collections import Counter

ANNOUNCEMENT = re.compile(r"^\[expect\] (.*\S)\s*$")
# "ERROR: ..", "USER ERROR: ..", "SCRIPT ERROR: ..": the engine's own, push_error's and GDScript's.
# A match anywhere in the line, since another stream's text may stand before it.
ERROR = re.compile(r"\bERROR: ?(.*)$")
LEAK = re.compile(
    r"leaked at exit|still in use at exit|were leaked|orphan StringName|unclaimed string names?"
    r"|StringName was orphaned|runtime error: |Program crashed|Segmentation fault",
    re.IGNORECASE,
)
# What the engine prints below an error.
ORIGIN = re.compile(r"^\s+(at: |GDScript backtrace|C\+\+ backtrace|\[\d+\] )")
COLOR = re.compile(r"\x1b\[[0-9;]*m")


class EngineLog:
    """Reads the lines of one engine run and reports its problems."""

    def __init__(self):
        self._announced = Counter()
        self._errors = Counter()
        self._leaks = Counter()
        self._below_announced = False

    def feed(self, line):
        """Reads one line, with or without its line ending. Returns whether to show it: announcements and the
        errors that they announce are hidden."""
        line = COLOR.sub("", line).rstrip()
        if self._below_announced and ORIGIN.match(line):
            return False
        self._below_announced = False
        announcement = ANNOUNCEMENT.match(line)
        if announcement:
            self._announced[announcement.group(1)] += 1
            return False
        error = ERROR.search(line)
        if error:
            message = error.group(1).strip()
            self._below_announced = self._errors[message] < self._announced[message]
            self._errors[message] += 1
        elif LEAK.search(line):
            self._leaks[line.strip()] += 1
        return not self._below_announced

    def problems(self):
        """One line for each unexpected error, expected error that was not printed, and leak."""
        found = [counted("error line: " + message, count) for message, count in (self._errors - self._announced).items()]
        found += [counted("expected error was not printed: " + message, count)
                  for message, count in (self._announced - self._errors).items()]
        return found + [counted(line, count) for line, count in self._leaks.items()]


def counted(message, count):
    """The message, with the number of times it occurred if more than once."""
    return f"{message} ({count} times)" if count > 1 else message


def problems_of(text):
    """The problems of a whole output."""
    log = EngineLog()
    for line in text.splitlines():
        log.feed(line)
    return log.problems()
