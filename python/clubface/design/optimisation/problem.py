"""The problem an optimiser solves: an objective and limits as functions of its numbers, with exact gradients."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from clubface.design.optimisation.landings import Landings
from clubface.design.optimisation.objectives import Objective
from clubface.design.optimisation.variables import Variables

REMEMBERED = 4
"""Points whose values are kept: an optimiser asks for objective, limits and gradients one after another."""


@dataclass(frozen=True)
class State:
    """What is known at a point.

    Attributes
    ----------
    point
        The numbers of the optimiser.
    club
        The fields of the club that may change [SI].
    slopes
        Their derivatives by the numbers, shape (fields, numbers).
    judged
        The value of every objective in use, the mean over the golfers.
    gradients
        Their derivatives by the numbers, each of shape (numbers,); empty where they were not asked for.
    """

    point: NDArray[Any]
    club: Mapping[str, float]
    slopes: NDArray[Any]
    judged: Mapping[str, float]
    gradients: Mapping[str, NDArray[Any]]


class Limit(Protocol):
    """One or several margins that must not be negative.

    Attributes
    ----------
    name
        What it is called in reports.
    """

    @property
    def name(self) -> str: ...  # noqa: D102 - among the attributes

    def told(self, state: State) -> tuple[str, str]:
        """Return what a club has of it, and what is allowed, in words."""
        ...

    def margins(self, state: State) -> NDArray[Any]:
        """Return them as numbers of size 1, shape (m,)."""
        ...

    def gradients(self, state: State) -> NDArray[Any]:
        """Return their derivatives by the numbers of the optimiser, shape (m, numbers)."""
        ...


class Problem:
    """An objective and limits over variables.

    Parameters
    ----------
    variables
        What is turned.
    golfers
        The shots of each golfer, and how much he counts; the weights need not add up to 1.
    objective
        What is made best.
    limits
        What must hold.
    others
        Objectives that the limits ask for, or that are reported.
    """

    def __init__(
        self,
        variables: Variables,
        golfers: Sequence[tuple[Landings, float]],
        objective: Objective,
        limits: Sequence[Limit],
        others: Sequence[Objective] = (),
    ) -> None:
        self.variables, self.golfers, self.objective, self.limits = variables, tuple(golfers), objective, tuple(limits)
        self.judges = {each.name: each for each in (objective, *others)}
        total = sum(weight for _, weight in golfers)
        self._weights = [weight / total for _, weight in golfers]
        self._values: dict[bytes, State] = {}
        self._slopes: dict[bytes, State] = {}
        self.evaluations = self.differentiations = 0

    @property
    def shots(self) -> int:
        """The shots of all golfers, those that miss the face left out."""
        return sum(landings.count for landings, _ in self.golfers)

    def values(self, point: NDArray[Any]) -> State:
        """Return what is known at a point without derivatives of the landings."""
        key = np.ascontiguousarray(point).tobytes()
        if key in self._slopes:
            return self._slopes[key]
        if key not in self._values:
            self.evaluations += 1
            club = self.variables.club(point)
            landed = [each.of(club) for each, _ in self.golfers]
            judged = {name: self._mean([each.judge(one)[0] for one in landed]) for name, each in self.judges.items()}
            _keep(self._values, key, State(np.array(point), club, self.variables.slopes(point), judged, {}))
        return self._values[key]

    def differentiated(self, point: NDArray[Any]) -> State:
        """Return all that is known at a point."""
        key = np.ascontiguousarray(point).tobytes()
        if key not in self._slopes:
            self.differentiations += 1
            club, slopes = self.variables.club(point), self.variables.slopes(point)
            found = [each.differentiated(club, self.variables.fields) for each, _ in self.golfers]
            judged, gradients = {}, {}
            for name, each in self.judges.items():
                values = [each.judge(landed) for landed, _ in found]
                judged[name] = self._mean([value for value, _ in values])
                each_by_fields = [by.gradient(weights) for (_, weights), (_, by) in zip(values, found, strict=True)]
                gradients[name] = self._mean(each_by_fields) @ slopes
            _keep(self._slopes, key, State(np.array(point), club, slopes, judged, gradients))
        return self._slopes[key]

    def _mean(self, of_golfers: Sequence[Any]) -> Any:
        return sum(weight * each for weight, each in zip(self._weights, of_golfers, strict=True))

    def cost(self, point: NDArray[Any]) -> float:
        """Return what is made least."""
        return self.objective.sign * self.values(point).judged[self.objective.name]

    def slope(self, point: NDArray[Any]) -> NDArray[Any]:
        """Return its derivatives, shape (numbers,)."""
        return self.objective.sign * self.differentiated(point).gradients[self.objective.name]

    def margins(self, point: NDArray[Any]) -> NDArray[Any]:
        """Return all margins, which must not be negative."""
        state = self.values(point)
        return np.concatenate([np.empty(0), *(each.margins(state) for each in self.limits)])

    def margin_slopes(self, point: NDArray[Any]) -> NDArray[Any]:
        """Return their derivatives, shape (margins, numbers)."""
        state = self.differentiated(point)
        return np.concatenate([np.empty((0, self.variables.count)), *(each.gradients(state) for each in self.limits)])


def _keep(kept: dict[bytes, State], key: bytes, state: State) -> None:
    kept[key] = state
    while len(kept) > REMEMBERED:
        del kept[next(iter(kept))]
