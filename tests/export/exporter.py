"""Exports a project by one of its presets."""

import os
import subprocess

import checkout
import engine_log
import pack

EXPORT_SECONDS = 120
PACK = ".pck"


class Export:
    """An exported game: its files, by path relative to its folder, and the project's files in its pack."""

    def __init__(self, folder, executable):
        self.executable = os.path.join(folder, executable)
        self.files = {}
        for place, _, names in os.walk(folder):
            for name in names:
                path = os.path.join(place, name)
                self.files[os.path.relpath(path, folder)] = path
        packs = [path for name, path in self.files.items() if name.endswith(PACK)]
        if len(packs) != 1:
            raise AssertionError(f"the export has {len(packs)} packs: {sorted(self.files)}")
        self.packed = pack.read(packs[0])

    def libraries(self):
        """The files outside the pack that are neither the executable nor part of a bundle."""
        bundle = (PACK, "Info.plist", "PkgInfo", "CodeResources")
        return {name: path for name, path in self.files.items()
                if path != self.executable and os.sep + "MacOS" + os.sep not in path and not name.endswith(bundle)}


def export(project, preset, kind, folder, name):
    """Exports a project in a kind, debug or release."""
    os.makedirs(folder)
    return run_export(project, folder, name, [f"--export-{kind}", preset, os.path.join(folder, name)])


def run_export(project, folder, name, arguments):
    """Runs Godot in the folder of a project with the arguments of an export; raises AssertionError for any error or warning."""
    try:
        done = subprocess.run([checkout.ENGINE, "--headless", "--path", ".", *arguments], cwd=project, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=EXPORT_SECONDS, text=True,
                              errors="replace", check=False)
    except subprocess.TimeoutExpired:
        raise AssertionError(f"{' '.join(arguments)} did not end within {EXPORT_SECONDS} s") from None
    # Godot exports a game without a library, and only warns.
    warnings = [line for line in done.stdout.splitlines() if "WARNING:" in line]
    problems = engine_log.problems_of(done.stdout) + warnings
    if done.returncode != 0 or problems:
        raise AssertionError(f"{' '.join(arguments)} ended with exit code {done.returncode}: {problems}")
    return Export(folder, name)
