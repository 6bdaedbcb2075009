"""A scripted person at the dock "GA Playground", in the real editor on a copy of the project."""

import os
import re
import shutil
import tempfile

import editor

PROBE = "dock_probe"
SECONDS = 60
SIZE = "1280x800"
REFERENCE = os.path.join(editor.HERE, "reference", "dock.png")
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


def write_reference(engine, project, output):
    """Takes the picture of the dock as the one to compare with."""
    check_dock(engine, project, output, reference=None)
    shutil.copyfile(os.path.join(output, "dock.png"), REFERENCE)


def check_dock(engine, project, output, theme="Default", percent=100, size=SIZE, reference=REFERENCE):
    """Everything that is done in dock_probe/probe.gd; leaves pictures of the dock in the folder `output`."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_dock_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        write_settings(os.path.join(place, "config"), theme, percent)
        with_settings = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        imported = with_settings.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        arguments = ["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--",
                     f"--dock-picture={os.path.join(output, 'dock.png')}",
                     f"--wide-picture={os.path.join(output, 'dock_wide.png')}"]
        if reference:
            arguments.append(f"--dock-reference={reference}")
        run = with_settings.run(arguments, SECONDS)
    problems = editor.run_problems(imported) + editor.run_problems(run)
    problems += re.findall(r"^\[probe\] FAIL (.*)$", run.text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", run.text, re.MULTILINE):
        problems.append("the probe did not come to its end")
    return problems


def write_settings(folder, theme, percent):
    """The settings of an editor that was never started by a person."""
    os.makedirs(os.path.join(folder, "godot"))
    with open(os.path.join(folder, "godot", "editor_settings-4.6.tres"), "w", encoding="utf-8") as file:
        file.write(SETTINGS.format(theme=theme, scale=SCALES[percent]))
