"""What cases of the network suite check about a run."""

import os
import time

from pose_error import compare_by_tick
from pose_record import PoseRecord, ROW_FLOATS, lever_distance, moving_bodies

# Bounds in metres. The sender keeps interpolation within 5 mm and quantises to 1 mm and 0.2 degrees.
MOVING_P99 = 0.010
MOVING_MOST = 0.060
AT_REST = 0.004


def expect(condition, words):
    if not condition:
        raise AssertionError(words)


def wait_until(condition, seconds, words):
    end = time.monotonic() + seconds
    while not condition():
        expect(time.monotonic() < end, f"{words} within {seconds} s")
        time.sleep(0.05)


def server_record(run, cubes):
    record = PoseRecord(run.server.record_path, cubes)
    return record, moving_bodies(record), run.server.report()


def expect_errors_within(run, client, cubes, p99=MOVING_P99, most=MOVING_MOST):
    """What the client showed of moving cubes is within the bounds at every tick; returns how many samples that were."""
    server, moving, told = server_record(run, cubes)
    summary = compare_by_tick(server, moving, PoseRecord(client.record_path, cubes), told["first_tick"], told["last_tick"])
    figures = summary.figures()
    expect(figures["p99"] is not None, f"{client.name} showed no moving cube")
    expect(figures["p99"] <= p99 * 1000, f"{client.name}: p99 of the error is {figures['p99']:.1f} mm")
    expect(figures["max"] <= most * 1000, f"{client.name}: the largest error is {figures['max']:.1f} mm")
    return figures["samples"]


def expect_same_end(run, client, cubes):
    """At the last tick the client shows every cube where the server has it."""
    server, _, told = server_record(run, cubes)
    shown = PoseRecord(client.record_path, cubes)
    index = shown.index_of_ticks().get(told["last_tick"])
    expect(index is not None, f"{client.name} never showed the last tick: {client.last_words()}")
    truth = server.rows[server.index_of_ticks()[told["last_tick"]]]
    expect(len(shown.rows[index]) == cubes * ROW_FLOATS, f"{client.name} does not show {cubes} cubes")
    worst = max(lever_distance(truth, shown.rows[index], at) for at in range(0, cubes * ROW_FLOATS, ROW_FLOATS))
    expect(worst <= AT_REST, f"{client.name}: at the end a cube is {worst * 1000:.1f} mm off")


def resident_bytes(process):
    """Memory of a process that is in use, or None where the system does not tell."""
    try:
        with open(f"/proc/{process.pid}/statm", encoding="utf-8") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return None


def processor_seconds(process):
    """Processor time that a process has used so far, or None where the system does not tell."""
    try:
        with open(f"/proc/{process.pid}/stat", encoding="utf-8") as file:
            fields = file.read().rsplit(")", 1)[1].split()
    except OSError:
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
