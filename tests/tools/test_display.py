"""Displays of their own: two at once, both gone afterwards."""

import os
import unittest

from display import display


class DisplayTest(unittest.TestCase):
    def test_two_at_once(self):
        with display() as first, display() as second:
            self.assertNotEqual(first["DISPLAY"], second["DISPLAY"])
            sockets = [f"/tmp/.X11-unix/X{env['DISPLAY'][1:]}" for env in (first, second)]
            self.assertTrue(all(os.path.exists(path) for path in sockets))
        self.assertFalse(any(os.path.exists(path) for path in sockets))
