"""The playground in an exported game: exports a pack from a copy of the project, runs it and presses a button."""

import os
import re
import shutil
import tempfile

import editor

PROBE = os.path.join(editor.HERE, "export_probe", "probe.gd")
PRESET = """[preset.0]

name="Pack"
platform="Linux"
runnable=true
export_filter="all_resources"
include_filter=""
exclude_filter=""
export_path=""
script_export_mode=2

[preset.0.options]
ga_godot/include_playground={includes}
"""
EXPORT_SECONDS = 120
RUN_SECONDS = 60
PRINTED = ["entries A", "words point, at (0, 0, 0)", "example Circle through three points",
        "done"]


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed."""
    del output
    with tempfile.TemporaryDirectory(prefix="ga_godot_export_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy)
        game = os.path.join(place, "game")
        # The game loads the library from this folder, as a pack cannot contain it.
        libraries = os.path.join("addons", "ga_godot", "bin")
        shutil.copytree(os.path.join(project, libraries), os.path.join(game, libraries))
        engine.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        yield "the playground in an exported game", check_export(engine, copy, game)
        yield "an exported game without the playground", check_exclusion(engine, copy, game)


def check_export(engine, copy, game):
    """Runs the demo from the pack, where a button adds an object."""
    pack = os.path.join(game, "game.pck")
    problems = export(engine, copy, pack, "true")
    run = engine.in_folder(game).run(["--main-pack", pack, "-s", PROBE], RUN_SECONDS, drawing=False)
    problems += editor.run_problems(run)
    printed = re.findall(r"^\[probe\] (.*)$", run.text, re.MULTILINE)
    if printed != PRINTED:
        problems.append(f"the probe printed {printed}, expected {PRINTED}")
    return problems


def check_exclusion(engine, copy, game):
    """An option of the preset excludes all scripts of the playground from the pack."""
    pack = os.path.join(game, "without.pck")
    problems = export(engine, copy, pack, "false")
    if not problems:
        with open(pack, "rb") as file:
            if b"addons/ga_godot/playground/" in file.read():
                problems.append("the pack contains the playground")
    return problems


def export(engine, copy, pack, includes):
    """Exports a pack; returns a list of problems."""
    with open(os.path.join(copy, "export_presets.cfg"), "w", encoding="utf-8") as file:
        file.write(PRESET.format(includes=includes))
    exported = engine.run(["--path", copy, "--export-pack", "Pack", pack], EXPORT_SECONDS, drawing=False)
    problems = editor.run_problems(exported)
    if not os.path.exists(pack):
        problems.append("no pack was written")
    return problems
