"""The editor with the newcomer's project: the dock, the class help, and by input events the quick start of the playground guide."""

import os
import shutil

import checkout
import editor
import networking
import scripted_user

HERE = os.path.dirname(os.path.abspath(__file__))
# The probe of the dock's tests, with chapters of its own.
PROBE = os.path.join("addons", "dock_probe")
HANDS = os.path.join("tests", "framework", "hands.gd")
OUTPUT = os.path.join(checkout.BUILD, "newcomer")
CHAPTERS = ("first_look", "playground_guide")
SECONDS = 120


def editor_with_the_plugin(newcomer):
    """The first start of the editor, without an import before it."""
    networking.prepare(newcomer)
    shutil.rmtree(newcomer.path(".godot"))
    os.makedirs(OUTPUT, exist_ok=True)
    settings, place = newcomer.read("project.godot"), newcomer.path(PROBE)
    shutil.copytree(os.path.join(editor.HERE, "dock_probe"), place, ignore=shutil.ignore_patterns("chapters", "*.inc"))
    shutil.copytree(os.path.join(HERE, "chapters"), os.path.join(place, "chapters"))
    os.makedirs(os.path.dirname(newcomer.path(HANDS)))
    shutil.copy(os.path.join(checkout.PROJECT, HANDS), newcomer.path(HANDS))
    assert settings.count(editor.PLUGIN) == 1, "project.godot does not enable the plugin"
    newcomer.write("project.godot", settings.replace(editor.PLUGIN, f'{editor.PLUGIN}, "res://addons/dock_probe/plugin.cfg"'))
    try:
        arguments = [f"--chapters={','.join(CHAPTERS)}", f"--pictures={OUTPUT}"]
        run = scripted_user.start(newcomer.engine, newcomer.project, arguments, SECONDS)
    finally:
        newcomer.write("project.godot", settings)
        shutil.rmtree(place)
        shutil.rmtree(newcomer.path("tests"))
    problems = scripted_user.problems_of(run)
    assert not problems, "\n   ".join(problems)


CASES = (editor_with_the_plugin,)
