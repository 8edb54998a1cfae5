"""What golfers call a shot: start and curve in words, by the limits of the core.

The *curve* is the distance of the landing from the line on which the ball starts, across that line; wind is part of it.
The names follow from start and curve alone: a push or pull starts off the target line, a draw or fade curves, a hook or
slice curves much. The limits are those of Open Golf Coach, that of the spin axis as the curve that it makes; the core
says more in ``crates/clubface-impact/src/flight/shot_shape.rs``.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clubface import _core as core
from clubface.support.arrays import NumberOrArray, ValueLike

__all__ = ["BIG_CURVE", "STRAIGHT_CURVE", "STRAIGHT_START", "curve", "shot_shape"]

_SHAPES = core.shot_shapes()
STRAIGHT_START: float = _SHAPES["straight_start"]
"""Largest angle between the start and the target line that is no push or pull [rad]."""
STRAIGHT_CURVE: float = _SHAPES["straight_curve"]
"""Largest curve, as a share of the carry, that is neither draw nor fade: that of 3 degrees of spin axis."""
BIG_CURVE: float = _SHAPES["big_curve"]
"""Largest curve, as a share of the carry, that is no hook or slice: that of 12 degrees of spin axis."""


def curve(azimuth: ValueLike, carry: ValueLike, side: ValueLike) -> NumberOrArray:
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
    (start, distance, right), shape = _columns(azimuth, carry, side)
    values = core.curves(start, distance, right, math.prod(shape)).reshape(shape)
    return values if shape else float(values)


def shot_shape(azimuth: ValueLike, curve: ValueLike, carry: ValueLike, *, hand: ValueLike = 1.0) -> Any:
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
    (start, bend, distance, sides), shape = _columns(azimuth, curve, carry, hand)
    names = core.shot_shape_names(start, bend, distance, sides, math.prod(shape))
    return np.array(names, dtype=str).reshape(shape) if shape else names[0]


def _columns(*values: Any) -> tuple[list[Any], tuple[int, ...]]:
    """Return numbers, or arrays as the core takes them, and the shape they broadcast to."""
    arrays = [np.asarray(each, dtype=float) for each in values]
    shape = np.broadcast_shapes(*(each.shape for each in arrays))
    whole = (np.ascontiguousarray(np.broadcast_to(each, shape)).reshape(-1) if each.ndim else each for each in arrays)
    return [each if each.ndim else float(each) for each in whole], shape
