"""Makes a Godot project ready to run headless: its extensions listed, its files imported."""

import fcntl
import hashlib
import os
import subprocess
import sys

import checkout
import engine_log

STAMP = "ga_godot_imported"
IMPORT_SECONDS = 180
# Written by the engine or by the build; none of them changes what there is to import.
GENERATED = (".import", ".uid", ".so", ".tmp")


def prepare(folder):
    """Lists the project's extensions and imports it, unless that was done with these files and this engine."""
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


def list_extensions(folder):
    """Writes the list from which the engine loads extensions; a first import without it aborts."""
    found = []
    for place, _, names in walk(folder):
        found += [os.path.relpath(os.path.join(place, name), folder) for name in names if name.endswith(".gdextension")]
    text = "".join(f"res://{path}\n" for path in sorted(found))
    path = os.path.join(folder, ".godot", "extension_list.cfg")
    if read(path).split() != text.split():
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def import_files(folder):
    """Lets the engine import; ends the program with the engine's words if it reports a problem."""
    print(f"project: importing {os.path.relpath(folder, checkout.ROOT)} ...", file=sys.stderr, flush=True)
    command = [checkout.ENGINE, "--headless", "--path", folder, "--import"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=IMPORT_SECONDS, text=True, errors="replace", check=False)
    except subprocess.TimeoutExpired:
        sys.exit(f"project: the import did not end within {IMPORT_SECONDS} s")
    problems = engine_log.problems_of(done.stdout)
    if done.returncode != 0 or problems:
        sys.exit(f"{done.stdout}\nproject: the import failed (exit code {done.returncode}), see above")


def fingerprint(folder):
    """Changes when the engine or a file that it imports or scans for classes changes."""
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
    """A file's text; empty if there is none."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""
