"""Constructors and classify against school geometry at 50 digits (euclid.py), in both conventions, for any weight."""

import numpy as np

import euclid
from euclid import exact
from scenes import SCENES, Scene, error

ORACLE = "Euclid, 50 digits"
CASES = 60
# What the coefficients of points can hold: a point p has the coefficients (p^2 -+ 1) / 2, so that lengths far below a
# metre lose digits to the 1, lengths far above it to p^2.
BOUNDS = {"1 mm": 1e-9, "1 m": 1e-13, "1 km": 1e-9, "100 km": 1e-5, "1 m, 1 km away": 1e-9, "1 km, 100 km away": 1e-5}


def check(library, report, seed):
    """Everything of this file."""
    random = np.random.default_rng([seed, 80])
    for label, (size, distance) in SCENES.items():
        for name, draw in CONSTRUCTORS.items():
            scenes = [Scene(random, size, distance) for _ in range(CASES)]
            drawn = [draw(scene) for scene in scenes]
            objects = library.construct(name, [np.concatenate([np.atleast_1d(x) for x in row]) for row, _ in drawn])
            wanted = [right for _, right in drawn]
            weights = random.choice([-1.0, 1.0], CASES) * 10.0 ** random.uniform(-6.0, 6.0, CASES)
            duals = library.unary("dual", objects * weights[:, None])
            errors = [max(error(a, right, scene.extent), error(b, right, scene.extent))
                      for a, b, right, scene in zip(library.classify(objects), library.classify(duals, ipns=True), wanted, scenes)]
            report.check(ORACLE, f"{name} and classify, {label}", errors, BOUNDS[label])


def point(scene):
    p = scene.position()
    return [p], euclid.point(exact(p))


def flat_point(scene):
    p = scene.position()
    return [p], euclid.flat_point(exact(p))


def point_pair(scene):
    a, b = scene.position(), scene.position()
    while np.linalg.norm(b - a) < 0.3 * scene.size:
        b = scene.position()
    return [a, b], euclid.pair_through(exact(a), exact(b))


def line(scene):
    p, d = scene.position(), scene.direction() * scene.random.uniform(0.5, 2.0)
    return [p, d], euclid.line(exact(p), exact(d))


def line_through(scene):
    (a, b), _ = point_pair(scene)
    return [a, b], euclid.line(exact(a), euclid.minus(exact(b), exact(a)))


def circle(scene):
    c, n, r = scene.position(), scene.direction(), scene.radius()
    return [c, n, r], euclid.circle(exact(c), exact(n), exact([r])[0] ** 2)


def circle_through(scene):
    points = scene.circle_points()
    return points, euclid.circle_through(*map(exact, points))


def plane(scene):
    n = scene.direction()
    k = float(n @ scene.position())
    return [n, k], euclid.plane(exact(n), exact([k])[0])


def plane_through(scene):
    points = scene.circle_points()
    return points, euclid.plane_through(*map(exact, points))


def sphere(scene):
    c, r = scene.position(), scene.radius()
    return [c, r], euclid.sphere(exact(c), exact([r])[0] ** 2)


def sphere_through(scene):
    points = scene.sphere_points()
    return points, euclid.sphere_through(*map(exact, points))


CONSTRUCTORS = {
    "point": point, "flat_point": flat_point, "point_pair": point_pair, "line": line, "line_through": line_through,
    "circle": circle, "circle_through": circle_through, "plane": plane, "plane_through": plane_through,
    "sphere": sphere, "sphere_through": sphere_through,
}
