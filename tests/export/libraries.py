"""The libraries that ga_godot.gdextension lists for each system."""

import os
import re

EXTENSION = os.path.join("addons", "ga_godot", "ga_godot.gdextension")
LIBRARY = re.compile(r'^([a-z0-9_.]+) = "(.+)"$', re.M)


def listed(project):
    """Paths relative to the addon by their feature tags, such as linux.debug.x86_64."""
    with open(os.path.join(project, EXTENSION), encoding="utf-8") as file:
        section = re.search(r"^\[libraries\]\n(.*?)(?=^\[|\Z)", file.read(), re.M | re.S)[1]
    return dict(LIBRARY.findall(section))


def path_of(project, library):
    """Path of a listed library."""
    return os.path.join(project, os.path.dirname(EXTENSION), library)


def expected(project, tags):
    """Path of the one library for these feature tags."""
    found = {library for key, library in listed(project).items() if set(key.split(".")) <= set(tags)}
    if len(found) != 1:
        raise AssertionError(f"ga_godot.gdextension lists {sorted(found)} for {sorted(tags)}, but must list one library")
    return path_of(project, found.pop())


def add_placeholders(project):
    """Makes placeholders of the listed libraries that have not been built."""
    for library in listed(project).values():
        place = path_of(project, library)
        if not os.path.exists(place):
            with open(place, "w", encoding="utf-8") as file:
                file.write(f"placeholder of {library}\n")
