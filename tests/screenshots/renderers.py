"""Drawing of GANode3D by each of the engine's renderers, and quitting while they still compile shaders."""

import os
import re

METHODS = ("gl_compatibility", "mobile", "forward_plus")
PICTURE = "drawn_scene"
SIZE = "1152x648"
SECONDS = 60
EARLY_END = "res://tests/pictures/early_end.gd"
# An engine that waits for shaders when it quits does so in most runs.
EARLY_ENDS = 3


def tests(engine, project, references, output):
    """Yields the title of each test and a list of problems, empty if it passed."""
    for method in METHODS:
        yield f"an early end of {method}", check_early_ends(engine, project, method)
        yield f"objects drawn by {method}", check(engine, project, method, references_of(references, method), f"--output={output}")


def write_references(engine, project, references):
    """Makes the current pictures of the renderers the references."""
    for method in METHODS[1:]:
        os.makedirs(references_of(references, method), exist_ok=True)
        check(engine, project, method, references_of(references, method), "--update")


def references_of(references, method):
    """The folder of a renderer's references. That of the renderer of all other pictures is the top folder."""
    return references if method == METHODS[0] else os.path.join(references, method)


def check_early_ends(engine, project, method):
    """Runs the engine and quits while shaders are being compiled; returns a list of problems."""
    problems = []
    for _ in range(EARLY_ENDS):
        run = engine.run(["--rendering-method", method, "--path", project, "--script", EARLY_END], SECONDS)
        problems += run_problems(run)
    return problems


def check(engine, project, method, folder, *arguments):
    """Draws and compares one picture and quits at once; returns a list of problems."""
    run = engine.run(["--rendering-method", method, "--path", project, "--windowed", "--resolution", SIZE, "--position", "0,0",
                      "--", f"--screenshots={folder}", f"--picture={PICTURE}", *arguments], SECONDS)
    problems = run_problems(run) + re.findall(r"^FAIL .*$", run.text, re.MULTILINE)
    if "--update" not in arguments and "[pictures] 1 passed, 0 failed" not in run.text:
        problems.append("the picture was not compared:\n" + run.text)
    return problems


def run_problems(run):
    """Problems with how a run ended."""
    problems = run.problems()
    if run.code is None:
        problems.append(f"it did not end within {SECONDS} s")
    elif run.code != 0:
        problems.append(f"exit code {run.code}")
    return problems
