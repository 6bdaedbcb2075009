"""A scripted person at a scene with GANode3D, in the real editor on a copy of the project."""

import os
import re
import shutil
import tempfile

import dock
import editor

PROBE = "drawing_probe"
HANDS = os.path.join(editor.HERE, dock.PROBE, "hands.gd")
SECONDS = 90


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    yield "a scene with GANode3D in the editor", check(engine, project, output)


def check(engine, project, output):
    """Everything that is done in drawing_probe/probe.gd; leaves pictures of the editor in the folder `output`."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_drawing_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        shutil.copy(HANDS, os.path.join(copy, "addons", PROBE))
        dock.write_settings(os.path.join(place, "config"), "Default", 100)
        with_settings = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        imported = with_settings.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        run = with_settings.run(["--path", copy, "-e", "--windowed", "--resolution", dock.SIZE, "--position", "0,0", "--",
                                 f"--one-view={os.path.join(output, 'drawing_one_view.png')}",
                                 f"--four-views={os.path.join(output, 'drawing_four_views.png')}"], SECONDS)
    problems = editor.run_problems(imported) + editor.run_problems(run)
    problems += re.findall(r"^\[probe\] FAIL (.*)$", run.text, re.MULTILINE)
    if not re.search(r"^\[probe\] done$", run.text, re.MULTILINE):
        problems.append("the probe did not come to its end")
    return problems
