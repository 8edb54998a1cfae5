"""An optimisation from start to end: many starts on few shots, the best on all, the nominal optimum, fresh shots.

Everything finished is kept in a store where there is one, so that an interrupted run goes on where it stopped.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.feasibility import of_club, refuse_impossible
from clubface.design.optimisation.front import front, front_solutions
from clubface.design.optimisation.landings import Landings
from clubface.design.optimisation.problem import Problem
from clubface.design.optimisation.result import Fresh, FrontPoint, Optimum
from clubface.design.optimisation.solve import Solution, agreeing, best, refused, solve, starts
from clubface.design.optimisation.study import DesignStudy
from clubface.design.optimisation.study_file import design_study
from clubface.errors import RangeWarning, RuleWarning
from clubface.support.resuming import kept_beside
from clubface.support.warning import without_warnings

COARSE = 512
"""Shots of a golfer from which all starts are tried; the first of those on which the best is solved again."""
MORE = 5
"""How many times as many shots the best is solved on next."""
FRONT_SHOTS = 2048
"""Shots of a golfer for a front, at most."""
NOMINAL_STARTS = 4
REPEATS = 8
"""Independent sets of fresh shots, whose spread tells how certain a difference is."""
FRESH_SEED = 1_000_003
"""What seeds of fresh shots are beyond that of the study."""

Progress = Callable[[int, int, str], object]
"""Told of what is done, of the whole, and in words."""


def optimise(
    study: DesignStudy | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    progress: Progress | None = None,
) -> Optimum:
    """Find the best club of a study.

    Parameters
    ----------
    study
        What may change, what is best, for whom, and within which limits; or its file.
    output
        The TOML file to which the best club is written. Beside it, in a folder, what is finished is kept until the run
        ends; without it, nothing is.
    resume
        Whether to refuse to begin anew where a run of another study was interrupted; that of the same one goes on.
    progress
        Told of what is done, of the whole, and in words.

    Returns
    -------
    Optimum
        The best club, what it is judged by on fresh shots, and all limits.

    Raises
    ------
    InputError
        The file is none of a study; the club to start from is impossible in the head of the study; or no start reaches
        a club within all limits.
    """
    study = design_study(study)
    store = kept_beside(output, {"study": _content(study)}, resume=resume)
    with without_warnings(RuleWarning), without_warnings(RangeWarning), store as kept:
        found = _Run(study, kept, progress).result()
        if output is not None and kept is not None:
            kept.write_result(Path(output), lambda file: file.write(found.built.to_toml().encode()))
            kept.remove()
        return found


def _content(study: DesignStudy) -> Any:
    """Return all that a result depends on."""
    found = {name: getattr(study, name) for name in study.__dataclass_fields__ if name != "golfers"}
    found["golfers"] = [(each.content(), weight) for each, weight in study.golfers]
    return found


class _Run:
    def __init__(self, study: DesignStudy, kept: Any, progress: Progress | None) -> None:
        self.study, self._kept, self._progress = study, kept, progress
        two = len(study.objectives) == 2
        self._whole = (
            study.starts + len(_levels(study.shots)) + NOMINAL_STARTS + REPEATS + (front_solutions(study) if two else 0)
        )
        self._done = 0

    def _once(self, name: str, words: str, compute: Callable[[], Any]) -> Any:
        """Return what is kept under a name, or compute and keep it."""
        if self._progress is not None:
            self._progress(self._done, self._whole, words)
        self._done += 1
        return compute() if self._kept is None else self._kept.once(name, compute)

    def result(self) -> Optimum:
        study = self.study
        name = study.objectives[0]
        self._refuse_an_impossible_start()
        coarse = study.problem(study.landings(min(study.shots, COARSE), seed=study.seed), name)
        tried = [
            self._solved(f"start {place}", "trying starts", coarse, point)
            for place, point in enumerate(starts(coarse, study.starts, study.seed))
        ]
        first = best(tried)
        if first is None:
            raise refused(coarse, tried)
        alike = agreeing(tried, first)
        whole, found = coarse, first
        for shots in _levels(study.shots):
            whole = study.problem(study.landings(shots, seed=study.seed), name)
            found = self._solved(f"{shots} shots", f"solving on {shots} shots", whole, found.point)
        if not found.allowed:
            raise refused(whole, [found])
        club = whole.variables.club(found.point)
        nominal = self._nominal(name)
        fresh = self._fresh({"start": {}, "nominal": nominal, "optimum": club})
        points = self._front() if len(study.objectives) == 2 else ()
        missed = sum(each.missed for each, _ in whole.golfers)
        return Optimum(
            study=study, club=club, nominal=nominal, starts=study.starts, alike=alike, steps=found.steps,
            shots=whole.shots, missed=missed, fresh=fresh, front=points,
            judged=dict(whole.values(found.point).judged), message=found.message,
        )  # fmt: skip

    def _refuse_an_impossible_start(self) -> None:
        envelope = self.study.variables.envelope
        if envelope is not None:
            refuse_impossible(self.study.club.name, envelope, of_club(self.study.club))

    def _solved(self, name: str, words: str, problem: Problem, start: NDArray[Any]) -> Solution:
        def compute() -> dict[str, Any]:
            found = solve(problem, start)
            return {**found._asdict(), "point": found.point.tolist()}

        kept = self._once(name, words, compute)
        return Solution(**{**kept, "point": np.array(kept["point"])})

    def _nominal(self, name: str) -> dict[str, float]:
        """Return the club that is best for the mean deliveries alone; limits of the shots do not count."""
        study = self.study
        judged = name if study.objective(name).one_shot else "carry"
        single = Problem(study.variables, study.mean_shots(), study.objective(judged), study.design_limits())
        tried = [
            self._solved(f"nominal {place}", "solving for the mean delivery", single, point)
            for place, point in enumerate(starts(single, NOMINAL_STARTS, study.seed))
        ]
        found = best(tried)
        return {} if found is None else single.variables.club(found.point)

    def _fresh(self, clubs: Mapping[str, Mapping[str, float]]) -> Fresh:
        """Judge clubs on shots that no solver has seen, in independent sets."""
        study, count = self.study, max(self.study.shots // REPEATS, 1)
        judges = study.known()
        rows = [
            self._once(
                f"fresh {place}", "judging on fresh shots", lambda place=place: self._judged(place, count, clubs)
            )
            for place in range(REPEATS)
        ]
        table = np.array(rows)  # repeats, clubs, objectives
        return Fresh(
            shots=count * REPEATS * len(study.golfers), clubs=tuple(clubs),
            objectives=tuple(each.name for each in judges),
            values=table.mean(axis=0),
            errors=_error(table - table[:, -1:]),
        )  # fmt: skip

    def _judged(self, place: int, count: int, clubs: Mapping[str, Mapping[str, float]]) -> list[list[float]]:
        study = self.study
        golfers = study.landings(count, seed=study.seed + FRESH_SEED + place)
        return [judged(study, golfers, club) for club in clubs.values()]

    def _front(self) -> tuple[FrontPoint, ...]:
        study = self.study
        golfers = study.landings(min(study.shots, FRONT_SHOTS), seed=study.seed)
        return front(study, golfers, self._solved)


def judged(study: DesignStudy, golfers: list[tuple[Landings, float]], club: Mapping[str, float]) -> list[float]:
    """Return what every objective of a study says of a club, the mean over golfers."""
    landed = [(each.of(club), weight) for each, weight in golfers]
    total = sum(weight for _, weight in golfers)
    return [sum(weight * each.judge(one)[0] for one, weight in landed) / total for each in study.known()]


def _levels(shots: int) -> list[int]:
    """Return numbers of shots from few to all: an optimum on few is near that on five times as many."""
    found, count = [], COARSE * MORE
    while count < shots:
        found.append(count)
        count *= MORE
    return [*found, shots] if shots > COARSE else []


def _error(differences: NDArray[Any]) -> NDArray[Any]:
    """Return the standard error of the mean over independent sets, the first axis."""
    return differences.std(axis=0, ddof=1) / np.sqrt(len(differences))
