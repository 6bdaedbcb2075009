"""Constructors and classify, compared with Euclidean geometry at 50 digits (euclid.py), in OPNS and IPNS, for any weight."""

import numpy as np

import euclid
from euclid import exact
from scenes import SCENES, Scene, error

ORACLE = "Euclid, 50 digits"
CASES = 100
# Flats keep all digits. Points and rounds store half the square of their distance beside a weight of 1, so lengths far
# below a meter lose digits to the 1, and those far above to the square. The bounds are the precision of doubles.
FLAT_BOUND = 2e-15
ROUND_BOUNDS = {"1 mm": 1e-9, "1 m": 1e-13, "1 km": 3e-9, "100 km": 3e-5, "1 m, 1 km away": 1e-6, "1 km, 30 km away": 1e-4}
FLATS = ("flat_point", "line", "line_through", "plane", "plane_through")


def check(library, report, seed):
    """Runs the checks of this file: two for each scene, which name their worst constructor."""
    random = np.random.default_rng([seed, 80])
    for label, (size, distance) in SCENES.items():
        errors = {False: {}, True: {}}
        for name, draw in CONSTRUCTORS.items():
            scenes = [Scene(random, size, distance) for _ in range(CASES)]
            drawn = [draw(scene) for scene in scenes]
            objects = library.construct(name, [np.concatenate([np.atleast_1d(x) for x in row]) for row, _ in drawn])
            weights = random.choice([-1.0, 1.0], CASES) * 10.0 ** random.uniform(-6.0, 6.0, CASES)
            duals = library.unary("dual", objects * weights[:, None])
            found = library.classify(objects), library.classify(duals, ipns=True)
            errors[name in FLATS][name] = [error(x, expected, scene.extent) for classes in found
                                           for x, (_, expected), scene in zip(classes, drawn, scenes)]
        for flat, group in ((True, "flats"), (False, "points and rounds")):
            worst = max(errors[flat], key=lambda name: max(errors[flat][name]))
            bound = FLAT_BOUND if flat else ROUND_BOUNDS[label]
            report.check(ORACLE, f"classify {group}, {label} (worst: {worst})", sum(errors[flat].values(), []), bound)
    check_rejected(library, report)


def check_rejected(library, report):
    """Invalid parameters. Three points of a line and four points of a plane are valid: they give the line and the plane."""
    nan, a, b, c = np.nan, [1.0, 2.0, 3.0], [3.0, 4.0, 5.0], [4.0, 5.0, 6.0]
    for name, rows in {
        "point_pair": [a + a, a + [nan, 0, 0], [1e5, 0, 0, 1e5 + 1e-11, 0, 0]], "line": [a + [0, 0, 0], [nan, 0, 0] + a],
        "line_through": [b + b], "circle": [a + b + [0.0], a + b + [-1.0], a + [0, 0, 0, 1], a + b + [np.inf]],
        "circle_through": [a + a + b, a + b + a], "plane": [[0, 0, 0, 1], [0, 0, 1, nan]],
        "plane_through": [a + b + c, a + a + b], "sphere": [a + [0.0], a + [-2.0], a + [nan]],
        "sphere_through": [a + b + c + a, [1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0]],
    }.items():
        results, reasons = library.construct_with_reasons(name, rows)
        successes = [bool(reason) and np.isnan(result).all() for result, reason in zip(results, reasons)]
        report.count(ORACLE, f"{name} rejected with a reason", successes)
    kinds = [library.classify(library.construct(name, [row]))[0]["kind"] for name, row in (
        ("circle_through", a + b + c), ("circle_through", [0, 0, 1e5, 1, 0, 1e5, 5, 0, 1e5]),
        ("sphere_through", [0, 0, 7, 1, 0, 7, 0, 1, 7, 3, 3, 7]))]
    report.count(ORACLE, "three points of a line, four of a plane", [kind == expected for kind, expected in zip(kinds, ("line", "line", "plane"))])


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
