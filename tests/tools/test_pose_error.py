"""The error metric of the multi-process tests and the demo."""

import json
import os
import unittest

import checkout
from pose_error import percentile

# Rows of C++ initializers that the C++ test of the same function includes.
TABLE = os.path.join(checkout.ROOT, "tests", "bench", "network", "tests", "percentiles.inc")


class PercentileTest(unittest.TestCase):
    def test_interpolates_linearly_as_in_cpp(self):
        with open(TABLE, encoding="utf-8") as file:
            rows = json.loads("[" + file.read().replace("{", "[").replace("}", "]") + "]")
        self.assertEqual(len(rows), 11)
        for share, expected, values in rows:
            self.assertAlmostEqual(percentile(values, share), expected, places=12)

    def test_infinities_and_no_values(self):
        infinity = float("inf")
        infinite = [infinity, 1.0, infinity]
        self.assertEqual([percentile(infinite, share) for share in (0.0, 0.25, 0.75)], [1.0, infinity, infinity])
        self.assertIsNone(percentile([], 0.5))


if __name__ == "__main__":
    unittest.main()
