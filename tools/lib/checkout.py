"""Paths in this checkout, and of dependencies that tools/setup installs outside it."""

import os
import platform
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOOLS = os.path.join(ROOT, "tools")
BUILD = os.path.join(ROOT, "build")
PROJECT = os.path.join(ROOT, "godot_project")
ENGINE = os.path.join(TOOLS, "godot")


def variant(sanitizer=""):
    """Folder of a build, named as SConstruct names it; `sanitizer` is the value of its option sanitize."""
    name = "{}.template_debug.{}".format(*host())
    return os.path.join(BUILD, f"{name}.{sanitizer.replace(',', '_')}" if sanitizer else name)


def zig_variant(system, arch):
    """Folder of a build with zig for a platform and a processor."""
    return os.path.join(BUILD, f"{system}.template_debug.{arch}.zig")


def host():
    """Platform and processor of this machine, by Godot's names."""
    machine = platform.machine().lower()
    return platform.system().lower(), {"amd64": "x86_64", "aarch64": "arm64"}.get(machine, machine)


def setup(*parts):
    """Installs missing dependencies of the parts; exits if that fails: setup has printed the reason."""
    if subprocess.run([os.path.join(TOOLS, "setup"), *parts], check=False).returncode != 0:
        sys.exit(1)


def setup_path(what):
    """Path of something that setup provides: engine, engine_arm64, zig, templates, oracle, style, plots, cross, cache, apis."""
    done = subprocess.run([os.path.join(TOOLS, "setup"), "--print", what],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(1)
    return done.stdout.strip()
