"""A scripted person at the playground in the editor's 3D viewport, on a copy of the project."""

import os
import re
import shutil
import tempfile

import dock
import editor

PROBE = "view_probe"
SECONDS = 150
REFERENCE = os.path.join(editor.HERE, "reference", "viewport.png")


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    yield "a person at the 3D viewport", check_view(engine, project, output)


def write_reference(engine, project, output):
    """Takes the picture of the viewport as the one to compare with."""
    check_view(engine, project, output, reference=None)
    shutil.copyfile(os.path.join(output, "viewport.png"), REFERENCE)


def check_view(engine, project, output, theme="Default", percent=100, size=dock.SIZE, reference=REFERENCE):
    """Everything that is done in view_probe/probe.gd; leaves pictures in the folder `output`."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_view_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        shutil.copyfile(os.path.join(editor.HERE, dock.PROBE, "hands.gd"),
                        os.path.join(copy, "addons", PROBE, "hands.gd"))
        dock.write_settings(os.path.join(place, "config"), theme, percent)
        with_settings = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        imported = with_settings.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        arguments = ["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--",
                     f"--pictures={output}"]
        if reference:
            arguments.append(f"--reference={reference}")
        run = with_settings.run(arguments, SECONDS)
    problems = editor.run_problems(imported) + editor.run_problems(run)
    problems += re.findall(r"^\[probe\] FAIL (.*)$", run.text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", run.text, re.MULTILINE):
        problems.append("the probe did not come to its end")
    return problems
