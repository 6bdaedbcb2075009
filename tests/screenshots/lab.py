"""A scripted person at the interpolation lab of the dock, in the real editor on a copy of the project."""

import os
import re
import shutil
import tempfile

import dock
import editor

PROBE = "lab_probe"
HANDS = os.path.join(editor.HERE, "dock_probe", "hands.gd")
SECONDS = 60
SIZE = "1280x800"


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    yield "a person at the interpolation lab", check_lab(engine, project, output)


def check_lab(engine, project, output, theme="Default", percent=100, size=SIZE):
    """Everything that is done in lab_probe/probe.gd; leaves pictures of the dock in the folder `output`."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_lab_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        shutil.copy(HANDS, os.path.join(copy, "addons", PROBE))
        dock.write_settings(os.path.join(place, "config"), theme, percent)
        with_settings = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        imported = with_settings.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        run = with_settings.run(["--path", copy, "-e", "--windowed", "--resolution", size, "--position", "0,0", "--",
                                 f"--lab-picture={os.path.join(output, 'lab.png')}",
                                 f"--wide-picture={os.path.join(output, 'lab_wide.png')}"], SECONDS)
    problems = editor.run_problems(imported) + editor.run_problems(run)
    problems += re.findall(r"^\[probe\] FAIL (.*)$", run.text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", run.text, re.MULTILINE):
        problems.append("the probe did not come to its end")
    return problems
