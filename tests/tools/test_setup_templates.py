"""Which export templates setup takes, how it fetches them, and what it says when it cannot."""

import os
import unittest

from machine import FEDORA, Machine, engine_script

MACHINE = os.uname().machine
ARCH = {"aarch64": "arm64"}.get(MACHINE, MACHINE)
CACHED = ["engine-" + MACHINE, "templates-" + MACHINE]


class SetupTemplatesTest(unittest.TestCase):
    def machine(self, *system):
        machine = Machine(*system)
        self.addCleanup(machine.close)
        return machine

    def print_templates(self, machine, **environment):
        return machine.run("setup", "--print", "templates", **environment)

    def test_fetched_once_with_the_engine(self):
        machine = self.machine()
        first = self.print_templates(machine)
        self.assertEqual(first.returncode, 0, first.stderr)
        folder = os.path.join(machine.cache, CACHED[1])
        self.assertEqual((first.stdout, machine.cached()), (folder + "\n", CACHED))
        self.assertEqual(sorted(os.listdir(folder)), [f"linux_debug.{ARCH}", f"linux_release.{ARCH}"])
        second = self.print_templates(machine, FAKE_NETWORK="down")
        self.assertEqual((second.stdout, second.stderr), (first.stdout, ""))

    def test_the_engine_follows_a_newer_suite(self):
        machine = self.machine()
        machine.run("setup", "engine")
        machine.make_package("4.7.1")
        done = self.print_templates(machine, FAKE_VERSION="4.7.1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(machine.cached(), CACHED)
        self.assertEqual(machine.run("godot", "--version").stdout, "4.7.1.stable.debian\n")

    def test_outdated_ones_are_replaced(self):
        machine = self.machine()
        for kind in ("debug", "release"):
            machine.write(f"cache/{CACHED[1]}/linux_{kind}.{ARCH}", engine_script("4.6.2.stable.debian"), executable=True)
        self.assertEqual(self.print_templates(machine).returncode, 0)
        with open(os.path.join(machine.cache, CACHED[1], f"linux_debug.{ARCH}"), encoding="utf-8") as file:
            self.assertIn("4.6.3", file.read())

    def test_those_of_a_given_engine(self):
        machine = self.machine(FEDORA)
        engine = machine.write("mine/godot", engine_script("4.7.rc1.official.0123abcde"), executable=True)
        missing = self.print_templates(machine, GODOT=engine)
        self.assertEqual((missing.returncode, missing.stdout), (1, ""))
        self.assertIn("the export templates of Godot 4.7.rc1 are missing", missing.stderr)
        self.assertIn("Manage Export Templates", missing.stderr)
        for kind in ("debug", "release"):
            machine.write(f".local/share/godot/export_templates/4.7.rc1/linux_{kind}.{ARCH}",
                          engine_script("4.7.rc1.official.0123abcde"), executable=True)
        found = self.print_templates(machine, GODOT=engine)
        self.assertEqual(found.stdout, os.path.join(machine.folder, ".local/share/godot/export_templates/4.7.rc1") + "\n")

    def test_no_network(self):
        machine = self.machine()
        machine.run("setup", "engine")
        done = self.print_templates(machine, FAKE_NETWORK="down")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("the export templates are missing and the package site does not respond", done.stderr.splitlines()[-1])
        self.assertEqual(machine.cached(), CACHED[:1])


if __name__ == "__main__":
    unittest.main()
