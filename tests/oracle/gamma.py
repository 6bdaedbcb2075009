"""Cl(4,1) at 50 digits, as complex 4 x 4 matrices: an element is a sum of products of five matrices that anticommute
and whose squares are 1, 1, 1, 1, -1. Exponentials, powers and inverses are those of matrices; the formulas of the C++
code are not used. A matrix is a tuple of 16 mpc in row-major order.
"""

import itertools

import mpmath
from mpmath import mp, mpc, mpf

DIGITS = 50
GRADES = [k for k in range(6) for _ in itertools.combinations(range(5), k)]
SIZE = 4


def times(a, b):
    """The product of two matrices."""
    return tuple(
        sum((a[SIZE * row + k] * b[SIZE * k + column] for k in range(SIZE)), mpc(0))
        for row in range(SIZE) for column in range(SIZE)
    )


def kronecker(a, b):
    """The Kronecker product of two 2 x 2 matrices."""
    return tuple(mpc(a[2 * (r // 2) + c // 2] * b[2 * (r % 2) + c % 2]) for r in range(SIZE) for c in range(SIZE))


ONE, X, Y, Z = (1, 0, 0, 1), (0, 1, 1, 0), (0, -1j, 1j, 0), (1, 0, 0, -1)
IDENTITY = kronecker(ONE, ONE)
VECTORS = (kronecker(X, ONE), kronecker(Y, ONE), kronecker(Z, X), kronecker(Z, Y),
           tuple(1j * x for x in kronecker(Z, Z)))


def basis_matrices():
    """The matrices of the 32 basis blades, in the order of the coefficients."""
    matrices = []
    for k in range(6):
        for factors in itertools.combinations(VECTORS, k):
            blade = IDENTITY
            for factor in factors:
                blade = times(blade, factor)
            matrices.append(blade)
    return matrices


BASIS = basis_matrices()
# (index, entry) of the entries other than zero, one per row: 1, -1, i or -i.
ENTRIES = [[(index, entry) for index, entry in enumerate(blade) if entry != 0] for blade in BASIS]
# B^-1 is the conjugate transpose: the matrices are unitary.
INVERSE_ENTRIES = [[(index, entry.conjugate()) for index, entry in entries] for entries in ENTRIES]


def matrix_of(coefficients):
    """The matrix of 32 numbers, taken as exact."""
    matrix = [mpc(0)] * 16
    for coefficient, entries in zip(coefficients, ENTRIES):
        if coefficient != 0:
            number = coefficient if isinstance(coefficient, mpf) else mpf(float(coefficient))
            for index, entry in entries:
                matrix[index] += number * entry
    return tuple(matrix)


def coefficients_of(matrix):
    """The 32 coefficients: for blade B the scalar part of M B^-1, a quarter of its trace."""
    return [sum((matrix[index] * entry).real for index, entry in entries) / 4 for entries in INVERSE_ENTRIES]


def plus(a, b, factor=1):
    """a + factor b"""
    return tuple(x + factor * y for x, y in zip(a, b))


def scaled(a, factor):
    return tuple(x * factor for x in a)


def size(matrix):
    """The root of the sum of the squared coefficients: half the Frobenius norm."""
    return mpmath.sqrt(sum(abs(x) ** 2 for x in matrix)) / 2


def exponential(matrix):
    """By scaling and squaring of the series."""
    squarings = max(0, int(mpmath.ceil(mpmath.log(size(matrix) + mpf("1e-99"), 2))) + 12)
    small = scaled(matrix, mpf(2) ** -squarings)
    with mp.workdps(DIGITS + 15):
        total, term, k = plus(IDENTITY, small), small, 2
        while size(term) > mpf(10) ** -(DIGITS + 12):
            term = scaled(times(term, small), mpf(1) / k)
            total = plus(total, term)
            k += 1
        for _ in range(squarings):
            total = times(total, total)
    return tuple(+x for x in total)


def inverse(matrix):
    """The inverse; None if the matrix is singular to 50 digits."""
    try:
        inverted = mpmath.matrix([list(matrix[SIZE * r : SIZE * r + SIZE]) for r in range(SIZE)]) ** -1
    except ZeroDivisionError:
        return None
    return tuple(inverted[r, c] for r in range(SIZE) for c in range(SIZE))


def power(matrix, exponent):
    """An integer power, by multiplication."""
    if exponent < 0:
        return power(inverse(matrix), -exponent)
    result = IDENTITY
    for _ in range(exponent):
        result = times(result, matrix)
    return result


def distance(ours, exact):
    """|ours - exact| / |exact| of 32 numbers and a matrix; infinity for NaN."""
    if any(x != x for x in ours):
        return float("inf")
    difference = size(plus(matrix_of(ours), exact, -1))
    expected = size(exact)
    return float(difference / expected) if expected else float(difference)


mp.dps = DIGITS
