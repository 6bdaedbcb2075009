"""A scripted user of the playground in the editor's 3D viewport, on a copy of the project."""

import os
import shutil

import editor
import scripted_user

SECONDS = 150
REFERENCE = os.path.join(editor.HERE, "reference", "viewport.png")


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed."""
    yield "a user of the 3D viewport", check_view(engine, project, output)


def write_reference(engine, project, output):
    """Makes the current picture of the viewport the reference."""
    check_view(engine, project, output, reference=None)
    shutil.copyfile(os.path.join(output, "viewport.png"), REFERENCE)


def check_view(engine, project, output, reference=REFERENCE):
    """Runs view_probe/probe.gd, which saves pictures in the folder `output`; returns a list of problems."""
    arguments = [f"--pictures={output}"] + ([f"--reference={reference}"] if reference else [])
    return scripted_user.check(engine, project, "view_probe", arguments, SECONDS)
