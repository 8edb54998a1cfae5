"""The front between two objectives by the epsilon-constraint method: one is made best while the other must be kept.

Exact gradients and common shots make every point a smooth problem (Haimes, Lasdon and Wismer, 1971), solved from its
neighbours and from elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.optimisation.landings import Landings
from clubface.design.optimisation.limits import ShotLimit
from clubface.design.optimisation.problem import Problem
from clubface.design.optimisation.result import FrontPoint
from clubface.design.optimisation.solve import Solution, best, refused, starts

if TYPE_CHECKING:
    from clubface.design.optimisation.study import DesignStudy

STARTS = 6
"""Starts of every point, beside its neighbours: a front may jump from one kind of club to another."""
MARGIN = 1e-9
"""Part by which a front may be worse and still be no step back."""

Solve = Callable[[str, str, Problem, "NDArray[Any]"], Solution]


def front(study: DesignStudy, golfers: list[tuple[Landings, float]], solved: Solve) -> tuple[FrontPoint, ...]:
    """Return points of the front, from the best of the first objective to the best of the second.

    Parameters
    ----------
    study
        With two objectives.
    golfers
        Their shots.
    solved
        Solves a problem from a start, given a name and words for what is being done.
    """
    one, other = (study.objective(name) for name in study.objectives)
    ends = []
    for end, beside in ((one, other), (other, one)):
        problem = study.problem(golfers, end.name, others=(beside,))
        tried = [
            solved(f"front {end.name} {place}", "finding the ends of the front", problem, point)
            for place, point in enumerate(starts(problem, STARTS, study.seed))
        ]
        found = best(tried)
        if found is None:
            raise refused(problem, tried)
        ends.append((problem, found.point))
    points = [_point(problem, point, study) for problem, point in ends]
    first, last = (each.values[other.name] for each in points)
    found_points, before = [points[0]], ends[0][1]
    levels = np.linspace(first, last, study.points)[1:-1]
    for place, level in enumerate(levels):
        kept = ShotLimit(
            objective=other, least=level if other.sign < 0 else -math.inf, most=level if other.sign > 0 else math.inf
        )  # fmt: skip
        problem = study.problem(golfers, one.name, limits=(kept,))
        # The neighbour nearly keeps the new level; the other end keeps every level, and is seldom near.
        mixed = [before, ends[1][1], 0.5 * (before + ends[1][1]), *starts(problem, STARTS, study.seed)]
        tried = [
            solved(f"front {place} {start}", "following the front", problem, point) for start, point in enumerate(mixed)
        ]
        found = best(tried)
        if found is not None:
            before = found.point
            found_points.append(_point(problem, before, study))
    return tuple(_not_dominated([*found_points, points[1]], one.sign, other.sign, study.objectives))


def front_solutions(study: DesignStudy) -> int:
    """Return how many problems a front takes to solve."""
    return 2 * STARTS + (study.points - 2) * (3 + STARTS)


def _point(problem: Problem, point: NDArray[Any], study: DesignStudy) -> FrontPoint:
    judged = problem.values(point).judged
    return FrontPoint(
        club=problem.variables.club(point), values={name: float(judged[name]) for name in study.objectives}
    )  # fmt: skip


def _not_dominated(points: list[FrontPoint], one: float, other: float, names: tuple[str, ...]) -> list[FrontPoint]:
    """Leave out points than which another is better in both objectives."""
    costs = np.array([[one * each.values[names[0]], other * each.values[names[1]]] for each in points])
    size = np.abs(costs).max(axis=0)
    kept = []
    for place, each in enumerate(points):
        better = np.all(costs < costs[place] - MARGIN * size, axis=1)
        if not better.any():
            kept.append(each)
    return kept
