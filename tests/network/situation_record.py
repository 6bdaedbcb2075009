"""Reads what situations/recorder.gd writes, and measures how a body moves in it."""

import json
from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field

# Frames that follow each other faster than this, in seconds, after a late one: their speed says nothing.
MIN_FRAME = 0.002


@dataclass
class Sample:
    """One body in one frame or tick of one peer. Times in seconds."""

    wall: float
    media: float
    delay: float  # as reported by the synchronizer
    position: tuple
    is_visible: bool
    is_owned: bool

    @property
    def x(self):
        return self.position[0]


@dataclass
class Record:
    """What one process recorded: for each body its samples in frames and, where it owns it, in ticks; and events."""

    path: str
    frames: dict = field(default_factory=dict)
    ticks: dict = field(default_factory=dict)
    events: dict = field(default_factory=dict)
    # Wall clock time of each frame, with or without bodies.
    frame_walls: list = field(default_factory=list)

    def __post_init__(self):
        with open(self.path, encoding="utf-8") as file:
            for line in file:
                self._read(json.loads(line))

    def _read(self, item):
        if item[0] == "e":
            self.events.setdefault(item[2], item[1])
            return
        kind, wall, media, delay, bodies = item
        into = self.frames if kind == "f" else self.ticks
        if kind == "f":
            self.frame_walls.append(wall)
        for label, (x, y, z, is_visible, is_owned) in bodies.items():
            into.setdefault(label, []).append(Sample(wall, media, delay, (x, y, z), is_visible, is_owned))

    def remove_steps(self, step, reference):
        """Removes steps of the wall clock by multiples of `step` seconds; `reference`: a time of the session without them."""
        def corrected(wall):
            return wall - step * round((wall - reference) / step)

        for samples in (*self.frames.values(), *self.ticks.values()):
            for sample in samples:
                sample.wall = corrected(sample.wall)
        self.events = {name: corrected(wall) for name, wall in self.events.items()}
        self.frame_walls = [corrected(wall) for wall in self.frame_walls]

    @property
    def begin(self):
        return self.events["begin"]

    def shown(self, label, begin=None, end=None):
        """The visible frames of a body between two wall clock times."""
        return [sample for sample in self.frames.get(label, ())
                if sample.is_visible and (begin is None or sample.wall >= begin) and (end is None or sample.wall <= end)]


class Truth:
    """Where the owners of a body had it, from the records of all processes."""

    def __init__(self, processes, label, in_frames=False):
        samples = []
        for process in processes:
            source = process.record.frames if in_frames else process.record.ticks
            samples += [sample for sample in source.get(label, ()) if sample.is_owned]
        self.samples = sorted(samples, key=lambda sample: sample.wall)
        self._walls = [sample.wall for sample in self.samples]
        self._xs = [sample.x for sample in self.samples]
        self._media = [sample.media for sample in self.samples]

    def position_at(self, wall):
        """The position at a wall clock time; None outside the record."""
        return self._interpolate(self._walls, wall)

    def position_at_media(self, media):
        """The position at a media time of the only owner; None outside the record."""
        return self._interpolate(self._media, media)

    def wall_at_x(self, x):
        """The latest wall clock time at which the body had passed x no more than a step ago; it moves along x."""
        at = bisect_left(self._xs, x)
        if at == 0 or at == len(self._xs):
            return None
        share = (x - self._xs[at - 1]) / (self._xs[at] - self._xs[at - 1])
        return self._walls[at - 1] + share * (self._walls[at] - self._walls[at - 1])

    def speed(self, begin, end):
        """The mean speed along x between two wall clock times."""
        inside = [sample for sample in self.samples if begin <= sample.wall <= end]
        return (inside[-1].x - inside[0].x) / (inside[-1].wall - inside[0].wall)

    def tick_rate(self, begin, end):
        inside = [wall for wall in self._walls if begin <= wall <= end]
        return (len(inside) - 1) / (inside[-1] - inside[0])

    def distance(self, position):
        """The distance from a position to the path."""
        best = float("inf")
        for before, after in zip(self.samples, self.samples[1:]):
            best = min(best, distance_to_line(position, before.position, after.position))
        return best

    def _interpolate(self, keys, key):
        at = bisect_right(keys, key)
        if at == 0 or at == len(keys):
            return None
        before, after = self.samples[at - 1].position, self.samples[at].position
        span = keys[at] - keys[at - 1]
        share = (key - keys[at - 1]) / span if span > 0.0 else 0.0
        return tuple(a + share * (b - a) for a, b in zip(before, after))


def distance(a, b):
    return sum((p - q) ** 2 for p, q in zip(a, b)) ** 0.5


def distance_to_line(point, a, b):
    """The distance from a point to the line segment from a to b."""
    direction = [q - p for p, q in zip(a, b)]
    square = sum(d * d for d in direction)
    along = sum((p - q) * d for p, q, d in zip(point, a, direction)) / square if square else 0.0
    along = min(max(along, 0.0), 1.0)
    return distance(point, [p + along * d for p, d in zip(a, direction)])


def steps(samples):
    """(sample, seconds, meters) of each frame since the previous one."""
    return [(now, now.wall - before.wall, distance(now.position, before.position))
            for before, now in zip(samples, samples[1:]) if now.wall - before.wall >= MIN_FRAME]


def frozen_share(samples, speed):
    """The share of frames in which the body moves less than a tenth of `speed`, in m/s."""
    taken = steps(samples)
    frozen = sum(meters < 0.1 * speed * seconds for _, seconds, meters in taken)
    return frozen / len(taken) if taken else 1.0


def longest_stand(samples, speed):
    """The longest time, in seconds, in which the body moves less than a tenth of `speed` in every frame."""
    longest = current = 0.0
    for _, seconds, meters in steps(samples):
        current = current + seconds if meters < 0.1 * speed * seconds else 0.0
        longest = max(longest, current)
    return longest


def largest_jump(samples, speed):
    """The largest excess, in meters, of a frame's step over that at `speed`, in m/s."""
    return max((meters - speed * seconds for _, seconds, meters in steps(samples)), default=0.0)


def speeds(samples, span=0.05):
    """The mean speeds along x over spans of at least `span` seconds."""
    found = []
    last = 0
    for at, sample in enumerate(samples):
        if sample.wall - samples[last].wall >= span:
            found.append((sample.x - samples[last].x) / (sample.wall - samples[last].wall))
            last = at
    return found


def delays(samples, truth):
    """For each frame, how long ago the owner had the body at the x that is shown, in seconds."""
    walls = [(sample, truth.wall_at_x(sample.x)) for sample in samples]
    return [sample.wall - wall for sample, wall in walls if wall is not None]


def deviations(samples, truth):
    """For each frame, the distance to where the owner had the body at the media time shown, in meters."""
    found = [(sample, truth.position_at_media(sample.media)) for sample in samples]
    return [distance(sample.position, position) for sample, position in found if position is not None]
