"""exp, log, sqrt, powers, inverse and normalization of multivectors, compared with matrices at 50 digits (gamma.py).

Logarithms are checked by the exponential of their matrices, roots by their powers; logarithms of motors also by the
exact logarithm of exponentials.py, part by part.
"""

import mpmath
import numpy as np
from mpmath import mpf

import exponentials
import gamma
from bivectors import BLADES, GRADES, LAYOUT, general_bivectors, motor_bivector, motor_log, plane, random_versor, vector
from poses import random_poses

ORACLE = "mpmath, double"
BOUND = 1e-13
EACH = 12  # of each kind of general bivector
MOTORS = 150
ELEMENTS = 300
# (p, q): the q-th power of power(M, p / q) is the p-th power of M.
FRACTIONS = ((1, 2), (1, 3), (-1, 2), (-2, 3), (5, 2), (1, 7), (2, 1), (-1, 1), (0, 1))


def check(library, report, seed):
    """Runs the checks of this file."""
    random = np.random.default_rng([seed, 50])
    check_motors(library, report, random)
    check_general(library, report, random)
    check_weights(library, report, random)
    check_inverse(library, report, random)
    check_normalized(library, report, random)
    check_rejected(library, report, random)


def check_motors(library, report, random):
    """The grid of exponentials.py, as multivectors."""
    logs = exponentials.grid(random)
    bivectors = np.array([motor_bivector(log) for log in logs])
    motors = library.unary("exp", bivectors)
    errors, pose_errors = [], []
    for motor, bivector, log in zip(motors, bivectors, logs):
        errors.append(gamma.distance(motor, gamma.exponential(gamma.matrix_of(bivector))))
        pose_errors.append(exponentials.pose_error(pose_of(motor), *exponentials.exponential(log)))
    report.check(ORACLE, "exp of motor bivectors", errors, BOUND)
    report.check(ORACLE, "exp of motor bivectors, as poses", pose_errors, BOUND)

    exact_logs = [exponentials.logarithm(pose_of(motor)) for motor in motors]
    ours = library.unary("log", motors)
    outside = [np.abs(element - motor_bivector(motor_log(element))).max() for element in ours]
    report.check(ORACLE, "log of motors has only motor coefficients", outside / np.abs(ours).max(axis=1).clip(1e-300), BOUND)
    ours = np.array([motor_log(element) for element in ours])
    for part, numbers in (("rotation", slice(0, 3)), ("translation", slice(3, 6)), ("scale", slice(6, 7))):
        errors = [exponentials.relative(log[numbers], exact[numbers]) for log, exact in zip(ours, exact_logs)]
        report.check(ORACLE, f"log of motors, {part}", errors, BOUND)
    check_powers(library, report, "motors", motors)


def pose_of(motor):
    """The exact pose t1 t2 t3 qw qx qy qz s of a motor's doubles, by the polynomials A, B and V of its coefficients."""
    m = [mpf(float(x)) for x in motor]
    scalar, e12, e13, e14, e23, e24, e34, e45 = (m[i] for i in (0, 6, 7, 8, 10, 11, 13, 15))
    e1234, e1245, e1345, e2345 = (m[i] for i in (26, 28, 29, 30))
    a = [scalar + e45, e12 + e1245, e13 + e1345, e23 + e2345]
    b = [scalar - e45, e12 - e1245, e13 - e1345, e23 - e2345]
    square = sum(x * x for x in a)
    t1 = -2 * (e14 * a[0] + e24 * a[1] + e34 * a[2] + e1234 * a[3]) / square
    t2 = -2 * (e24 * a[0] - e14 * a[1] + e34 * a[3] - e1234 * a[2]) / square
    t3 = -2 * (e34 * a[0] - e14 * a[2] - e24 * a[3] + e1234 * a[1]) / square
    length = mpmath.sqrt(square)
    scale = mpmath.sqrt(sum(x * x for x in b)) / length
    return [t1, t2, t3, a[0] / length, -a[3] / length, a[2] / length, -a[1] / length, scale]


def check_general(library, report, random):
    """Bivectors of all kinds in Cl(4,1), and their versors."""
    bivectors = np.array([element for _, element in general_bivectors(random, EACH)])
    exact = [gamma.exponential(gamma.matrix_of(bivector)) for bivector in bivectors]
    errors = [gamma.distance(ours, expected) for ours, expected in zip(library.unary("exp", bivectors), exact)]
    report.check(ORACLE, "exp of general bivectors", errors, BOUND)

    versors = np.array([[float(x) for x in gamma.coefficients_of(matrix)] for matrix in exact])
    check_log(library, report, "general versors", versors)
    check_powers(library, report, "general versors", versors)
    products = np.array([random_versor(random, factors) for factors in (2, 4) for _ in range(EACH * 5)])
    products = products[np.array([norm_squared(x) > 0.0 for x in products])]
    check_log(library, report, "products of vectors", products)
    check_powers(library, report, "products of vectors", products)

    others = random.standard_normal((EACH * 5, BLADES)) * 10.0 ** random.uniform(-3.0, 0.5, (EACH * 5, 1))
    exact = [gamma.exponential(gamma.matrix_of(element)) for element in others]
    # The condition number of exp(X) is |X|: errors are relative to it.
    errors = [gamma.distance(ours, expected) / max(1.0, np.linalg.norm(element))
              for ours, expected, element in zip(library.unary("exp", others), exact, others)]
    report.check(ORACLE, "exp of elements of all grades", errors, BOUND)


def check_log(library, report, name, versors):
    """exp(log(M)) is M or -M, whichever has a scalar part that is not negative."""
    errors = [np.inf if np.isnan(log).any() else gamma.distance(with_positive_scalar(versor), gamma.exponential(gamma.matrix_of(log)))
              for versor, log in zip(versors, library.unary("log", versors))]
    report.check(ORACLE, f"exp(log(M)) of {name}", errors, BOUND)


def check_powers(library, report, name, versors):
    """Rational powers, checked by integer powers."""
    for numerator, denominator in FRACTIONS:
        ours = library.power(versors, np.full(len(versors), numerator / denominator))
        errors = [power_error(x, with_positive_scalar(versor), numerator, denominator) for x, versor in zip(ours, versors)]
        report.check(ORACLE, f"power {numerator}/{denominator} of {name}", errors, BOUND)
    errors = [power_error(x, with_positive_scalar(versor), 1, 2) for x, versor in zip(library.unary("sqrt", versors), versors)]
    report.check(ORACLE, f"sqrt of {name}", errors, BOUND)


def power_error(ours, versor, numerator, denominator):
    """Relative to the largest norm that the product can have, which bounds its rounding, and to the condition number
    |M| |M^-1|, the effect of rounding M (1 for a rotation)."""
    if np.isnan(ours).any():
        return float("inf")
    root, matrix = gamma.matrix_of(ours), gamma.matrix_of(versor)
    exact = gamma.power(matrix, numerator)
    condition = gamma.size(matrix) ** 2 / abs(norm_squared(versor))
    sizes = gamma.size(root) ** denominator, gamma.size(exact)
    difference = gamma.size(gamma.plus(gamma.power(root, denominator), exact, -1))
    return float(difference / max(sizes) / condition) / denominator


def with_positive_scalar(versor):
    return -versor if versor[0] < 0.0 else versor


def norm_squared(element):
    return LAYOUT.gmt_func(element, (~LAYOUT.MultiVector(element)).value)[0]


def check_weights(library, report, random):
    """Versors of any weight: it becomes the scalar part of the logarithm and a factor of powers."""
    weights = 10.0 ** random.uniform(-6.0, 6.0, MOTORS) * random.choice([-1.0, 1.0], MOTORS)
    motors = library.motor(random_poses(random, MOTORS, 2.0)) * weights[:, None]
    check_log(library, report, "motors of any weight", motors)
    for numerator, denominator in ((1, 2), (-3, 2)):
        ours = library.power(motors, np.full(MOTORS, numerator / denominator))
        errors = [power_error(x, with_positive_scalar(motor), numerator, denominator) for x, motor in zip(ours, motors)]
        report.check(ORACLE, f"power {numerator}/{denominator} of motors of any weight", errors, BOUND)


def check_inverse(library, report, random):
    """Errors relative to the condition number |X| |X^-1|, the effect of rounding X."""
    elements = random.standard_normal((ELEMENTS, BLADES)) * 10.0 ** random.uniform(-9.0, 9.0, (ELEMENTS, 1))
    elements[1::4] *= np.isin(GRADES, [0, 2, 4])
    elements[2::4] *= np.isin(GRADES, [0, 1])
    elements[3::4] *= random.uniform(size=(len(elements[3::4]), BLADES)) < 0.3
    errors = []
    for element, ours in zip(elements, library.unary("inverse", elements)):
        exact = gamma.inverse(gamma.matrix_of(element))
        if exact is None or np.isnan(ours).any():
            errors.append(0.0 if exact is None and np.isnan(ours).any() else np.inf)
        else:
            errors.append(gamma.distance(ours, exact) / float(gamma.size(exact) * gamma.size(gamma.matrix_of(element))))
    report.check(ORACLE, "inverse of elements of all grades", errors, 1e-15)


def check_normalized(library, report, random):
    """X = P X' with X' X'~ = 1 and P of grades 0 and 4: the polar decomposition, unique near X."""
    motors = library.motor(random_poses(random, MOTORS, 2.0)) * 10.0 ** random.uniform(-3.0, 3.0, (MOTORS, 1))
    noise = random.standard_normal(motors.shape) * 10.0 ** random.uniform(-15.0, -3.0, (MOTORS, 1))
    noisy = motors + np.isin(GRADES, [0, 2, 4]) * noise * np.abs(motors).max(axis=1, keepdims=True)
    for name, elements in (("motors", motors), ("noisy motors", noisy)):
        errors = []
        for element, ours in zip(elements, library.unary("normalized", elements)):
            reverse = (~LAYOUT.MultiVector(ours)).value
            matrix, reversed_matrix = gamma.matrix_of(ours), gamma.matrix_of(reverse)
            size = gamma.size(matrix) ** 2
            unit = gamma.size(gamma.plus(gamma.times(matrix, reversed_matrix), gamma.IDENTITY, -1)) / size
            factor = gamma.coefficients_of(gamma.times(gamma.matrix_of(element), reversed_matrix))
            largest = gamma.size(gamma.matrix_of(element)) * gamma.size(matrix)
            outside = max(abs(x) for x, grade in zip(factor, gamma.GRADES) if grade not in (0, 4)) / largest
            errors.append(float(max(unit, outside)) if factor[0] > 0 else np.inf)
        report.check(ORACLE, f"normalized of {name}", errors, BOUND)


def check_rejected(library, report, random):
    """Operands without a result: an error and NaN."""
    e_infinity, one = vector([0, 0, 0, 1, 1]), np.eye(BLADES)[0]
    unit = vector([0.6, 0.8, 0, 0, 0])
    null = [vector([*x, (x @ x - 1) / 2, (x @ x + 1) / 2]) for x in random.standard_normal((20, 3))]
    singular = [np.zeros(BLADES), e_infinity, one + unit, one - unit, *null]
    odd = [random_versor(random, factors) for factors in (1, 3, 5) for _ in range(5)]
    backward = [LAYOUT.gmt_func(unit, vector([0, 0, 0.3, 0.2, 1.5]))]
    mixed_grades = list(random.standard_normal((5, BLADES)))
    not_finite = [vector([np.inf, 0, 0, 0, 0]), np.full(BLADES, np.nan)]
    for name, elements in (
        ("inverse", singular + not_finite),
        ("normalized", [np.zeros(BLADES), e_infinity, *null, *not_finite]),
        ("log", [*singular, *odd, *backward, *mixed_grades, *not_finite]),
        ("sqrt", [*singular, *odd, *backward, *mixed_grades, *not_finite]),
        ("exp", [one * 800.0, plane(1, 5, 800.0), plane(4, 5, 1e4), *not_finite]),
    ):
        results, reasons = library.unary_with_reasons(name, elements)
        successes = [bool(reason) and np.isnan(result).all() for result, reason in zip(results, reasons)]
        report.count(ORACLE, f"{name} rejected with a reason", successes)

