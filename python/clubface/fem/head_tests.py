"""What testers measure on a head: coefficient of restitution and characteristic time."""

from __future__ import annotations

import math
import os
from typing import Any

from clubface import units
from clubface.clubs import Club, club
from clubface.errors import RunError
from clubface.fem.balls import Ball, Piece, ball
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead
from clubface.fem.materials import Material
from clubface.fem.result import Impact
from clubface.fem.run import Settings, strike

COR_SPEED = "160 ft/s"
"""Speed of the ball in the test of restitution that the rules had before the pendulum."""
STRIKER_DIAMETER = 0.0381
"""Of the steel sphere that stands for the pendulum [m]; it weighs 227 g."""
STRIKER_SPEED = "0.6 m/s"
"""Of the sphere: the time hardly depends on it, since a mesh gives as a whole and its local indentation is small."""


def restitution(
    head: Club | MeshedHead | str,
    *,
    which: str | os.PathLike[str] | Ball = "modern",
    speed: Any = COR_SPEED,
    friction: Any = 0.35,
    progress: Progress | None = None,
) -> float:
    """Return the coefficient of restitution of a free head, struck in front of its CG along the normal there.

    Parameters
    ----------
    head
        A head of shells; a rigid club shows what the ball alone loses.
    which
        The ball.
    speed
        Of approach [m/s].
    friction
        Coulomb's coefficient.
    progress
        Called with simulated time and duration [s].

    Returns
    -------
    float
        The ball's speed v after from e = v (M + m) / (M V) - 1, for a head of mass M that comes with the speed V.

    Raises
    ------
    RunError
        A run that failed.
    """
    made = ball(which)
    shaped = head if isinstance(head, MeshedHead) else club(head)
    rigid = shaped.club if isinstance(shaped, MeshedHead) else shaped
    approach = units.parse(speed, "speed", name="speed")
    settings = Settings(duration=1.5e-3, until_separation=True)
    # Level face: the CG's place behind it decides where the impact is central.
    up = [-math.sin(rigid.loft), math.cos(rigid.loft), 0.0]
    toe, high = -rigid.cg_z, -(rigid.cg_x * up[0] + rigid.cg_y * up[1])
    found = strike(
        shaped, which=made, friction=friction, settings=settings, progress=progress,
        speed=approach, loft=0.0, toe=toe, high=high,
    )  # fmt: skip
    _check_complete(found)
    mass = made.properties()["mass"]
    return found.launch["velocity_x"] * (rigid.mass + mass) / (rigid.mass * approach) - 1.0


def characteristic_time(
    head: MeshedHead, *, speed: Any = STRIKER_SPEED, toe: Any = 0.0, high: Any = 0.0, progress: Progress | None = None
) -> float:
    """Return the characteristic time of a head [s]: how long a small steel sphere takes to be thrown back by the face.

    The time is that between 5% and 95% of the change of the sphere's speed. The rules allow 239 us with a tolerance of
    18 us, measured with a pendulum of their own on a club that is held by its shaft, and extrapolated to where local
    indentation takes no time; this is a sphere of 227 g on a free head, so it compares designs and is no test of
    conformity.

    Parameters
    ----------
    head
        The head.
    speed
        Of the sphere [m/s].
    toe, high
        Where it strikes [m].
    progress
        Called with simulated time and duration [s].

    Raises
    ------
    RunError
        A run that failed.
    """
    approach = units.parse(speed, "speed", name="speed")
    settings = Settings(duration=1.5e-3, interval=1e-6, until_separation=True)
    found = strike(
        head, which=striker(), friction=0.0, settings=settings, progress=progress,
        speed=approach, loft=0.0, toe=toe, high=high,
    )  # fmt: skip
    _check_complete(found)
    gained = found.motion["velocity"][:, 0]
    share = (gained - gained[0]) / (gained[-1] - gained[0])
    first, last = (_crossing(found.motion["time"], share, level) for level in (0.05, 0.95))
    return last - first


def _check_complete(found: Impact) -> None:
    """Refuse a run that did not come to its end: nothing can be measured on it."""
    if found.interrupted:
        raise KeyboardInterrupt
    if found.stopped:
        raise RunError(found.stopped)


def striker() -> Ball:
    """Return the steel sphere."""
    steel = Material.linear(200e9, 0.3, density=7850.0)
    return Ball(
        name="steel sphere", diameter=STRIKER_DIAMETER, pieces=(Piece(name="steel", material=steel, layers=2),), cube=4
    )


def _crossing(time: Any, share: Any, level: float) -> float:
    """Return when ``share`` first exceeds ``level``, by straight lines."""
    import numpy as np

    after = int(np.argmax(share > level))
    before = after - 1
    part = (level - share[before]) / (share[after] - share[before])
    return float(time[before] + part * (time[after] - time[before]))
