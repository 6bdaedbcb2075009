"""The three modes of interpolation, computed by matrices, dual quaternions and poles, in double.

LINEAR blends dual quaternions. SCREW rotates and scales about the pole of the motion between the poses: in the plane
orthogonal to the axis, with complex numbers, the fixed point c of s exp(i theta); along the axis likewise. SEPARATE is
lerp of positions, Rodrigues' rotation, and lerp of scales.
"""

import json

import numpy as np
from mpmath import mp, mpf

import exponentials
from library import MODES
from poses import cross_matrices, matrices_of, random_poses

PAIRS = 10_000
EXACT_PAIRS = 200
DISTANCE = 1e4  # m


def check(library, report, seed):
    """Checks the C++ library."""
    random = np.random.default_rng([seed, 40])
    begin, end = random_poses(random, PAIRS), random_poses(random, PAIRS)
    end[::2, 3:7] *= -1.0  # the other sign of the same rotation
    weights = random.uniform(0.0, 1.0, PAIRS)
    weights[:100] = np.repeat([0.0, 1.0], 50)
    for mode in MODES:
        expected = REFERENCES[mode](matrices_of(begin), matrices_of(end), weights)
        ours = matrices_of(library.interpolate(mode, begin, end, weights, np.float64))
        report.check("numpy, double", mode, errors(ours, expected, begin, end), 1e-13)

        rounded = [array.astype(np.float32) for array in (begin, end, weights)]
        expected = REFERENCES[mode](*map(matrices_of, rounded[:2]), rounded[2].astype(float))
        ours = matrices_of(library.interpolate(mode, *rounded, np.float32))
        report.check("numpy, float", mode, errors(ours, expected, begin, end), 1e-6)
        ours = library.interpolate_blocks(mode, *rounded).reshape(-1, 3, 4)
        report.check("numpy, float", f"{mode} in blocks", errors(ours, expected, begin, end), 1e-5)
    check_far(library, report, random)
    check_screw(library, report, begin, end, weights)


def check_far(library, report, random):
    """Poses some meters apart, 10 km from the origin, where adjacent floats differ by a millimeter."""
    place = random.standard_normal((PAIRS, 3))
    place *= DISTANCE / np.linalg.norm(place, axis=1, keepdims=True)
    begin, end = random_poses(random, PAIRS, 3.0), random_poses(random, PAIRS, 3.0)
    begin[:, :3] += place
    end[:, :3] += place
    begin, end = begin.astype(np.float32), end.astype(np.float32)
    weights = random.uniform(0.0, 1.0, PAIRS).astype(np.float32)
    for mode in MODES:
        expected = REFERENCES[mode](matrices_of(begin), matrices_of(end), weights.astype(float))
        single = matrices_of(library.interpolate(mode, begin, end, weights, np.float32))
        blocks = library.interpolate_blocks(mode, begin, end, weights).reshape(-1, 3, 4)
        for name, ours in (("float", single), ("blocks", blocks)):
            meters = np.abs(ours[:, :, 3] - expected[:, :, 3]).max(axis=1)
            report.check("numpy, meters", f"{mode} in {name}, 10 km away", meters, 1e-3)


def check_screw(library, report, begin, end, weights):
    """A sample of SCREW at 50 digits: exp(a log M) for the motion M between the poses."""
    mp.dps = exponentials.DIGITS
    ours = matrices_of(library.interpolate("SCREW", begin, end, weights, np.float64))
    chosen = np.linspace(0, PAIRS - 1, EXACT_PAIRS).astype(int)
    worst = []
    for i in chosen:
        first, second = exponentials.to_mpf(begin[i]), exponentials.to_mpf(end[i])
        displacement = [b - a for a, b in zip(first[:3], second[:3])]
        rotation = product(second[3:7], [first[3], -first[4], -first[5], -first[6]])
        length = mp.sqrt(sum(x * x for x in rotation))
        motion = exponentials.logarithm([*displacement, *(x / length for x in rotation), second[7] / first[7]])
        linear, moved = exponentials.exponential([mpf(float(weights[i])) * x for x in motion])
        start = matrices_of(begin[i : i + 1])[0]
        expected = np.empty((1, 3, 4))
        expected[0, :, :3] = np.array(linear.tolist(), float) @ start[:, :3]
        expected[0, :, 3] = [float(a + b) for a, b in zip(first[:3], moved)]
        worst += list(errors(ours[i : i + 1], expected, begin[i : i + 1], end[i : i + 1]))
    report.check("mpmath, double", "SCREW", worst, 1e-13)


def check_file(path, report):
    """Checks what the engine computed (format: README.md)."""
    with open(path, encoding="utf-8") as file:
        cases = json.load(file)["cases"]
    for mode in MODES:
        chosen = [case for case in cases if case["mode"] == mode]
        if not chosen:
            report.check("engine", mode, [], 1e-5)
            continue
        begin, end, ours = (np.array([case[key] for case in chosen], float).reshape(-1, 3, 4)
                            for key in ("from", "to", "result"))
        weights = np.array([case["weight"] for case in chosen], float)
        expected = REFERENCES[mode](begin, end, weights)
        report.check("engine", mode, matrix_errors(ours, expected, begin, end), 1e-5)


def errors(ours, expected, begin, end):
    return matrix_errors(ours, expected, matrices_of(begin), matrices_of(end))


def matrix_errors(ours, expected, begin, end):
    """The larger of the errors of scale times rotation, relative to the scale, and of positions, relative to the longest."""
    linear = np.abs(ours[:, :, :3] - expected[:, :, :3]).max(axis=(1, 2)) / np.cbrt(np.linalg.det(expected[:, :, :3]))
    size = np.max([np.linalg.norm(matrix[:, :, 3], axis=1) for matrix in (expected, begin, end)], axis=0)
    return np.maximum(linear, np.linalg.norm(ours[:, :, 3] - expected[:, :, 3], axis=1) / np.maximum(size, 1.0))


def linear(begin, end, weights):
    """Dual-quaternion linear blending; the scale separately."""
    first_scale, first, first_position = split(begin)
    second_scale, second, second_position = split(end)
    real, other = quaternions_of(first), quaternions_of(second)
    dual, other_dual = half_product(first_position, real), half_product(second_position, other)
    sign = np.where(np.sum(real * other, axis=1) < 0.0, -1.0, 1.0)
    near, far = (1.0 - weights)[:, None], (weights * sign)[:, None]
    real, dual = near * real + far * other, near * dual + far * other_dual
    square = np.sum(real * real, axis=1, keepdims=True)
    conjugate = real * [1.0, -1.0, -1.0, -1.0]
    position = 2.0 * np.stack(product(dual.T, conjugate.T), axis=1)[:, 1:] / square
    w, u = real[:, 0, None, None], cross_matrices(real[:, 1:])
    rotation = np.eye(3) + (2.0 * w * u + 2.0 * u @ u) / square[:, :, None]
    return join((1.0 - weights) * first_scale + weights * second_scale, rotation, position)


def screw(begin, end, weights):
    """Rotation and scaling about the pole of the motion."""
    first_scale, first, first_position = split(begin)
    second_scale, second, second_position = split(end)
    axis, angle = axes_and_angles(second @ np.swapaxes(first, 1, 2))
    ratio = second_scale / first_scale
    displacement = second_position - first_position

    # Two directions that form a right-handed frame with the axis.
    helper = np.eye(3)[np.argmin(np.abs(axis), axis=1)]
    across = np.cross(axis, helper)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    upward = np.cross(axis, across)

    planar = np.sum(displacement * across, axis=1) + 1j * np.sum(displacement * upward, axis=1)
    moved = from_pole(np.log(ratio) + 1j * angle, planar, weights)
    along = from_pole(np.log(ratio) + 0j, np.sum(displacement * axis, axis=1), weights).real
    position = first_position + moved.real[:, None] * across + moved.imag[:, None] * upward + along[:, None] * axis
    return join(first_scale * ratio**weights, rotations(axis, angle * weights) @ first, position)


def from_pole(spiral, displacement, weights):
    """The displacement at u = weights of 0 .. 1 along a spiral exp(`spiral` u) about its pole; a line if `spiral` is 0."""
    straight = np.abs(spiral) < 1e-12
    pole = displacement / np.where(straight, 1.0, -np.expm1(spiral))
    return np.where(straight, displacement * weights, -pole * np.expm1(spiral * weights))


def separate(begin, end, weights):
    """lerp, slerp, lerp"""
    first_scale, first, first_position = split(begin)
    second_scale, second, second_position = split(end)
    axis, angle = axes_and_angles(second @ np.swapaxes(first, 1, 2))
    position = first_position + weights[:, None] * (second_position - first_position)
    return join((1.0 - weights) * first_scale + weights * second_scale, rotations(axis, angle * weights) @ first, position)


REFERENCES = {"LINEAR": linear, "SCREW": screw, "SEPARATE": separate}


def split(matrices):
    """Scale, nearest rotation, and translation."""
    linear_part = matrices[:, :, :3]
    left, _, right = np.linalg.svd(linear_part)
    return np.cbrt(np.linalg.det(linear_part)), left @ right, matrices[:, :, 3]


def join(scale, rotation, position):
    return np.concatenate([scale[:, None, None] * rotation, position[:, :, None]], axis=2)


def quaternions_of(rotation):
    """The eigenvector of the largest eigenvalue of Bar-Itzhack's matrix; exact at half turns too."""
    r = np.moveaxis(rotation, 0, 2)
    matrix = np.empty((len(rotation), 4, 4))
    skew = [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]
    trace = r[0, 0] + r[1, 1] + r[2, 2]
    matrix[:, 0, 0] = trace
    for i in range(3):
        matrix[:, 0, i + 1] = matrix[:, i + 1, 0] = skew[i]
        for j in range(3):
            matrix[:, i + 1, j + 1] = r[i, j] + r[j, i] - (trace if i == j else 0.0)
    return np.linalg.eigh(matrix)[1][:, :, 3]


def axes_and_angles(rotation):
    """Axes and angles of at most pi."""
    quaternions = quaternions_of(rotation)
    quaternions *= np.where(quaternions[:, :1] < 0.0, -1.0, 1.0)
    sine = np.linalg.norm(quaternions[:, 1:], axis=1)
    axis = np.where(sine[:, None] > 0.0, quaternions[:, 1:] / np.maximum(sine, 1e-300)[:, None], [0.0, 0.0, 1.0])
    return axis, 2.0 * np.arctan2(sine, quaternions[:, 0])


def rotations(axis, angle):
    """Rodrigues: 1 + sin [n]x + (1 - cos) [n]x^2"""
    n, angle = cross_matrices(axis), angle[:, None, None]
    return np.eye(3) + np.sin(angle) * n + 2.0 * np.sin(angle / 2.0) ** 2 * n @ n


def half_product(position, quaternion):
    """(1/2) (0, t) q: the dual part."""
    t = np.vstack([np.zeros(len(position)), 0.5 * position.T])
    return np.stack(product(t, quaternion.T), axis=1)


def product(p, q):
    """The Hamilton product of (w, x, y, z), of numbers or arrays."""
    return [
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    ]
