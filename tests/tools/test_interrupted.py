"""tools/test that is interrupted ends what it started."""

import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import checkout

SUITE = """
import os, sys
sys.path.insert(0, {lib!r})
import suites, suite_process, test
child = "import os, time; print(os.getpid(), flush=True); time.sleep(60)"
program = suite_process.Program([sys.executable, "-c", child], seconds=60)
test.SUITES = (suites.Suite("slow", (), (), lambda: [program], display=True),)
test.checkout.setup = lambda *parts: None
sys.argv = ["test"]
test.main()
"""


class InterruptedTest(unittest.TestCase):
    def test_signals(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number), tempfile.TemporaryFile("w+") as output:
                script = SUITE.format(lib=os.path.join(checkout.TOOLS, "lib"))
                process = subprocess.Popen([sys.executable, "-c", script], stdin=subprocess.DEVNULL, stdout=output)
                child = self.wait_for_number(output)
                self.assertTrue(os.path.exists(f"/proc/{child}"))
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=10), 128 + number)
                self.assertFalse(os.path.exists(f"/proc/{child}"))

    def wait_for_number(self, output):
        """The number that the suite's program prints: its process id."""
        until = time.monotonic() + 10
        while time.monotonic() < until:
            output.seek(0)
            numbers = [line for line in output.read().splitlines() if line.isdigit()]
            if numbers:
                return int(numbers[0])
            time.sleep(0.05)
        self.fail("the suite did not start")
