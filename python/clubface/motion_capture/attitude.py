"""Dynamic loft, face angle and lie of a clubhead, and back: the four rotations that deliver it.

Axes of the world: x to the target, y up, z to the right. Axes of the club: the same at its static loft, sole down, face
to the target, z towards the toe. Everything here is seen as for a right-hander: what a left-hander does is mirrored
in z before, and the face angle changes its sign after.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface.motion_capture.rotations import Array, about


def face_axes(static_loft: Any) -> Array:
    """Return the rotation from face axes (x outward normal, y up the face, z to the toe) to club axes, (..., 3, 3)."""
    return about(2, static_loft)


def delivered(loft: Any, face: Any, lie: Any, static_loft: Any) -> Array:
    """Return the rotation from club axes to the world, shape (..., 3, 3), of angles [rad] that broadcast.

    Tilt by the lie, toe up; yaw the face normal back to azimuth zero; turn about z until its elevation is the dynamic
    loft; yaw right by the face angle. Dynamic loft and face angle hold at any lie.
    """
    loft, face, lie, static_loft = np.broadcast_arrays(*(np.asarray(v, float) for v in (loft, face, lie, static_loft)))
    tilt = about(0, -lie)
    normal = (tilt @ face_axes(static_loft))[..., :, 0]
    square = about(1, np.arctan2(normal[..., 2], normal[..., 0]))
    raising = about(2, loft - np.arctan2(normal[..., 1], np.hypot(normal[..., 0], normal[..., 2])))
    return about(1, -face) @ raising @ square @ tilt


def angles(rotation: Any, static_loft: Any) -> tuple[Array, Array, Array]:
    """Return dynamic loft, face angle and lie [rad] of a rotation from club axes to the world.

    The inverse of :func:`delivered`. With D the attitude of the face turned back by the face angle, w the part of its
    toe axis along z and u that along the upward direction in the face, tan(lie) = cos(static loft) u/w.
    """
    attitude = np.asarray(rotation, dtype=np.float64) @ face_axes(static_loft)
    normal, toe = attitude[..., :, 0], attitude[..., :, 2]
    level = np.hypot(normal[..., 0], normal[..., 2])
    loft, face = np.arctan2(normal[..., 1], level), np.arctan2(normal[..., 2], normal[..., 0])
    along = np.cos(face) * toe[..., 0] + np.sin(face) * toe[..., 2]
    across = np.cos(face) * toe[..., 2] - np.sin(face) * toe[..., 0]
    up = np.cos(loft) * toe[..., 1] - np.sin(loft) * along
    return loft, face, np.arctan2(np.cos(static_loft) * up, across)
