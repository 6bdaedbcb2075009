#!/usr/bin/env python3
"""Runs the engine's tests with the library for arm64, in Debian's engine for arm64 under QEMU.

Usage: engine_arm64.py [FILTER]     FILTER as of godot_project/main.gd's --test=

The library has to be built: scons platform=linux arch=arm64. Ends with `[engine-arm64] N passed, N failed`.
"""

import concurrent.futures
import configparser
import glob
import os
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

import checkout  # noqa: E402
import project  # noqa: E402
import suite_process  # noqa: E402

ADDON = os.path.join(checkout.PROJECT, "addons", "ga_godot")
# How much longer than in the engine of this machine a test may take.
SLOWNESS = 20
SECONDS = 3600
AARCH64 = 183  # e_machine of an ELF file


def listed_library(feature):
    """The path of the library that ga_godot.gdextension names for this system and processor."""
    extension = configparser.ConfigParser()
    extension.read(os.path.join(ADDON, "ga_godot.gdextension"), encoding="utf-8")
    return os.path.join(ADDON, extension["libraries"][feature].strip('"'))


def is_for_arm64(path):
    """Whether the file is an ELF library for arm64."""
    try:
        with open(path, "rb") as file:
            head = file.read(20)
    except OSError:
        return False
    return head[:4] == b"\x7fELF" and int.from_bytes(head[18:20], "little") == AARCH64


def split(items, count):
    """The items in `count` lists of about equal length, the empty ones left out."""
    return [part for part in (items[start::count] for start in range(count)) if part]


def program(engine, wanted, folder):
    """One engine that runs the wanted tests, with its user data in the folder."""
    places = {f"XDG_{name}_HOME": os.path.join(folder, name.lower()) for name in ("DATA", "CONFIG", "CACHE")}
    return suite_process.Program(
        [engine, "--headless", "--path", checkout.PROJECT, "--", f"--test={','.join(wanted)}"], seconds=SECONDS,
        env={"GA_GODOT_SLOWNESS": str(SLOWNESS), "GA_GODOT_ENGINE_STARTER": engine, **places})


def run(wanted="", processes=os.cpu_count() or 1):
    """Runs the tests of the filter, or all of them in several processes; returns the numbers of those that passed and failed."""
    library = listed_library("linux.debug.arm64")
    if not is_for_arm64(library):
        print(f"engine-arm64: {os.path.relpath(library, ROOT)} is missing: build it with scons platform=linux arch=arm64")
        return 0, 1
    engine = checkout.setup_path("engine_arm64")
    project.prepare(checkout.PROJECT)  # with this machine's engine, which imports the same
    files = sorted(os.path.basename(path) for path in glob.glob(os.path.join(checkout.PROJECT, "tests", "test_*.gd")))
    parts = [[wanted]] if wanted else split(files, processes)
    with tempfile.TemporaryDirectory(prefix="ga_godot_arm64.") as folder, concurrent.futures.ThreadPoolExecutor(len(parts)) as pool:
        programs = [program(engine, part, os.path.join(folder, str(number))) for number, part in enumerate(parts)]
        outcomes = list(pool.map(suite_process.run, programs))
    problems = [problem for outcome in outcomes for problem in outcome.problems]
    for problem in problems:
        print(f"engine-arm64: {problem}")
    return sum(outcome.passed for outcome in outcomes), sum(outcome.failed for outcome in outcomes) + len(problems)


def main():
    """Runs the tests and sums up."""
    passed, failed = run(*sys.argv[1:2])
    print(f"[engine-arm64] {passed} passed, {failed} failed", flush=True)
    sys.exit(1 if failed or not passed else 0)


if __name__ == "__main__":
    main()
