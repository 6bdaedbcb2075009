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
    """Path of the first of the programs on PATH or in the folder `path`; exits if there is none."""
    for name in names:
        found = shutil.which(name) or shutil.which(name, path=path)
        if found:
            return found
    sys.exit(f"none of {', '.join(names)} is installed: run tools/setup arm64 wine")


def command(platform, arch):
    """What to put before the arguments of a program, and its additional environment."""
    if platform == "windows":
        return [first_program("wine64", "wine", path=WINE_FOLDER)], WINE_ENV
    if arch == "arm64" and platform == "linux":
        return [first_program("qemu-aarch64", "qemu-aarch64-static"), "-L", ARM64_ROOT], {}
    raise ValueError(f"no emulator for {platform}, {arch}")
