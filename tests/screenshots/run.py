#!/usr/bin/env python3
"""Tests that need a display: pictures of the demos, and the plugin with its dock and 3D viewports in the real editor.

    tests/screenshots/run.py [--engine CMD] [--update | --docs]

Ends with one line `[screenshots] N passed, N failed`; the exit code is 0 only if
none failed. Draws on the display in DISPLAY, or on its own Xvfb.
Pictures of failures and of the editor are saved in build/screenshots.
"""

import argparse
import contextlib
import itertools
import os
import re
import shutil
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tools", "lib"))
sys.path.insert(0, HERE)

import display  # noqa: E402
import dock  # noqa: E402
import drawing  # noqa: E402
import editor  # noqa: E402
import engine_run  # noqa: E402
import indexed_png  # noqa: E402
import lab  # noqa: E402
import renderers  # noqa: E402
import view  # noqa: E402

PROJECT = os.path.join(ROOT, "godot_project")
REFERENCES = os.path.join(HERE, "reference")
DOCS_IMAGES = os.path.join(ROOT, "docs", "images")
OUTPUT = os.path.join(ROOT, "build", "screenshots")
REFERENCE_SIZE = "1152x648"
DOCS_SIZE = "1280x720"
# The pictures for the documentation.
DOCS_PICTURES = ("interpolation.png", "interpolation_lab_frames.png")
# A picture of each document of the gallery, and one of all of them.
GALLERY_IMAGES = os.path.join(DOCS_IMAGES, "gallery")
GALLERY_SECONDS = 300
MAX_IMAGE = 150_000
# Pictures of windows, saved next to the gallery's folder.
WINDOW_IMAGES = ("playground.png", "playground_light.png", "playground_editor.png")
MAX_SHEET_OR_WINDOW = 250_000


def main():
    parser = argparse.ArgumentParser(description="Compares pictures with references and drives the editor.")
    parser.add_argument("--engine", default=os.path.join(ROOT, "tools", "godot"), help="the engine's command")
    parser.add_argument("--update", action="store_true", help="write the references instead of comparing")
    parser.add_argument("--docs", action="store_true", help="write the documentation's pictures")
    options = parser.parse_args()
    os.makedirs(OUTPUT, exist_ok=True)
    with screen() as environment:
        engine = engine_run.Engine(options.engine, environment)
        if options.update:
            dock.write_references(engine, PROJECT, OUTPUT)
            view.write_reference(engine, PROJECT, OUTPUT)
            renderers.write_references(engine, PROJECT, REFERENCES)
            sys.exit(write_pictures(engine, REFERENCES, REFERENCE_SIZE))
        if options.docs:
            sys.exit(write_documentation(engine) or write_gallery(engine))
        sys.exit(run_tests(engine))


def screen():
    """A context with the environment of the display to draw on."""
    if os.environ.get("DISPLAY"):
        return contextlib.nullcontext({})
    return display.display()


def run_tests(engine):
    """Runs all tests and prints the last line; returns the exit code."""
    passed, failed = compare_pictures(engine)
    parts = [renderers.tests(engine, PROJECT, REFERENCES, OUTPUT)]
    parts += [part.tests(engine, PROJECT, OUTPUT) for part in (editor, dock, view, drawing, lab)]
    for title, problems in itertools.chain.from_iterable(parts):
        if problems:
            failed += 1
            print(f"FAIL {title}")
            for problem in problems:
                print(f"   {problem}")
        else:
            passed += 1
            print(f"{title}: passed")
    print(f"[screenshots] {passed} passed, {failed} failed")
    return 1 if failed else 0


def compare_pictures(engine):
    """Compares pictures; returns the numbers of passed and failed ones."""
    run = draw(engine, REFERENCES, REFERENCE_SIZE, f"--output={OUTPUT}")
    print(run.text, end="", flush=True)
    last = re.search(r"^\[pictures\] (\d+) passed, (\d+) failed$", run.text, re.MULTILINE)
    if not last:
        print("FAIL the engine ended before the last picture")
        return 0, 1
    passed, failed = int(last.group(1)), int(last.group(2))
    problems = run.problems()
    for problem in problems:
        print(f"FAIL while drawing: {problem}")
    if (run.code != 0) != (failed > 0):
        problems.append(f"exit code {run.code}")
        print(f"FAIL exit code {run.code} with {failed} failed pictures")
    return passed, failed + len(problems)


def draw(engine, folder, size, *arguments):
    """Runs the project's picture runner."""
    return engine.run(["--path", PROJECT, "--windowed", "--resolution", size, "--position", "0,0",
                       "--", f"--screenshots={folder}", *arguments], seconds=150)


def write_pictures(engine, folder, size):
    """Writes all pictures into a folder; returns the exit code."""
    os.makedirs(folder, exist_ok=True)
    run = draw(engine, folder, size, "--update")
    print(run.text, end="")
    return run.code


def write_documentation(engine):
    """Writes the documentation's pictures, which are larger than the references; returns the exit code."""
    folder = os.path.join(OUTPUT, "docs")
    code = write_pictures(engine, folder, DOCS_SIZE)
    if code == 0:
        os.makedirs(DOCS_IMAGES, exist_ok=True)
        for name in DOCS_PICTURES:
            shutil.copyfile(os.path.join(folder, name), os.path.join(DOCS_IMAGES, name))
            indexed_png.shrink(os.path.join(DOCS_IMAGES, name))
            print(f"wrote {os.path.relpath(os.path.join(DOCS_IMAGES, name), ROOT)}")
    return code


def write_gallery(engine):
    """Writes the pictures of the gallery, small enough for the repository; returns the exit code."""
    folder = os.path.join(OUTPUT, "gallery")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    run = engine.run(["--path", PROJECT, "--windowed", "--resolution", "640x360", "--position", "0,0",
                      "--", f"--gallery-pictures={folder}"], seconds=GALLERY_SECONDS)
    print(run.text, end="")
    if run.code != 0 or run.problems():
        return 1
    # The picture of the editor is one of the scripted user's.
    problems = view.check_view(engine, PROJECT, OUTPUT)
    if problems:
        print("\n".join(problems))
        return 1
    shutil.copyfile(os.path.join(OUTPUT, "viewport_editor.png"), os.path.join(folder, "playground_editor.png"))
    os.makedirs(GALLERY_IMAGES, exist_ok=True)
    too_large = 0
    for name in sorted(os.listdir(folder)):
        path = os.path.join(DOCS_IMAGES if name in WINDOW_IMAGES else GALLERY_IMAGES, name)
        shutil.copyfile(os.path.join(folder, name), path)
        indexed_png.shrink(path)
        size = os.path.getsize(path)
        fits = size <= (MAX_SHEET_OR_WINDOW if name in (*WINDOW_IMAGES, "all.png") else MAX_IMAGE)
        too_large += not fits
        print(f"wrote {os.path.relpath(path, ROOT)}, {size // 1000} kB{'' if fits else ', which is too large'}")
    return 1 if too_large else 0


if __name__ == "__main__":
    main()
