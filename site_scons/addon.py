"""The targets install and package: copy the addon into a project, or pack it into a zip."""

import configparser
import os
import shutil
import zipfile

import requirements
from SCons.Script import Action

FOLDER = "godot_project/addons/ga_godot"


def files():
    """Every file of the addon, relative to its folder; without the files that the editor writes beside them."""
    found = []
    for folder, _, names in os.walk(FOLDER):
        for name in names:
            if not name.endswith((".import", ".tmp", "~")):
                found.append(os.path.relpath(os.path.join(folder, name), FOLDER))
    return sorted(found)


def install_destination(project):
    """DIR/addons/ga_godot of project=DIR; fails before the build if DIR is not a Godot project."""
    if not project:
        requirements.fail("project=DIR is missing: run scons install project=DIR, where DIR contains a project.godot")
    if not os.path.isfile(os.path.join(project, "project.godot")):
        requirements.fail("{} is not a Godot project: it contains no project.godot".format(project))
    destination = os.path.join(project, "addons", "ga_godot")
    if os.path.realpath(destination) == os.path.realpath(FOLDER):
        requirements.fail("{} is this checkout's own project, which contains the addon already".format(project))
    return destination


def install(env, built, destination):
    """Node of `scons install project=DIR`: replaces the addon at destination."""

    def copy(target, source, env):
        shutil.rmtree(destination, ignore_errors=True)
        for name in files():
            path = os.path.join(destination, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            shutil.copy2(os.path.join(FOLDER, name), path)
        print("scons: installed into {}".format(destination))

    node = env.Command("install_into_project", built, Action(copy, None))
    env.AlwaysBuild(node)
    return node


def package(env, built):
    """Node of `scons package`: dist/ga_godot-VERSION.zip with addons/ga_godot in it."""
    config = configparser.ConfigParser()
    config.read("plugin.cfg")
    version = config["plugin"]["version"].strip('"')

    def pack(target, source, env):
        with zipfile.ZipFile(str(target[0]), "w", zipfile.ZIP_DEFLATED) as archive:
            for name in files():
                archive.write(os.path.join(FOLDER, name), "addons/ga_godot/" + name)
            archive.write("LICENSE", "addons/ga_godot/LICENSE")

    node = env.Command("dist/ga_godot-{}.zip".format(version), built, Action(pack, "Packing $TARGET"))
    env.AlwaysBuild(node)
    return node
