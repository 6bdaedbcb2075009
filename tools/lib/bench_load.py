"""The suite load of tools/bench: thousands of bodies and many receivers over lines of many kinds, in virtual time.

docs/reliability.md holds the results and describes the lines. Errors are those of docs/performance/network.md.
"""

import json
import os
import subprocess
import sys

import checkout
from bench_network import integer, within
from build import build

PARTS = ("build", "bench")
# Name here and of the benchmark program's option, type, unit, meaning.
NUMBERS = (("bodies", integer(1, 65536), "N", "bodies of the scene"),
           ("moving", within(0, 100), "PERCENT", "share of the bodies that moves (100)"),
           ("receivers", integer(1, 1000), "N", "receivers of the first group"),
           ("rtt", within(0, 60000), "MS", "round trip without queues"),
           ("ack-loss", within(0, 100), "PERCENT", "random loss on the way back to the sender"),
           ("rate", within(0, 1e6), "KB/S", "rate of the bottleneck to each receiver (0: unlimited)"),
           ("queue-ms", within(0, 60000), "MS", "length of the bottleneck's queue (200)"),
           ("police", integer(0, 1), "0|1", "1: the bottleneck has no queue, it drops what exceeds its rate"),
           ("seconds", within(1, 1e6), "S", "simulated seconds"),
           ("warm-up", within(0, 1e6), "S", "simulated seconds before the measured ones (5)"),
           ("cpu-limit", within(0.1, 1e6), "S", "processor time after which a case ends early (120)"))
# Options of the suite network that apply here too, if they differ from their defaults.
SHARED = {"loss": 0.0, "jitter": 0.0, "burst": 0.0, "tolerance-mm": 5.0, "latency-ms": 200.0, "send-rate": None, "seed": 1}
# Heading, case of the rows, factor, format.
COLUMNS = (("kB/s", "bytes_per_second", 1e-3, "{:.1f}"), ("x clean", "clean_ratio", 1, "{:.2f}"),
           ("burst kB", "burst_max", 1e-3, "{:.1f}"), ("p99.9", "burst_p999", 1e-3, "{:.1f}"),
           ("join kB", "early_tick_max", 1e-3, "{:.1f}"), ("p50 mm", "error_p50", 1, "{:.2f}"),
           ("p99 mm", "error_p99", 1, "{:.2f}"), ("max mm", "error_max", 1, "{:.1f}"),
           ("frozen %", "frozen_share", 100, "{:.1f}"), ("stall ms", "longest_stall", 1, "{:.0f}"),
           ("delay ms", "playback_delay_median", 1, "{:.0f}"), ("snaps", "snapshots", 1, "{:.0f}"),
           ("repeats", "retransmissions", 1, "{:.0f}"), ("drops", "dropped", 1, "{:.0f}"),
           ("send us", "sender_tick", 1e-3, "{:.0f}"), ("core %", "sender_core_share", 100, "{:.2f}"),
           ("recv us", "receiver_frame", 1e-3, "{:.0f}"), ("core %", "receiver_core_share", 100, "{:.2f}"),
           ("send MB", "sender_memory", 1e-6, "{:.1f}"), ("kB/min", "sender_memory_growth", 1e-3, "{:.0f}"),
           ("recv MB", "receiver_memory", 1e-6, "{:.1f}"), ("kB/min", "receiver_memory_growth", 1e-3, "{:.0f}"))
# The same for the cases with a hostile peer, before and during its attack, and for requests without acknowledgement.
ATTACK_COLUMNS = (("packets", "hostile_packets", 1, "{:.0f}"), ("MB in", "hostile_bytes", 1e-6, "{:.2f}"),
                  ("frame us", "server_frame_before", 1e-3, "{:.0f}"), ("attacked", "server_frame_during", 1e-3, "{:.0f}"),
                  ("ratio", "server_frame_ratio", 1, "{:.2f}"), ("max us", "server_frame_max_during", 1e-3, "{:.0f}"),
                  ("us/packet", "hostile_packet_cost", 1e-3, "{:.2f}"), ("MB", "server_memory_before", 1e-6, "{:.1f}"),
                  ("attacked", "server_memory_during", 1e-6, "{:.1f}"), ("p99 mm", "honest_error_p99_before", 1, "{:.2f}"),
                  ("attacked", "honest_error_p99_during", 1, "{:.2f}"), ("delay ms", "honest_delay_median_during", 1, "{:.0f}"),
                  ("stall ms", "honest_longest_stall_during", 1, "{:.0f}"),
                  ("kB/s", "honest_bytes_per_second_before", 1e-3, "{:.1f}"),
                  ("attacked", "honest_bytes_per_second_during", 1e-3, "{:.1f}"),
                  ("out kB/s", "hostile_bytes_per_second_during", 1e-3, "{:.1f}"))
AMPLIFICATION_COLUMNS = (("B in", "bytes_in", 1, "{:.0f}"), ("B out", "bytes_out", 1, "{:.0f}"), ("out/in", "amplification", 1, "{:.1f}"))
# The last row of a subject, and the columns of its table.
TABLES = {"sender_rejected": COLUMNS, "server_frame_ratio": ATTACK_COLUMNS, "amplification": AMPLIFICATION_COLUMNS}
NAME_WIDTH = 28


def add_options(parser):
    """Adds the options of this suite."""
    parser.add_argument("--case", metavar="NAME", action="append", dest="cases", default=[],
                        help="case to run; repeatable (all; with options of the line or the scene, what they describe)")
    parser.add_argument("--quick", action="store_true", help="short runs, for a first look")
    for name, kind, unit, meaning in NUMBERS:
        parser.add_argument("--" + name, type=kind, metavar=unit, help=meaning)


def measure(options):
    """Builds and runs the benchmark and prints its table; returns the rows."""
    build("bench")
    command = [os.path.join(checkout.variant(), "bench", "load_bench")] + [f"--case={name}" for name in options.cases]
    command += ["--quick"] if options.quick else []
    command += [f"--{name}={value:g}" for name, value in changes(options).items()]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
        rows = print_tables(program.stdout)
    if program.returncode != 0:
        sys.exit(f"tools/bench: load_bench failed with exit code {program.returncode}")
    return rows


def changes(options):
    """What the command line changes in the cases: {option: number}."""
    values = {name: getattr(options, name.replace("-", "_")) for name in [name for name, *_ in NUMBERS] + list(SHARED)}
    return {name: value for name, value in values.items() if value != SHARED.get(name)}


def print_tables(lines):
    """Prints a line of a table when all rows of a subject have arrived; returns the rows."""
    rows = []
    values = {}
    table = None
    for line in lines:
        row = json.loads(line)
        rows.append(row)
        values[row["case"]] = row["value"]
        columns = TABLES.get(row["case"])
        if columns:
            if columns is not table:
                print(f"\n{'':<{NAME_WIDTH}}" + "".join(f"{heading:>10}" for heading, *_ in columns))
            table = columns
            name = row["subject"] + ("*" if values.get("is_cut") else "")
            print(f"{name:<{NAME_WIDTH}}" + "".join(f"{number(values[case], factor, form):>10}" for _, case, factor, form in columns),
                  flush=True)
            values = {}
    if any(row["case"] == "is_cut" and row["value"] for row in rows):
        print("* ended early, at the limit of processor time or memory")
    return rows


def number(value, factor, form):
    """A formatted value; a dash for None."""
    return "-" if value is None else form.format(value * factor)
