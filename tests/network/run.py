#!/usr/bin/env python3
"""Multi-process tests: the multiplayer demo and situations of games (situations/*.gd), over ENet on this machine.

Usage: tests/network/run.py [--engine COMMAND] [--case NAME] [--long]

Each case starts servers and clients and compares the poses that the clients showed with those that their owners
simulated. Ends with `[network] N passed, N failed`.
"""

import argparse
import os
import shlex
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import avatar_cases  # noqa: E402
import bad_network_cases  # noqa: E402
import cases  # noqa: E402
import fault_cases  # noqa: E402
import hostile_case  # noqa: E402
import situation_cases  # noqa: E402
import checkout  # noqa: E402
import project  # noqa: E402
from case_runner import run_cases  # noqa: E402
from demo_run import DemoRun  # noqa: E402


CASES = (*cases.CASES, *bad_network_cases.CASES, *avatar_cases.CASES, *hostile_case.CASES, *situation_cases.CASES,
         *fault_cases.CASES)
LONG_SECONDS = "60"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--engine", metavar="COMMAND", help="command that starts Godot (the one that tools/setup provides)")
    parser.add_argument("--case", metavar="NAME", help="run only the cases whose name, or whose file's, contains NAME")
    parser.add_argument("--long", action="store_true", help=f"sessions in which players join and leave last {LONG_SECONDS} s")
    options = parser.parse_args()
    if options.long:
        os.environ["GA_GODOT_SESSION_SECONDS"] = LONG_SECONDS
    if options.engine:
        engine = shlex.split(options.engine)
        os.makedirs(os.path.join(checkout.PROJECT, ".godot"), exist_ok=True)
        project.list_extensions(checkout.PROJECT)
    else:
        engine = [checkout.ENGINE]
        project.prepare(checkout.PROJECT)
    chosen = [case for case in CASES if not options.case or options.case in f"{case.__module__}.{case.__name__}"]
    return run_cases("network", chosen, lambda case: run_case(case, engine))


def run_case(case, engine):
    """Runs a case in a temporary folder."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_network_") as folder, DemoRun(engine, folder) as run:
        case(run)


if __name__ == "__main__":
    sys.exit(main())
