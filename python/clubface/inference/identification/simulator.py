"""Launches of all shots for candidate parameters, with exact derivatives, and the cost of their errors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.errors import InputError
from clubface.inference.evaluation.statistics import MONITOR, standard_deviations
from clubface.inference.identification.problem import FreeParameters, PreparedShots
from clubface.quantities import display_unit
from clubface.simulation.launch_conditioned import solve_angles
from clubface.simulation.results import outputs
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import check_choice, check_names

MOST_ROWS = 1 << 18
"""Largest number of impacts in one call, for less than 200 MB of memory; a usual generation, 110 000, is one call."""


@dataclass
class Effort:
    """Computing effort so far: parameter sets evaluated on all shots, and impacts."""

    evaluations: int = 0
    impacts: int = 0

    def add(self, evaluations: int, shots: int) -> None:
        """Add evaluations on a number of shots."""
        self.evaluations += evaluations
        self.impacts += evaluations * shots

    def since(self, before: Effort) -> Effort:
        """Return the difference from ``before``."""
        return Effort(self.evaluations - before.evaluations, self.impacts - before.impacts)


@dataclass
class Simulator:
    """Computes the launches of measured shots at points of the unit cube of free parameters, counting the effort.

    ``accuracy`` is the relative tolerance per contact step, None for the fast setting; 0 ``threads`` means all cores.
    """

    shots: PreparedShots
    free: FreeParameters
    accuracy: float | None = None
    threads: int = 0
    effort: Effort = field(default_factory=Effort)

    def __post_init__(self) -> None:
        self._places = self.shots.output_places()[: len(self.shots.quantities)]
        self._tiled: dict[int, list[float | Floats]] = {}

    def of(self, shots: PreparedShots) -> Simulator:
        """Return a simulator for other shots that shares the effort count."""
        return replace(self, shots=shots)

    def launches(self, points: Floats) -> Floats:
        """Return the launch quantities [SI] at points of shape (n, free), shape (quantities, n, shots).

        Shots that cannot be computed are NaN.
        """
        count = len(self.shots)
        block = max(1, MOST_ROWS // count)
        parts = [self._block(points[start : start + block]) for start in range(0, len(points), block)]
        self.effort.add(len(points), count)
        return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=1)

    def launch(self, point: Floats) -> Floats:
        """Return the launch quantities [SI] at one point, shape (quantities, shots)."""
        return self.launches(point[None, :])[:, 0, :]

    def before(self) -> Floats:
        """Return the launch quantities [SI] with the initial parameter set, shape (quantities, shots)."""
        launches = self._compute_outputs(self.shots.columns, self.free.fixed.columns(), len(self.shots))
        self.effort.add(1, len(self.shots))
        return launches[self._places]

    def derivatives(self, point: Floats) -> tuple[Floats, Floats]:
        """Return the launch quantities at a point, shape (quantities, shots), and their derivatives by its coordinates.

        The derivatives have shape (quantities, free, shots). They are exact: dual numbers for the model, and implicit
        differentiation of the angles that meet launch angle and azimuth.
        """
        driven = self.free.driven()
        inputs = self._meet_launch(self.shots.columns, self.free.single(point), len(self.shots))
        variables = [len(inputs) + place for places in driven for place in places] + self.shots.solved_columns()
        places = self.shots.output_places()
        computed, _ = core.sensitivities(
            self.free.fixed.model, inputs, self.free.single(point), len(self.shots), places, variables, self.accuracy,
            self.threads,
        )  # fmt: skip
        self.effort.add(1, len(self.shots))
        table = computed.reshape(len(places), 1 + len(variables), len(self.shots))
        sizes = [len(each) for each in driven]
        angles, count = 1 + sum(sizes), len(self._places)
        together = np.add.reduceat(table[:, 1:angles], np.cumsum([0, *sizes[:-1]]), axis=1)
        by_point = together * self.free.slopes(point)[:, None]
        return table[:count, 0], _at_launch(by_point, table[:, angles:], count)

    def contact(self, point: Floats) -> tuple[Floats, Floats]:
        """Return contact times [s] and peak forces [N] of the shots; NaN for a model without a time scale."""
        order = list(outputs())
        computed = self._compute_outputs(self.shots.columns, self.free.single(point), len(self.shots))
        return computed[order.index("contact_time")], computed[order.index("peak_force")]

    def _block(self, points: Floats) -> Floats:
        count, shots = len(points), len(self.shots)
        computed = self._compute_outputs(self._inputs(count), self.free.columns(points, shots), count * shots)
        return computed[self._places].reshape(len(self._places), count, shots)

    def _compute_outputs(self, inputs: list[Any], parameters: list[Any], count: int) -> Floats:
        """Return all outputs of the core, meeting the measured launch if required; NaN where that is impossible."""
        inputs = self._meet_launch(inputs, parameters, count)
        computed, _ = core.impact(self.free.fixed.model, inputs, parameters, count, self.accuracy, self.threads)
        return computed

    def _meet_launch(self, inputs: list[Any], parameters: list[Any], count: int) -> list[Any]:
        """Return the inputs with the loft and face angle that meet the measured launch; NaN where none do."""
        columns = self.shots.solved_columns()
        if not columns:
            return inputs
        outs = self.shots.output_places()[len(self._places) :]

        def directions(angles: Floats, places: NDArray[np.intp]) -> Floats:
            some, others = (
                [each if isinstance(each, float) else each[places] for each in every] for every in (inputs, parameters)
            )
            for column, values in zip(columns, angles, strict=True):
                some[column] = np.ascontiguousarray(values)
            computed, _ = core.impact(self.free.fixed.model, some, others, len(places), self.accuracy, self.threads)
            self.effort.impacts += len(places)
            return computed[outs]

        wanted = np.tile(self.shots.start, count // len(self.shots))
        begin = np.array([np.broadcast_to(inputs[column], (count,)) for column in columns])
        solved = solve_angles(directions, begin, wanted)
        met = list(inputs)
        for column, values in zip(columns, solved, strict=True):
            met[column] = np.ascontiguousarray(values)
        return met

    def _inputs(self, count: int) -> list[float | Floats]:
        """Return the delivery columns repeated for ``count`` parameter sets; the most recent result is cached."""
        if count not in self._tiled:
            tiled = [each if isinstance(each, float) else np.tile(each, count) for each in self.shots.columns]
            self._tiled = {count: tiled}
        return self._tiled[count]


def _at_launch(by_point: Floats, by_angle: Floats, count: int) -> Floats:
    """Return the total derivatives of the first ``count`` outputs, including the change of the solved angles.

    With outputs q, met outputs m, angles a and coordinates p: m(a, p) is constant, so that da/dp = -(dm/da)^-1 dm/dp,
    and dq/dp = q_p - q_a (m_a)^-1 m_p.
    """
    if not by_angle.shape[1]:
        return by_point[:count]
    met_by_angle, met_by_point = (np.moveaxis(each[count:], -1, 0) for each in (by_angle, by_point))
    usable = np.abs(np.linalg.det(met_by_angle)) > 0.0  # zero where a shot cannot be computed
    follow = np.full(met_by_point.shape, np.nan)
    follow[usable] = np.linalg.solve(met_by_angle[usable], met_by_point[usable])
    return by_point[:count] - np.einsum("qas,sap->qps", by_angle[:count], follow)


Loss = Literal["absolute", "squares", "huber"]

LOSSES: dict[str, Loss] = {"published": "absolute", "least-squares": "squares", "robust": "huber"}
"""The loss function of each cost, by name."""

NORMALISERS = ("absolute", "signed")

NOISE = {"ball_speed": units.to_si(0.5, "mph"), **MONITOR}
"""Standard deviations of a launch monitor [SI]: angles and spin after Caldwell and McPhee (2023), section 4; the
0.5 mph of ball speed is assumed."""

HUBER = 1.345
"""Knee of Huber's loss, from square to linear, in units of the noise: 95% efficient for normal noise.

P. J. Huber, Robust estimation of a location parameter, Annals of Mathematical Statistics 35 (1964).
"""


@dataclass(frozen=True, eq=False)
class Cost:
    """A sum over quantities and shots of a loss of the deviations ``simulated - measured``.

    The loss is the weight times |deviation| ("absolute"), deviation^2 ("squares"), or Huber's loss of deviation / knee,
    times knee^2, which is deviation^2 up to the knee ("huber").
    """

    loss: Loss
    measured: Floats  # [SI], shape (quantities, shots), 0 where nothing was measured
    weights: Floats  # of the same shape, 0 where nothing was measured
    knees: Floats  # of Huber's loss [SI], shape (quantities,)

    def of(self, simulated: Floats) -> Floats:
        """Return the cost of launches of shape (quantities, ..., shots) with shape (...); infinite if any is NaN."""
        total = np.zeros(simulated.shape[1:-1])
        for quantity in range(len(simulated)):
            losses = self._losses(simulated[quantity] - self.measured[quantity], self.knees[quantity])
            losses *= self.weights[quantity]
            # Summed over the last, contiguous axis, so that one point gives the same sum as a population.
            total += losses.sum(axis=-1)
        return np.where(np.isnan(total), np.inf, total)

    def select(self, chosen: NDArray[Any], counts: NDArray[np.int64]) -> Cost:
        """Return the cost of a subset of the shots, weighted by ``counts``, with the same scales."""
        return Cost(self.loss, self.measured[:, chosen], self.weights[:, chosen] * counts, self.knees)

    def absolute(self) -> Cost:
        """Return the cost with absolute deviations, scaled so that a deviation with a loss of 1 keeps it."""
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
    noise: Mapping[str, ValueLike] | None = None,
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
        Measured values [SI], shape (quantities, shots); NaN for values not measured, which are ignored.
    quantities
        Names of the rows.
    noise
        Standard deviations of the measurement by quantity, text with a unit or SI numbers; they replace those of
        :data:`NOISE`.
    normaliser
        For "published": "absolute" is the mean magnitude of the measured values; "signed" is the magnitude of their
        mean, as the equation is printed, which vanishes for azimuth and sidespin of players who miss on both sides.

    Raises
    ------
    InputError
        A normaliser is below the noise of its quantity, so that the mean does not represent the size of the values.
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
    """Return the standard deviation of each quantity [SI]: :data:`NOISE`, updated with the ``given`` values."""
    check_names("quantity with noise", given or {}, quantities)
    dimensions = {name: outputs()[name].dimension for name in quantities}
    deviations = NOISE | standard_deviations(given, dimensions, "noise")
    for name in quantities:
        if name not in deviations:
            raise InputError(f"noise of {name}", None, "give it, since no default noise is known for this quantity")
        if not 0.0 < deviations[name] < np.inf:
            raise InputError(f"noise of {name}", deviations[name], "positive")
    return np.array([deviations[name] for name in quantities])


def _normalisers(
    measured: Floats, there: NDArray[np.bool_], quantities: tuple[str, ...], normaliser: str, noise: Floats
) -> Floats:
    values = np.abs(measured) if normaliser == "absolute" else measured
    means = np.abs(values.sum(axis=1) / there.sum(axis=1))
    for name, mean, least in zip(quantities, means, noise, strict=True):
        if mean < least:
            symbol = display_unit(name, outputs()[name].unit)
            what = "|measured|" if normaliser == "absolute" else "measured values"
            advice = "leave the quantity out" + (", or use the absolute normaliser" if normaliser == "signed" else "")
            shown = units.show(float(mean), symbol, 3)
            raise InputError(
                f"the mean of {what} of {name}", shown,
                f"above its noise, {units.show(float(least), symbol, 3)}, since errors are divided by it; {advice}",
            )  # fmt: skip
    return means
