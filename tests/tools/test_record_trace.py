"""Conversion of the demo's pose records to traces for the network benchmark."""

import io
import math
import random
import unittest

from record_trace import quaternion, write_trace


def rows_of(w, x, y, z):
    """The rows of a unit quaternion's matrix."""
    return ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))


class Record:
    """One body that rotates about y."""

    body_count = 1
    ticks = (0, 1, 2)

    def __init__(self):
        self.rows = []
        for angle in (0.0, 3.0, 6.0):
            x, y, z = rows_of(math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0)
            self.rows.append([*x, 1.5, *y, 0.25, *z, -2.0])


class RecordTraceTest(unittest.TestCase):
    def test_quaternions_of_matrices(self):
        chance = random.Random(7)
        cases = [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0.5, 0.5, 0.5, 0.5), (1e-9, 0.6, 0.0, 0.8)]
        cases += [tuple(chance.gauss(0, 1) for _ in range(4)) for _ in range(200)]
        for case in cases:
            norm = math.sqrt(sum(part * part for part in case))
            q = [part / norm for part in case]
            found = quaternion(rows_of(*q))
            self.assertAlmostEqual(abs(sum(a * b for a, b in zip(q, found))), 1.0, places=12)

    def test_lines(self):
        file = io.StringIO()
        write_trace(Record(), file)
        lines = file.getvalue().splitlines()
        self.assertEqual(lines[0], "t,id,x,y,z,qw,qx,qy,qz")
        self.assertEqual(lines[1], "0.000000,0,1.50000,0.25000,-2.00000,1.000000,0.000000,0.000000,0.000000")
        self.assertEqual(lines[2].split(",")[0], "0.016667")
        # Beyond half a turn the quaternion stays in its hemisphere.
        self.assertEqual([line.split(",")[7] for line in lines[1:]], ["0.000000", "0.997495", "0.141120"])


if __name__ == "__main__":
    unittest.main()
