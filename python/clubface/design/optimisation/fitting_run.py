"""A fitting from start to end: every combination judged on the same shots, and what is free adjusted."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface.design.optimisation.advice import (
    BETTER,
    Advice,
    adds_nothing,
    describe_conditions,
    describe_golfers,
    judge_sets,
)
from clubface.design.optimisation.fitting import (
    Combination,
    Effect,
    Fitted,
    Fitting,
    describe,
    describe_changes,
    golfer_landings,
)
from clubface.design.optimisation.fitting_result import combinations_table
from clubface.design.optimisation.landings import Landings, Objective, own_value
from clubface.design.optimisation.solve import COARSE, Problem, best, solve, starts
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


class _Judged(NamedTuple):
    """A club as it is set for one objective [SI].

    Attributes
    ----------
    changes
        Of loft, lie and CG.
    values
        All objectives over all shots.
    sets
        Those of the advice in sets of shots.
    """

    changes: dict[str, float]
    values: list[float]
    sets: list[list[float]]


class _Tried(NamedTuple):
    """What is kept of a combination: its ball, and how it is judged as it is set for each objective."""

    ball: str
    judged: dict[str, _Judged]

    @classmethod
    def read(cls, ball: str, judged: Mapping[str, Any]) -> _Tried:
        """Return what was kept."""
        return cls(ball, {name: _Judged(*each) for name, each in judged.items()})


def fit(
    subject: Fitting | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Fitted:
    """Return all combinations, the best first, and what the golfer should do.

    A setting changes the loft of a head, and with it the loft at impact, the lie at impact, and the CG; a loft that is
    set by turning the head is taken to leave the face angle alone, as a golfer does who squares the face again.
    Combinations that do not differ by what is worth a change share a rank, and stand in the order of the parts.

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
        fitted = _fitted(subject, _all(subject, store, progress))
        if output is not None:
            table = combinations_table(subject, fitted)
            store.write_result(Path(output), lambda file: file.write(csv_lines(table.csv_rows(), ",")))
            store.remove()
    return fitted


def _fitted(fitting: Fitting, tried: list[_Tried]) -> Fitted:
    """Return ranked combinations with the advice on them."""
    purpose, count = fitting.objective, range(len(tried))
    own = [each.judged[purpose] for each in tried]
    same = next((place for place in count if _is_present(fitting, place, own[place])), None)
    present = own[same] if same is not None else _present(fitting)
    rows = {place: row for row, place in enumerate((place for place in count if place != same), 1)}
    rows |= {} if same is None else {same: 0}
    judged = [present, *(own[place] for place in count if place != same)]
    every = _advice(fitting, ["" for _ in judged], judged)
    ranks = every.ranks([rows[place] for place in count])
    order = sorted(count, key=lambda place: (ranks[rows[place]], place))
    best = max(rows.values(), key=lambda row: every.gain(purpose, row))
    ranked = [
        _combination(fitting, tried[place].ball, place, own[place])._replace(
            error=every.error(purpose, rows[place], best), rank=ranks[rows[place]]
        )
        for place in order
    ]
    with_ball = len(fitting.balls) > 1
    chosen = {describe(each, with_ball=with_ball): (each, own[each.place]) for each in ranked if each.place != same}
    combinations = len(chosen)
    for each in fitting.advised[1:]:
        tuned = [one.judged.get(each.name, own[place]) for place, one in enumerate(tried)]
        column = [one.name for one in fitting.judges].index(each.name)
        place = min(count, key=lambda place: each.sign * tuned[place].values[column])
        combination = _combination(fitting, tried[place].ball, place, tuned[place])
        known = [judged.values[column] for judged in (present, *(judged for _, judged in chosen.values()))]
        if not adds_nothing(each, fitting.worth[each.name], tuned[place].values[column], known):
            chosen.setdefault(describe(combination, with_ball=with_ball), (combination, tuned[place]))
    ball = f" with the ball {tried[0].ball}" if with_ball else ""
    names = [f"present {fitting.clubs[0].name}{ball}", *chosen]
    advice = _advice(fitting, names, [present, *(judged for _, judged in chosen.values())])
    alternatives = tuple(combination for combination, _ in chosen.values())
    return Fitted(ranked, fitting, advice, _effects(fitting, tried), alternatives, len(chosen) - combinations)


def _combination(fitting: Fitting, ball: str, place: int, judged: _Judged) -> Combination:
    head, _, setting = fitting.names()[place]
    values = {each.name: value for each, value in zip(fitting.judges, judged.values, strict=True)}
    value = values.pop(fitting.objective)
    return Combination(head.name, ball, setting, judged.changes, value, values, 0.0, place)


def _is_present(fitting: Fitting, place: int, judged: _Judged) -> bool:
    """Return whether a combination is the first club with the first ball, nothing changed that is seen."""
    head, ball, _ = fitting.names()[place]
    return head is fitting.clubs[0] and ball is fitting.balls[0] and not describe_changes(judged.changes)


def _present(fitting: Fitting) -> _Judged:
    """Return how the first club with the first ball is judged, with nothing changed."""
    golfers = golfer_landings(fitting, *fitting.names()[0][:2], fitting.samples())
    return _judged(fitting, golfers, {}, {})


def _advice(fitting: Fitting, names: list[str], judged: list[_Judged]) -> Advice:
    columns = slice(0, len(fitting.advised))
    return Advice(
        purpose=fitting.objective, golfer=describe_golfers(fitting.golfers), objectives=fitting.advised,
        names=tuple(names), values=np.array([each.values for each in judged])[:, columns],
        sets=np.array([each.sets for each in judged]), worth=fitting.worth,
        conditions=describe_conditions(fitting.setting, fitting.hole, fitting.shots),
        assumed_hole=fitting.hole is None and fitting.counted_hole is not None,
    )  # fmt: skip


def _effects(fitting: Fitting, tried: list[_Tried]) -> tuple[Effect, ...]:
    """Return how much clubs, balls and settings matter, each combination as it is set for the objective."""
    names = [(head.name, each.ball, setting) for (head, _, setting), each in zip(fitting.names(), tried, strict=True)]
    effects = []
    for place, part in enumerate(("club", "ball", "setting")):
        groups: dict[tuple[str, ...], list[int]] = {}
        for row, name in enumerate(names):
            groups.setdefault(name[:place] + name[place + 1 :], []).append(row)
        if all(len(rows) < 2 for rows in groups.values()):
            continue
        for judge in fitting.advised:
            judged = [one.judged.get(judge.name) or one.judged[fitting.objective] for one in tried]
            every = _advice(fitting, ["" for _ in judged], judged)
            ends = [
                (max(rows, key=lambda row: every.gain(judge.name, row)),
                 min(rows, key=lambda row: every.gain(judge.name, row)))
                for rows in groups.values()
            ]  # fmt: skip
            most, least = max(ends, key=lambda pair: every.gain(judge.name, *pair))
            effects.append(Effect(
                part, judge.name, every.gain(judge.name, most, least), every.error(judge.name, most, least),
                every.state(judge.name, most, least) == BETTER,
            ))  # fmt: skip
    return tuple(effects)


def _all(fitting: Fitting, store: Finished, progress: Callable[[int, int], object] | None) -> list[_Tried]:
    combinations, samples = fitting.names(), fitting.samples()

    def compute(place: int) -> list[Any]:
        head, ball, setting = combinations[place]
        return list(_tried(fitting, head, ball, setting, samples))

    job = Job("combinations", range(len(combinations)), compute, lambda place: f"combination {place}")
    return [_Tried.read(*each) for each in run(job, store=store, progress=progress).values()]


def _tried(fitting: Fitting, head: Club, ball: Ball | None, setting: str, samples: Any) -> _Tried:
    """Judge one combination, after what can be set freely is set as well as it can be for each objective."""
    golfers = golfer_landings(fitting, head, ball, samples)
    changes = dict(fitting.settings[setting]) if setting else {}
    club = fitting.set(head, setting)
    judged = {}
    for judge in fitting.advised if fitting.bounds else fitting.advised[:1]:
        tuned = _tuned(fitting, judge, head, ball, setting, samples, golfers) if fitting.bounds else {}
        moved = {name: tuned[name] - own_value(head, name) for name in fitting.bounds}
        result = _judged(fitting, golfers, {**changes, **moved}, {**club, **tuned})
        if not np.isfinite(result.values).all():
            raise _impossible(head, setting)
        judged[judge.name] = result
    return _Tried(golfers[0][0].ball.name, judged)


def _tuned(
    fitting: Fitting, judge: Objective, head: Club, ball: Ball | None, setting: str, samples: Any, golfers: Any
) -> dict[str, float]:
    """Return what can be set freely as it is best for an objective: from several starts on few shots, then on all."""
    club = fitting.set(head, setting)
    moved = head.replace(**{name: value for name, value in club.items() if name != "lie"})
    variables = Variables(base=moved, bounds=fitting.free(head, club))
    few = [({name: values[:COARSE] for name, values in sample.items()}, weight) for sample, weight in samples]
    coarse = _Adjusted(variables, golfer_landings(fitting, head, ball, few), judge, club)
    solution = best([solve(coarse, each) for each in starts(coarse, STARTS, fitting.seed)])
    problem = _Adjusted(variables, golfers, judge, club)
    if solution is not None and fitting.shots > COARSE:
        solution = best([solve(problem, solution.point)])
    if solution is None:
        raise _impossible(head, setting)
    return problem.variables.club(solution.point)


def _judged(fitting: Fitting, golfers: Any, changes: Mapping[str, float], club: Mapping[str, float]) -> _Judged:
    """Return how a club is judged by all objectives, over all shots and in sets of them."""
    landed = [(each, weight, each.of(club)) for each, weight in golfers]
    whole = judge_sets(fitting.judges, landed, 1)[0]
    return _Judged(dict(changes), whole.tolist(), judge_sets(fitting.advised, landed).tolist())


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
