"""The suite playground of tools/bench: a drag in a document of 200 objects, opening large documents, and 1,000 drawn objects."""

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
    runs = bench_native.median_runs("playground_bench", REPETITIONS,
                                    "Dragging a point that 200 objects depend on; opening documents of up to 16 MiB (n: bytes)")
    rows = [{"suite": "playground", "case": case, "subject": subject, "n": n, "value": run["cpu_time"], "unit": run["time_unit"]}
            for case, subject, n, run in runs]
    print(f"{'case':<24} {'subject':<20} {'n':>8} {'time':>10}")
    for row in rows:
        print(f"{row['case']:<24} {row['subject']:<20} {row['n']:>8} {row['value']:>10.1f} {row['unit']}")
    return rows + bench_drawing.measure()
