#!/usr/bin/env python3
"""Loads the library of each system that this machine can run or emulate, without an engine: library_host plays its part.

Prints "[load] N passed, N failed" as the last line.
"""

import glob
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "tools", "lib"), os.path.join(ROOT, "site_scons")]

import addon_files  # noqa: E402
import checkout  # noqa: E402
import emulators  # noqa: E402

SECONDS = 120
SYSTEMS = (("linux", "x86_64"), ("linux", "arm64"), ("windows", "x86_64"))
# Each class of the library has a page.
CLASSES = len(glob.glob(os.path.join(ROOT, "src", "godot", "doc_classes", "*.xml")))


def load(platform, arch):
    """Runs library_host with the library; returns what is wrong, or None."""
    name = os.path.basename(addon_files.library_for(addon_files.read(addon_files.EXTENSION), [platform, arch, "debug"]))
    command, env = emulators.test_program(platform, arch, "library_host", os.path.join(checkout.zig_variant(platform, arch), name))
    try:
        done = subprocess.run(command, env={**os.environ, **env}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace", timeout=SECONDS, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    lines = done.stdout.splitlines()
    if done.returncode != 0:
        return f"exit code {done.returncode}: {done.stdout.strip()}"
    if "newer version of Godot" not in done.stdout:
        return f"the library does not say that an engine without functions is too old: {done.stdout.strip()}"
    classes = [line for line in lines if line.startswith("class ")]
    if len(classes) != CLASSES:
        return f"{len(classes)} classes instead of {CLASSES}: {done.stdout.strip()}"
    print(f"{platform} {arch}: " + ", ".join(line for line in lines if line.startswith(("minimum", "functions", "help"))) +
          f", {len(classes)} classes", flush=True)
    return None


def main():
    """Loads all libraries."""
    failures = 0
    for system in SYSTEMS:
        problem = load(*system)
        if problem:
            print(f"load: {system[0]} {system[1]}: {problem}", flush=True)
            failures += 1
    print(f"[load] {len(SYSTEMS) - failures} passed, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
