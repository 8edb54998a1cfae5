"""Dynamic loft, face angle and lie of a clubhead, and back: the four rotations that deliver it.

Axes of the world: x towards the target, y up, z to the right. Axes of the club: the same at its static loft, with the
sole down, the face towards the target, and z towards the toe. Everything here is for a right-hander. The caller mirrors
a left-hander in z before, and changes the sign of the face angle after.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface.motion_capture.rotations import Array, about


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
