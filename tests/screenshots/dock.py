"""A scripted user of the dock "GA Playground", in the real editor on a copy of the project."""

import os
import shutil
import tempfile

import editor
import scripted_user

PROBE = "dock_probe"
SECONDS = 120
REFERENCES = os.path.join(editor.HERE, "reference")
CHAPTERS = ["entries", "combining", "coloring", "coefficients", "copying", "files", "gallery", "undoing", "embedded", "docking", "speed",
            "looks", "leaving"]
# Chapters for a second start of the editor, with another theme.
LATER_CHAPTERS = ["returning", "looks"]
# The pictures of chapters/looks.gd that are compared.
COMPARED = ["dark_100_250", "dark_100_250_end", "dark_100_600_coefficients", "light_200_600", "light_200_600_coefficients"]
# Errors about the invalid files that the chapters open on purpose.
EXPECTED_ERRORS = [
    "GAScene.load_json_utf8: parts of the text could not be read; the rest was loaded:",
    "GAScene.load_json_utf8: the text was not loaded; the scene is unchanged:",
]


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_dock_") as place:
        engine, copy, imported = scripted_user.prepare(engine, project, place, PROBE, "Default", 100)
        yield "importing a project with the dock", editor.run_problems(imported)
        run = run_editor(engine, copy, output, CHAPTERS, "dark_100")
        yield "a user of the dock", scripted_user.problems_of(run, EXPECTED_ERRORS)
        scripted_user.write_settings(place, "Light", 200)
        run = run_editor(engine, copy, output, LATER_CHAPTERS, "light_200")
        yield "the dock after a restart of the editor", scripted_user.problems_of(run)


def write_references(engine, project, output):
    """Makes the current pictures of the dock the references."""
    for _ in tests(engine, project, output):
        pass
    for title in COMPARED:
        shutil.copyfile(os.path.join(output, f"dock_{title}.png"), os.path.join(REFERENCES, f"dock_{title}.png"))


def run_editor(engine, copy, output, chapters, look):
    """Runs chapters of dock_probe in the real editor; leaves pictures in the folder `output`."""
    return scripted_user.start(engine, copy, [f"--chapters={','.join(chapters)}", f"--look={look}", f"--pictures={output}",
                                       f"--references={REFERENCES}"], SECONDS)
