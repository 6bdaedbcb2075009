"""What the built library calls in the engine, found in its objects, and what of it a version lacks."""

import glob
import json
import os
import re
import subprocess
import sys

import checkout
from descriptions import Description

sys.path.insert(0, os.path.join(checkout.ROOT, "bindings"))

import engine_api  # noqa: E402

LOADED = engine_api.INTERFACE_FUNCTIONS
# The library calls these only where the engine has them, and otherwise what stands beside them.
INTERFACE_FALLBACKS = {
    "mem_alloc2": "mem_alloc",
    "mem_free2": "mem_free",
    "classdb_register_extension_class5": "classdb_register_extension_class4",
}
METHOD_FALLBACKS = {
    ("WorkerThreadPool", "get_caller_task_id"): ("OS", "get_thread_caller_id"),
    ("WorkerThreadPool", "get_caller_group_id"): ("OS", "get_main_thread_id"),
}
CALL_BY_NAME = re.compile(r'\b(?:call|call_deferred|callv)\("(\w+)"')
OVERRIDE = re.compile(r"\b(_\w+)\([^;{]*\boverride\b")
OWN_METHOD = re.compile(r'\bD_METHOD\("(\w+)"')


class LibraryCalls:
    """The functions, methods and constants of the engine that the library uses."""

    def __init__(self):
        build = os.path.join(checkout.variant(), "bindings")
        if not glob.glob(os.path.join(build, "src", "*.os")):
            sys.exit(f"{build} has no objects: run scons")
        own = symbols(os.path.join(build, "src"))
        generated = symbols(os.path.join(build, "generated"))
        self.interface = set(re.findall(r"\bgdextension_interface::(\w+)", "\n".join(own | generated)))
        self.interface -= {"load", "library", "token"}
        named = set(re.findall(r"\bgodot::(\w+)::(\w+)", "\n".join(own)))
        description = newest_dump()
        self.built_from = Description(description)
        with open(os.path.join(checkout.ROOT, "bindings", "build_profile.json"), encoding="utf-8") as file:
            api = engine_api.Api(description, json.load(file))
        self.classes = list(api.classes)
        self.methods, self.builtin_methods, self.virtuals = [], [], []
        source = code()
        overridden = set(OVERRIDE.findall(source))
        for owner in api.classes:
            self.methods += [method for method in api.class_methods(owner, False) if (owner, method.name) in named]
            self.virtuals += [method for method in api.class_methods(owner, True) if method.engine_name in overridden]
        for owner in engine_api.HANDLES:
            self.builtin_methods += [method for method in api.builtin_methods(owner) if (owner, method.name) in named]
        self.by_name = set(CALL_BY_NAME.findall(source)) - set(OWN_METHOD.findall(source))
        self.constructors = {(name, index) for name in engine_api.HANDLES for index, _, _ in api.constructors(name)}
        self.words = set(re.findall(r"\b[A-Z][A-Z0-9_]+\b", source))
        self._api = api
        self.sizes = {name: api.sizes[name] for name in [*engine_api.HANDLES, *engine_api.HAND_WRITTEN, "Variant"]}

    def missing_interface(self, interface, version):
        """Functions of the C interface that the version lacks."""
        return sorted(name for name in self.interface if interface.get(name, (99, 0)) > version)

    def missing_methods(self, description):
        """Methods (class, name) that the version lacks, or has with another hash."""
        found = [method for method in self.methods + self.builtin_methods + self.virtuals
                 if method.hash not in description.hashes(method.owner, method.engine_name)]
        return sorted({(method.owner, method.engine_name) for method in found})

    def missing_names(self, description):
        """Classes, utility functions, and methods called by name that the version lacks."""
        found = [name for name in self.classes if name not in description.classes]
        known = description.names()
        return sorted(found + [name for name in self.by_name if name not in known])

    def changed_values(self, description):
        """Enumerators and constants that the library was compiled with and that the version lacks or has with another value."""
        found = []
        for owner in [None, *self.classes]:
            built = self.built_from.values(owner) if owner else self.built_from.enum_values
            old = description.values(owner) if owner else description.enum_values
            found += [f"{owner}.{name}" for name in built if name in self.words and old.get(name) != built[name]]
        return sorted(found)

    def changed_types(self, description):
        """Built-in types with another size, or constructors or operators that differ."""
        found = [name for name, size in self.sizes.items() if description.sizes.get(name) != size]
        for name in engine_api.HANDLES:
            known = [(entry["name"], entry.get("right_type")) for entry in description.builtins[name]["operators"]]
            found += [f"{name} {symbol} {right}" for symbol, _, right in self._api.operators(name) if (symbol, right) not in known]
            known = {entry["index"]: arguments(entry) for entry in description.builtins[name]["constructors"]}
            found += [f"{name}({arguments(entry)})" for entry in self.built_from.builtins[name]["constructors"]
                      if (name, entry["index"]) in self.constructors and known.get(entry["index"]) != arguments(entry)]
        return found


def newest_dump():
    """The description that the bindings were generated from last."""
    dumps = glob.glob(os.path.join(checkout.BUILD, "bindings", "api", "*", "extension_api.json"))
    with open(max(dumps, key=os.path.getmtime), encoding="utf-8") as file:
        return json.load(file)


def arguments(constructor):
    """The types of a constructor's arguments, as text."""
    return ", ".join(argument["type"] for argument in constructor.get("arguments", []))


def symbols(folder):
    """The demangled symbols that objects in the folder use or instantiate."""
    paths = glob.glob(os.path.join(folder, "**", "*.os"), recursive=True)
    paths = [path for path in paths if os.path.basename(path) != "interface.os" and has_source(path, folder)]
    if not paths:
        return set()
    done = subprocess.run(["nm", "-C", *paths], stdout=subprocess.PIPE, text=True, check=True)
    lines = re.findall(r"^[0-9a-f ]* ([UVWwvu]) (.*)$", done.stdout, re.M)
    return {name for _, name in lines}


def has_source(path, folder):
    """Whether the source of an object exists; a build folder may contain objects of sources that were removed."""
    source = os.path.splitext(os.path.relpath(path, folder))[0] + ".cpp"
    places = ("src", "bindings/src", "build/bindings/generated")
    return any(os.path.exists(os.path.join(checkout.ROOT, place, source)) for place in places)


def code():
    """The C++ code of src/godot, and of the bindings that is written by hand."""
    text = []
    for folder in ("src/godot", "bindings/src", "bindings/include"):
        for path in glob.glob(os.path.join(checkout.ROOT, folder, "**", "*.[ch]pp"), recursive=True):
            with open(path, encoding="utf-8") as file:
                text.append(file.read())
    return "\n".join(text)
