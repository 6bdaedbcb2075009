"""meet, join and reflections, compared with Euclidean geometry at 50 digits (euclid.py), including degenerate cases."""

import numpy as np

import euclid
from euclid import exact
from scenes import SCENES, Scene, error

ORACLE = "Euclid, 50 digits"
CASES = 40
BOUNDS = {"1 mm": 1e-8, "1 m": 2e-13, "1 km": 5e-8, "100 km": 3e-4, "1 m, 1 km away": 5e-6, "1 km, 30 km away": 1e-4}
# Factor for reflections: an inversion amplifies the rounding of a radius.
REFLECTION_FACTOR = 50


def check(library, report, seed):
    """Runs the checks of this file: one for each operation and scene, which names its worst kind of case."""
    random = np.random.default_rng([seed, 90])
    for operation, table in (("meet", MEETS), ("join", JOINS), ("reflect_in", REFLECTIONS)):
        for label, (size, distance) in SCENES.items():
            errors = {}
            for name, draw in table.items():
                scenes = [Scene(random, size, distance) for _ in range(CASES)]
                errors[name] = errors_of(library, operation, scenes, [draw(scene) for scene in scenes])
            worst = max(errors, key=lambda name: max(errors[name]))
            report.check(ORACLE, f"{operation}, {label} ({len(table)} kinds; worst: {worst})", sum(errors.values(), []),
                         BOUNDS[label] * (REFLECTION_FACTOR if operation == "reflect_in" else 1))


def errors_of(library, operation, scenes, drawn):
    """The errors of cases, each (constructor, parameters) of both operands and the expected result."""
    left, right = (made(library, [case[side] for case in drawn]) for side in (0, 1))
    results = [library.incidence(operation, left, right)]
    if operation in ("meet", "join"):
        results.append(library.incidence(operation, right, left))
    return [error(found, case[2], scene.extent)
            for result in results for found, case, scene in zip(library.classify(result), drawn, scenes)]


def made(library, objects):
    """The multivectors of (constructor, parameters), all of the same constructor."""
    return library.construct(objects[0][0], [np.concatenate([np.atleast_1d(x) for x in row]) for _, row in objects])


# Objects: (constructor, its parameters), and the parameters of euclid.py.


def line(p, d):
    return ("line", [p, d]), (exact(p), exact(d))


def plane(n, p):
    """Through a point, up to rounding of the distance."""
    k = float(n @ p)
    return ("plane", [n, k]), (exact(n), exact([k])[0])


def circle(c, n, r):
    return ("circle", [c, n, r]), (exact(c), exact(n), exact([r])[0])


def sphere(c, r):
    return ("sphere", [c, r]), (exact(c), exact([r])[0])


def case(first, second, expected):
    return first[0], second[0], expected(first[1], second[1])


def kind(name, **parts):
    return lambda *_: {"kind": name, **parts}


def line_plane(s):
    d = s.direction()
    return case(line(s.position(), d), plane(s.aslant(d), s.position()), euclid.line_plane)


def plane_plane(s):
    n = s.direction()
    return case(plane(n, s.position()), plane(s.aslant(n), s.position()), euclid.plane_plane)


def sphere_plane(s):
    """Real and imaginary circles, not near tangency."""
    c, r, n = s.position(), s.radius(), s.direction()
    return case(sphere(c, r), plane(n, c + n * r * apart(s)), euclid.sphere_plane)


def apart(s):
    """0.1 .. 0.8 or 1.2 .. 2"""
    return s.random.uniform(0.1, 0.8) if s.random.uniform() < 0.6 else s.random.uniform(1.2, 2.0)


def sphere_sphere(s):
    c, r, q = s.position(), s.radius(), s.radius()
    if s.random.uniform() < 0.6:
        gap = s.random.uniform(abs(r - q) + 0.2 * min(r, q), r + q - 0.2 * min(r, q))
    else:
        gap = (r + q) * s.random.uniform(1.2, 2.0)
    return case(sphere(c, r), sphere(c + s.direction() * gap, q), euclid.sphere_sphere)


def line_sphere(s):
    c, r, d = s.position(), s.radius(), s.direction()
    return case(line(c + s.across(d) * r * apart(s) + d * s.size, d), sphere(c, r), euclid.line_sphere)


def circle_plane(s):
    c, n, r = s.position(), s.direction(), s.radius()
    m = s.aslant(n)
    inside = np.cross(n, np.cross(n, m))
    return case(circle(c, n, r), plane(m, c + inside / np.linalg.norm(inside) * r * apart(s)), euclid.circle_plane)


def circle_sphere(s):
    c, n, r = s.position(), s.direction(), s.radius()
    on_circle = c + s.across(n) * r
    q = s.radius()
    return case(circle(c, n, r), sphere(on_circle + s.aslant(n) * q * s.random.uniform(0.2, 0.8), q), euclid.circle_sphere)


def crossing_lines(s):
    p, d = s.position(), s.direction()
    e = s.aslant(d)
    return case(line(p - d * s.size, d), line(p + e * s.size, e), lambda *_: euclid.flat_point(exact(p)))


def coplanar_circles(s):
    c, n, r = s.position(), s.direction(), s.radius()
    q = s.radius()
    gap = s.random.uniform(abs(r - q) + 0.2 * min(r, q), r + q - 0.2 * min(r, q))
    if s.random.uniform() < 0.4:
        gap = (r + q) * s.random.uniform(1.2, 2.0)
    return case(circle(c, n, r), circle(c + s.across(n) * gap, n, q),
                lambda a, b: euclid.circle_sphere(a, (b[0], b[2])))


def circles_on_a_sphere(s):
    c, r, n = s.position(), s.radius(), s.direction()
    m = s.aslant(n)
    first = euclid.sphere_plane((exact(c), exact([r])[0]), (exact(n), exact([n @ c + 0.3 * r])[0]))
    second = euclid.sphere_plane((exact(c), exact([r])[0]), (exact(m), exact([m @ c - 0.2 * r])[0]))
    rounded = [circle(np.array(x["center"], float), np.array(x["normal"], float), float(x["radius"])) for x in (first, second)]
    return *rounded, (c, r)


def circles_with_two_points(s):
    first, second, _ = circles_on_a_sphere(s)
    return case(first, second, lambda a, b: euclid.circle_plane(a, (b[1], euclid.dot(b[1], b[0]))))


def circle_line(s):
    c, n, r = s.position(), s.direction(), s.radius()
    d = s.across(n)
    return case(circle(c, n, r), line(c + np.cross(n, d) * r * apart(s) + d * r, d), euclid.circle_line)


def tangent_plane(s):
    c, r, n = s.position(), s.radius(), s.direction()
    touch = c + n * r
    return case(sphere(c, r), plane(n, touch), kind("tangent", center=exact(touch), normal=exact(n)))


def tangent_spheres(s):
    c, r, q, u = s.position(), s.radius(), s.radius(), s.direction()
    touch = c + u * r
    return case(sphere(c, r), sphere(c + u * (r + q), q), kind("tangent", center=exact(touch), normal=exact(u)))


def tangent_line(s):
    c, r, d = s.position(), s.radius(), s.direction()
    touch = c + s.across(d) * r
    return case(sphere(c, r), line(touch, d), kind("tangent", center=exact(touch), direction=exact(d)))


def parallel_planes(s):
    n, p = s.direction(), s.position()
    return case(plane(n, p), plane(n, p + n * s.size), kind("direction", normal=exact(n)))


def parallel_lines(s):
    p, d = s.position(), s.direction()
    return case(line(p, d), line(p + s.across(d) * s.size, d), kind("direction", direction=exact(d)))


def line_along_plane(s):
    n, p = s.direction(), s.position()
    d = s.across(n)
    return case(line(p, d), plane(n, p + n * s.size), kind("direction", direction=exact(d)))


def skew_lines(s):
    """They share the point at infinity."""
    p, d = s.position(), s.direction()
    e = s.aslant(d)
    return case(line(p, d), line(p + np.cross(d, e) * s.size, e), kind("direction"))


def line_in_plane(s):
    n, p = s.direction(), s.position()
    d = s.across(n)
    return case(line(p, d), plane(n, p), lambda a, b: euclid.line(*a))


def circle_in_plane(s):
    c, n, r = s.position(), s.direction(), s.radius()
    return case(circle(c, n, r), plane(n, c), lambda a, b: euclid.circle(a[0], a[1], a[2] ** 2))


def circle_on_sphere(s):
    c, n, r = s.position(), s.direction(), s.radius()
    up = r * s.random.uniform(0.1, 1.0)
    return case(circle(c, n, r), sphere(c + n * up, float(np.hypot(r, up))), lambda a, b: euclid.circle(a[0], a[1], a[2] ** 2))


def same_sphere(s):
    it = sphere(s.position(), s.radius())
    return case(it, it, lambda a, b: euclid.sphere(a[0], a[1] ** 2))


def same_plane(s):
    it = plane(s.direction(), s.position())
    return case(it, it, lambda a, b: euclid.plane(*a))


def same_circle(s):
    it = circle(s.position(), s.direction(), s.radius())
    return case(it, it, lambda a, b: euclid.circle(a[0], a[1], a[2] ** 2))


def same_line(s):
    it = line(s.position(), s.direction())
    return case(it, it, lambda a, b: euclid.line(*a))


def point_on_sphere(s):
    c, r = s.position(), s.radius()
    p = c + s.direction() * r
    return ("point", [p]), ("sphere", [c, r]), euclid.point(exact(p))


def point_off_plane(s):
    n, p = s.direction(), s.position()
    return ("point", [p + n * s.size]), plane(n, p)[0], {"kind": "scalar"}


MEETS = {
    "line, plane": line_plane, "planes": plane_plane, "sphere, plane": sphere_plane, "spheres": sphere_sphere,
    "line, sphere": line_sphere, "circle, plane": circle_plane, "circle, sphere": circle_sphere,
    "crossing lines": crossing_lines, "circles of a plane": coplanar_circles,
    "circles with two points": circles_with_two_points, "circle, line of its plane": circle_line,
    "tangent plane": tangent_plane, "tangent spheres": tangent_spheres, "tangent line": tangent_line,
    "parallel planes": parallel_planes, "parallel lines": parallel_lines, "line along a plane": line_along_plane,
    "skew lines": skew_lines, "line in a plane": line_in_plane, "circle in a plane": circle_in_plane,
    "circle on a sphere": circle_on_sphere, "sphere, itself": same_sphere, "plane, itself": same_plane,
    "circle, itself": same_circle, "line, itself": same_line, "point on a sphere": point_on_sphere,
    "point off a plane": point_off_plane,
}


def join_points(s):
    a, b, _ = s.circle_points()
    return ("point", [a]), ("point", [b]), euclid.pair_through(exact(a), exact(b))


def join_point_pair(s):
    a, b, c = s.circle_points()
    return ("point", [a]), ("point_pair", [b, c]), euclid.circle_through(*map(exact, (a, b, c)))


def join_point_circle(s):
    a, b, c, d = s.sphere_points()
    return ("point", [d]), ("circle_through", [a, b, c]), euclid.sphere_through(*map(exact, (a, b, c, d)))


def join_point_line(s):
    a, b, c = s.circle_points()
    return ("point", [a]), ("line_through", [b, c]), euclid.plane_through(*map(exact, (a, b, c)))


def join_crossing_lines(s):
    p, d = s.position(), s.direction()
    e = s.aslant(d)
    normal = euclid.cross(exact(d), exact(e))
    return case(line(p, d), line(p, e), lambda a, b: euclid.plane(normal, euclid.dot(normal, a[0])))


def join_parallel_lines(s):
    p, d = s.position(), s.direction()
    u = s.across(d)
    normal = np.cross(d, u)
    return case(line(p, d), line(p + u * s.size, d), lambda a, b: euclid.plane(exact(normal), euclid.dot(exact(normal), a[0])))


def join_circles(s):
    first, second, (c, r) = circles_on_a_sphere(s)
    return case(first, second, lambda a, b: euclid.sphere(exact(c), exact([r])[0] ** 2))


def join_coplanar_circles(s):
    first, second, _ = coplanar_circles(s)
    c, n = (exact(x) for x in first[1][:2])
    return first, second, euclid.plane(n, euclid.dot(n, c))


def join_line_in_plane(s):
    first, second, _ = line_in_plane(s)
    n, k = second[1]
    return first, second, euclid.plane(exact(n), exact([k])[0])


JOINS = {
    "points": join_points, "point, pair": join_point_pair, "point, circle": join_point_circle,
    "point, line": join_point_line, "crossing lines": join_crossing_lines, "parallel lines": join_parallel_lines,
    "circles with two points": join_circles, "circles of a plane": join_coplanar_circles,
    "line in a plane": join_line_in_plane, "sphere, itself": same_sphere, "line, itself": same_line,
}


def point_in_plane(s):
    p = s.position()
    second = plane(s.direction(), s.position())
    foot = euclid.foot_on_plane(exact(p), second[1])
    return ("point", [p]), second[0], euclid.point(euclid.opposite(exact(p), foot))


def point_in_line(s):
    p = s.position()
    second = line(s.position(), s.direction())
    foot = euclid.foot_on_line(exact(p), second[1])
    return ("point", [p]), second[0], euclid.point(euclid.opposite(exact(p), foot))


def point_in_sphere(s):
    c, r = s.position(), s.radius()
    p = c + s.direction() * r * s.random.uniform(0.5, 2.0)
    return ("point", [p]), ("sphere", [c, r]), euclid.point(euclid.inverted(exact(p), (exact(c), exact([r])[0])))


def sphere_in_plane(s):
    first, second = sphere(s.position(), s.radius()), plane(s.direction(), s.position())
    foot = euclid.foot_on_plane(first[1][0], second[1])
    return first[0], second[0], euclid.sphere(euclid.opposite(first[1][0], foot), first[1][1] ** 2)


def line_in_mirror(s):
    first, second = line(s.position(), s.direction()), plane(s.direction(), s.position())
    ends = [euclid.opposite(p, euclid.foot_on_plane(p, second[1])) for p in (first[1][0], euclid.add(*first[1]))]
    return first[0], second[0], euclid.line(ends[0], euclid.minus(ends[1], ends[0]))


def plane_in_sphere(s):
    """A plane that does not contain the center is inverted to a sphere through the center."""
    c, r, n = s.position(), s.radius(), s.direction()
    first, second = plane(n, c + n * r * s.random.uniform(0.5, 1.5)), sphere(c, r)
    foot = euclid.inverted(euclid.foot_on_plane(second[1][0], first[1]), second[1])
    found = euclid.pair_through(second[1][0], foot)
    return first[0], second[0], euclid.sphere(found["center"], found["radius"] ** 2)


def circle_in_sphere(s):
    c, r = s.position(), s.size * s.random.uniform(0.8, 1.2)
    corners = np.array(s.sphere_points())
    points = list(c + s.direction() * 1.2 * s.size + 0.5 * (corners - corners.mean(axis=0)))[:3]
    mirror = (exact(c), exact([r])[0])
    return ("circle_through", points), ("sphere", [c, r]), euclid.circle_through(*(euclid.inverted(exact(p), mirror) for p in points))


REFLECTIONS = {
    "point in a plane": point_in_plane, "point in a line": point_in_line, "point in a sphere": point_in_sphere,
    "sphere in a plane": sphere_in_plane, "line in a plane": line_in_mirror, "plane in a sphere": plane_in_sphere,
    "circle in a sphere": circle_in_sphere,
}
