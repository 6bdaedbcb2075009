"""Builds the library and prepares the Godot project: python3 tools/lib/build.py [TARGET...]

An up-to-date build takes a second. Output goes to stderr.
"""

import os
import subprocess
import sys

import checkout
import project

LIBRARY = "godot_project/addons"


def build(*targets, sanitizer="", compiler=None, options=()):
    """Runs SCons for the targets, with another compiler than CXX if one is given; exits if the build fails; SCons has
    printed the reason."""
    command = ["scons", "-Q", *options, *targets]
    if sanitizer:
        command.append(f"sanitize={sanitizer}")
    print("build: " + " ".join(command), file=sys.stderr, flush=True)
    env = {**os.environ, "CXX": compiler} if compiler else None
    done = subprocess.run(command, cwd=checkout.ROOT, env=env, stdin=subprocess.DEVNULL, stdout=sys.stderr, check=False)
    if done.returncode != 0:
        sys.exit("build: failed, see above")


def main():
    """Builds the targets in the arguments (default: the library) and prepares the project."""
    build(*(sys.argv[1:] or [LIBRARY]))
    project.prepare(checkout.PROJECT)


if __name__ == "__main__":
    main()
