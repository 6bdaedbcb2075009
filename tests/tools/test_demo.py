"""Options of tools/demo."""

import contextlib
import io
import unittest

import demo


class OptionsTest(unittest.TestCase):
    def refused(self, *arguments):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors), self.assertRaises(SystemExit) as stop:
            demo.parse_arguments(arguments)
        self.assertEqual(stop.exception.code, 2)
        return errors.getvalue()

    def test_defaults_by_scene(self):
        cubes, push, avatars = (demo.parse_arguments(["--scene", scene]) for scene in ("cubes", "push", "avatars"))
        self.assertEqual((cubes.cubes, cubes.clients, cubes.seconds), (250, 2, 8))
        self.assertEqual((push.cubes, push.clients), (901, 2))
        self.assertEqual((avatars.cubes, avatars.clients, avatars.relay), (None, 8, None))
        self.assertEqual(demo.parse_arguments([]), cubes)

    def test_options_of_another_scene(self):
        self.assertIn("has no cubes", self.refused("--scene", "avatars", "--cubes", "5"))
        self.assertIn("at least 2 clients", self.refused("--scene", "avatars", "--clients", "1"))
        self.assertIn("the scene cubes has at most 6 clients", self.refused("--clients", "7"))
        self.assertIn("no relay", self.refused("--scene", "push", "--relay", "on"))
        self.assertIn("17 is not in the range from 1 to 16", self.refused("--scene", "avatars", "--clients", "17"))
