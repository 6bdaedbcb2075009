"""Conformal geometry of the package `clifford`: classification, meet, join, inverse, and logarithms of motors.

Its general_logarithm is wrong at half turns and inaccurate near them and near the identity (it divides by squares of
parts), so angles and log-scales are 0.1 .. 3 here; versors.py has the rest. Its `vee` uses complements instead of duals,
so it differs by the signs of reversion. Its `interpret_multivector_as_object` returns wrong kinds and is not used.
"""

import numpy as np
from clifford import g3c
from clifford.tools import classify as classifier
from clifford.tools import g3c as tools
from clifford.tools.g3c.rotor_parameterisation import general_logarithm

from bivectors import BLADES, GRADES, LAYOUT
from scenes import Scene
from subspaces import errors as direction_errors

ORACLE = "clifford"
CASES = 300
BOUND = 1e-12
MEET_BOUND = 1e-11  # random points, some close to each other


def check(library, report, seed):
    """Runs the checks of this file."""
    random = np.random.default_rng([seed, 110])
    check_inverse(library, report, random)
    check_motors(library, report, random)
    check_classify(library, report, random)
    check_meet(library, report, random)


def check_inverse(library, report, random):
    """clifford solves linear equations; errors are relative to the condition number."""
    elements = random.standard_normal((CASES, BLADES))
    errors = []
    for ours, element in zip(library.unary("inverse", elements), elements):
        expected = LAYOUT.MultiVector(element).leftLaInv().value
        errors.append(np.linalg.norm(ours - expected) / np.linalg.norm(expected) ** 2 / np.linalg.norm(element))
    report.check(ORACLE, "inverse of random elements", errors, BOUND)
    errors = []
    for i, j in ((i, j) for i in range(6) for j in range(5 - i, 6)):
        left, right = random.standard_normal((2, 10, BLADES)) * np.array([GRADES == i, GRADES == j])[:, None]
        sign = reversion(i) * reversion(j) * reversion(10 - i - j)
        expected = [sign * (LAYOUT.MultiVector(a) & LAYOUT.MultiVector(b)).value for a, b in zip(left, right)]
        errors += list(np.abs(library.binary("regressive product", left, right) - np.array(expected)).max(axis=1))
    report.check(ORACLE, "regressive product, up to sign", errors, BOUND)


def reversion(grade):
    return (-1) ** (grade * (grade - 1) // 2)


def check_motors(library, report, random):
    """Poses and logarithms of products of clifford's translators, rotors and dilators."""
    axes, offsets = random.standard_normal((2, CASES, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    angles = random.uniform(0.1, 3.0, CASES)
    scales = np.exp(random.uniform(0.1, 2.0, CASES) * random.choice([-1.0, 1.0], CASES))
    motors, logs = [], []
    for axis, offset, angle, scale in zip(axes, offsets, angles, scales):
        motor = (tools.generate_translation_rotor(euclidean(offset))
                 * tools.generate_rotation_rotor(angle, *plane_vectors(axis)) * tools.generate_dilation_rotor(scale))
        motors.append(motor.value)
        logs.append(general_logarithm(motor).value)
    poses = library.extract(motors)
    quaternions = np.hstack([np.cos(angles / 2)[:, None], axes * np.sin(angles / 2)[:, None]])
    expected = np.hstack([offsets, quaternions, scales[:, None]])
    report.check(ORACLE, "translation, rotation and scale of T R D", np.abs(poses - expected).max(axis=1) / scales.clip(1.0), BOUND)
    errors = np.abs(library.unary("log", motors) - np.array(logs)).max(axis=1) / np.abs(logs).max(axis=1)
    report.check(ORACLE, "log of motors with angles up to 3", errors, BOUND)


def euclidean(numbers):
    return sum(float(x) * e for x, e in zip(numbers, (g3c.e1, g3c.e2, g3c.e3)))


def plane_vectors(axis):
    """Two vectors orthogonal to an axis, right-handed with it."""
    first = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    first /= np.linalg.norm(first)
    return euclidean(first), euclidean(np.cross(axis, first))


# Kinds of objects by the names of clifford's classes.
NAMES = {"Point": "point", "PointPair": "point_pair", "Circle": "circle", "Sphere": "sphere", "PointFlat": "flat_point",
         "Line": "line", "Plane": "plane"}


def check_classify(library, report, random):
    """Outer products of points, with and without e_inf, real and imaginary."""
    elements, expected = [], []
    for i in range(CASES):
        scene = Scene(random, 1.0, 1.0)
        count = 1 + i % 4
        blade = LAYOUT.scalar
        for point in scene.sphere_points()[:count]:
            blade = blade ^ g3c.up(euclidean(point))
        if i % 3 == 1 and count < 4:
            blade = blade ^ g3c.einf
        if i % 3 == 2 and count > 1:
            found = classifier.classify(blade)
            blade = type(found)(found.direction, found.location, found.radius * 1j).mv
        elements.append(blade.value)
        expected.append(classifier.classify(blade))
    errors = [class_error(found, right) for found, right in zip(library.classify(elements), expected)]
    report.check(ORACLE, "classify", errors, BOUND)


def class_error(found, right):
    name = type(right).__name__
    if NAMES.get(name) != found["kind"]:
        return np.inf
    worst = 0.0 if name == "Plane" else np.abs(found["center"] - vector_of(right.location)).max()
    if name == "Plane":
        worst = abs(found["normal"] @ vector_of(right.location) - found["distance"])
    if isinstance(right, classifier.Round) and name != "Point":
        if found["imaginary"] != (abs(np.imag(right.radius)) > 0.0):
            return np.inf
        worst = max(worst, abs(found["radius"] - abs(right.radius)))
    if name in ("Circle", "Plane", "PointPair", "Line"):
        element = right.direction * g3c.e123 if name in ("Circle", "Plane") else right.direction
        expected = vector_of(element)
        ours = found["normal" if name in ("Circle", "Plane") else "direction"]
        worst = max(worst, np.linalg.norm(np.cross(ours, expected)) / np.linalg.norm(expected))
    return worst


def vector_of(element):
    return element.value[1:4] if hasattr(element, "value") else np.zeros(3)


def check_meet(library, report, random):
    """Blades of random points: independent ones, whose join is the outer product (with common points, clifford's join
    divides by zero), and ones that span the whole space, whose meet is the regressive product."""
    for name in ("join", "meet"):
        left, right, expected = [], [], []
        for i in range(CASES):
            a = 1 + i % 4
            points = [g3c.up(euclidean(x)) for x in random.standard_normal((5, 3))]
            first, second = product(points[:a]), product(points[a if name == "join" else a - 1 :])
            expected.append((first.join(second) if name == "join" else first.meet(second, LAYOUT.pseudoScalar)).value)
            left.append(first.value)
            right.append(second.value)
        report.check(ORACLE, f"{name} of blades of points", direction_errors(library.incidence(name, left, right), np.array(expected)), MEET_BOUND)


def product(factors):
    """The outer product."""
    blade = LAYOUT.scalar
    for factor in factors:
        blade = blade ^ factor
    return blade
