"""The dynamic loft with which a model launches a ball at a given angle."""

from __future__ import annotations

import os

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.models import models
from clubface.errors import InputError, RangeWarning
from clubface.simulation.impact import impact
from clubface.support.warning import without_warnings

LOWEST, STEEPEST = units.to_si(-20.0, "deg"), units.to_si(78.0, "deg")
"""The dynamic lofts [rad] between which one is looked for."""
SLOPE = 0.85
"""Change of the launch angle with the loft, for the first step of the search."""
FAR_APART = 1e-3
TRIES = 16
RESOLUTION, COARSE_RESOLUTION = 1e-10, 1e-5
"""How closely a solved loft gives its launch angle [rad]: by a reduced model, and by one that takes long."""
REACHED = 2e-5
"""What is further off [rad] after all tries is out of reach; the steps of contact models alone make some 1e-6."""


def solve_loft(
    club: str,
    speed: float,
    attack: float,
    launch: float,
    *,
    high: float = 0.0,
    model: str,
    ball: str | os.PathLike[str] | Ball | None = None,
) -> float:
    """Return the dynamic loft [rad] with which a model launches the ball at the angle ``launch`` [rad].

    The ball is struck ``high`` [m] above the face centre.

    Secants; tries closer together than ``FAR_APART`` keep the slope, which the steps of contact models would spoil.
    """
    resolution = RESOLUTION if model in models() else COARSE_RESOLUTION
    loft, slope = _within(launch + (1.0 / SLOPE - 1.0) * (launch - attack)), SLOPE
    tried: list[tuple[float, float]] = []
    while len(tried) < TRIES:
        with without_warnings(RangeWarning):  # of tries
            found = impact(club, speed=speed, attack=attack, loft=loft, high=high, model=model, ball=ball)
        tried.append((float(found.launch) - launch, loft))
        missing = tried[-1][0]
        if abs(missing) <= resolution:
            break
        if len(tried) > 1 and abs(loft - tried[-2][1]) > FAR_APART:
            slope = (missing - tried[-2][0]) / (loft - tried[-2][1])
        following = _within(loft - missing / slope)
        if following == loft:
            break
        loft = following
    missing, loft = min(tried, key=lambda each: abs(each[0]))
    if abs(missing) > REACHED:
        raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
    return loft


def _within(loft: float) -> float:
    return min(max(loft, LOWEST), STEEPEST)
