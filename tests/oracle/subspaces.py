"""meet and join as intersection and sum of subspaces of R^5, without a metric: blades are outer products (clifford's) of
known vectors, so their intersection is known too. All grades and overlaps; the intersection may be a point, a direction
or another null blade, where the products of conformal algebra degenerate.
"""

import numpy as np
from clifford import g3c

from bivectors import BLADES, LAYOUT, vector

ORACLE = "subspaces"
CASES = 40
# Some of any vectors are spheres as large as planets, some are nearly points.
KINDS = ("any vectors", "points", "points and infinity")
BOUND = 1e-12
E_INFINITY, E_ORIGIN = vector([0, 0, 0, 1, 1]), vector([0, 0, 0, -0.5, 0.5])


def check(library, report, seed):
    """Runs the checks of this file."""
    random = np.random.default_rng([seed, 100])
    for kind in KINDS:
        for operation in ("meet", "join"):
            left, right, expected = zip(*cases(random, kind, operation))
            weights = random.choice([-1.0, 1.0], (len(left), 1)) * 10.0 ** random.uniform(-6.0, 6.0, (len(left), 1))
            ours = library.incidence(operation, np.array(left) * weights, np.array(right) / weights)
            report.check(ORACLE, f"{operation} of blades of {kind}", errors(ours, np.array(expected)), BOUND)
    check_rejected(library, report, random)


def cases(random, kind, operation):
    """(A, B, their intersection or sum), for all grades and overlaps."""
    for a in range(1, 6):
        for b in range(1, 6):
            for shared in range(max(0, a + b - 5), min(a, b) + 1):
                for _ in range(CASES if (a, b) != (5, 5) else 5):
                    factors = vectors(random, kind, a + b - shared)
                    common, own, other = factors[:shared], factors[shared:a], factors[a:]
                    yield (outer(mixed(random, common + own)), outer(mixed(random, common + other)),
                           outer(common if operation == "meet" else factors))


def vectors(random, kind, count):
    """Well separated vectors, in random order."""
    while True:
        found = [random_vector(random, kind) for _ in range(count)]
        if kind == "points and infinity" and count:
            found[int(random.integers(count))] = E_INFINITY
        rows = np.array([x[1:6] / np.linalg.norm(x) for x in found])
        if count == 0 or np.linalg.svd(rows)[1][-1] > 0.1:
            return found


def random_vector(random, kind):
    if kind == "any vectors":
        return vector(random.standard_normal(5))
    position = random.standard_normal(3)
    return vector([*position, (position @ position - 1) / 2, (position @ position + 1) / 2])


def mixed(random, factors):
    """Other vectors that span the same subspace."""
    if not factors:
        return factors
    while True:
        matrix = random.standard_normal((len(factors), len(factors)))
        if np.linalg.cond(matrix) < 10.0:
            return list(matrix @ np.array(factors))


def outer(factors):
    blade = np.eye(BLADES)[0]
    for factor in factors:
        blade = LAYOUT.omt_func(blade, factor)
    return blade


def errors(ours, expected):
    """Errors of blades up to weight and sign."""
    found = ours / np.linalg.norm(ours, axis=1, keepdims=True)
    right = expected / np.linalg.norm(expected, axis=1, keepdims=True)
    worst = np.minimum(np.abs(found - right).max(axis=1), np.abs(found + right).max(axis=1))
    return np.where(np.isnan(worst), np.inf, worst)


def check_rejected(library, report, random):
    """Operands that are not blades are rejected."""
    blade = np.tile(outer(vectors(random, "points", 3)), (CASES, 1))
    others = np.array([np.where(np.array(LAYOUT.gradeList) == 2, random.standard_normal(BLADES), 0.0) for _ in range(CASES // 2)])
    others = np.concatenate([others, random.standard_normal((CASES - len(others) - 2, BLADES)), np.zeros((1, BLADES)), np.full((1, BLADES), np.nan)])
    for operation in ("meet", "join", "project_onto", "reject_from", "reflect_in"):
        successes = []
        for left, right in ((blade, others), (others, blade)):
            results, reasons = library.incidence_with_reasons(operation, left, right)
            successes += [bool(reason) and np.isnan(result).all() for result, reason in zip(results, reasons)]
        report.count(ORACLE, f"{operation} of elements that are not blades is rejected", successes)
