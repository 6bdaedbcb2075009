"""The Python environment of the oracle: made once for its pins, never half."""

import os
import unittest

from machine import Machine

# `-m venv FOLDER` makes an interpreter that notes what it is asked to install.
PYTHON = """#!/bin/sh
if [ "$1 $2" = "-m venv" ]; then
    mkdir -p "$3/bin"
    cp "$0" "$3/bin/python"
elif [ "$1 $2" = "-m pip" ]; then
    echo pip >>"$FAKE_LOG.pip"
    if [ "${FAKE_NETWORK:-}" = down ]; then echo "ERROR: No matching distribution" >&2; exit 1; fi
    touch "$(dirname "$0")/installed"
fi
"""


class SetupOracleTest(unittest.TestCase):
    def setUp(self):
        self.machine = Machine()
        self.addCleanup(self.machine.close)
        self.machine.program("python3", PYTHON)
        self.pin("clifford==1.5.1\n")
        self.machine.write("checkout/tests/oracle/requirements_alone.txt", "pytransform3d==3.17.0\n")

    def pin(self, text):
        self.machine.write("checkout/tests/oracle/requirements.txt", text)

    def environments(self):
        return [name for name in self.machine.cached() if name.startswith("oracle-")]

    def test_made_once(self):
        first = self.machine.run("setup", "--print", "oracle")
        second = self.machine.run("setup", "--print", "oracle", FAKE_NETWORK="down")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual((second.stdout, second.stderr), (first.stdout, ""))
        self.assertTrue(os.path.exists(os.path.join(os.path.dirname(first.stdout.strip()), "installed")))

    def test_other_pins_make_another(self):
        self.machine.run("setup", "--print", "oracle")
        self.pin("clifford==1.5.0\n")
        self.machine.run("setup", "--print", "oracle")
        self.assertEqual(len(self.environments()), 2)

    def test_other_pins_alone_make_another(self):
        self.machine.run("setup", "--print", "oracle")
        self.machine.write("checkout/tests/oracle/requirements_alone.txt", "pytransform3d==3.16.0\n")
        self.machine.run("setup", "--print", "oracle")
        self.assertEqual(len(self.environments()), 2)

    def test_no_network(self):
        done = self.machine.run("setup", "--print", "oracle", FAKE_NETWORK="down")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("tests/oracle/requirements.txt", done.stderr.splitlines()[-1])
        self.assertIn("network", done.stderr.splitlines()[-1])
        self.assertEqual(self.machine.cached(), [])

    def test_incomplete_checkout(self):
        for name in ("requirements_alone.txt", "requirements.txt"):
            os.unlink(os.path.join(self.machine.folder, "checkout/tests/oracle", name))
            done = self.machine.run("setup", "--print", "oracle")
            self.assertIn(f"{name} is missing: this checkout is not complete", done.stderr)
            self.assertEqual(done.returncode, 1)
