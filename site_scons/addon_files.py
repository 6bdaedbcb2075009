"""The files that users get: those of the addon, and the license, changelog and pages that it contains for reading offline."""

import configparser
import os
import posixpath
import re

# Paths in this file are relative to it.
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = "godot_project/addons/ga_godot"
EXTENSION = FOLDER + "/ga_godot.gdextension"
PLUGIN = "plugin.cfg"
# Files of the repository's root that are in the addon too.
ROOT_FILES = ("LICENSE", "CHANGELOG.md", "SECURITY.md")
PAGES = "docs"
# Pages for those who have the sources.
SOURCE_PAGES = ("docs/asset_library.md", "docs/demos.md")
EXECUTABLE = (".so", ".dylib", ".dll")
# Written by the editor beside the files that it imports or saves.
EDITOR_FILES = (".import", ".tmp", "~")
# A link or picture in Markdown. The text of a link can contain a picture.
LINK = re.compile(r"(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^)\s]+)\)")
EXTERNAL = re.compile(r"^[a-z]+:")
# The editor shows the originals of these pictures: the examples of the playground.
LEFT_OUT = re.compile(r"^docs/images/gallery/(?!all\.png)")


def version():
    """The version in plugin.cfg."""
    return settings(read(PLUGIN))["plugin"]["version"].strip('"')


def libraries(extension):
    """The paths in the bytes of a ga_godot.gdextension, relative to it, by feature tags such as linux.debug.x86_64."""
    return {tags: path.strip('"') for tags, path in settings(extension)["libraries"].items()}


def library_for(extension, tags):
    """The path in ga_godot.gdextension of the one library for a system with these feature tags."""
    found = {path for key, path in libraries(extension).items() if set(key.split(".")) <= set(tags)}
    if len(found) != 1:
        raise ValueError("ga_godot.gdextension lists {} for {}, but must list one library".format(sorted(found), sorted(tags)))
    return found.pop()


def listed_libraries():
    """The paths in ga_godot.gdextension, relative to it, of the libraries of all systems; sorted."""
    return sorted(set(libraries(read(EXTENSION)).values()))


def settings(data):
    """The sections of a file of Godot's settings."""
    config = configparser.ConfigParser(interpolation=None)
    config.optionxform = str
    config.read_string(data.decode("utf-8"))
    return config


def contents(built=None):
    """The bytes of every file of the installed addon, by its path relative to addons/ga_godot; sorted.

    `built` are the paths of the libraries; by default, those that were built into the checkout's addon.
    """
    moved = {FOLDER + "/" + path: path for path in paths_below(FOLDER) if not path.startswith("bin/")}
    if built is None:
        built = [path for path in (FOLDER + "/" + path for path in listed_libraries()) if os.path.isfile(os.path.join(ROOT, path))]
    moved.update({path: "bin/" + os.path.basename(path) for path in built})
    moved.update({path: path for path in ROOT_FILES})
    pages = [PAGES + "/" + path for path in paths_below(PAGES) if path.endswith(".md")]
    moved.update({path: path for path in pages if path not in SOURCE_PAGES})
    # The editor imports nothing from docs/.
    found = {"docs/.gdignore": b""}
    for source, path in sorted(moved.items()):
        found[path] = read(source)
        if path.endswith(".md"):
            text, pictures = offline_page(found[path].decode("utf-8"), source, moved)
            found[path] = text.encode("utf-8")
            found.update({picture: read(picture) for picture in pictures})
    return dict(sorted(found.items()))


def write(folder, built=None):
    """Writes the files of the installed addon into a folder; `built` as in contents()."""
    for name, data in contents(built).items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(data)
        os.chmod(path, mode_of(name))


def mode_of(name):
    """Permissions of an installed file."""
    return 0o755 if name.endswith(EXECUTABLE) else 0o644


def paths_below(top):
    """Paths of the files in a folder, relative to it, without those of the editor."""
    found, top = [], os.path.join(ROOT, top)
    for folder, _, names in os.walk(top):
        below = os.path.relpath(folder, top).replace(os.sep, "/")
        found += [posixpath.normpath(below + "/" + name) for name in names if not name.endswith(EDITOR_FILES)]
    return found


def offline_page(text, source, moved):
    """A page as it is in the addon, and the pictures that it shows.

    `source` is its path in the repository; `moved` maps paths in the repository to those in the addon. A link to what the addon
    does not contain becomes its text.
    """
    pictures = set()

    def replace(match):
        mark, label, target = match.groups()
        if not mark:
            label = LINK.sub(replace, label)
        path, separator, fragment = target.partition("#")
        if EXTERNAL.match(target) or not path:
            return "{}[{}]({})".format(mark, label, target)
        linked = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
        if linked.startswith("docs/images/") and not LEFT_OUT.match(linked):
            pictures.add(linked)
            place = linked
        elif linked in moved:
            place = moved[linked]
        else:
            return "" if mark else label
        start = posixpath.dirname(moved[source]) or "."
        return "{}[{}]({})".format(mark, label, posixpath.relpath(place, start) + separator + fragment)

    return LINK.sub(replace, text), pictures


def read(path):
    """The bytes of a file."""
    with open(os.path.join(ROOT, path), "rb") as file:
        return file.read()
