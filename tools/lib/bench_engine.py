"""The suite engine of tools/bench: the GA-Unity paper's benchmark. In one run of the engine, the methods of the paper,
the engine and this project take turns in moving cubes between two poses."""

import json
import os
import subprocess
import sys
import tempfile

import checkout
import display
import project
from build import LIBRARY, build

PARTS = ("build", "engine", "display", "graphics")
SCRIPT = "res://tests/bench/engine/engine.gd"
SHARING = "res://tests/bench/engine/sharing.gd"
BASELINES = os.path.join("bench", "ga_godot_bench.gdextension")
SECONDS = 900
SIZES = (50, 100, 150, 200, 250, 1000, 10000)
MEASURES = ("work", "work_p95", "frame", "frame_p95", "cost")
# With GALLIUM_NOOP the driver does nothing. Without a graphics card, the CPU would draw.
DRAWN = {"GALLIUM_NOOP": "1"}
DRAWN_SIZES = (250, 1000)
# Where, n, subject, baseline, measure, and the goal: at most 1/N of the baseline.
GOALS = (
    ("headless", 250, "motor_pool_multimesh", "paper_pooled", "cost", 15),
    ("headless", 250, "motor_pool_nodes", "paper_pooled", "cost", 15),
    ("headless", 1000, "motor_pool_nodes", "transform3d_interpolate_with", "work", 4),
    ("headless", 10000, "motor_pool_multimesh", "transform3d_interpolate_with", "work", 50),
)


def add_options(parser):
    """The options of this suite."""
    parser.add_argument("--rounds", type=int, default=9, help="rounds of each method at each size (default 9)")


def measure(options):
    """Builds, runs, prints the table; returns the rows."""
    build(LIBRARY, "bench_engine")
    project.prepare(checkout.PROJECT)
    found = run("headless", ["--headless"], {}, SIZES, options.rounds)
    with display.display() as screen:
        drawing = ["--audio-driver", "Dummy", "--rendering-method", "gl_compatibility", "--disable-vsync", "--resolution", "320x180"]
        found += run("drawn", drawing, {**screen, **DRAWN}, DRAWN_SIZES, options.rounds)
    print_table(found)
    sharing = run_script(["--headless"], {}, SHARING, [], "MotorPool with one thread and with all")
    print_sharing(sharing)
    return sharing + [row_of(row, name) for row in found for name in MEASURES]


def row_of(found, name):
    """A row of tools/bench: one measure in a row of the script."""
    return {"suite": "engine", "case": name, "subject": found["subject"], "n": found["n"], "where": found["where"],
            "value": found[name], "unit": "us/frame"}


def run(where, arguments, settings, sizes, rounds):
    """The rows of one run of all methods."""
    baselines = os.path.abspath(os.path.join(checkout.variant(), BASELINES))
    options = [f"--baselines={baselines}", f"--sizes={','.join(map(str, sizes))}", f"--rounds={rounds}"]
    rows = run_script(arguments, settings, SCRIPT, options, f"{', '.join(map(str, sizes))} cubes, {where}")
    for row in rows:
        row["where"] = where
    return rows


def run_script(arguments, settings, script, options, what):
    """The rows that a script prints in one run of the engine."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.json")
        command = [checkout.ENGINE, *arguments, "--path", checkout.PROJECT, "--script", script, "--", *options, f"--json={path}"]
        print(f"{what} (up to a minute) ...", file=sys.stderr, flush=True)
        done = subprocess.run(command, env={**os.environ, **settings}, timeout=SECONDS, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0 or not os.path.exists(path):
            sys.exit(f"{done.stdout}\n{script}: failed with exit code {done.returncode}")
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    for row in rows:
        row["n"] = int(row["n"])
    return rows


def print_sharing(rows):
    """One line for each case and size: one thread, all threads, and the speedup."""
    print(f"\n{'case':<20} {'n':>9} {'one thread':>11} {'shared':>9} {'speedup':>7}   (ns/body)")
    for shared, alone in zip(rows[::2], rows[1::2]):
        print(f"{shared['case']:<20} {shared['n']:>9} {alone['value']:>11.2f} {shared['value']:>9.2f} {alone['value'] / shared['value']:>7.2f}")


def print_table(rows):
    """One line for each subject and size, in microseconds per frame, and the ratios that have a goal."""
    print(f"{'where':<9} {'n':>6} {'subject':<30}" + "".join(f" {name:>10}" for name in MEASURES) + "   (us/frame)")
    for row in rows:
        print(f"{row['where']:<9} {row['n']:>6} {row['subject']:<30}" + "".join(f" {row[name]:>10.0f}" for name in MEASURES))
    print()
    values = {(row["where"], row["n"], row["subject"]): row for row in rows}
    for where, size, ours, theirs, name, least in GOALS:
        part, whole = values[where, size, ours][name], values[where, size, theirs][name]
        ratio = f"1/{whole / part:.1f}" if part > 0 else "too small to measure"
        print(f"{where}, {size}: the {name} of {ours} is {ratio} of {theirs}'s (goal 1/{least})")
