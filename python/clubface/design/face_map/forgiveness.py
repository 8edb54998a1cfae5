"""What impacts that scatter over a face cost: the mean and the spread of their launches and flights."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.comparison.quantities import QUANTITIES
from clubface.design.face_map.outline import Outline
from clubface.design.face_map.surface import Surface
from clubface.errors import InputError

NODES = 40
"""Of Gauss's rule across the face and up it."""
REACH = 6.0
"""Standard deviations to each side that are counted."""


class Forgiveness(NamedTuple):
    """What impacts around a point cost.

    Attributes
    ----------
    toe, high
        The point they scatter about [m].
    toe_deviation, high_deviation
        Their standard deviations [m].
    missed
        The share of swings that miss the face, of which nothing else is counted.
    mean, deviation
        Mean and standard deviation of every quantity of a map [SI], by name.
    loss
        By how much the mean is below the value at the point they scatter about [SI], by name.
    """

    toe: float
    high: float
    toe_deviation: float
    high_deviation: float
    missed: float
    mean: dict[str, float]
    deviation: dict[str, float]
    loss: dict[str, float]


def forgiveness(surface: Surface, outline: Outline, spread: tuple[Any, Any], toe: Any, high: Any) -> Forgiveness:
    """Return what impacts cost that scatter over a face; see :meth:`clubface.FaceMap.forgiveness`.

    Expectations are integrals over the face by Gauss's rule: across it, and at each place from its lower to its upper
    edge.
    """
    if not isinstance(spread, (tuple, list)) or len(spread) != 2:
        raise InputError("spread", spread, "two standard deviations, towards the toe and upwards")
    deviations = [units.parse(each, "length", name="spread") for each in spread]
    about = [units.parse(each, "length", name=name) for each, name in ((toe, "toe"), (high, "high"))]
    size = outline.greatest - outline.least
    for each, most in zip(deviations, size, strict=True):
        if not 0.0 < each <= most:
            raise InputError("spread", units.show(each, "mm"), f"above 0 and at most {units.show(most, 'mm', 3)}")
    if not outline.holds(*about):
        raise InputError("the point", ", ".join(units.show(each, "mm") for each in about), "on the face")
    across, up, weights = _rule(outline, about, deviations)
    table = surface.at(across, up)
    good = np.isfinite(table).all(axis=0)
    weights = np.where(good, weights, 0.0)
    hit = float(weights.sum())
    table = np.where(good, table, 0.0)
    mean = table @ weights / hit
    deviation = np.sqrt(np.maximum((table - mean[:, None]) ** 2 @ weights / hit, 0.0))
    middle = surface.at(np.array([about[0]]), np.array([about[1]]))[:, 0]
    named = [dict(zip(QUANTITIES, map(float, each), strict=True)) for each in (mean, deviation, middle - mean)]
    return Forgiveness(about[0], about[1], deviations[0], deviations[1], max(0.0, 1.0 - hit), *named)


def _rule(
    outline: Outline, about: list[float], deviations: list[float]
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return points of the face and their weights, which add up to the share of swings that hit it."""
    places, weights = np.polynomial.legendre.leggauss(NODES)
    left = max(float(outline.least[0]), about[0] - REACH * deviations[0])
    right = min(float(outline.greatest[0]), about[0] + REACH * deviations[0])
    across = left + (right - left) * (0.5 + 0.5 * places)
    by_toe = weights * 0.5 * (right - left) * _density(across, about[0], deviations[0])
    low, top = outline.extent(across)
    low = np.maximum(low, about[1] - REACH * deviations[1])
    top = np.maximum(np.minimum(top, about[1] + REACH * deviations[1]), low)
    up = low[:, None] + (top - low)[:, None] * (0.5 + 0.5 * places)
    by_high = weights * 0.5 * (top - low)[:, None] * _density(up, about[1], deviations[1])
    return np.repeat(across, NODES), up.reshape(-1), (by_toe[:, None] * by_high).reshape(-1)


def _density(values: NDArray[Any], middle: float, deviation: float) -> NDArray[Any]:
    return np.exp(-0.5 * ((values - middle) / deviation) ** 2) / (deviation * math.sqrt(2.0 * math.pi))
