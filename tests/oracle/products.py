"""Products, involutions, duals, inverses, sandwiches and motors, compared with the Python package `clifford`."""

import clifford
import numpy as np
from clifford import g3c

from library import BLADES
from poses import matrices_of, random_poses

BOUND = 1e-12
RANDOM_PAIRS = 1000
LAYOUT = g3c.layout
SCALAR = np.eye(BLADES)[0]


def check(library, report, seed):
    """Runs the checks of this file."""
    names = [LAYOUT.names[i] for i in range(BLADES)]
    assert names[1] == "e1" and names[6] == "e12" and names[31] == "e12345" and list(LAYOUT.sig) == [1, 1, 1, 1, -1]
    random = np.random.default_rng([seed, 20])
    basis = np.eye(BLADES)
    every_left, every_right = np.repeat(basis, BLADES, axis=0), np.tile(basis, (BLADES, 1))
    left, right = random.standard_normal((2, RANDOM_PAIRS, BLADES))
    sizes = np.linalg.norm(left, axis=1) * np.linalg.norm(right, axis=1)
    for name, function in PRODUCTS.items():
        exact = np.array([function(a, b) for a, b in zip(every_left, every_right)])
        ours = library.binary(name, every_left, every_right)
        report.check("clifford", f"{name} of basis blades", np.abs(ours - exact).max(axis=1), 0.0)
        exact = np.array([function(a, b) for a, b in zip(left, right)])
        errors = relative(library.binary(name, left, right), exact, sizes)
        report.check("clifford", f"{name} of random elements", errors, BOUND)
    for name, function in OPERATIONS.items():
        operands = np.concatenate([basis, left])
        exact = np.array([function(element(x)).value for x in operands])
        errors = relative(library.unary(name, operands), exact, np.linalg.norm(operands, axis=1))
        report.check("clifford", name, errors, BOUND)
    check_versors(library, report, random)
    check_motors(library, report, random)


def check_versors(library, report, random):
    """Inverses and sandwiches of products of one to five vectors; odd ones with the grade involution."""
    versors, operands, inverses, images = [], [], [], []
    for i in range(RANDOM_PAIRS):
        versor = element(SCALAR)
        factors = 1 + i % 5
        for _ in range(factors):
            vector = random.standard_normal(5)
            vector[4] *= 0.3  # away from null vectors
            versor = versor * sum(c * e for c, e in zip(vector, LAYOUT.blades_of_grade(1)))
        operand = element(random.standard_normal(BLADES))
        inverse = versor.hitzer_inverse()
        versors.append(versor.value)
        operands.append(operand.value)
        inverses.append(inverse.value)
        images.append((versor * (operand.gradeInvol() if factors % 2 else operand) * inverse).value)
    errors = relative(library.unary("inverse", versors), np.array(inverses))
    report.check("clifford", "inverse of versors", errors, BOUND)
    errors = relative(library.binary("sandwich", versors, operands), np.array(images))
    report.check("clifford", "sandwich with even and odd versors", errors, BOUND)


def check_motors(library, report, random):
    """Motors applied to clifford's conformal points, compared with matrices; extraction for any weight."""
    poses = random_poses(random, RANDOM_PAIRS)
    points = random.standard_normal((RANDOM_PAIRS, 3)) * 3.0
    motors = library.motor(poses)
    exact = np.einsum("nij,nj->ni", matrices_of(poses)[:, :, :3], points) + matrices_of(poses)[:, :, 3]
    images = []
    for motor, position in zip(motors, points):
        versor = element(motor)
        conformal = g3c.up(sum(c * e for c, e in zip(position, [g3c.e1, g3c.e2, g3c.e3])))
        images.append(g3c.down(versor * conformal * ~versor).value[1:4])
    # down() divides by a weight, which is a difference of numbers as large as the squared distance.
    size = 1.0 + np.sum(exact**2, axis=1)
    report.check("clifford", "motors move conformal points", np.linalg.norm(np.array(images) - exact, axis=1) / size**1.5, 1e-11)
    weights = 10.0 ** random.uniform(-3.0, 3.0, (RANDOM_PAIRS, 1)) * random.choice([-1.0, 1.0], (RANDOM_PAIRS, 1))
    extracted = library.extract(motors * weights)
    errors = np.abs(matrices_of(extracted) - matrices_of(poses)).max(axis=(1, 2))
    report.check("numpy, double", "poses of motors of any weight", errors / np.abs(matrices_of(poses)).max(axis=(1, 2)), BOUND)


def element(value):
    return clifford.MultiVector(LAYOUT, np.array(value, float))


def relative(ours, exact, sizes=1e-300):
    """The largest difference of each row, relative to its largest coefficient or to `sizes` if those are larger."""
    return np.abs(ours - exact).max(axis=1) / np.maximum(np.abs(exact).max(axis=1), sizes)


def fat_dot(left, right):
    """The inner product with scalars, which clifford's inner product excludes."""
    a, b = left[0], right[0]
    return LAYOUT.imt_func(left - a * SCALAR, right - b * SCALAR) + a * right + b * left - a * b * SCALAR


def right_contraction(left, right):
    """(b~ left-contract a~)~"""
    return (~((~element(right)).lc(~element(left)))).value


def regressive(left, right):
    """undual(dual(A) ^ dual(B)), by clifford's products."""
    dual = LAYOUT.pseudoScalar.inv()
    return (((element(left) * dual) ^ (element(right) * dual)) * LAYOUT.pseudoScalar).value


PRODUCTS = {
    "geometric product": LAYOUT.gmt_func,
    "outer product": LAYOUT.omt_func,
    "inner product": fat_dot,
    "left contraction": lambda left, right: element(left).lc(element(right)).value,
    "right contraction": right_contraction,
    "scalar product": lambda left, right: LAYOUT.gmt_func(left, right)[0] * SCALAR,
    "regressive product": regressive,
    "commutator product": lambda left, right: element(left).commutator(element(right)).value,
}

OPERATIONS = {
    "reverse": lambda x: ~x,
    "grade involution": lambda x: x.gradeInvol(),
    "clifford conjugate": lambda x: x.conjugate(),
    "dual": lambda x: x * LAYOUT.pseudoScalar.inv(),
    "undual": lambda x: x * LAYOUT.pseudoScalar,
    "norm squared": lambda x: element((x * ~x).value[0] * SCALAR),
    "norm": lambda x: element(np.sqrt(abs((x * ~x).value[0])) * SCALAR),
}
