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
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
for folder in (os.path.join(ROOT, "tests", "network"), os.path.join(ROOT, "site_scons"), os.path.join(ROOT, "tools", "lib"), HERE):
    sys.path.insert(0, folder)

import checkout  # noqa: E402
import game_cases  # noqa: E402
from demo_run import RunFailed  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", metavar="NAME", default="", help="run only the cases whose name contains NAME")
    options = parser.parse_args()
    templates = checkout.setup_path("templates")
    passed = failed = 0
    with tempfile.TemporaryDirectory(prefix="ga_godot_export_") as place:
        games = game_cases.Games(place, templates)
        for case in game_cases.CASES:
            if options.case not in case.__name__:
                continue
            start = time.monotonic()
            try:
                case(games)
                passed += 1
                print(f"ok {case.__name__} ({time.monotonic() - start:.1f} s)", flush=True)
            except (AssertionError, RunFailed) as problem:
                failed += 1
                print(f"FAILED {case.__name__} ({time.monotonic() - start:.1f} s): {problem}", flush=True)
    print(f"[export] {passed} passed, {failed} failed", flush=True)
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
