"""Points, lines, planes, circles and spheres in Euclidean geometry at 50 digits, without conformal algebra.

Vectors are lists of three numbers. Results are dicts of what cga::classify should return: kind, imaginary, center,
radius, direction or normal, distance, points.
"""

import mpmath
from mpmath import mp, mpf

mp.dps = 50


def exact(numbers):
    return [number if isinstance(number, mpf) else mpf(float(number)) for number in numbers]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b, factor=1):
    """a + factor b"""
    return [x + factor * y for x, y in zip(a, b)]


def minus(a, b):
    return add(a, b, -1)


def length(a):
    return mpmath.sqrt(dot(a, a))


def unit(a):
    return [x / length(a) for x in a]


def solve(rows, right):
    """The point x with row . x = number, for three rows."""
    return list(mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix(right)))


# Objects.


def flat_point(position):
    return {"kind": "flat_point", "center": position}


def point(position):
    return {"kind": "point", "center": position}


def line(position, direction):
    """`center` is the point closest to the origin."""
    d = unit(direction)
    return {"kind": "line", "center": add(position, d, -dot(position, d)), "direction": d}


def plane(normal, distance):
    size = length(normal)
    return {"kind": "plane", "normal": unit(normal), "distance": distance / size}


def round_of(kind, center, square, **parts):
    """A round with the square of its radius, which is negative for imaginary rounds."""
    return {"kind": kind, "center": center, "radius": mpmath.sqrt(abs(square)), "imaginary": square < 0, **parts}


def circle(center, normal, square):
    return round_of("circle", center, square, normal=unit(normal))


def sphere(center, square):
    return round_of("sphere", center, square)


def pair(center, direction, square):
    d = unit(direction)
    found = round_of("point_pair", center, square, direction=d)
    if square > 0:
        found["points"] = [add(center, d, -found["radius"]), add(center, d, found["radius"])]
    return found


# Objects through points.


def pair_through(a, b):
    half = [x / 2 for x in minus(b, a)]
    return pair(add(a, half), half, dot(half, half))


def plane_through(a, b, c):
    normal = cross(minus(b, a), minus(c, a))
    return plane(normal, dot(normal, a))


def circle_through(a, b, c):
    """The center is in the plane of the points, at the same distance from all."""
    normal = cross(minus(b, a), minus(c, a))
    rows = [minus(b, a), minus(c, a), normal]
    center = solve(rows, [(dot(b, b) - dot(a, a)) / 2, (dot(c, c) - dot(a, a)) / 2, dot(normal, a)])
    return circle(center, normal, dot(minus(a, center), minus(a, center)))


def sphere_through(a, *others):
    center = solve([minus(b, a) for b in others], [(dot(b, b) - dot(a, a)) / 2 for b in others])
    return sphere(center, dot(minus(a, center), minus(a, center)))


# Intersections. Lines are (point, direction), planes (normal, distance), circles
# (center, normal, radius), spheres (center, radius).


def line_plane(line_, plane_):
    (p, d), (n, k) = line_, plane_
    return flat_point(add(p, d, (k - dot(n, p)) / dot(n, d)))


def plane_plane(first, second):
    (n, k), (m, j) = first, second
    direction = cross(n, m)
    return line(solve([n, m, direction], [k, j, 0]), direction)


def sphere_plane(sphere_, plane_):
    (c, r), (n, k) = sphere_, plane_
    u = unit(n)
    height = k / length(n) - dot(u, c)
    return circle(add(c, u, height), u, r * r - height * height)


def sphere_sphere(first, second):
    (c, r), (b, s) = first, second
    gap = minus(b, c)
    square = dot(gap, gap)
    part = (square + r * r - s * s) / (2 * square)
    return circle(add(c, gap, part), gap, r * r - part * part * square)


def line_sphere(line_, sphere_):
    (p, d), (c, r) = line_, sphere_
    u = unit(d)
    middle = add(p, u, dot(minus(c, p), u))
    height = minus(middle, c)
    return pair(middle, u, r * r - dot(height, height))


def circle_plane(circle_, plane_):
    """Intersects the line of both planes with the sphere that has the circle as its equator."""
    c, n, r = circle_
    common = plane_plane((n, dot(n, c)), plane_)
    return line_sphere((common["center"], common["direction"]), (c, r))


def circle_sphere(circle_, sphere_):
    """Intersects the circle with the plane of the circle in which its sphere and the other one intersect."""
    c, n, r = circle_
    common = sphere_sphere((c, r), sphere_)
    normal = common["normal"]
    return circle_plane(circle_, (normal, dot(normal, common["center"])))


def circle_line(circle_, line_):
    """For a line in the plane of the circle."""
    return line_sphere(line_, (circle_[0], circle_[2]))


# Reflections and inversions.


def foot_on_plane(p, plane_):
    n, k = plane_
    return add(p, n, (k - dot(n, p)) / dot(n, n))


def foot_on_line(p, line_):
    q, d = line_
    return add(q, d, dot(minus(p, q), d) / dot(d, d))


def opposite(p, middle):
    return add(middle, minus(middle, p))


def inverted(p, sphere_):
    c, r = sphere_
    gap = minus(p, c)
    return add(c, gap, r * r / dot(gap, gap))
