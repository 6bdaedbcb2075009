"""Assertions of the network suite."""

import os
import time

from pose_error import compare_by_tick, percentile
from pose_record import PoseRecord, ROW_FLOATS, lever_distance, moving_bodies

# Bounds in meters for a tolerance of 5 mm. MOVING_SHARE of the errors must be within MOVING_BOUND: a loaded machine may
# deliver some frames late.
MOVING_BOUND = 0.006
MOVING_SHARE = 0.96
# On an unimpaired network.
MOVING_P99 = 0.010
MAX_MOVING = 0.3
AT_REST = 0.006


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def wait_until(condition, seconds, message):
    end = time.monotonic() + seconds
    while not condition():
        expect(time.monotonic() < end, f"{message} within {seconds} s")
        time.sleep(0.05)


def server_record(run, cubes):
    record = PoseRecord(run.server.record_path, cubes)
    return record, moving_bodies(record), run.server.report()


def expect_errors_within(run, client, cubes, share=MOVING_SHARE, bound=MOVING_BOUND, maximum=MAX_MOVING, after=0):
    """Of the client's errors at moving cubes, `share` is within `bound`, and all within `maximum`, in meters.

    Ignores the client's first `after` seconds, in which its playback delay adapts. Returns the number of samples.
    """
    server, moving, _ = server_record(run, cubes)
    shown = PoseRecord(client.record_path, cubes)
    shown.drop_before(shown.walls[0] + after if len(shown) else 0)
    errors = compare_by_tick(server, moving, shown).moving
    expect(errors, f"{client.name} showed no moving cube")
    error = percentile(errors, share)
    expect(error <= bound, f"{client.name}: {1 - share:.0%} of the errors exceed {error * 1000:.1f} mm")
    expect(max(errors) <= maximum, f"{client.name}: the largest error is {max(errors) * 1000:.1f} mm")
    return len(errors)


def expect_good_network_errors(run, client, cubes):
    """Bounds for an unimpaired network. Returns the number of samples."""
    expect_errors_within(run, client, cubes, share=0.99, bound=MOVING_P99)
    return expect_errors_within(run, client, cubes)


def expect_same_end(run, client, cubes):
    """At the end the client shows every cube where the server has it."""
    server = PoseRecord(run.server.record_path, cubes)
    shown = PoseRecord(client.record_path, cubes)
    expect(len(shown) > 0 and shown.ticks[-1] >= server.ticks[-1] >= 0,
           f"{client.name} never showed the last tick; its last line: {client.last_line()}")
    worst = max(lever_distance(server.rows[-1], shown.rows[-1], at) for at in range(0, cubes * ROW_FLOATS, ROW_FLOATS))
    expect(worst <= AT_REST, f"{client.name}: at the end the error of a cube is {worst * 1000:.1f} mm")


def resident_bytes(process):
    """Resident memory of a process; None if the system does not report it."""
    try:
        with open(f"/proc/{process.pid}/statm", encoding="utf-8") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return None


def processor_seconds(process):
    """Processor time that a process has used; None if the system does not report it."""
    try:
        with open(f"/proc/{process.pid}/stat", encoding="utf-8") as file:
            fields = file.read().rsplit(")", 1)[1].split()
    except OSError:
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
