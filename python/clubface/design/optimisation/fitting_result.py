"""A fitting as a result: the combinations from the best to the worst, what they come to, and their picture."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Sequence

import numpy as np

from clubface import units
from clubface.design.optimisation.fitting import Combination, Fitting, as_it_is, describe, describe_changes, landings
from clubface.design.optimisation.optimum_result import CERTAIN, landings_panel, study_provenance
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text

SHOWN = 12
"""Combinations that are printed; files have all."""
FELT = 2.0
"""Yards below which a difference is taken to escape a golfer on a range, however certain it is of computed shots. It is
assumed: no measurement was found."""
LANDINGS, BARS = 3, 10
"""The best combinations whose landings are drawn, and that are compared."""
LETTERS = 36
"""Most letters in a line of the name of a combination."""
ERRORS = 2.0
"""Standard errors that a bar of uncertainty reaches: about 19 of 20 differences lie within."""


def fitting_result(fitting: Fitting, combinations: Sequence[Combination]) -> Result:
    """Return a fitting and its combinations, the best first, as a result."""
    return Result(
        kind="fitting", title=fitting.title, tables=(combinations_table(fitting, combinations),),
        summary=tuple(_summary(fitting, combinations)),
        notes=tuple(_notes(fitting, combinations)), provenance=study_provenance(fitting, fitting.clubs, fitting.balls),
        draw=lambda: [fitting_picture(fitting, combinations)],
    )  # fmt: skip


def combinations_table(fitting: Fitting, combinations: Sequence[Combination]) -> Table:
    """Return all combinations as a table."""
    first, *others = (fitting.judge(name) for name in (fitting.objective, *combinations[0].others))
    changes = dict.fromkeys(name for each in combinations for name in each.changes)
    columns = [
        text("place", list(range(1, len(combinations) + 1)), label=""),
        text("club", [each.club for each in combinations]),
        text("ball", [each.ball for each in combinations]),
        text("setting", [each.setting for each in combinations], printed=any(each.setting for each in combinations)),
        text("changes", [describe_changes(each.changes) for each in combinations], in_files=False,
             printed=bool(changes)),
        *(column(f"{name}_change", [each.changes.get(name, 0.0) for each in combinations],
                 "rad" if name in ("loft", "lie") else "m", printed=False) for name in changes),
        Column(first.name, [each.value for each in combinations], first.quantity),
        Column("against_the_best", [each.value - combinations[0].value for each in combinations], first.quantity,
               "against the best", difference=True),
        Column("error", [each.error for each in combinations], first.quantity, "±"),
        *(Column(judge.name, [each.others[judge.name] for each in combinations], judge.quantity) for judge in others),
    ]  # fmt: skip
    return Table("combinations", tuple(columns), shown_rows=range(min(len(combinations), SHOWN)))


def _summary(fitting: Fitting, combinations: Sequence[Combination]) -> Iterator[Note]:
    best, judge = combinations[0], fitting.judge(fitting.objective)
    yield note(
        "fitting-best", combinations=len(combinations), best=describe(best), meaning=judge.meaning,
        value=judge.show(best.value),
    )  # fmt: skip
    if len(combinations) > 1:
        behind = abs(combinations[1].value - best.value)
        if math.isnan(combinations[1].error):
            code = "fitting-error-unknown"
        elif behind <= CERTAIN * combinations[1].error:
            code = "fitting-not-certain"
        else:
            little = judge.unit == "yd" and units.from_si(behind, "yd") < FELT
            code = f"fitting-certain{'-but-small' * little}"
        yield note(code, worse=describe(combinations[1]), behind=judge.show(behind))
    now = as_it_is(fitting)[judge.name]
    if not math.isnan(now):
        ball = "the same ball" if fitting.balls[0] is None else f"the ball {fitting.balls[0].name}"
        yield note("fitting-unchanged", club=fitting.clubs[0].name, ball=ball, value=judge.show(now))


def _notes(fitting: Fitting, combinations: Sequence[Combination]) -> Iterator[Note]:
    yield note(
        "fitting-shots",
        combinations=len(combinations),
        shots=fitting.shots,
        golfers=len(fitting.golfers),
        club=fitting.clubs[0].name,
    )
    if any(math.isnan(each.error) for each in combinations):
        yield note("fitting-errors-missing")
    if close := sum(abs(each.value - combinations[0].value) <= CERTAIN * each.error for each in combinations[1:]):
        yield note("fitting-close", close=close)
    if ends := [
        name for name, limits in fitting.bounds.items() if _is_at_an_end(combinations[0].changes.get(name), limits)
    ]:
        yield note("fitting-at-an-end", names=ends)
    if len(combinations) > SHOWN:
        yield note("fitting-not-shown", hidden=len(combinations) - SHOWN)


def _is_at_an_end(value: float | None, limits: tuple[float, float]) -> bool:
    low, high = limits
    return value is not None and min(value - low, high - value) < 1e-3 * (high - low)


def fitting_picture(fitting: Fitting, combinations: Sequence[Combination]) -> Picture:
    """Return landings and ellipses of the best combinations, and how far behind the best the others are."""
    best = enumerate(combinations[:LANDINGS], 1)
    landed = {f"{rank}": np.concatenate(landings(fitting, each), axis=1) for rank, each in best}
    return Picture(
        "fitting", "Landings with the best parts, and how far behind the others are",
        [[landings_panel(landed), _behind_panel(fitting, combinations[:BARS])]], widths=[1.0, 1.1],
        height=max(3.2, 0.8 + 0.42 * min(len(combinations), BARS)),
    )  # fmt: skip


def _behind_panel(fitting: Fitting, combinations: Sequence[Combination]) -> Panel:
    judge = fitting.judge(fitting.objective)
    behind = np.array([judge.sign * (each.value - combinations[0].value) for each in combinations])
    errors = ERRORS * np.array([each.error for each in combinations])
    rows = np.arange(len(combinations))
    marks = [
        Mark("bars", behind[row : row + 1], rows[row : row + 1], style=row if row < LANDINGS else -1, size=0.6)
        for row in range(len(combinations))
    ]
    known = np.isfinite(errors)
    marks.append(Mark("intervals", behind[known], rows[known], x0=(behind - errors)[known], x1=(behind + errors)[known],
                      symbol="", style=-2))  # fmt: skip
    labels = [_label(place + 1, each) for place, each in enumerate(combinations)]
    low = 1.05 * min(0.0, float(np.nanmin(behind - errors)))
    return Panel(
        marks, Axis(judge.quantity, "behind the best", limits=(low, None)),
        axis(names=labels, reversed=True, limits=(len(combinations) - 0.4, -0.6)),
        textwrap.fill(f"By the {judge.meaning}", LETTERS),
    )  # fmt: skip


def _label(number: int, combination: Combination) -> str:
    parts = textwrap.wrap(
        ", ".join(each for each in (combination.club, combination.ball, combination.setting) if each), LETTERS
    )
    changes = textwrap.wrap(describe_changes(combination.changes), LETTERS)
    return "\n".join([f"{number}: {parts[0]}", *parts[1:], *changes])
