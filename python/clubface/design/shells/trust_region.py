"""A trust-region search with two models: a corrected fast model proposes, an exact model accepts or rejects.

The framework is due to Alexandrov, Dennis, Lewis and Torczon (1998). The fast model is corrected to agree with the
exact one at the best design; the slopes of the correction come from neighbours of the starting design and are updated
by Broyden's method (1965). All quantities are positive and corrections are factors, so everything is relative.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from clubface.errors import RunError
from clubface.support.arrays import Floats

Values = dict[str, float]
"""The quantities of a design by name, all positive."""
PENALTY = 10.0
"""Weight of the largest relative violation against a relative change of the objective. It exceeds what any limit of a
head gains: 1% of characteristic time gains 0.1% of ball speed."""


Fast = Callable[[Floats], Values]
INSIDE = 5e-4
"""Relative distance inside a limit at which proposals aim; on the limit itself, model error would violate it."""


@dataclass(frozen=True, kw_only=True)
class Goal:
    """Objective and limits of a search.

    Attributes
    ----------
    objective, largest
        Name of a quantity, and whether it is maximised rather than minimised.
    limits
        Lower and upper limits of quantities, by name; 0 and infinity for none.
    """

    objective: str
    largest: bool
    limits: Mapping[str, tuple[float, float]]

    def cost(self, values: Values) -> float:
        """Return the logarithm of the objective, negated if it is maximised: smaller is better."""
        return (-1.0 if self.largest else 1.0) * math.log(values[self.objective])

    def excess(self, values: Values) -> Floats:
        """Return the log ratio by which each limit is exceeded; negative inside it."""
        result = []
        for name, (least, most) in self.limits.items():
            if least > 0.0:
                result.append(math.log(least / values[name]))
            if most < math.inf:
                result.append(math.log(values[name] / most))
        return np.array(result)

    def violation(self, values: Values) -> float:
        """Return the largest relative violation of a limit; 0 within all limits, infinity for a failed design."""
        if not all(math.isfinite(value) for value in values.values()):
            return math.inf
        return max(0.0, *self.excess(values)) if self.limits else 0.0

    def merit(self, values: Values) -> float:
        """Return the cost plus the weighted violation."""
        violation = self.violation(values)
        return self.cost(values) + PENALTY * violation if violation < math.inf else math.inf

    def better(self, one: Values, other: Values) -> bool:
        """Return whether ``one`` is the better design: within limits first, then by the objective."""
        if self.violation(other) == 0.0:
            return self.violation(one) == 0.0 and self.cost(one) < self.cost(other)
        return self.violation(one) == 0.0 or self.merit(one) < self.merit(other)


class Correction:
    """Factors, linear in log space, that make the fast model agree with the exact one at one place."""

    def __init__(self, names: Sequence[str], place: Floats, ratio: Floats) -> None:
        self.names, self._place, self._ratio = tuple(names), place, ratio
        self._slope = np.zeros((len(ratio), len(place)))

    def set_slope(self, place: Floats, ratio: Floats, variable: int) -> None:
        """Set the slope along one variable from a neighbour."""
        self._slope[:, variable] = (ratio - self._ratio) / (place - self._place)[variable]

    def learn(self, place: Floats, ratio: Floats, *, move: bool) -> None:
        """Match another place too, by Broyden's smallest change of slopes; ``move`` makes it the reference place."""
        away = place - self._place
        missed = ratio - self._ratio - self._slope @ away
        if away @ away > 0.0:
            self._slope += np.outer(missed, away) / (away @ away)
        if move:
            self._place, self._ratio = place, ratio

    def __call__(self, place: Floats, fast: Values) -> Values:
        """Return the corrected values of the fast model at a place."""
        factors = np.exp(self._ratio + self._slope @ (place - self._place))
        return {name: fast[name] * float(factor) for name, factor in zip(self.names, factors, strict=True)}


def propose(fast: Fast, correction: Correction, place: Floats, radius: float, goal: Goal) -> tuple[Floats, Values]:
    """Return the best design of the corrected fast model near a place, and its predicted values.

    A slack variable allows violations at a price, so that the search can start outside the limits.
    """
    from scipy.optimize import minimize

    count = len(place)
    seen: dict[bytes, Values] = {}

    def model(at: Floats) -> Values:
        key = at.tobytes()
        if key not in seen:
            seen[key] = correction(at, fast(at))
        return seen[key]

    def cost(both: Floats) -> float:
        return goal.cost(model(both[:count])) + PENALTY * both[count]

    def room(both: Floats) -> Floats:
        return both[count] - goal.excess(model(both[:count])) - INSIDE

    low, high = np.maximum(place - radius, 0.0), np.minimum(place + radius, 1.0)
    slack = goal.violation(model(place)) + 2.0 * INSIDE
    result = minimize(
        cost, np.append(place, slack), method="SLSQP", bounds=[*zip(low, high, strict=True), (0.0, 10.0)],
        constraints=[{"type": "ineq", "fun": room}] if goal.limits else [],
        options={"maxiter": 60, "ftol": 1e-7, "eps": 1e-5},
    )  # fmt: skip
    at = np.clip(result.x[:count], low, high)
    return at, model(at)


Exact = Callable[[Sequence[Floats]], list[Values]]

LEAST_GAIN = 1e-4
"""Relative gain below which a proposal is not worth a run."""
LEAST_RADIUS = 0.004
FAR, NEAR = 0.08, 0.03
"""Distance of neighbours, as a share of each variable's range: at the start, and at what may be the optimum."""
RENEWED_RADIUS = 0.1
"""Minimum half width of the trust region after slopes are renewed."""
GOOD, POOR = 0.75, 0.25
"""Shares of the predicted gain above which the trust region grows, and below which it shrinks."""


@dataclass(frozen=True, kw_only=True)
class Step:
    """One design evaluated by the exact model.

    Attributes
    ----------
    place
        Its variables, as shares of their ranges.
    kind
        "start", "neighbour" or "proposal".
    values, promised
        Quantities from the exact model and, for a proposal, those predicted by the corrected fast model.
    accepted, radius
        Whether it became the best design, and half the width of the trust region.
    """

    place: tuple[float, ...]
    kind: str
    values: Values
    promised: Values | None
    accepted: bool
    radius: float


@dataclass(frozen=True, kw_only=True)
class SearchResult:
    """All designs evaluated by the exact model, in order, the index of the best one, and why the search ended."""

    steps: tuple[Step, ...]
    best: int
    ended: str


def trust_region_search(
    fast: Fast, exact: Exact, start: Floats, goal: Goal, *, radius: float = 0.3, most: int = 20,
    neighbours: bool = True, progress: Callable[[int, int], object] | None = None,
) -> SearchResult:  # fmt: skip
    """Search for the best design with few runs of an exact model.

    Parameters
    ----------
    fast, exact
        The models. Both take variables as shares of their ranges, 0 to 1, and return positive quantities by name. The
        exact model takes several designs at once; the values of a failed design are NaN.
    start, goal
        The starting design; objective and limits.
    radius, most
        Half the width of the initial trust region, and maximum number of designs the exact model evaluates.
    neighbours
        Whether it evaluates a neighbour along each variable, at the start and where the search would end, to give the
        correction its slopes. Otherwise a search may stop too early, as slopes are known only along its own path.
    progress
        Called with the number of designs evaluated and the maximum.

    Raises
    ------
    RunError
        The starting design fails.
    """
    return _Search(fast, exact, goal, radius, most, progress).run(np.asarray(start, float), neighbours)


class _Search:
    def __init__(self, fast: Fast, exact: Exact, goal: Goal, radius: float, most: int, progress: Any) -> None:
        self._fast, self._exact, self._goal, self._progress = fast, exact, goal, progress
        self._radius, self._most = radius, most
        self._steps: list[Step] = []
        self._best = 0
        self._names = [goal.objective, *(name for name in goal.limits if name != goal.objective)]

    @property
    def _place(self) -> Floats:
        return np.array(self._steps[self._best].place)

    @property
    def _values(self) -> Values:
        return self._steps[self._best].values

    def run(self, start: Floats, neighbours: bool) -> SearchResult:
        """Search from a start."""
        values = self._exact([start])[0]
        if self._goal.violation(values) == math.inf:
            raise RunError("the starting design fails")
        self._record_step(start, "start", values, None)
        self._correction = Correction(self._names, start, self._ratio(start, values))
        if neighbours and self._can_evaluate_neighbours(start):
            self._evaluate_neighbours(start, FAR)
        looked = neighbours
        while len(self._steps) < self._most:
            place, values = self._place, self._values
            proposed, promised = propose(self._fast, self._correction, place, self._radius, self._goal)
            gain = self._goal.merit(values) - self._goal.merit(promised)
            if gain >= LEAST_GAIN and self._radius >= LEAST_RADIUS:
                looked = self._evaluate_proposal(proposed, promised, gain) and looked
                continue
            # Slopes learnt on the way hold only along the path, so evaluate neighbours before relying on them.
            if not neighbours or looked or not self._can_evaluate_neighbours(place):
                ended = "no proposal promised a gain" if gain < LEAST_GAIN else "the trust region became small"
                break
            self._evaluate_neighbours(place, NEAR)
            self._radius, looked = max(self._radius, RENEWED_RADIUS), True
        else:
            ended = f"the maximum of {self._most} designs was evaluated"
        return SearchResult(steps=tuple(self._steps), best=self._best, ended=ended)

    def _record_step(self, place: Floats, kind: str, values: Values, promised: Values | None) -> bool:
        accepted = not self._steps or self._goal.better(values, self._values)
        self._steps.append(
            Step(
                place=tuple(map(float, place)), kind=kind, values=values, promised=promised, accepted=accepted,
                radius=self._radius,
            )
        )  # fmt: skip
        if accepted:
            self._best = len(self._steps) - 1
        if self._progress is not None:
            self._progress(len(self._steps), self._most)
        return accepted

    def _ratio(self, at: Floats, judged: Values) -> Floats:
        guessed = self._fast(at)
        return np.array([math.log(judged[name] / guessed[name]) for name in self._names])

    def _can_evaluate_neighbours(self, place: Floats) -> bool:
        return len(self._steps) + len(place) <= self._most

    def _evaluate_neighbours(self, place: Floats, far: float) -> None:
        """Evaluate a neighbour along each variable with the exact model, and set the slopes of the correction."""
        others = np.tile(place, (len(place), 1))  # each on the side with more room
        others += np.diag(np.where(place <= 0.5, far, -far))
        for variable, (at, judged) in enumerate(zip(others, self._exact(list(others)), strict=True)):
            self._record_step(at, "neighbour", judged, None)
            if self._goal.violation(judged) < math.inf:
                self._correction.set_slope(at, self._ratio(at, judged), variable)
        if not np.array_equal(self._place, place):
            self._correction.learn(self._place, self._ratio(self._place, self._values), move=True)

    def _evaluate_proposal(self, proposed: Floats, promised: Values, gain: float) -> bool:
        """Evaluate a proposal with the exact model, learn from it, and return whether it failed."""
        place, merit = self._place, self._goal.merit(self._values)
        judged = self._exact([proposed])[0]
        accepted = self._record_step(proposed, "proposal", judged, promised)
        kept = (merit - self._goal.merit(judged)) / gain
        far = float(np.abs(proposed - place).max())
        if math.isfinite(kept):
            self._correction.learn(proposed, self._ratio(proposed, judged), move=accepted)
        if kept > GOOD:
            self._radius = min(max(self._radius, 2.0 * far), 1.0)
        elif kept < POOR:
            self._radius = 0.5 * far
        return not math.isfinite(kept)
