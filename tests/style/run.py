"""The style suite: formatting, naming, limits and words of all files of ours.

Usage: tests/style/run.py [--check NAME]

Each check prints `ok NAME`, or `FAIL NAME` after what it found. Ends with `[style] N passed, M failed`.
compile_commands.json must exist; tools/test --only style builds it.
"""

import argparse
import os
import re
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(HERE)), "tools", "lib"))

import checkout  # noqa: E402
import format as formatters  # noqa: E402
import limits  # noqa: E402
import sources  # noqa: E402
import tidy  # noqa: E402
import words  # noqa: E402
from passed_files import PassedFiles  # noqa: E402

GDLINT_FINDING = re.compile(r"^(.+?):(\d+): Error: (.+)$")


def cpp_is_formatted():
    """clang-format changes nothing."""
    return [f"{path}: not formatted" for path in formatters.clang_format(sources.find("c++"), check=True)]


def gdscript_is_formatted():
    """gdformat changes nothing."""
    return check_changed("gdformat", lambda paths: [f"{path}: not formatted" for path in formatters.gdformat(paths, check=True)])


def gdscript_passes_gdlint():
    """gdlint reports nothing, with the settings in .gdlintrc."""
    return check_changed("gdlint", run_gdlint)


def run_gdlint(paths):
    """What gdlint reports for these files."""
    command = [checkout.setup_path("style"), "-m", "gdtoolkit.linter", *paths]
    done = subprocess.run(command, cwd=checkout.ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    found = [f"{match[1]}:{match[2]}: {match[3]}" for match in map(GDLINT_FINDING.match, done.stdout.splitlines()) if match]
    if done.returncode != 0 and not found:
        raise formatters.FormatFailed(done.stdout.strip())
    return found


def check_changed(check, run):
    """What `run` finds in the GDScript files that have not passed `check` before."""
    passed = PassedFiles(check, checkout.setup_path("style") + sources.read(".gdlintrc"))
    pending = [path for path in sources.find("gdscript") if not passed.has(path)]
    found = run(pending) if pending else []
    failed = {line.split(":")[0] for line in found}
    for path in pending:
        if path not in failed:
            passed.add(path)
    return found


# Name of each test, what finds violations, and how to fix them.
CHECKS = (
    ("cpp_is_formatted", cpp_is_formatted, "run tools/format"),
    ("gdscript_is_formatted", gdscript_is_formatted, "run tools/format"),
    ("gdscript_passes_gdlint", gdscript_passes_gdlint, "see the rule's name in gdtoolkit's documentation; .gdlintrc has our settings"),
    ("cpp_passes_clang_tidy", tidy.findings, ".clang-tidy has the naming rules and the reasons for the checks that are off"),
    ("files_are_short", limits.long_files, "each file holds one concept"),
    ("classes_are_small", limits.crowded_classes, "each class has one responsibility"),
    ("engine_free_code_includes_no_engine", limits.engine_includes, "see docs/architecture.md for the layers"),
    ("integer_types_have_no_std", limits.std_integers, "as in Godot"),
    ("words_are_those_of_the_field", words.findings, "tests/style/words.txt has the list, docs/glossary.md explains the terms"),
)


def main():
    """Runs the checks and sums up."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", metavar="NAME", help="run only the checks whose name contains NAME")
    options = parser.parse_args()
    passed = failed = 0
    for name, find, advice in CHECKS:
        if options.check and options.check not in name:
            continue
        started = time.monotonic()
        try:
            found = find()
        except formatters.FormatFailed as error:
            found = [str(error)]
        seconds = time.monotonic() - started
        for line in found:
            print(line)
        if found:
            failed += 1
            print(f"FAIL {name} ({seconds:.1f} s): {len(found)} found; {advice}", flush=True)
        else:
            passed += 1
            print(f"ok {name} ({seconds:.1f} s)", flush=True)
    print(f"[style] {passed} passed, {failed} failed", flush=True)
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
