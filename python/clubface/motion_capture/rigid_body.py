"""The pose of a cluster of markers in every frame, by least squares (Kabsch 1976, Umeyama 1991)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.motion_capture.rotations import Array, skew

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
    the least one is chosen so that no frame gives a reflection.

    Parameters
    ----------
    shape
        Markers in body axes [m], shape (markers, 3).
    observed
        Markers in the laboratory [m], shape (frames, markers, 3); NaN where one was not seen.
    weights
        One a marker, shape (markers,); equal unless given.
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
