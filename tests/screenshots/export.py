"""The playground in an exported game: a pack is exported from a copy of the project, and a button pressed in it."""

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
SAID = ["entries A", "words point, at (0, 0, 0)", "example Circle through three points",
        "done"]


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    del output
    with tempfile.TemporaryDirectory(prefix="ga_godot_export_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy)
        game = os.path.join(place, "game")
        # Where a game looks for the library that its pack cannot hold.
        libraries = os.path.join("addons", "ga_godot", "bin")
        shutil.copytree(os.path.join(project, libraries), os.path.join(game, libraries))
        engine.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        yield "the playground in an exported game", check_export(engine, copy, game)
        yield "an exported game without the playground", check_left_out(engine, copy, game)


def check_export(engine, copy, game):
    """The demo runs from the pack, and a button adds an object."""
    pack = os.path.join(game, "game.pck")
    problems = export(engine, copy, pack, "true")
    run = engine.in_folder(game).run(["--main-pack", pack, "-s", PROBE], RUN_SECONDS, drawing=False)
    problems += editor.run_problems(run)
    said = re.findall(r"^\[probe\] (.*)$", run.text, re.MULTILINE)
    if said != SAID:
        problems.append(f"the probe said {said}, expected {SAID}")
    return problems


def check_left_out(engine, copy, game):
    """By an option of the preset no script of the playground is in the pack."""
    pack = os.path.join(game, "without.pck")
    problems = export(engine, copy, pack, "false")
    if not problems:
        with open(pack, "rb") as file:
            if b"addons/ga_godot/playground/" in file.read():
                problems.append("the pack has the playground")
    return problems


def export(engine, copy, pack, includes):
    """What is wrong with exporting."""
    with open(os.path.join(copy, "export_presets.cfg"), "w", encoding="utf-8") as file:
        file.write(PRESET.format(includes=includes))
    exported = engine.run(["--path", copy, "--export-pack", "Pack", pack], EXPORT_SECONDS, drawing=False)
    problems = editor.run_problems(exported)
    if not os.path.exists(pack):
        problems.append("no pack was written")
    return problems
