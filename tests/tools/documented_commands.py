"""Checks commands in the documentation without running them: programs, options, suites, cases and files must exist."""

import argparse
import contextlib
import functools
import glob
import io
import os
import re
import runpy
import shlex
import subprocess
import sys
from unittest import mock

import checkout
import fuzzing
import suites

# What a reader replaces, and a valid value in its place.
PLACEHOLDERS = {"SUITE": "cpp", "PART": "engine", "SECONDS": "60", "PATH/TO/PROJECT": ".", "PATH/TO/YOUR/PROJECT": "."}
# Programs of the system, whose options are not checked. Those that build or change something are run by the tests named here.
OTHERS = {
    "git": "",
    "./game.x86_64": "tests/newcomer",
    "xattr": "",
    "mkdir": "tests/newcomer",
    "echo": "tests/newcomer",
    "godot": "tests/newcomer",
    "aarch64-linux-gnu-g++": "tests/determinism",
    "qemu-aarch64": "tests/determinism",
}
# A file of this checkout that a command reads.
CHECKOUT_FILE = re.compile(r"^(?:src|tests|tools|docs|godot_project)/")
ASSIGNMENT = re.compile(r"^[A-Z][A-Z_]*=")
OPERATORS = ("&&", ";", "|")
BENCHMARKS = ("kernels_bench", "network_bench", "load_bench", "playground_bench")


class Parsed(Exception):
    """The options of a program are valid."""


def fault(line):
    """What is wrong with a command line; None if nothing is."""
    try:
        words = shlex.split(line, comments=True)
    except ValueError as error:
        return str(error)
    command = []
    for word in [*words, ";"]:
        if word not in OPERATORS:
            command.append(PLACEHOLDERS.get(word, word))
        elif command:
            found = _fault_of(command)
            if found:
                return found
            command = []
    return None


def missing_program(name):
    """The same about the name of a program."""
    return missing_file(name) if name.startswith(("tools/", "tests/")) else None


def _fault_of(words):
    if ">" in words:
        words = words[:words.index(">")]
    while words and ASSIGNMENT.match(words[0]):
        words = words[1:]
    if words[0] in ("python", "python3"):
        words = words[1:]
    program, arguments = words[0], words[1:]
    for word in words:
        if CHECKOUT_FILE.match(word) and missing_file(word):
            return missing_file(word)
    if program == "scons" and arguments:
        return _scons_fault(arguments)
    if program == "tools/setup":
        return _setup_fault(arguments)
    if program == "tools/godot":
        return _project_fault(arguments)
    if program.startswith("build/"):
        return _built_fault(program, arguments)
    if program.startswith(("tools/", "tests/")):
        return _python_fault(program, arguments)
    return None if program == "scons" or program in OTHERS else f"{program} is no program that a test knows"


def missing_file(word):
    """What is missing of the files that bash makes of a word with * and {a,b}; None if nothing is."""
    script = f'shopt -s failglob; for file in {word}; do [ -e "$file" ] || exit 1; done'
    done = subprocess.run(["bash", "-c", script], cwd=checkout.ROOT, stderr=subprocess.DEVNULL, check=False)
    return None if done.returncode == 0 else f"there is no {word}"


@functools.lru_cache
def scons_help():
    """The options and targets of SConstruct, as `scons -h` lists them."""
    return subprocess.run(["scons", "-Q", "-h"], cwd=checkout.ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout


def _scons_fault(arguments):
    if arguments[0] == "-C":
        return None  # the SConstruct of another folder
    options, _, targets = scons_help().partition("\nTargets:\n")
    for word in arguments:
        name, is_option, value = word.partition("=")
        if is_option and not ASSIGNMENT.match(word):
            found = re.search(rf"^{re.escape(name)}: (.*?)(?:\(([\w|]+\|\w+)\))?$", options, re.M)
            if not found:
                return f"scons has no option {name}"
            if found[2] and value not in found[2].split("|") or name == "platform" and not re.search(rf"\b{value}\b", found[1]):
                return f"scons has no {word}"
        elif not is_option and word != "-h" and not re.search(rf"^  {re.escape(name)}\b", targets, re.M):
            return f"scons has no target {word}"
    return None


def _setup_fault(arguments):
    with open(os.path.join(checkout.TOOLS, "setup"), encoding="utf-8") as file:
        usage = file.read().partition("\nset -u")[0]
    if arguments[:1] == ["--print"]:
        return None if re.search(rf"^# WHAT: .*\b{arguments[1]}\b", usage, re.M) else f"tools/setup prints no {arguments[1]}"
    for part in arguments:
        if not re.search(rf"^# (?:PART:|     ) {part} ", usage, re.M):
            return f"tools/setup has no part {part}"
    return None


def _project_fault(arguments):
    """The arguments that main.gd of the project reads."""
    if "--" not in arguments:
        return None
    with open(os.path.join(checkout.PROJECT, "main.gd"), encoding="utf-8") as file:
        script = file.read()
    for argument in arguments[arguments.index("--") + 1:]:
        key, _, value = argument.partition("=")
        if f'"{key}"' not in script:
            return f"the project has no argument {key}"
        if key == "--demo" and not os.path.isdir(os.path.join(checkout.PROJECT, "demos", value)):
            return f"there is no demo {value}"
    return None


def _built_fault(program, arguments):
    folder, name = program.split("/")[-2:]
    tests = [os.path.basename(test.argv[0]) for test in suites.unit_programs()]
    if folder == "fuzz" and name not in fuzzing.targets() or folder == "bench" and name not in BENCHMARKS or \
            folder == "tests" and name not in tests:
        return f"nothing builds {program}"
    for argument in arguments:
        if argument.startswith("-tc=") and not _has_text("tests/**/*.cpp", f'TEST_CASE("{argument[4:].rstrip("*")}'):
            return f"no test case is named {argument[4:]}"
    return None


def _python_fault(program, arguments):
    """Whether a Python program of the checkout takes these arguments: it is run up to the end of its own parsing."""
    path = os.path.join(checkout.ROOT, program)
    if os.path.dirname(program) == "tools" and program != "tools/smoke":
        path = os.path.join(checkout.TOOLS, "lib", os.path.basename(program) + ".py")
    if not os.path.isfile(path):
        return f"there is no {program}"
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if "argparse" not in text:
        unknown = [word for word in arguments if word.startswith("-") and f'"{word}"' not in text]
        return f"{program} has no option {unknown[0]}" if unknown else None
    errors = io.StringIO()
    parse = argparse.ArgumentParser.parse_args

    def parse_and_end(parser, *given):
        raise Parsed(parse(parser, *given))

    state = sys.path[:], os.getcwd()
    try:
        with mock.patch.object(sys, "argv", [path, *arguments]), contextlib.redirect_stdout(io.StringIO()), \
                mock.patch.object(argparse.ArgumentParser, "parse_args", parse_and_end), contextlib.redirect_stderr(errors):
            sys.path.insert(0, os.path.dirname(path))
            os.chdir(checkout.ROOT)
            runpy.run_path(path, run_name="__main__")
    except Parsed as parsed:
        return _case_fault(program, parsed.args[0])
    except SystemExit as ended:
        # --help
        return None if not ended.code else f"{program}: {errors.getvalue().strip().splitlines()[-1]}"
    finally:
        sys.path[:] = state[0]
        os.chdir(state[1])
    return f"{program} does not parse its arguments"


def _case_fault(program, options):
    """Cases are names in the sources of what runs them."""
    if program == "tools/bench":
        sources = {"load": "tests/bench/load/**/*.cpp", "robustness": "tools/lib/bench_robustness.py"}
        # Attacks are listed without their prefix.
        names = [(sources[options.suite], f'"{name.removeprefix("hostile_")}"') for name in options.cases]
    elif program == "tests/network/run.py" and options.case:
        names = [("tests/network/*.py", options.case)]
    else:
        return None
    for place, name in names:
        if not _has_text(place, name):
            return f"{program} has no case {name}"
    return None


def _has_text(place, text):
    for path in glob.glob(os.path.join(checkout.ROOT, place), recursive=True):
        with open(path, encoding="utf-8") as file:
            if text in file.read():
                return True
    return False
