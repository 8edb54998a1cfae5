"""The complete optimisation: many starts on few shots, the best on all, the nominal optimum, fresh shots.

Finished parts are kept in a store, if there is one, so that an interrupted run resumes. The Pareto front between two
objectives is found by the epsilon-constraint method (Haimes, Lasdon and Wismer, 1971): one is optimised while the other
is limited.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from clubface.design.feasibility import of_club, refuse_impossible
from clubface.design.optimisation.advice import judge_sets
from clubface.design.optimisation.landings import Landings
from clubface.design.optimisation.result import Fresh, FrontPoint, Optimum
from clubface.design.optimisation.solve import COARSE, Problem, Solution, agreeing, best, refused, solve, starts
from clubface.design.optimisation.study import DesignStudy, content, design_study
from clubface.errors import RangeWarning, RuleWarning
from clubface.jobs.store import Finished, store_for
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

MORE = 5
"""Factor on the number of shots from one level to the next."""
FRONT_STARTS = 6
"""Starts for every point of a front besides its neighbours, since it may jump from one kind of club to another."""
MARGIN = 1e-9
"""Relative tolerance within which a point of a front is not dominated."""
FRONT_SHOTS = 2048
"""Maximum number of shots per golfer for a front."""
NOMINAL_STARTS = 4
RIVAL_STARTS = 3
"""Solver starts for each other objective: the optimum, the starting club, and one more."""
REPEATS = 8
"""Number of independent sets of fresh shots; their spread gives the standard error of a difference."""
FRESH_SEED = 1_000_003
"""Offset of the seeds of fresh shots from the study's seed."""

Progress = Callable[[int, int, str], object]
"""Called with the number of parts done, the total, and a description of the current part."""


def optimise(
    study: DesignStudy | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    others: Sequence[str] | None = None,
    progress: Progress | None = None,
) -> Optimum:
    """Find the best club of a study, and how it compares by other objectives.

    Parameters
    ----------
    study
        The study, or its file.
    output
        TOML file for the best club. Finished parts are kept in a folder next to it until the run ends; without an
        output nothing is kept.
    resume
        Whether finding the interrupted run of a different study is an error; otherwise it starts over. An interrupted
        run of the same study always resumes.
    others
        Other objectives for which the best clubs are found as well, for the advice; default ``ADVISED``.
    progress
        Called with the number of parts done, the total, and a description of the current part.

    Raises
    ------
    InputError
        The file does not describe a study; the starting club is impossible in the study's head; or no start reaches a
        club within all limits.
    """
    study = design_study(study)
    store = store_for(output, {"study": content(study)}, resume=resume)
    with without_warnings(RuleWarning), without_warnings(RangeWarning), store as kept:
        result = _Run(study, kept, others, progress).result()
        if output is not None:
            kept.write_result(Path(output), lambda file: file.write(result.built.to_toml().encode()))
            kept.remove()
        return result


class _Run:
    def __init__(
        self, study: DesignStudy, kept: Finished, others: Sequence[str] | None, progress: Progress | None
    ) -> None:
        self.study, self._kept, self._progress = study, kept, progress
        self._others = [each.name for each in study.advised[1:]] if others is None else list(others)
        levels = len(_levels(study.shots))
        self._total = study.starts + levels + NOMINAL_STARTS + REPEATS
        self._total += len(self._others) * (RIVAL_STARTS + min(levels, 1))
        if len(study.objectives) == 2:
            self._total += 2 * FRONT_STARTS + (study.points - 2) * (3 + FRONT_STARTS)
        self._done = 0

    def _kept_or_computed(self, name: str, words: str, compute: Callable[[], Any]) -> Any:
        """Return the result stored under a name, or compute and store it."""
        if self._progress is not None:
            self._progress(self._done, self._total, words)
        self._done += 1
        return self._kept.once(name, compute)

    def _solve(self, name: str, words: str, problem: Problem, start: Floats) -> Solution:
        def compute() -> dict[str, Any]:
            solution = solve(problem, start)
            return {**solution._asdict(), "point": solution.point.tolist()}

        kept = self._kept_or_computed(name, words, compute)
        return Solution(**{**kept, "point": np.array(kept["point"])})

    def _solve_all(self, name: str, words: str, problem: Problem, points: Sequence[Floats]) -> list[Solution]:
        return [self._solve(f"{name} {place}", words, problem, point) for place, point in enumerate(points)]

    def _problem(self, shots: int, name: str) -> Problem:
        """Return the problem for an objective on at most ``shots`` shots per golfer."""
        study = self.study
        return study.problem(study.landings(min(study.shots, shots), seed=study.seed), name)

    def result(self) -> Optimum:
        study = self.study
        name = study.objectives[0]
        if (envelope := study.variables.envelope) is not None:
            refuse_impossible(study.club.name, envelope, of_club(study.club))
        coarse = self._problem(COARSE, name)
        tried = self._solve_all("start", "trying starts", coarse, starts(coarse, study.starts, study.seed))
        first = best(tried)
        if first is None:
            raise refused(coarse, tried)
        alike = agreeing(tried, first)
        whole, result = coarse, first
        for shots in _levels(study.shots):
            whole = self._problem(shots, name)
            result = self._solve(f"{shots} shots", f"solving on {shots} shots", whole, result.point)
        if not result.allowed:
            raise refused(whole, [result])
        club = whole.variables.club(result.point)
        nominal = self._nominal(name)
        rivals = {other: fields for other in self._others if (fields := self._rival(other, result.point))}
        fresh = self._fresh({"start": {}, "nominal": nominal, "optimum": club, **rivals})
        points = self._front() if len(study.objectives) == 2 else ()
        missed = sum(each.missed for each, _ in whole.golfers)
        return Optimum(
            study=study, club=club, nominal=nominal, starts=study.starts, alike=alike, steps=result.steps,
            shots=whole.shots, missed=missed, fresh=fresh, rivals=rivals, front=points,
            judged=dict(whole.values(result.point).judged), message=result.message,
        )  # fmt: skip

    def _nominal(self, name: str) -> dict[str, float]:
        """Return the best club for the mean deliveries alone, without limits on the shots."""
        study = self.study
        judged = name if study.objective(name).one_shot else "carry"
        single = Problem(study.variables, study.mean_shots(), study.objective(judged), study.design_limits())
        points = starts(single, NOMINAL_STARTS, study.seed)
        solution = best(self._solve_all("nominal", "solving for the mean delivery", single, points))
        return {} if solution is None else single.variables.club(solution.point)

    def _rival(self, name: str, optimum: Floats) -> dict[str, float]:
        """Return the best club for another objective within the same limits; empty if none is reached."""
        words = f"solving for {name.replace('_', ' ')}"
        coarse = self._problem(COARSE, name)
        points = [optimum, *starts(coarse, RIVAL_STARTS - 1, self.study.seed)]
        solution = best(self._solve_all(name, words, coarse, points))
        if solution is None:
            return {}
        if (levels := _levels(self.study.shots)) and levels[0] > COARSE:
            more = self._problem(levels[0], name)
            finer = self._solve(f"{name} {levels[0]} shots", words, more, solution.point)
            solution = finer if finer.allowed else solution
        return coarse.variables.club(solution.point)

    def _fresh(self, clubs: Mapping[str, Mapping[str, float]]) -> Fresh:
        """Evaluate clubs on independent sets of shots that were not used in the optimisation."""
        study, count = self.study, max(self.study.shots // REPEATS, 1)

        def judge(place: int) -> list[list[float]]:
            golfers = study.landings(count, seed=study.seed + FRESH_SEED + place)
            return [judged(study, golfers, club) for club in clubs.values()]

        rows = [
            self._kept_or_computed(f"fresh {place}", "judging on fresh shots", lambda place=place: judge(place))
            for place in range(REPEATS)
        ]
        return Fresh(
            shots=count * REPEATS * len(study.golfers), clubs=tuple(clubs),
            objectives=tuple(each.name for each in study.known()), sets=np.array(rows),
        )  # fmt: skip

    def _front(self) -> tuple[FrontPoint, ...]:
        """Return points of the Pareto front, from the best by the first objective to the best by the second."""
        study = self.study
        golfers = study.landings(min(study.shots, FRONT_SHOTS), seed=study.seed)
        one, other = (study.objective(name) for name in study.objectives)
        ends = []
        for end, second in ((one, other), (other, one)):
            problem = study.problem(golfers, end.name, others=(second,))
            points = starts(problem, FRONT_STARTS, study.seed)
            tried = self._solve_all(f"front {end.name}", "finding the ends of the front", problem, points)
            solution = best(tried)
            if solution is None:
                raise refused(problem, tried)
            ends.append((_point(problem, solution.point, study), solution.point))
        (first, before), (last, farther) = ends
        kept_points = [first]
        for place, level in enumerate(
            np.linspace(first.values[other.name], last.values[other.name], study.points)[1:-1]
        ):
            limits = (level, math.inf) if other.sign < 0 else (-math.inf, level)
            problem = study.problem(golfers, one.name, limits=(study.shot_limit(other.name, *limits),))
            # The previous point nearly meets the new level; the other end meets every level but is rarely near.
            mixed = [before, farther, 0.5 * (before + farther), *starts(problem, FRONT_STARTS, study.seed)]
            solution = best(self._solve_all(f"front {place}", "following the front", problem, mixed))
            if solution is not None:
                before = solution.point
                kept_points.append(_point(problem, before, study))
        return tuple(_not_dominated([*kept_points, last], one.sign, other.sign, study.objectives))


def _point(problem: Problem, point: Floats, study: DesignStudy) -> FrontPoint:
    judged = problem.values(point).judged
    return FrontPoint(problem.variables.club(point), {name: float(judged[name]) for name in study.objectives})


def _not_dominated(points: list[FrontPoint], one: float, other: float, names: tuple[str, ...]) -> list[FrontPoint]:
    """Return the points that no other point beats in both objectives."""
    costs = np.array([[one * each.values[names[0]], other * each.values[names[1]]] for each in points])
    size = np.abs(costs).max(axis=0)
    is_beaten = (np.all(costs < cost - MARGIN * size, axis=1).any() for cost in costs)
    return [each for each, beaten in zip(points, is_beaten, strict=True) if not beaten]


def judged(study: DesignStudy, golfers: list[tuple[Landings, float]], club: Mapping[str, float]) -> list[float]:
    """Return all objectives of a study [SI] for a club, averaged over golfers by weight."""
    landed = [(each, weight, each.of(club)) for each, weight in golfers]
    return judge_sets(study.known(), landed, 1)[0].tolist()


def _levels(shots: int) -> list[int]:
    """Return increasing numbers of shots up to all: the optimum on few shots is near the one on five times as many."""
    levels, count = [], COARSE * MORE
    while count < shots:
        levels.append(count)
        count *= MORE
    return [*levels, shots] if shots > COARSE else []
