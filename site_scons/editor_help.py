"""Embeds the class reference, so that the editor's help shows it."""

import os


def embed(target, source, env):
    """SCons action: writes a C++ source that holds each XML file as a string."""
    lines = ["namespace ga_godot {", "", "extern const char *const EDITOR_HELP[] = {"]
    for node in sorted(source, key=str):
        with open(str(node), encoding="utf-8") as file:
            lines.append("\t// " + os.path.basename(str(node)))
            for line in file.read().splitlines():
                lines.append('\t"{}\\n"'.format(line.replace("\\", "\\\\").replace('"', '\\"').replace("\t", "\\t")))
            lines.append("\t,")
    lines += ["\tnullptr,", "};", "", "} // namespace ga_godot", ""]
    with open(str(target[0]), "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
