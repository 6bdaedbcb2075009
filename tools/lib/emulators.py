"""Commands that run programs of other systems on this machine."""

import os
import shutil
import sys

import checkout

# The C library of arm64, which Debian's cross compiler brings.
ARM64_ROOT = "/usr/aarch64-linux-gnu"
WINE_FOLDER = "/usr/lib/wine"
WINE_ENV = {
    "WINEPREFIX": os.path.join(checkout.BUILD, "wine"),
    "WINEDEBUG": "-all",
    # No dialogs about a browser and about .NET.
    "WINEDLLOVERRIDES": "mscoree,mshtml=",
}


def first_program(*names, path=None):
    """Path of the first of the programs on PATH or in the folder `path`; None if there is none."""
    return next((found for name in names for found in (shutil.which(name), shutil.which(name, path=path) if path else None) if found), None)


def qemu_arm64():
    """Path of QEMU for programs of Linux on arm64; None if it is not installed."""
    return first_program("qemu-aarch64", "qemu-aarch64-static")


def test_program(platform, arch, name, *arguments):
    """The command and the additional environment that run a test program that zig built; exits without the emulator."""
    program = os.path.join(checkout.zig_variant(platform, arch), "tests", name)
    if (platform, arch) == checkout.host():
        return [program, *arguments], {}
    if platform == "windows":
        command, env = [first_program("wine64", "wine", path=WINE_FOLDER), program + ".exe", *arguments], WINE_ENV
    else:
        command, env = [qemu_arm64(), "-L", ARM64_ROOT, program, *arguments], {}
    if command[0] is None:
        sys.exit(f"there is no emulator for {platform}, {arch}: run tools/setup arm64 wine")
    return command, dict(env)
