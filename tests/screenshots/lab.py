"""A scripted user of the interpolation lab in the dock, in the real editor on a copy of the project."""

import os

import scripted_user

SECONDS = 60


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed; saves pictures of the dock."""
    pictures = [f"--lab-picture={os.path.join(output, 'lab.png')}", f"--wide-picture={os.path.join(output, 'lab_wide.png')}"]
    yield "a user of the interpolation lab", scripted_user.check(engine, project, "lab_probe", pictures, SECONDS)
