"""tools/bench: timings beside named rivals on the same input, in one run.

tools/bench kernels   blend of pose pairs, n from 1 to 1,000,000: C++ against GLM,
                      and MotorPool against Transform3D.interpolate_with in the engine
tools/bench all       every suite there is

A row says what one subject took; only ratios between rows of one run mean something.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile

import checkout

SUITES = ("kernels",)
# Of these the table gives the ratio to ga_godot at the same place.
OURS = "ga_godot"


def machine():
    """Processor, cores and system of this run, as one line."""
    model = platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as cpuinfo:
            model = next(line.split(":", 1)[1].strip() for line in cpuinfo if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return f"{model}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}"


def run_quietly(command, what):
    """Runs a command; on failure shows what it printed and ends the program."""
    print(f"{what} ...", file=sys.stderr, flush=True)
    done = subprocess.run(command, cwd=checkout.ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{what}: failed with exit code {done.returncode}")


def kernel_rows_native(binary, repetitions):
    """Rows of the C++ benchmark program: medians over its repetitions."""
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


def kernel_rows_engine(engine):
    """Rows of the same blends called from GDScript."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "engine.json")
        run_quietly(engine + ["--headless", "--path", checkout.PROJECT, "--script",
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


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="tools/bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suite", choices=SUITES + ("all",), help="what to measure")
    parser.add_argument("--json", metavar="FILE", help="also write the rows as JSON")
    parser.add_argument("--repetitions", type=int, default=5, help="repeats behind each median of the C++ rows (default 5)")
    parser.add_argument("--engine", default=checkout.ENGINE, help=argparse.SUPPRESS)
    parser.add_argument("--binary", default=os.path.join(checkout.variant(), "bench", "kernels_bench"), help=argparse.SUPPRESS)
    return parser.parse_args(arguments)


def main(arguments):
    options = parse_arguments(arguments)
    rows = kernel_rows_native(options.binary, options.repetitions) + kernel_rows_engine([options.engine])
    print_table(rows)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"rows": rows, "machine": machine()}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1:])
