"""Godot's export_presets.cfg: a preset for Linux, and changes of options."""

import re

# What "Add..." in the export window writes, as far as it matters.
LINUX = """[preset.0]

name="Linux"
platform="Linux"
runnable=true
export_filter="all_resources"
include_filter=""
exclude_filter=""
export_path=""
script_export_mode=2

[preset.0.options]
"""
NAME = re.compile(r'^name="(.*)"$', re.M)


def with_options(text, changes):
    """The text of the presets with the options in `changes`: a dictionary by name of the preset.

    Values are strings, numbers or truth values. Raises KeyError if there is no such preset.
    """
    sections = re.split(r"(?=^\[preset\.\d+)", text, flags=re.M)
    names = {}
    for section in sections:
        header = re.match(r"\[preset\.(\d+)\]", section)
        if header:
            names[NAME.search(section)[1]] = header[1]
    for name, options in changes.items():
        at = next(at for at, section in enumerate(sections) if section.startswith(f"[preset.{names[name]}.options]"))
        for key, value in options.items():
            sections[at] = with_option(sections[at], key, value)
    return "".join(sections)


def with_option(section, key, value):
    line = f"{key}={literal(value)}"
    pattern = re.compile(rf"^{re.escape(key)}=.*$", re.M)
    if pattern.search(section):
        return pattern.sub(lambda _: line, section)
    return f"{section.rstrip()}\n{line}\n\n"


def literal(value):
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)
