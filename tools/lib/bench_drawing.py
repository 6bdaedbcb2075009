"""Frame time of 1,000 drawn objects, compared with the engine's primitives: a part of the suite playground."""

import json
import os
import subprocess
import sys
import tempfile

import checkout
import display

SCRIPT = "res://tests/bench/drawing.gd"
SECONDS = 300
# Where, environment variables of Mesa, sizes, frames. With GALLIUM_NOOP the driver does nothing, which leaves the
# engine's own work. Without it and without a graphics card, the CPU also processes vertices and pixels.
RUNS = (
    ("no driver work", {"GALLIUM_NOOP": "1"}, "64x36", 60),
    ("drawn", {}, "64x36,1152x648", 12),
)


def measure():
    """Runs the engine, prints the table; returns the rows."""
    rows = []
    with display.display() as screen:
        for where, settings, sizes, frames in RUNS:
            rows += [row_of(found, where) for found in run({**screen, **settings}, sizes, frames)]
    print(f"{'each frame':<24} {'subject':<18} {'where':<16} {'size':<9} {'frame ms':>9} {'render ms':>9} {'draw calls':>10}")
    for row in rows:
        print(f"{row['case']:<24} {row['subject']:<18} {row['where']:<16} {row['size']:<9} {row['value']:>9.2f} {row['render']:>9.2f} {row['draws']:>10}")
    return rows


def row_of(found, where):
    """Converts a row of the script to a row of tools/bench."""
    return {"suite": "playground", "case": found["case"], "subject": found["subject"], "n": 1000, "where": where, "size": found["size"],
            "value": found["frame"], "unit": "ms/frame", "render": found["render"], "draws": int(found["draws"])}


def run(settings, sizes, frames):
    """The rows of one run of the engine."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.json")
        command = [checkout.ENGINE, "--audio-driver", "Dummy", "--rendering-method", "gl_compatibility", "--path", checkout.PROJECT,
                   "--disable-vsync", "--resolution", "320x180", "--script", SCRIPT, "--",
                   f"--sizes={sizes}", f"--frames={frames}", f"--json={path}"]
        print(f"1,000 drawn objects at {sizes} (up to a minute) ...", file=sys.stderr, flush=True)
        done = subprocess.run(command, env={**os.environ, **settings}, timeout=SECONDS, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0 or not os.path.exists(path):
            sys.exit(f"{done.stdout}\n{SCRIPT}: failed with exit code {done.returncode}")
        with open(path, encoding="utf-8") as file:
            return json.load(file)["rows"]
