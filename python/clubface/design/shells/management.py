"""Trust-region management of two models: a fast one, corrected, proposes, and an exact one accepts or refuses.

The framework is that of Alexandrov, Dennis, Lewis and Torczon (1998). The fast model is corrected so that it agrees with
the exact one at the best design; the slopes of the correction come from exact neighbours of the start and are kept up
to date after Broyden (1965). All quantities are positive, and everything is relative: corrections are factors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

Values = dict[str, float]
Fast = Callable[["NDArray[Any]"], Values]
Exact = Callable[[Sequence["NDArray[Any]"]], list[Values]]

PENALTY = 10.0
"""Weight of the largest relative violation beside the relative change of the objective. No limit of a head is worth more
to its objective: 1% of characteristic time is worth 0.1% of ball speed, and 1% of stress some 0.3% of the walls' mass."""
INSIDE = 5e-4
"""How far inside of a limit a proposal aims, relatively: one on the limit is refused for the error of the fast model."""
LEAST_GAIN = 1e-4
"""A proposal that promises a smaller relative gain is not worth a run."""
LEAST_RADIUS = 0.004
NEIGHBOUR = 0.08
"""How far the neighbours of the start are away, as a share of the range of each variable."""


@dataclass(frozen=True, kw_only=True)
class Goal:
    """What is best, and within which limits.

    Attributes
    ----------
    objective
        Name of a quantity.
    largest
        Whether it shall be large; otherwise small.
    limits
        The least and the greatest value of quantities, by name; 0 and infinity where there is none.
    """

    objective: str
    largest: bool
    limits: Mapping[str, tuple[float, float]]

    def cost(self, values: Values) -> float:
        """Return the logarithm of the objective, or minus it if it shall be large: smaller is better."""
        return (-1.0 if self.largest else 1.0) * math.log(values[self.objective])

    def excess(self, values: Values) -> NDArray[Any]:
        """Return by how much every limit is broken, relatively; negative where it is kept."""
        found = []
        for name, (least, most) in self.limits.items():
            if least > 0.0:
                found.append(math.log(least / values[name]))
            if most < math.inf:
                found.append(math.log(values[name] / most))
        return np.array(found)

    def violation(self, values: Values) -> float:
        """Return the largest relative excess over a limit; 0 within all, infinity for a design that failed."""
        if not all(math.isfinite(value) for value in values.values()):
            return math.inf
        return max(0.0, *self.excess(values)) if self.limits else 0.0

    def merit(self, values: Values) -> float:
        """Return cost and weighted violation."""
        violation = self.violation(values)
        return self.cost(values) + PENALTY * violation if violation < math.inf else math.inf

    def better(self, one: Values, other: Values) -> bool:
        """Tell whether ``one`` is the better design: first within limits, then by the objective."""
        if self.violation(other) == 0.0:
            return self.violation(one) == 0.0 and self.cost(one) < self.cost(other)
        return self.violation(one) == 0.0 or self.merit(one) < self.merit(other)


@dataclass(frozen=True, kw_only=True)
class Step:
    """One design that the exact model judged.

    Attributes
    ----------
    place
        Its variables, as shares of their ranges.
    kind
        "start", "neighbour" or "proposal".
    values, promised
        The quantities by the exact model, and those that the corrected fast model promised (of a proposal).
    accepted
        Whether it became the best design.
    radius
        Half the width of the region in which it was sought.
    """

    place: tuple[float, ...]
    kind: str
    values: Values
    promised: Values | None
    accepted: bool
    radius: float


@dataclass(frozen=True, kw_only=True)
class Managed:
    """What a search found.

    Attributes
    ----------
    steps
        All designs that the exact model judged, in their order.
    best
        Index of the best one.
    ended
        Why the search ended.
    """

    steps: tuple[Step, ...]
    best: int
    ended: str


class Correction:
    """Factors by which the fast model is multiplied: exact at one place, with slopes."""

    def __init__(self, names: Sequence[str], place: NDArray[Any], ratio: NDArray[Any]) -> None:
        self.names, self._place, self._ratio = tuple(names), place, ratio
        self._slope = np.zeros((len(ratio), len(place)))

    def set_slope(self, place: NDArray[Any], ratio: NDArray[Any], variable: int) -> None:
        """Take the slope along one variable from a neighbour."""
        self._slope[:, variable] = (ratio - self._ratio) / (place - self._place)[variable]

    def learn(self, place: NDArray[Any], ratio: NDArray[Any], *, move: bool) -> None:
        """Make it exact at another place too, by the least change of slopes; ``move``: make that the place."""
        away = place - self._place
        missed = ratio - self._ratio - self._slope @ away
        if away @ away > 0.0:
            self._slope += np.outer(missed, away) / (away @ away)
        if move:
            self._place, self._ratio = place, ratio

    def __call__(self, place: NDArray[Any], fast: Values) -> Values:
        """Return the values of the fast model at a place, corrected."""
        factors = np.exp(self._ratio + self._slope @ (place - self._place))
        return {name: fast[name] * float(factor) for name, factor in zip(self.names, factors, strict=True)}


def manage(
    fast: Fast, exact: Exact, start: NDArray[Any], goal: Goal, *, radius: float = 0.3, most: int = 20,
    neighbours: bool = True, told: Callable[[int, int], object] | None = None,
) -> Managed:  # fmt: skip
    """Search for the best design with few runs of an exact model.

    Parameters
    ----------
    fast, exact
        The models. Both take variables as shares of their ranges, 0 to 1, and return positive quantities by name. The
        exact one takes several designs at once; one that fails has values that are NaN.
    start
        The design to start from.
    goal
        What is best.
    radius
        Half the width of the first region of trust.
    most
        Number of designs that the exact model may judge.
    neighbours
        Whether it judges a neighbour of the start along each variable, so that the first correction has its slopes.
    told
        Called with the number of designs that were judged and the number of those allowed.

    Raises
    ------
    ValueError
        The design to start from fails.
    """
    steps: list[Step] = []

    def note(*judged: Step) -> None:
        steps.extend(judged)
        if told is not None:
            told(len(steps), most)

    place = np.asarray(start, float)
    values = exact([place])[0]
    if goal.violation(values) == math.inf:
        raise ValueError("the design to start from fails")
    note(Step(place=tuple(place), kind="start", values=values, promised=None, accepted=True, radius=radius))
    names = [goal.objective, *(name for name in goal.limits if name != goal.objective)]

    def ratio(at: NDArray[Any], judged: Values) -> NDArray[Any]:
        guessed = fast(at)
        return np.array([math.log(judged[name] / guessed[name]) for name in names])

    correction, best = Correction(names, place, ratio(place, values)), 0
    if neighbours:
        others = _neighbours(place)
        for variable, (at, judged) in enumerate(zip(others, exact(others), strict=True)):
            accepted = goal.better(judged, steps[best].values)
            note(
                Step(place=tuple(at), kind="neighbour", values=judged, promised=None, accepted=accepted, radius=radius)
            )
            if goal.violation(judged) < math.inf:
                correction.set_slope(at, ratio(at, judged), variable)
            best = len(steps) - 1 if accepted else best
        if best:
            place, values = np.array(steps[best].place), steps[best].values
            correction.learn(place, ratio(place, values), move=True)
    while len(steps) < most:
        proposed, promised = _propose(fast, correction, place, radius, goal)
        gain = goal.merit(values) - goal.merit(promised)
        if gain < LEAST_GAIN:
            return Managed(steps=tuple(steps), best=best, ended="no proposal promised a gain")
        judged = exact([proposed])[0]
        accepted = goal.better(judged, values)
        note(Step(place=tuple(proposed), kind="proposal", values=judged, promised=promised, accepted=accepted,
                  radius=radius))  # fmt: skip
        kept = (goal.merit(values) - goal.merit(judged)) / gain
        far = float(np.abs(proposed - place).max())
        if math.isfinite(kept):
            correction.learn(proposed, ratio(proposed, judged), move=accepted)
        if accepted:
            place, values, best = proposed, judged, len(steps) - 1
        if kept > 0.75:
            radius = min(max(radius, 2.0 * far), 1.0)
        elif kept < 0.25 or not math.isfinite(kept):
            radius = 0.5 * far
        if radius < LEAST_RADIUS:
            return Managed(steps=tuple(steps), best=best, ended="the region of trust became small")
    return Managed(steps=tuple(steps), best=best, ended=f"{most} designs were judged, as many as allowed")


def _neighbours(place: NDArray[Any]) -> list[NDArray[Any]]:
    """Return a neighbour along each variable, on the side with more room."""
    found = []
    for variable, share in enumerate(place):
        other = place.copy()
        other[variable] += NEIGHBOUR if share <= 0.5 else -NEIGHBOUR
        found.append(other)
    return found


def _propose(
    fast: Fast, correction: Correction, place: NDArray[Any], radius: float, goal: Goal
) -> tuple[NDArray[Any], Values]:
    """Return the best design of the corrected fast model near a place, and what it promises.

    A slack lets limits be broken at a price, so that a start outside them has a way back.
    """
    from scipy.optimize import minimize

    count = len(place)
    seen: dict[bytes, Values] = {}

    def model(at: NDArray[Any]) -> Values:
        key = at.tobytes()
        if key not in seen:
            seen[key] = correction(at, fast(at))
        return seen[key]

    def cost(both: NDArray[Any]) -> float:
        return goal.cost(model(both[:count])) + PENALTY * both[count]

    def room(both: NDArray[Any]) -> NDArray[Any]:
        return both[count] - goal.excess(model(both[:count])) - INSIDE

    low, high = np.maximum(place - radius, 0.0), np.minimum(place + radius, 1.0)
    slack = goal.violation(model(place)) + 2.0 * INSIDE
    found = minimize(
        cost, np.append(place, slack), method="SLSQP", bounds=[*zip(low, high, strict=True), (0.0, 10.0)],
        constraints=[{"type": "ineq", "fun": room}] if goal.limits else [],
        options={"maxiter": 60, "ftol": 1e-7, "eps": 1e-5},
    )  # fmt: skip
    at = np.clip(found.x[:count], low, high)
    return at, model(at)
