"""Screw motions, compared with the Python packages `pytransform3d` (dual quaternions and matrices, no scale) and
`geometricalgebra` (conformal versors).

pytransform3d's screw parameters divide by the angle, and geometricalgebra's exponential is a series of ten terms by
default. To keep both within the bound, angles are 0.1 .. 3, and the series has more terms.
"""

import numpy as np
import pytransform3d.transformations as transformations
from geometricalgebra import cga3d

from bivectors import motor_bivector
from poses import matrices_of, random_poses

BOUND = 1e-12
CASES = 500
TERMS = 60


def check(library, report, seed):
    """Runs the checks of this file."""
    random = np.random.default_rng([seed, 60])
    check_pytransform3d(library, report, random)
    check_geometricalgebra(library, report, random)


def screws(random):
    """Points on axes, unit axes, pitches, angles, and the logarithms w = theta s, v = q x w + h w."""
    points, axes = random.standard_normal((2, CASES, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    pitches, angles = random.standard_normal(CASES), random.uniform(0.1, 3.0, CASES)
    turns = axes * angles[:, None]
    velocities = np.cross(points, turns) + pitches[:, None] * turns
    return points, axes, pitches, angles, np.hstack([turns, velocities, np.zeros((CASES, 1))])


def check_pytransform3d(library, report, random):
    """Exponential coordinates, screw parameters, powers of dual quaternions, ScLERP."""
    oracle = "pytransform3d"
    points, axes, pitches, angles, logs = screws(random)
    motors = library.unary("exp", [motor_bivector(log) for log in logs])
    ours = matrices_of(library.extract(motors))
    expected = [transformations.transform_from_exponential_coordinates(log[:6])[:3] for log in logs]
    report.check(oracle, "exp of exponential coordinates", pose_errors(ours, expected), BOUND)
    expected = [matrix_of(transformations.dual_quaternion_from_screw_parameters(*screw))
              for screw in zip(points, axes, pitches, angles)]
    report.check(oracle, "exp of screw parameters", pose_errors(ours, expected), BOUND)

    begin, end = rigid_poses(random), rigid_poses(random)
    end[np.sum(begin[:, 3:7] * end[:, 3:7], axis=1) < 0.0, 3:7] *= -1.0
    weights = random.uniform(0.0, 1.0, CASES)
    matrices = matrices_of(begin)
    coordinates = np.array([transformations.exponential_coordinates_from_transform(square(matrix)) for matrix in matrices])
    ours = library.log_of_pose(begin, np.float64)[:, :6]
    # A half turn has two axes; the log of pytransform3d is inaccurate near it.
    clear = np.linalg.norm(coordinates[:, :3], axis=1) < 3.0
    errors = np.linalg.norm(ours - coordinates, axis=1) / np.linalg.norm(coordinates, axis=1)
    report.check(oracle, "log of poses up to 3 radians", errors[clear], BOUND)

    first, second = dual_quaternions(begin), dual_quaternions(end)
    exponents = random.uniform(-2.0, 2.0, CASES)
    positive = begin.copy()
    positive[begin[:, 3] < 0.0, 3:7] *= -1.0
    expected = [matrix_of(transformations.dual_quaternion_power(q, a)) for q, a in zip(dual_quaternions(positive), exponents)]
    ours = matrices_of(library.power_of_pose(begin, exponents, np.float64))
    report.check(oracle, "powers of dual quaternions", pose_errors(ours, expected), BOUND)
    ours = matrices_of(library.extract(library.power(library.motor(begin), exponents)))
    report.check(oracle, "powers of motors", pose_errors(ours, expected), BOUND)
    expected = [matrix_of(transformations.dual_quaternion_sclerp(p, q, w)) for p, q, w in zip(first, second, weights)]
    ours = matrices_of(library.interpolate("SCREW", begin, end, weights, np.float64))
    report.check(oracle, "ScLERP of dual quaternions", pose_errors(ours, expected), BOUND)


def rigid_poses(random):
    poses = random_poses(random, CASES, 3.0)
    poses[:, 7] = 1.0
    return poses


def square(matrix):
    return np.vstack([matrix, [0.0, 0.0, 0.0, 1.0]])


def dual_quaternions(poses):
    return [transformations.dual_quaternion_from_pq(pose[:7]) for pose in poses]


def matrix_of(dual_quaternion):
    return transformations.transform_from_dual_quaternion(dual_quaternion)[:3]


def pose_errors(ours, expected):
    """Errors of matrices, relative to their largest entry or 1."""
    difference = np.abs(np.array(ours) - np.array(expected)).max(axis=(1, 2))
    return difference / np.abs(np.array(expected)).max(axis=(1, 2)).clip(1.0)


def check_geometricalgebra(library, report, random):
    """Versors of screws, translations, rotations and scalings, and their action on points."""
    oracle = "geometricalgebra"
    points, axes, pitches, angles, logs = screws(random)
    motors = library.unary("exp", [motor_bivector(log) for log in logs])
    lines = cga3d.Vector.from_euclid(points) ^ cga3d.Vector.from_direction(axes * angles[:, None]) ^ cga3d.e_inf
    small = angles / 2.0 < 0.2
    along = (lines | cga3d.minkovski_plane) * pitches
    expected = (0.5 * (lines.dual() + (cga3d.e_inf ^ along))).exp(TERMS)
    report.check(oracle, "exp of screw axes", relative(motors, values(expected)), BOUND)
    expected = values(cga3d.Vector.from_screw(lines, pitches))
    report.check(oracle, "from_screw of small angles", relative(motors[small], expected[small]), BOUND)

    placed = random.standard_normal((CASES, 3)) * 3.0
    images = (0.5 * (lines.dual() + (cga3d.e_inf ^ along))).exp(TERMS).apply(cga3d.Vector.from_euclid(placed)).to_euclid()
    matrices = matrices_of(library.extract(motors))
    ours = np.einsum("nij,nj->ni", matrices[:, :, :3], placed) + matrices[:, :, 3]
    report.check(oracle, "points on screws", np.linalg.norm(ours - np.asarray(images), axis=1) / (1.0 + np.linalg.norm(ours, axis=1)), BOUND)

    translations, turns, scales = points * 3.0, axes * angles[:, None], 10.0 ** random.uniform(-1.0, 1.0, CASES)
    theirs = cga3d.Vector.from_pos_and_rot_vector(np.hstack([translations, turns])) & cga3d.Vector.from_scaling(scales)
    rotations = np.hstack([np.cos(angles / 2.0)[:, None], axes * np.sin(angles / 2.0)[:, None]])
    ours = library.motor(np.hstack([translations, rotations, scales[:, None]]))
    report.check(oracle, "motors T R D", relative(ours, values(theirs)), BOUND)
    back, coordinates = theirs.to_scale_pos_and_rot_vector()
    extracted = library.extract(ours)
    logs = library.log_of_pose(np.hstack([np.zeros((CASES, 3)), extracted[:, 3:]]), np.float64)
    errors = [np.abs(extracted[:, 7] - np.asarray(back)) / scales,
              np.abs(extracted[:, :3] - coordinates[:, :3]).max(axis=1) / np.linalg.norm(translations, axis=1),
              np.abs(logs[:, :3] - coordinates[:, 3:]).max(axis=1)]
    report.check(oracle, "scale, position and rotation of motors", np.max(errors, axis=0), BOUND)
    rigid = cga3d.Vector.from_pos_and_rot_vector(np.hstack([translations, turns]))
    report.check(oracle, "sqrt of motors", relative(library.unary("sqrt", values(rigid)), values(rigid.sqrt(is_rigid=True))), BOUND)


def values(vector):
    """All 32 coefficients; the basis and its order are the same."""
    return np.asarray(vector(range(6)).values, float)


def relative(ours, expected):
    """Relative errors of versors; a versor and its negative are the same motion."""
    sign = np.sign(np.sum(ours * expected, axis=1, keepdims=True))
    return np.abs(ours - sign * expected).max(axis=1) / np.abs(expected).max(axis=1)
