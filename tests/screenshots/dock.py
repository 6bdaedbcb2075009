"""A scripted person at the dock "GA Playground", in the real editor on a copy of the project."""

import os
import re
import shutil
import tempfile

import editor
import engine_run

PROBE = "dock_probe"
SECONDS = 120
SIZE = "1280x800"
REFERENCES = os.path.join(editor.HERE, "reference")
CHAPTERS = ["entries", "combining", "coloring", "coefficients", "copying", "files", "gallery", "undoing", "embedded", "docking", "speed",
            "looks", "leaving"]
# Of an editor that is started a second time, with another look.
LATER_CHAPTERS = ["returning", "looks"]
# These pictures of chapters/looks.gd are compared.
COMPARED = ["dark_100_250", "dark_100_250_end", "dark_100_600_coefficients", "light_200_600", "light_200_600_coefficients"]
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
    with tempfile.TemporaryDirectory(prefix="ga_godot_dock_") as place:
        copy = os.path.join(place, "project")
        editor.copy_project(project, copy, PROBE)
        engine = engine.with_environment({"XDG_CONFIG_HOME": os.path.join(place, "config")})
        write_settings(os.path.join(place, "config"), "Default", 100)
        imported = engine.run(["--path", copy, "--import"], editor.IMPORT_SECONDS, drawing=False)
        yield "importing a project with the dock", editor.run_problems(imported)
        run = run_editor(engine, copy, output, CHAPTERS, "dark_100")
        yield "a person at the dock", probe_problems(run, EXPECTED_ERRORS)
        write_settings(os.path.join(place, "config"), "Light", 200)
        run = run_editor(engine, copy, output, LATER_CHAPTERS, "light_200")
        yield "the dock in an editor that was started again", probe_problems(run, [])


def write_references(engine, project, output):
    """Takes the pictures of the dock as those to compare with."""
    for _ in tests(engine, project, output):
        pass
    for title in COMPARED:
        shutil.copyfile(os.path.join(output, f"dock_{title}.png"), os.path.join(REFERENCES, f"dock_{title}.png"))


def run_editor(engine, copy, output, chapters, look):
    """These chapters of dock_probe, in the real editor; leaves pictures in the folder `output`."""
    return engine.run(["--path", copy, "-e", "--windowed", "--resolution", SIZE, "--position", "0,0", "--",
                       f"--chapters={','.join(chapters)}", f"--look={look}", f"--pictures={output}",
                       f"--references={REFERENCES}"], SECONDS)


def probe_problems(run, expected):
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


def write_settings(folder, theme, percent):
    """The settings of an editor that was never started by a person."""
    os.makedirs(os.path.join(folder, "godot"), exist_ok=True)
    with open(os.path.join(folder, "godot", "editor_settings-4.6.tres"), "w", encoding="utf-8") as file:
        file.write(SETTINGS.format(theme=theme, scale=SCALES[percent]))
