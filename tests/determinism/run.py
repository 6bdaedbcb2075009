#!/usr/bin/env python3
"""Compares the packets that equal inputs lead to: on arm64 (emulated), without AVX2, with and without optimization, and with clang.

The unit tests compare those of the normal build. Prints "[determinism] N passed, N failed" as the last line; the exit code is 0
only if all hashes are the expected ones. A build for which this machine lacks the compiler or the emulator is named and left out.
"""

import glob
import os
import platform
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

from emulators import first_program, qemu_arm64  # noqa: E402

BUILD = os.path.join(ROOT, "build", "determinism")
FOLDERS = ("net/endpoint", "net/delivery", "net/motion", "net/stream", "net/coding")
FILES = ("src/net/pose_codec.cpp", "src/cga/motor/interpolate.cpp",
         "src/cga/platform/processor.cpp", "tests/determinism/main.cpp")
OPTIONS = ("-std=c++17", "-Isrc", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math")
IS_X86_64 = platform.machine().lower() in ("x86_64", "amd64")
ARM64_COMPILER = "aarch64-linux-gnu-g++"


def builds():
    """(name, compiler, options, emulator) of each build; the compiler or the emulator is None if it is missing."""
    base = first_program("g++", "c++")
    clang = first_program("clang++", "clang++-19")
    result = [("baseline, -O0", base, ["-O0", "-DCGA_BASELINE_ONLY"], ""), ("clang, -O3", clang, ["-O3"], "")]
    if IS_X86_64:
        if not (shutil.which(ARM64_COMPILER) and qemu_arm64()):
            subprocess.run([os.path.join(ROOT, "tools", "setup"), "arm64"], check=False)
        result.append(("arm64, -O2", shutil.which(ARM64_COMPILER), ["-O2", "-static"], qemu_arm64()))
    return result


def compile_one(compiler, options, source, place):
    """Compiles a source; returns the path of the object."""
    target = os.path.join(place, source.replace("/", "_") + ".o")
    avx2 = ["-mavx2"] if source.endswith("_avx2.cpp") and IS_X86_64 and ARM64_COMPILER not in compiler else []
    subprocess.run([compiler, *OPTIONS, *options, *avx2, "-c", source, "-o", target], cwd=ROOT, check=True)
    return target


def check(name, compiler, options, emulator):
    """Builds and runs the program; returns whether all hashes are the expected ones."""
    place = os.path.join(BUILD, name.replace(", -", "_"))
    os.makedirs(place, exist_ok=True)
    sources = list(FILES)
    for folder in FOLDERS:
        sources += [os.path.relpath(path, ROOT) for path in sorted(glob.glob(os.path.join(ROOT, "src", folder, "*.cpp")))]
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        objects = list(pool.map(lambda source: compile_one(compiler, options, source, place), sources))
    program = os.path.join(place, "packets")
    subprocess.run([compiler, *options, *objects, "-o", program], check=True)
    done = subprocess.run([*([emulator] if emulator else []), program], stdout=subprocess.PIPE, text=True, check=False)
    print(f"{name}:\n{done.stdout}", end="", flush=True)
    return done.returncode == 0


def main():
    """Runs all builds that this machine can."""
    passed = failed = 0
    for name, compiler, options, emulator in builds():
        if compiler is None or emulator is None:
            print(f"{name}: not run, as the compiler or the emulator is not installed (see tools/setup arm64)", flush=True)
            continue
        try:
            is_equal = check(name, compiler, options, emulator)
        except subprocess.CalledProcessError as error:
            print(f"{name}: {error}")
            is_equal = False
        passed += is_equal
        failed += not is_equal
    print(f"[determinism] {passed} passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
