"""The case of Roh and Lee, "Analysis of golf ball spin mechanism at impact by FEM": their figures beside ours."""

from __future__ import annotations

import math
import os
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem.case import PLANE, Case, case
from clubface.fem.core import Progress
from clubface.fem.result import Impact

PUBLISHED: dict[str, float] = {
    "ball_speed_mps": 50.4,
    "launch_deg": 9.8,
    "club_speed_after_mps": 24.0,
    "spin_rpm": 2047.0,
    "peak_force_n": 6600.0,
    "peak_force_time_s": 280e-6,
    "reversal_time_s": 320e-6,
    "contraction": 0.23,
    "contraction_time_s": 300e-6,
    "f_prime": 0.8379,
    "f": 0.9476,
}
"""What Roh and Lee computed: Figs. 3 to 7, Eqs. (9) and (11)."""


def paper(which: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> Impact:
    """Run Roh and Lee's case, or a variation of it."""
    chosen = case(which)
    if chosen.head == PLANE:
        raise InputError("case", chosen.name, "a case with a head; for a throw at a plane use clubface fem run")
    return chosen.run(progress)


def table(found: Impact) -> dict[str, float]:
    """Return Roh and Lee's figures as computed, under the keys of ``PUBLISHED``."""
    launch = found.launch
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


SPIN_FACTOR = 7.0 * 0.0214 * units.parse("2047 rpm", "angular rate") / (5.0 * 35.0 * math.sin(math.radians(11.5)))
"""The factor of Eq. (6) that Roh and Lee's spin means."""


def spin_factor(found: Impact) -> float:
    """Return the compression factor that the backspin means by Eq. (6) of Roh and Lee: the ball rolls off the face.

    They derive their f from the forces instead, Eqs. (9) and (11). NaN for a blow without velocity along the face.
    """
    approach = sum(found.relative_velocity()[:1, 1])
    if not approach > 0.0:
        return math.nan
    return float(7.0 * 0.5 * found.ball.diameter * found.launch["backspin"] / (5.0 * approach))


def document(found: Impact) -> dict[str, Any]:
    """Return everything ``clubface fem paper --json`` prints."""
    return {
        **table(found),
        "energy_error": found.energy_error,
        "elements": found.elements,
        "steps": found.steps,
        "wall_s": found.wall,
    }
