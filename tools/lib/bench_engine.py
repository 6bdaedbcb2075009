"""The suite engine of tools/bench: the GA-Unity paper's benchmark. Cubes go between two poses, by the paper's methods, the
engine's, and the project's, one after the other in one run of the engine."""

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
RIVALS = os.path.join("bench", "ga_godot_bench.gdextension")
SECONDS = 900
SIZES = (50, 100, 150, 200, 250, 1000, 10000)
MEASURES = ("work", "work_p95", "frame", "frame_p95", "cost")
# With a display and without a graphics card, drawing would be the processor's work too; Mesa can leave that out.
DRAWN = {"GALLIUM_NOOP": "1"}
DRAWN_SIZES = (250, 1000)
# Where, n, what, of what, measure, and how small a part it should be.
GOALS = (
    ("headless", 250, "motor_pool_multimesh", "paper_pooled", "cost", 15),
    ("headless", 250, "motor_pool_nodes", "paper_pooled", "cost", 15),
    ("headless", 1000, "motor_pool_nodes", "transform3d_interpolate_with", "work", 4),
    ("headless", 10000, "motor_pool_multimesh", "transform3d_interpolate_with", "work", 50),
)


def add_options(parser):
    """The options that only this suite takes."""
    parser.add_argument("--rounds", type=int, default=9, help="turns of each arm at each size (default 9)")


def measure(options):
    """Builds, runs, prints the table; returns the rows."""
    build(LIBRARY, "bench_engine")
    project.prepare(checkout.PROJECT)
    found = run("headless", ["--headless"], {}, SIZES, options.rounds)
    with display.display() as screen:
        drawing = ["--audio-driver", "Dummy", "--rendering-method", "gl_compatibility", "--disable-vsync", "--resolution", "320x180"]
        found += run("drawn", drawing, {**screen, **DRAWN}, DRAWN_SIZES, options.rounds)
    print_table(found)
    return [row_of(row, name) for row in found for name in MEASURES]


def row_of(found, name):
    """A row of tools/bench: one measure of one of the script's rows."""
    return {"suite": "engine", "case": name, "subject": found["subject"], "n": found["n"], "where": found["where"],
            "value": found[name], "unit": "us/frame"}


def run(where, arguments, settings, sizes, rounds):
    """The rows of one run of the engine."""
    rivals = os.path.abspath(os.path.join(checkout.variant(), RIVALS))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.json")
        command = [checkout.ENGINE, *arguments, "--path", checkout.PROJECT, "--script", SCRIPT, "--", f"--rivals={rivals}",
                   f"--sizes={','.join(map(str, sizes))}", f"--rounds={rounds}", f"--json={path}"]
        print(f"{', '.join(map(str, sizes))} cubes, {where} (up to a minute) ...", file=sys.stderr, flush=True)
        done = subprocess.run(command, env={**os.environ, **settings}, timeout=SECONDS, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0 or not os.path.exists(path):
            sys.exit(f"{done.stdout}\n{SCRIPT}: failed with exit code {done.returncode}")
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    for row in rows:
        row.update(where=where, n=int(row["n"]))
    return rows


def print_table(rows):
    """One line a subject and size, in microseconds, and how the ratios that count came out."""
    print(f"{'where':<9} {'n':>6} {'subject':<30}" + "".join(f" {name:>10}" for name in MEASURES) + "   (us a frame)")
    for row in rows:
        print(f"{row['where']:<9} {row['n']:>6} {row['subject']:<30}" + "".join(f" {row[name]:>10.0f}" for name in MEASURES))
    print()
    values = {(row["where"], row["n"], row["subject"]): row for row in rows}
    for where, size, ours, theirs, name, least in GOALS:
        part, whole = values[where, size, ours][name], values[where, size, theirs][name]
        ratio = f"1/{whole / part:.1f}" if part > 0 else "nothing that can be measured"
        print(f"{where}, {size}: the {name} of {ours} is {ratio} of {theirs}'s (goal 1/{least})")
