"""Records a scene of the multiplayer demo for tools/bench network: python3 tools/lib/record_trace.py SCENE FILE.csv

SCENE is cubes (250 cubes, collapsing structures) or push (901 cubes, a ball plows through a field of them). The file has
the server's poses at 60 Hz for 20 s, as lines of t,id,x,y,z,qw,qx,qy,qz.
"""

import math
import sys
import tempfile

import checkout
import project
from build import LIBRARY, build
from demo_measure import CUBES
from demo_run import DemoRun, RunFailed
from pose_record import ROW_FLOATS, PoseRecord

SECONDS = 20
SPARE_SECONDS = 120
TICK_RATE = 60.0


def main(arguments):
    """Runs the scene with one client and writes the server's poses."""
    if len(arguments) != 2 or arguments[0] not in CUBES:
        sys.exit(__doc__.strip())
    scene, path = arguments
    checkout.setup("build", "engine")
    build(LIBRARY)
    project.prepare(checkout.PROJECT)
    with tempfile.TemporaryDirectory(prefix="ga_godot_record_") as folder:
        try:
            record = run_scene(scene, folder)
        except RunFailed as failure:
            sys.exit(f"record_trace: {failure}")
    with open(path, "w", encoding="utf-8") as file:
        write_trace(record, file)
    print(f"Saved {record.body_count} bodies at {len(record)} times to {path}")


def run_scene(scene, folder):
    """Runs a scene; returns the server's PoseRecord."""
    with DemoRun([checkout.ENGINE], folder) as run:
        run.start_server("--method=motors", f"--scene={scene}", f"--cubes={CUBES[scene]}", f"--seconds={SECONDS}", "--clients=1")
        run.start_client("--record=", f"--seconds={SECONDS}")
        run.wait(SECONDS + SPARE_SECONDS)
        run.check_logs()
        return PoseRecord(run.server.record_path, CUBES[scene])


def write_trace(record, file):
    """Writes a record as lines. Consecutive quaternions of a body are in the same hemisphere."""
    file.write("t,id,x,y,z,qw,qx,qy,qz\n")
    last = [(1.0, 0.0, 0.0, 0.0)] * record.body_count
    for tick, rows in enumerate(record.rows):
        for body in range(record.body_count):
            row = rows[ROW_FLOATS * body:ROW_FLOATS * (body + 1)]
            q = quaternion((row[0:3], row[4:7], row[8:11]))
            if sum(a * b for a, b in zip(last[body], q)) < 0.0:
                q = tuple(-component for component in q)
            last[body] = q
            numbers = ",".join(f"{number:.6f}" for number in q)
            file.write(f"{tick / TICK_RATE:.6f},{body},{row[3]:.5f},{row[7]:.5f},{row[11]:.5f},{numbers}\n")


def quaternion(rows):
    """(w, x, y, z) of a rotation matrix, computed from the component of largest magnitude."""
    trace = rows[0][0] + rows[1][1] + rows[2][2]
    i = max(range(3), key=lambda axis: rows[axis][axis])
    if trace > rows[i][i]:
        four_w = 2.0 * math.sqrt(1.0 + trace)
        return (four_w / 4.0, (rows[2][1] - rows[1][2]) / four_w, (rows[0][2] - rows[2][0]) / four_w, (rows[1][0] - rows[0][1]) / four_w)
    j, k = (i + 1) % 3, (i + 2) % 3
    four = 2.0 * math.sqrt(max(0.0, 1.0 + rows[i][i] - rows[j][j] - rows[k][k]))
    q = [(rows[k][j] - rows[j][k]) / four, 0.0, 0.0, 0.0]
    q[1 + i] = four / 4.0
    q[1 + j] = (rows[j][i] + rows[i][j]) / four
    q[1 + k] = (rows[k][i] + rows[i][k]) / four
    return tuple(q)


if __name__ == "__main__":
    main(sys.argv[1:])
