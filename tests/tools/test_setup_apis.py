"""The API descriptions of the engine: downloaded once for their pin, never half."""

import os
import unittest

from machine import Machine

# `vendor --locked --manifest-path FILE FOLDER` creates the package in the folder.
CARGO = """#!/bin/sh
if [ "${FAKE_NETWORK:-}" = down ]; then
    mkdir -p "$5/gdextension-api"
    echo "error: failed to get the package" >&2
    exit 101
fi
[ "$1 $2 $3" = "vendor --locked --manifest-path" ] && mkdir -p "$5/gdextension-api/src"
"""


class SetupApisTest(unittest.TestCase):
    def setUp(self):
        self.machine = Machine()
        self.addCleanup(self.machine.close)
        self.machine.program("cargo", CARGO)
        self.pin("0.5.1")

    def pin(self, version):
        self.machine.write("checkout/tests/versions/Cargo.lock", version)

    def cached(self):
        return [name for name in self.machine.cached() if name.startswith("apis-")]

    def test_downloaded_once(self):
        first = self.machine.run("setup", "--print", "apis")
        second = self.machine.run("setup", "--print", "apis", FAKE_NETWORK="down")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual((second.stdout, second.stderr), (first.stdout, ""))
        self.assertTrue(os.path.isdir(first.stdout.strip()))

    def test_another_pin_makes_another(self):
        self.machine.run("setup", "apis")
        self.pin("0.5.2")
        self.machine.run("setup", "apis")
        self.assertEqual(len(self.cached()), 2)

    def test_no_network(self):
        done = self.machine.run("setup", "--print", "apis", FAKE_NETWORK="down")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("tests/versions/Cargo.toml", done.stderr.splitlines()[-1])
        self.assertIn("network", done.stderr.splitlines()[-1])
        self.assertEqual(self.machine.cached(), [])

    def test_no_cargo(self):
        os.unlink(os.path.join(self.machine.bin, "cargo"))
        done = self.machine.run("setup", "apis", FAKE_PACKAGE="absent")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("cargo", done.stderr.splitlines()[-1])

    def test_incomplete_checkout(self):
        os.unlink(os.path.join(self.machine.folder, "checkout/tests/versions/Cargo.lock"))
        done = self.machine.run("setup", "--print", "apis")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tests/versions/Cargo.lock is missing: this checkout is not complete", done.stderr)
