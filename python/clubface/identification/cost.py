"""The cost that an identification minimises: that of Caldwell and McPhee (2023), and two weighted by the noise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.evaluation.noise import MONITOR
from clubface.simulation.quantities import outputs
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_names

Loss = Literal["absolute", "squares", "huber"]

LOSSES: dict[str, Loss] = {"published": "absolute", "least-squares": "squares", "robust": "huber"}
"""The loss of each cost by its name."""

NORMALISERS = ("absolute", "signed")

NOISE = {"ball_speed": units.to_si(0.5, "mph"), **MONITOR}
"""Standard deviations of a launch monitor [SI]: angles and spin after Caldwell and McPhee (2023), section 4; the
0.5 mph of ball speed is assumed."""

HUBER = 1.345
"""Where Huber's loss turns from square to linear, in units of the noise: 95% efficient for normal noise.

P. J. Huber, Robust estimation of a location parameter, Annals of Mathematical Statistics 35 (1964).
"""


@dataclass(frozen=True, eq=False)
class Cost:
    """A sum over quantities and shots of a loss of the deviations ``simulated - measured``.

    Attributes
    ----------
    loss
        "absolute": weight |deviation|; "squares": weight deviation^2; "huber": weight times Huber's loss of
        deviation / knee, times knee^2, which is deviation^2 up to the knee.
    measured
        Shape (quantities, shots), 0 where nothing was measured.
    weights
        The same shape, 0 where nothing was measured.
    knees
        Of Huber's loss [SI], shape (quantities,).
    """

    loss: Loss
    measured: Floats
    weights: Floats
    knees: Floats

    def of(self, simulated: Floats) -> Floats:
        """Return the cost of launches of shape (quantities, ..., shots), shape (...); infinite where one is NaN."""
        total = np.zeros(simulated.shape[1:-1])
        for quantity in range(len(simulated)):
            losses = self._losses(simulated[quantity] - self.measured[quantity], self.knees[quantity])
            losses *= self.weights[quantity]
            # Over the last, contiguous axis: the same sum for one point as for a population.
            total += losses.sum(axis=-1)
        return np.where(np.isnan(total), np.inf, total)

    def select(self, which: NDArray[Any], counts: NDArray[np.int64]) -> Cost:
        """Return the cost of some of the shots, each counting as often as ``counts`` says, with the same weights."""
        return Cost(self.loss, self.measured[:, which], self.weights[:, which] * counts, self.knees)

    def absolute(self) -> Cost:
        """Return the sum of absolute deviations, each in the unit in which its loss is 1."""
        return Cost("absolute", self.measured, np.sqrt(self.weights), self.knees)

    def value(self, simulated: Floats) -> float:
        """Return the cost of launches of shape (quantities, shots)."""
        return float(self.of(simulated[:, None, :])[0])

    def _losses(self, deviations: Floats, knee: float) -> Floats:
        sizes = np.abs(deviations)
        if self.loss == "absolute":
            return sizes
        if self.loss == "squares":
            return sizes * sizes
        return np.where(sizes <= knee, sizes * sizes, knee * (2.0 * sizes - knee))


def cost_of(
    kind: str,
    launches: Floats,
    quantities: tuple[str, ...],
    *,
    noise: Mapping[str, Any] | None = None,
    normaliser: str = "absolute",
) -> Cost:
    """Return the cost function of measured launches.

    Parameters
    ----------
    kind
        "published" is equation 22 of Caldwell and McPhee (2023): the mean absolute deviation of each quantity divided
        by its normaliser, summed over the quantities. "least-squares" is the mean of (deviation / noise)^2. "robust" is
        the same with Huber's loss.
    launches
        Measured values [SI], shape (quantities, shots). NaN marks a value that was not measured; it does not count.
    quantities
        Names of the rows.
    noise
        Standard deviations of the measurement by quantity, as text with a unit or as SI numbers. They replace those of
        :data:`NOISE`.
    normaliser
        For "published": "absolute" is the mean magnitude of the measured values. "signed" is the magnitude of their
        mean, as the equation is printed; it vanishes for azimuth and sidespin of players who miss on both sides.

    Raises
    ------
    InputError
        A normaliser is below the noise of its quantity, so that the mean says nothing about the size of the values.
    """
    check_choice("cost", kind, LOSSES)
    check_choice("normaliser", normaliser, NORMALISERS)
    deviations = noise_of(quantities, noise)
    there = np.isfinite(launches)
    measured = np.where(there, launches, 0.0)
    per_quantity = there.sum(axis=1)
    if kind == "published":
        scale = _normalisers(measured, there, quantities, normaliser, deviations)
        each = 1.0 / (per_quantity * scale)
    else:
        each = 1.0 / (per_quantity.sum() * deviations**2)
    return Cost(LOSSES[kind], measured, there * each[:, None], HUBER * deviations)


def noise_of(quantities: tuple[str, ...], given: Mapping[str, Any] | None = None) -> Floats:
    """Return the standard deviation of each quantity [SI]: :data:`NOISE`, with the values ``given`` replaced."""
    given = dict(given or {})
    check_names("quantity with noise", given, quantities)
    found = []
    for name in quantities:
        told = given.get(name, NOISE.get(name))
        if told is None:
            raise InputError(f"noise of {name}", None, "give it, since no default noise is known for this quantity")
        value = units.parse(told, outputs()[name].dimension, name=f"noise of {name}")
        if not 0.0 < value < np.inf:
            raise InputError(f"noise of {name}", told, "positive")
        found.append(value)
    return np.array(found)


def _normalisers(
    measured: Floats, there: NDArray[np.bool_], quantities: tuple[str, ...], normaliser: str, noise: Floats
) -> Floats:
    values = np.abs(measured) if normaliser == "absolute" else measured
    means = np.abs(values.sum(axis=1) / there.sum(axis=1))
    for name, mean, least in zip(quantities, means, noise, strict=True):
        if mean < least:
            symbol = units.display_unit(name, outputs()[name].unit)
            what = "|measured|" if normaliser == "absolute" else "measured values"
            advice = "leave the quantity out" + (", or take the absolute normaliser" if normaliser == "signed" else "")
            shown = units.show(float(mean), symbol, 3)
            raise InputError(
                f"the mean of {what} of {name}", shown,
                f"above its noise, {units.show(float(least), symbol, 3)}, to divide by; {advice}",
            )  # fmt: skip
    return means
