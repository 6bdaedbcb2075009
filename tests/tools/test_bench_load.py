"""Tables and options of tools/bench load."""

import argparse
import contextlib
import io
import json
import unittest

import bench_load
import bench_network


def rows(subject, **values):
    """The rows of one subject, as the benchmark program prints them."""
    return [json.dumps({"case": case, "subject": subject, "value": value}) for case, value in values.items()]


class TablesTest(unittest.TestCase):
    def printed(self, *lines):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            self.assertEqual(bench_load.print_tables(lines), [json.loads(line) for line in lines])
        return out.getvalue().split("\n")

    def test_a_line_for_each_subject_in_the_table_of_its_last_row(self):
        printed = self.printed(*rows("one", bytes_in=4, bytes_out=40, amplification=10.0),
                               *rows("two", bytes_in=8, bytes_out=8, amplification=None))
        self.assertEqual([line.split() for line in printed],
                         [[], ["B", "in", "B", "out", "out/in"], ["one", "4", "40", "10.0"], ["two", "8", "8", "-"], []])

    def test_a_run_that_was_cut_is_marked(self):
        printed = self.printed(*rows("one", is_cut=1, bytes_in=4, bytes_out=40, amplification=10.0))
        self.assertEqual(printed[2].split()[0], "one*")
        self.assertEqual(printed[-2], "* ended early, at the limit of processor time or memory")

    def test_every_table_ends_with_its_row(self):
        for last, columns in bench_load.TABLES.items():
            self.assertTrue(last in ("sender_rejected", *[case for _, case, *_ in columns]), last)


class OptionsTest(unittest.TestCase):
    def changes(self, *arguments):
        parser = argparse.ArgumentParser()
        bench_network.add_options(parser)
        bench_load.add_options(parser)
        return bench_load.changes(parser.parse_args(arguments))

    def test_nothing_changes_by_default(self):
        self.assertEqual(self.changes(), {})

    def test_changes_of_the_line_and_the_scene(self):
        self.assertEqual(self.changes("--bodies=500", "--rtt", "100", "--loss=5", "--rate", "30", "--latency-ms=100"),
                         {"bodies": 500, "rtt": 100, "rate": 30, "loss": 5, "latency-ms": 100})


if __name__ == "__main__":
    unittest.main()
