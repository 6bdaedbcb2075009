"""What cases of the network suite check about a run."""

import os
import time

from pose_error import compare_by_tick, percentile
from pose_record import PoseRecord, ROW_FLOATS, lever_distance, moving_bodies

# Bounds in meters, where the tolerance is 5 mm. A share may be outside: a busy machine is late now and then.
MOVING_BOUND = 0.006
MOVING_SHARE = 0.96
# On a good network nearly all of the rest is not far outside.
MOVING_P99 = 0.010
MAX_MOVING = 0.3
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


def expect_errors_within(run, client, cubes, share=MOVING_SHARE, bound=MOVING_BOUND, most=MAX_MOVING, after=0):
    """That share of what the client showed of moving cubes is within the bound, and all of it within `most`.

    Its first `after` seconds do not count: it has to find its delay. Returns how many samples that were.
    """
    server, moving, _ = server_record(run, cubes)
    shown = PoseRecord(client.record_path, cubes)
    shown.drop_until(shown.walls[0] + after if len(shown) else 0)
    errors = compare_by_tick(server, moving, shown).moving
    expect(errors, f"{client.name} showed no moving cube")
    error = percentile(errors, share)
    expect(error <= bound, f"{client.name}: {1 - share:.0%} of the errors are larger than {error * 1000:.1f} mm")
    expect(max(errors) <= most, f"{client.name}: the largest error is {max(errors) * 1000:.1f} mm")
    return len(errors)


def expect_good_network_errors(run, client, cubes):
    """The bounds of a session that nothing disturbs. Returns how many samples there were."""
    expect_errors_within(run, client, cubes, share=0.99, bound=MOVING_P99)
    return expect_errors_within(run, client, cubes)


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
