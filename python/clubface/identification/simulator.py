"""Launches of all shots for one or many sets of parameters, and their exact derivatives: one call of the core each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.identification.free_parameters import FreeParameters
from clubface.identification.prepared import PreparedShots
from clubface.simulation import core
from clubface.simulation.launch_conditioned import solve_angles
from clubface.simulation.quantities import outputs
from clubface.support.arrays import Floats

MOST_ROWS = 1 << 18
"""Impacts of one call, so that memory stays below 200 MB; a generation of the usual search, 110 000, is one call."""


@dataclass
class Effort:
    """What has been computed so far.

    Attributes
    ----------
    evaluations
        Sets of parameters for which all shots of a data set were computed.
    impacts
        Impacts computed.
    """

    evaluations: int = 0
    impacts: int = 0

    def add(self, evaluations: int, shots: int) -> None:
        """Count some evaluations over a number of shots."""
        self.evaluations += evaluations
        self.impacts += evaluations * shots

    def since(self, before: Effort) -> Effort:
        """Return what was added to ``before``."""
        return Effort(self.evaluations - before.evaluations, self.impacts - before.impacts)


class Simulator:
    """Computes the launches of measured shots at points of the search.

    Parameters
    ----------
    shots
        The deliveries.
    free
        The parameters, and the unit cube in which points lie.
    accuracy
        Tolerance of a contact step; None is the fast setting.
    threads
        Of the core, 0 for all cores.
    effort
        Counts what is computed.
    """

    def __init__(
        self,
        shots: PreparedShots,
        free: FreeParameters,
        *,
        accuracy: float | None = None,
        threads: int = 0,
        effort: Effort | None = None,
    ) -> None:
        self.shots = shots
        self.free = free
        self.accuracy = accuracy
        self.threads = threads
        self.effort = effort or Effort()
        self._places = shots.output_places()[: len(shots.quantities)]
        self._tiled: dict[int, list[float | Floats]] = {}

    def of(self, shots: PreparedShots) -> Simulator:
        """Return the same for other shots; what it computes is counted together."""
        return Simulator(shots, self.free, accuracy=self.accuracy, threads=self.threads, effort=self.effort)

    def launches(self, points: Floats) -> Floats:
        """Return the launch quantities [SI] at points of shape (n, free), shape (quantities, n, shots).

        A shot that cannot be computed is NaN.
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
        """Return the launch quantities [SI] with the set that holds the fixed parameters, shape (quantities, shots)."""
        found = self._computed(self.shots.columns, self.free.fixed.columns(), len(self.shots))
        self.effort.add(1, len(self.shots))
        return found[self._places]

    def derivatives(self, point: Floats) -> tuple[Floats, Floats]:
        """Return the launch quantities at a point, shape (quantities, shots), and their derivatives by its coordinates.

        The latter have the shape (quantities, free, shots). They are exact: dual numbers through the model, and where
        launch angle and azimuth are met, the implicit function of the angles that meet them.
        """
        driven = self.free.driven()
        inputs = self._met(self.shots.columns, self.free.single(point), len(self.shots))
        variables = [len(inputs) + place for places in driven for place in places] + self.shots.solved_columns()
        places = self.shots.output_places()
        found, _ = core.sensitivities(
            self.free.fixed.model, inputs, self.free.single(point), len(self.shots), places, variables, self.accuracy,
            self.threads,
        )  # fmt: skip
        self.effort.add(1, len(self.shots))
        table = found.reshape(len(places), 1 + len(variables), len(self.shots))
        slopes = self.free.slopes(point)
        by_point = np.empty((len(places), len(driven), len(self.shots)))
        start = 1
        for place, group in enumerate(driven):
            by_point[:, place] = table[:, start : start + len(group)].sum(axis=1) * slopes[place]
            start += len(group)
        count = len(self._places)
        return table[:count, 0], _at_launch(by_point, table[:, start:], count)

    def contact(self, point: Floats) -> tuple[Floats, Floats]:
        """Return contact times [s] and peak forces [N] of the shots; NaN for a model without a time scale."""
        order = list(outputs())
        found = self._computed(self.shots.columns, self.free.single(point), len(self.shots))
        return found[order.index("contact_time")], found[order.index("peak_force")]

    def _block(self, points: Floats) -> Floats:
        count, shots = len(points), len(self.shots)
        found = self._computed(self._inputs(count), self.free.columns(points, shots), count * shots)
        return found[self._places].reshape(len(self._places), count, shots)

    def _computed(self, inputs: list[Any], parameters: list[Any], count: int) -> Floats:
        """Return all outputs of the core, at the measured launch if that is to be met; NaN where it cannot be."""
        inputs = self._met(inputs, parameters, count)
        found, _ = core.impact(self.free.fixed.model, inputs, parameters, count, self.accuracy, self.threads)
        return found

    def _met(self, inputs: list[Any], parameters: list[Any], count: int) -> list[Any]:
        """Return the inputs with the loft and face angle that meet the measured launch, NaN where none do."""
        columns = self.shots.solved_columns()
        if not columns:
            return inputs
        outs = self.shots.output_places()[len(self._places) :]

        def directions(angles: Floats, places: NDArray[np.intp]) -> Floats:
            some, with_ = (
                [each if isinstance(each, float) else each[places] for each in every] for every in (inputs, parameters)
            )
            for column, values in zip(columns, angles, strict=True):
                some[column] = np.ascontiguousarray(values)
            found, _ = core.impact(self.free.fixed.model, some, with_, len(places), self.accuracy, self.threads)
            self.effort.impacts += len(places)
            return found[outs]

        wanted = np.tile(self.shots.start, count // len(self.shots))
        begin = np.array([np.broadcast_to(inputs[column], (count,)) for column in columns])
        solved = solve_angles(directions, begin, wanted)
        found = list(inputs)
        for column, values in zip(columns, solved, strict=True):
            found[column] = np.ascontiguousarray(values)
        return found

    def _inputs(self, count: int) -> list[float | Floats]:
        """Return the columns of the deliveries, repeated for ``count`` sets of parameters; the last ones are kept."""
        if count not in self._tiled:
            tiled = [each if isinstance(each, float) else np.tile(each, count) for each in self.shots.columns]
            self._tiled = {count: tiled}
        return self._tiled[count]


def _at_launch(by_point: Floats, by_angle: Floats, count: int) -> Floats:
    """Return derivatives of the first ``count`` outputs that hold how the solved angles follow what moves the others.

    With outputs q and met ones m, angles a and coordinates p: m(a, p) stays, so that da/dp = -(dm/da)^-1 dm/dp, and
    dq/dp = q_p - q_a (m_a)^-1 m_p.
    """
    if not by_angle.shape[1]:
        return by_point[:count]
    met_by_angle, met_by_point = (np.moveaxis(each[count:], -1, 0) for each in (by_angle, by_point))
    usable = np.abs(np.linalg.det(met_by_angle)) > 0.0  # not where a shot cannot be computed
    follow = np.full(met_by_point.shape, np.nan)
    follow[usable] = np.linalg.solve(met_by_angle[usable], met_by_point[usable])
    return by_point[:count] - np.einsum("qas,sap->qps", by_angle[:count], follow)
