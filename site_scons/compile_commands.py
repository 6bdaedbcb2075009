"""compile_commands.json for editors and clang tools."""

import json
import os


def write(path, objects):
    """Writes the commands that make the objects; leaves an equal file alone."""
    folder = os.getcwd()
    entries = []
    for node in objects:
        source = node.sources[0]
        env = node.get_build_env()
        command = env.subst("$SHCXXCOM", target=[node], source=[source], executor=node.get_executor())
        entries.append({"directory": folder, "file": source.srcnode().path, "output": node.path, "command": command})
    text = json.dumps(entries, indent=2) + "\n"
    try:
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    except OSError:
        pass
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
