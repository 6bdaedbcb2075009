"""The guide's game, exported by the command lines of the guide to exporting: a server without a display, and a client."""

import os
import re
import shlex
import shutil

import checkout
import networking
import presets
from first_import import run_lines

PAGE = "docs/guides/exporting.md"
GAME = "game.x86_64"


def exported_game(newcomer):
    networking.prepare(newcomer)
    install_templates(newcomer)
    options = {"binary_format/architecture": checkout.host()[1]}
    newcomer.write("export_presets.cfg", presets.with_options(presets.LINUX, {"Linux": options}))
    shutil.rmtree(newcomer.path(".godot"), ignore_errors=True)
    newcomer.write(".godot/extension_list.cfg", "res://addons/ga_godot/ga_godot.gdextension\n")
    folder = newcomer.path("build")
    newcomer.write("build/.gdignore", "")
    samples = [sample.text for sample in newcomer.page(PAGE) if sample.language == "sh"]
    run_lines(newcomer, "".join(text for text in samples if "--export-release" in text), PAGE)
    exported = sorted(set(os.listdir(folder)) - {".gdignore"})
    assert len(exported) == 3 and GAME in exported, f"the export has the files {exported}"
    # Away from the project.
    place = os.path.join(newcomer.place, "game")
    shutil.move(folder, place)
    commands = [shlex.split(text) for text in samples if GAME in text and "--headless --" in text and "--export" not in text]
    assert len(commands) == 1 and commands[0][-2:] == ["--", "host"], f"{PAGE} has the commands {commands} for a server"
    networking.check_motion(newcomer, commands[0][:-2], place)


def install_templates(newcomer):
    """As "Manage Export Templates" does."""
    version = re.match(r"[\d.]+\.[a-z]+\d*", newcomer.engine.run(["--version"], 60, drawing=False).text)[0]
    folder = os.path.join(newcomer.environment["XDG_DATA_HOME"], "godot", "export_templates", version)
    os.makedirs(os.path.dirname(folder), exist_ok=True)
    os.symlink(checkout.setup_path("templates"), folder)


CASES = (exported_game,)
