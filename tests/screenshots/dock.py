"""A scripted person at the dock "GA Playground", in the real editor on a copy of the project."""

import os
import shutil
import tempfile

import editor
import person

PROBE = "dock_probe"
SECONDS = 120
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


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_dock_") as place:
        engine, copy, imported = person.prepare(engine, project, place, PROBE, "Default", 100)
        yield "importing a project with the dock", editor.run_problems(imported)
        run = run_editor(engine, copy, output, CHAPTERS, "dark_100")
        yield "a person at the dock", person.problems_of(run, EXPECTED_ERRORS)
        person.write_settings(place, "Light", 200)
        run = run_editor(engine, copy, output, LATER_CHAPTERS, "light_200")
        yield "the dock in an editor that was started again", person.problems_of(run)


def write_references(engine, project, output):
    """Takes the pictures of the dock as those to compare with."""
    for _ in tests(engine, project, output):
        pass
    for title in COMPARED:
        shutil.copyfile(os.path.join(output, f"dock_{title}.png"), os.path.join(REFERENCES, f"dock_{title}.png"))


def run_editor(engine, copy, output, chapters, look):
    """These chapters of dock_probe, in the real editor; leaves pictures in the folder `output`."""
    return person.start(engine, copy, [f"--chapters={','.join(chapters)}", f"--look={look}", f"--pictures={output}",
                                       f"--references={REFERENCES}"], SECONDS)
