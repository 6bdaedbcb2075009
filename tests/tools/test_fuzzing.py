"""The record of fuzz runs."""

import contextlib
import io
import os
import tempfile
import unittest
from unittest import mock

import fuzzing


class RunRecordTest(unittest.TestCase):
    def test_executions_are_summed_over_runs(self):
        runs = (("#2\tINITED cov: 3\n", "#512\tNEW    cov: 4\n", "Done 700 runs in 2 second(s)\n"), ("#64\tpulse\n", "ERROR: AddressSanitizer\n"), ())
        with tempfile.TemporaryDirectory() as place, mock.patch.object(fuzzing, "RUNS", os.path.join(place, "runs.tsv")):
            self.assertEqual(fuzzing.recorded(), {})
            for lines in runs:
                record = fuzzing.RunRecord("packet")
                for line in lines:
                    record.feed(line)
                record.end()
            self.assertEqual(fuzzing.recorded(), {"packet": [764, 0, 1]})
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                fuzzing.print_recorded()
            self.assertEqual(out.getvalue().splitlines()[2].split(), ["packet", "764", "0.00", "1"])


if __name__ == "__main__":
    unittest.main()
