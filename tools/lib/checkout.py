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
    machine = platform.machine().lower()
    arch = {"amd64": "x86_64", "aarch64": "arm64"}.get(machine, machine)
    name = f"{platform.system().lower()}.template_debug.{arch}"
    return os.path.join(BUILD, f"{name}.{sanitizer.replace(',', '_')}" if sanitizer else name)


def setup(*parts):
    """Installs missing dependencies of the parts; exits if that fails: setup has printed the reason."""
    if subprocess.run([os.path.join(TOOLS, "setup"), *parts], check=False).returncode != 0:
        sys.exit(1)


def setup_path(what):
    """Path of something that setup provides: engine, engine_arm64, templates, oracle, style, plots, cache, apis."""
    done = subprocess.run([os.path.join(TOOLS, "setup"), "--print", what],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(1)
    return done.stdout.strip()
