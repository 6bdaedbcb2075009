"""Outcomes of the tests that tools/bench robustness runs, and its options."""

import argparse
import unittest

import bench_load
import bench_robustness

NAME = "test_file test_method"


class OutcomesTest(unittest.TestCase):
    def test_each_end_of_a_process_has_its_outcome(self):
        rows = (("[engine] 1 passed, 0 failed\n", 0, "passed"), (f"FAIL {NAME}\n[engine] 0 passed, 1 failed\n", 1, "failed"),
                ("FAIL test_file.gd\n   does not compile\n[engine] 0 passed, 1 failed\n", 1, "failed"),
                ("FAIL test_other.gd\n   does not compile\n[engine] 1 passed, 1 failed\n", 1, "passed"),
                ("FAIL outside of any test: x\n[engine] 1 passed, 1 failed\n", 1, "failed"),
                ("", -11, "crashed"), ("[engine] 1 passed, 0 failed\n", -6, "crashed"), ("", 0, "crashed"), ("", None, "hung"),
                (f"FAIL {NAME}: blocks the main thread; the run is aborted\n", -9, "hung"))
        for output, code, expected in rows:
            with self.subTest(output=output, code=code):
                self.assertEqual(bench_robustness.outcome(NAME, output, code), expected)

    def test_cases_are_chosen_by_name(self):
        parser = argparse.ArgumentParser()
        bench_load.add_options(parser)
        bench_robustness.add_options(parser)
        self.assertTrue(bench_robustness.is_chosen("callbacks", parser.parse_args([])))
        options = parser.parse_args(["--case", "first_import"])
        self.assertEqual([bench_robustness.is_chosen(name, options) for name in ("first_import", "first_import_readme")], [True, False])


if __name__ == "__main__":
    unittest.main()
