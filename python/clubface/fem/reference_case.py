"""The reference case: a ball whose every constant is stated, thrown at a rigid plane."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import Any

from clubface.fem.balls import Ball, ball
from clubface.fem.core import Progress
from clubface.fem.result import Impact
from clubface.fem.run import throw
from clubface.fem.settings import Settings
from clubface.support.shipped import DATA
from clubface.support.strict_toml import Document

SPEED = "35 m/s"
ANGLE = "11.5 deg"
FRICTION = 0.35


def reference(
    *,
    which: str | os.PathLike[str] | Ball = "reference",
    friction: Any = FRICTION,
    refine: int = 1,
    element: str = "one-point",
    settings: Settings | None = None,
    progress: Progress | None = None,
) -> Impact:
    """Throw the ball of Roh and Lee at a rigid plane, at 35 m/s and 11.5 deg from the normal, for 1000 us.

    Parameters
    ----------
    which
        The ball: a name, a TOML file or a :class:`Ball`.
    friction
        Coefficient of Coulomb friction.
    refine
        How many times finer the mesh is along every edge.
    element
        The kind of elements: "one-point" or "full".
    settings, progress
        As for :func:`throw`.
    """
    made = replace(ball(which).refined(refine), element=element)
    return throw(made, speed=SPEED, angle=ANGLE, friction=friction, settings=settings, progress=progress)


def other_solvers() -> tuple[list[str], dict[str, list[float]]]:
    """Return the names of independent solvers, and what they found [SI; rpm], by the keys of the command line."""
    told = Document.read(DATA / "published_impacts.toml").data["reference"]
    return told["solvers"], told["figures"]
