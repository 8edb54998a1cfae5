"""The complete fitting: every combination is adjusted and evaluated on the same shots; and its result."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface.design.optimisation import advice as advising
from clubface.design.optimisation.advice import BETTER, Advice, judge_sets, short_label
from clubface.design.optimisation.fitting import Fitting, Samples, adjusted, describe_changes
from clubface.design.optimisation.landings import Landings, Objective, own_value
from clubface.design.optimisation.result import landings_panel, study_provenance
from clubface.design.optimisation.solve import COARSE, Problem, best, solve, starts
from clubface.design.optimisation.study import content, fitting
from clubface.design.optimisation.variables import Variables
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Wording
from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, store_for
from clubface.results.notes import Note, note
from clubface.results.pictures import Picture
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.shots.tables.writer import csv_lines

STARTS = 3
"""Solver starts for adjusting a combination, which has at most two variables, loft and lie."""
SHOWN = 12
"""Maximum number of combinations printed; files have them all."""
BARS = 10
"""Maximum number of alternatives drawn."""


class Combination(NamedTuple):
    """One possible combination of club, ball and setting.

    Attributes
    ----------
    club, ball, setting
        Names of the club, the ball, and the head's setting ("" without settings).
    changes
        Changes of loft, lie and CG [SI], including adjusted ones.
    value, others
        Values of the main objective, and of the others by name [SI].
    error
        Standard error of the difference from the best [SI]; 0 for the best itself.
    place
        Index of the combination in the fitting.
    rank
        1 for the best; combinations whose difference is not worth a change share a rank.
    """

    club: str
    ball: str
    setting: str
    changes: Mapping[str, float]
    value: float
    others: Mapping[str, float]
    error: float
    place: int
    rank: int = 1

    def describe(self, *, with_ball: bool = True) -> str:
        """Return a description such as "driver with the ball modern, the setting "back", 1.0 deg more loft"."""
        parts = [f"{self.club} with the ball {self.ball}" if with_ball else self.club]
        parts += [f'the setting "{self.setting}"'] if self.setting else []
        changed = describe_changes(self.changes)
        return ", ".join([*parts, changed] if changed else parts)


class Effect(NamedTuple):
    """How much one kind of part matters: its largest effect on an objective, all else being equal.

    Attributes
    ----------
    part, objective
        "club", "ball" or "setting", and the name of an objective.
    difference, error
        The largest difference between two parts, and its standard error [SI].
    matters
        Whether the difference is worth a change and statistically clear.
    """

    part: str
    objective: str
    difference: float
    error: float
    matters: bool


class Fitted(list[Combination], Described):
    """The combinations of a fitting, sorted by rank.

    Attributes
    ----------
    fitting, advice
        The fitting, and advice on the present club, all combinations, and the best for other objectives.
    effects
        How much clubs, balls and settings matter, by objective.
    alternatives
        The clubs of the advice after the present one, in its order.
    others
        Number of alternatives, at the end of the advice, adjusted for other objectives.
    """

    def __init__(
        self,
        combinations: list[Combination],
        fitting: Fitting,
        advice: Advice,
        effects: tuple[Effect, ...],
        alternatives: tuple[Combination, ...],
        others: int,
    ) -> None:
        super().__init__(combinations)
        self.fitting, self.advice, self.effects = fitting, advice, effects
        self.alternatives, self.others = alternatives, others

    @property
    def leading(self) -> Combination | None:
        """The club recommended or, if none is, the best candidate; None for the present club."""
        place = self.advice.recommended() or self.advice.best(self.advice.purpose)
        return self.alternatives[place - 1] if place else None

    def to_result(self) -> Result:
        """Return the combinations and the advice as a result."""
        fitting, advice = self.fitting, self.advice
        count = len(advice.names)
        shown = [row for row in range(count) if row <= SHOWN or row >= count - self.others]
        tables = [combinations_table(fitting, self), *advising.advice_tables(advice, shown=shown)]
        if self.effects:
            tables.append(_effects_table(self))
        return Result(
            kind="fitting", title=fitting.title, tables=tuple(tables),
            lead=(*advising.advice_lead(advice), *_part_notes(self)),
            notes=(*_notes(self), *advising.advice_notes(advice)),
            provenance=study_provenance(fitting, fitting.clubs, fitting.balls),
            # Two pictures: a printed page puts the first below the advice.
            draw=lambda: [fitting_picture(self), *([fitting_landings_picture(self)] if count > 1 else [])],
        )  # fmt: skip


class _AdjustedClub(NamedTuple):
    """A club adjusted for one objective: its changes [SI], all objectives, and those of the advice in sets of shots."""

    changes: dict[str, float]
    values: list[float]
    sets: list[list[float]]


class _CombinationResult(NamedTuple):
    """The stored results of a combination: its ball, and its values when adjusted for each objective."""

    ball: str
    judged: dict[str, _AdjustedClub]


def fit(
    subject: Fitting | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Fitted:
    """Return all combinations, the best first, and advice for the golfer.

    A setting changes the head's loft (and with it the loft at impact), the lie at impact, and the CG. Turning the head
    to change loft is assumed to leave the face angle unchanged, because golfers square the face again. Combinations
    whose difference is not worth a change share a rank and keep the order of the parts.

    Parameters
    ----------
    subject
        The fitting, or its file.
    output
        CSV file for all combinations. Finished ones are kept in a folder next to it until the file is written; without
        an output nothing is kept.
    resume
        As for :func:`clubface.optimise`.
    progress
        Called with the number of combinations done and the total.

    Raises
    ------
    InputError
        The file does not describe a fitting, or some club cannot play any of the golfers' shots.
    """
    subject = fitting(subject)
    depends_on = {"study": content(subject), "order of the settings": list(subject.settings)}
    with store_for(output, depends_on, resume=resume) as store:
        fitted = _rank(subject, _run_combinations(subject, store, progress))
        if output is not None:
            table = combinations_table(subject, fitted)
            store.write_result(Path(output), lambda file: file.write(csv_lines(table.csv_rows(), ",")))
            store.remove()
    return fitted


def _rank(fitting: Fitting, tried: list[_CombinationResult]) -> Fitted:
    purpose, count = fitting.objective, range(len(tried))
    own = [each.judged[purpose] for each in tried]
    same = next((place for place in count if _is_present(fitting, place, own[place])), None)
    if same is None:
        samples = fitting.samples(fitting.shots, fitting.seed)
        present = _judge_club(fitting, fitting.landings(*fitting.combinations()[0][:2], samples), {}, {})
    else:
        present = own[same]
    rows = {place: row for row, place in enumerate((place for place in count if place != same), 1)}
    rows |= {} if same is None else {same: 0}
    judged = [present, *(own[place] for place in count if place != same)]
    every = _advice(fitting, judged)
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
    chosen = {each.describe(with_ball=with_ball): (each, own[each.place]) for each in ranked if each.place != same}
    combinations = len(chosen)
    for each in fitting.advised[1:]:
        tuned = [one.judged.get(each.name, own[place]) for place, one in enumerate(tried)]
        column = [one.name for one in fitting.judges].index(each.name)
        place = min(count, key=lambda place: each.sign * tuned[place].values[column])
        combination = _combination(fitting, tried[place].ball, place, tuned[place])
        known = [judged.values[column] for judged in (present, *(judged for _, judged in chosen.values()))]
        if not advising.adds_nothing(each, fitting.worth[each.name], tuned[place].values[column], known):
            chosen.setdefault(combination.describe(with_ball=with_ball), (combination, tuned[place]))
    ball = f" with the ball {tried[0].ball}" if with_ball else ""
    names = [f"present {fitting.clubs[0].name}{ball}", *chosen]
    advice = _advice(fitting, [present, *(judged for _, judged in chosen.values())], names)
    alternatives = tuple(combination for combination, _ in chosen.values())
    return Fitted(ranked, fitting, advice, _effects(fitting, tried), alternatives, len(chosen) - combinations)


def _combination(fitting: Fitting, ball: str, place: int, judged: _AdjustedClub) -> Combination:
    head, _, setting = fitting.combinations()[place]
    values = {each.name: value for each, value in zip(fitting.judges, judged.values, strict=True)}
    value = values.pop(fitting.objective)
    return Combination(head.name, ball, setting, judged.changes, value, values, 0.0, place)


def _is_present(fitting: Fitting, place: int, judged: _AdjustedClub) -> bool:
    """Return whether a combination is the first club with the first ball and no visible change."""
    head, ball, _ = fitting.combinations()[place]
    return head is fitting.clubs[0] and ball is fitting.balls[0] and not describe_changes(judged.changes)


def _advice(fitting: Fitting, judged: list[_AdjustedClub], names: Sequence[str] = ()) -> Advice:
    values = np.array([each.values for each in judged])[:, : len(fitting.advised)]
    sets = np.array([each.sets for each in judged])
    return fitting.advice(names or [""] * len(judged), values, sets, fitting.shots)


def _effects(fitting: Fitting, tried: list[_CombinationResult]) -> tuple[Effect, ...]:
    """Return how much clubs, balls and settings matter, with each combination adjusted for the objective."""
    combinations = zip(fitting.combinations(), tried, strict=True)
    names = [(head.name, each.ball, setting) for (head, _, setting), each in combinations]
    effects = []
    for place, part in enumerate(("club", "ball", "setting")):
        groups: dict[tuple[str, ...], list[int]] = {}
        for row, name in enumerate(names):
            groups.setdefault(name[:place] + name[place + 1 :], []).append(row)
        if all(len(rows) < 2 for rows in groups.values()):
            continue
        for judge in fitting.advised:
            every = _advice(fitting, [one.judged.get(judge.name) or one.judged[fitting.objective] for one in tried])
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


def _run_combinations(
    fitting: Fitting, store: Finished, progress: Callable[[int, int], object] | None
) -> list[_CombinationResult]:
    combinations, samples = fitting.combinations(), fitting.samples(fitting.shots, fitting.seed)

    def compute(place: int) -> list[Any]:
        return list(_evaluate(fitting, *combinations[place], samples))

    job = Job("combinations", range(len(combinations)), compute, lambda place: f"combination {place}")
    kept = run(job, store=store, progress=progress).values()
    return [_CombinationResult(ball, {name: _AdjustedClub(*each) for name, each in own.items()}) for ball, own in kept]


def _evaluate(fitting: Fitting, head: Club, ball: Ball | None, setting: str, samples: Samples) -> _CombinationResult:
    """Evaluate one combination after adjusting its free settings for each objective."""
    golfers = fitting.landings(head, ball, samples)
    changes = dict(fitting.settings[setting]) if setting else {}
    club = fitting.set(head, setting)
    judged = {}
    for judge in fitting.advised if fitting.bounds else fitting.advised[:1]:
        tuned = _tune(fitting, judge, head, ball, setting, samples, golfers) if fitting.bounds else {}
        moved = {name: tuned[name] - own_value(head, name) for name in fitting.bounds}
        result = _judge_club(fitting, golfers, {**changes, **moved}, {**club, **tuned})
        if not np.isfinite(result.values).all():
            raise _no_shot_error(head, setting)
        judged[judge.name] = result
    return _CombinationResult(golfers[0][0].ball.name, judged)


def _tune(
    fitting: Fitting, judge: Objective, head: Club, ball: Ball | None, setting: str, samples: Samples, golfers: Any
) -> dict[str, float]:
    """Return the best free settings for an objective: several starts on few shots, then the best on all shots."""
    club = fitting.set(head, setting)
    held = {name: value for name, value in club.items() if name not in fitting.bounds}
    variables = Variables(base=adjusted(head, club), bounds=fitting.free(head, club), held=held)
    few = [({name: values[:COARSE] for name, values in sample.items()}, weight) for sample, weight in samples]
    coarse = Problem(variables, fitting.landings(head, ball, few), judge, ())
    solution = best([solve(coarse, each) for each in starts(coarse, STARTS, fitting.seed)])
    if solution is not None and fitting.shots > COARSE:
        solution = best([solve(Problem(variables, golfers, judge, ()), solution.point)])
    if solution is None:
        raise _no_shot_error(head, setting)
    return {name: value for name, value in variables.club(solution.point).items() if name not in held}


def _judge_club(
    fitting: Fitting, golfers: Sequence[tuple[Landings, float]], changes: Mapping[str, float], club: Mapping[str, float]
) -> _AdjustedClub:
    """Return all objectives of a club, over all shots and in sets of shots."""
    landed = [(each, weight, each.of(club)) for each, weight in golfers]
    whole = judge_sets(fitting.judges, landed, 1)[0]
    return _AdjustedClub(dict(changes), whole.tolist(), judge_sets(fitting.advised, landed).tolist())


def _no_shot_error(head: Club, setting: str) -> InputError:
    setting_words = f" with the setting {setting}" if setting else ""
    return InputError(
        "fit",
        Wording(f"impossible for {head.name}{setting_words}: a shot cannot be computed"),
        "give other settings or bounds",
    )


def combinations_table(fitting: Fitting, combinations: Sequence[Combination]) -> Table:
    """Return all combinations as a table."""
    first, *others = (fitting.judge(name) for name in (fitting.objective, *combinations[0].others))
    changes = dict.fromkeys(name for each in combinations for name in each.changes)
    best = max((each.value for each in combinations), key=lambda value: -first.sign * value)
    columns = [
        text("place", [each.rank for each in combinations], label=""),
        text("club", [each.club for each in combinations]),
        text("ball", [each.ball for each in combinations]),
        text("setting", [each.setting for each in combinations], printed=any(each.setting for each in combinations)),
        text("changes", [describe_changes(each.changes) for each in combinations], in_files=False,
             printed=bool(changes)),
        *(column(f"{name}_change", [each.changes.get(name, 0.0) for each in combinations],
                 "rad" if name in ("loft", "lie") else "m", printed=False) for name in changes),
        Column(first.name, [each.value for each in combinations], first.quantity),
        Column("against_the_best", [each.value - best for each in combinations], first.quantity,
               "difference from the best", difference=True),
        Column("error", [each.error for each in combinations], first.quantity, "±"),
        *(Column(judge.name, [each.others[judge.name] for each in combinations], judge.quantity) for judge in others),
    ]  # fmt: skip
    return Table("combinations", tuple(columns), printed=False)


def _effects_table(fitted: Fitted) -> Table:
    kinds = [fitted.fitting.judge(each.objective).quantity for each in fitted.effects]
    columns = (
        text("part", [each.part for each in fitted.effects]),
        *row_names("objective", [each.objective for each in fitted.effects], [each.label for each in kinds]),
        Column("difference", [each.difference for each in fitted.effects], kinds, "largest difference"),
        Column("error", [each.error for each in fitted.effects], kinds, "±"),
        Column("worth", [fitted.advice.worth[each.objective] for each in fitted.effects], kinds, "worth a change"),
        text("matters", [each.matters for each in fitted.effects]),
    )
    return Table("effects", columns, "Effect of each part, all else being equal")


def _part_notes(fitted: Fitted) -> Iterator[Note]:
    parts = {each.part: [] for each in fitted.effects}
    for each in fitted.effects:
        if each.matters:
            judge = fitted.fitting.judge(each.objective)
            parts[each.part].append(f"{short_label(judge)} by up to {judge.show(each.difference)}")
    if idle := [part for part, effects in parts.items() if not effects]:
        yield note("fitting-parts-idle", parts=idle)
    if effects := [f"the {part}: {', '.join(effects)}" for part, effects in parts.items() if effects]:
        yield note("fitting-parts-matter", effects=effects)


def _notes(fitted: Fitted) -> Iterator[Note]:
    fitting, leading = fitted.fitting, fitted.leading
    yield note(
        "fitting-shots", combinations=len(fitted), shots=fitting.shots, golfers=len(fitting.golfers),
        club=fitting.clubs[0].name,
    )  # fmt: skip
    if leading is not None:
        by_setting = fitting.settings.get(leading.setting, {})
        free = {name: leading.changes[name] - by_setting.get(name, 0.0) for name in fitting.bounds}
        if ends := [name for name, limits in fitting.bounds.items() if advising.is_at_an_end(free[name], limits)]:
            yield note("fitting-at-an-end", names=ends)
    if len(fitted) > SHOWN:
        yield note("fitting-not-shown", hidden=len(fitted) - SHOWN)


def fitting_picture(fitted: Fitted) -> Picture:
    """Return the gains of the alternatives over the present club, or its landings if there are no alternatives."""
    advice = fitted.advice
    if len(advice.names) == 1:
        return fitting_landings_picture(fitted)
    rows = min(len(advice.names) - 1, BARS)
    caption = "Gain of each alternative over the present club"
    return Picture("fitting", caption, [[advising.gains_panel(advice, BARS)]], height=1.3 + 0.5 * rows)


def fitting_landings_picture(fitted: Fitted) -> Picture:
    """Return the landings with the present club and with the leading alternative."""
    fitting, leading = fitted.fitting, fitted.leading
    clubs, caption = {"present": fitting.landed(0, {})}, "Landings with the present club, which is the best one"
    if leading is not None:
        clubs[f"best for {short_label(fitted.advice.objectives[0])}"] = fitting.landed(leading.place, leading.changes)
        caption = "Landings with the present club and with the best one"
    panel = landings_panel({name: np.concatenate(each, axis=1) for name, each in clubs.items()})
    return Picture("fitting-landings", caption, [[panel]], height=3.2)
