"""The suite robustness of tools/bench: what once took too long, was accepted silently, or crashed, each case in an engine of its own.

docs/reliability.md holds the results, before and after. `--library` measures the library of another checkout.
"""

import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

import checkout
import project
from build import LIBRARY, build

PARTS = ("build", "engine")
SCRIPT = "res://tests/bench/robustness.gd"
VALUE = re.compile(r"^\[value\] (\S+)$", re.MULTILINE)
# Cases of the script, their units, and what they measure.
MEASURES = (
    ("refused_entries_20000", "ms", "GAScene.load_json (processor time): 20,000 invalid entries"),
    ("refused_entries_16_mib", "ms", "16 MiB of invalid entries"),
    ("valid_entries_70000", "ms", "70,000 valid entries, which are more than a document may have"),
    ("valid_entries_65536", "ms", "65,536 valid entries"),
    ("cycle_65536", "ms", "65,536 entries that form a cycle"),
    ("cycle_16_mib", "ms", "16 MiB of entries that refer to the next one"),
    ("attributes_1000000", "ms", "1,000,000 attributes, which are more than a document may have"),
    ("flush_after_a_day", "ms", "MotorSender.flush for 100 bodies, one day after the last"),
    ("flush_after_1e9_s", "ms", "MotorSender.flush for 100 bodies, 1e9 s after the last"),
    ("invalid_settings", "taken", "values outside the range that settings take"),
    ("codec_tolerance_1e300", "bytes", "a pose encoded by a MotorCodec whose position_tolerance was set to 1e300"),
    ("internal_methods", "methods", "methods for internal use that scripts can call"),
)
MEASURE_SECONDS = 60
# Groups of engine tests: the files whose name begins so, and what the tests do.
TESTS = (
    ("callbacks", "test_callback", "callbacks that free or change what called them"),
    ("files", "test_safe_file", "files written to a full disk, and files cut short"),
    ("reflective_calls", "test_reflective_calls", "every method, property and signal with invalid arguments"),
)
TEST_SECONDS = 100
TEST = re.compile(r"^func (test_\w+)", re.MULTILINE)
RESULT = re.compile(r"^\[engine\] \d+ passed, \d+ failed$", re.MULTILINE)
IMPORTS = (("first_import", False, "exit code of the first headless import of a new project with the addon"),
           ("first_import_readme", True, "the same, with the extension listed before, as the README says"))
IMPORT_SECONDS = 120
OUTCOMES = ("passed", "failed", "crashed", "hung")


def add_options(parser):
    """The options of this suite, which also has --case of the suite load."""
    parser.add_argument("--library", metavar="FILE", help="the library to measure (this checkout's)")


def measure(options):
    """Builds, runs, prints the table; returns the rows."""
    if options.library is None:
        build(LIBRARY)
    rows = []
    with tempfile.TemporaryDirectory(prefix="ga_godot_robustness_") as place:
        folder = os.path.join(place, "project")
        copy_project(folder, options.library)
        project.list_extensions(folder)
        run_engine(folder, ["--import"], IMPORT_SECONDS)
        for name, unit, what in MEASURES:
            if is_chosen(name, options):
                rows.append(show(row(name, measured(folder, name), unit), what))
        for name, prefix, what in TESTS:
            if is_chosen(name, options):
                counts = outcomes(folder, prefix)
                rows += [show(row(name, counts[outcome], outcome), what) for outcome in OUTCOMES]
        for name, is_listed, what in IMPORTS:
            if is_chosen(name, options):
                rows.append(show(row(name, first_import(place, folder, is_listed), "code"), what))
    return rows


def is_chosen(name, options):
    """Whether the options select a case."""
    return not options.cases or name in options.cases


def show(found, what):
    """Prints a row and returns it."""
    value = found["value"]
    text = "-" if value is None else f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
    print(f"{found['case']:<24} {text:>8} {found['unit']:<8} {what}", flush=True)
    return found


def row(name, value, unit):
    """A row of tools/bench."""
    return {"suite": "robustness", "case": name, "subject": "ga_godot", "n": 1, "value": value, "unit": unit}


def copy_project(folder, library):
    """A copy of the project, with another library if one is given."""
    shutil.copytree(checkout.PROJECT, folder, ignore=shutil.ignore_patterns(".godot"))
    os.mkdir(os.path.join(folder, ".godot"))
    if library:
        target = os.path.join(folder, "addons", "ga_godot", "bin", os.path.basename(library))
        if not os.path.exists(target):
            sys.exit(f"tools/bench: --library is {library}, but must be a file named like this checkout's library")
        shutil.copyfile(library, target)


def run_engine(folder, arguments, seconds):
    """The output of an engine and its exit code; None instead of the code if it did not end in time."""
    command = [checkout.ENGINE, "--headless", "--path", folder, *arguments]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", start_new_session=True) as process:
        try:
            output, _ = process.communicate(timeout=seconds)
            return output, process.returncode
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return process.communicate()[0], None


def measured(folder, name):
    """The value that a case of the script prints; None if it prints none within the time limit."""
    output, _ = run_engine(folder, ["--script", SCRIPT, "--", name], MEASURE_SECONDS)
    found = VALUE.search(output)
    return float(found.group(1)) if found else None


def outcomes(folder, prefix):
    """How the tests of the files with this prefix end, each in a process of its own: {outcome: number}."""
    counts = dict.fromkeys(OUTCOMES, 0)
    for path in sorted(glob.glob(os.path.join(folder, "tests", prefix + "*.gd"))):
        with open(path, encoding="utf-8") as file:
            tests = TEST.findall(file.read())
        title = os.path.splitext(os.path.basename(path))[0]
        for test in tests:
            name = f"{title} {test}"
            found = outcome(name, *run_engine(folder, ["--", f"--test={name}"], TEST_SECONDS))
            counts[found] += 1
            if found != "passed":
                print(f"  {found}: {name}", flush=True)
    return counts


def outcome(name, output, code):
    """One of OUTCOMES, from the output and the exit code of the test "FILE METHOD". Other files may not compile with the library."""
    if code is None or "blocks the main thread" in output:
        return "hung"
    if code not in (0, 1) or not RESULT.search(output):
        return "crashed"
    lines = output.splitlines()
    faults = ("FAIL " + name, f"FAIL {name.split()[0]}.gd")
    has_failed = any(line in faults or line.startswith("FAIL outside") for line in lines)
    return "failed" if has_failed else "passed"


def first_import(place, folder, is_listed):
    """The exit code of the first import of a project that holds only the addon; None if it did not end."""
    new = os.path.join(place, f"new_{is_listed}")
    shutil.copytree(os.path.join(folder, "addons"), os.path.join(new, "addons"), ignore=shutil.ignore_patterns("*.import"))
    with open(os.path.join(new, "project.godot"), "w", encoding="utf-8") as file:
        file.write("config_version=5\n")
    if is_listed:
        os.mkdir(os.path.join(new, ".godot"))
        project.list_extensions(new)
    code = run_engine(new, ["--import"], IMPORT_SECONDS)[1]
    return 128 - code if code is not None and code < 0 else code
