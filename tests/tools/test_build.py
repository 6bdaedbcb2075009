"""The build: one line for what cannot be built, nothing done twice, and the addon as users get it."""

import os
import subprocess
import tempfile
import unittest

import checkout

LIBRARY = "addons/ga_godot/bin/libga_godot.{}.{}.so".format(*checkout.host())


def scons(*arguments, **env):
    """Runs SCons in the checkout; returns exit code, output and error output."""
    done = subprocess.run(["scons", "-Q", *arguments], cwd=checkout.ROOT, env={**os.environ, **env}, text=True,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    lines = [line for line in done.stdout.splitlines() if "another build runs" not in line]
    return done.returncode, "\n".join(lines), done.stderr


class RefusalTest(unittest.TestCase):
    def refuses(self, *arguments, naming, **env):
        code, output, error = scons(*arguments, **env)
        self.assertEqual(code, 2, output + error)
        self.assertEqual(output, "")
        self.assertRegex(error, r"^scons: error: [^\n]+\n$")
        for word in naming:
            self.assertIn(word, error)

    def test_unknown_platforms(self):
        self.refuses("platform=ios", naming=["ios", "linux", "windows", "macos", "android", "web"])

    def test_unknown_processors(self):
        self.refuses("arch=riscv64", naming=["riscv64", "x86_64", "arm64"])
        self.refuses("platform=windows", "arch=universal", naming=["universal", "windows", "x86_64", "arm64"])

    def test_platforms_without_godot_cpp(self):
        for arguments, env in ((["arch=arm64"], {}), (["arch=arm64", "godot_cpp=x"], {}), (["godot_cpp=x"], {"CXX": "clang++"})):
            self.refuses("platform=android", *arguments, naming=["android", "CXX=", "arch=", "godot_cpp=", "docs/building.md"],
                         **{"CXX": "", "GODOT_CPP": "", **env})

    def test_tests_for_two_processors(self):
        self.refuses("platform=macos", "tests", naming=["universal", "arm64", "x86_64"])

    def test_unknown_options(self):
        self.refuses("tarket=template_debug", naming=["tarket", "scons -h"])

    def test_unknown_sanitizers(self):
        self.refuses("sanitize=address,memory", naming=["memory", "address", "thread"])

    def test_a_fuzzer_without_clang(self):
        self.refuses("sanitize=fuzzer,address", naming=["fuzzer", "clang"], CXX="g++")

    def test_no_compiler(self):
        self.refuses(naming=["no-such-compiler", "g++"], CXX="no-such-compiler")

    def test_an_engine_that_is_none(self):
        self.refuses("godot=/no/such/engine", naming=["godot=/no/such/engine"])

    def test_an_engine_that_is_too_old(self):
        with tempfile.TemporaryDirectory() as folder:
            engine = os.path.join(folder, "godot")
            with open(engine, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\necho 4.3.stable.official\n")
            os.chmod(engine, 0o755)
            self.refuses(f"godot={engine}", naming=["4.3.stable.official", "4.6"])

    def test_a_godot_cpp_that_is_none(self):
        self.refuses("godot_cpp=/no/such/folder", naming=["/no/such/folder", "include/godot_cpp/godot.hpp"])

    def test_install_without_a_project(self):
        self.refuses("install", naming=["project=DIR"])

    def test_install_into_what_is_no_project(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refuses("install", f"project={folder}", naming=[folder, "project.godot"])

    def test_install_into_the_own_project(self):
        self.refuses("install", "project=godot_project", naming=["contains the addon already"])


class BuildTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        code, output, error = scons()
        assert code == 0, output + error

    def test_unchanged_inputs_build_nothing(self):
        code, output, error = scons()
        self.assertEqual((code, error), (0, ""))
        printed = [line for line in output.splitlines() if not line.endswith("is up to date.")]
        self.assertEqual(len(printed), 1, printed)
        self.assertRegex(printed[0], r"^Bindings: (bindings/|godot-cpp in \S+) \([^()]+\)$")

    def test_the_library_exports_the_entry_point_alone(self):
        path = os.path.join(checkout.PROJECT, LIBRARY)
        names = subprocess.run(["nm", "-D", "--defined-only", path], stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual([line.split()[-1] for line in names.stdout.splitlines()], ["ga_godot_init"])


if __name__ == "__main__":
    unittest.main()
