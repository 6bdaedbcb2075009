"""Poses as 8 numbers t1 t2 t3 qw qx qy qz s, or as 3 x 4 matrices."""

import numpy as np


def random_poses(random, count, distance=10.0):
    """Translations of standard deviation `distance`, any rotation, scales 0.1 to 10 uniform in the logarithm."""
    translations = random.standard_normal((count, 3)) * distance
    rotations = random.standard_normal((count, 4))
    rotations /= np.linalg.norm(rotations, axis=1, keepdims=True)
    scales = 10.0 ** random.uniform(-1.0, 1.0, (count, 1))
    return np.hstack([translations, rotations, scales])


def rotation_matrices(quaternions):
    """By Rodrigues' formula from the vector part: R = 1 + 2 w [u]x + 2 [u]x^2 of a unit (w, u)."""
    w, u = quaternions[:, 0, None, None], cross_matrices(quaternions[:, 1:])
    return np.eye(3) + 2.0 * w * u + 2.0 * u @ u


def cross_matrices(vectors):
    """[v]x, so that [v]x u = v x u."""
    x, y, z = np.moveaxis(np.asarray(vectors), -1, 0)
    zero = np.zeros_like(x)
    return np.moveaxis(np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]), -1, 0)


def matrices_of(poses):
    """n x 3 x 4: scale times rotation, and the translation, in double. Normalizes the quaternions."""
    poses = np.asarray(poses, float)
    quaternions = poses[:, 3:7]
    lengths = np.linalg.norm(quaternions, axis=1, keepdims=True)
    linear = rotation_matrices(quaternions / np.where(lengths > 0.0, lengths, 1.0)) * poses[:, 7, None, None]
    return np.concatenate([linear, poses[:, :3, None]], axis=2)
