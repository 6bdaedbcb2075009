"""Which godot-cpp a build uses, and what it says about it."""

import os
import sys
import tempfile
import unittest
from contextlib import redirect_stderr
from io import StringIO

import checkout

sys.path.insert(0, os.path.join(checkout.ROOT, "site_scons"))

import engine_bindings  # noqa: E402


class GodotCppTest(unittest.TestCase):
    def setUp(self):
        # Resolved, as the choice returns absolute paths.
        self.place = os.path.realpath(self.enterContext(tempfile.TemporaryDirectory()))
        self.checkout = self.make("checkout")

    def make(self, *names, header=False):
        """A folder; with `header`, one that looks like godot-cpp."""
        folder = os.path.join(self.place, *names)
        os.makedirs(os.path.join(folder, "include", "godot_cpp") if header else folder)
        if header:
            open(os.path.join(folder, engine_bindings.HEADER), "w", encoding="utf-8").close()
        return folder

    def find(self, option="", environment=None):
        return engine_bindings.find_godot_cpp(option, environment or {}, self.checkout)

    def refusal(self, *arguments):
        with redirect_stderr(StringIO()) as error, self.assertRaises(SystemExit):
            self.find(*arguments)
        return error.getvalue()

    def test_without_one_the_stand_in_is_used(self):
        root, source = self.find()
        self.assertIsNone(root)
        line = engine_bindings.describe(root, source)
        self.assertRegex(line, r"^Bindings: bindings/ \(.*CONTRIBUTING\.md")

    def test_a_folder_inside_the_checkout(self):
        beside = self.make("godot-cpp", header=True)
        inside = self.make("checkout", "godot-cpp", header=True)
        root, source = self.find()
        self.assertEqual((root, source), (inside, "the folder godot-cpp"))
        self.assertEqual(engine_bindings.describe(root, source), f"Bindings: godot-cpp in {inside} (the folder godot-cpp)")
        self.assertNotEqual(root, beside)

    def test_a_folder_beside_the_checkout(self):
        beside = self.make("godot-cpp", header=True)
        self.assertEqual(self.find(), (beside, "the folder ../godot-cpp"))

    def test_another_folder_of_that_name_is_not_taken(self):
        self.make("checkout", "godot-cpp", "src")
        self.assertIsNone(self.find()[0])
        beside = self.make("godot-cpp", header=True)
        self.assertEqual(self.find()[0], beside)

    def test_a_submodule_that_is_not_checked_out(self):
        self.make("checkout", "godot-cpp")
        root, source = self.find()
        self.assertIsNone(root)
        self.assertIn("git submodule update --init", source)

    def test_the_variable_precedes_folders(self):
        self.make("checkout", "godot-cpp", header=True)
        other = self.make("other", header=True)
        self.assertEqual(self.find("", {"GODOT_CPP": other}), (other, "GODOT_CPP=" + other))

    def test_the_option_precedes_the_variable(self):
        variable, option = self.make("variable", header=True), self.make("option", header=True)
        self.assertEqual(self.find(option, {"GODOT_CPP": variable}), (option, "godot_cpp=" + option))

    def test_the_stand_in_by_choice(self):
        inside = self.make("checkout", "godot-cpp", header=True)
        self.assertIsNone(self.find("no", {"GODOT_CPP": inside})[0])

    def test_a_named_folder_that_is_none(self):
        self.make("checkout", "godot-cpp", header=True)
        missing = os.path.join(self.place, "missing")
        for arguments, source in (((missing, {}), "godot_cpp=" + missing), (("", {"GODOT_CPP": missing}), "GODOT_CPP=" + missing)):
            error = self.refusal(*arguments)
            self.assertEqual(error, f"scons: error: {source} is not a godot-cpp folder: it contains no {engine_bindings.HEADER}\n")

    def test_one_that_can_not_be_built(self):
        root = self.make("installed", header=True)
        environment = {"platform": "linux", "target": "template_debug", "arch": "x86_64", "toolchain": "native"}
        with redirect_stderr(StringIO()) as error, self.assertRaises(SystemExit):
            engine_bindings.use_godot_cpp(environment, root, builds=True)
        self.assertIn("libgodot-cpp.linux.template_debug.x86_64.a and no SConstruct", error.getvalue())


if __name__ == "__main__":
    unittest.main()
