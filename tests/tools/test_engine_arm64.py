"""How tests/platforms/engine_arm64.py divides the engine tests and reads what emulated engines print."""

import contextlib
import io
import os
import sys
import tempfile
import unittest

import checkout

sys.path.insert(0, os.path.join(checkout.ROOT, "tests", "platforms"))

import engine_arm64  # noqa: E402


class EngineArm64Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="ga_godot_tools.")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_engine(self, *lines):
        """The counts of an engine that is this shell script, and the output of the run."""
        engine = os.path.join(self.folder, "engine")
        with open(engine, "w", encoding="utf-8") as file:
            file.write("\n".join(["#!/bin/sh", *lines, ""]))
        os.chmod(engine, 0o755)
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            counts = engine_arm64.run_engine(engine, "project", ["test_a.gd", "test_b.gd"], os.path.join(self.folder, "user"))
        return counts, output.getvalue()

    def test_each_test_is_in_one_part(self):
        self.assertEqual(engine_arm64.split(["a", "b", "c"], 2), [["a", "c"], ["b"]])
        self.assertEqual(engine_arm64.split(["a", "b"], 8), [["a"], ["b"]])

    def test_command_and_environment(self):
        counts, output = self.run_engine('echo "$*"', 'echo "$XDG_DATA_HOME $GA_GODOT_SLOWNESS $GA_GODOT_ENGINE_STARTER"',
                                         'echo "[engine] 2 passed, 0 failed"')
        self.assertEqual(counts, (2, 0))
        self.assertEqual(output.splitlines()[:2], [
            "--headless --path project -- --test=test_a.gd,test_b.gd",
            f"{self.folder}/user/data {engine_arm64.SLOWNESS} {self.folder}/engine"])

    def test_failed_tests(self):
        counts, _ = self.run_engine('echo "[engine] 2 passed, 3 failed"', "exit 1")
        self.assertEqual(counts, (2, 3))

    def test_problems_count_as_failed(self):
        counts, output = self.run_engine('echo "ERROR: surprise"', 'echo "[engine] 2 passed, 0 failed"')
        self.assertEqual(counts, (2, 1))
        self.assertIn("engine-arm64: error line: surprise", output)
        counts, output = self.run_engine('echo "[engine] 2 passed, 0 failed"', "exit 134")
        self.assertEqual(counts, (2, 1))
        self.assertIn("engine-arm64: exit code 134", output)
        self.assertEqual(self.run_engine("exit 0")[0], (0, 1))


if __name__ == "__main__":
    unittest.main()
