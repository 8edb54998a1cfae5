"""Profile likelihoods: how well the shots can be explained with one parameter held and all others fitted anew.

A. Raue et al., Structural and practical identifiability analysis of partially observed dynamical models by exploiting
the profile likelihood, Bioinformatics 25 (2009) 1923-1929.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from clubface.identification.cost import cost_of
from clubface.identification.refine import refine
from clubface.identification.simulator import Simulator
from clubface.support.arrays import Floats

CHI_SQUARE_95 = 3.841458820694124
"""95% quantile of chi-square with one degree of freedom."""
STEPS = (0.7, 1.4, 2.1, 2.8, 4.0, 6.0, 9.0, 13.0, 20.0)
"""Places of a profile on each side, in standard errors."""
WIDEST = 0.15
"""Standard error taken for the steps of a parameter the data do not tell of, in parts of the range."""
NEAR = 1e-2
"""A fit ends where minus twice the logarithm of the likelihood would fall by less."""


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile likelihood of one parameter.

    Attributes
    ----------
    name
        Name of the parameter.
    values
        Values at which it was held [SI], increasing, shape (places,).
    rise
        Minus twice the logarithm of the likelihood, above its least value, shape (places,).
    interval
        The least and the greatest value at which the rise is below 3.84 [SI]: the 95% interval.
    closed
        For either end, whether the rise reaches 3.84 inside the bounds. Where it does not, that end of the interval is
        a bound, and the shots do not determine the parameter on that side.
    """

    name: str
    values: Floats
    rise: Floats
    interval: tuple[float, float]
    closed: tuple[bool, bool]

    @property
    def verdict(self) -> str:
        """Whether the shots determine the parameter: "yes", "from below only", "from above only" or "no"."""
        if all(self.closed):
            return "yes"
        if any(self.closed):
            return "from below only" if self.closed[0] else "from above only"
        return "no"


def outside(value: float, interval: tuple[float, float], profile: Profile | None) -> bool:
    """Return whether an interval of a parameter, or that of its profile, does not hold its value [SI]."""
    spans = [interval] if profile is None else [interval, profile.interval]
    # To rounding: the end of an interval may be the value itself, by way of the unit cube.
    return any(not low - abs(low) * 1e-9 <= value <= high + abs(high) * 1e-9 for low, high in spans)


class Profiler:
    """Makes profiles of the parameters of a fit.

    Parameters
    ----------
    simulator
        Of all shots.
    noise
        Standard deviation of each quantity [SI].
    errors
        Standard errors of the coordinates of the unit cube.
    """

    def __init__(self, simulator: Simulator, noise: Floats, errors: Floats) -> None:
        shots = simulator.shots
        given = dict(zip(shots.quantities, noise.tolist(), strict=True))
        self.simulator = simulator
        self.cost = cost_of("least-squares", shots.launches, shots.quantities, noise=given)
        self.values_measured = int(np.isfinite(shots.launches).sum())
        self.errors = np.where(np.isfinite(errors), np.minimum(errors, WIDEST), WIDEST)

    def most_likely(self, fit: Floats) -> Floats:
        """Return the most likely point, which is that of least squares, starting from the fit by another cost."""
        return refine(self.simulator, self.cost, fit).point

    def profile(self, place: int, optimum: Floats) -> Profile:
        """Return the profile of the parameter at ``place`` of the free ones, from the most likely point."""
        centre = float(optimum[place])
        least = self.cost.value(self.simulator.launch(optimum))
        sides = [self._side(place, sign, optimum, least) for sign in (-1.0, 1.0)]
        table = [*reversed(sides[0]), (centre, least), *sides[1]]
        where = np.array([each[0] for each in table])
        costs = np.array([each[1] for each in table])
        rise = self.values_measured * (costs - costs.min())
        low, low_closed = _crossing(where, rise, -1)
        high, high_closed = _crossing(where, rise, 1)
        full = np.repeat(optimum[None, :], len(where), axis=0)
        full[:, place] = where
        ends = np.repeat(optimum[None, :], 2, axis=0)
        ends[:, place] = (low, high)
        free = self.simulator.free
        interval = free.values(ends)[:, place]
        return Profile(
            free.names[place], free.values(full)[:, place], rise, (float(interval[0]), float(interval[1])),
            (low_closed, high_closed),
        )  # fmt: skip

    def _side(self, place: int, sign: float, optimum: Floats, least: float) -> list[tuple[float, float]]:
        """Return places and costs from the optimum outwards, until the rise is clear or a bound is reached."""
        held = np.arange(len(optimum)) == place
        point = optimum
        found: list[tuple[float, float]] = []
        for step in STEPS:
            where = optimum[place] + sign * step * self.errors[place]
            end = not 0.0 < where < 1.0
            point = point.copy()
            point[place] = min(max(where, 0.0), 1.0)
            refined = refine(self.simulator, self.cost, point, held=held, fall=NEAR / self.values_measured)
            point = refined.point
            found.append((float(point[place]), refined.cost))
            if end or self.values_measured * (refined.cost - least) > 1.5 * CHI_SQUARE_95:
                break
        return found


def _crossing(where: Floats, rise: Floats, side: int) -> tuple[float, bool]:
    """Return where the rise passes 3.84 for the last time on one side, and whether it does.

    A profile may pass it, and fall below it again further out: what lies there is as likely.
    """
    likely = np.flatnonzero(rise <= CHI_SQUARE_95)
    place = int(likely[0 if side < 0 else -1])
    if not 0 <= place + side < len(rise):
        return float(where[place]), False
    # Linear in the root of the rise: exact for normal deviations and a linear model.
    inner, outer = np.sqrt(rise[place]), np.sqrt(rise[place + side])
    part = (np.sqrt(CHI_SQUARE_95) - inner) / (outer - inner)
    return float(where[place] + part * (where[place + side] - where[place])), True
