"""The Python environments of the oracle and of zig: made once for their pins, never half."""

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
elif [ "$1" = -c ]; then
    case $2 in *ziglang*) if [ -e "$(dirname "$0")/installed" ]; then echo /packages/ziglang/zig; else exit 1; fi ;; esac
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


class SetupZigTest(unittest.TestCase):
    def setUp(self):
        self.machine = Machine()
        self.addCleanup(self.machine.close)
        self.machine.program("python3", PYTHON)

    def zig(self, **env):
        return self.machine.run("setup", "--print", "zig", **env)

    def test_zig_is_that_of_the_environment(self):
        first, second = self.zig(), self.zig(FAKE_NETWORK="down")
        self.assertEqual((first.returncode, first.stdout), (0, "/packages/ziglang/zig\n"), first.stderr)
        self.assertEqual((second.returncode, second.stdout, second.stderr), (0, first.stdout, ""))

    def test_no_network(self):
        done = self.zig(FAKE_NETWORK="down")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("cross_requirements.txt", done.stderr.splitlines()[-1])

    def test_a_damaged_environment(self):
        self.zig()
        name, = [name for name in self.machine.cached() if name.startswith("cross-")]
        os.unlink(os.path.join(self.machine.folder, "cache", name, "bin", "installed"))
        done = self.zig()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("is damaged: remove it", done.stderr)
