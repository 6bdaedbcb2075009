"""exp, log and power of similarities, compared with matrices at 50 digits (mpmath).

The logarithm L = -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E) is the matrix [[sigma 1 + [w]x, v], [0, 0]] of
the same motion. Its exponential is that of the matrix; v follows from t by a linear system with the series
sum of X^k / (k + 1)!, X = sigma 1 + [w]x. The closed forms of the C++ code are not used.
"""

import itertools

import mpmath
import numpy as np
from mpmath import mp, mpf

BOUNDS = {np.float64: 1e-13, np.float32: 5e-7}
DIGITS = 50
ANGLES = [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.3, 1.0, 2.0, 3.0, np.pi - 1e-6, np.pi - 1e-12, np.pi]
LOG_SCALES = [0.0] + [sign * size for size in (1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.3, 1.0, 3.0, 5.0) for sign in (1, -1)]
EXPONENTS = [0.5, 0.01, -1.0, 2.0]


def check(library, report, seed):
    """Runs the checks of this file, in double and in float."""
    mp.dps = DIGITS
    for kind in (np.float64, np.float32):
        name = "double" if kind is np.float64 else "float"
        bound = BOUNDS[kind]
        logs = grid(np.random.default_rng([seed, 30])).astype(kind)
        images = [exponential(log) for log in logs]
        errors = [pose_error(pose, *exact) for pose, exact in zip(library.exp_of_log(logs, kind), images)]
        report.check(f"mpmath, {name}", "exp of poses", errors, bound)

        # The input of log is the rounded pose, so the expected result is the exact log of that.
        poses = np.array([rounded_pose(log) for log in logs]).astype(kind)
        exact_logs = [logarithm(pose) for pose in poses]
        ours = library.log_of_pose(poses, kind)
        for part, numbers in (("rotation", slice(0, 3)), ("translation", slice(3, 6)), ("scale", slice(6, 7))):
            errors = [relative(log[numbers], exact[numbers]) for log, exact in zip(ours, exact_logs)]
            report.check(f"mpmath, {name}", f"log of poses, {part}", errors, bound)

        for exponent in EXPONENTS:
            alpha = kind(exponent)
            ours = library.power_of_pose(poses, np.full(len(poses), alpha), kind)
            images = [exponential([mpf(float(alpha)) * number for number in exact]) for exact in exact_logs]
            # A power may nearly cancel the translation, as the square of a half turn does: errors are relative to the pose's.
            sizes = np.linalg.norm(poses[:, :3], axis=1)
            errors = [pose_error(power, *exact, size) for power, exact, size in zip(ours, images, sizes)]
            report.check(f"mpmath, {name}", f"power {exponent:g} of poses", errors, bound)


def grid(random):
    """All angles with all logarithms of scale, about random axes, with random velocities, some with zero velocity."""
    logs = []
    for i, (angle, sigma) in enumerate(itertools.product(ANGLES, LOG_SCALES)):
        axis, velocity = random.standard_normal((2, 3))
        axis /= np.linalg.norm(axis)
        logs.append([*(axis * angle), *(velocity * 10.0 ** random.uniform(-3, 3)), sigma])
        if i % 10 == 0:
            logs.append([*(axis * angle), 0.0, 0.0, 0.0, sigma])
    return np.array(logs)


def to_mpf(numbers):
    return [number if isinstance(number, mpf) else mpf(float(number)) for number in numbers]


def linear_part(log):
    """sigma 1 + [w]x"""
    w1, w2, w3, _, _, _, sigma = to_mpf(log)
    return mpmath.matrix([[sigma, -w3, w2], [w3, sigma, -w1], [-w2, w1, sigma]])


def exponential(log):
    """(scale times rotation, translation) of a logarithm."""
    generator = mpmath.zeros(4)
    generator[:3, :3] = linear_part(log)
    for row, velocity in enumerate(to_mpf(log)[3:6]):
        generator[row, 3] = velocity
    image = mp.expm(generator)
    return image[:3, :3], image[:3, 3]


def logarithm(pose):
    """w, v, sigma of a pose of doubles (the quaternion normalized exactly), with an angle of at most pi."""
    t1, t2, t3, w, x, y, z, scale = to_mpf(pose)
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    sine = mpmath.sqrt(x * x + y * y + z * z)
    factor = 2 * mpmath.atan2(sine, w) / sine if sine else mpf(0)
    log = [factor * x, factor * y, factor * z, mpf(0), mpf(0), mpf(0), mpmath.log(scale)]
    velocity = mp.lu_solve(integral_of_exponential(linear_part(log)), mpmath.matrix([t1, t2, t3]))
    log[3:6] = list(velocity)
    return log


def integral_of_exponential(x):
    """sum of x^k / (k + 1)!, which is the integral of exp(u x) over u from 0 to 1."""
    term = total = mpmath.eye(3)
    for k in range(1, 120):
        term = term * x / (k + 1)
        total = total + term
    return total


def rounded_pose(log):
    """The pose of a logarithm, rounded to double: the input of log and power."""
    w = np.array(log[:3], float)
    angle = np.linalg.norm(w)
    axis = w / angle if angle else w
    translation = [float(number) for number in exponential(log)[1]]
    return [*translation, np.cos(angle / 2.0), *(axis * np.sin(angle / 2.0)), np.exp(float(log[6]))]


def pose_error(pose, linear, translation, size=0):
    """The larger of the errors of t, relative to max(|t|, `size`), and of scale times rotation, relative to the scale."""
    t1, t2, t3, w, x, y, z, scale = to_mpf(pose)
    rotation = mpmath.matrix([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])
    linear_error = mpmath.mnorm(rotation * scale - linear, "f") / mpmath.mnorm(linear, "f")
    return max(float(linear_error), relative([t1, t2, t3], list(translation), size))


def relative(ours, expected, size=0):
    """|ours - expected| / max(|expected|, `size`); 0 / 0 is 0."""
    difference = mpmath.norm([a - b for a, b in zip(to_mpf(ours), expected)])
    size = max(mpmath.norm(list(expected)), size)
    return float(difference / size) if size else float(difference)
