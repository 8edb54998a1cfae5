"""Launches of all shots for one or many sets of parameters, and their exact derivatives: one call of the core each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from clubface.identification.free_parameters import FreeParameters
from clubface.identification.prepared import PreparedShots
from clubface.simulation import core
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
        self._places = shots.output_places()
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
        found, _ = core.impact(
            self.free.fixed.model, self.shots.columns, self.free.fixed.columns(), len(self.shots), self.accuracy,
            self.threads,
        )  # fmt: skip
        self.effort.add(1, len(self.shots))
        return found[self._places]

    def derivatives(self, point: Floats) -> tuple[Floats, Floats]:
        """Return the launch quantities at a point, shape (quantities, shots), and their derivatives by its coordinates.

        The latter have the shape (quantities, free, shots). They are exact: dual numbers through the model.
        """
        driven = self.free.driven()
        flat = [place for places in driven for place in places]
        variables = [len(self.shots.columns) + place for place in flat]
        found, _ = core.sensitivities(
            self.free.fixed.model, self.shots.columns, self.free.single(point), len(self.shots), self._places,
            variables, self.accuracy, self.threads,
        )  # fmt: skip
        self.effort.add(1, len(self.shots))
        table = found.reshape(len(self._places), 1 + len(variables), len(self.shots))
        slopes = self.free.slopes(point)
        by_point = np.empty((len(self._places), len(driven), len(self.shots)))
        start = 1
        for place, group in enumerate(driven):
            by_point[:, place] = table[:, start : start + len(group)].sum(axis=1) * slopes[place]
            start += len(group)
        return table[:, 0], by_point

    def contact(self, point: Floats) -> tuple[Floats, Floats]:
        """Return contact times [s] and peak forces [N] of the shots; NaN for a model without a time scale."""
        order = list(outputs())
        found, _ = core.impact(
            self.free.fixed.model, self.shots.columns, self.free.single(point), len(self.shots), self.accuracy,
            self.threads,
        )  # fmt: skip
        return found[order.index("contact_time")], found[order.index("peak_force")]

    def _block(self, points: Floats) -> Floats:
        count, shots = len(points), len(self.shots)
        inputs = self._inputs(count)
        parameters = self.free.columns(points, shots)
        found, _ = core.impact(self.free.fixed.model, inputs, parameters, count * shots, self.accuracy, self.threads)
        return found[self._places].reshape(len(self._places), count, shots)

    def _inputs(self, count: int) -> list[float | Floats]:
        """Return the columns of the deliveries, repeated for ``count`` sets of parameters; the last ones are kept."""
        if count not in self._tiled:
            tiled = [each if isinstance(each, float) else np.tile(each, count) for each in self.shots.columns]
            self._tiled = {count: tiled}
        return self._tiled[count]
