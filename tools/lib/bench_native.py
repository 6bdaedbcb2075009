"""Runs the C++ benchmark programs, which use Google Benchmark."""

import json
import os
import subprocess
import sys
import tempfile

import checkout


def run_quietly(command, what):
    """Runs a command; on failure exits with its output."""
    print(f"{what} ...", file=sys.stderr, flush=True)
    done = subprocess.run(command, cwd=checkout.ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{what}: failed with exit code {done.returncode}")


def medians(program, repetitions, what):
    """Case, subject, n and median CPU time in the benchmark's own unit, of each CASE/SUBJECT/N in build/VARIANT/bench/PROGRAM."""
    return [(case, subject, n, run["cpu_time"]) for case, subject, n, run in median_runs(program, repetitions, what)]


def median_runs(program, repetitions, what):
    """Case, subject, n and Google Benchmark's whole record of the median of each CASE/SUBJECT/N in build/VARIANT/bench/PROGRAM."""
    binary = os.path.join(checkout.variant(), "bench", program)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "report.json")
        run_quietly([binary, f"--benchmark_out={path}", "--benchmark_out_format=json",
                     f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true",
                     "--benchmark_min_time=0.05"], what)
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
    found = []
    for run in report["benchmarks"]:
        # A single repetition has no median row.
        if run.get("aggregate_name") == "median" or repetitions == 1:
            case, subject, n = run["run_name"].split("/")[:3]
            found.append((case, subject, int(n), run))
    return found
