"""A fitting from start to end: every combination judged on the same shots, and what is free adjusted."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface.design.optimisation.fitting import Combination, Fitting, golfer_landings, judged_values
from clubface.design.optimisation.fitting_result import combinations_table
from clubface.design.optimisation.landings import Landings, Objective, own_value
from clubface.design.optimisation.solve import Problem, best, solve, starts
from clubface.design.optimisation.study import content, fitting
from clubface.design.optimisation.variables import Variables
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Wording
from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, store_for
from clubface.shots.tables.writer import csv_lines

STARTS = 3
"""Starts of a combination's adjustment; it has at most two numbers, loft and lie."""
BLOCKS = 16
"""Parts of the shots; the spread of their differences gives the standard error of a difference."""


class _Tried(NamedTuple):
    """What is kept of a combination: its changes and values [SI], and the values of parts of its shots by golfer."""

    ball: str
    changes: dict[str, float]
    values: dict[str, float]
    shots: list[int]
    parts: list[list[float]]


def fit(
    subject: Fitting | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> list[Combination]:
    """Return all combinations, the best first.

    A setting changes the loft of a head, and with it the loft at impact, the lie at impact, and the CG; a loft that is
    set by turning the head is taken to leave the face angle alone, as a golfer does who squares the face again.

    Parameters
    ----------
    subject
        The parts, for whom, and what is judged; or its file.
    output
        The CSV file to which all combinations are written. Next to it, in a folder, each is kept as soon as it is
        judged, until the file is written; without it, nothing is.
    resume
        Whether an interrupted run of another fitting is an error; otherwise it is started over. An interrupted run of
        the same fitting goes on in either case.
    progress
        Called with the number of combinations done and that of all.

    Raises
    ------
    InputError
        The file is none of a fitting, or some club can play no shot of the golfers.
    """
    subject = fitting(subject)
    depends_on = {"study": content(subject), "order of the settings": list(subject.settings)}
    with store_for(output, depends_on, resume=resume) as store:
        ranked = _ranked(subject, _all(subject, store, progress))
        if output is not None:
            store.write_result(
                Path(output), lambda file: file.write(csv_lines(combinations_table(subject, ranked).csv_rows(), ","))
            )
            store.remove()
    return ranked


def _ranked(fitting: Fitting, tried: list[_Tried]) -> list[Combination]:
    """Return combinations from the best to the worst."""
    judge = fitting.judge(fitting.objective)
    order = sorted(range(len(tried)), key=lambda place: judge.sign * tried[place].values[judge.name])
    first, weights = tried[order[0]], [weight for _, weight in fitting.golfers]
    ranked = []
    for place in order:
        one, (head, _, setting) = tried[place], fitting.names()[place]
        error = 0.0 if place == order[0] else _error(weights, one, first)
        others = {name: value for name, value in one.values.items() if name != judge.name}
        ranked.append(
            Combination(head.name, one.ball, setting, one.changes, one.values[judge.name], others, error, place)
        )
    return ranked


def _all(fitting: Fitting, store: Finished, progress: Callable[[int, int], object] | None) -> list[_Tried]:
    combinations, samples = fitting.names(), fitting.samples()

    def compute(place: int) -> list[Any]:
        head, ball, setting = combinations[place]
        return list(_tried(fitting, head, ball, setting, samples))

    job = Job("combinations", range(len(combinations)), compute, lambda place: f"combination {place}")
    return [_Tried(*each) for each in run(job, store=store, progress=progress).values()]


def _tried(fitting: Fitting, head: Club, ball: Ball | None, setting: str, samples: Any) -> _Tried:
    """Judge one combination, after what can be set freely is set as well as it can be."""
    judge, golfers = fitting.judge(fitting.objective), golfer_landings(fitting, head, ball, samples)
    changes = dict(fitting.settings[setting]) if setting else {}
    club = fitting.set(head, setting)
    if fitting.bounds:
        moved = head.replace(**{name: value for name, value in club.items() if name != "lie"})
        problem = _Adjusted(Variables(base=moved, bounds=fitting.free(head, club)), golfers, judge, club)
        solution = best([solve(problem, each) for each in starts(problem, STARTS, fitting.seed)])
        if solution is None:
            raise _impossible(head, setting)
        club |= problem.variables.club(solution.point)
        changes |= {name: club[name] - own_value(head, name) for name in fitting.bounds}
    landed = [each.of(club) for each, _ in golfers]
    if any(np.isnan(each).any() for each in landed):
        raise _impossible(head, setting)
    values = judged_values(fitting, [(one, weight) for one, (_, weight) in zip(landed, golfers, strict=True)])
    parts = [
        [judge.judge(part)[0] for part in np.array_split(one, BLOCKS, axis=1)] if one.shape[1] >= 2 * BLOCKS else []
        for one in landed
    ]
    return _Tried(golfers[0][0].ball.name, changes, values, [one.shape[1] for one in landed], parts)


def _impossible(head: Club, setting: str) -> InputError:
    setting_words = f" with the setting {setting}" if setting else ""
    return InputError(
        "fit", Wording(f"without result for {head.name}{setting_words}"), "one whose shots can all be computed"
    )


class _Adjusted(Problem):
    """A problem whose club has settings that its variables do not turn."""

    def __init__(self, variables: Variables, golfers: Any, judge: Objective, club: Mapping[str, float]) -> None:
        held = {name: value for name, value in club.items() if name not in variables.fields}
        super().__init__(variables, [(_Held(each, held), weight) for each, weight in golfers], judge, ())


class _Held(Landings):
    """Landings with a club that has some fields set."""

    def __init__(self, landings: Landings, held: Mapping[str, float]) -> None:
        self.__dict__ |= landings.__dict__
        self._held = held

    def _inputs(self, club: Mapping[str, float]) -> list[Any]:
        return super()._inputs({**self._held, **club})


def _error(weights: list[float], one: _Tried, first: _Tried) -> float:
    """Return the standard error of a difference on the same shots, from the differences of ``BLOCKS`` parts of them.

    Where other shots miss the face of the other club, the shots do not pair, and it is not known.
    """
    if one.shots != first.shots or not all(one.parts):
        return float("nan")
    differences = np.average(np.subtract(one.parts, first.parts), axis=0, weights=weights)
    return float(np.std(differences, ddof=1) / np.sqrt(BLOCKS))
