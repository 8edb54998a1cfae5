"""The case of Roh and Lee, "Analysis of golf ball spin mechanism at impact by FEM", and its table of figures."""

from __future__ import annotations

import math
import os
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem.case import PLANE, Case, case
from clubface.fem.core import Progress
from clubface.fem.result import Impact
from clubface.support.shipped import DATA
from clubface.support.strict_toml import Document

_ROH_LEE = Document.read(DATA / "published_impacts.toml").data["roh-lee"]
PUBLISHED: dict[str, float] = _ROH_LEE["figures"]
"""What Roh and Lee computed."""
LEAST_FACTOR: float = _ROH_LEE["least_factor"]
"""The least compression factor they tell."""
SPEED, LOFT, RADIUS = (
    units.parse(_ROH_LEE["case"][name], dimension)
    for name, dimension in (("speed", "speed"), ("loft", "angle"), ("ball_radius", "length"))
)
"""Their case [m/s, rad, m]."""


def paper(which: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> Impact:
    """Run the case of Roh and Lee, or a variation of it."""
    chosen = case(which)
    if chosen.head == PLANE:
        raise InputError("case", chosen.name, "a case with a head; for a throw at a plane use clubface fem run")
    return chosen.run(progress)


def table(found: Impact) -> dict[str, float]:
    """Return the computed values of Roh and Lee's figures, under the keys of ``PUBLISHED``."""
    launch = found.outcome()
    return {
        "ball_speed_mps": launch["ball_speed"],
        "launch_deg": units.from_si(launch["launch"], "deg"),
        "club_speed_after_mps": sum(launch[f"club_velocity_{axis}"] ** 2 for axis in "xyz") ** 0.5,
        "spin_rpm": units.from_si(launch["backspin"], "rpm"),
        "peak_force_n": found.peak_force,
        "peak_force_time_s": found.peak_force_time,
        "reversal_time_s": found.reversal_time,
        "contraction": found.contraction,
        "contraction_time_s": found.contraction_time,
        "f_prime": found.f_prime,
        "f": found.f,
    }


def _rolling_factor(spin: float, radius: float, along: float) -> float:
    """Return the compression factor of Eq. (6): the ball rolls off the face that it met at ``along`` [m/s]."""
    return 7.0 * radius * spin / (5.0 * along)


SPIN_FACTOR = _rolling_factor(units.to_si(PUBLISHED["spin_rpm"], "rpm"), RADIUS, SPEED * math.sin(LOFT))
"""The factor of Eq. (6) that their spin means."""


def spin_factor(found: Impact) -> float:
    """Return the compression factor that follows from the backspin by equation 6 of Roh and Lee.

    In that equation the ball rolls off the face. Roh and Lee derive their f from the forces instead, by equations 9 and
    11. NaN for a blow without velocity along the face.
    """
    approach = sum(found.relative_velocity()[:1, 1])
    if not approach > 0.0:
        return math.nan
    return float(_rolling_factor(found.outcome()["backspin"], 0.5 * found.ball.diameter, approach))


def document(found: Impact) -> dict[str, Any]:
    """Return the document that ``clubface fem paper --json`` prints."""
    return {
        **table(found),
        "energy_error": found.energy_error,
        "elements": found.elements,
        "steps": found.steps,
        "wall_s": found.wall,
    }
