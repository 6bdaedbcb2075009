"""Which engine setup takes, how it fetches one, and what it says and leaves when it cannot."""

import os
import signal
import time
import unittest

from machine import DEBIAN, FEDORA, UBUNTU, Machine, engine_script

CACHED = "engine-" + os.uname().machine


class SetupEngineTest(unittest.TestCase):
    def machine(self, system=DEBIAN):
        machine = Machine(system)
        self.addCleanup(machine.close)
        return machine

    def fetched(self, machine, done):
        """It ended well and the cache holds the engine and nothing else."""
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(machine.cached(), [CACHED])

    def fails(self, machine, done, *words):
        """It ended with an error that its last line explains, and left nothing."""
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stdout, "")
        last = done.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("setup: "), done.stderr)
        for word in words:
            self.assertIn(word, last)
        self.assertEqual(machine.cached(), [])

    def test_fetches(self):
        machine = self.machine()
        done = machine.run("setup", "--print", "engine")
        self.fetched(machine, done)
        self.assertEqual(done.stdout, os.path.join(machine.cache, CACHED, "usr/bin/godot") + "\n")
        with open(os.path.join(machine.cache, CACHED, "usr/share/vulkan/icd.d/soft.json"), encoding="utf-8") as file:
            self.assertIn(f'"{machine.cache}/{CACHED}/usr/lib/some-linux-gnu/libsoft.so"', file.read())

    def test_second_run_is_silent_and_asks_no_package_source(self):
        machine = self.machine()
        machine.run("setup", "engine")
        os.unlink(machine.log)
        done = machine.run("setup", "engine", FAKE_NETWORK="down")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(machine.apt_calls("update"), 0)

    def test_certificates_come_with_the_fetched_engine(self):
        machine = self.machine()
        for _ in range(2):
            os.unlink(machine.environment["GA_GODOT_CERTIFICATES"])
            done = machine.run("setup", "engine")
            self.fetched(machine, done)
            self.assertIn("installing ca-certificates", done.stderr)

    def test_given_engine_comes_first(self):
        machine = self.machine(FEDORA)
        path = machine.write("mine/godot", engine_script("4.7.stable.official"), executable=True)
        self.assertEqual(machine.run("setup", "--print", "engine", GODOT=path).stdout, path + "\n")

    def test_given_engine_that_does_not_fit(self):
        machine = self.machine()
        for version in ("4.5.1.stable.official", "3.6.stable", "5.0.stable", "Written by somebody"):
            path = machine.write("mine/godot", engine_script(version), executable=True)
            self.fails(machine, machine.run("setup", "engine", GODOT=path), f"GODOT={path}", version, "4.6 or newer")
        self.fails(machine, machine.run("setup", "engine", GODOT="/nowhere/godot"), "/nowhere/godot is not an executable")
        wrapper = os.path.join(machine.tools, "godot")
        self.fails(machine, machine.run("setup", "engine", GODOT=wrapper), "wrapper")

    def test_engine_on_path(self):
        for name in ("godot", "godot4"):
            machine = self.machine(FEDORA)
            path = machine.program(name, engine_script("4.10.stable"))
            self.assertEqual(machine.run("setup", "--print", "engine").stdout, path + "\n")

    def test_old_engine_on_path_is_passed_over(self):
        machine = self.machine()
        machine.program("godot", engine_script("4.5.stable"))
        self.fetched(machine, machine.run("setup", "engine"))

    def test_another_system(self):
        machine = self.machine(FEDORA)
        done = machine.run("setup", "engine")
        self.fails(machine, done, "Godot 4.6", "Fedora Linux 43", "GODOT=")
        self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_no_network(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine", FAKE_NETWORK="down"), "does not respond", "network", "GODOT=")

    def test_bad_signature(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine", FAKE_SIGNATURE="bad"), "signatures", "keyring", "GODOT=")

    def test_clock_that_is_ahead(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine", FAKE_SIGNATURE="expired"), "set the clock", "GODOT=")

    def test_suites_that_carry_only_an_old_engine(self):
        for system, suites in ((DEBIAN, "forky sid"), (UBUNTU, "devel")):
            machine = self.machine(system)
            self.fails(machine, machine.run("setup", "engine", FAKE_VERSION="4.5.2"), suites, "GODOT=")

    def test_disk_too_small(self):
        machine = self.machine()
        machine.program("df", "#!/bin/sh\necho header\necho /dev/x 100000 90000 9000 90% /\n")
        self.fails(machine, machine.run("setup", "engine"), "needs 25 MB", "has 8 MB free", "GA_GODOT_CACHE")
        self.assertEqual(machine.apt_calls("--download-only"), 0)

    def test_disk_that_fills_up(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine", FAKE_DISK="full"), "the disk is full", "run the same command again")
        self.fetched(machine, machine.run("setup", "engine"))

    def test_cache_that_cannot_be_written(self):
        machine = self.machine()
        place = machine.write("a-file", "")
        done = machine.run("setup", "engine", GA_GODOT_CACHE=place + "/cache")
        self.fails(machine, done, "cannot write to the cache folder", "GA_GODOT_CACHE")

    def test_no_home(self):
        machine = self.machine()
        self.fails(machine, machine.run("setup", "engine", HOME="", GA_GODOT_CACHE=""), "HOME is not set", "GA_GODOT_CACHE")

    def test_fetched_engine_that_does_not_start(self):
        machine = self.machine()
        machine.write("package/usr/bin/godot", "#!/bin/sh\nexit 127\n", executable=True)
        package = machine.make_package()
        self.assertEqual(package, machine.environment["FAKE_DEB"])
        machine.program("dpkg", "#!/bin/sh\n[ $1 = -x ] || { echo amd64; exit; }\n"
                        'mkdir -p "$3" && tar -xf "$2" -C "$3" && printf "#!/bin/sh\\nexit 127\\n" >"$3/usr/bin/godot"\n')
        self.fails(machine, machine.run("setup", "engine"), "does not start", "GODOT=")

    def test_broken_cached_engine_is_replaced(self):
        machine = self.machine()
        machine.write(f"cache/{CACHED}/usr/bin/godot", "#!/bin/sh\nexit 127\n", executable=True)
        self.fetched(machine, machine.run("setup", "engine"))
        self.assertEqual(machine.run("godot", "--version").stdout, "4.6.3.stable.debian\n")

    def test_interrupted_run_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            machine = self.machine()
            # A test run by nohup ignores SIGHUP, which its programs would inherit.
            previous = signal.signal(number, signal.default_int_handler)
            process = self.start_slow_download(machine)
            signal.signal(number, previous)
            process.send_signal(number)
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, 128 + number)
            self.assertEqual(machine.cached(), [])

    def test_killed_run_is_repaired_by_the_next(self):
        machine = self.machine()
        process = self.start_slow_download(machine, seconds=2)
        process.kill()
        process.communicate(timeout=60)
        self.assertEqual(len(machine.cached()), 1)
        self.assertTrue(machine.cached()[0].startswith("partial."))
        self.fetched(machine, machine.run("setup", "engine"))

    def test_two_at_once_fetch_once(self):
        machine = self.machine()
        first = self.start_slow_download(machine, seconds=2)
        second = machine.run("setup", "--print", "engine")
        first.communicate(timeout=60)
        self.fetched(machine, second)
        self.assertIn("waiting", second.stderr)
        self.assertEqual((first.returncode, machine.apt_calls("--download-only")), (0, 1))

    def test_wrapper_passes_arguments_and_exit_code(self):
        machine = self.machine()
        machine.run("setup", "engine")
        done = machine.run("godot", "--headless", "a b")
        drivers = os.path.join(machine.cache, CACHED, "usr/lib/some-linux-gnu/dri")
        self.assertEqual((done.returncode, done.stdout), (7, f"--headless a b drivers={drivers}\n"))

    def test_wrapper_leaves_the_users_own_engine_alone(self):
        machine = self.machine()
        machine.program("godot", engine_script("4.6.stable"))
        self.assertEqual(machine.run("godot", "-e").stdout, "-e drivers=none\n")

    def test_wrapper_on_path_does_not_find_itself(self):
        machine = self.machine()
        path = machine.tools + os.pathsep + machine.environment["PATH"]
        done = machine.run("godot", "--version", PATH=path)
        self.assertEqual((done.returncode, done.stdout), (0, "4.6.3.stable.debian\n"))

    def start_slow_download(self, machine, seconds=30):
        """A setup that has begun its download."""
        process = machine.start("setup", "engine", FAKE_SLOW=str(seconds))
        until = time.monotonic() + 20
        while machine.apt_calls("--download-only") == 0 and time.monotonic() < until:
            time.sleep(0.05)
        return process
