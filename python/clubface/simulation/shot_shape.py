"""Golfers' names of shots: start and curve in words, with the limits of the core.

The *curve* is the distance of the landing from the start line of the ball, across that line; it includes the effect of
wind. The names follow from start and curve alone: a push or pull starts off the target line, a draw or fade curves, a
hook or slice curves a lot. The limits are those of Open Golf Coach, with limits of the spin axis converted to the curve
that it causes; see ``crates/clubface-impact/src/flight/shot_shape.rs``.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clubface import _core as core
from clubface.support.arrays import NumberOrArray, ValueLike, flat

__all__ = ["BIG_CURVE", "STRAIGHT_CURVE", "STRAIGHT_START", "curve", "shot_shape"]

_SHAPES = core.shot_shapes()
STRAIGHT_START: float = _SHAPES["straight_start"]
"""Maximum angle between start and target line of a straight start, neither push nor pull [rad]."""
STRAIGHT_CURVE: float = _SHAPES["straight_curve"]
"""Maximum curve over carry of a straight ball, neither draw nor fade: that of 3 degrees of spin axis."""
BIG_CURVE: float = _SHAPES["big_curve"]
"""Maximum curve over carry of a draw or fade; more is a hook or slice: that of 12 degrees of spin axis."""


def curve(azimuth: ValueLike, carry: ValueLike, side: ValueLike) -> NumberOrArray:
    """Return the distance of the landing from the start line of the ball [m]; right is positive.

    Parameters
    ----------
    azimuth
        Launch direction [rad], right of the target is positive.
    carry
        Straight distance from the start to the landing [m].
    side
        Distance of the landing from the target line [m], right is positive. All are numbers or arrays that broadcast.
    """
    (start, distance, right), shape = _columns(azimuth, carry, side)
    values = core.curves(start, distance, right, math.prod(shape)).reshape(shape)
    return values if shape else float(values)


def shot_shape(azimuth: ValueLike, curve: ValueLike, carry: ValueLike, *, hand: ValueLike = 1.0) -> Any:
    """Return the golfer's name of a shot, such as "pull hook", or "" if it does not fly. Arrays give an array.

    Parameters
    ----------
    azimuth, carry
        As for :func:`curve`.
    curve
        Curve [m], as returned by :func:`curve`.
    hand
        1 for a right-handed player, -1 for a left-handed one, whose push starts left and whose draw curves right.
    """
    (start, bend, distance, sides), shape = _columns(azimuth, curve, carry, hand)
    names = core.shot_shape_names(start, bend, distance, sides, math.prod(shape))
    return np.array(names, dtype=str).reshape(shape) if shape else names[0]


def _columns(*values: Any) -> tuple[list[Any], tuple[int, ...]]:
    """Return numbers, or flat arrays for the core, and the shape to which they broadcast."""
    arrays = [np.asarray(each, dtype=float) for each in values]
    shape = np.broadcast_shapes(*(each.shape for each in arrays))
    return [flat(each, shape) if each.ndim else float(each) for each in arrays], shape
