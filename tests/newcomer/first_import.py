"""The first headless import, by the lines of the addon's README and of the page about troubleshooting."""

import os
import shutil
import subprocess

import checkout
import engine_log
from newcomer import ADDON, PLUGIN

PAGES = ("docs/troubleshooting.md", "README.md")
SECONDS = 240
# A script that needs the extension to compile.
SCRIPT = "extends Node\n\n\nfunc value() -> Multivector:\n\treturn Multivector.point(Vector3.ONE)\n"


def first_import_by_the_documented_lines(newcomer):
    newcomer.set("editor_plugins", "enabled", f'PackedStringArray("{PLUGIN}")')
    newcomer.write("script.gd", SCRIPT)
    for page in PAGES:
        shutil.rmtree(newcomer.path(".godot"), ignore_errors=True)
        lines = [sample.text for sample in newcomer.page(page) if "--import" in sample.text]
        assert len(lines) == 1 and len(lines[0].splitlines()) == 2, f"{page} has other lines than the two for the import: {lines}"
        run_lines(newcomer, lines[0], page)
        imported = os.listdir(newcomer.path(os.path.join(".godot", "imported")))
        assert any(name.startswith("multivector.svg") for name in imported), imported
        assert not any(".png" in name for name in imported), f"the editor imports the pictures of the documentation: {imported}"
    os.remove(newcomer.path("script.gd"))
    left = [name for name in os.listdir(newcomer.path(ADDON)) if name.endswith(".import")]
    assert left == ["icon.svg.import"], left


def run_lines(newcomer, lines, page):
    """Runs lines of a page in the project, where `godot` is the engine of the tests. They must end with 0 and report no problem."""
    programs = os.path.join(newcomer.place, "bin")
    if not os.path.isdir(programs):
        os.mkdir(programs)
        program = os.path.join(programs, "godot")
        with open(program, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\nexec "{checkout.ENGINE}" "$@"\n')
        os.chmod(program, 0o755)
    environment = {**newcomer.environment, "PATH": programs + os.pathsep + newcomer.environment["PATH"]}
    done = subprocess.run(["sh", "-e", "-c", lines], cwd=newcomer.project, env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=SECONDS,
                          check=False)
    problems = engine_log.problems_of(done.stdout)
    assert done.returncode == 0 and not problems, f"the lines of {page} end with {done.returncode}; {problems}\n{done.stdout}"


CASES = (first_import_by_the_documented_lines,)
