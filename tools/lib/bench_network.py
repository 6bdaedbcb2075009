"""The suite network of tools/bench: recorded motion over a simulated link, and the load of a server.

Replicates each trace over the same impaired link with every method: the project's sender and receiver, float32 poses at
fixed rates, and the GA-Unity paper's scheme. docs/performance/network.md defines error and cost.
"""

import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile

import checkout
from bench_network_table import print_trace, print_server
from build import build

PARTS = ("build", "bench")
TRACES = os.path.join(os.path.dirname(checkout.ROOT), "shared", "traces")
IMPAIRED_RUNS = 5
PLOT_TOLERANCES = (1, 2, 3, 5, 8, 12, 20)
PLOT_LATENCIES = (33, 50, 100, 200)
# Options of the link: name here, name of the benchmark program's option, factor between their units.
LINK = (("loss", "loss", 0.01), ("burst", "burst", 1.0), ("duplicates", "duplication", 0.01), ("delay", "delay", 0.001),
        ("jitter", "jitter", 0.001), ("bandwidth", "bytes-per-second", 1000.0))


def add_options(parser):
    """Adds the options of this suite."""
    parser.add_argument("--trace", metavar="FILE", action="append", dest="traces", default=[],
                        help="recording to replicate, lines of t,id,x,y,z,qw,qx,qy,qz; repeatable (all in "
                             "../shared/traces beside the checkout)")
    parser.add_argument("--loss", type=within(0, 100), default=0.0, metavar="PERCENT", help="loss of datagrams, each way (0)")
    parser.add_argument("--jitter", type=within(0, 60000), default=0.0, metavar="MS",
                        help="maximum of the additional, uniformly distributed delay, which reorders datagrams (0)")
    parser.add_argument("--delay", type=within(0, 60000), default=0.0, metavar="MS", help="minimum delay, each way (0)")
    parser.add_argument("--burst", type=within(0, 1000000), default=0.0, metavar="N",
                        help="mean length of a loss burst, in datagrams (0: losses are independent)")
    parser.add_argument("--duplicates", type=within(0, 100), default=0.0, metavar="PERCENT", help="duplication of datagrams (0)")
    parser.add_argument("--bandwidth", type=within(0, 1e9), default=0.0, metavar="KB/S", help="bandwidth of the link (0: unlimited)")
    parser.add_argument("--tolerance-mm", type=within(0.01, 10000), default=5.0, metavar="MM",
                        help="maximum error of ga_godot, at the center and 0.25 m from it (5)")
    parser.add_argument("--latency-ms", "--max-latency-ms", type=within(10, 10000), default=200.0, metavar="MS",
                        help="maximum latency of ga_godot (200); below 200, it is also compared at equal delay")
    parser.add_argument("--send-rate", type=within(1, 1000), metavar="HZ",
                        help="maximum rate of ga_godot's windows (two in the maximum latency, at least 20)")
    parser.add_argument("--mode", choices=("linear", "screw", "separate"), default="separate",
                        help="ga_godot's interpolation between samples (separate)")
    parser.add_argument("--seed", type=integer(0, 10 ** 15), default=1, help="seed of the link's random numbers (1)")
    parser.add_argument("--runs", type=integer(1, 1000), metavar="N",
                        help=f"runs to pool, with consecutive seeds ({IMPAIRED_RUNS} if the link is random, else 1)")
    parser.add_argument("--engine-seconds", type=integer(0, 3600), default=0, metavar="S",
                        help="also run tools/demo over ENet for this long, with MultiplayerSynchronizer for comparison (0: do not)")
    parser.add_argument("--rate-distortion", metavar="PNG",
                        help="plot bytes per second over error instead, ga_godot's for tolerances of "
                             + ", ".join(map(str, PLOT_TOLERANCES)) + " mm")
    parser.add_argument("--latency-plot", metavar="PNG",
                        help="plot bytes per second over the delay instead, ga_godot's for maximum latencies of "
                             + ", ".join(map(str, PLOT_LATENCIES)) + " ms")


def within(minimum, maximum):
    """An argparse type: a number from `minimum` to `maximum`."""
    def number(text):
        value = float(text)
        if not minimum <= value <= maximum:
            raise argparse.ArgumentTypeError(f"{text} is not in the range from {minimum} to {maximum}")
        return value
    return number


def integer(minimum, maximum):
    """An argparse type: an integer from `minimum` to `maximum`."""
    def number(text):
        value = int(text)
        if not minimum <= value <= maximum:
            raise argparse.ArgumentTypeError(f"{text} is not in the range from {minimum} to {maximum}")
        return value
    return number


def run_count(options):
    """How many runs to pool: with a random link, one run is not representative."""
    return options.runs or (IMPAIRED_RUNS if options.loss or options.jitter or options.duplicates else 1)


def measure(options):
    """Builds and runs the benchmark and prints its tables; returns the rows."""
    build("bench")
    traces = options.traces or sorted(glob.glob(os.path.join(TRACES, "*.csv")))
    if not traces:
        print("tools/bench network: no recordings found in ../shared/traces; pass one with --trace FILE", file=sys.stderr)
    if options.rate_distortion:
        series = [{"tolerance_mm": tolerance} for tolerance in PLOT_TOLERANCES]
        return measure_series(options, traces, series, "plot_rate_distortion.py", options.rate_distortion)
    if options.latency_plot:
        series = [{"latency_ms": latency} for latency in PLOT_LATENCIES]
        return measure_series(options, traces, series, "plot_latency.py", options.latency_plot)
    rows = []
    for trace in traces:
        found = run_trace(options, trace)
        print_trace(os.path.basename(trace), found, link_text(options))
        rows += found
    server = run_program(options)
    for row in server:
        row["trace"] = "lissajous"
    print_server(server, link_text(options))
    return rows + server + (measure_in_engine(options) if options.engine_seconds else [])


def measure_in_engine(options):
    """Runs the multiplayer demo, which prints its table; returns its rows, measured by ENet's counters."""
    with tempfile.TemporaryDirectory(prefix="ga_godot_bench_") as folder:
        path = os.path.join(folder, "rows.json")
        command = [os.path.join(checkout.TOOLS, "demo"), f"--seconds={options.engine_seconds}", f"--loss={options.loss:g}",
                   f"--jitter={options.jitter:g}", "--json", path]
        print(flush=True)
        if subprocess.run(command, stdin=subprocess.DEVNULL, check=False).returncode != 0:
            sys.exit("tools/bench: the demo failed; see its message above")
        with open(path, encoding="utf-8") as file:
            return json.load(file)["rows"]


def measure_series(options, traces, series, script, plot):
    """Measures every method on every trace, ours with each of the settings in `series`, and plots the results."""
    rows = []
    for trace in traces:
        baselines = run_trace(options, trace)
        rows += [row for row in baselines if row["subject"] != "ga_godot"]
        for changes in series:
            rows += run_trace(argparse.Namespace(**{**vars(options), **changes}), trace, "--baselines=no")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"rows": rows}, file)
        done = subprocess.run([checkout.setup_path("plots"), os.path.join(checkout.TOOLS, "lib", script), path, plot], check=False)
        if done.returncode != 0:
            sys.exit(1)
    print(f"Saved the plot to {plot}")
    return rows


def run_trace(options, trace, *arguments):
    """The rows of a trace. Exits with a message if the trace is invalid."""
    rows = run_program(options, f"--trace={trace}", *arguments)
    for row in rows:
        row["trace"] = os.path.basename(trace)
    return rows


def send_rate(options):
    """The maximum rate of our windows: twice the reciprocal of the latency, as a window's length is part of it."""
    return options.send_rate or max(20.0, 2000.0 / options.latency_ms)


def run_program(options, *arguments):
    """Runs the benchmark program; returns its rows, with the settings added."""
    command = [os.path.join(checkout.variant(), "bench", "network_bench"), *arguments,
               f"--tolerance={options.tolerance_mm / 1000:g}", f"--max-latency={options.latency_ms / 1000:g}",
               f"--send-rate={send_rate(options):g}", f"--mode={options.mode}", f"--seed={options.seed}",
               f"--runs={run_count(options)}"]
    command += [f"--{name}={getattr(options, option) * factor:g}" for option, name, factor in LINK]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    if done.returncode != 0:
        reason = done.stderr.strip() or f"network_bench failed with exit code {done.returncode}"
        sys.exit(f"tools/bench: {reason}")
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    settings = {"loss_percent": options.loss, "jitter_ms": options.jitter, "delay_ms": options.delay,
                "runs": run_count(options)}
    for row in rows:
        row.update(settings)
        if row["subject"] == "ga_godot":
            row.update(tolerance_mm=options.tolerance_mm, latency_ms=options.latency_ms)
    return rows


def link_text(options):
    """The impairments of the link as text."""
    parts = [(options.loss, f"{options.loss:g} % loss" + (f" in bursts of {options.burst:g}" if options.burst else "")),
             (options.jitter, f"{options.jitter:g} ms jitter"), (options.delay, f"{options.delay:g} ms delay"),
             (options.duplicates, f"{options.duplicates:g} % duplicates"), (options.bandwidth, f"{options.bandwidth:g} kB/s")]
    return ", ".join(text for value, text in parts if value) or "no loss, no delay"
