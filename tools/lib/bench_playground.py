"""The suite playground of tools/bench: a drag in a document of 200 objects, and 1,000 drawn objects."""

import bench_drawing
import bench_native
import checkout
import project
from build import LIBRARY, build

PARTS = ("build", "bench", "engine", "display", "graphics")
REPETITIONS = 9


def add_options(_parser):
    """This suite has no options."""


def measure(_options):
    """Builds, runs, prints the table; returns the rows."""
    build(LIBRARY, "bench")
    project.prepare(checkout.PROJECT)
    medians = bench_native.medians("playground_bench", REPETITIONS, "Dragging a point that 200 objects depend on, in a chain of 50")
    rows = [{"suite": "playground", "case": case, "subject": subject, "n": n, "value": value, "unit": "us"}
            for case, subject, n, value in medians]
    print(f"{'case':<24} {'subject':<18} {'n':>5} {'us':>10}")
    for row in rows:
        print(f"{row['case']:<24} {row['subject']:<18} {row['n']:>5} {row['value']:>10.1f}")
    return rows + bench_drawing.measure()
