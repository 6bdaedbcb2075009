"""Runs tests of the engine suite in an engine that hides from the library what an older version lacks."""

import os
import re
import shutil
import subprocess

import checkout

HERE = os.path.dirname(os.path.abspath(__file__))
EXTENSION = os.path.join("addons", "ga_godot", "ga_godot.gdextension")
# What the addon's scripts look for by name.
LATER = re.compile(r'&"(EditorDock|FoldableContainer|DPITexture|popup_file_dialog)"')
DESCRIPTION = """[configuration]
entry_symbol = "older_engine_init"
compatibility_minimum = "4.4"
reloadable = false
[libraries]
linux = "older_engine.so"
"""


def link_tree(source, destination, inside=()):
    """A folder of links to the entries of another; the folders in `inside`, one in the other, are folders of their own."""
    os.makedirs(destination)
    for name in os.listdir(source):
        if name == ".godot":
            continue
        if inside and name == inside[0]:
            link_tree(os.path.join(source, name), os.path.join(destination, name), inside[1:])
        else:
            os.symlink(os.path.join(source, name), os.path.join(destination, name))


def make_project():
    """A copy of the project in a copy of the checkout, whose extension is older_engine.c; built anew each time."""
    root = os.path.join(checkout.BUILD, "older_engine")
    shutil.rmtree(root, ignore_errors=True)
    link_tree(checkout.ROOT, root, (os.path.basename(checkout.PROJECT), "addons", "ga_godot"))
    folder = os.path.join(root, os.path.basename(checkout.PROJECT))
    extension = os.path.join(folder, EXTENSION)
    os.remove(extension)
    with open(extension, "w", encoding="utf-8") as file:
        file.write(DESCRIPTION)
    include = os.path.join(checkout.BUILD, "bindings", "generated", "include")
    library = os.path.join(os.path.dirname(extension), "older_engine.so")
    command = [os.environ.get("CC", "gcc"), "-O1", "-Wall", "-Werror", "-shared", "-fPIC", f"-I{include}",
               os.path.join(HERE, "older_engine.c"), "-ldl", "-o", library]
    subprocess.run(command, check=True)
    # Imported files are those of the project, which was prepared.
    shutil.copytree(os.path.join(checkout.PROJECT, ".godot"), os.path.join(folder, ".godot"))
    return folder


def hide_later_classes(folder):
    """Makes the addon's scripts look for other classes than those that an older version lacks, and installs the probe."""
    addon = os.path.join(folder, "addons", "ga_godot")
    for name in ("editor", "playground"):
        source = os.path.realpath(os.path.join(addon, name))
        os.remove(os.path.join(addon, name))
        shutil.copytree(source, os.path.join(addon, name))
    for place, _, names in os.walk(addon):
        for path in [os.path.join(place, name) for name in names if name.endswith(".gd")]:
            with open(path, encoding="utf-8") as file:
                text = file.read()
            hidden = LATER.sub(r'&"Later\1"', text)
            if hidden != text:
                replace(path, hidden)
    shutil.copytree(os.path.join(HERE, "probe"), os.path.join(folder, "addons", "versions_probe"))
    path = os.path.join(folder, "project.godot")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    replace(path, text.replace("enabled=PackedStringArray(", 'enabled=PackedStringArray("res://addons/versions_probe/plugin.cfg", '))


def replace(path, text):
    """Writes a file in place of a link."""
    os.remove(path)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def run_editor(folder, lacks):
    """Runs the editor until the probe ends it; returns the output."""
    home = {name: folder for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    return start(folder, lacks, ["--editor"], home)


def run(folder, lacks, test):
    """Runs the tests of one name; returns (passed, failed, what the library asked for in vain, the output)."""
    output = start(folder, lacks, ["--", f"--test={test}" if test else "--test"])
    counts = re.search(r"^\[engine\] (\d+) passed, (\d+) failed", output, re.M)
    passed, failed = map(int, counts.groups()) if counts else (0, 1)
    return passed, failed, set(re.findall(r"^\[lacks\] (\S+)$", output, re.M)), output


def start(folder, lacks, arguments, env=None):
    """Runs the engine in the copy of the project; returns its output."""
    library = os.path.join(checkout.PROJECT, "addons", "ga_godot", "bin", "libga_godot.{}.{}.so".format(*checkout.host()))
    env = {**os.environ, **(env or {}), "OLDER_ENGINE_LACKS": " ".join(lacks), "OLDER_ENGINE_LIBRARY": library}
    command = [checkout.ENGINE, "--headless", "--path", folder, *arguments]
    done = subprocess.run(command, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          timeout=280, check=False)
    return done.stdout
