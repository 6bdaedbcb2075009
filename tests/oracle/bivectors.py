"""Vectors, bivectors and versors for the oracles, as arrays of 32 numbers."""

import itertools

import numpy as np
from clifford import g3c

LAYOUT = g3c.layout
BLADES = 32
GRADES = np.array(LAYOUT.gradeList)
PAIRS = list(itertools.combinations(range(1, 6), 2))
# The index of e12 .. e45: after the scalar and the vectors.
PLANES = {pair: 6 + i for i, pair in enumerate(PAIRS)}


def plane(first, second, size=1.0):
    """size times e_(first, second)"""
    numbers = np.zeros(BLADES)
    numbers[PLANES[first, second]] = size
    return numbers


def vector(numbers):
    """The vector with these five coefficients."""
    element = np.zeros(BLADES)
    element[1:6] = numbers
    return element


def motor_bivector(log):
    """L = -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E) of a logarithm w1 w2 w3 v1 v2 v3 sigma: exact."""
    w1, w2, w3, *v, sigma = -0.5 * np.asarray(log, float)
    element = plane(2, 3, w1) + plane(1, 3, -w2) + plane(1, 2, w3) + plane(4, 5, sigma)
    for axis, speed in enumerate(v, 1):
        element += plane(axis, 4, speed) + plane(axis, 5, speed)
    return element


def motor_log(element):
    """The logarithm w1 w2 w3 v1 v2 v3 sigma of such a bivector; v from both its e4 and e5 coefficients."""
    speeds = [-(element[PLANES[axis, 4]] + element[PLANES[axis, 5]]) for axis in (1, 2, 3)]
    rotation = [-2 * element[PLANES[2, 3]], 2 * element[PLANES[1, 3]], -2 * element[PLANES[1, 2]]]
    return [*rotation, *speeds, -2 * element[PLANES[4, 5]]]


def random_versor(random, factors):
    """A product of vectors that are not nearly null."""
    versor = np.eye(BLADES)[0]
    for _ in range(factors):
        numbers = random.standard_normal(5)
        numbers[4] *= 0.3
        versor = LAYOUT.gmt_func(versor, vector(numbers / np.linalg.norm(numbers)))
    return versor


def moved(random, bivector):
    """A bivector after a random conformal transformation."""
    versor = LAYOUT.MultiVector(random_versor(random, 4))
    return (versor * LAYOUT.MultiVector(bivector) * versor.hitzer_inverse()).value * (GRADES == 2)


def general_bivectors(random, each):
    """Bivectors of all kinds: (name of the kind, element)."""
    e_infinity, e_origin = vector([0, 0, 0, 1, 1]), vector([0, 0, 0, -0.5, 0.5])
    for i in range(each):
        size = 10.0 ** random.uniform(-6.0, 0.5)
        numbers = np.zeros(BLADES)
        numbers[6:16] = random.standard_normal(10)
        yield "random", numbers * size * 0.5
        angle, other = random.uniform(0.0, np.pi / 2, 2)
        boost = random.uniform(-3.0, 3.0)
        direction = vector([*random.standard_normal(3), 0, 0])
        yield "rotation in a sphere", moved(random, plane(1, 2, angle))
        yield "boost", moved(random, plane(1, 5, boost))
        yield "rotation and boost", moved(random, plane(1, 2, angle) + plane(3, 5, boost))
        yield "two rotations", moved(random, plane(1, 2, angle) + plane(3, 4, other))
        yield "two equal rotations", plane(1, 2, angle) + plane(3, 4, angle * (-1) ** i)
        yield "two nearly equal rotations", plane(1, 2, angle) + plane(3, 4, angle * (1.0 + 10.0 ** random.uniform(-15, -3)))
        yield "transversion", LAYOUT.omt_func(e_origin, direction) * size * 10.0
        yield "null plane", LAYOUT.omt_func(e_infinity, direction) * size * 10.0
        yield "null plane, transformed", moved(random, LAYOUT.omt_func(e_infinity, direction))
        yield "null plane and rotation", LAYOUT.omt_func(e_origin, vector([0, 0, size, 0, 0])) + plane(1, 2, angle)
        yield "nearly null plane", LAYOUT.omt_func(e_infinity, direction) + plane(1, 5, 10.0 ** random.uniform(-14, -3))
        yield "small rotation", plane(1, 2, 10.0 ** random.uniform(-14, -5)) + plane(3, 4, 10.0 ** random.uniform(-14, -5))
        yield "half turn", plane(1, 2, np.pi / 2) + plane(3, 4, other)
        yield "nearly half turn", plane(1, 2, np.pi / 2 - 10.0 ** random.uniform(-14, -3)) + plane(3, 5, boost)
