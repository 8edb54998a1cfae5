"""What makes the difference of two shots: contributions that add up to it, and what remains."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.design.comparison.line import FACE, Line, Point
from clubface.design.comparison.quantities import FLOWN, LAUNCHED, QUANTITIES, values
from clubface.design.comparison.slopes import flown, slopes
from clubface.equipment.backends import MODULES
from clubface.errors import ClubfaceError
from clubface.simulation.flight import fly
from clubface.simulation.flight_inputs import flight_columns
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import flight_outputs, outputs
from clubface.support.checks import check_choice

NODES = {False: 8, True: 1}
"""Points of the line at which a launch is differentiated, unless given: of a model that takes long the middle alone."""


class Change(NamedTuple):
    """One thing that differs between two shots.

    Attributes
    ----------
    name
        An input, a parameter, or what is changed as a whole: "model", "hand", "ball" or "head".
    start, end
        Its values [SI]; None for what is changed as a whole.
    derivative
        Whether its contribution comes from derivatives; otherwise it is the difference that the whole change makes.
    """

    name: str
    start: float | None
    end: float | None
    derivative: bool


class Contributions(NamedTuple):
    """The difference between two shots, split.

    Attributes
    ----------
    changes
        What differs.
    si
        What each of the ``changes`` contributes to each of ``QUANTITIES`` [SI], shape (changes, quantities).
    remainder
        What remains of the difference [SI], shape (quantities,).
    nodes
        Points of the line at which the launch was differentiated.
    left_out
        Why there are no contributions, or "".
    """

    changes: tuple[Change, ...]
    si: NDArray[Any]
    remainder: NDArray[Any]
    nodes: int
    left_out: str = ""

    def of(self, name: str, quantity: str) -> float:
        """Return what the change called ``name`` contributes to a quantity [SI]."""
        names = [each.name for each in self.changes]
        check_choice("change", name, names)
        check_choice("quantity", quantity, QUANTITIES)
        return float(self.si[names.index(name), QUANTITIES.index(quantity)])


class Stage(NamedTuple):
    """A shot on the way from one to the other.

    Attributes
    ----------
    name
        What has been changed as a whole since the stage before.
    launch
        The launch then.
    """

    name: str
    launch: Launch


def contributions(
    stages: list[Stage],
    last: Launch,
    conditions: Mapping[str, Any],
    *,
    ball: Any,
    nodes: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Contributions:
    """Split the difference between the launch ``last`` and the first of the ``stages``.

    What has no derivatives is changed first, from stage to stage. From the last stage a straight line leads to ``last``
    through all inputs and parameters, and along it the exact derivatives are integrated by Gauss's rule.

    Parameters
    ----------
    stages
        The first shot, and every shot after something was changed as a whole.
    last
        The other shot, by the model of the last stage.
    conditions
        Air, wind and ground, as for :func:`clubface.fly`.
    ball
        The ball of ``last``, as a model takes it.
    nodes
        Points at which the launch is differentiated; left out, 8, or 1 for a model that takes long.
    progress
        Called with the points that are done and all points.
    """
    *levels, end = (values(each, fly(each, **conditions)) for each in (*(stage.launch for stage in stages), last))
    changes = [Change(each.name, None, None, False) for each in stages[1:]]
    parts = [after - before for before, after in pairwise(levels)]
    line = Line.between(Point.of(stages[-1].launch), Point.of(last))
    count = nodes or NODES[last.model in MODULES]
    if line.names:
        try:
            along = _integrated(line, last, conditions, count, ball, progress)
        except ClubfaceError as error:
            empty = np.empty((0, len(QUANTITIES)))
            return Contributions((), empty, end - levels[0], count, str(error))
        told = [name for name in line.names if FACE.get(name) not in line.names]
        for name in told:
            same = [place for place, each in enumerate(line.names) if FACE.get(each, each) == FACE.get(name, name)]
            changes.append(Change(name, line.start.value(name), line.end.value(name), True))
            parts.append(along[same].sum(axis=0))
    si = np.array(parts).reshape(len(changes), len(QUANTITIES))
    return Contributions(tuple(changes), si, end - levels[0] - si.sum(axis=0), count)


def _integrated(
    line: Line,
    last: Launch,
    conditions: Mapping[str, Any],
    nodes: int,
    ball: Any,
    progress: Callable[[int, int], object] | None,
) -> NDArray[Any]:
    """Return what each name of the line contributes to each quantity, shape (names, quantities)."""
    places, weights = np.polynomial.legendre.leggauss(nodes)
    shares = 0.5 + 0.5 * places
    base, _, _ = flight_columns(last, conditions.get("air"), conditions.get("wind"), conditions.get("ground"))
    launched = [list(outputs()).index(name) for name in LAUNCHED]
    flights = [list(flight_outputs()).index(name) for name in FLOWN]
    total = np.zeros((len(QUANTITIES), len(line.names)))
    for done, (share, weight, found) in enumerate(
        zip(shares.tolist(), weights.tolist(), slopes(line, last, shares.tolist(), ball), strict=True), 1
    ):
        rates = np.array(list(line.rates(share).values()))
        by_flight = flown(found, line.at(share), line.names, base)[flights]
        total += 0.5 * weight * np.concatenate([found[1][launched], by_flight]) * rates
        if progress is not None:
            progress(done, nodes)
    return total.T
