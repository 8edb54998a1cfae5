"""A fast model, corrected to agree with an exact one where that was asked, and the best design that it promises."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.shells.goal import PENALTY, Goal, Values

Fast = Callable[["NDArray[Any]"], Values]
INSIDE = 5e-4
"""How far inside of a limit a proposal aims, relatively: on the limit, the error of the fast model would break it."""


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


def propose(
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
