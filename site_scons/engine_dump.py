"""Finds the engine and runs it to dump its API, once for each engine version."""

import json
import os
import shutil
import subprocess
import sys

import requirements

OLDEST_ENGINE = (4, 6)


def dump(option, output):
    """Folder below output with extension_api.json and gdextension_interface.h of the engine that find() returns."""
    versions = Versions(os.path.join(output, "engines.json"))
    engine = find(option, versions)
    version = versions.of(engine)
    if numbers(version) < OLDEST_ENGINE:
        requirements.fail("{} is Godot {}; 4.6 or newer is needed".format(engine, version or "of an unknown version"))
    folder = os.path.join(output, version)
    if not os.path.isdir(folder):
        print("Dumping the API of Godot {}".format(version), flush=True)
        fresh = os.path.abspath(folder + ".new")
        shutil.rmtree(fresh, ignore_errors=True)
        os.makedirs(fresh)
        arguments = ["--headless", "--dump-extension-api", "--dump-gdextension-interface"]
        done = subprocess.run([engine] + arguments, cwd=fresh, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0 or sorted(os.listdir(fresh)) != ["extension_api.json", "gdextension_interface.h"]:
            sys.stderr.buffer.write(done.stdout)
            requirements.fail("{} did not dump its API".format(engine))
        os.rename(fresh, folder)
    return folder


def find(option, versions):
    """The engine: godot=, then GODOT, then PATH, then what tools/setup keeps in its cache."""
    for origin, value in (("godot=", option), ("GODOT=", os.environ.get("GODOT"))):
        if value:
            path = shutil.which(os.path.expanduser(value))
            if not path:
                requirements.fail("{}{} is not an executable: give the path of Godot 4.6 or newer".format(origin, value))
            return os.path.abspath(path)
    for name in ("godot", "godot4"):
        path = shutil.which(name)
        if path and numbers(versions.of(path)) >= OLDEST_ENGINE:
            return path
    done = subprocess.run(["tools/setup", "--print", "engine"], stdout=subprocess.PIPE, universal_newlines=True)
    path = done.stdout.strip()
    if done.returncode == 0 and os.path.isfile(path):
        return path
    requirements.fail("no Godot 4.6 or newer: run tools/setup, put godot on PATH, or give godot=PATH")


class Versions:
    """The versions of engines, such as 4.6.3.stable.official; kept in a file, because starting an engine is slow."""

    def __init__(self, path):
        self.path = path
        self.known = {}
        if os.path.isfile(path):
            with open(path, encoding="utf-8") as file:
                self.known = json.load(file)

    def of(self, engine):
        """The version; empty if the engine does not start."""
        status = os.stat(engine)
        identity = "{} {} {}".format(engine, status.st_size, status.st_mtime_ns)
        if identity not in self.known:
            version = ask(engine)
            if not version:
                return ""
            self.known[identity] = version
            os.makedirs(os.path.dirname(self.path), exist_ok=True)
            with open(self.path, "w", encoding="utf-8") as file:
                json.dump(self.known, file, indent=2)
        return self.known[identity]


def ask(engine):
    """The version that an engine prints; empty if it does not start."""
    try:
        command = [engine, "--headless", "--version"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    words = done.stdout.decode(errors="replace").split()
    return words[-1] if done.returncode == 0 and words else ""


def numbers(version):
    """(major, minor) of a version text; (0, 0) if it has none."""
    parts = version.split(".")
    return (int(parts[0]), int(parts[1])) if len(parts) > 1 and parts[0].isdigit() and parts[1].isdigit() else (0, 0)
