"""A scripted person at the playground in the editor's 3D viewport, on a copy of the project."""

import os
import shutil

import editor
import person

SECONDS = 150
REFERENCE = os.path.join(editor.HERE, "reference", "viewport.png")


def tests(engine, project, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    yield "a person at the 3D viewport", check_view(engine, project, output)


def write_reference(engine, project, output):
    """Takes the picture of the viewport as the one to compare with."""
    check_view(engine, project, output, reference=None)
    shutil.copyfile(os.path.join(output, "viewport.png"), REFERENCE)


def check_view(engine, project, output, reference=REFERENCE):
    """Everything that is done in view_probe/probe.gd; leaves pictures in the folder `output`."""
    arguments = [f"--pictures={output}"] + ([f"--reference={reference}"] if reference else [])
    return person.check(engine, project, "view_probe", arguments, SECONDS)
