"""meet, join and reflections of small and large objects, 1 mm to 100 km, compared with Euclidean geometry at 50 digits.

The expected result is that of the objects as their rounded coefficients represent them, so that only the operation is
measured. Errors are relative to the radius of the result plus its distance from the origin.
"""

import numpy as np
import mpmath
from clifford import g3c
from mpmath import mpf

import euclid
from euclid import add, cross, dot, minus
from scenes import Scene, error

ORACLE = "mixed scales, 50 digits"
CASES = 40
SMALLEST, LARGEST = 1e-3, 1e5
RATIOS = {"1 to 100": (1e0, 1e2), "100 to 10,000": (1e2, 1e4), "10,000 to 10^8": (1e4, 1e8)}
BOUND = 1e-12
EUCLIDEAN = ("", "1", "2", "3", "12", "13", "23", "123")
INDEX = {name: i for i, name in enumerate(g3c.layout.names)}


def check(library, report, seed):
    """Runs the checks of this file: one for each operation and range of ratios, which names its worst kind of case."""
    for operation, label, errors in all_errors(library, seed):
        worst = max(errors, key=lambda name: max(errors[name]))
        report.check(ORACLE, f"{operation}, sizes {label} ({len(errors)} kinds; worst: {worst})", sum(errors.values(), []), BOUND)


def all_errors(library, seed):
    random = np.random.default_rng([seed, 120])
    for operation, table in TABLES.items():
        for label, ratios in RATIOS.items():
            yield operation, label, {name: [error_of(library, operation, *draw(Pair(library, random, ratios)), random)
                                            for _ in range(CASES)] for name, draw in table.items()}


def error_of(library, operation, left, right, expected, random):
    if operation != "reflect_in" and random.uniform() < 0.5:
        left, right = right, left
    result = library.incidence(operation, [left], [right])
    extent = float(expected.get("radius", mpf(0)) + euclid.length(expected["center"]))
    return error(library.classify(result)[0], expected, extent) / rounding_factor(result[0], extent)


def rounding_factor(blade, extent):
    """The amplification of rounding by the coefficients of e4 and e5, which store Q + R / 2 and Q - R / 2, in meters."""
    _, q, r, _ = parts(blade)
    square, weight = (float(max(abs(part(x)) for x in EUCLIDEAN)) for part in (q, r))
    return (1.0 + square / weight) * (1.0 + extent ** -2) if weight > 0.0 else 1.0


class Pair(Scene):
    """Draws small objects near the origin and large ones that extend to them."""

    def __init__(self, library, random, ratios):
        ratio = np.exp(random.uniform(*np.log(ratios)))
        size = np.exp(random.uniform(np.log(SMALLEST), np.log(LARGEST / ratio)))
        super().__init__(random, size, size)
        self.library, self.large = library, size * ratio

    def made(self, name, *parameters):
        return self.library.construct(name, [np.concatenate([np.atleast_1d(x) for x in parameters])])[0]

    def small_circle(self):
        c, n, r = self.position(), self.direction(), self.radius()
        return self.made("circle", c, n, r), c, n, r

    def corners(self):
        """Three well separated directions."""
        while True:
            found = [self.direction() for _ in range(3)]
            if abs(np.linalg.det(found)) > 0.2:
                return found

    def large_radius(self):
        return self.large * self.random.uniform(0.3, 1.0)

    def large_sphere(self, through, direction=None):
        """Through a point, up to rounding."""
        radius = self.large_radius()
        return self.made("sphere", through + radius * (self.direction() if direction is None else direction), radius)


# Parameters of euclid.py from coefficients. The parts are those of conformal_parts.hpp:
# X = A + Q ^ e_inf + R ^ e_o + D ^ E.


def parts(blade):
    """A, Q, R, D as functions of the name of a Euclidean blade."""
    def a(name):
        return mpf(float(blade[INDEX["e" + name]]))
    return a, lambda x: (a(x + "4") + a(x + "5")) / 2, lambda x: a(x + "5") - a(x + "4"), lambda x: a(x + "45")


def axis(part):
    """The axis of a bivector."""
    return [part("23"), -part("13"), part("12")]


def read_point(blade):
    a, _, r, _ = parts(blade)
    return [a(x) / r("") for x in "123"]


def read_sphere(blade):
    """(center, radius) of a real sphere: D = -(c . E), h = Q / R, r^2 = 2 h + c^2."""
    _, q, r, d = parts(blade)
    center = [x / r("123") for x in axis(d)]
    return center, mpmath.sqrt(2 * q("123") / r("123") + dot(center, center))


def read_circle(blade):
    """(center, normal, radius) of a real circle."""
    a, q, r, d = parts(blade)
    n = axis(r)
    square = dot(n, n)
    along = [x / square for x in cross(n, [d("1"), d("2"), d("3")])]
    across = [x * a("123") / square for x in n]
    power = dot(axis(q), n) / square
    return add(along, across), n, mpmath.sqrt(2 * power + dot(along, along) - dot(across, across))


def read_pair(blade):
    """The points of a real point pair: c orthogonal to E from A, along E from D."""
    a, q, r, d = parts(blade)
    e = [-r(x) for x in "123"]
    square = dot(e, e)
    along = [-d("") * x / square for x in e]
    # c ^ E = (c x E) I
    across = [x / square for x in cross(e, axis(a))]
    power = -dot([q(x) for x in "123"], e) / square
    radius = mpmath.sqrt(2 * power + dot(along, along) - dot(across, across))
    center, unit = add(along, across), euclid.unit(e)
    return add(center, unit, -radius), add(center, unit, radius)


def read_line(blade):
    """(foot, direction): D = -(-1)^k F, Q = p ^ F."""
    _, q, _, d = parts(blade)
    e = [d(x) for x in "123"]
    return [x / dot(e, e) for x in cross(e, axis(q))], e


def points_of(circle):
    """Three points of a circle."""
    c, n, r = circle
    u = euclid.unit(cross(n, [mpf(1), mpf(2), mpf(3)]))
    v = euclid.unit(cross(n, u))
    return add(c, u, r), add(c, u, -r), add(c, v, r)


# Meets.


def spheres(s):
    c, r = s.position(), s.radius()
    first, n = s.made("sphere", c, r), s.direction()
    second = s.large_sphere(c + n * r * s.random.uniform(-0.7, 0.7), n)
    return first, second, euclid.sphere_sphere(read_sphere(first), read_sphere(second))


def spheres_apart(s):
    """Disjoint spheres: an imaginary circle."""
    c, r, n = s.position(), s.radius(), s.direction()
    first, gap = s.made("sphere", c, r), r * s.random.uniform(1.5, 20.0)
    radius = s.large_radius() + 30.0 * r
    second = s.made("sphere", c + n * (gap + radius * s.random.choice([-1.0, 1.0])), radius)
    return first, second, euclid.sphere_sphere(read_sphere(first), read_sphere(second))


def circle_sphere(s):
    first, c, n, r = s.small_circle()
    m = s.aslant(n)
    second = s.large_sphere(c + s.across(n) * r * s.random.uniform(0.0, 0.3), m)
    return first, second, euclid.circle_sphere(read_circle(first), read_sphere(second))


def circle_sphere_through(s):
    """The large sphere is given by four points, one of them the center of the small circle."""
    first, c, n, r = s.small_circle()
    second = s.made("sphere_through", c, *(c + s.large * x for x in s.corners()))
    return first, second, euclid.circle_sphere(read_circle(first), read_sphere(second))


def sphere_large_circle(s):
    """A small sphere and a large circle through it."""
    c, r = s.position(), s.radius()
    first, n = s.made("sphere", c, r), s.direction()
    radius = s.large_radius()
    second = s.made("circle", c + s.across(n) * radius + s.direction() * r * 0.5, n, radius)
    return first, second, euclid.circle_sphere(read_circle(second), read_sphere(first))


def line_large_sphere(s):
    p, d = s.position(), s.direction()
    first, second = s.made("line", p, d), s.large_sphere(p, s.aslant(d))
    return first, second, euclid.line_sphere(read_line(first), read_sphere(second))


def tangent_spheres(s):
    """Spheres that touch up to rounding are tangent."""
    c, r, u, radius = s.position(), s.radius(), s.direction(), s.large_radius()
    first, second = s.made("sphere", c, r), s.made("sphere", c + u * r + u * radius, radius)
    return first, second, {"kind": "tangent", "center": euclid.sphere_sphere(read_sphere(first), read_sphere(second))["center"]}


def circle_on_sphere(s):
    """A small circle on a large sphere: their meet is the circle."""
    first, c, n, r = s.small_circle()
    radius = s.large_radius() + r
    second = s.made("sphere", c + n * np.sqrt(radius ** 2 - r ** 2), radius)
    c, n, r = read_circle(first)
    return first, second, euclid.circle(c, n, r ** 2)


# Joins.


def pair_and_point(s):
    """A small point pair and a distant point: a circle."""
    a = s.position()
    first = s.made("point_pair", a, a + s.direction() * s.radius())
    second = s.made("point", a + s.direction() * s.large)
    ends, p = read_pair(first), read_point(second)
    return first, second, euclid.circle_through(*ends, p)


def circle_and_point(s):
    """A small circle and a distant point: a sphere, by points of the circle."""
    first, c, n, r = s.small_circle()
    second = s.made("point", c + s.aslant(n) * s.large)
    return first, second, euclid.sphere_through(*points_of(read_circle(first)), read_point(second))


def large_circle_and_point(s):
    """A large circle and a point near it: a sphere."""
    n, radius = s.direction(), s.large_radius()
    at = s.position()
    first, second = s.made("circle", at + s.across(n) * radius, n, radius), s.made("point", at + s.aslant(n) * s.size)
    return first, second, euclid.sphere_through(*points_of(read_circle(first)), read_point(second))


def points(s):
    """Two distant points."""
    a = s.position()
    first, second = s.made("point", a), s.made("point", a + s.direction() * s.large)
    return first, second, euclid.pair_through(read_point(first), read_point(second))


# Reflections.


def sphere_in_sphere(first, second):
    """The inversion of a sphere in a sphere."""
    (c, r), (m, q) = first, second
    gap = minus(c, m)
    power = dot(gap, gap) - r * r
    return euclid.sphere(add(m, gap, q * q / power), (r * q * q / power) ** 2)


def small_in_large(s):
    c, r = s.position(), s.radius()
    first, second = s.made("sphere", c, r), s.large_sphere(c + s.direction() * s.size * s.random.uniform(0.0, 2.0))
    return first, second, sphere_in_sphere(read_sphere(first), read_sphere(second))


def large_in_small(s):
    """The large sphere passes near the center of the small one."""
    c, r, n = s.position(), s.radius(), s.direction()
    second = s.made("sphere", c, r)
    first = s.large_sphere(c + n * r * s.random.uniform(0.3, 1.5), n)
    return first, second, sphere_in_sphere(read_sphere(first), read_sphere(second))


def point_in_large(s):
    p = s.position()
    first, second = s.made("point", p), s.large_sphere(p + s.direction() * s.size * s.random.uniform(0.1, 2.0))
    return first, second, euclid.point(euclid.inverted(read_point(first), read_sphere(second)))


def circle_in_large(s):
    first, c, _, _ = s.small_circle()
    second = s.large_sphere(c + s.direction() * s.size * s.random.uniform(0.0, 2.0))
    mirror = read_sphere(second)
    return first, second, euclid.circle_through(*(euclid.inverted(p, mirror) for p in points_of(read_circle(first))))


TABLES = {
    "meet": {"spheres": spheres, "spheres apart": spheres_apart, "circle, sphere": circle_sphere,
             "circle, sphere through points": circle_sphere_through, "sphere, large circle": sphere_large_circle,
             "line, large sphere": line_large_sphere, "tangent spheres": tangent_spheres, "circle on a sphere": circle_on_sphere},
    "join": {"pair, point": pair_and_point, "circle, point": circle_and_point, "large circle, point": large_circle_and_point,
             "points": points},
    "reflect_in": {"small in large": small_in_large, "large in small": large_in_small, "point in large": point_in_large,
                   "circle in large": circle_in_large},
}
