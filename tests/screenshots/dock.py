"""A scripted person at the dock "GA Playground", in the real editor on a copy of the project."""

import os
import re
import tempfile

import editor
import engine_run

PROBE = "dock_probe"
SECONDS = 120
SIZE = "1280x800"
CHAPTERS = ["entries", "combining", "coloring", "coefficients", "copying", "files", "docking", "speed"]
# What the engine says of the files that cannot be read, which the dock is given on purpose.
EXPECTED_ERRORS = [
    "GAScene.load_json: a part of the text cannot be read; the rest is loaded:",
    "GAScene.load_json: the text is no document; the scene stays as it was:",
]
# The editor's look, whatever that of the person who runs the tests is.
SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/theme/follow_system_theme = false
interface/theme/color_preset = "{theme}"
interface/editor/display_scale = {scale}
"""
# Of the setting display_scale, which is a choice from a list.
SCALES = {100: 2, 200: 6}


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    yield "a person at the dock", check_dock(engine, project, output)


def check_dock(engine, project, output, theme="Default", percent=100, size=SIZE, chapters=CHAPTERS):
    """Everything that is done in these chapters of dock_probe; leaves pictures in the folder `output`."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_dock_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        write_settings(os.path.join(place, "config"), theme, percent)
        with_settings = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        imported = with_settings.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        run = with_settings.run(["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--",
                                 f"--chapters={','.join(chapters)}", f"--pictures={output}"], SECONDS)
    return editor.run_problems(imported) + probe_problems(run)


def probe_problems(run):
    """What the probe says, and what the engine says beside the expected errors, each of which must be there."""
    text = run.text
    problems = []
    for error in EXPECTED_ERRORS:
        if f"ERROR: {error}" not in text:
            problems.append(f"missing: {error}")
        text = text.replace(f"ERROR: {error}", "expected: ")
    problems += editor.run_problems(engine_run.Run(run.code, text))
    problems += re.findall(r"^\[probe\] FAIL (.*)$", text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", text, re.MULTILINE):
        problems.append("the probe did not come to its end")
    for line in re.findall(r"^\[probe\] .* ms$", text, re.MULTILINE):
        print(line)
    return problems


def write_settings(folder, theme, percent):
    """The settings of an editor that was never started by a person."""
    os.makedirs(os.path.join(folder, "godot"))
    with open(os.path.join(folder, "godot", "editor_settings-4.6.tres"), "w", encoding="utf-8") as file:
        file.write(SETTINGS.format(theme=theme, scale=SCALES[percent]))
