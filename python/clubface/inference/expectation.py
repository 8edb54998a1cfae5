"""What a prior expects to be measured: how surprising a shot is, and whether it is out of reach."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.measured.shots import QUANTITIES
from clubface.simulation.delivery import OF_CLUB
from clubface.support.arrays import Floats

DRAWS = 4000
"""Deliveries of the prior whose launches tell what it expects."""
FAR = 3.29
"""Standard deviations beyond which one in a thousand of normally distributed values lies."""


class UnreachableLaunchError(InputError):
    """A launch so far from those of the prior that no delivery can be inferred for it."""


class Expectation:
    """What a prior expects of some quantities that are measured with normally distributed noise.

    Parameters
    ----------
    seen
        Computes what is shown of points of a standard normal prior: (n, dimensions) to (n, quantities), NaN for those
        that cannot be computed.
    names
        The quantities.
    scale
        Standard deviations of the measurement [SI].
    dimensions, seed
        Of the points.
    """

    def __init__(
        self, seen: Callable[[Floats], Floats], names: Sequence[str], scale: Floats, dimensions: int, seed: int
    ) -> None:
        values = seen(np.random.default_rng([seed, 1]).standard_normal((DRAWS, dimensions)))
        values = values[np.isfinite(values).all(axis=1)]
        self.names = tuple(names)
        self.mean = values.mean(axis=0)
        """Mean of each quantity."""
        self.spread = values.std(axis=0)
        """Standard deviation of each quantity, without noise."""
        self._scale = scale
        self._covariance = np.atleast_2d(np.cov(values.T)) + np.diag(scale**2)
        noise = scale * np.random.default_rng([seed, 2]).standard_normal(values.shape)
        away = values + noise - self.mean
        self._distances = np.sort(np.sum(away * np.linalg.solve(self._covariance, away.T).T, axis=1))

    def surprise(self, measured: Floats) -> float:
        """Return the probability of a shot that lies further from the expected mean than the one ``measured``.

        The distance is measured with the covariance of what is expected, noise included. For normally distributed
        values it has a chi-squared distribution.
        """
        away = measured - self.mean
        nearer = np.searchsorted(self._distances, float(away @ np.linalg.solve(self._covariance, away)))
        return float((1.0 + self._distances.size - nearer) / (1.0 + self._distances.size))

    def far(self, measured: Floats) -> list[str]:
        """Return the quantities that are by themselves further from what is expected than one in a thousand."""
        away = np.abs(measured - self.mean) > FAR * np.hypot(self.spread, self._scale)
        return [name for name, each in zip(self.names, away, strict=True) if each]

    def told(self, names: Sequence[str]) -> str:
        """Return in words what is expected of some of the quantities."""
        places = [self.names.index(name) for name in names]
        return ", ".join(
            f"{self.names[place]} {shown(self.names[place], float(self.mean[place]), 3)} +-"
            f" {shown(self.names[place], float(self.spread[place]), 2)}"
            for place in places
        )


def shown(name: str, value: float, digits: int) -> str:
    """Write a value [SI] of a launch or delivery with its unit."""
    return units.show(value, unit_of(name), digits)


def unit_of(name: str) -> str:
    """Return the unit a quantity of a launch or a delivery is read in."""
    if name in QUANTITIES:
        return QUANTITIES[name]
    return "mph" if name == "speed" else units.display_unit(name, units.SI_UNITS[OF_CLUB[name]])


def unreachable(measured: Mapping[str, float], expected: Expectation, who: str) -> UnreachableLaunchError:
    """Return the error for a shot that the prior ``who`` cannot reach."""
    given = ", ".join(f"{name} {shown(name, value, 4)}" for name, value in measured.items())
    advice = (
        f"within reach of {who} expects {expected.told(expected.names)}: if units and club are right, give a prior that"
        " suits the golfer"
    )
    return UnreachableLaunchError("launch", given, advice)
