"""System packages: what setup does with and without root, and what it says when it cannot."""

import os
import unittest

from machine import DEBIAN, FEDORA, Machine


class SetupPackagesTest(unittest.TestCase):
    def machine(self, system=DEBIAN, present=()):
        machine = Machine(system)
        self.addCleanup(machine.close)
        for name in present:
            machine.program(name)
        return machine

    def fails(self, done, *words):
        """It ended with an error; its last line says why, and nothing was printed as an answer."""
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stdout, "")
        last = done.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("setup: "), done.stderr)
        for word in words:
            self.assertIn(word, last)

    def test_all_there_says_nothing(self):
        machine = self.machine(present=("python3", "g++", "scons"))
        done = machine.run("setup", "build")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(machine.cached(), [])

    def test_all_there_on_another_system(self):
        machine = self.machine(FEDORA, present=("python3", "g++", "scons"))
        self.assertEqual(machine.run("setup", "build").returncode, 0)

    def test_another_system(self):
        done = self.machine(FEDORA, present=("python3", "g++")).run("setup", "build")
        self.fails(done, "scons", "Debian and Ubuntu", "Fedora Linux 43")
        self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_no_root_and_no_sudo(self):
        machine = self.machine(present=("python3", "g++"))
        machine.as_user(1000)
        done = machine.run("setup", "build")
        self.fails(done, "sudo apt-get install scons")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual(machine.apt_calls("install"), 0)

    def test_sudo_that_asks_for_a_password(self):
        machine = self.machine(present=("python3", "g++"))
        machine.as_user(1000)
        machine.program("sudo", "#!/bin/sh\necho 'sudo: a password is required' >&2\nexit 1\n")
        self.fails(machine.run("setup", "build"), "sudo apt-get install scons")

    def test_sudo_without_password(self):
        machine = self.machine(present=("python3", "g++"))
        machine.as_user(1000)
        machine.program("sudo", '#!/bin/sh\n[ "$1" = -n ] || exit 1\nshift\nexec "$@"\n')
        self.assertEqual(machine.run("setup", "build").returncode, 0)

    def test_installs_only_what_is_missing(self):
        machine = self.machine(present=("g++",))
        done = machine.run("setup", "build")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("installing python3 scons", done.stderr)
        self.assertNotIn("g++", done.stderr)
        self.assertEqual(machine.apt_calls("update"), 0)
        self.assertEqual(machine.cached(), [])

    def test_old_lists_are_read_anew(self):
        machine = self.machine(present=("python3", "g++"))
        done = machine.run("setup", "build", FAKE_LISTS="old")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(machine.apt_calls("update"), 1)

    def test_no_network(self):
        machine = self.machine(present=("python3", "g++"))
        done = machine.run("setup", "build", FAKE_LISTS="old", FAKE_NETWORK="down")
        self.fails(done, "package lists cannot be read", "network")
        self.assertEqual(machine.cached(), [])

    def test_network_that_goes_away(self):
        machine = self.machine(present=("python3", "g++"))
        done = machine.run("setup", "build", FAKE_NETWORK="gone")
        self.fails(done, "could not install scons", "no network; connect and run the same command again")

    def test_package_that_no_source_has(self):
        machine = self.machine(present=("python3", "g++"))
        self.fails(machine.run("setup", "build", FAKE_PACKAGE="absent"), "not in this system's sources: scons")

    def test_installed_yet_not_usable(self):
        machine = self.machine(present=("python3", "g++"))
        os.unlink(machine.environment["FAKE_PROGRAM"])
        self.fails(machine.run("setup", "build"), "not usable: scons")

    def test_clang_tools(self):
        for version, is_installed in (("18.1.3", True), ("20.1.0", False)):
            machine = self.machine(present=("python3",))
            for name in ("clang-format", "clang-tidy"):
                machine.program(name, f'#!/bin/sh\necho "Ubuntu {name} version {version} (1ubuntu1)"\n')
            machine.run("setup", "style", FAKE_PACKAGE="absent")
            self.assertEqual(machine.apt_calls("clang-tidy-19") > 0, is_installed, version)
        machine = self.machine(present=("python3", "clang-format-19", "clang-tidy-19"))
        machine.run("setup", "style", FAKE_PACKAGE="absent")
        self.assertEqual(machine.apt_calls("clang-tidy-19"), 0)

    def test_unknown_part(self):
        self.fails(self.machine().run("setup", "everything"), "unknown part 'everything'", "--help")

    def test_help_needs_nothing(self):
        machine = self.machine(FEDORA)
        for tool in ("setup", "test", "format", "demo", "bench"):
            done = machine.run(tool, "--help")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"tools/{tool}", done.stdout)
        self.assertEqual(machine.cached(), [])
