"""How a suite's program is judged: nothing that ends oddly counts as passed."""

import contextlib
import io
import os
import sys
import tempfile
import time
import unittest

from suite_process import Program, read_counts, run


def outcome(script, seconds=20, engine=True):
    """Judges a Python script; what it prints stays out of this test's own output."""
    with contextlib.redirect_stdout(io.StringIO()):
        return run(Program([sys.executable, "-u", "-c", script], seconds=seconds, engine=engine))


class SuiteProcessTest(unittest.TestCase):
    def check(self, got, passed, failed, *problems):
        self.assertEqual((got.passed, got.failed, got.problems), (passed, failed, list(problems)))

    def test_passes(self):
        self.check(outcome("print('[x] 3 passed, 0 failed')"), 3, 0)

    def test_failed_tests_are_counted_once(self):
        self.check(outcome("print('[x] 3 passed, 2 failed'); raise SystemExit(1)"), 3, 2)

    def test_exit_code_counts(self):
        self.check(outcome("print('[x] 3 passed, 0 failed'); raise SystemExit(134)"), 3, 0, "exit code 134")

    def test_zero_tests(self):
        self.check(outcome("print('[x] 0 passed, 0 failed')"), 0, 0, "ran no test")

    def test_no_result(self):
        self.check(outcome("print('all well')"), 0, 0, "printed no result (exit code 0)")

    def test_crash(self):
        self.check(outcome("import os; os.kill(os.getpid(), 11)"), 0, 0, "printed no result (exit code -11)")

    def test_missing_program(self):
        self.check(run(Program(["/nowhere/tests"], seconds=5)), 0, 0,
                   "/nowhere/tests cannot be started: No such file or directory")

    def test_error_line_in_a_passing_run(self):
        script = "print('ERROR: broken'); print('[x] 3 passed, 0 failed')"
        self.check(outcome(script), 3, 0, "error line: broken")
        self.check(outcome(script, engine=False), 3, 0)

    def test_time_limit_ends_children_too(self):
        with tempfile.TemporaryDirectory() as folder:
            mark = os.path.join(folder, "alive")
            child = f"import time; time.sleep(2.5); open({mark!r}, 'w')"
            script = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {child!r}])"
            self.check(outcome(script, seconds=1), 0, 0, "did not end within 1 s")
            time.sleep(2)
            self.assertFalse(os.path.exists(mark))

    def test_a_fuzz_target_counts_as_one_test(self):
        self.check(outcome("print('Done 2000 runs in 3 second(s)')"), 1, 0)
        self.check(outcome("print('Done 0 runs in 3 second(s)')"), 0, 0, "printed no result (exit code 0)")
        self.check(outcome("print('Done 2000 runs in 3 second(s)'); raise SystemExit(77)"), 1, 0, "exit code 77")

    def test_doctest_summary(self):
        line = "[doctest] test cases:  12 |  11 passed | 1 failed | 0 skipped\n"
        self.assertEqual(read_counts(line), (11, 1))
        self.assertEqual(read_counts("\x1b[0;36m[doctest] \x1b[0mtest cases: 1 | \x1b[0;32m1 passed\x1b[0m | 0 failed"), (1, 0))

    def test_no_result_lines(self):
        for line in ("3 passed, 0 failed", "[x] passed", "[doctest] assertions: 3 | 3 passed | 0 failed |"):
            self.assertIsNone(read_counts(line))
