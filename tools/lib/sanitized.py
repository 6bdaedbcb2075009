"""The suites of tools/test --sanitize: the C++ and engine tests, built with each sanitizer in turn."""

import glob
import os
import shutil
import subprocess

import checkout
import project
from build import LIBRARY, build
from suite_process import Program
from suites import Suite, unit_programs

SANITIZERS = ("address", "undefined")
SECONDS = 900
ADDON_LIBRARIES = "addons/ga_godot/bin"
# A finding ends the program, so that it fails the suite. Leaks of the engine itself are not reported.
UNIT_ENV = {"UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1"}
ENGINE_ENV = {**UNIT_ENV, "ASAN_OPTIONS": "detect_leaks=0:verify_asan_link_order=0"}


def unit_suite(sanitizer):
    """The doctest programs under a sanitizer."""

    def programs():
        found = unit_programs(sanitizer)
        for program in found:
            program.env.update(UNIT_ENV)
        return found

    return Suite(f"cpp-{sanitizer}", (), (), programs)


def engine_suite(sanitizer):
    """The engine-side tests with a sanitized library, in a copy of the project."""

    def programs():
        folder = copy_project(sanitizer)
        # The engine itself, not the wrapper: the shell would load LD_PRELOAD too.
        argv = [checkout.setup_path("engine"), "--headless", "--path", folder, "--", "--test"]
        env = dict(ENGINE_ENV)
        if sanitizer == "address":
            env["LD_PRELOAD"] = f"{build_shim()} {runtime('libasan.so')}"
        return [Program(argv, seconds=SECONDS, env=env)]

    return Suite(f"engine-{sanitizer}", (), (), programs)


SUITES = tuple(unit_suite(name) for name in SANITIZERS) + tuple(engine_suite(name) for name in SANITIZERS)


def make_ready():
    """Installs missing dependencies, builds both sanitized variants, and prepares the project with the plain library."""
    checkout.setup("build", "unit", "engine")
    os.environ["GODOT"] = checkout.setup_path("engine")
    build(LIBRARY)
    project.prepare(checkout.PROJECT)
    for sanitizer in SANITIZERS:
        build(os.path.relpath(checkout.variant(sanitizer), checkout.ROOT), "tests", sanitizer=sanitizer)


def copy_project(sanitizer):
    """Folder of a copy of the project with the sanitized library, including the imported files."""
    place = os.path.join(checkout.variant(sanitizer), "engine")
    shutil.rmtree(place, ignore_errors=True)
    folder = os.path.join(place, "project")
    shutil.copytree(checkout.PROJECT, folder)
    # Tests read the guides and the class reference, and the files that these name.
    for name in ("README.md", "docs", "src", "tests"):
        os.symlink(os.path.join(checkout.ROOT, name), os.path.join(place, name))
    libraries = os.path.join(folder, ADDON_LIBRARIES)
    shutil.rmtree(libraries)
    os.mkdir(libraries)
    for path in glob.glob(os.path.join(checkout.variant(sanitizer), "libga_godot.*")):
        shutil.copy2(path, libraries)
    return folder


def build_shim():
    """Path of the compiled clear_deepbind.c."""
    path = os.path.join(checkout.variant("address"), "clear_deepbind.so")
    source = os.path.join(checkout.TOOLS, "lib", "clear_deepbind.c")
    subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", path, source, "-ldl"], check=True)
    return path


def runtime(name):
    """Path of a library that comes with the compiler."""
    done = subprocess.run(["gcc", f"-print-file-name={name}"], stdout=subprocess.PIPE, text=True, check=True)
    return os.path.realpath(done.stdout.strip())
