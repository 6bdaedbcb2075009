"""What `clifford` knows of conformal geometry: its classification, meet, join, inverse, and logarithms of motors.

Its general_logarithm is wrong at half a turn and loses digits next to it and next to no turn (it divides by the squares
of its parts), so it is asked where angle and log-scale are 0.1 .. 3; versors.py has the rest. Its `vee` is made
with complements, not with duals, so it differs by the signs of reversion. `interpret_multivector_as_object` misnames objects and is not used.
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
MEET_BOUND = 1e-11  # of points as they fall, some close to each other


def check(library, report, seed):
    """Everything of this file."""
    random = np.random.default_rng([seed, 110])
    check_inverse(library, report, random)
    check_motors(library, report, random)
    check_classify(library, report, random)
    check_meet(library, report, random)


def check_inverse(library, report, random):
    """By linear equations; relative to the condition."""
    elements = random.standard_normal((CASES, BLADES))
    errors = []
    for ours, element in zip(library.unary("inverse", elements), elements):
        wanted = LAYOUT.MultiVector(element).leftLaInv().value
        errors.append(np.linalg.norm(ours - wanted) / np.linalg.norm(wanted) ** 2 / np.linalg.norm(element))
    report.check(ORACLE, "inverse of random elements", errors, BOUND)
    errors = []
    for i, j in ((i, j) for i in range(6) for j in range(5 - i, 6)):
        left, right = random.standard_normal((2, 10, BLADES)) * np.array([GRADES == i, GRADES == j])[:, None]
        sign = reversion(i) * reversion(j) * reversion(10 - i - j)
        wanted = [sign * (LAYOUT.MultiVector(a) & LAYOUT.MultiVector(b)).value for a, b in zip(left, right)]
        errors += list(np.abs(library.binary("regressive product", left, right) - np.array(wanted)).max(axis=1))
    report.check(ORACLE, "regressive product, up to its signs", errors, BOUND)


def reversion(grade):
    return (-1) ** (grade * (grade - 1) // 2)


def check_motors(library, report, random):
    """clifford's T, R and D: poses, and logarithms."""
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
    wanted = np.hstack([offsets, quaternions, scales[:, None]])
    report.check(ORACLE, "translation, rotation and scale of T R D", np.abs(poses - wanted).max(axis=1) / scales.clip(1.0), BOUND)
    errors = np.abs(library.unary("log", motors) - np.array(logs)).max(axis=1) / np.abs(logs).max(axis=1)
    report.check(ORACLE, "log of motors away from half turns", errors, BOUND)


def euclidean(numbers):
    return sum(float(x) * e for x, e in zip(numbers, (g3c.e1, g3c.e2, g3c.e3)))


def plane_vectors(axis):
    """Two vectors across an axis, right-handed with it."""
    first = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    first /= np.linalg.norm(first)
    return euclidean(first), euclidean(np.cross(axis, first))


# clifford's class of an object, and what it is called here.
NAMES = {"Point": "point", "PointPair": "point_pair", "Circle": "circle", "Sphere": "sphere", "PointFlat": "flat_point",
         "Line": "line", "Plane": "plane"}


def check_classify(library, report, random):
    """Outer products of points, with e_inf and without, real and imaginary."""
    elements, wanted = [], []
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
        wanted.append(classifier.classify(blade))
    errors = [class_error(found, right) for found, right in zip(library.classify(elements), wanted)]
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
        wanted = vector_of(element)
        ours = found["normal" if name in ("Circle", "Plane") else "direction"]
        worst = max(worst, np.linalg.norm(np.cross(ours, wanted)) / np.linalg.norm(wanted))
    return worst


def vector_of(element):
    return element.value[1:4] if hasattr(element, "value") else np.zeros(3)


def check_meet(library, report, random):
    """Blades of random points that span at most the space together, where clifford's join is the outer product (where
    blades share points it ends in a division by zero), and blades whose meet is the regressive product."""
    for name in ("join", "meet"):
        left, right, wanted = [], [], []
        for i in range(CASES):
            a = 1 + i % 4
            points = [g3c.up(euclidean(x)) for x in random.standard_normal((5, 3))]
            first, second = product(points[:a]), product(points[a if name == "join" else a - 1 :])
            wanted.append((first.join(second) if name == "join" else first.meet(second, LAYOUT.pseudoScalar)).value)
            left.append(first.value)
            right.append(second.value)
        report.check(ORACLE, f"{name} of blades of points", direction_errors(library.incidence(name, left, right), np.array(wanted)), MEET_BOUND)


def product(factors):
    """The outer product."""
    blade = LAYOUT.scalar
    for factor in factors:
        blade = blade ^ factor
    return blade
