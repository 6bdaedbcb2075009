"""The error of the poses that a client showed, relative to the server's at the same media time.

Defined in docs/performance/network.md, as for tests/bench/network/pose_error.hpp.
"""
import bisect

from pose_record import ROW_FLOATS, lever_distance

# Seconds that a client without playback delay lags behind the server, network delay excluded.
MAX_DELAY = 0.25
# Frames further from a tick than this, in ticks, are not compared.
MAX_TICK_OFFSET = 0.1


class ErrorSummary:
    """Errors in meters, of moving and of resting samples; playback delays in seconds."""

    def __init__(self):
        self.moving = []
        self.resting = []
        self.delays = []

    def add(self, truth, shown, moving, resting_step=5):
        """Adds a frame: the moving bodies, given by the offsets of their rows, and one in `resting_step` of the others."""
        for at in moving:
            self.moving.append(lever_distance(truth, shown, at))
        moving_set = set(moving)
        for at in range(0, len(truth), ROW_FLOATS * resting_step):
            if at not in moving_set:
                self.resting.append(lever_distance(truth, shown, at))

    def merge(self, other):
        self.moving += other.moving
        self.resting += other.resting
        self.delays += other.delays

    def figures(self):
        """Percentiles in millimeters, median delay in milliseconds; None where there are no samples."""
        return {
            "samples": len(self.moving),
            "p50": milli(percentile(self.moving, 0.5)),
            "p99": milli(percentile(self.moving, 0.99)),
            "max": milli(percentile(self.moving, 1.0)),
            "rest_p50": milli(percentile(self.resting, 0.5)),
            "rest_p99": milli(percentile(self.resting, 0.99)),
            "delay": milli(percentile(self.delays, 0.5)),
        }


def percentile(values, share):
    """The percentile at `share` (0 to 1), by linear interpolation between the closest ranks; None without values."""
    if not values:
        return None
    values = sorted(values)
    place = share * (len(values) - 1)
    below = values[int(place)]
    above = values[min(int(place) + 1, len(values) - 1)]
    weight = place - int(place)
    # Does not subtract infinities, which would give NaN.
    return below if weight == 0.0 or above == below else below + (above - below) * weight


def milli(value):
    """A thousand times the value; None stays None."""
    return None if value is None else 1000.0 * value


def compare_by_tick(server, moving, client):
    """For a client that records the media time it shows: errors at that time; delays by the two wall clocks.

    Errors are taken only of frames close to a tick: between two ticks, where a collision may be, the server has no pose.
    """
    summary = ErrorSummary()
    for wall, tick, rows in zip(client.walls, client.ticks, client.rows):
        truth, index = rows_at(server, server.ticks, tick)
        if truth is None:
            continue
        if abs(tick - round(tick)) <= MAX_TICK_OFFSET:
            summary.add(truth, rows, moving[index])
        before, after = server.ticks[index - 1], server.ticks[index]
        weight = (tick - before) / (after - before)
        summary.delays.append(wall - server.walls[index - 1] * (1.0 - weight) - server.walls[index] * weight)
    return summary


def compare_by_wall_clock(server, moving, client, network_delay=0.0):
    """For a client without media time: removes the constant delay that minimizes the mean error."""
    delay = best_delay(server, moving, client, MAX_DELAY + network_delay)
    summary = ErrorSummary()
    for wall, rows in zip(client.walls, client.rows):
        truth, index = rows_at(server, server.walls, wall - delay)
        if truth is not None:
            summary.add(truth, rows, moving[index])
            summary.delays.append(delay)
    return summary


def best_delay(server, moving, client, max_delay=MAX_DELAY):
    """Searches the delay in steps of 8 ms, then of 2 ms around the best, on a subset of the frames."""
    step = max(1, len(client) // 40)
    frames = list(zip(client.walls, client.rows))[::step]

    def mean_error(delay):
        total, count = 0.0, 0
        for wall, rows in frames:
            truth, index = rows_at(server, server.walls, wall - delay)
            if truth is None:
                continue
            for at in moving[index][::3]:
                total += lever_distance(truth, rows, at)
                count += 1
        return total / count if count else float("inf")

    coarse = min((0.008 * i for i in range(int(max_delay / 0.008))), key=mean_error)
    fine = [max(0.0, coarse + 0.002 * i) for i in range(-4, 5)]
    return min(fine, key=mean_error)


def rows_at(server, times, time):
    """The server's rows at a time, interpolated linearly, and the index of the record at or after it.

    `times` are the times of its records, on any clock; records at negative times are ignored. Returns (None, 0) outside.
    """
    index = bisect.bisect_left(times, time)
    if index == 0 or index >= len(times) or times[index - 1] < 0.0:
        return None, 0
    before, after = server.rows[index - 1], server.rows[index]
    span = times[index] - times[index - 1]
    weight = (time - times[index - 1]) / span if span > 0.0 else 1.0
    if before == after:
        return after, index
    return [a + (b - a) * weight for a, b in zip(before, after)], index
