"""tools/bench: measures time and bandwidth, compared with baselines on the same input in the same run.

tools/bench kernels   blend of pose pairs, n from 1 to 1,000,000: C++ against GLM,
                      and MotorPool against Transform3D.interpolate_with in the engine
tools/bench engine    50 to 10,000 cubes between two poses in each frame: the GA-Unity paper's two
                      methods, GLM, scripts, Tween, AnimationPlayer, MultivectorLerp, MotorPool
tools/bench network   recorded motion over a simulated link: bytes, errors and delay, compared
                      with fixed-rate poses and the GA-Unity paper's scheme; the load of a server
tools/bench load      up to 40,000 bodies or 64 receivers over long, lossy and narrow lines, simulated:
                      bytes, bursts, errors, stalls, delay, processor time, memory
tools/bench playground
                      a drag in a document of 200 objects, compared with a full evaluation;
                      opening documents of 16 MiB of every kind; 1,000 drawn objects, compared with the engine's primitives
tools/bench robustness
                      large documents, jumps of the clock, invalid settings, damaged files, callbacks that free their
                      callers, random calls, the first import: times, values accepted, crashes
tools/bench all       all suites

A row is the result of one subject. Compare only rows of the same run.
"""

import argparse
import json
import os
import platform
import sys

import bench_engine
import bench_kernels
import bench_load
import bench_network
import bench_playground
import bench_robustness
import checkout

SUITES = {"kernels": bench_kernels, "engine": bench_engine, "network": bench_network, "load": bench_load,
          "playground": bench_playground, "robustness": bench_robustness}


def machine():
    """Processor, cores and system of this run, as one line."""
    model = platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as cpuinfo:
            model = next(line.split(":", 1)[1].strip() for line in cpuinfo if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return f"{model}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}"


def parse_arguments(arguments):
    """The options of tools/bench."""
    parser = argparse.ArgumentParser(prog="tools/bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suite", choices=(*SUITES, "all"), help="what to measure")
    parser.add_argument("--json", metavar="FILE", help="also write the rows as JSON")
    for name, suite in SUITES.items():
        suite.add_options(parser.add_argument_group(f"options of the suite {name}"))
    return parser.parse_args(arguments)


def main(arguments):
    """Measures the chosen suite."""
    options = parse_arguments(arguments)
    suites = [suite for name, suite in SUITES.items() if options.suite in (name, "all")]
    checkout.setup(*sorted({part for suite in suites for part in suite.PARTS}))
    rows = []
    for suite in suites:
        rows += suite.measure(options)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"rows": rows, "machine": machine()}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1:])
