"""A scripted user who edits a scene with GANode3D, in the real editor on a copy of the project."""

import os

import scripted_user

SECONDS = 90


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed; saves pictures of the editor."""
    pictures = [f"--one-view={os.path.join(output, 'drawing_one_view.png')}",
                f"--four-views={os.path.join(output, 'drawing_four_views.png')}"]
    yield "a scene with GANode3D in the editor", scripted_user.check(engine, project, "drawing_probe", pictures, SECONDS)
