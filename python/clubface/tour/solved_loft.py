"""The dynamic loft with which a model launches a ball at a published angle."""

from __future__ import annotations

import math
import os

from clubface import units
from clubface.equipment.balls import Ball
from clubface.errors import InputError, RangeWarning
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.support.warning import without_warnings


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

    The ball is struck ``high`` [m] above the face centre. A launch angle out of reach is an :class:`InputError`.
    """
    with without_warnings(RangeWarning):
        found = impact_at_launch(
            club, speed=speed, attack=attack, high=high, launch=launch, model=model, ball=ball
        )  # fmt: skip
    if math.isnan(found.loft):
        raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
    return found.loft
