"""The projects that are exported: a copy of the demos, and a small game with the addon."""

import os
import shutil

import addon_files
import checkout
import libraries
import presets
import project
import stand_ins

PRESETS = "export_presets.cfg"
PROBE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "export_probe.gd")
# System, architecture and feature tags by the names of the demos' presets.
SYSTEMS = {
    "Linux": ("linux", "x86_64"),
    "Linux arm64": ("linux", "arm64"),
    "Windows": ("windows", "x86_64"),
    "Windows arm64": ("windows", "arm64"),
    "macOS": ("macos", "universal"),
}
# Without the script that starts a debug game in a console.
NO_WRAPPER = {"debug/export_console_wrapper": 0}
SERVER = "Dedicated server"
GAME = """config_version=5

[application]

config/name="Game"
run/main_scene="res://addons/ga_godot/examples/replication.tscn"

[editor_plugins]

enabled=PackedStringArray("res://addons/ga_godot/plugin.cfg")
"""


def host_arch():
    """The architecture of this machine, by Godot's name."""
    return checkout.host()[1]


def host_preset():
    """The name of the preset for this machine."""
    return next(name for name, system in SYSTEMS.items() if system == ("linux", host_arch()))


def make_demos(folder, templates):
    """Copies the project of the demos, with templates in the presets, placeholders of libraries, and a probe."""
    copy = os.path.join(folder, "demos")
    shutil.copytree(checkout.PROJECT, copy, ignore=shutil.ignore_patterns(".godot"))
    for kind in ("debug", "release"):
        library = libraries.expected(copy, ("linux", host_arch(), kind))
        if not os.path.exists(library):
            raise AssertionError(f"{os.path.basename(library)} is missing: run scons")
    libraries.add_placeholders(copy)
    shutil.copyfile(PROBE, os.path.join(copy, os.path.basename(PROBE)))
    edit(copy, "project.godot", lambda text: f'{text}\n[autoload]\n\nExportProbe="*res://{os.path.basename(PROBE)}"\n')
    own = native_templates(templates)
    options = {name: own if name == host_preset() else stand_in_templates(folder, copy, *system)
               for name, system in SYSTEMS.items()}
    options[SERVER] = {**own, "binary_format/architecture": host_arch()}
    edit(copy, PRESETS, lambda text: presets.with_options(text, options))
    prepare(copy)
    return copy


def make_game(folder, templates):
    """Makes a project that contains only the addon, with all files that users get."""
    game = os.path.join(folder, "game")
    addon_files.write(os.path.join(game, "addons", "ga_godot"))
    options = {**native_templates(templates), "binary_format/architecture": host_arch()}
    stand_ins.write(os.path.join(game, "project.godot"), GAME.encode())
    stand_ins.write(os.path.join(game, PRESETS), presets.with_options(presets.LINUX, {"Linux": options}).encode())
    prepare(game)
    return game


def prepare(folder):
    """Imports the files of a new project."""
    os.makedirs(os.path.join(folder, ".godot"))
    project.list_extensions(folder)
    project.import_files(folder)


def native_templates(templates):
    """The options for the templates of this machine."""
    return {**{f"custom_template/{kind}": os.path.join(templates, f"linux_{kind}.{host_arch()}") for kind in ("debug", "release")},
            **NO_WRAPPER}


def stand_in_templates(folder, copy, system, arch):
    """The options for stand-ins of another system's templates."""
    path = os.path.join(folder, "templates", f"{system}_{arch}")
    options = {"custom_template/debug": path, "custom_template/release": path, **NO_WRAPPER}
    if system == "macos":
        with open(libraries.expected(copy, ("macos", "universal", "release")), "rb") as file:
            library = file.read()
        os.makedirs(os.path.dirname(path), exist_ok=True)
        stand_ins.write_macos(path, library)
        # Without Mach-O files there is nothing to sign.
        return options if stand_ins.is_macho(library) else {**options, "codesign/codesign": 0}
    if system == "windows":
        stand_ins.write_windows(path, arch)
        # A stand-in has no resources, which contain the icon and the version.
        return {**options, "application/modify_resources": False}
    stand_ins.write_linux(path, arch)
    return options


def edit(folder, name, change):
    """Replaces the text of a file by that which `change` makes of it."""
    path = os.path.join(folder, name)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    with open(path, "w", encoding="utf-8") as file:
        file.write(change(text))
