"""Geometry of the clubface: nearest point, and point by offsets, as in ``face.rs`` of the core.

Face axes: origin at the face centre, x along the outward normal, y up the face, z towards the toe. The roll arc in the
x-y plane is revolved about an axis parallel to y, one bulge radius behind the centre. All formulas use curvatures, so
that a plane is the special case of zero curvature.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]


def nearest(point: Any, bulge: float, roll: float) -> tuple[Array, Array]:
    """Return the distance of points in front of the face [m], and the outward unit normal at the nearest face point.

    The points are in face axes [m], shape (..., 3); the radii of the face are infinite if it is flat [m].
    """
    p = np.asarray(point, dtype=np.float64)
    x1, radial_x, radial_z = _circle(p[..., 0], p[..., 2], 1.0 / bulge)
    distance, normal_x, normal_y = _circle(x1, p[..., 1], 1.0 / roll)
    return distance, np.stack([normal_x * radial_x, normal_y, normal_x * radial_z], -1)


def face_point(toe: Any, high: Any, bulge: float, roll: float) -> Array:
    """Return the face point [m] with offsets [m] in the plane tangent at the centre, in face axes, shape (..., 3)."""
    toe, high = np.broadcast_arrays(np.asarray(toe, float), np.asarray(high, float))
    a, b = 1.0 / bulge, 1.0 / roll
    x1 = -b * high**2 / (np.sqrt(1.0 - (b * high) ** 2) + 1.0)
    root = np.sqrt((1.0 + a * x1) ** 2 - (a * toe) ** 2)
    return np.stack([(2.0 * x1 + a * (x1**2 - toe**2)) / (root + 1.0), high, toe], -1)


def turn_to_sole(loft: float) -> Array:
    """Return the rotation from face axes to the axes of the soled head, by the static loft [rad]."""
    sine, cosine = np.sin(loft), np.cos(loft)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def _circle(x: Array, y: Array, curvature: float) -> tuple[Array, Array, Array]:
    """Return the signed distance of (x, y) from a circle through the origin with normal +x there, and its normal."""
    radial = curvature * x + 1.0
    root = np.hypot(radial, curvature * y)
    return (2.0 * x + curvature * (x**2 + y**2)) / (root + 1.0), radial / root, curvature * y / root
