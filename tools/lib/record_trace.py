"""Records a scene of the multiplayer demo for tools/bench network: python3 tools/lib/record_trace.py SCENE FILE.csv

SCENE is cubes (250 cubes, structures that fall) or push (901 cubes, a field that a ball ploughs through). The file has
the poses that the server simulated, 60 a second for 20 seconds: lines of t,id,x,y,z,qw,qx,qy,qz.
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
    """Runs the scene with one client and writes the server's record."""
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
    print(f"{path}: {record.body_count} bodies, {len(record)} times")


def run_scene(scene, folder):
    """The server's PoseRecord of a scene."""
    with DemoRun([checkout.ENGINE], folder) as run:
        run.start_server("--method=motors", f"--scene={scene}", f"--cubes={CUBES[scene]}", f"--seconds={SECONDS}", "--clients=1")
        run.start_client("--record=", f"--seconds={SECONDS}")
        run.wait(SECONDS + SPARE_SECONDS)
        run.check_logs()
        return PoseRecord(run.server.record_path, CUBES[scene])


def write_trace(record, file):
    """Writes a record as lines; consecutive quaternions of a body lie in the same hemisphere."""
    file.write("t,id,x,y,z,qw,qx,qy,qz\n")
    last = [(1.0, 0.0, 0.0, 0.0)] * record.body_count
    for tick, rows in enumerate(record.rows):
        for body in range(record.body_count):
            row = rows[ROW_FLOATS * body:ROW_FLOATS * (body + 1)]
            q = quaternion((row[0:3], row[4:7], row[8:11]))
            if sum(a * b for a, b in zip(last[body], q)) < 0.0:
                q = tuple(-part for part in q)
            last[body] = q
            numbers = ",".join(f"{number:.6f}" for number in q)
            file.write(f"{tick / TICK_RATE:.6f},{body},{row[3]:.5f},{row[7]:.5f},{row[11]:.5f},{numbers}\n")


def quaternion(rows):
    """(w, x, y, z) of the rows of a rotation matrix; found from the largest of the four."""
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
