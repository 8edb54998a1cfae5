"""The best point of a problem: sequential quadratic programming (Kraft, 1988) from many starts, with exact gradients."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface.design.optimisation.problem import Problem

if TYPE_CHECKING:
    from numpy.typing import NDArray

SLACK = 1e-6
"""What every margin keeps above 0 while it is solved, so that rounding of the solver breaks no limit."""
PRECISION = 1e-8
"""Of the cost, as a part of its size at the start; noise of the flights' steps in the mean of shots is near 1e-9."""
MOST_STEPS = 200
ALIKE = 1e-4
"""Costs that differ by less than this part are the same optimum."""
REFUSED = 10.0
"""Cost, in sizes of the cost at the start, of a club whose shots cannot be computed: a line search turns back."""


class Solution(NamedTuple):
    """Where a solver ended.

    Attributes
    ----------
    point
        The numbers.
    cost
        What was made least.
    least_margin
        The smallest of all margins; negative where a limit is broken.
    steps
        How many steps were made.
    message
        What the solver says of its end.
    """

    point: NDArray[Any]
    cost: float
    least_margin: float
    steps: int
    message: str

    @property
    def allowed(self) -> bool:
        """Whether no limit is broken."""
        return self.least_margin >= 0.0


def starts(problem: Problem, count: int, seed: int) -> list[NDArray[Any]]:
    """Return points to start from: that of the base club, then points spread evenly over the bounds."""
    from scipy.stats import qmc

    uniform = qmc.Sobol(problem.variables.count + 1, scramble=True, rng=np.random.default_rng(seed))
    spread = [problem.variables.random(each) for each in uniform.random_base2(max(count - 1, 1).bit_length())]
    return [problem.variables.start(), *spread][:count]


def solve(problem: Problem, start: NDArray[Any], *, progress: Callable[[], object] | None = None) -> Solution:
    """Return the optimum that is reached from a start."""
    from scipy.optimize import minimize

    scale = max(abs(problem.cost(start)), 1e-6) if np.isfinite(problem.cost(start)) else 1.0

    def cost(point: NDArray[Any]) -> float:
        found = problem.cost(point) / scale
        return found if np.isfinite(found) else REFUSED

    def slope(point: NDArray[Any]) -> NDArray[Any]:
        if progress is not None:
            progress()
        return np.nan_to_num(problem.slope(point) / scale)

    def margins(point: NDArray[Any]) -> NDArray[Any]:
        return np.nan_to_num(problem.margins(point), nan=-REFUSED) - SLACK

    def margin_slopes(point: NDArray[Any]) -> NDArray[Any]:
        return np.nan_to_num(problem.margin_slopes(point))

    limited = problem.margins(start).size > 0
    box = problem.variables.box
    found = minimize(
        cost, start, jac=slope, method="SLSQP", bounds=box,
        constraints=[{"type": "ineq", "fun": margins, "jac": margin_slopes}] if limited else [],
        options={"maxiter": MOST_STEPS, "ftol": PRECISION},
    )  # fmt: skip
    point = np.clip(found.x, *box.T)
    least = float(problem.margins(point).min()) if limited else np.inf
    return Solution(point, problem.cost(point), least, int(found.nit), str(found.message))


def best(found: Sequence[Solution]) -> Solution | None:
    """Return the best of those that break no limit."""
    allowed = [each for each in found if each.allowed and np.isfinite(each.cost)]
    return min(allowed, key=lambda each: each.cost) if allowed else None


def agreeing(found: Sequence[Solution], chosen: Solution) -> int:
    """Return how many solutions are as good as the chosen one."""
    near = ALIKE * max(abs(chosen.cost), 1e-12)
    return sum(each.allowed and each.cost <= chosen.cost + near for each in found)
