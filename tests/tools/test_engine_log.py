"""What the filter of engine output lets through and what it reports."""

import unittest

from engine_log import EngineLog, problems_of

# output, problems
CASES = {
    "clean": ("Godot Engine v4.6\nall well\nWARNING: only a warning\n", []),
    "engine error": ("ERROR: no such file\n   at: open (core/io/file.cpp:1)\n", ["error line: no such file"]),
    "push_error": ("USER ERROR: mine\n", ["error line: mine"]),
    "script error": ("SCRIPT ERROR: Invalid call\n", ["error line: Invalid call"]),
    "colored": ("\x1b[1;31mERROR:\x1b[0;91m no such file\x1b[0m\n", ["error line: no such file"]),
    "after other text": ("no line end beforeERROR: late\nfine ERROR: x\n", ["error line: x"]),
    "leaked object": ("WARNING: 1 ObjectDB instance leaked at exit.\n", ["WARNING: 1 ObjectDB instance leaked at exit."]),
    "resource in use": ("ERROR: 2 resources still in use at exit.\n", ["error line: 2 resources still in use at exit."]),
    "orphan name": ("Orphan StringName: foo (static: 0, total: 1)\n", ["Orphan StringName: foo (static: 0, total: 1)"]),
    "sanitizer": ("a.cpp:3:1: runtime error: signed overflow\n", ["a.cpp:3:1: runtime error: signed overflow"]),
    "the same error again": ("ERROR: bad\nERROR: bad\nERROR: worse\n", ["error line: bad (2 times)", "error line: worse"]),
    "announced": ("[expect] bad input\nERROR: bad input\n", []),
    "announced later": ("SCRIPT ERROR: bad input\n[expect] bad input\n", []),
    "announced once, came twice": ("[expect] bad\nERROR: bad\nERROR: bad\n", ["error line: bad"]),
    "announced, other came": (
        "[expect] bad\nERROR: worse\n", ["error line: worse", "expected error was not printed: bad"]),
    "announced, none came": ("[expect] bad\n", ["expected error was not printed: bad"]),
    "a leak cannot be announced": (
        "[expect] 1 instance leaked at exit\nWARNING: 1 instance leaked at exit\n",
        ["expected error was not printed: 1 instance leaked at exit", "WARNING: 1 instance leaked at exit"]),
    "word in a name": ("TERROR: not an error\nERRORS none\n", []),
}


class EngineLogTest(unittest.TestCase):
    def test_cases(self):
        for name, (output, problems) in CASES.items():
            with self.subTest(name):
                self.assertEqual(problems_of(output), problems)

    def test_announced_errors_are_not_shown(self):
        announced = ["[expect] bad", "ERROR: bad", "   at: f (a.cpp:1)", "   GDScript backtrace (most recent call first):",
                     "       [0] _ready (res://a.gd:1)"]
        surprise = ["ERROR: worse", "   at: f (a.cpp:1)", "all well"]
        log = EngineLog()
        self.assertEqual([line for line in announced + surprise + announced[1:3] if log.feed(line)],
                         surprise + announced[1:3])
