"""Finds clang-format and clang-tidy, as tools/lib/system.sh does."""

import functools
import re
import shutil
import subprocess
import sys

VERSION = 19


@functools.cache
def find(name):
    """The command for clang tool `name`: NAME-19, or NAME if it is of version 19 or newer; exits if there is neither."""
    for command in (f"{name}-{VERSION}", name):
        if shutil.which(command) and major_version(version_of(command)) >= VERSION:
            return command
    sys.exit(f"{name} {VERSION} or newer not found: install {name}-{VERSION} (tools/setup style does on Debian and Ubuntu)")


@functools.cache
def version_of(command):
    """What the command prints for --version."""
    return subprocess.run([command, "--version"], stdout=subprocess.PIPE, text=True, check=False).stdout


def major_version(text):
    """The major version in a clang tool's --version output; 0 if it contains none."""
    match = re.search(r"version (\d+)\.", text)
    return int(match[1]) if match else 0
