"""The suites of tools/test --sanitize.

The C++ and engine tests run with the address and undefined-behavior sanitizers, which one build combines. The thread
sanitizer runs the C++ tests that use threads. It is of no use in the engine: that is compiled without it, so it does not see
how the engine's threads are synchronized, and reports races that are none.
"""

import os
import subprocess

import checkout
import project
from build import LIBRARY, build
from suite_process import Program
from suites import Suite, unit_programs

MEMORY = "address,undefined"
THREAD = "thread"
THREAD_PROGRAM = "threads_tests"
SECONDS = 900
# A finding ends the program, so that it fails the suite. Leaks of the engine itself are not reported.
UNIT_ENV = {"UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1", "TSAN_OPTIONS": "halt_on_error=1"}
ENGINE_ENV = {**UNIT_ENV, "ASAN_OPTIONS": "detect_leaks=0:verify_asan_link_order=0"}


def unit_suite():
    """The doctest programs under the sanitizers of memory."""
    found = unit_programs(MEMORY)
    for program in found:
        program.env.update(UNIT_ENV)
        program.seconds = SECONDS
    return found


def thread_suite():
    """The C++ tests that use threads, under the thread sanitizer."""
    return [Program([thread_program()], seconds=SECONDS, env=dict(UNIT_ENV), engine=False)]


def engine_suite():
    """The engine-side tests with a sanitized library, in a copy of the project."""
    folder = project.copy_with_library(library(), os.path.join(checkout.variant(MEMORY), "engine"))
    # The engine itself, not the wrapper: the shell would load LD_PRELOAD too.
    argv = [checkout.setup_path("engine"), "--headless", "--path", folder, "--", "--test"]
    env = {**ENGINE_ENV, "LD_PRELOAD": f"{build_shim()} {runtime('libasan.so')}"}
    return [Program(argv, seconds=SECONDS, env=env)]


SUITES = (Suite("cpp-sanitized", (), (), unit_suite), Suite("threads", (), (), thread_suite),
          Suite("engine-sanitized", (), (), engine_suite))


def thread_program():
    """Path of the program of the C++ tests that use threads."""
    return os.path.join(checkout.variant(THREAD), "tests", THREAD_PROGRAM)


def library():
    """Path of the library with the sanitizers of memory."""
    return os.path.join(checkout.variant(MEMORY), "libga_godot.{}.{}.so".format(*checkout.host()))


def make_ready():
    """Installs missing dependencies, builds each sanitized variant once, and prepares the project with the plain library."""
    checkout.setup("build", "unit", "engine", "ccache")
    os.environ["GODOT"] = checkout.setup_path("engine")
    build(LIBRARY)
    project.prepare(checkout.PROJECT)
    build(os.path.relpath(library(), checkout.ROOT), "tests", sanitizer=MEMORY)
    build(os.path.relpath(thread_program(), checkout.ROOT), sanitizer=THREAD)


def build_shim():
    """Path of the compiled clear_deepbind.c."""
    path = os.path.join(checkout.variant(MEMORY), "clear_deepbind.so")
    source = os.path.join(checkout.TOOLS, "lib", "clear_deepbind.c")
    subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", path, source, "-ldl"], check=True)
    return path


def runtime(name):
    """Path of a library that comes with the compiler."""
    done = subprocess.run(["gcc", f"-print-file-name={name}"], stdout=subprocess.PIPE, text=True, check=True)
    return os.path.realpath(done.stdout.strip())
