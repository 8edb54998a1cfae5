"""The spread of a golfer's shots by derivatives: what the first two terms of Taylor's series make of the distribution.

With the gradient g and the matrix H of second derivatives at the mean delivery, and the covariance C of shots that are
no mishits, a quantity f of normally distributed deliveries has

    mean = f + tr(H C) / 2,    variance = g' C g + tr(H C H C) / 2,

exactly where it has no derivatives beyond the second, and otherwise to the second order of the spreads. A mishit with
the probability s is c times as far off, so that the second moments of the shots are m2 = 1 - s + s c^2 times, and their
fourth ones m4 = 1 - s + s c^4 times as large:

    mean = f + m2 tr(H C) / 2,    variance = m2 g' C g + m4 tr(H C H C) / 2 + (m4 - m2^2) tr(H C)^2 / 4.

The gradients are exact; the second derivatives are differences of gradients on both sides of the mean.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from clubface.design.dispersion.hitting import Hitting
from clubface.design.dispersion.tally import LAUNCHED
from clubface.design.golfer.golfer import Golfer
from clubface.errors import InputError, RangeWarning
from clubface.simulation.flight_derivatives import flight_derivatives
from clubface.simulation.flight_inputs import SPIN, VELOCITY
from clubface.simulation.quantities import flight_inputs, flight_outputs
from clubface.simulation.sensitivity import sensitivity
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice
from clubface.support.warning import without_warnings

FLOWN = ("carry", "side", "total", "total_side")
"""What is differentiated of flights."""
STEP = 0.1
"""Distance from the mean at which gradients are taken for second derivatives, in standard deviations."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ByDerivatives:
    """Spread by derivatives, in SI units.

    Attributes
    ----------
    golfer
        Whose shots.
    value
        What the mean delivery gives, by quantity.
    gradient
        Derivatives of each quantity by the golfer's variables, shape (k,).
    second
        Second derivatives of each quantity, shape (k, k).
    """

    golfer: Golfer
    value: Mapping[str, float]
    gradient: Mapping[str, Floats]
    second: Mapping[str, Floats]

    def mean(self, name: str) -> float:
        """Return the mean of a quantity, to the second order."""
        check_choice("quantity", name, self.value)
        m2, _ = moments(self.golfer)
        return self.value[name] + 0.5 * m2 * float(np.trace(self.second[name] @ self.golfer.covariance))

    def variance(self, name: str, *, order: int = 2) -> float:
        """Return the variance of a quantity: of the gradient alone (``order`` 1), or of gradient and curvature."""
        check_choice("quantity", name, self.value)
        if order not in (1, 2):
            raise InputError("order", order, "1 or 2")
        m2, m4 = moments(self.golfer)
        slope, covariance = self.gradient[name], self.golfer.covariance
        first = m2 * float(slope @ covariance @ slope)
        if order == 1:
            return first
        curved = self.second[name] @ covariance
        return first + 0.5 * m4 * float(np.trace(curved @ curved)) + 0.25 * (m4 - m2**2) * float(np.trace(curved)) ** 2

    def spread(self, name: str, *, order: int = 2) -> float:
        """Return the standard deviation of a quantity."""
        return float(np.sqrt(self.variance(name, order=order)))


def moments(of: Golfer) -> tuple[float, float]:
    """Return the mean square and the mean fourth power of the factor by which shots are further off than no mishits."""
    share, scale = of.mishit_share, of.mishit_scale
    return 1.0 - share + share * scale**2, 1.0 - share + share * scale**4


def by_derivatives(of: Golfer, hit: Hitting) -> ByDerivatives:
    """Differentiate what a golfer's mean shot gives.

    Parameters
    ----------
    of
        The golfer, of the club's hand.
    hit
        How shots are hit. Its model must be one with derivatives; another is an :class:`InputError`.
    """
    value, gradient = _gradients(of.mean, of, hit)
    second = {name: np.zeros((len(of.mean),) * 2) for name in gradient}
    for place, spread in enumerate(of.spread):
        if spread == 0.0:
            continue  # what does not vary needs no curvature
        step = np.zeros_like(of.mean)
        step[place] = STEP * spread
        above, below = (_gradients(of.mean + side * step, of, hit)[1] for side in (1.0, -1.0))
        for name in gradient:
            second[name][place] = (above[name] - below[name]) / (2.0 * step[place])
    second = {name: 0.5 * (matrix + matrix.T) for name, matrix in second.items()}
    return ByDerivatives(golfer=of, value=value, gradient=gradient, second=second)


def _gradients(at: Floats, of: Golfer, hit: Hitting) -> tuple[dict[str, float], dict[str, Floats]]:
    """Return quantities at a delivery and their derivatives by the variables."""
    values = dict(zip(of.variables, map(float, at), strict=True))
    launched = (*VELOCITY, *SPIN)
    with without_warnings(RangeWarning):  # it is told of the shots
        found = sensitivity(
            hit.club, values, model=hit.model, parameters=hit.parameters, ball=getattr(hit.ball, "rigid", hit.ball),
            accuracy=hit.accuracy, outputs=(*LAUNCHED, *launched), variables=of.variables,
        )  # fmt: skip
    rows: dict[str, Floats] = dict(zip(found.outputs, found.si, strict=True))
    value = {name: float(getattr(found.launch, name)) for name in LAUNCHED}
    slope = {name: rows[name] for name in LAUNCHED}
    if hit.flight:
        flown = flight_derivatives(found.launch, air=hit.air, wind=hit.wind, ground=hit.ground)
        order = list(flight_outputs())
        columns = [list(flight_inputs()).index(name) for name in launched]
        chain = flown.jacobian[:, columns] @ np.array([rows[name] for name in launched])
        slope |= {name: chain[order.index(name)] for name in FLOWN}
        value |= {name: flown.values[name] for name in FLOWN}
    return value, slope
