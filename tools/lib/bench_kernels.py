"""The suite kernels of tools/bench: blends of pose pairs beside GLM's and the engine's."""

import json
import os
import subprocess
import sys
import tempfile

import checkout
import project
from build import LIBRARY, build

PARTS = ("build", "bench", "engine")
# Of these the table gives the ratio to ga_godot at the same place.
OURS = "ga_godot"


def add_options(parser):
    """The options that only this suite takes."""
    parser.add_argument("--repetitions", type=int, default=5, help="repeats behind each median of the C++ rows (default 5)")


def measure(options):
    """Builds, runs, prints the table; returns the rows."""
    build(LIBRARY, "bench")
    project.prepare(checkout.PROJECT)
    rows = native_rows(options.repetitions) + engine_rows()
    print_table(rows)
    return rows


def run_quietly(command, what):
    """Runs a command; on failure shows what it printed and ends the program."""
    print(f"{what} ...", file=sys.stderr, flush=True)
    done = subprocess.run(command, cwd=checkout.ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{what}: failed with exit code {done.returncode}")


def native_rows(repetitions):
    """Rows of the C++ benchmark program: medians over its repetitions."""
    binary = os.path.join(checkout.variant(), "bench", "kernels_bench")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "kernels.json")
        run_quietly([binary, f"--benchmark_out={path}", "--benchmark_out_format=json",
                     f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true",
                     "--benchmark_min_time=0.05"], "C++ kernels against GLM (about a minute)")
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
    rows = []
    for run in report["benchmarks"]:
        if run.get("aggregate_name") != "median":
            continue
        case, subject, n = run["run_name"].split("/")[:3]
        rows.append({"suite": "kernels", "case": case, "subject": subject, "n": int(n),
                     "value": run["cpu_time"] / int(n), "unit": "ns/pose", "where": "C++"})
    return rows


def engine_rows():
    """Rows of the same blends called from GDScript."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "engine.json")
        run_quietly([checkout.ENGINE, "--headless", "--path", checkout.PROJECT, "--script",
                     "res://tests/bench/kernels.gd", "--", f"--json={path}"],
                    "MotorPool against Transform3D.interpolate_with in the engine (about a minute)")
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    for row in rows:
        row["n"] = int(row["n"])
    return rows


def print_table(rows):
    """One line a row: value, and the ratio to ga_godot on the same input at the same place."""
    ours = {(row["where"], row["case"], row["n"]): row["value"] for row in rows if row["subject"] == OURS}
    print(f"{'case':<20} {'where':<22} {'subject':<30} {'n':>9} {'ns/pose':>10} {'ga_godot takes':>16}")
    for row in sorted(rows, key=lambda row: (row["case"], row["where"], row["n"], row["value"])):
        reference = ours.get((row["where"], row["case"], row["n"]))
        ratio = ""
        if reference and row["subject"] != OURS:
            ratio = f"1/{row['value'] / reference:.1f} of it" if row["value"] > reference else f"{reference / row['value']:.1f} times it"
        print(f"{row['case']:<20} {row['where']:<22} {row['subject']:<30} {row['n']:>9} {row['value']:>10.2f} {ratio:>16}")
