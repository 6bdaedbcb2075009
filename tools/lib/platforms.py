"""The suites of tools/test --platforms: the archive with the libraries of all systems, and tests under emulators."""

import glob
import os

import checkout
import emulators
import project
from build import LIBRARY, build
from suite_process import Program
from suites import PYTHON, Suite

FOLDER = os.path.join(checkout.ROOT, "tests", "platforms")
# Emulated processors are slower by an order of magnitude.
SECONDS = 900
EMULATED = (("windows", "x86_64"), ("linux", "arm64"))


def inspect_suite():
    """What the archive's libraries need and offer."""
    archive = max(glob.glob(os.path.join(checkout.ROOT, "dist", "ga_godot-*.zip")), key=os.path.getmtime)
    return [Program([checkout.setup_path("cross"), os.path.join(FOLDER, "inspect_libraries.py"), archive], seconds=120, engine=False)]


def load_suite():
    """Loads the libraries without an engine."""
    return [Program([PYTHON, os.path.join(FOLDER, "load_libraries.py")], seconds=600, engine=False)]


def unit_suite(platform, arch):
    """The doctest programs of the core under an emulator."""
    commands = [emulators.test_program(platform, arch, f"{name}_tests") for name in ("cga", "net", "playground", "threads")]
    return [Program(command, seconds=SECONDS, env=env, engine=False) for command, env in commands]


def archive_suite():
    """The checks of the suite package, of the archive with all libraries."""
    return [Program([PYTHON, os.path.join(checkout.ROOT, "tests", "package", "run.py"), "--complete"], seconds=3600, engine=False)]


def engine_suite():
    """The engine tests with the archive's library for this machine."""
    platform, arch = checkout.host()
    place = checkout.zig_variant(platform, arch)
    folder = project.copy_with_library(os.path.join(place, f"libga_godot.{platform}.{arch}.so"), os.path.join(place, "engine"))
    return [Program([checkout.ENGINE, "--headless", "--path", folder, "--", "--test"], seconds=SECONDS)]


def engine_arm64_suite():
    """The engine tests with the archive's library for arm64, in an emulated engine."""
    return [Program([PYTHON, os.path.join(FOLDER, "engine_arm64.py")], seconds=4 * SECONDS, engine=False)]


SUITES = (
    Suite("archive", (), (), archive_suite),
    Suite("libraries", (), (), inspect_suite),
    Suite("load", (), (), load_suite),
    *(Suite(f"cpp-{platform}-{arch}", (), (), lambda platform=platform, arch=arch: unit_suite(platform, arch)) for platform, arch in EMULATED),
    Suite("engine-archive", (), (), engine_suite),
    Suite("engine-arm64", (), (), engine_arm64_suite),
)


def make_ready():
    """Installs missing dependencies, and builds the archive and the test programs."""
    checkout.setup("build", "unit", "engine", "cross", "wine", "arm64", "engine_arm64")
    os.environ["GODOT"] = checkout.setup_path("engine")
    build(LIBRARY)
    project.prepare(checkout.PROJECT)
    build("package")
    platform, arch = checkout.host()
    build(os.path.relpath(os.path.join(checkout.zig_variant(platform, arch), "tests", "library_host"), checkout.ROOT), options=["toolchain=zig"])
    for platform, arch in EMULATED:
        build("tests", options=[f"platform={platform}", f"arch={arch}"])
