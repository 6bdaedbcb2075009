"""The suite kernels of tools/bench: blends, motors and products, compared with GLM, Eigen, the engine and the memory
bandwidth."""

import json
import os
import tempfile

import bench_native
import checkout
import project
from build import LIBRARY, build

PARTS = ("build", "bench", "engine")
# The table gives the ratio of these to ga_godot at the same place.
OURS = "ga_godot"


def add_options(parser):
    """The options of this suite."""
    parser.add_argument("--repetitions", type=int, default=5, help="repetitions for each median of the C++ rows (default 5)")


def measure(options):
    """Builds, runs, prints the table; returns the rows."""
    build(LIBRARY, "bench")
    project.prepare(checkout.PROJECT)
    rows = native_rows(options.repetitions) + engine_rows()
    print_table(rows)
    return rows


def native_rows(repetitions):
    """Rows of the C++ benchmark program: medians over its repetitions."""
    runs = bench_native.median_runs("kernels_bench", repetitions, "C++ kernels against GLM and Eigen (some minutes)")
    rows = []
    for case, subject, n, run in runs:
        rows.append({"suite": "kernels", "case": case, "subject": subject, "n": n, "value": run["cpu_time"] / n,
                     "unit": "ns/pose", "where": "C++"})
        # Not known for the paper's methods, which also read multivectors elsewhere in memory.
        if "bytes_per_second" in run:
            rows[-1]["bytes_per_second"] = run["bytes_per_second"]
    return rows


def engine_rows():
    """Rows of the same blends, called from GDScript."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "engine.json")
        bench_native.run_quietly([checkout.ENGINE, "--headless", "--path", checkout.PROJECT, "--script",
                                  "res://tests/bench/kernels.gd", "--", f"--json={path}"],
                                 "MotorPool against Transform3D.interpolate_with in the engine (about a minute)")
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    for row in rows:
        row["n"] = int(row["n"])
    return rows


def print_table(rows):
    """One line for each row: the value, and the ratio to ga_godot on the same input at the same place."""
    ours = {(row["where"], row["case"], row["n"]): row["value"] for row in rows if row["subject"] == OURS}
    print(f"{'case':<24} {'where':<22} {'subject':<30} {'n':>9} {'ns/pose':>10} {'GB/s':>7} {'ga_godot takes':>16}")
    for row in sorted(rows, key=lambda row: (row["case"], row["where"], row["n"], row["value"])):
        reference = ours.get((row["where"], row["case"], row["n"]))
        ratio = ""
        if reference and row["subject"] != OURS:
            ratio = f"1/{row['value'] / reference:.1f} of it" if row["value"] > reference else f"{reference / row['value']:.1f} times it"
        moved = f"{row['bytes_per_second'] / 1e9:.1f}" if "bytes_per_second" in row else ""
        print(f"{row['case']:<24} {row['where']:<22} {row['subject']:<30} {row['n']:>9} {row['value']:>10.2f} {moved:>7} {ratio:>16}")
