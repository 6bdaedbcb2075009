"""Compares the algebra with independent programs; README.md of this folder says with which, and how to call it."""

import argparse
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--library", metavar="PATH", help="check this libcga_oracle.so only")
    parser.add_argument("--poses", metavar="FILE", help="check this file of poses only")
    arguments = parser.parse_args()
    everything = not arguments.library and not arguments.poses

    # After the arguments: these take seconds to load.
    from report import Report

    report = Report()
    if arguments.library or everything:
        check_library(arguments.library or built_library(), report)
    if arguments.poses:
        check_poses(arguments.poses, report)
    if everything:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "poses.json")
            dump_poses(path)
            check_poses(path, report)
    return report.end()


def check_library(path, report):
    if not os.path.isfile(path):
        sys.exit(f"{path} is missing: build it with `scons tests`")
    import exponentials
    import interpolation
    import products
    from library import Library

    library = Library(os.path.abspath(path))
    for oracle in (products, exponentials, interpolation):
        oracle.check(library, report)


def check_poses(path, report):
    import interpolation

    if os.path.isfile(path):
        interpolation.check_file(path, report)
    else:
        report.check("engine: poses", [], 0.0)


def built_library():
    import checkout

    return os.path.join(checkout.variant(), "tests", "libcga_oracle.so")


def dump_poses(path):
    """Lets the engine interpolate; what it prints is the suite's to judge."""
    import checkout

    command = [checkout.ENGINE, "--headless", "--path", checkout.PROJECT, "--", f"--dump-poses={path}"]
    subprocess.run(command, check=False, timeout=200)


if __name__ == "__main__":
    sys.exit(main())
