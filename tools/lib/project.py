"""Prepares a Godot project for headless runs: lists its extensions and imports its files."""

import fcntl
import hashlib
import os
import shutil
import subprocess
import sys

import checkout
import engine_log

STAMP = "ga_godot_imported"
LIBRARIES = "addons/ga_godot/bin"
IMPORT_SECONDS = 180
# Written by the engine or by the build; a change does not require an import.
GENERATED = (".import", ".uid", ".so", ".dll", ".dylib", ".tmp")


def prepare(folder):
    """Lists the project's extensions and imports its files, unless done before with the same files and engine."""
    state = os.path.join(folder, ".godot")
    os.makedirs(state, exist_ok=True)
    with open(os.path.join(state, "ga_godot_lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # a test and a demo may start at once
        list_extensions(folder)
        wanted = fingerprint(folder)
        stamp = os.path.join(state, STAMP)
        if read(stamp) == wanted:
            return
        import_files(folder)
        with open(stamp, "w", encoding="utf-8") as file:
            file.write(wanted)


def copy_with_library(library, place):
    """Folder of a copy of the prepared project, below the folder `place`, with another library."""
    shutil.rmtree(place, ignore_errors=True)
    folder = os.path.join(place, os.path.basename(checkout.PROJECT))
    shutil.copytree(checkout.PROJECT, folder, ignore=lambda path, _: ["bin"] if path.endswith(os.path.dirname(LIBRARIES)) else [])
    # Tests read the guides and the class reference, and the files that these name.
    for name in ("README.md", "docs", "src", "tests"):
        os.symlink(os.path.join(checkout.ROOT, name), os.path.join(place, name))
    os.mkdir(os.path.join(folder, LIBRARIES))
    shutil.copy2(library, os.path.join(folder, LIBRARIES))
    return folder


def list_extensions(folder):
    """Writes the list of extensions that the engine loads; without it, a first import aborts."""
    found = []
    for place, _, names in walk(folder):
        found += [os.path.relpath(os.path.join(place, name), folder) for name in names if name.endswith(".gdextension")]
    text = "".join(f"res://{path}\n" for path in sorted(found))
    path = os.path.join(folder, ".godot", "extension_list.cfg")
    if read(path).split() != text.split():
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def import_files(folder):
    """Runs the engine's import; exits with the engine's output if it reports a problem."""
    print(f"project: importing {os.path.relpath(folder, checkout.ROOT)} ...", file=sys.stderr, flush=True)
    command = [checkout.ENGINE, "--headless", "--path", folder, "--import"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=IMPORT_SECONDS, text=True, errors="replace", check=False)
    except subprocess.TimeoutExpired:
        sys.exit(f"project: the import did not finish within {IMPORT_SECONDS} s")
    problems = engine_log.problems_of(done.stdout)
    if done.returncode != 0 or problems:
        sys.exit(f"{done.stdout}\nproject: the import failed (exit code {done.returncode}), see above")


def fingerprint(folder):
    """A digest of the engine and of all files that it imports or scans for classes."""
    digest = hashlib.sha256()
    engine = os.stat(checkout.setup_path("engine"))
    digest.update(f"{folder} {engine.st_size} {engine.st_mtime_ns}\n".encode())
    for place, _, names in walk(folder):
        for name in sorted(names):
            if not name.endswith(GENERATED):
                path = os.path.join(place, name)
                with open(path, "rb") as file:
                    content = hashlib.sha256(file.read()).hexdigest()
                digest.update(f"{os.path.relpath(path, folder)} {content}\n".encode())
    return digest.hexdigest()


def walk(folder):
    """os.walk without hidden folders, in a fixed order."""
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield place, folders, names


def read(path):
    """The text of a file; empty if it does not exist."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""
