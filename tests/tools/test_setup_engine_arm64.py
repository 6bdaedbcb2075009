"""How setup fetches the engine for arm64, and what starts it."""

import os
import unittest

from machine import FEDORA, Machine

CACHED = "engine-arm64"
# Runs the program that the real one would emulate, and tells what it was given.
QEMU = '#!/bin/sh\n[ "$6" = --version ] || echo "$1=$2 $3=$4 program=$5"\nshift 4\nexec "$@"\n'


class SetupEngineArm64Test(unittest.TestCase):
    def machine(self, *system):
        machine = Machine(*system)
        self.addCleanup(machine.close)
        machine.program("aarch64-linux-gnu-g++")
        machine.program("qemu-aarch64-static", QEMU)
        return machine

    def settings(self, machine, name):
        """A file that apt-get was last given when it was asked what it would download."""
        with open(os.path.join(machine.folder, name), encoding="utf-8") as file:
            return file.read()

    def test_starts_in_qemu(self):
        machine = self.machine()
        done = machine.run("setup", "--print", "engine_arm64")
        folder = os.path.join(machine.cache, CACHED)
        self.assertEqual((done.returncode, done.stdout), (0, f"{folder}/godot\n"), done.stderr)
        self.assertEqual(machine.cached(), [CACHED])
        with open(f"{folder}/lib/some-linux-gnu/ld-linux-some.so.2", encoding="utf-8") as loader:
            self.assertTrue(loader.read())
        started = machine.execute(done.stdout.strip(), "--headless", "a b")
        self.assertEqual((started.returncode, started.stdout),
                         (7, f"-cpu=cortex-a72 -L={folder} program={folder}/usr/bin/godot\n--headless a b drivers=none\n"))

    def test_asks_for_packages_of_arm64_only_for_this_engine(self):
        machine = self.machine()
        machine.run("setup", "engine_arm64", "engine")
        self.assertIn("[arch=amd64 ", self.settings(machine, "sources.list"))
        self.assertNotIn("APT::Architecture", self.settings(machine, "apt.conf"))
        self.assertEqual(machine.cached(), [CACHED, "engine-" + os.uname().machine])
        machine = self.machine()
        machine.run("setup", "engine", "engine_arm64")
        self.assertIn("[arch=arm64 ", self.settings(machine, "sources.list"))
        self.assertIn('APT::Architecture "arm64";', self.settings(machine, "apt.conf"))
        self.assertEqual(machine.cached(), [CACHED, "engine-" + os.uname().machine])

    def test_second_run_is_silent_and_asks_no_package_source(self):
        machine = self.machine()
        machine.run("setup", "engine_arm64")
        os.unlink(machine.log)
        done = machine.run("setup", "engine_arm64", FAKE_NETWORK="down")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(machine.apt_calls("update"), 0)

    def test_engines_of_this_machine_do_not_count(self):
        machine = self.machine()
        machine.program("godot", "#!/bin/sh\necho 4.7.stable.official\n")
        machine.run("setup", "engine_arm64", GODOT=os.path.join(machine.bin, "godot"))
        self.assertEqual(machine.cached(), [CACHED])

    def test_emulator_that_is_missing_is_installed(self):
        machine = self.machine()
        os.unlink(os.path.join(machine.bin, "qemu-aarch64-static"))
        done = machine.run("setup", "engine_arm64")
        self.assertIn("installing qemu-user-static", done.stderr)

    def fails(self, machine, done, *words):
        """It ended with an error that its last line explains, and left nothing."""
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        for word in words:
            self.assertIn(word, done.stderr.splitlines()[-1])
        self.assertEqual(machine.cached(), [])

    def test_not_to_be_had(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine_arm64", FAKE_NETWORK="down"), "Godot 4.6 for arm64 is missing", "network")
        self.fails(machine, machine.run("setup", "engine_arm64", FAKE_VERSION="4.5.2"), "for arm64", "forky sid", "Debian machine")
        machine = self.machine(FEDORA)
        self.fails(machine, machine.run("setup", "engine_arm64"), "Godot 4.6 for arm64 is missing", "on Debian only")

    def test_engine_that_does_not_start(self):
        machine = self.machine()
        machine.program("qemu-aarch64-static", "#!/bin/sh\nexit 127\n")
        self.fails(machine, machine.run("setup", "engine_arm64"), "does not start")


if __name__ == "__main__":
    unittest.main()
