#!/usr/bin/env python3
"""Runs the engine tests with the library for arm64, in Debian's engine for arm64 under QEMU.

Usage: engine_arm64.py [FILTER]     FILTER as of --test in godot_project/main.gd

`scons platform=linux arch=arm64` must have built the library. Prints "[engine-arm64] N passed, N failed" as the last line.
"""

import concurrent.futures
import glob
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

import checkout  # noqa: E402
import project  # noqa: E402
from engine_log import EngineLog  # noqa: E402
from suite_process import read_counts  # noqa: E402

# How many times longer than in an engine of this machine a test may take, beside another emulated engine on each core.
SLOWNESS = 15


def split(items, count):
    """The items, in turn, in up to `count` lists; none is empty."""
    return [part for part in (items[first::count] for first in range(count)) if part]


def run_engine(engine, folder, wanted, place):
    """Runs the wanted tests of the project in `folder`, with the user's data below `place`; returns how many passed and failed."""
    env = {f"XDG_{name}_HOME": os.path.join(place, name.lower()) for name in ("DATA", "CONFIG", "CACHE")}
    env.update(GA_GODOT_SLOWNESS=str(SLOWNESS), GA_GODOT_ENGINE_STARTER=engine)
    command = [engine, "--headless", "--path", folder, "--", f"--test={','.join(wanted)}"]
    log = EngineLog()
    counts = None
    # In this process group, so that whoever ends the group ends the engines.
    with subprocess.Popen(command, env={**os.environ, **env}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace") as process:
        for line in process.stdout:
            if log.feed(line):
                print(line, end="", flush=True)
            counts = read_counts(line) or counts
    problems = log.problems()
    passed, failed = counts or (0, 0)
    if process.returncode != 0 and failed == 0 or counts is None:
        problems.append(f"exit code {process.returncode}")
    for problem in problems:
        print(f"engine-arm64: {problem}", flush=True)
    return passed, failed + len(problems)


def run(wanted=""):
    """Runs the tests of a filter, or all of them, in one process for each core; returns how many passed and failed."""
    build = checkout.zig_variant("linux", "arm64")
    library = os.path.join(build, "libga_godot.linux.arm64.so")
    if not os.path.isfile(library):
        print(f"engine-arm64: {os.path.relpath(library, ROOT)} is missing: run scons platform=linux arch=arm64")
        return 0, 1
    engine = checkout.setup_path("engine_arm64")
    project.prepare(checkout.PROJECT)  # by the engine of this machine: an imported project fits both
    place = os.path.join(build, "engine")
    folder = project.copy_with_library(library, place)
    tests = sorted(os.path.basename(path) for path in glob.glob(os.path.join(folder, "tests", "test_*.gd")))
    parts = [[wanted]] if wanted else split(tests, os.cpu_count() or 1)
    places = [os.path.join(place, f"user{number}") for number in range(len(parts))]
    with concurrent.futures.ThreadPoolExecutor(len(parts)) as pool:
        counts = list(pool.map(lambda part, user: run_engine(engine, folder, part, user), parts, places))
    return tuple(map(sum, zip(*counts)))


def main():
    """Runs the tests and sums up."""
    passed, failed = run(*sys.argv[1:2])
    print(f"[engine-arm64] {passed} passed, {failed} failed", flush=True)
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
