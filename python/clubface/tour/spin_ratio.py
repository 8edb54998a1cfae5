"""The spin of a ball beside its speed along the face: I w / (m R v_t), angular over linear momentum and radius.

A force along the face that acts at the distance R from the centre of a resting ball gives it m v_t along the face and I
w = R m v_t: the ratio is 1, whether the ball slides, sticks or rolls off. The centre of a ball that is flattened is
nearer to the face while the force acts, which makes it 0.85 to 0.95. That is for a face that does not turn, or nearly
for the face at maximum compression, whose loft TrackMan calls the dynamic loft. Until then a free head turns up by 0.5
to 0.9 degrees (irons) or less than 0.3 (woods), so that over the face of first touch the ratio is larger: for irons by
0.1 to 0.2, for a driver, along which the ball hardly moves, by up to as much as itself.

So a published speed, launch angle and spin belong to a narrow range of dynamic lofts, and with a loft that is further
off than the head turns they cannot be those of one shot.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.simulation.launch import Launch
from clubface.simulation.spin import rolling_speed

RIGID = 1.0
"""The ratio of a ball that stays round."""
FLATTENED = 0.85
"""The least ratio that a flattened ball has, in throws of finite elements at a plane."""


def spin_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, loft: Any) -> Any:
    """Return I w / (m R v_t) of launches [m/s, rad, rad/s] in the vertical plane of a face of dynamic loft [rad]."""
    return rolling_speed(ball, spin) / (speed * np.sin(loft - np.asarray(launch)))


def loft_of_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, ratio: float) -> NDArray[np.float64]:
    """Return the dynamic lofts [rad] with which launches have this ratio; NaN where no loft gives so much spin."""
    share = rolling_speed(ball, spin) / (np.asarray(speed) * ratio)
    return launch + np.arcsin(np.where(np.abs(share) <= 1.0, share, np.nan))


def spin_ratio_of(found: Launch, loft: float) -> float:
    """Return the ratio of one launch over a square face of loft [rad] at first touch, all directions taken together."""
    normal = np.array([np.cos(loft), np.sin(loft), 0.0])
    velocity = np.array([found.velocity_x, found.velocity_y, found.velocity_z])
    along = velocity - normal * (velocity @ normal)
    return float(rolling_speed(found.ball, found.total_spin) / np.linalg.norm(along))
