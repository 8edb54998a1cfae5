"""Rotations, attitudes of a clubhead, and poses of rigid marker clusters.

Rotations are stacks of matrices or of rotation vectors (axis times angle). An attitude consists of dynamic loft, face
angle and lie. Poses are fitted by least squares (Kabsch 1976, Umeyama 1991).

World axes: x towards the target, y up, z to the right. Club axes: the same for the club at its static loft, with the
sole down and the face towards the target; z towards the toe. Everything here is for a right-hander. For a left-hander,
the caller first mirrors in z, and changes the sign of the face angle afterwards.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

SMALL = 1e-4
"""Angle below which series replace quotients [rad]; their next term is of order 1e-17."""


CROSS = np.cross(np.eye(3)[:, None], np.eye(3)).swapaxes(1, 2)
"""The matrices of the cross products of the unit vectors."""


def mirror(hand: int) -> Array:
    """Return the factors from the right-hander's world to that of ``hand`` (1 right, -1 left), shape (3,)."""
    return np.array([1.0, 1.0, float(hand)])


def skew(v: Any) -> Array:
    """Return the matrices of the cross product v × w; ``v`` of shape (..., 3) gives (..., 3, 3)."""
    return np.tensordot(np.asarray(v, dtype=np.float64), CROSS, 1)


def exponential(vector: Any) -> Array:
    """Return the rotation matrices of rotation vectors [rad] (Rodrigues); shape (..., 3) gives (..., 3, 3)."""
    sine, cosine, _ = _quotients(vector)
    k = skew(vector)
    return np.eye(3) + sine[..., None, None] * k + cosine[..., None, None] * (k @ k)


def logarithm(rotation: Any) -> Array:
    """Return the rotation vectors [rad] of rotation matrices, shorter than pi; (..., 3, 3) gives (..., 3).

    Not for half turns, for which the sense of the axis is lost.
    """
    r = np.asarray(rotation, dtype=np.float64)
    twice_sine = np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], -1)
    sine = 0.5 * np.linalg.norm(twice_sine, axis=-1)
    angle = np.arctan2(sine, 0.5 * (np.trace(r, axis1=-2, axis2=-1) - 1.0))
    small = angle < SMALL
    factor = np.where(small, 1.0 + angle**2 / 6.0, angle / np.where(small, 1.0, sine))
    return 0.5 * factor[..., None] * twice_sine


def left_jacobian(vector: Any) -> Array:
    """Return the matrices from the rate of a rotation vector to the angular velocity in fixed axes.

    J = 1 + (1 - cos a)/a^2 K + (a - sin a)/a^3 K^2 with K the matrix of the vector and a its length; (..., 3, 3).
    """
    _, cosine, cubic = _quotients(vector)
    k = skew(vector)
    return np.eye(3) + cosine[..., None, None] * k + cubic[..., None, None] * (k @ k)


def _quotients(vector: Any) -> tuple[Array, Array, Array]:
    """Return sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3 for the lengths a."""
    a = np.linalg.norm(np.asarray(vector, dtype=np.float64), axis=-1)
    small = a < SMALL
    safe = np.where(small, 1.0, a)
    return (
        np.where(small, 1.0 - a**2 / 6.0, np.sin(safe) / safe),
        np.where(small, 0.5 - a**2 / 24.0, 2.0 * (np.sin(0.5 * safe) / safe) ** 2),
        np.where(a < 1e-2, 1.0 / 6.0 - a**2 / 120.0 + a**4 / 5040.0, (safe - np.sin(safe)) / safe**3),
    )


def about(axis: int, angle: Any) -> Array:
    """Return the rotation matrices for ``angle`` [rad] about x, y or z (0, 1, 2)."""
    vector = np.zeros((*np.shape(angle), 3))
    vector[..., axis] = angle
    return exponential(vector)


def face_axes(static_loft: Any) -> Array:
    """Return the rotation from face axes (x outward normal, y up the face, z to the toe) to club axes, (..., 3, 3)."""
    return about(2, static_loft)


def delivered(loft: Any, face: Any, lie: Any, static_loft: Any) -> Array:
    """Return the rotations from club to world axes, shape (..., 3, 3), for angles [rad] that broadcast.

    The club is tilted by the lie, toe up; yawed so that its face normal has azimuth zero; rotated about z until the
    normal's elevation is the dynamic loft; and finally yawed right by the face angle. Dynamic loft and face angle are
    thus exact at any lie.
    """
    loft, face, lie, static_loft = np.broadcast_arrays(*(np.asarray(v, float) for v in (loft, face, lie, static_loft)))
    tilt = about(0, -lie)
    normal = (tilt @ face_axes(static_loft))[..., :, 0]
    square = about(1, np.arctan2(normal[..., 2], normal[..., 0]))
    raising = about(2, loft - np.arctan2(normal[..., 1], np.hypot(normal[..., 0], normal[..., 2])))
    return about(1, -face) @ raising @ square @ tilt


def angles(rotation: Any, static_loft: Any) -> tuple[Array, Array, Array]:
    """Return dynamic loft, face angle and lie [rad] of a rotation from club to world axes.

    The inverse of :func:`delivered`. For the face's attitude, turned back by the face angle, let w be the component of
    the toe axis along z and u its component along the upward direction in the face; then
    tan(lie) = cos(static loft) u/w.
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
"""Minimum number of markers for a pose, unless they lie on a line."""


def visible(points: Any) -> NDArray[np.bool_]:
    """Return which points (..., 3) were seen, that is, contain no NaN."""
    return np.asarray(np.all(np.isfinite(points), axis=-1))


class Poses(NamedTuple):
    """Poses of a body in all frames."""

    position: Array  # of the body's origin [m], shape (frames, 3); NaN without a pose
    rotation: Array  # from body to laboratory axes, shape (frames, 3, 3)
    residuals: Array  # between markers and body [m], shape (frames, markers, 3); NaN where a marker was not seen

    @property
    def known(self) -> NDArray[np.bool_]:
        """Which frames have a pose."""
        return np.isfinite(self.position[:, 0])

    @property
    def misfit(self) -> Array:
        """Each frame's root mean square residual per degree of freedom [m]; NaN without a pose."""
        freedom = np.maximum(degrees_of_freedom(self.residuals), 1)
        return np.where(self.known, np.sqrt(np.nansum(self.residuals**2, axis=(-1, -2)) / freedom), np.nan)


def fit_poses(shape: Any, observed: Any, weights: Any = None) -> Poses:
    """Fit rotation and position of a rigid body to its markers, frame by frame.

    Minimises the weighted sum of squared distances by a singular value decomposition of the cross-covariance, with the
    sign of the smallest value chosen so that no frame gives a reflection. ``shape`` (markers, 3) is in body axes [m],
    ``observed`` (frames, markers, 3) in laboratory axes, NaN where not seen; weights default to 1.
    """
    shape, observed = np.asarray(shape, dtype=np.float64), np.asarray(observed, dtype=np.float64)
    given = np.ones(len(shape)) if weights is None else np.asarray(weights, dtype=np.float64)
    seen = visible(observed)
    w = seen * given
    usable = seen.sum(-1) >= FEWEST
    w = np.where(usable[:, None], w, given)  # frames without a pose are computed with zeros, then set to NaN
    y = np.where(seen[..., None], observed, 0.0)
    total = w.sum(-1)
    here = np.einsum("km,mi->ki", w, shape) / total[:, None]
    there = np.einsum("km,kmi->ki", w, y) / total[:, None]
    from_here, from_there = shape - here[:, None], y - there[:, None]
    left, size, right = np.linalg.svd(np.einsum("km,kmi,kmj->kij", w, from_there, from_here))
    sign = np.sign(np.linalg.det(left) * np.linalg.det(right))
    left[..., 2] *= sign[:, None]
    rotation = left @ right
    # With markers on a line, the rotation about it is undetermined: the second singular value is as small as the third.
    usable &= size[:, 1] > 1e-4 * size[:, 0]
    position = there - np.einsum("kij,kj->ki", rotation, here)
    residuals = observed - position[:, None] - np.einsum("kij,mj->kmi", rotation, shape)
    position[~usable], rotation[~usable], residuals[~usable] = np.nan, np.nan, np.nan
    return Poses(position, rotation, residuals)


def degrees_of_freedom(residuals: Array) -> NDArray[np.int64]:
    """Return the number of independent residuals per frame: three per marker, minus six of the pose."""
    return np.maximum(3 * visible(residuals).sum(-1) - 6, 0)


def shape_covariance(shape: Array) -> Array:
    """Return the covariance of position and rotation of a cluster at rest, for markers with unit noise [1 m]."""
    return np.linalg.inv(pose_information(shape, np.eye(3)[None], np.ones((1, len(shape))))[0])


def pose_information(shape: Any, rotation: Any, seen: Any) -> Array:
    """Return the information on position and rotation in markers with unit noise [1 m], shape (frames, 6, 6).

    Its inverse is the covariance of (position [m], rotation in laboratory axes [rad]) for markers with equal,
    independent and isotropic noise.
    """
    arms = np.einsum("kij,mj->kmi", rotation, shape)
    jacobian = np.concatenate([np.broadcast_to(np.eye(3), (*arms.shape[:2], 3, 3)), -skew(arms)], -1)
    return np.einsum("km,kmia,kmib->kab", np.asarray(seen, dtype=np.float64), jacobian, jacobian)
