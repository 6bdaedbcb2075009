"""Reads the pose records that the multiplayer demo writes (godot_project/demos/multiplayer/measure/pose_recorder.gd)."""
import array
import struct
import sys

MAGIC = b"GAPOSES1"
ROW_FLOATS = 12


class PoseRecord:
    """All records of one process: wall clock times (s), media times (ticks, -1 if unknown) and matrix rows of the bodies."""

    def __init__(self, path, bodies=None):
        """Keeps the first `bodies` bodies of each record, or all. Raises ValueError if the file is not a pose record."""
        with open(path, "rb") as file:
            header = file.read(12)
            if len(header) < 12 or header[:8] != MAGIC:
                raise ValueError("%s is not a pose record: it does not start with %s and a count" % (path, MAGIC.decode()))
            self.body_count = struct.unpack("<I", header[8:])[0]
            kept = self.body_count if bodies is None else min(bodies, self.body_count)
            size = 16 + self.body_count * ROW_FLOATS * 4
            self.walls, self.ticks, self.rows = [], [], []
            while True:
                data = file.read(size)
                if len(data) < size:
                    break
                wall, tick = struct.unpack_from("<dd", data)
                rows = array.array("f")
                rows.frombytes(data[16:16 + kept * ROW_FLOATS * 4])
                if sys.byteorder == "big":
                    rows.byteswap()
                self.walls.append(wall)
                self.ticks.append(tick)
                self.rows.append(rows)
        self.body_count = kept

    def __len__(self):
        return len(self.walls)

    def drop_before(self, wall):
        """Removes the records before a wall clock time."""
        kept = [index for index, at in enumerate(self.walls) if at >= wall]
        for name in ("walls", "ticks", "rows"):
            setattr(self, name, [getattr(self, name)[index] for index in kept])


def lever_distance(a, b, at, lever_arm=0.25):
    """The largest distance, in meters, between two poses of the body whose rows begin at `at`.

    Measured at the body's center and at three points `lever_arm` meters along its axes.
    """
    dx, dy, dz = a[at + 3] - b[at + 3], a[at + 7] - b[at + 7], a[at + 11] - b[at + 11]
    worst = dx * dx + dy * dy + dz * dz
    for axis in range(at, at + 3):
        x = dx + lever_arm * (a[axis] - b[axis])
        y = dy + lever_arm * (a[axis + 4] - b[axis + 4])
        z = dz + lever_arm * (a[axis + 8] - b[axis + 8])
        square = x * x + y * y + z * z
        if square > worst:
            worst = square
    return worst ** 0.5


def moving_bodies(record, tick_rate=60.0, min_speed=0.001):
    """For each record, the offsets of the rows of the bodies that moved since the previous one.

    A body moves if its center or a point at the lever arm is faster than `min_speed`, in m/s.
    """
    min_distance = min_speed / tick_rate
    result = [[]]
    for before, now in zip(record.rows, record.rows[1:]):
        moving = []
        for at in range(0, len(now), ROW_FLOATS):
            if now[at + 3] != before[at + 3] or now[at:at + ROW_FLOATS] != before[at:at + ROW_FLOATS]:
                if lever_distance(now, before, at) > min_distance:
                    moving.append(at)
        result.append(moving)
    return result
