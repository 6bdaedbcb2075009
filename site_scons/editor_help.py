"""Embeds the class reference, so that the editor's help shows it, with the version of the library."""

import os

import addon_files


def embed(target, source, env):
    """SCons action: writes a C++ source that holds each XML file as a string."""
    lines = ["namespace ga_godot {", "", "extern const char *const EDITOR_HELP[] = {"]
    for node in sorted(source, key=str):
        if not str(node).endswith(".xml"):
            continue
        with open(str(node), encoding="utf-8") as file:
            lines.append("\t// " + os.path.basename(str(node)))
            for line in with_version(file.read()).splitlines():
                lines.append('\t"{}\\n"'.format(line.replace("\\", "\\\\").replace('"', '\\"').replace("\t", "\\t")))
            lines.append("\t,")
    lines += ["\tnullptr,", "};", "", "} // namespace ga_godot", ""]
    with open(str(target[0]), "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def with_version(xml):
    """The reference of a class with the version of the addon that it belongs to, which the engine ignores."""
    return xml.replace("<class ", '<class version="{}" '.format(addon_files.version()), 1)
