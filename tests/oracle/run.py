"""Compares the algebra with independent implementations; see README.md in this folder."""

import argparse
import concurrent.futures
import importlib
import os
import subprocess
import sys
import tempfile
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, HERE)
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

# Longest first: they run in parallel.
LIBRARY_CHECKS = ("versors", "incidence", "exponentials", "texts", "scales", "products", "subspaces", "objects", "conformal", "screws",
                  "interpolation")
DEFAULT_SEED = 1
ENGINE = "engine"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--library", metavar="PATH", help="check only this libcga_oracle.so")
    parser.add_argument("--poses", metavar="FILE", help="check only this file of poses")
    parser.add_argument("--only", metavar="CHECK", action="append", choices=[*LIBRARY_CHECKS, ENGINE],
                        help="run only this check (repeatable): " + ", ".join([*LIBRARY_CHECKS, ENGINE]))
    parser.add_argument("--seed", metavar="N", type=int, default=DEFAULT_SEED,
                        help="seed of the random cases (default: %(default)s)")
    arguments = parser.parse_args()
    jobs = []
    with tempfile.TemporaryDirectory() as folder:
        if arguments.library or not arguments.poses:
            path = os.path.abspath(arguments.library or built_library())
            if not os.path.isfile(path):
                sys.exit(f"{path} does not exist; build it with `scons tests`")
            jobs = [(name, path, arguments.seed) for name in LIBRARY_CHECKS]
        if arguments.poses:
            jobs.append((ENGINE, arguments.poses, None))
        elif not arguments.library:
            jobs.insert(0, (ENGINE, os.path.join(folder, "poses.json"), "dump"))
        return run([job for job in jobs if not arguments.only or job[0] in arguments.only])


def run(jobs):
    """Runs the checks in one process per core; prints their lines in order, then the table."""
    import report

    lines = []
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
        for name, found in zip([job[0] for job in jobs], pool.map(run_job, jobs)):
            for line in found:
                print(line, flush=True)
            lines += found or [report.Line(name, "no checks ran", 0, float("nan"), 0.0)]
    print("\n" + report.table(lines) + "\n")
    text, code = report.summary(lines)
    print(text, flush=True)
    return code


def run_job(job):
    """Runs a job in its own process; returns its lines."""
    from report import Line, Report

    name, path, choice = job
    report = Report()
    try:
        if name == ENGINE:
            check_poses(path, choice, report)
        else:
            from library import Library

            importlib.import_module(name).check(Library(path), report, choice)
    except Exception:
        traceback.print_exc()
        report.lines.append(Line(name, "raised an exception", 0, float("nan"), 0.0))
    return report.lines


def check_poses(path, choice, report):
    """Checks interpolation in the engine."""
    import interpolation

    if choice == "dump":
        dump_poses(path)
    if os.path.isfile(path):
        interpolation.check_file(path, report)
    else:
        report.check(ENGINE, "poses", [], 0.0)


def built_library():
    import checkout

    return os.path.join(checkout.variant(), "tests", "libcga_oracle.so")


def dump_poses(path):
    """Lets the engine interpolate poses and write them to a file."""
    import checkout

    command = [checkout.ENGINE, "--headless", "--path", checkout.PROJECT, "--", f"--dump-poses={path}"]
    subprocess.run(command, check=False, timeout=200)


if __name__ == "__main__":
    sys.exit(main())
