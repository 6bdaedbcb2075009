#!/usr/bin/env python3
"""Checks the archive for users, and examples/core with the CMake package, installed and by add_subdirectory.

Prints "[package] N passed, N failed" as the last line; the exit code is 0 only if every check passed.
"""

import glob
import os
import platform
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.path.join(ROOT, "build", "package")
EXAMPLE = os.path.join(ROOT, "examples", "core")
EXPECTED = """\
circle: center (1.000, 0.500, 0.000), radius 0.866
point 7: (1.000, 7.000, 0.000)
body: shown, within tolerance
"""
IS_X86_64 = platform.machine().lower() in ("x86_64", "amd64")
# Symbols of exception handling, which do not depend on the instruction set.
IGNORED_SYMBOLS = ("DW.ref.__gxx_personality_v0", "__clang_call_terminate")
BUILDING = os.path.join("docs", "building.md")
PROJECT = """\
cmake_minimum_required(VERSION 3.16)
project(documented CXX)
set(CMAKE_CXX_STANDARD 17)
add_executable(my_program "{source}")
{sample}"""
sys.path.insert(0, os.path.join(ROOT, "site_scons"))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))

import archive  # noqa: E402
import code_samples  # noqa: E402
import instruction_sets  # noqa: E402


def run(*command):
    """Runs a program and returns its stdout. Raises RuntimeError with its output if it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def folder(name):
    """Path of a folder below build/package."""
    return os.path.join(BUILD, name)


def configure(source, name, build_type, *options):
    """Configures a build folder, with warnings as errors."""
    run("cmake", "-S", source, "-B", folder(name), f"-DCMAKE_BUILD_TYPE={build_type}",
        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", *options)


def build(name, *targets):
    """Builds in a configured folder."""
    run("cmake", "--build", folder(name), "--parallel", str(os.cpu_count() or 1), *[f"--target={target}" for target in targets])


def check_example(name):
    """Builds and runs the example in a configured folder, and checks its output."""
    build(name, "core_example")
    printed = run(os.path.join(folder(name), "core_example"))
    if printed != EXPECTED:
        raise RuntimeError(f"core_example printed\n{printed}instead of\n{EXPECTED}")


def installed():
    """find_package() of the installed library, unoptimized."""
    configure(ROOT, "core", "Debug", f"-DCMAKE_INSTALL_PREFIX={folder('prefix')}")
    build("core")
    shutil.rmtree(folder("prefix"), ignore_errors=True)
    run("cmake", "--install", folder("core"))
    configure(EXAMPLE, "example_of_package", "Debug", f"-DCMAKE_PREFIX_PATH={folder('prefix')}")
    check_example("example_of_package")


def documented():
    """The lines of the page about building, with the installed package: they build and link the example's source."""
    samples = [sample for sample in code_samples.all_samples() if sample.language == "cmake"]
    if [sample.page for sample in samples] != [BUILDING]:
        raise RuntimeError(f"this test runs one sample, that of {BUILDING}, instead of {samples}")
    source = folder("documented_source")
    os.makedirs(source, exist_ok=True)
    with open(os.path.join(source, "CMakeLists.txt"), "w", encoding="utf-8") as file:
        file.write(PROJECT.format(source=os.path.join(EXAMPLE, "main.cpp"), sample=samples[0].text))
    configure(source, "documented", "Debug", f"-DCMAKE_PREFIX_PATH={folder('prefix')}")
    build("documented", "my_program")
    if run(os.path.join(folder("documented"), "my_program")) != EXPECTED:
        raise RuntimeError("the program does not print what core_example prints")


def subdirectory():
    """add_subdirectory() of the sources, optimized."""
    configure(EXAMPLE, "example_of_sources", "Release", f"-DGA_GODOT_CORE_SOURCE={ROOT}")
    check_example("example_of_sources")


def no_shared_code(name):
    """Each object for AVX2 defines one symbol: the linker could use another one in place of the baseline's."""
    sources = glob.glob(os.path.join(ROOT, "src", "*", "*", "*_avx2*.cpp"))
    objects = glob.glob(os.path.join(folder(name), "**", "*_avx2*.o"), recursive=True)
    if not sources or len(objects) != len(sources):
        raise RuntimeError(f"{len(sources)} sources for AVX2, {len(objects)} objects: {objects}")
    for path in objects:
        lines = run("nm", "--demangle", "--defined-only", "--extern-only", path).splitlines()
        symbols = [line.split(maxsplit=2) for line in lines if not line.endswith(IGNORED_SYMBOLS)]
        if len(symbols) != (1 if IS_X86_64 else 0) or any(kind not in "TDR" for _, kind, _ in symbols):
            raise RuntimeError(f"{path} defines {symbols}; code in it must have internal linkage (see batch/kernels.hpp)")


def same_options():
    """CMakeLists.txt has the options of site_scons/instruction_sets.py."""
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        text = file.read()
    for suffix, options in {**instruction_sets.ANY, **instruction_sets.X86_64}.items():
        line = f"set({suffix[1:-len('.cpp')]} {' '.join(options)})"
        if line not in text:
            raise RuntimeError(f"CMakeLists.txt lacks: {line}")


CHECKS = (
    ("the example with the installed package", installed),
    ("the lines of the page about building", documented),
    ("the example with the sources", subdirectory),
    ("unoptimized objects for AVX2 share no code", lambda: no_shared_code("core")),
    ("optimized objects for AVX2 share no code", lambda: no_shared_code("example_of_sources")),
    ("CMake and SCons use the same options for each instruction set", same_options),
    *archive.CHECKS,
    archive.INSTALL_CHECK,
)


def main():
    """Runs all checks, even after failures; with --complete, those of the archive with the libraries of all systems."""
    name, checks = "package", CHECKS
    if sys.argv[1:] == ["--complete"]:
        name, checks, archive.system = "archive", archive.CHECKS, ""
    failed = 0
    for title, check in checks:
        try:
            check()
        except (RuntimeError, OSError, subprocess.TimeoutExpired) as error:
            failed += 1
            print(f"FAIL {title}: {error}")
    print(f"[{name}] {len(checks) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
