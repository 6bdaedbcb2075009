"""GA-Godot's plugin in the real editor, on copies of the project with and without the library."""

import os
import re
import shutil
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PLUGIN = '"res://addons/ga_godot/plugin.cfg"'
PROBE = "editor_probe"
MESSAGE = re.compile(r"^WARNING: GA-Godot: .*$", re.MULTILINE)
# The scripts of the examples name the classes of the library; the editor reads them when it first shows the project.
EXAMPLE_ERROR = re.compile(r"^SCRIPT ERROR: Parse Error: Could not find type .*\n *at: .*addons/ga_godot/examples/", re.MULTILINE)
EDITOR_SECONDS = 120
IMPORT_SECONDS = 120
# A smaller file (in bytes) is an empty picture.
MIN_PICTURE = 20_000


def tests(engine, project, output):
    """Yields the title of each test and a list of problems, empty if it passed."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_editor_") as place:
        copy = os.path.join(place, "project")
        copy_project(project, copy)
        imported = engine.run(["--path", copy, "--import"], IMPORT_SECONDS, drawing=False)
        yield "importing a copy of the project", run_problems(imported)
        yield "the plugin in the editor", check_editor(engine, copy, os.path.join(output, "editor.png"))
        shutil.rmtree(os.path.join(copy, "addons", "ga_godot", "bin"))
        yield "the start scene without the library", check_start_without_library(engine, copy)
        bare = os.path.join(place, "bare")
        make_bare_project(copy, bare)
        engine.run(["--path", bare, "--import"], IMPORT_SECONDS, drawing=False)
        yield "the editor without the library", check_editor_without_library(engine, bare)
        extension = os.path.join(bare, "addons", "ga_godot", "ga_godot.gdextension")
        leave_only_another_system(extension)
        yield "a library for another system only", check_message(engine, bare, "this version has no library for")
        os.remove(extension)
        yield "no extension file", check_message(engine, bare, "is missing. Copy the complete folder")


def copy_project(project, copy, probe=PROBE, base=None):
    """Copies the project, with a probe of this folder as a second plugin, to which the scripts of the folder `base` are added."""
    shutil.copytree(project, copy, ignore=shutil.ignore_patterns(".godot"))
    shutil.copytree(os.path.join(HERE, probe), os.path.join(copy, "addons", probe))
    if base:
        shutil.copytree(base, os.path.join(copy, "addons", probe), dirs_exist_ok=True)
    os.makedirs(os.path.join(copy, ".godot"))
    with open(os.path.join(copy, ".godot", "extension_list.cfg"), "w", encoding="utf-8") as file:
        file.write("res://addons/ga_godot/ga_godot.gdextension\n")
    path = os.path.join(copy, "project.godot")
    with open(path, encoding="utf-8") as file:
        settings = file.read()
    if PLUGIN not in settings:
        raise RuntimeError("project.godot does not enable the plugin")
    with open(path, "w", encoding="utf-8") as file:
        file.write(settings.replace(PLUGIN, f'{PLUGIN}, "res://addons/{probe}/plugin.cfg"'))


def make_bare_project(copy, bare):
    """Makes a project that has only the addon and the probe of that copy."""
    shutil.copytree(os.path.join(copy, "addons"), os.path.join(bare, "addons"))
    shutil.copytree(os.path.join(copy, ".godot"), os.path.join(bare, ".godot"),
                    ignore=lambda folder, names: [name for name in names if name != "extension_list.cfg"])
    with open(os.path.join(bare, "project.godot"), "w", encoding="utf-8") as file:
        file.write('config_version=5\n\n[application]\n\nconfig/name="Bare"\n'
                   'config/features=PackedStringArray("4.6", "GL Compatibility")\n\n[editor_plugins]\n\n'
                   f'enabled=PackedStringArray({PLUGIN}, "res://addons/{PROBE}/plugin.cfg")\n')


def run_problems(run):
    """Problems of a run that should succeed."""
    return run.problems() + ([] if run.code == 0 else [f"exit code {run.code}", *run.text.splitlines()[-10:]])


def check_editor(engine, copy, picture):
    """Disables and enables the plugin and opens a scene of the addon, without errors."""
    run = engine.run(["--path", copy, "-e", "--windowed", "--resolution", "1280x800", "--position", "0,0",
                      "--", f"--picture={picture}"], EDITOR_SECONDS)
    printed = re.findall(r"^\[probe\] (.*)$", run.text, re.MULTILINE)
    expected = ["library loaded", "enabled true", "off false", "on true", "scene MultivectorLerp", "picture OK", "done"]
    problems = run_problems(run)
    if printed != expected:
        problems.append(f"the probe printed {printed}, expected {expected}")
    if MESSAGE.search(run.text):
        problems.append(f"unexpected message: {MESSAGE.search(run.text).group(0)}")
    if not os.path.exists(picture) or os.path.getsize(picture) < MIN_PICTURE:
        problems.append(f"{picture} is empty")
    return problems


def check_editor_without_library(engine, copy):
    """The plugin prints one message each time it is enabled. Errors of the engine itself are ignored."""
    run = engine.run(["--path", copy, "-e", "--windowed", "--resolution", "1280x800", "--position", "0,0"],
                     EDITOR_SECONDS)
    problems = [] if run.code == 0 else [f"exit code {run.code}"]
    printed = re.findall(r"^\[probe\] (.*)$", run.text, re.MULTILINE)
    expected = ["library missing", "enabled true", "off false", "on true", "done"]
    if printed != expected:
        problems.append(f"the probe printed {printed}, expected {expected}")
    messages = MESSAGE.findall(run.text)
    if len(messages) != 2:  # at the start, and when the probe enables the plugin again
        problems.append(f"{len(messages)} messages of the plugin, expected 2: {messages}")
    if not all("is missing. Build it with scons" in message for message in messages):
        problems.append(f"the messages do not say what to do: {messages}")
    if "SCRIPT ERROR" in EXAMPLE_ERROR.sub("", run.text):
        problems.append("a script failed:\n" + run.text)
    return problems


def leave_only_another_system(extension):
    """Makes the extension file list only a library for another system."""
    with open(extension, encoding="utf-8") as file:
        text = file.read()
    before, _, after = text.partition("[libraries]")
    icons = after[after.index("[icons]"):]
    with open(extension, "w", encoding="utf-8") as file:
        file.write(f'{before}[libraries]\n\nweb.debug.wasm32 = "bin/libga_godot.wasm"\n\n{icons}')


def check_message(engine, bare, words):
    """Loading the project, by an import, prints one message that contains these words."""
    run = engine.run(["--path", bare, "--import"], IMPORT_SECONDS, drawing=False)
    messages = MESSAGE.findall(run.text)
    if len(messages) != 1 or words not in messages[0]:
        return [f"the plugin prints {messages}, expected one message with: {words}"]
    return ["a script failed:\n" + run.text] if "SCRIPT ERROR" in run.text else []


def check_start_without_library(engine, copy):
    """The start fails with exit code 1 and one line with the reason."""
    run = engine.run(["--path", copy, "--", "--test"], 60, drawing=False)
    problems = [] if run.code == 1 else [f"exit code {run.code}, expected 1"]
    if "The GA-Godot library is not loaded. Build it by running scons" not in run.text:
        problems.append("it does not report that the library is missing:\n" + run.text)
    if "SCRIPT ERROR" in run.text:
        problems.append("a script failed:\n" + run.text)
    return problems
