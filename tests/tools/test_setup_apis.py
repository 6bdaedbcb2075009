"""The API descriptions of the engine: downloaded once for their pin, never half."""

import hashlib
import os
import tarfile
import unittest

from machine import Machine

# `fetch --manifest-path FILE` keeps the archive of the package, which FAKE_ARCHIVE names, like cargo. A version that is too old
# for the package fails afterwards, and reaches the registry only if it is told to.
CARGO = """#!/bin/sh
if [ "$1" = --version ]; then echo "cargo ${FAKE_CARGO:-1.96.0}"; exit; fi
if [ "${FAKE_NETWORK:-}" = down ] || { [ "${FAKE_CARGO:-}" = 1.65.0 ] && [ "${CARGO_UNSTABLE_SPARSE_REGISTRY:-}" != true ]; }; then
    echo "error: failed to get the package" >&2
    exit 101
fi
[ "$1 $2" = "fetch --manifest-path" ] && [ -r "$3" ] || exit 2
mkdir -p "$HOME/.cargo/registry/cache/registry"
cp "$FAKE_ARCHIVE" "$HOME/.cargo/registry/cache/registry/"
[ "${FAKE_CARGO:-}" != 1.65.0 ]
"""


class SetupApisTest(unittest.TestCase):
    def setUp(self):
        self.machine = Machine()
        self.addCleanup(self.machine.close)
        self.machine.program("cargo", CARGO)
        self.archive = os.path.join(self.machine.folder, "gdextension-api-0.5.1.crate")
        with tarfile.open(self.archive, "w:gz") as archive:
            archive.addfile(tarfile.TarInfo("gdextension-api-0.5.1/src/4.6/extension_api.json"))
        self.machine.environment["FAKE_ARCHIVE"] = self.archive
        with open(self.archive, "rb") as file:
            self.pin(hashlib.sha256(file.read()).hexdigest())

    def pin(self, digest, comment=""):
        self.machine.write("checkout/tests/versions/Cargo.toml", f'{comment}[package.metadata]\nsha256 = "{digest}"\n')
        self.digest = digest

    def cached(self):
        return [name for name in self.machine.cached() if name.startswith("apis-")]

    def test_downloaded_once(self):
        first = self.machine.run("setup", "--print", "apis")
        second = self.machine.run("setup", "--print", "apis", FAKE_NETWORK="down")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual((second.stdout, second.stderr), (first.stdout, ""))
        self.assertTrue(os.path.isfile(os.path.join(first.stdout.strip(), "4.6", "extension_api.json")))

    def test_the_cargo_of_debian_12(self):
        done = self.machine.run("setup", "--print", "apis", FAKE_CARGO="1.65.0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.isdir(done.stdout.strip()))

    def test_an_archive_with_another_hash(self):
        self.pin("0" * 64)
        done = self.machine.run("setup", "--print", "apis")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(self.cached(), [])

    def test_another_pin_makes_another(self):
        self.machine.run("setup", "apis")
        self.pin(self.digest, "# another version\n")
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
        os.unlink(os.path.join(self.machine.folder, "checkout/tests/versions/Cargo.toml"))
        done = self.machine.run("setup", "--print", "apis")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tests/versions/Cargo.toml is missing: this checkout is not complete", done.stderr)
