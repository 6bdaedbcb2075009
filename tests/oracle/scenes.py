"""Random objects of Euclidean geometry at the scales of applications, and the error of classifications."""

import numpy as np

import euclid

# Size of the objects and their distance from the origin, in meters.
SCENES = {
    "1 mm": (1e-3, 1e-3),
    "1 m": (1.0, 1.0),
    "1 km": (1e3, 1e3),
    "100 km": (1e5, 1e5),
    "1 m, 1 km away": (1.0, 1e3),
    "1 km, 30 km away": (1e3, 3e4),
}
LIMIT = 0.8  # of cosines: nearly parallel directions are ill-conditioned


class Scene:
    """Draws positions, directions and sizes, as doubles."""

    def __init__(self, random, size, distance):
        self.random, self.size = random, size
        self.place = self.direction() * distance
        self.extent = size + distance

    def direction(self):
        vector = self.random.standard_normal(3)
        return vector / np.linalg.norm(vector)

    def across(self, direction):
        """A random orthogonal unit vector, up to rounding."""
        vector = np.cross(direction, self.direction())
        return vector / np.linalg.norm(vector)

    def aslant(self, direction):
        """A direction neither parallel nor orthogonal to another one."""
        while True:
            vector = self.direction()
            if 1.0 - LIMIT < abs(vector @ direction) < LIMIT:
                return vector

    def position(self):
        return self.place + self.direction() * self.size * self.random.uniform(0.2, 1.0)

    def radius(self):
        return self.size * self.random.uniform(0.3, 1.0)

    def circle_points(self, count=3):
        """Well separated points on a circle, up to rounding."""
        center, radius, first = self.position(), self.radius(), self.direction()
        second = self.across(first)
        angles = 2 * np.pi * (np.arange(count) + self.random.uniform(-0.3, 0.3, count)) / count
        return [center + radius * (np.cos(angle) * first + np.sin(angle) * second) for angle in angles]

    def sphere_points(self):
        """The corners of an irregular tetrahedron."""
        corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / np.sqrt(3.0)
        frame = np.array([first := self.direction(), second := self.across(first), np.cross(first, second)])
        corners = corners @ frame + self.random.uniform(-0.2, 0.2, (4, 3))
        return list(self.position() + self.radius() * corners)


def error(found, expected, extent):
    """The error of a classification against a dict of euclid.py, lengths relative to the extent of the scene."""
    if found["kind"] != expected["kind"] or found["imaginary"] != bool(expected.get("imaginary", False)):
        return np.inf
    worst = 0.0
    for name in ("center", "radius", "normal", "direction", "distance", "points"):
        if name not in expected:
            continue
        if name not in found:
            return np.inf
        worst = max(worst, part_error(name, found, expected, extent))
    return float(worst)


def part_error(name, found, expected, extent):
    ours, right = found[name], expected[name]
    if name == "points":
        return min(max(gap(ours[0], right[i]), gap(ours[1], right[1 - i])) for i in (0, 1)) / extent
    if name in ("normal", "direction"):
        return min(gap(ours, right), gap(ours, [-x for x in right]))
    if name == "distance":
        # The distance is along the normal found, which may be the negative of the expected one.
        is_negated = euclid.dot(euclid.exact(found["normal"]), expected["normal"]) < 0
        return abs(float(ours) - float(-right if is_negated else right)) / extent
    return gap(np.atleast_1d(ours), right if name == "center" else [right]) / extent


def gap(ours, right):
    return float(euclid.length(euclid.minus(euclid.exact(ours), euclid.exact(right))))
