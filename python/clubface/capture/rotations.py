"""Rotations, attitudes of a clubhead, and the poses of rigid clusters of markers.

Rotations are matrices, or rotation vectors (axis times angle), for stacks of them at once. An attitude is dynamic loft,
face angle and lie. Poses are fitted by least squares (Kabsch 1976, Umeyama 1991).

Axes of the world: x towards the target, y up, z to the right. Axes of the club: the same at its static loft, with the
sole down, the face towards the target, and z towards the toe. Everything here is for a right-hander. The caller mirrors
a left-hander in z before, and changes the sign of the face angle after.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

SMALL = 1e-4
"""Angle [rad] below which series replace quotients; their next term is of order 1e-17."""


def mirror(hand: int) -> Array:
    """Return the factors that take the world of a right-hander to that of a hand (1 right, -1 left), shape (3,)."""
    return np.array([1.0, 1.0, float(hand)])


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


def face_axes(static_loft: Any) -> Array:
    """Return the rotation from face axes (x outward normal, y up the face, z to the toe) to club axes, (..., 3, 3)."""
    return about(2, static_loft)


def delivered(loft: Any, face: Any, lie: Any, static_loft: Any) -> Array:
    """Return the rotation from club axes to the world, shape (..., 3, 3), for angles [rad] that broadcast.

    The club is tilted by the lie, toe up. Its face normal is yawed back to azimuth zero and turned about z until its
    elevation is the dynamic loft. Then the club is yawed right by the face angle. Dynamic loft and face angle are exact
    at any lie.
    """
    loft, face, lie, static_loft = np.broadcast_arrays(*(np.asarray(v, float) for v in (loft, face, lie, static_loft)))
    tilt = about(0, -lie)
    normal = (tilt @ face_axes(static_loft))[..., :, 0]
    square = about(1, np.arctan2(normal[..., 2], normal[..., 0]))
    raising = about(2, loft - np.arctan2(normal[..., 1], np.hypot(normal[..., 0], normal[..., 2])))
    return about(1, -face) @ raising @ square @ tilt


def angles(rotation: Any, static_loft: Any) -> tuple[Array, Array, Array]:
    """Return dynamic loft, face angle and lie [rad] of a rotation from club axes to the world.

    This is the inverse of :func:`delivered`. Let D be the attitude of the face turned back by the face angle, w the
    component of its toe axis along z, and u the component along the upward direction in the face. Then tan(lie) =
    cos(static loft) u/w.
    """
    attitude = np.asarray(rotation, dtype=np.float64) @ face_axes(static_loft)
    normal, toe = attitude[..., :, 0], attitude[..., :, 2]
    level = np.hypot(normal[..., 0], normal[..., 2])
    loft, face = np.arctan2(normal[..., 1], level), np.arctan2(normal[..., 2], normal[..., 0])
    along = np.cos(face) * toe[..., 0] + np.sin(face) * toe[..., 2]
    across = np.cos(face) * toe[..., 2] - np.sin(face) * toe[..., 0]
    up = np.cos(loft) * toe[..., 1] - np.sin(loft) * along
    return loft, face, np.arctan2(np.cos(static_loft) * up, across)


FEWEST = 3
"""Markers that fix a pose, unless they lie on a line."""


def visible(points: Any) -> NDArray[np.bool_]:
    """Return which points [..., 3] were seen: those without a NaN."""
    return np.asarray(np.all(np.isfinite(points), axis=-1))


class Poses(NamedTuple):
    """Poses of a body in frames.

    Attributes
    ----------
    position
        Of the body's origin [m], shape (frames, 3); NaN where there is no pose.
    rotation
        From body axes to the laboratory, shape (frames, 3, 3).
    residuals
        What is left between markers and body [m], shape (frames, markers, 3); NaN where a marker was not seen.
    """

    position: Array
    rotation: Array
    residuals: Array


def fit_poses(shape: Any, observed: Any, weights: Any = None) -> Poses:
    """Fit rotation and position of a rigid body to its markers, frame by frame.

    Minimises the weighted sum of squared distances by the singular values of the covariance of both sets; the sign of
    the least one is chosen so that no frame gives a reflection. Markers have the ``shape`` (markers, 3) in body axes
    [m] and are ``observed`` in the laboratory, (frames, markers, 3), NaN where one was not seen; their weights are
    equal unless given.
    """
    shape, observed = np.asarray(shape, dtype=np.float64), np.asarray(observed, dtype=np.float64)
    given = np.ones(len(shape)) if weights is None else np.asarray(weights, dtype=np.float64)
    seen = visible(observed)
    w = seen * given
    usable = seen.sum(-1) >= FEWEST
    w = np.where(usable[:, None], w, given)  # frames without a pose are computed with zeros and marked at the end
    y = np.where(seen[..., None], observed, 0.0)
    total = w.sum(-1)
    here = np.einsum("km,mi->ki", w, shape) / total[:, None]
    there = np.einsum("km,kmi->ki", w, y) / total[:, None]
    from_here, from_there = shape - here[:, None], y - there[:, None]
    left, size, right = np.linalg.svd(np.einsum("km,kmi,kmj->kij", w, from_there, from_here))
    sign = np.sign(np.linalg.det(left) * np.linalg.det(right))
    left[..., 2] *= sign[:, None]
    rotation = left @ right
    # Markers on a line leave the turn about it open: the second singular value is then as small as the third.
    usable &= size[:, 1] > 1e-4 * size[:, 0]
    position = there - np.einsum("kij,kj->ki", rotation, here)
    residuals = observed - position[:, None] - np.einsum("kij,mj->kmi", rotation, shape)
    position[~usable], rotation[~usable], residuals[~usable] = np.nan, np.nan, np.nan
    return Poses(position, rotation, residuals)


def degrees_of_freedom(residuals: Array) -> NDArray[np.int64]:
    """Return how many independent residuals each frame has: three a marker, less six of the pose."""
    return np.maximum(3 * visible(residuals).sum(-1) - 6, 0)


def pose_information(shape: Any, rotation: Any, seen: Any) -> Array:
    """Return the information that markers of unit noise [1 m] hold on position and rotation, shape (frames, 6, 6).

    Its inverse is the covariance of (position [m], turn [rad] in laboratory axes), for markers of equal and independent
    noise in every direction.
    """
    arms = np.einsum("kij,mj->kmi", rotation, shape)
    jacobian = np.concatenate([np.broadcast_to(np.eye(3), (*arms.shape[:2], 3, 3)), -skew(arms)], -1)
    return np.einsum("km,kmia,kmib->kab", np.asarray(seen, dtype=np.float64), jacobian, jacobian)
