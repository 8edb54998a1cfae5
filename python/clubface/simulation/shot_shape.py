"""The shape of a shot: how far the ball curves from the line on which it starts, and what golfers call that.

The *curve* is the distance of the landing from the line on which the ball starts. It is measured across that line, so
that a shot which is turned to the left or right as a whole curves as much as before; wind is part of it. The names
follow from start and curve alone: a push or pull starts off the target line, a draw or fade curves, a hook or slice
curves much. Where the ball lands is stated as a number next to the name.

The limits are those of Open Golf Coach 0.3 (https://docs.rs/crate/opengolfcoach/0.3.0, shot_classifier.rs), a public
library that names the shots of simulators: a push or pull starts more than 3 degrees off the target line; a shot curves
from 3 degrees of spin axis on, and much from 12 degrees on. Measured and computed flights have no spin axis that stands
for wind and carry as well, so that the limits of the axis are taken as the curve they make, 0.7% of the carry for a
degree of axis: it is 0.6 to 1.0% for the clubs of the tours with the flight of this package.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

__all__ = ["BIG_CURVE", "STRAIGHT_CURVE", "STRAIGHT_START", "curve", "shot_shape"]

STRAIGHT_START = math.radians(3.0)
"""Largest angle between the start and the target line that is no push or pull [rad]."""
STRAIGHT_CURVE = 0.02
"""Largest curve, as a share of the carry, that is neither draw nor fade: that of 3 degrees of spin axis."""
BIG_CURVE = 0.085
"""Largest curve, as a share of the carry, that is no hook or slice: that of 12 degrees of spin axis."""


def curve(azimuth: Any, carry: Any, side: Any) -> Any:
    """Return the distance of the landing from the line on which the ball starts [m]; to the right is positive.

    Parameters
    ----------
    azimuth
        Launch direction [rad], right of the target is positive.
    carry
        Straight distance from the start to the landing [m].
    side
        Distance of the landing from the target line [m], right is positive. Numbers or arrays that broadcast.
    """
    along = np.sqrt(np.maximum(np.square(carry) - np.square(side), 0.0))
    return side * np.cos(azimuth) - along * np.sin(azimuth)


def shot_shape(azimuth: Any, curve: Any, carry: Any, *, hand: Any = 1.0) -> Any:
    """Return what golfers call a shot, such as "pull hook"; "" of one that does not fly. Arrays give an array.

    Parameters
    ----------
    azimuth
        Launch direction [rad], right of the target is positive.
    curve
        As :func:`curve` returns it [m].
    carry
        Straight distance from the start to the landing [m].
    hand
        1 for a right-handed player, -1 for a left-handed one, whose push starts left and whose draw curves right.
    """
    start, share = (
        np.multiply(azimuth, hand),
        np.multiply(curve, hand) / np.where(np.greater(carry, 0.0), carry, np.nan),
    )
    side = np.select([start < -STRAIGHT_START, start > STRAIGHT_START], ["pull", "push"], "")
    bend = np.select(
        [share < -BIG_CURVE, share < -STRAIGHT_CURVE, share > BIG_CURVE, share > STRAIGHT_CURVE],
        ["hook", "draw", "slice", "fade"], "",
    )  # fmt: skip
    names = np.char.strip(np.char.add(np.char.add(side, " "), bend))
    names = np.where(names == "", "straight shot", names)
    names = np.where(np.isnan(start + share), "", names)
    return names if names.ndim else str(names)
