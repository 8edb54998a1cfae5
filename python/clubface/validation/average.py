"""What a published average leaves open: the scatter of the shots behind it, and where a driver was struck.

The mean of many shots is not the shot of the mean delivery. A face that scatters to both sides of the path adds spin to
every shot, whichever side it is on, and strikes that scatter about a point are slower than one at the point. So a
published average belongs to a mean delivery whose shot may have had less spin, and more speed, than the average. Of a
driver the height of the strike is not published either, and at one launch angle a higher strike spins less.

Both are computed with the default model, whatever model is judged, so that the interval is the same for all. Speed,
attack angle and loft scatter too; the means hardly notice, since the launch is nearly linear in them.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.models import DEFAULT_MODEL
from clubface.support.arrays import Floats
from clubface.validation.check import Judged, rows

HEIGHTS = tuple(units.parse(each, "length") for each in ("0 mm", "3 mm", "6 mm"))
"""Strikes on a driver above its face centre: the middle one is computed, the others bound what it may have been."""
CENTRE = (0.0,)
"""Of other clubs."""
DRIVER, WOODS = "driver", ("3-wood", "5-wood", "hybrid")
FACE_NODES, STRIKE_NODES = 5, 3
"""Points of the Gauss-Hermite quadrature over face-to-path, and over each coordinate of the strike."""
QUANTITIES = ("ball_speed", "total_spin")


class Scatter(NamedTuple):
    """Standard deviations of face-to-path [rad], whose mean is 0, and of the impact point [m] about its mean."""

    face_to_path: float
    toe: float
    high: float


def scatter(club: str, drive_speed: float) -> Scatter:
    """Return how golfers scatter whose drives have a club speed [m/s].

    A drive starts away from its path by the share of face-to-path that PING has measured (launch-shares-horizontal).
    Their irons get the same face-to-path, and no scatter of the strike, since that on irons is not published.
    """
    group = max(
        (row for row in rows("drive-scatter-blackmore") if row["club_speed_least"] <= drive_speed),
        key=lambda row: row["club_speed_least"],
    )
    (share,) = (row["share"] for row in rows("launch-shares-horizontal") if row["club"] == "driver")
    strike = (group["toe"], group["high"]) if club in (DRIVER, *WOODS) else (0.0, 0.0)
    return Scatter(group["start_to_path"] / share, *strike)


def scattered(scatter: Scatter) -> tuple[dict[str, Floats], Floats]:
    """Return face angles and impact points that stand for normally distributed ones, and their weights, of sum 1."""
    axes = [
        (spread * places, weights / weights.sum())
        for spread, (places, weights) in zip(
            scatter, map(np.polynomial.hermite_e.hermegauss, (FACE_NODES, STRIKE_NODES, STRIKE_NODES)), strict=True
        )
    ]
    face, toe, high = (np.array(each) for each in zip(*itertools.product(*(axis for axis, _ in axes)), strict=True))
    weights = np.array([math.prod(each) for each in itertools.product(*(weights for _, weights in axes))])
    return {"face": face, "toe": toe, "high": high}, weights


@cache
def ratios(
    club: str, speed: float, attack: float, launch: float, scatter: Scatter | None, heights: Sequence[float]
) -> dict[str, tuple[float, float]]:
    """Return the least and the largest ratio of the shot that is computed to what may have been published, by quantity.

    The shot that is computed is struck at the middle of ``heights`` and launches at an angle [rad]. What may have been
    published is the shot of any of the heights with the same launch angle, or the mean of shots that scatter about it.
    """
    reference = Judged(DEFAULT_MODEL)
    shots = reference.at_launch(club, launch, speed=speed, attack=attack, high=np.array(heights))
    possible = {name: [float(each) for each in getattr(shots, name)] for name in QUANTITIES}
    computed = {name: values[len(heights) // 2] for name, values in possible.items()}
    if scatter is not None:
        places, weights = scattered(scatter)
        for height, loft in zip(heights, shots.delivery["loft"], strict=True):
            where: dict[str, Any] = {"face": places["face"], "toe": places["toe"], "high": height + places["high"]}
            many = reference.hit(club, speed=speed, attack=attack, loft=loft, **where)
            for name in QUANTITIES:
                possible[name].append(float(weights @ getattr(many, name)))
    return {name: (computed[name] / max(values), computed[name] / min(values)) for name, values in possible.items()}
