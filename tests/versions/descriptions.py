"""The engine's API in each version, from the descriptions that tools/setup downloads."""

import json
import os
import re

MEMBERS = ("methods", "properties", "signals", "constants", "members")
BUILD_CONFIGURATION = "float_64"


def numbers(version):
    """(4, 6) of "4.6"."""
    return tuple(map(int, version.split(".")))


def versions(folder):
    """The versions that are described, oldest first."""
    return sorted((name for name in os.listdir(folder) if re.fullmatch(r"\d+\.\d+", name)), key=numbers)


def interface_functions(folder):
    """The functions of the C interface: {name: the version in which it came}."""
    with open(os.path.join(folder, "gdextension_interface.json"), encoding="utf-8") as file:
        return {function["name"]: numbers(function["since"]) for function in json.load(file)["interface"]}


class Description:
    """One version of the API."""

    def __init__(self, description):
        self.classes = {entry["name"]: entry for entry in description["classes"]}
        self.builtins = {entry["name"]: entry for entry in description["builtin_classes"]}
        self.utility_functions = {entry["name"]: entry["hash"] for entry in description["utility_functions"]}
        self.enum_values = {value["name"]: value["value"] for enum in description["global_enums"] for value in enum["values"]}
        sizes = {entry["build_configuration"]: entry["sizes"] for entry in description["builtin_class_sizes"]}
        self.sizes = {entry["name"]: entry["size"] for entry in sizes[BUILD_CONFIGURATION]}
        self._members = {}

    @classmethod
    def load(cls, folder, version):
        """The description of a version in the folder of all."""
        with open(os.path.join(folder, version, "extension_api.json"), encoding="utf-8") as file:
            return cls(json.load(file))

    def lineage(self, name):
        """The entries of a class and its ancestors; of a built-in type, its own."""
        found = []
        while name in self.classes:
            found.append(self.classes[name])
            name = found[-1].get("inherits")
        return found or [self.builtins[name]] if name in self.builtins or found else []

    def members(self, name):
        """All names in a class and its ancestors."""
        if name not in self._members:
            self._members[name] = {member for entry in self.lineage(name) for member in names_in(entry)}
        return self._members[name]

    def names(self):
        """All names of the API."""
        found = {*self.classes, *self.builtins, *self.utility_functions, *self.enum_values}
        return found.union(*(names_in(entry) for entry in [*self.classes.values(), *self.builtins.values()]))

    def hashes(self, owner, method):
        """The hashes by which this version finds a method of a class or of a built-in type."""
        for entry in self.lineage(owner):
            for found in entry.get("methods", []):
                if found["name"] == method:
                    return {found.get("hash"), *found.get("hash_compatibility", [])}
        return set()

    def values(self, owner):
        """{name: value} of the enumerators and constants of a class."""
        entry = self.classes.get(owner, {})
        found = {value["name"]: value["value"] for enum in entry.get("enums", []) for value in enum["values"]}
        found.update((constant["name"], constant["value"]) for constant in entry.get("constants", []))
        return found

    def argument_counts(self):
        """The largest number of arguments of the methods and utility functions of each name; infinite if it varies."""
        counts = {}
        for entry in [*self.classes.values(), *self.builtins.values()]:
            for method in entry.get("methods", []):
                count = float("inf") if method["is_vararg"] else len(method.get("arguments", []))
                counts[method["name"]] = max(count, counts.get(method["name"], 0))
        return counts


def names_in(entry):
    """The names that a class declares itself."""
    found = {member["name"] for kind in MEMBERS for member in entry.get(kind, [])}
    for enum in entry.get("enums", []):
        found.add(enum["name"])
        found.update(value["name"] for value in enum["values"])
    return found
