"""The libraries that ga_godot.gdextension lists for each system."""

import os
import re

EXTENSION = os.path.join("addons", "ga_godot", "ga_godot.gdextension")
LIBRARY = re.compile(r'^([a-z0-9_.]+) = "(.+)"$', re.M)
# What the addon lists when it has libraries for all systems; added to the copy while it lists fewer.
ALL_SYSTEMS = {f"{system}.{kind}{arch and '.' + arch}": f"bin/libga_godot.{system}.{arch or 'universal'}.{suffix}"
               for system, archs, suffix in (("linux", ("x86_64", "arm64"), "so"), ("windows", ("x86_64", "arm64"), "dll"),
                                             ("macos", ("",), "dylib"))
               for kind in ("debug", "release") for arch in archs}


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


def complete(project):
    """Lists the systems that the project's addon does not list, and makes placeholders of missing libraries."""
    present = listed(project)
    systems = {key.split(".")[0] for key in present}
    added = {key: library for key, library in ALL_SYSTEMS.items() if key.split(".")[0] not in systems}
    path = os.path.join(project, EXTENSION)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    lines = "".join(f'{key} = "{library}"\n' for key, library in added.items())
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("[libraries]\n\n", "[libraries]\n\n" + lines))
    for library in {**present, **added}.values():
        place = path_of(project, library)
        if not os.path.exists(place):
            with open(place, "w", encoding="utf-8") as file:
                file.write(f"placeholder of {library}\n")
