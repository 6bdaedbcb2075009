"""The libraries that the ga_godot.gdextension of a project lists."""

import os

import addon_files

EXTENSION = os.path.join("addons", "ga_godot", "ga_godot.gdextension")


def expected(project, tags):
    """Path of the one library for these feature tags, such as linux, x86_64 and debug."""
    return path_of(project, addon_files.library_for(extension_of(project), tags))


def add_placeholders(project):
    """Makes placeholders of the listed libraries that have not been built."""
    for library in addon_files.libraries(extension_of(project)).values():
        place = path_of(project, library)
        if not os.path.exists(place):
            with open(place, "w", encoding="utf-8") as file:
                file.write(f"placeholder of {library}\n")


def extension_of(project):
    """The bytes of a project's ga_godot.gdextension."""
    return addon_files.read(os.path.join(project, EXTENSION))


def path_of(project, library):
    """Path of a listed library."""
    return os.path.join(project, os.path.dirname(EXTENSION), library)
