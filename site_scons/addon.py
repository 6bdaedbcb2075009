"""The targets install and package: copy the addon into a project, or pack it into a zip."""

import hashlib
import os
import shutil
import zipfile

import addon_files
import requirements
from SCons.Script import Action

FOLDER = addon_files.FOLDER
# Of every file in the archive, so that equal files give an equal archive.
ARCHIVE_TIME = (1980, 1, 1, 0, 0, 0)


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
        addon_files.write(destination)
        print("scons: installed into {}".format(destination))

    node = env.Command("install_into_project", built, Action(copy, None))
    env.AlwaysBuild(node)
    return node


def package(env, plugin, libraries, system):
    """Nodes of `scons package`: dist/ga_godot-VERSION.zip with addons/ga_godot in it, and its checksum for sha256sum -c.

    `system` names the folder below dist/ of an archive for one system; empty for that of all.
    """
    paths = [str(node) for library in libraries for node in library]

    def pack(target, source, env):
        path = str(target[0])
        with zipfile.ZipFile(path, "w") as archive:
            for name, data in addon_files.contents(paths).items():
                entry = zipfile.ZipInfo("addons/ga_godot/" + name, ARCHIVE_TIME)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = (0o100000 | addon_files.mode_of(name)) << 16
                archive.writestr(entry, data, compresslevel=9)
        with open(str(target[1]), "w", encoding="utf-8") as file:
            file.write("{}  {}\n".format(hashlib.sha256(addon_files.read(path)).hexdigest(), os.path.basename(path)))

    path = os.path.join("dist", system, "ga_godot-{}.zip".format(addon_files.version()))
    nodes = env.Command([path, path + ".sha256"], [plugin, libraries], Action(pack, "Packing $TARGET"))
    env.AlwaysBuild(nodes)
    return nodes
