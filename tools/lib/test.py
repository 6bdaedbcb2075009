"""tools/test [--only SUITE]... [--fuzz [SECONDS]] [--sanitize] [--platforms]

Installs missing dependencies, builds what the suites need, runs them one after
another and ends with one line `N passed, N failed`. A failing suite does not
stop the next.
"""

import argparse
import os
import resource
import signal
import subprocess
import sys
import time
from contextlib import ExitStack

import checkout
import fuzzing
import platforms
import project
import sanitized
import suite_process
from build import LIBRARY, build
from display import display
from suites import SUITES, Suite


def parse_arguments(argv):
    """The options of tools/test."""
    names = [suite.name for suite in SUITES]
    parser = argparse.ArgumentParser(prog="tools/test", usage=argparse.SUPPRESS, description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=[*names, "all"], metavar="SUITE",
                        help="run only this suite (repeatable): " + ", ".join(names) + "; or all of them")
    parser.add_argument("--fuzz", type=positive, nargs="?", const=60, metavar="SECONDS",
                        help="run each fuzz target for SECONDS (60), after the suites of --only")
    parser.add_argument("--sanitize", action="store_true",
                        help="run only the C++ and engine suites, built with the address, undefined-behavior and thread sanitizers")
    parser.add_argument("--platforms", action="store_true",
                        help="build the archive with the libraries of all systems, inspect them, and run only the tests under emulators")
    arguments = parser.parse_args(argv)
    if sum(map(bool, (arguments.sanitize, arguments.platforms, arguments.only or arguments.fuzz))) > 1:
        parser.error("--sanitize and --platforms run suites of their own; remove the other options")
    return arguments


def positive(text):
    """A number of seconds above 0."""
    if int(text) <= 0:
        raise ValueError(text)
    return int(text)


def chosen_suites(arguments):
    """The suites of these options."""
    wanted = arguments.only or ([] if arguments.fuzz else ["all"])
    suites = [suite for suite in SUITES if "all" in wanted or suite.name in wanted]
    if arguments.fuzz:
        programs = fuzzing.programs(arguments.fuzz)
        suites.append(Suite("fuzz", (), (), lambda: programs))
    return suites


def make_ready(suites):
    """Installs, builds and prepares what the suites need."""
    parts = sorted({part for suite in suites for part in suite.parts})
    if parts:
        checkout.setup(*parts)
    if "engine" in parts:
        # All programs use the same engine, whatever their PATH.
        os.environ["GODOT"] = checkout.setup_path("engine")
    targets = sorted({target for suite in suites for target in suite.targets})
    if targets:
        build(*targets)
    if LIBRARY in targets:
        project.prepare(checkout.PROJECT)


def run_suite(suite):
    """Runs the programs of a suite; returns its (passed, failed, seconds, seconds of processor time)."""
    print(f"\n== {suite.name} ==", flush=True)
    started, worked = time.monotonic(), work_seconds()
    passed = failed = 0
    problems = []
    try:
        with ExitStack() as stack:
            env = stack.enter_context(display()) if suite.display else {}
            for program in suite.programs():
                program.env.update(env)
                outcome = suite_process.run(program)
                passed += outcome.passed
                failed += outcome.failed
                problems += [f"{os.path.basename(program.argv[0])}: {problem}" for problem in outcome.problems]
    except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
        problems.append(f"could not run: {error}")
    if passed + failed + len(problems) == 0:
        problems.append("the suite has no test")
    failed += len(problems)
    for problem in problems:
        print(f"{suite.name}: {problem}", flush=True)
    return passed, failed, time.monotonic() - started, work_seconds() - worked


def work_seconds():
    """Processor time of the programs that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    """Runs the chosen suites and sums up."""
    arguments = parse_arguments(sys.argv[1:])
    # An orderly exit also ends the suite's programs and displays.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))
    signal.signal(signal.SIGINT, lambda number, frame: sys.exit(128 + number))
    if arguments.sanitize:
        suites = sanitized.SUITES
        sanitized.make_ready()
    elif arguments.platforms:
        suites = platforms.SUITES
        platforms.make_ready()
    else:
        suites = chosen_suites(arguments)
        make_ready(suites)
    results = [(suite.name, *run_suite(suite)) for suite in suites]
    if arguments.fuzz:
        fuzzing.print_recorded()
    print()
    for name, passed, failed, seconds, work in results:
        print(f"{name:<17} {passed:>5} passed {failed:>4} failed {seconds:>7.1f} s, processor {work:>7.1f} s")
    all_passed = sum(result[1] for result in results)
    all_failed = sum(result[2] for result in results)
    print(f"{all_passed} passed, {all_failed} failed", flush=True)
    sys.exit(1 if all_failed or not all_passed else 0)


if __name__ == "__main__":
    main()
