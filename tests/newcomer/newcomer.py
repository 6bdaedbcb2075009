"""The newcomer's project: empty, with the files of the archive, and with the plugin enabled."""

import os

import addon_files
import checkout
import code_samples
import engine_run

ADDON = os.path.join("addons", "ga_godot")
PLUGIN = "res://addons/ga_godot/plugin.cfg"
# What the project manager of Godot 4.6 writes, with the compatibility renderer.
PROJECT = """config_version=5

[application]

config/name="Newcomer"
config/features=PackedStringArray("4.6", "GL Compatibility")

[rendering]

renderer/rendering_method="gl_compatibility"
renderer/rendering_method.mobile="gl_compatibility"
"""
SECONDS = 120


class Newcomer:
    """A folder with the project, and the engine with settings of its own."""

    def __init__(self, place, environment):
        self.place = place
        self.project = os.path.join(place, "project")
        self.port = None
        variables = {**environment, "XDG_DATA_HOME": os.path.join(place, "data"), "XDG_CONFIG_HOME": os.path.join(place, "config")}
        self.environment = {**os.environ, **variables}
        self.engine = engine_run.Engine(checkout.ENGINE, variables)
        os.makedirs(self.project)
        self.write("project.godot", PROJECT)
        unpack(os.path.join(self.project, ADDON))

    def path(self, name):
        """Path of a file of the project."""
        return os.path.join(self.project, name)

    def write(self, name, text):
        """Writes a file of the project."""
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        """The text of a file of the project."""
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def set(self, section, key, value):
        """A setting in project.godot, in a new section, as the project settings write it."""
        self.write("project.godot", self.read("project.godot") + f"\n[{section}]\n\n{key}={value}\n")

    def page(self, name):
        """The samples of a page of the addon."""
        return code_samples.samples_of(name, self.read(os.path.join(ADDON, name)))

    def run(self, *arguments, drawing=False, seconds=SECONDS):
        """Runs the engine in the project; returns its output. It must end with 0 and report no problem."""
        done = self.engine.run(["--path", self.project, *arguments], seconds, drawing)
        problems = done.problems()
        assert done.code == 0 and not problems, f"{' '.join(arguments)} ended with {done.code}; {problems}\n{done.text[-3000:]}"
        return done.text


def unpack(folder):
    """Writes the files of the archive, with the library of this machine alone."""
    library = addon_files.library_for(addon_files.read(addon_files.EXTENSION), [*checkout.host(), "debug"])
    addon_files.write(folder, [os.path.join(addon_files.FOLDER, library)])
