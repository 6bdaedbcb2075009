"""How far what a client shows is from where the server's bodies were, at the same media time."""
import bisect

from pose_record import ROW_FLOATS, lever_distance

# Of a client that shows what arrives as it arrives, in seconds, besides what the network delays.
MAX_DELAY = 0.25
# How far from a tick a picture may be, in ticks.
NEAR_A_TICK = 0.1


class ErrorSummary:
    """Errors in metres: over moving samples, and over resting ones apart."""

    def __init__(self):
        self.moving = []
        self.resting = []
        self.delays = []

    def add(self, truth, shown, moving, every_rest=5):
        """One picture: `moving` lists the offsets of moving bodies; of the resting, every n-th is looked at."""
        for at in moving:
            self.moving.append(lever_distance(truth, shown, at))
        moves = set(moving)
        for at in range(0, len(truth), ROW_FLOATS * every_rest):
            if at not in moves:
                self.resting.append(lever_distance(truth, shown, at))

    def merge(self, other):
        self.moving += other.moving
        self.resting += other.resting
        self.delays += other.delays

    def figures(self):
        """Percentiles in millimetres, delay in milliseconds; None where there was nothing to look at."""
        return {
            "samples": len(self.moving),
            "p50": percentile(self.moving, 0.50, 1000.0),
            "p99": percentile(self.moving, 0.99, 1000.0),
            "max": percentile(self.moving, 1.0, 1000.0),
            "rest_p50": percentile(self.resting, 0.50, 1000.0),
            "rest_p99": percentile(self.resting, 0.99, 1000.0),
            "delay": percentile(self.delays, 0.50, 1000.0),
        }


def percentile(values, share, scale=1.0):
    if not values:
        return None
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))] * scale


def compare_by_tick(server, moving, client):
    """For a client that knows which moment it shows: error at that moment; delay from the two wall clocks.

    Only pictures close to a tick count: between two ticks, where a collision may be, the server itself knows no pose.
    """
    summary = ErrorSummary()
    for wall, tick, rows in zip(client.walls, client.ticks, client.rows):
        truth, index = rows_at(server, server.ticks, tick)
        if truth is None:
            continue
        if abs(tick - round(tick)) <= NEAR_A_TICK:
            summary.add(truth, rows, moving[index])
        before, after = server.ticks[index - 1], server.ticks[index]
        weight = (tick - before) / (after - before)
        summary.delays.append(wall - server.walls[index - 1] * (1.0 - weight) - server.walls[index] * weight)
    return summary


def compare_by_wall_clock(server, moving, client, network_delay=0.0):
    """For a client that knows no time: the one delay that makes the mean error smallest is removed."""
    delay = best_delay(server, moving, client, MAX_DELAY + network_delay)
    summary = ErrorSummary()
    for wall, rows in zip(client.walls, client.rows):
        truth, index = rows_at(server, server.walls, wall - delay)
        if truth is not None:
            summary.add(truth, rows, moving[index])
            summary.delays.append(delay)
    return summary


def best_delay(server, moving, client, longest=MAX_DELAY):
    """Searches the delay in steps of 8 ms, then of 2 ms around the best, on a part of the pictures."""
    step = max(1, len(client) // 40)
    pictures = list(zip(client.walls, client.rows))[::step]

    def mean_error(delay):
        total, count = 0.0, 0
        for wall, rows in pictures:
            truth, index = rows_at(server, server.walls, wall - delay)
            if truth is None:
                continue
            for at in moving[index][::3]:
                total += lever_distance(truth, rows, at)
                count += 1
        return total / count if count else float("inf")

    coarse = min((0.008 * i for i in range(int(longest / 0.008))), key=mean_error)
    fine = [max(0.0, coarse + 0.002 * i) for i in range(-4, 5)]
    return min(fine, key=mean_error)


def rows_at(server, moments, moment):
    """The server's rows at a moment, between two of its own in proportion, and the index of the later; None outside.

    `moments` are those of its rows, by any clock; before the first that is not negative none counts.
    """
    index = bisect.bisect_left(moments, moment)
    if index == 0 or index >= len(moments) or moments[index - 1] < 0.0:
        return None, 0
    before, after = server.rows[index - 1], server.rows[index]
    span = moments[index] - moments[index - 1]
    weight = (moment - moments[index - 1]) / span if span > 0.0 else 1.0
    if before == after:
        return after, index
    return [a + (b - a) * weight for a, b in zip(before, after)], index
