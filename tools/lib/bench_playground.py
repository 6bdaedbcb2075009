"""The suite playground of tools/bench: what a drag costs in a document of 200 objects."""

import bench_native
from build import build

PARTS = ("build", "bench")
REPETITIONS = 9


def add_options(_parser):
    """It has none of its own."""


def measure(_options):
    """Builds, runs, prints the table; returns the rows."""
    build("bench")
    medians = bench_native.medians("playground_bench", REPETITIONS, "A drag of what 200 objects depend on, in a chain of 50")
    rows = [{"suite": "playground", "case": case, "subject": subject, "n": n, "value": value, "unit": "us"}
            for case, subject, n, value in medians]
    print(f"{'case':<24} {'subject':<18} {'n':>5} {'us':>10}")
    for row in rows:
        print(f"{row['case']:<24} {row['subject']:<18} {row['n']:>5} {row['value']:>10.1f}")
    return rows
