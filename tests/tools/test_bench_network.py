"""Tables and options of tools/bench network."""

import argparse
import contextlib
import io
import unittest

import bench_network
import bench_network_table


def method(bytes_per_second, p99):
    """The figures of one method."""
    return {"bytes_per_second_per_body": bytes_per_second, "error_p99": p99}


class ComparisonTest(unittest.TestCase):
    def said(self, ours, **baselines):
        methods = {"ga_godot": ours, **{f"pqs_float32_{rate}": values for rate, values in baselines.items()}}
        return bench_network_table.comparison(methods, "pqs_float32_", "the cheapest baseline")

    def test_cheapest_that_is_no_worse(self):
        baselines = {"5hz": method(200, 5.1), "10hz": method(400, 5.0), "20hz": method(800, 2.0)}
        self.assertEqual(self.said(method(40, 5.0), **baselines),
                         "ga_godot: 1/10.0 of the cheapest baseline whose p99 error is not larger (pqs_float32_10hz)")

    def test_none_is_as_good(self):
        self.assertEqual(self.said(method(40, 1.0), **{"30hz": method(1200, 3.0), "60hz": method(2400, 2.0)}),
                         "ga_godot: 1/60.0 of pqs_float32_60hz, whose p99 is the best of pqs_float32_* but worse than that of ga_godot")

    def test_only_baselines_with_no_more_delay(self):
        methods = {"ga_godot": {**method(40, 5.0), "playback_delay_median": 50},
                   "pqs_float32_10hz": {**method(400, 5.0), "playback_delay_median": 100},
                   "pqs_float32_20hz": {**method(800, 2.0), "playback_delay_median": 50}}
        self.assertEqual(list(bench_network_table.no_slower(methods)), ["ga_godot", "pqs_float32_20hz"])

    def test_nothing_shown(self):
        self.assertEqual(self.said(method(40, None), **{"5hz": method(200, 1.0)}), "ga_godot showed no moving body")
        self.assertEqual(self.said(method(40, 1.0), **{"5hz": method(200, None)}),
                         "ga_godot: the cheapest baseline showed no moving body")


class OptionsTest(unittest.TestCase):
    def parse(self, *arguments):
        parser = argparse.ArgumentParser()
        bench_network.add_options(parser)
        return parser.parse_args(arguments)

    def test_defaults_are_a_good_link(self):
        self.assertEqual(bench_network.link_text(self.parse()), "no loss, no delay")

    def test_impairments_in_words(self):
        options = self.parse("--loss", "5", "--burst=3", "--jitter=30", "--bandwidth=12.5")
        self.assertEqual(bench_network.link_text(options), "5 % loss in bursts of 3, 30 ms jitter, 12.5 kB/s")

    def test_windows_are_half_as_long_as_the_latency(self):
        self.assertEqual([bench_network.send_rate(self.parse(*arguments)) for arguments in
                          ([], ["--latency-ms=50"], ["--max-latency-ms=50", "--send-rate=30"])], [20, 40, 30])

    def test_several_runs_where_chance_decides(self):
        self.assertEqual(bench_network.run_count(self.parse("--delay=50")), 1)
        self.assertEqual(bench_network.run_count(self.parse("--loss=1")), bench_network.IMPAIRED_RUNS)
        self.assertEqual(bench_network.run_count(self.parse("--loss=1", "--runs=2")), 2)

    def test_traces_repeat(self):
        self.assertEqual(self.parse("--trace", "a.csv", "--trace", "b.csv").traces, ["a.csv", "b.csv"])

    def test_out_of_range(self):
        for argument in ("--loss=101", "--loss=nan", "--jitter=-1", "--tolerance-mm=0", "--mode=cubic", "--runs=0", "--seed=x"):
            with self.assertRaises(SystemExit) as caught, contextlib.redirect_stderr(io.StringIO()):
                self.parse(argument)
            self.assertEqual(caught.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
