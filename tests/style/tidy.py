"""clang-tidy on every C++ source, with the checks of .clang-tidy."""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess

import checkout
import clang_tools
import sources
from passed_files import PassedFiles

COMMANDS = "compile_commands.json"
CONFIGURATIONS = (".clang-tidy", "bindings/.clang-tidy")
# Options of gcc that clang does not know.
GCC_ONLY = {"-fno-gnu-unique"}
# clang-tidy reports its own checks; the compiler's warnings belong to the build.
EXTRA = ["-Wno-error", "-Wno-unknown-warning-option"]
FINDING = re.compile(r"^(?P<place>.+?:\d+:\d+): (?:warning|error): (?P<text>.+)$")


def findings():
    """What clang-tidy reports, one line for each finding, without duplicates from headers."""
    tool = clang_tools.find("clang-tidy")
    settings = [clang_tools.version_of(tool), *EXTRA, *map(sources.read, CONFIGURATIONS)]
    passed = PassedFiles("clang-tidy", "\n".join(settings))
    commands = compile_commands()
    pending = [path for path in sources.find("c++") if path.endswith(".cpp") and not passed.has(path)]
    found = set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as executor:
        for path, lines in zip(pending, executor.map(lambda path: check(tool, path, commands), pending)):
            found |= set(lines)
            if not lines:
                passed.add(path, included_files(path, commands))
    return sorted(found)


def check(tool, path, commands):
    """The findings in one source and the headers it includes."""
    arguments = [word for word in command_of(path, commands)[1] if word not in GCC_ONLY]
    done = subprocess.run([tool, "--quiet", path, "--", *arguments, *EXTRA], cwd=checkout.ROOT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    lines = []
    for line in done.stdout.splitlines():
        match = FINDING.match(line)
        if match:
            place = match["place"]
            if os.path.isabs(place):
                place = os.path.relpath(place, checkout.ROOT)
            lines.append(f"{place}: {match['text'].replace(',-warnings-as-errors', '')}")
    if done.returncode != 0 and not lines:
        lines.append(f"{path}: clang-tidy failed: {(done.stderr or done.stdout).strip()}")
    return lines


def compile_commands():
    """The command of each source in compile_commands.json, by path, as a pair (compiler, arguments)."""
    commands = {}
    for entry in json.loads(sources.read(COMMANDS)):
        words = shlex.split(entry["command"])
        first = next(index for index, word in enumerate(words) if word.startswith("-"))
        arguments = [word for word in words[first:] if word not in ("-c", entry["file"])]
        output = arguments.index("-o")
        commands.setdefault(entry["file"], (words[:first], arguments[:output] + arguments[output + 2:]))
    return commands


def command_of(path, commands):
    """The command of a source. SCons does not build tests/bindings: its sources use the flags of src/godot."""
    if path in commands:
        return commands[path]
    return next(command for other, command in commands.items() if other.startswith("src/godot/"))


def included_files(path, commands):
    """The headers of this checkout that a source includes, directly or not."""
    compiler, arguments = command_of(path, commands)
    done = subprocess.run([*compiler, *arguments, "-MM", path], cwd=checkout.ROOT,
                          stdout=subprocess.PIPE, text=True, check=True)
    words = done.stdout.replace("\\\n", " ").split()[1:]
    return [os.path.relpath(os.path.join(checkout.ROOT, word), checkout.ROOT) for word in words]
