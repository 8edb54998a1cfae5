"""Rotations as matrices and as rotation vectors (axis times angle), for stacks of them at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

SMALL = 1e-4
"""Angle [rad] below which series replace quotients; their next term is of order 1e-17."""


def skew(v: Any) -> Array:
    """Return the matrices that take a vector w to v × w; ``v`` of shape (..., 3) gives (..., 3, 3)."""
    v = np.asarray(v, dtype=np.float64)
    out = np.zeros((*v.shape, 3))
    out[..., 0, 1], out[..., 0, 2] = -v[..., 2], v[..., 1]
    out[..., 1, 0], out[..., 1, 2] = v[..., 2], -v[..., 0]
    out[..., 2, 0], out[..., 2, 1] = -v[..., 1], v[..., 0]
    return out


def exponential(vector: Any) -> Array:
    """Return the rotation matrices of rotation vectors [rad] (Rodrigues); shape (..., 3) gives (..., 3, 3)."""
    sine, cosine, _ = _quotients(vector)
    k = skew(vector)
    return np.eye(3) + sine[..., None, None] * k + cosine[..., None, None] * (k @ k)


def logarithm(rotation: Any) -> Array:
    """Return the rotation vectors [rad] of rotation matrices, of a length below pi; (..., 3, 3) gives (..., 3).

    Not meant for half turns, where the sense of the axis is lost.
    """
    r = np.asarray(rotation, dtype=np.float64)
    twice_sine = np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], -1)
    sine = 0.5 * np.linalg.norm(twice_sine, axis=-1)
    angle = np.arctan2(sine, 0.5 * (np.trace(r, axis1=-2, axis2=-1) - 1.0))
    small = angle < SMALL
    factor = np.where(small, 1.0 + angle**2 / 6.0, angle / np.where(small, 1.0, sine))
    return 0.5 * factor[..., None] * twice_sine


def left_jacobian(vector: Any) -> Array:
    """Return the matrices that take the rate of a rotation vector to the angular velocity in fixed axes.

    J = 1 + (1 - cos a)/a^2 K + (a - sin a)/a^3 K^2 with K the matrix of the vector and a its length; (..., 3, 3).
    """
    _, cosine, cubic = _quotients(vector)
    k = skew(vector)
    return np.eye(3) + cosine[..., None, None] * k + cubic[..., None, None] * (k @ k)


def _quotients(vector: Any) -> tuple[Array, Array, Array]:
    """Return sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3 of the lengths a."""
    a = np.linalg.norm(np.asarray(vector, dtype=np.float64), axis=-1)
    small = a < SMALL
    safe = np.where(small, 1.0, a)
    return (
        np.where(small, 1.0 - a**2 / 6.0, np.sin(safe) / safe),
        np.where(small, 0.5 - a**2 / 24.0, 2.0 * (np.sin(0.5 * safe) / safe) ** 2),
        np.where(a < 1e-2, 1.0 / 6.0 - a**2 / 120.0 + a**4 / 5040.0, (safe - np.sin(safe)) / safe**3),
    )


def about(axis: int, angle: Any) -> Array:
    """Return the rotation matrices by ``angle`` [rad] about x, y or z (0, 1, 2)."""
    vector = np.zeros((*np.shape(angle), 3))
    vector[..., axis] = angle
    return exponential(vector)
