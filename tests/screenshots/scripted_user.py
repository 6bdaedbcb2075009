"""Runs scripted users (probes) in the real editor, on a copy of the project, with a given theme and scale."""

import os
import re
import tempfile

import editor
import engine_run

# Scripts that are copied to each probe.
BASE = os.path.join(editor.HERE, "probe_base")
SIZE = "1280x800"
# Overrides the editor settings of the user who runs the tests.
SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/theme/follow_system_theme = false
interface/theme/color_preset = "{theme}"
interface/editor/display_scale = {scale}
"""
# Values of the setting display_scale, which is an enumeration, by percentage.
SCALES = {100: 2, 200: 6}


def check(engine, project, probe, arguments, seconds, theme="Default", percent=100, size=SIZE):
    """Runs a probe, which is a plugin in the folder of that name; returns a list of problems."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_user_") as place:
        engine, copy, imported = prepare(engine, project, place, probe, theme, percent)
        run = start(engine, copy, arguments, seconds, size)
    return editor.run_problems(imported) + problems_of(run)


def prepare(engine, project, place, probe, theme, percent):
    """Prepares a run in the folder `place`. Returns the engine with its own settings, a copy of the project with the probe, and the
    run that imported it."""
    copy = os.path.join(place, "project")
    editor.copy_project(project, copy, probe, BASE)
    write_settings(place, theme, percent)
    engine = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
    return engine, copy, engine.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)


def start(engine, copy, arguments, seconds, size=SIZE):
    """Runs the editor on the copy until the probe quits it."""
    return engine.run(["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--", *arguments], seconds)


def problems_of(run, expected=()):
    """The failures of the probe, unexpected errors of the engine, and expected errors that are missing."""
    text = run.text
    problems = []
    for error in expected:
        if f"ERROR: {error}" not in text:
            problems.append(f"missing: {error}")
        text = text.replace(f"ERROR: {error}", "expected: ")
    problems += editor.run_problems(engine_run.Run(run.code, text))
    problems += re.findall(r"^\[probe\] FAIL (.*)$", text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", text, re.MULTILINE):
        problems.append("the probe did not reach its end")
    for line in re.findall(r"^\[probe\] .* ms$", text, re.MULTILINE):
        print(line)
    return problems


def write_settings(place, theme, percent):
    """Writes the settings of an editor that has never been started."""
    folder = os.path.join(place, "config", "godot")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "editor_settings-4.6.tres"), "w", encoding="utf-8") as file:
        file.write(SETTINGS.format(theme=theme, scale=SCALES[percent]))
