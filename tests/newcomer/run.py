#!/usr/bin/env python3
"""Does what a newcomer does, in an empty project with the files of the release archive: imports it, follows the guides as they are
written, opens the editor, exports a game and runs it.

    tests/newcomer/run.py [--case NAME] [--keep FOLDER]

The cases share one project, in this order. Ends with `[newcomer] N passed, N failed`. Pictures of the editor are saved in
build/newcomer.
"""

import argparse
import contextlib
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PLACES = (("tools", "lib"), ("site_scons",), ("tests", "screenshots"), ("tests", "export"))
sys.path[:0] = [os.path.join(ROOT, *place) for place in PLACES] + [HERE]

import display  # noqa: E402
import editor_case  # noqa: E402
import export_case  # noqa: E402
import faults  # noqa: E402
import first_import  # noqa: E402
import guides  # noqa: E402
import networking  # noqa: E402
from case_runner import run_cases  # noqa: E402
from newcomer import Newcomer  # noqa: E402

CASES = (*first_import.CASES, *guides.CASES, *networking.CASES, *faults.CASES, *editor_case.CASES,
         *export_case.CASES)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", metavar="NAME", help="of the cases after the import, run only those whose name contains NAME")
    parser.add_argument("--keep", metavar="FOLDER", help="make the project in this folder, which must be empty, and keep it")
    options = parser.parse_args()
    cases = [case for case in CASES if not options.case or options.case in case.__name__ or case in first_import.CASES]
    with contextlib.ExitStack() as stack:
        place = options.keep or stack.enter_context(tempfile.TemporaryDirectory(prefix="ga_godot_newcomer_"))
        environment = {} if os.environ.get("DISPLAY") else stack.enter_context(display.display())
        newcomer = Newcomer(os.path.abspath(place), environment)
        return run_cases("newcomer", cases, lambda case: case(newcomer))


if __name__ == "__main__":
    sys.exit(main())
