"""The source files of this checkout, by language; generated, imported and third-party files are left out."""

import os

import checkout

SKIPPED_FOLDERS = {"__pycache__", "rust_peers"}
SUFFIXES = {
    "c++": (".cpp", ".hpp", ".inl"),
    "gdscript": (".gd",),
    "python": (".py",),
    "shell": (".sh",),
    "markdown": (".md",),
    "xml": (".xml",),
}
FOLDERS = ("src", "tests", "bindings", "godot_project", "tools", "site_scons", "docs")
# Files without a suffix, by their first line.
INTERPRETERS = {"#!/bin/sh": "shell", "#!/usr/bin/env bash": "shell", "#!/usr/bin/env python3": "python"}


def find(*languages):
    """Paths relative to the checkout of all files in these languages, sorted."""
    return sorted(path for path in _all_files() if language_of(path) in languages)


def language_of(path):
    """The language of a file, a key of SUFFIXES; None for any other file."""
    name = os.path.basename(path)
    if name == "SConstruct":
        return "python"
    for language, suffixes in SUFFIXES.items():
        if name.endswith(suffixes):
            return language
    if "." in name:
        return None
    try:
        with open(os.path.join(checkout.ROOT, path), encoding="utf-8") as file:
            return INTERPRETERS.get(file.readline().strip())
    except (OSError, UnicodeDecodeError):
        return None


def read(path):
    """The text of a file of this checkout."""
    with open(os.path.join(checkout.ROOT, path), encoding="utf-8") as file:
        return file.read()


def _all_files():
    for name in os.listdir(checkout.ROOT):
        if os.path.isfile(os.path.join(checkout.ROOT, name)):
            yield name
    for top in FOLDERS:
        for folder, folders, names in os.walk(os.path.join(checkout.ROOT, top)):
            folders[:] = [name for name in folders if name not in SKIPPED_FOLDERS and not name.startswith(".")]
            for name in names:
                yield os.path.relpath(os.path.join(folder, name), checkout.ROOT)
