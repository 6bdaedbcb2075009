"""What GANode3D draws in each of the engine's renderers, which end in time, also while they still compile shaders."""

import os
import re

METHODS = ("gl_compatibility", "mobile", "forward_plus")
PICTURE = "drawn_scene"
SIZE = "1152x648"
SECONDS = 60


def tests(engine, project, references, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    for method in METHODS:
        yield f"objects drawn by {method}", check(engine, project, method, references_of(references, method), f"--output={output}")


def write_references(engine, project, references):
    """Takes the pictures of the renderers as those to compare with."""
    for method in METHODS[1:]:
        os.makedirs(references_of(references, method), exist_ok=True)
        check(engine, project, method, references_of(references, method), "--update")


def references_of(references, method):
    """Those of the renderer that draws all other pictures lie at the top."""
    return references if method == METHODS[0] else os.path.join(references, method)


def check(engine, project, method, folder, *arguments):
    """One run that draws, compares and ends as soon as it has the picture."""
    run = engine.run(["--rendering-method", method, "--path", project, "--windowed", "--resolution", SIZE, "--position", "0,0",
                      "--", f"--screenshots={folder}", f"--picture={PICTURE}", *arguments], SECONDS)
    problems = run.problems() + re.findall(r"^FAIL .*$", run.text, re.MULTILINE)
    if run.code is None:
        problems.append(f"it did not end in {SECONDS} s")
    elif run.code != 0:
        problems.append(f"exit code {run.code}")
    if "--update" not in arguments and "[pictures] 1 passed, 0 failed" not in run.text:
        problems.append("the picture was not compared:\n" + run.text)
    return problems
