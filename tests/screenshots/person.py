"""A scripted person in the real editor, on a copy of the project, with the look that is asked for."""

import os
import re
import tempfile

import editor
import engine_run

# Scripts that all probes share.
BASE = os.path.join(editor.HERE, "probe_base")
SIZE = "1280x800"
# The editor's look, whatever that of the person who runs the tests is.
SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/theme/follow_system_theme = false
interface/theme/color_preset = "{theme}"
interface/editor/display_scale = {scale}
"""
# Of the setting display_scale, which is a choice from a list.
SCALES = {100: 2, 200: 6}


def check(engine, project, probe, arguments, seconds, theme="Default", percent=100, size=SIZE):
    """Lets the probe, a plugin in a folder of that name, do what it does; returns what is wrong."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_person_") as place:
        engine, copy, imported = prepare(engine, project, place, probe, theme, percent)
        run = start(engine, copy, arguments, seconds, size)
    return editor.run_problems(imported) + problems_of(run)


def prepare(engine, project, place, probe, theme, percent):
    """Below the folder `place`: the engine with settings there, a copy of the project with the probe, the run that imported it."""
    copy = os.path.join(place, "project")
    editor.copy_project(project, copy, probe, BASE)
    write_settings(place, theme, percent)
    engine = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
    return engine, copy, engine.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)


def start(engine, copy, arguments, seconds, size=SIZE):
    """The editor on the copy, until the probe ends it."""
    return engine.run(["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--", *arguments], seconds)


def problems_of(run, expected=()):
    """What the probe says, and what the engine says beside the expected errors, each of which must be there."""
    text = run.text
    problems = []
    for error in expected:
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


def write_settings(place, theme, percent):
    """The settings of an editor that was never started by a person."""
    folder = os.path.join(place, "config", "godot")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "editor_settings-4.6.tres"), "w", encoding="utf-8") as file:
        file.write(SETTINGS.format(theme=theme, scale=SCALES[percent]))
