"""The first headless import of a new project with the addon, by the lines of the addon's README and of the troubleshooting page."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

import checkout
import engine_log

PAGES = (os.path.join(checkout.ROOT, "docs", "troubleshooting.md"),
         os.path.join(checkout.PROJECT, "addons", "ga_godot", "README.md"))
LINES = re.compile(r"^```sh\n(mkdir -p \.godot .*?)^```$", re.M | re.S)
IMPORT_SECONDS = 120
SCRIPT = "extends Node\n\n\nfunc value() -> Multivector:\n\treturn Multivector.point(Vector3.ONE)\n"


class FirstImportTest(unittest.TestCase):
    def test_the_documented_lines_end_without_an_error(self):
        for page in PAGES:
            with self.subTest(page=os.path.relpath(page, checkout.ROOT)), tempfile.TemporaryDirectory() as place:
                with open(page, encoding="utf-8") as file:
                    found = LINES.findall(file.read())
                self.assertEqual(len(found), 1)
                self.assertEqual(len(found[0].splitlines()), 2)
                done = self.run_lines(found[0], place)
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertEqual(engine_log.problems_of(done.stdout), [])
                imported = os.listdir(os.path.join(place, "project", ".godot", "imported"))
                self.assertTrue(any(name.startswith("multivector.svg") for name in imported), imported)

    @staticmethod
    def run_lines(lines, place):
        """Runs the lines in a new project with the addon, where `godot` is the engine of the tests."""
        folder = os.path.join(place, "project")
        shutil.copytree(os.path.join(checkout.PROJECT, "addons", "ga_godot"), os.path.join(folder, "addons", "ga_godot"),
                        ignore=shutil.ignore_patterns("*.import"))
        for name, text in (("project.godot", "config_version=5\n"), ("main.gd", SCRIPT)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        programs = os.path.join(place, "bin")
        os.mkdir(programs)
        with open(os.path.join(programs, "godot"), "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\nexec "{checkout.ENGINE}" "$@"\n')
        os.chmod(os.path.join(programs, "godot"), 0o755)
        environment = {**os.environ, "PATH": programs + os.pathsep + os.environ["PATH"],
                       "XDG_DATA_HOME": os.path.join(place, "data"), "XDG_CONFIG_HOME": os.path.join(place, "config")}
        return subprocess.run(["sh", "-e", "-c", lines], cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=IMPORT_SECONDS, check=False)


if __name__ == "__main__":
    unittest.main()
