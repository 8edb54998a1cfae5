"""What a club is judged by: numbers of the landings of many shots, with their derivatives by every landing."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.strokes import Hole, expected
from clubface.errors import InputError
from clubface.support.checks import check_choice

SHARE = 0.9
"""Of normally distributed shots that the landing ellipse holds."""

FINE, ROUGH = 1e-8, 1e-6
"""Precisions: of what is smooth, but for 1e-9 that the steps of flights leave in a mean, and of expected strokes, which
have kinks in distance and where a single ball begins to slide as it bounces."""

Judged = tuple[float, "NDArray[Any]"]
"""A value, and its derivatives by every landing, of the shape of the landings."""


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
        From landings [m], rows as in ``landings.LANDING``, to the value and its derivatives.
    one_shot
        Whether a single shot has it.
    precision
        Part of its value to which it is made best.
    """

    name: str
    meaning: str
    dimension: str
    unit: str
    sign: float
    judge: Callable[[NDArray[Any]], Judged]
    one_shot: bool
    precision: float = FINE


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
    weights = np.zeros_like(landed)
    weights[:2] = by_down * landed[0] / down, by_side - by_down * landed[1] / down
    return area, weights


OBJECTIVES = {
    each.name: each
    for each in (
        Objective("carry", "mean carry", "length", "yd", -1.0, carry, True),
        Objective("side_spread", "standard deviation of the side", "length", "yd", 1.0, side_spread, False),
        Objective("ellipse", f"area of the ellipse of {SHARE:.0%} of the landings", "area", "m2", 1.0, ellipse, False),
    )
}
"""The ways to judge that need nothing but landings."""


EDGE = 4.0
"""Width [m] over which one lie turns into another, so that expected strokes have derivatives; assumed."""
_STEP = 1e-3
"""Half the difference [m] by which expected strokes, straight lines between published distances, are differentiated."""


def strokes(hole: Hole) -> Objective:
    """Return the objective of the strokes expected on a hole after the shot, by where balls come to rest."""

    def judge(landed: NDArray[Any]) -> Judged:
        total, side = landed[2], landed[3]
        ahead = np.sqrt(np.maximum(total**2 - side**2, 1e-12))
        value, by_ahead, by_side = _after(hole, ahead, side)
        weights = np.zeros_like(landed)
        weights[2] = by_ahead * total / ahead
        weights[3] = by_side - by_ahead * side / ahead
        return float(value.mean()), weights / landed.shape[1]

    meaning = f"mean strokes to hole out after the shot, {units.fixed(hole.length, 'yd', 0)} hole"
    return Objective("strokes", meaning, units.DIMENSIONLESS, "1", 1.0, judge, True, ROUGH)


def _after(hole: Hole, ahead: NDArray[Any], side: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return strokes after balls have come to rest, and their derivatives by the place.

    They are those of ``Hole.after``, but for a band of ``EDGE`` where a ball lies partly in either of two lies.
    """
    off, left = np.abs(side), np.maximum(np.hypot(hole.length - ahead, side), 1e-6)
    rough, by_rough = _step(off - 0.5 * hole.fairway)
    trees, by_trees = _step(off - 0.5 * hole.fairway - hole.rough)
    away, by_away = _step(left - hole.green)
    lies = {name: _lie(name, left) for name in ("fairway", "rough", "recovery", "green")}
    (fair, fair_left), (deep, deep_left), (wild, wild_left), (putt, putt_left) = lies.values()
    off_green = fair + rough * (deep - fair) + trees * (wild - deep)
    value = putt + away * (off_green - putt)
    by_left = putt_left + away * (
        fair_left + rough * (deep_left - fair_left) + trees * (wild_left - deep_left) - putt_left
    ) + by_away * (off_green - putt)  # fmt: skip
    by_off = away * (by_rough * (deep - fair) + by_trees * (wild - deep))
    return value, -by_left * (hole.length - ahead) / left, by_left * side / left + by_off * np.sign(side)


def _step(beyond: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return how far a ball is across an edge, 0 to 1 without a corner, and the derivative."""
    part = np.clip(beyond / EDGE + 0.5, 0.0, 1.0)
    return part**2 * (3.0 - 2.0 * part), 6.0 * part * (1.0 - part) / EDGE


def _lie(name: str, left: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    above, below = expected(name, left + _STEP), expected(name, np.maximum(left - _STEP, 0.0))
    return 0.5 * (above + below), (above - below) / (2.0 * _STEP)


def objectives(hole: Hole | None) -> tuple[Objective, ...]:
    """Return all objectives that can be computed: expected strokes take a hole."""
    return (*OBJECTIVES.values(), *(() if hole is None else (strokes(hole),)))


def objective(name: str, hole: Hole | None = None) -> Objective:
    """Return an objective by its name."""
    if name == "strokes" and hole is None:
        raise InputError("hole", None, 'give [hole] with its length, as in length = "400 yd", for expected strokes')
    known = {each.name: each for each in objectives(hole)}
    check_choice("objective", name, known)
    return known[name]
