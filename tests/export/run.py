#!/usr/bin/env python3
"""Exports the demos and a small game for all systems and runs those for this machine.

Usage: tests/export/run.py [--case NAME]

On Linux it uses Godot's export templates; for other systems, stand-ins, so that the exports can be looked at but not run.
Ends with `[export] N passed, N failed`.
"""

import argparse
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
for folder in (os.path.join(ROOT, "tests", "network"), os.path.join(ROOT, "site_scons"), os.path.join(ROOT, "tools", "lib"), HERE):
    sys.path.insert(0, folder)

import checkout  # noqa: E402
import game_cases  # noqa: E402
from case_runner import run_cases  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", metavar="NAME", default="", help="run only the cases whose name contains NAME")
    options = parser.parse_args()
    templates = checkout.setup_path("templates")
    cases = [case for case in game_cases.CASES if options.case in case.__name__]
    with tempfile.TemporaryDirectory(prefix="ga_godot_export_") as place:
        games = game_cases.Games(place, templates)
        return run_cases("export", cases, lambda case: case(games))


if __name__ == "__main__":
    sys.exit(main())
