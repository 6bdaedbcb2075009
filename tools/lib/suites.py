"""The test suites: what each needs from the machine and the build, and the programs it runs."""

import glob
import os
import sys
from dataclasses import dataclass
from typing import Callable

import checkout
import fuzzing
from build import LIBRARY
from suite_process import Program

PYTHON = sys.executable or "python3"


@dataclass
class Suite:
    """One name of --only."""

    name: str
    parts: tuple  # of tools/setup
    targets: tuple  # of SCons
    programs: Callable
    display: bool = False


def unit_programs(sanitizer=""):
    """The doctest programs: one for each folder of src/ with C++ tests, three for the code of the benchmarks, and one for the
    use of threads."""
    tests = os.path.join(checkout.ROOT, "tests")
    place = os.path.join(checkout.variant(sanitizer), "tests")
    names = [name for name in sorted(os.listdir(os.path.join(checkout.ROOT, "src")))
             if glob.glob(os.path.join(tests, name, "**", "*.cpp"), recursive=True)]
    programs = [f"{name}_tests" for name in [*names, "network_bench", "load_bench", "engine_bench", "threads"]]
    return [Program([os.path.join(place, program)], seconds=120, engine=False) for program in programs]


def cpp_programs():
    """The doctest programs, then each fuzz target: its corpus and some random edits of it."""
    place = os.path.join(checkout.variant(), "fuzz")
    findings = os.path.join(checkout.BUILD, "fuzz", "findings")
    os.makedirs(findings, exist_ok=True)
    return unit_programs() + [Program([os.path.join(place, target), "-runs=2000", "-timeout=20", f"-artifact_prefix={findings}/{target}-",
                                       fuzzing.corpus(target)], seconds=120, engine=False) for target in fuzzing.targets()]


def engine_programs():
    """The tests that run inside the engine."""
    return [Program([checkout.ENGINE, "--headless", "--path", checkout.PROJECT, "--", "--test"], seconds=240)]


def runner(folder, *arguments, seconds, python=PYTHON, engine=True):
    """A suite that is one Python program, tests/FOLDER/run.py."""
    path = os.path.join(checkout.ROOT, "tests", folder, "run.py")
    return [Program([python, path, *arguments], seconds=seconds, engine=engine)]


def algebra_programs():
    """The oracle tests, in the environment with the packages that they compare with."""
    return runner("oracle", seconds=400, python=checkout.setup_path("oracle"))


SUITES = (
    Suite("style", ("style", "build", "unit", "bench", "engine"), (LIBRARY,),
          lambda: runner("style", seconds=3600, engine=False)),
    Suite("tools", ("build", "display", "engine"), (LIBRARY,), lambda: runner("tools", seconds=300, engine=False)),
    Suite("cpp", ("build", "unit"), ("tests", "fuzz"), cpp_programs),
    Suite("determinism", ("build",), (), lambda: runner("determinism", seconds=900, engine=False)),
    Suite("package", ("build", "package", "engine"), (LIBRARY,), lambda: runner("package", seconds=600, engine=False)),
    Suite("algebra", ("build", "unit", "oracle", "engine"), (LIBRARY, "tests"), algebra_programs),
    Suite("bindings", ("build", "engine"), (LIBRARY,),
          lambda: runner("bindings", seconds=300) + runner("versions", seconds=300, engine=False)),
    Suite("engine", ("build", "engine"), (LIBRARY,), engine_programs),
    Suite("screenshots", ("build", "engine", "display", "graphics"), (LIBRARY,),
          lambda: runner("screenshots", seconds=360), display=True),
    Suite("export", ("build", "engine", "templates"), (LIBRARY,), lambda: runner("export", seconds=400)),
    Suite("newcomer", ("build", "engine", "display", "graphics", "templates"), (LIBRARY,),
          lambda: runner("newcomer", seconds=400), display=True),
    Suite("network", ("build", "engine"), (LIBRARY,), lambda: runner("network", seconds=700)),
)
