"""What cases of the network suite check about a run."""

import os
import time

from pose_error import compare_by_tick, percentile
from pose_record import PoseRecord, ROW_FLOATS, lever_distance, moving_bodies

# Bounds in metres, where the tolerance is 5 mm.
MOVING_P99 = 0.006
MOVING_MOST = 0.03
AT_REST = 0.006


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


def errors_of(run, client, cubes, after=0):
    """The errors of what the client showed, without its first `after` seconds: it has to find its delay."""
    server, moving, _ = server_record(run, cubes)
    shown = PoseRecord(client.record_path, cubes)
    shown.drop_until(shown.walls[0] + after if len(shown) else 0)
    return compare_by_tick(server, moving, shown)


def expect_errors_within(run, client, cubes, p99=MOVING_P99, most=MOVING_MOST, after=0):
    """What the client showed of moving cubes is within the bounds; returns how many samples that were."""
    figures = errors_of(run, client, cubes, after).figures()
    expect(figures["p99"] is not None, f"{client.name} showed no moving cube")
    expect(figures["p99"] <= p99 * 1000, f"{client.name}: p99 of the error is {figures['p99']:.1f} mm")
    expect(figures["max"] <= most * 1000, f"{client.name}: the largest error is {figures['max']:.1f} mm")
    return figures["samples"]


def expect_mostly_within(run, client, cubes, share, bound=MOVING_P99, after=0):
    """That share of what the client showed of moving cubes is within the bound."""
    error = percentile(errors_of(run, client, cubes, after).moving, share)
    expect(error is not None and error <= bound, f"{client.name}: {share:.0%} of the errors reach {(error or 0) * 1000:.1f} mm")


def expect_same_end(run, client, cubes):
    """At the end the client shows every cube where the server has it."""
    server = PoseRecord(run.server.record_path, cubes)
    shown = PoseRecord(client.record_path, cubes)
    expect(len(shown) > 0 and shown.ticks[-1] >= server.ticks[-1] >= 0,
           f"{client.name} never showed the last tick: {client.last_words()}")
    worst = max(lever_distance(server.rows[-1], shown.rows[-1], at) for at in range(0, cubes * ROW_FLOATS, ROW_FLOATS))
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
