#!/usr/bin/env python3
"""Loads the library of each system that this machine can run or emulate, without an engine: library_host plays its part.

Prints "[load] N passed, N failed" as the last line.
"""

import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

import checkout  # noqa: E402
import emulators  # noqa: E402

SECONDS = 120
SYSTEMS = (("linux", "x86_64", ".so", ""), ("linux", "arm64", ".so", ""), ("windows", "x86_64", ".dll", ".exe"))
CLASSES = 9


def load(platform, arch, library_suffix, program_suffix):
    """Runs library_host with the library; returns what is wrong, or None."""
    folder = checkout.zig_variant(platform, arch)
    host = os.path.join(folder, "tests", "library_host" + program_suffix)
    library = os.path.join(folder, f"libga_godot.{platform}.{arch}{library_suffix}")
    emulator, env = ([], {}) if (platform, arch) == checkout.host() else emulators.command(platform, arch)
    try:
        done = subprocess.run([*emulator, host, library], env={**os.environ, **env}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
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
