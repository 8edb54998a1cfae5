"""A fitting in tables and sentences."""

from __future__ import annotations

import math
from typing import Any

from clubface import units
from clubface.design.optimisation.combination import Combination, named, told
from clubface.design.optimisation.fitting import Fitting
from clubface.design.optimisation.fitting_run import as_it_is
from clubface.design.optimisation.formatting import CERTAIN, at_an_end, heading, signed, written, written_error

SHOWN = 12
"""Combinations of a fitting that are shown; the file of --output has all."""
FELT = 2.0
"""Yards below which a difference is taken to escape a golfer on a range, however certain it is of computed shots. It is
assumed: no measurement was found."""


def table(of: Fitting, found: list[Combination]) -> tuple[list[str], list[list[str]]]:
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
