"""A fitting from start to end: combinations judged on the same shots, in tables and sentences.

A fitting from start to end: every combination judged on the same shots, and what is free adjusted.

A fitting in tables and sentences.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.design.optimisation.fitting import Combination, Fitting, changed, named, told
from clubface.design.optimisation.landings import Landings, Objective, objectives
from clubface.design.optimisation.result import CERTAIN, at_an_end, heading, signed, written, written_error
from clubface.design.optimisation.solve import Problem, best, solve, starts
from clubface.design.optimisation.study import fitting
from clubface.design.optimisation.variables import Variables
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Told
from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, store_for
from clubface.present.document import Data, file_name

STARTS = 3
"""Starts of a combination's adjustment; it has at most two numbers, loft and lie."""
BLOCKS = 16
"""Parts of the shots whose differences tell how certain a difference is."""


class _Tried(NamedTuple):
    """What is kept of a combination: its changes and values [SI], and the values of parts of its shots by golfer."""

    ball: str
    changes: dict[str, float]
    values: dict[str, float]
    shots: list[int]
    parts: list[list[float]]


def fit(
    of: Fitting | str | os.PathLike[str],
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
    of
        The parts, for whom, and what is judged; or its file.
    output
        The CSV file to which all combinations are written. Beside it, in a folder, each is kept as soon as it is
        judged, until the file is written; without it, nothing is.
    resume
        Whether to refuse to begin anew where a run of another fitting was interrupted; that of the same one goes on.
    progress
        Told of what is done and of the whole.

    Raises
    ------
    InputError
        The file is none of a fitting, or some club can play no shot of the golfers.
    """
    of = fitting(of)
    with store_for(output, _content(of), resume=resume) as store:
        found = _ranked(of, _all(of, store, progress))
        if output is not None:
            store.write_result(Path(output), lambda file: file.write(table(of, found).as_csv().encode()))
            store.remove()
    return found


def table(of: Fitting, found: Sequence[Combination]) -> Data:
    """Return all combinations as a table, in the units of its headings."""
    judges = [of.judge(each) for each in (of.objective, *found[0].others)]
    changes = {name: "deg" if name in ("loft", "lie") else "mm" for each in found for name in each.changes}
    heads = ["club", "ball", "setting", *(f"{name} changed ({unit})" for name, unit in changes.items())]
    heads += [each.name if each.unit == "1" else f"{each.name} ({each.unit})" for each in judges]
    first = judges[0]
    heads.append(f"error of the difference from the best{'' if first.unit == '1' else f' ({first.unit})'}")
    rows = []
    for each in found:
        moved = [float(units.from_si(each.changes.get(name, 0.0), unit)) for name, unit in changes.items()]
        values = [{first.name: each.value, **each.others}[judge.name] for judge in judges]
        told = [units.from_si(value, judge.unit) for value, judge in zip(values, judges, strict=True)]
        rows.append([each.club, each.ball, each.setting, *moved, *told, units.from_si(each.error, first.unit)])
    return Data(file_name(of.title), heads, rows)


def _ranked(of: Fitting, tried: list[_Tried]) -> list[Combination]:
    """Return combinations from the best to the worst."""
    judge = of.judge(of.objective)
    order = sorted(range(len(tried)), key=lambda place: judge.sign * tried[place].values[judge.name])
    first, weights = tried[order[0]], [weight for _, weight in of.golfers]
    found = []
    for place in order:
        one, (head, _, setting) = tried[place], of.names()[place]
        error = 0.0 if place == order[0] else _error(weights, one, first)
        others = {name: value for name, value in one.values.items() if name != judge.name}
        found.append(
            Combination(head.name, one.ball, setting, one.changes, one.values[judge.name], others, error, place)
        )
    return found


def _content(of: Fitting) -> dict[str, Any]:
    """Return all that a result depends on."""
    found = {name: getattr(of, name) for name in of.__dataclass_fields__ if name != "golfers"}
    found["golfers"] = [(each.content(), weight) for each, weight in of.golfers]
    return {"study": found, "order of the settings": list(of.settings)}


def _all(of: Fitting, store: Finished, progress: Callable[[int, int], object] | None) -> list[_Tried]:
    combinations, samples = of.names(), of.samples()

    def compute(place: int) -> list[Any]:
        head, ball, setting = combinations[place]
        return list(_tried(of, head, ball, setting, samples))

    job = Job("combinations", range(len(combinations)), compute, lambda place: f"combination {place}")
    return [_Tried(*each) for each in run(job, store=store, progress=progress).values()]


def landings(of: Fitting, found: Combination) -> list[Any]:
    """Return where the shots of every golfer land with a combination [m], each of shape (landings, shots)."""
    head, ball, _ = of.names()[found.place]
    club = changed(head, found.changes)
    return [each.of(club) for each, _ in _landings(of, head, ball, of.samples())]


def as_it_is(of: Fitting) -> dict[str, float]:
    """Return what the first club with the first ball is judged by, with nothing changed [SI]."""
    return _values(of, [(each.of({}), weight) for each, weight in _landings(of, *of.names()[0][:2], of.samples())])


def _landings(of: Fitting, head: Club, ball: Ball | None, samples: Any) -> list[tuple[Landings, float]]:
    """Return the shots of the golfers with a head and a ball."""
    own, base_loft = replace(of.setting, ball=ball), of.clubs[0].loft
    found = []
    for sample, weight in samples:
        # The golfer delivers his loft with the first club; another head delivers as much more as it has more of it.
        delivered = {**sample, "loft": sample.get("loft", base_loft) + (head.loft - base_loft)}
        found.append((Landings(head, delivered, own), weight))
    return found


def _tried(of: Fitting, head: Club, ball: Ball | None, setting: str, samples: Any) -> _Tried:
    """Judge one combination, after what can be set freely is set as well as it can be."""
    judge, golfers = of.judge(of.objective), _landings(of, head, ball, samples)
    changes = dict(of.settings[setting]) if setting else {}
    club = of.set(head, setting)
    if of.bounds:
        moved = head.replace(**{name: value for name, value in club.items() if name != "lie"})
        problem = _Adjusted(Variables(base=moved, bounds=of.free(head, club)), golfers, judge, club)
        found = best([solve(problem, each) for each in starts(problem, STARTS, of.seed)])
        if found is None:
            raise _impossible(head, setting)
        club |= problem.variables.club(found.point)
        changes |= {name: club[name] - (0.0 if name == "lie" else getattr(head, name)) for name in of.bounds}
    landed = [each.of(club) for each, _ in golfers]
    if any(np.isnan(each).any() for each in landed):
        raise _impossible(head, setting)
    values = _values(of, [(one, weight) for one, (_, weight) in zip(landed, golfers, strict=True)])
    parts = [
        [judge.judge(part)[0] for part in np.array_split(one, BLOCKS, axis=1)] if one.shape[1] >= 2 * BLOCKS else []
        for one in landed
    ]
    return _Tried(golfers[0][0].ball.name, changes, values, [one.shape[1] for one in landed], parts)


def _values(of: Fitting, landed: Sequence[tuple[Any, float]]) -> dict[str, float]:
    """Return every objective of the landings of golfers, each with how much he counts, by its name."""
    total = sum(weight for _, weight in landed)
    return {
        each.name: sum(weight * each.judge(one)[0] for one, weight in landed) / total for each in objectives(of.hole)
    }


def _impossible(head: Club, setting: str) -> InputError:
    with_ = f" with the setting {setting}" if setting else ""
    return InputError("fit", Told(f"without result for {head.name}{with_}"), "one whose shots can all be computed")


class _Adjusted(Problem):
    """A problem whose club has settings that its variables do not turn."""

    def __init__(self, variables: Variables, golfers: Any, judge: Objective, club: Mapping[str, float]) -> None:
        held = {name: value for name, value in club.items() if name not in variables.fields}
        super().__init__(variables, [(_Held(each, held), weight) for each, weight in golfers], judge, ())


class _Held(Landings):
    """Landings with a club some fields of which are set."""

    def __init__(self, of: Landings, held: Mapping[str, float]) -> None:
        self.__dict__ |= of.__dict__
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


SHOWN = 12
"""Combinations of a fitting that are shown; the file of --output has all."""
FELT = 2.0
"""Yards below which a difference is taken to escape a golfer on a range, however certain it is of computed shots. It is
assumed: no measurement was found."""


def best_table(of: Fitting, found: list[Combination]) -> tuple[list[str], list[list[str]]]:
    """Return the best combinations of parts."""
    judge = of.judge(of.objective)
    others = list(found[0].others)
    heads = ["", "club", "ball", "setting", "changes", heading(judge), "against\nthe best"]
    heads += [heading(of.judge(name)) for name in others]
    rows = []
    for number, each in enumerate(found[:SHOWN], 1):
        behind = f"{signed(each.value - found[0].value, judge)} ± {written_error(each.error, judge)}"
        rows.append(
            [
                str(number),
                each.club,
                each.ball,
                each.setting,
                told(each.changes),
                written(each.value, judge),
                behind if number > 1 else "",
            ]
            + [written(each.others[name], of.judge(name)) for name in others]
        )
    return heads, rows


def document(of: Fitting, found: list[Combination]) -> dict[str, Any]:
    """Return a fitting as JSON has it, in SI units, all combinations from the best to the worst."""
    return {"title": of.title, "objective": of.objective, "combinations": [each._asdict() for each in found]}


def advice(of: Fitting, found: list[Combination]) -> list[str]:
    """Return what a fitting comes to, in sentences for the golfer."""
    best, judge = found[0], of.judge(of.objective)

    unit = "" if judge.unit == "1" else f" {judge.unit}"
    said = [
        f"Of {len(found)} combinations the best is {named(best)}: "
        f"the {judge.meaning} is {written(best.value, judge)}{unit}."
    ]
    if len(found) > 1:
        behind = written(abs(found[1].value - best.value), judge)
        if math.isnan(found[1].error):
            sure = "how sure that is cannot be told, since other shots miss its face"
        elif abs(found[1].value - best.value) > CERTAIN * found[1].error:
            little = judge.unit == "yd" and abs(units.from_si(found[1].value - best.value, "yd")) < FELT
            sure = "that is more than chance leaves open"
            sure += ", but less than a golfer notices" * little
        else:
            sure = "that is not clearly worse: more shots, or trying both, would tell"
        said.append(f"Next comes {named(found[1])}, {behind}{unit} behind; {sure}.")
    now = as_it_is(of)[judge.name]
    if not math.isnan(now):
        ball = "the same ball" if of.balls[0] is None else f"the ball {of.balls[0].name}"
        said.append(f"With {of.clubs[0].name} as it is now and {ball} it is {written(now, judge)}{unit}.")
    return said


def notes(of: Fitting, found: list[Combination]) -> list[str]:
    """Return what a reader should know about a fitting."""
    several = len(of.golfers) > 1
    each, who = (
        (f" of each of {len(of.golfers)} golfers", "who deliver") if several else (" of the golfer", "who delivers")
    )
    said = [
        f"{len(found)} combinations, all judged on the same {of.shots} shots{each}, {who} every club like"
        f" {of.clubs[0].name}, with more dynamic loft where the club has more loft.",
    ]
    if any(math.isnan(each.error) for each in found):
        said.append("After ± stands ? where other shots miss the face than with the best club.")
    close = sum(abs(each.value - found[0].value) <= CERTAIN * each.error for each in found[1:])
    if close:
        said.append(f"Not clearly behind the best: {close} of the others.")
    if ends := [name for name, limits in of.bounds.items() if at_an_end(found[0].changes.get(name), limits)]:
        said.append(f"The best is at an end of the range of {' and '.join(ends)}; a wider range may give a better one.")
    if len(found) > SHOWN:
        said.append(f"{len(found) - SHOWN} more are not shown; --output and --json have all.")
    return said
