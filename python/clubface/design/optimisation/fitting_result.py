"""A fitting as a result: the combinations from the best to the worst, what they come to, and their picture."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from clubface.design.optimisation.advice import is_at_an_end
from clubface.design.optimisation.advice_result import (
    advice_lead,
    advice_notes,
    advice_tables,
    gains_panel,
    short_label,
)
from clubface.design.optimisation.fitting import (
    Combination,
    Fitted,
    Fitting,
    describe_changes,
    landings,
    present_landings,
)
from clubface.design.optimisation.optimum_result import landings_panel, study_provenance
from clubface.results.notes import Note, note
from clubface.results.pictures import Picture
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text

SHOWN = 12
"""Combinations that are printed; files have all."""
BARS = 10
"""Most alternatives that are drawn."""


def fitting_result(fitted: Fitted) -> Result:
    """Return a fitting and its combinations, those of the best rank first, as a result."""
    fitting, advice = fitted.fitting, fitted.advice
    count = len(advice.names)
    shown = [row for row in range(count) if row <= SHOWN or row >= count - fitted.others]
    tables = [combinations_table(fitting, fitted), *advice_tables(advice, shown=shown)]
    if fitted.effects:
        tables.append(_effects_table(fitted))
    return Result(
        kind="fitting", title=fitting.title, tables=tuple(tables),
        lead=(*advice_lead(advice), *_parts(fitted)), notes=(*_notes(fitted), *advice_notes(advice)),
        provenance=study_provenance(fitting, fitting.clubs, fitting.balls),
        draw=lambda: _pictures(fitted),
    )  # fmt: skip


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
               "against the best", difference=True),
        Column("error", [each.error for each in combinations], first.quantity, "±"),
        *(Column(judge.name, [each.others[judge.name] for each in combinations], judge.quantity) for judge in others),
    ]  # fmt: skip
    return Table("combinations", tuple(columns), printed=False)


def _effects_table(fitted: Fitted) -> Table:
    kinds = [fitted.fitting.judge(each.objective).quantity for each in fitted.effects]
    columns = (
        text("part", [each.part for each in fitted.effects]),
        text("objective", [each.objective for each in fitted.effects], printed=False),
        text("what counts", [each.label for each in kinds], in_files=False),
        Column("difference", [each.difference for each in fitted.effects], kinds, "greatest difference"),
        Column("error", [each.error for each in fitted.effects], kinds, "±"),
        Column("worth", [fitted.advice.worth[each.objective] for each in fitted.effects], kinds, "worth a change"),
        text("matters", [each.matters for each in fitted.effects]),
    )
    return Table("effects", columns, "Which parts matter, all else being equal")


def _parts(fitted: Fitted) -> Iterator[Note]:
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
        if ends := [name for name, limits in fitting.bounds.items() if is_at_an_end(free[name], limits)]:
            yield note("fitting-at-an-end", names=ends)
    if len(fitted) > SHOWN:
        yield note("fitting-not-shown", hidden=len(fitted) - SHOWN)


def fitting_picture(fitted: Fitted) -> Picture:
    """Return what each alternative gains on the present club; the landings with it where there is no other."""
    advice = fitted.advice
    if len(advice.names) == 1:
        return fitting_landings_picture(fitted)
    rows = min(len(advice.names) - 1, BARS)
    caption = "What each alternative gains on the present club"
    return Picture("fitting", caption, [[gains_panel(advice, BARS)]], height=1.3 + 0.5 * rows)


def fitting_landings_picture(fitted: Fitted) -> Picture:
    """Return where shots land with the present club and with the one that the advice opens with."""
    fitting, leading = fitted.fitting, fitted.leading
    clubs, caption = {"present": present_landings(fitting)}, "Landings with the present club, which is the best one"
    if leading is not None:
        clubs[f"best for {short_label(fitted.advice.objectives[0])}"] = landings(fitting, leading)
        caption = "Landings with the present club and with the best one"
    panel = landings_panel({name: np.concatenate(each, axis=1) for name, each in clubs.items()})
    return Picture("fitting-landings", caption, [[panel]], height=3.2)


def _pictures(fitted: Fitted) -> list[Picture]:
    """Return the pictures of a fitting: two, so that a printed page takes the first beneath the advice."""
    landed = [fitting_landings_picture(fitted)]
    return landed if len(fitted.advice.names) == 1 else [fitting_picture(fitted), *landed]
