"""What a club is judged by: numbers of the landings of many shots, with their derivatives by every landing."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface.errors import UnknownNameError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SHARE = 0.9
"""Of normally distributed shots that the landing ellipse holds."""

Judged = tuple[float, "NDArray[Any]"]
"""A value, and its derivatives by carry and side of every shot, shape (2, shots)."""


class Objective(NamedTuple):
    """One way to judge landings.

    Attributes
    ----------
    name
        As a study file names it.
    meaning
        In a line.
    dimension, unit
        Of the value, and the unit it is shown in.
    sign
        -1 if more is better, +1 if less is.
    judge
        From landings, shape (2, shots): carry and side [m], to the value and its derivatives.
    one_shot
        Whether a single shot has it.
    """

    name: str
    meaning: str
    dimension: str
    unit: str
    sign: float
    judge: Callable[[NDArray[Any]], Judged]
    one_shot: bool


def carry(landed: NDArray[Any]) -> Judged:
    """Judge by the mean carry [m]."""
    weights = np.zeros_like(landed)
    weights[0] = 1.0 / landed.shape[1]
    return float(landed[0].mean()), weights


def side_spread(landed: NDArray[Any]) -> Judged:
    """Judge by the standard deviation of the side [m], 0 for a single shot."""
    weights, deviation = np.zeros_like(landed), landed[1] - landed[1].mean()
    spread = math.sqrt(float(np.mean(deviation**2)))
    if spread > 0.0:
        weights[1] = deviation / (spread * landed.shape[1])
    return spread, weights


def ellipse(landed: NDArray[Any]) -> Judged:
    """Judge by the area [m2] of the ellipse that holds ``SHARE`` of shots with this mean and covariance.

    With the covariance C of the distance down the target line and of the side it is pi q sqrt(det C), where q is the
    quantile of chi squared with two degrees of freedom, -2 log(1 - SHARE).
    """
    down = np.sqrt(np.maximum(landed[0] ** 2 - landed[1] ** 2, 1e-12))
    around = np.array([down - down.mean(), landed[1] - landed[1].mean()])
    covariance = around @ around.T / landed.shape[1]
    determinant = covariance[0, 0] * covariance[1, 1] - covariance[0, 1] ** 2
    area = math.pi * -2.0 * math.log1p(-SHARE) * math.sqrt(max(determinant, 0.0))
    if area == 0.0:
        return 0.0, np.zeros_like(landed)
    # d sqrt(det C) = sqrt(det C) / 2 trace(C^-1 dC), and dC = 2 / n (around)(d around)'
    by_place = area / landed.shape[1] * np.linalg.solve(covariance, around)
    by_down, by_side = by_place
    return area, np.array([by_down * landed[0] / down, by_side - by_down * landed[1] / down])


OBJECTIVES = {
    each.name: each
    for each in (
        Objective("carry", "mean carry", "length", "yd", -1.0, carry, True),
        Objective("side_spread", "standard deviation of the side", "length", "yd", 1.0, side_spread, False),
        Objective("ellipse", f"area of the ellipse of {SHARE:.0%} of the landings", "area", "m2", 1.0, ellipse, False),
    )
}
"""The ways to judge that need nothing but landings."""


def objective(name: str, others: dict[str, Objective] | None = None) -> Objective:
    """Return an objective by its name; ``others`` are those a study defines."""
    known = {**OBJECTIVES, **(others or {})}
    if name not in known:
        raise UnknownNameError("objective", name, known)
    return known[name]
