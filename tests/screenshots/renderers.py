"""What GANode3D draws in each of the engine's renderers, which end in time, also while they still compile shaders."""

import os
import re

METHODS = ("gl_compatibility", "mobile", "forward_plus")
PICTURE = "drawn_scene"
SIZE = "1152x648"
SECONDS = 60
EARLY_END = "res://tests/pictures/early_end.gd"
# An engine that waits for shaders at its end does so most of the times.
EARLY_ENDS = 3


def tests(engine, project, references, output):
    """Yields the title of each test and what is wrong, a list that is empty when it passed."""
    for method in METHODS:
        yield f"an early end of {method}", check_early_ends(engine, project, method)
        yield f"objects drawn by {method}", check(engine, project, method, references_of(references, method), f"--output={output}")


def write_references(engine, project, references):
    """Takes the pictures of the renderers as those to compare with."""
    for method in METHODS[1:]:
        os.makedirs(references_of(references, method), exist_ok=True)
        check(engine, project, method, references_of(references, method), "--update")


def references_of(references, method):
    """Those of the renderer that draws all other pictures lie at the top."""
    return references if method == METHODS[0] else os.path.join(references, method)


def check_early_ends(engine, project, method):
    """Runs that end while shaders are compiled."""
    problems = []
    for _ in range(EARLY_ENDS):
        run = engine.run(["--rendering-method", method, "--path", project, "--script", EARLY_END], SECONDS)
        problems += run_problems(run)
    return problems


def check(engine, project, method, folder, *arguments):
    """One run that draws, compares and ends as soon as it has the picture."""
    run = engine.run(["--rendering-method", method, "--path", project, "--windowed", "--resolution", SIZE, "--position", "0,0",
                      "--", f"--screenshots={folder}", f"--picture={PICTURE}", *arguments], SECONDS)
    problems = run_problems(run) + re.findall(r"^FAIL .*$", run.text, re.MULTILINE)
    if "--update" not in arguments and "[pictures] 1 passed, 0 failed" not in run.text:
        problems.append("the picture was not compared:\n" + run.text)
    return problems


def run_problems(run):
    """What is wrong with how a run ended."""
    problems = run.problems()
    if run.code is None:
        problems.append(f"it did not end in {SECONDS} s")
    elif run.code != 0:
        problems.append(f"exit code {run.code}")
    return problems
