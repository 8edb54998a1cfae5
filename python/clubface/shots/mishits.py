"""Mishits and robust statistics of the other shots: the one rule for summarising shots of a club.

One topped drive moves the mean of ten by as much as a new driver would, so summaries use medians, and spreads leave out
mishits. A shot is a mishit if its ball speed or carry falls short, or its launch angle or start direction is off, by
more than ``FARTHEST`` robust standard deviations of the shots with the same club, and by a visible amount (``LEAST``).
The robust standard deviation is 1.4826 times the median absolute deviation, times n / (n - 0.8) for a small number n of
shots (C. Croux and P. J. Rousseeuw, Time-efficient algorithms for two highly robust estimators of scale, Computational
Statistics 1, 411-428, 1992). The limit of 3.5 is from B. Iglewicz and D. C. Hoaglin, How to detect and handle outliers,
ASQC Quality Press, 1993.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.support.arrays import Floats
from clubface.units import to_si

FARTHEST = 3.5
"""Number of robust standard deviations beyond which a shot is a mishit."""
LEAST = {"ball_speed": 0.1, "carry": 0.15, "launch": to_si(6.0, "deg"), "azimuth": to_si(10.0, "deg")}
"""Minimum shortfall of a mishit relative to the median, or deviation of its angle [rad]; assumed."""
SHORT = ("ball_speed", "carry")
"""Quantities for which only values that are too small count."""
FEWEST = 5
"""Minimum number of shots with a club for finding mishits."""
MOST = 1 / 3
"""Largest share of mishits; with more, shots are of two kinds, such as full and half swings, and none is a mishit."""


class Mishit(NamedTuple):
    """A quantity that makes a shot a mishit, SI."""

    place: int  # index of the shot
    quantity: str  # quantity that is far off
    value: float
    median: float  # of all shots


class Statistic(NamedTuple):
    """Statistics of one quantity over the shots of a club, in SI units.

    Attributes
    ----------
    shots
        Number of shots in which it was measured, without mishits.
    median, spread, low, high
        Median and standard deviation of these (NaN for a single shot), and the range of their middle two thirds.
    measured
        Number of shots in which it was measured, including mishits.
    mean, deviation, usual_mean
        Mean and standard deviation of all measured shots, and mean without mishits.
    """

    shots: int
    median: float
    spread: float
    low: float
    high: float
    measured: int
    mean: float
    deviation: float
    usual_mean: float

    @property
    def error(self) -> float:
        """Standard error of the median: the standard error of the mean of normal shots times the root of pi / 2.

        The factor holds for many shots. For two, the median is the mean; for few, it is too large by some per cent.
        """
        return math.sqrt((math.pi / 2.0 if self.shots > 2 else 1.0) / self.shots) * self.spread

    @property
    def margin(self) -> float:
        """Half width of the 95% confidence interval of the median by Student's t; NaN for a single shot."""
        return math.nan if self.shots < 2 else _student(self.shots - 1) * self.error


def find_mishits(values: Mapping[str, Floats]) -> list[Mishit]:
    """Return the mishits among shots of one club, one entry per reason; ``values`` are the quantities [SI] by name."""
    reasons = []
    for name, least in LEAST.items():
        measured = values.get(name, np.empty(0))
        known = measured[np.isfinite(measured)]
        if known.size < FEWEST:
            continue
        middle = float(np.median(known))
        robust = 1.4826 * known.size / (known.size - 0.8) * float(np.median(np.abs(known - middle)))
        if name in SHORT:
            off = measured < middle - max(FARTHEST * robust, least * abs(middle))
        else:
            off = np.abs(measured - middle) > max(FARTHEST * robust, least)
        reasons += [Mishit(int(place), name, float(measured[place]), middle) for place in np.flatnonzero(off)]
    count = max((each.size for each in values.values()), default=0)
    if len({each.place for each in reasons}) > MOST * count:
        return []
    return sorted(reasons, key=lambda each: each.place)


def is_mishit(mishits: list[Mishit], count: int) -> NDArray[np.bool_]:
    """Return the mask, of length ``count``, of the shots among ``mishits``."""
    return np.isin(np.arange(count), [each.place for each in mishits])


def statistic(values: Floats, mishit: NDArray[np.bool_] | None = None) -> Statistic | None:
    """Return the statistics of values, with a mask of mishits (used if all are); None if nothing was measured."""
    known = np.isfinite(values)
    every = values[known]
    if not every.size:
        return None
    usual = every if mishit is None else values[known & ~mishit]
    usual = usual if usual.size else every
    low, high = np.quantile(usual, [1 / 6, 5 / 6])
    spread, deviation = (float(each.std(ddof=1)) if each.size > 1 else math.nan for each in (usual, every))
    return Statistic(int(usual.size), float(np.median(usual)), spread, float(low), float(high), int(every.size),
                     float(every.mean()), deviation, float(usual.mean()))  # fmt: skip


def difference_error(one: Statistic, other: Statistic) -> float:
    """Return the half width of the 95% interval of the difference of two medians, by Welch's test (1947)."""
    parts = [each.error**2 for each in (one, other)]
    total = sum(parts)
    if total == 0.0:
        return 0.0
    freedom = total**2 / sum(part**2 / (each.shots - 1) for part, each in zip(parts, (one, other), strict=True))
    return _student(freedom) * math.sqrt(total)


def _student(freedom: float) -> float:
    """Return the two-sided 95% quantile of Student's t."""
    from scipy.special import stdtrit

    return float(stdtrit(freedom, 0.975))
