"""Advice in sentences, tables and a panel, the same for every command that advises a golfer."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from clubface.design.optimisation.advice import (
    ALIKE,
    ASSUMED_HOLE,
    BETTER,
    CERTAIN,
    DRIVES,
    OPEN,
    WORSE,
    Advice,
)
from clubface.design.optimisation.landings import Objective
from clubface.quantities import Quantity, Reading
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, axis
from clubface.results.table import Column, Table, text

_SHORT = {
    "carry": "carry", "total": "total distance", "side_spread": "spread to the side", "ellipse": "ellipse",
    "strokes": "strokes",
}  # fmt: skip
_LETTERS = 36
"""Most letters in a line of the name of an alternative in a picture."""
WORTHS = Quantity("worth", "1", Reading("1", 1), Reading("1", 1), "gain, in differences worth a change")


def short_label(judge: Objective) -> str:
    """Return what an objective counts, in sentences: "spread to the side"."""
    return _SHORT[judge.name]


def advice_lead(advice: Advice) -> Iterator[Note]:
    """Yield what to do in one sentence, what it is for, and what holds under other objectives."""
    yield _opening(advice)
    chosen = advice.recommended()
    states = advice.states(chosen)
    yield note("advice-purpose", meaning=advice.objectives[0].meaning, conditions=advice.conditions)
    level = [place for place in advice.as_good(advice.purpose, chosen) if place != chosen]
    if chosen and level:
        judge = advice.objectives[0]
        others = [
            f"{advice.names[place]} (better by {_amount(judge, advice.gain(judge.name, place))})" for place in level
        ]
        yield note("advice-as-good", label=short_label(judge), others=others)
    if losses := losses_in_words(advice, advice.purpose, chosen):
        yield note("advice-costs", best=advice.names[chosen], losses=losses)
    elif chosen and all(state in (BETTER, ALIKE) for state in states.values()):
        yield note("advice-holds", best=advice.names[chosen], present=advice.names[0], labels=_labels(advice))
    if len({advice.best(each.name) for each in advice.objectives}) > 1:
        yield note("advice-by-objective", wishes=[_wish(advice, each) for each in advice.objectives])


def _opening(advice: Advice) -> Note:
    """Return what to do, in one sentence."""
    judge, chosen = advice.objectives[0], advice.recommended()
    best = chosen or advice.best(judge.name)
    gain, error = (judge.show(each) for each in (advice.gain(judge.name, best), advice.error(judge.name, best)))
    common = {"present": advice.names[0], "golfer": advice.golfer, "label": short_label(judge)}
    if chosen:
        before, after = (judge.show(float(advice.values[place, 0])) for place in (0, chosen))
        data = {**common, "best": advice.names[chosen], "gain": gain, "error": error, "before": before, "after": after}
        if judge.name != "strokes":
            return note("advice-change", **data)
        return note("advice-change-strokes", **data, drives=DRIVES, round=DRIVES * advice.gain(judge.name, chosen))
    if best and advice.state(judge.name, best) == OPEN:
        return note("advice-not-certain", **common, best=advice.names[best], gain=gain, error=error)
    others = range(1, len(advice.names))
    if not any(state in (BETTER, OPEN) for place in others for state in advice.states(place).values()):
        return note("advice-keep-all", **common, alternatives=len(others), labels=_labels(advice))
    worth = judge.show(advice.worth[judge.name])
    return note("advice-keep", **common, worth=worth, most=gain)


def _labels(advice: Advice) -> list[str]:
    return [short_label(each) for each in advice.objectives]


def _wish(advice: Advice, judge: Objective) -> str:
    best = advice.best(judge.name)
    if not best:
        return f"{short_label(judge)}, the {advice.names[0]}"
    gain = _amount(judge, advice.gain(judge.name, best))
    state = advice.state(judge.name, best)
    enough = {BETTER: "worth a change", OPEN: "not certain"}.get(state, "not worth a change")
    price = losses_in_words(advice, judge.name, best)
    if state == BETTER and price:
        enough += f" only if nothing else counts: it costs {', '.join(price)}"
    if best in advice.at_an_end:
        enough += "; at an end of what was tried, and so no optimum"
    return f"{short_label(judge)}, {advice.names[best]} (better by {gain}, {enough})"


def losses_in_words(advice: Advice, name: str, alternative: int) -> list[str]:
    """Return in words what an alternative costs by the other objectives."""
    judges = {each.name: each for each in advice.objectives}
    losses = advice.losses(name, alternative)
    return [
        _amount(judges[each], loss) + (f" of {short_label(judges[each])}" if each != "strokes" else "")
        for each, loss in losses.items()
    ]


def _amount(judge: Objective, value: float) -> str:
    """Return a value with its unit in a sentence: "0.0220 strokes"."""
    return judge.show(value) + (" strokes" if judge.name == "strokes" else "")


def advice_notes(advice: Advice) -> Iterator[Note]:
    """Yield what is to be known about the tables."""
    sizes = [f"{short_label(each)} {each.show(advice.worth[each.name])}" for each in advice.objectives]
    yield note("advice-worth", sizes=sizes)
    yield note("advice-errors" if advice.sets.std(axis=1).any() else "advice-single-delivery")
    if advice.sets.std(axis=1).any():
        yield note("advice-mishits")
    if advice.assumed_hole:
        yield note("advice-hole-assumed", hole=ASSUMED_HOLE.describe())


def advice_tables(
    advice: Advice, fields: Sequence[Column] = (), shown: Sequence[int] | None = None
) -> tuple[Table, Table, Table]:
    """Return what to do by objective, the alternatives with all objectives, and what separates them.

    Parameters
    ----------
    fields
        Further columns of the alternatives, such as their lofts.
    shown
        Which alternatives people see; None for all.
    """
    shown = range(len(advice.names)) if shown is None else shown
    return _by_objective(advice), _alternatives(advice, fields, shown), _differences(advice, shown)


def _by_objective(advice: Advice) -> Table:
    """Return for each objective which alternative is best by it, by how much, if that is worth a change, and its price.

    They are those of the sentence on what each objective alone would choose.
    """
    judges = advice.objectives
    kinds = [each.quantity for each in judges]
    pairs = [(each.name, advice.best(each.name)) for each in judges]
    words = [{BETTER: "change", OPEN: "not certain"}.get(advice.state(*pair), "keep") for pair in pairs]
    prices = [", ".join(losses_in_words(advice, *pair)) for pair in pairs]
    columns = (
        text("objective", [each.name for each in judges], printed=False),
        text("what counts", [each.label for each in kinds], in_files=False),
        text("advice", words, label="alone"),
        Column("present", [float(each) for each in advice.values[0]], kinds),
        Column("gain", [advice.gain(*pair) for pair in pairs], kinds, "to gain", difference=True),
        Column("error", [advice.error(*pair) for pair in pairs], kinds, "±"),
        Column("worth", [advice.worth[each.name] for each in judges], kinds, "worth a change"),
        text("best", [advice.names[place] for _, place in pairs], label="with"),
        text("price", prices, label="at the price of", printed=any(prices)),
    )
    return Table("advice", columns, "What each objective alone would choose")


def _alternatives(advice: Advice, fields: Sequence[Column], shown: Sequence[int]) -> Table:
    every = range(len(advice.names))
    ranks = advice.ranks(every)
    columns = (
        text("alternative", advice.names),
        text("place", [ranks[place] for place in every]),
        *fields,
        *(Column(judge.name, [float(each) for each in advice.values[:, column]], judge.quantity)
          for column, judge in enumerate(advice.objectives)),
    )  # fmt: skip
    title = f"Alternatives; those of one place do not differ in {short_label(advice.objectives[0])}"
    return Table("alternatives", columns, title, shown_rows=shown)


def _differences(advice: Advice, shown: Sequence[int]) -> Table:
    every = range(1, len(advice.names))
    columns = [text("alternative", advice.names[1:])]
    for place, judge in enumerate(advice.objectives):
        changes = [float(advice.values[row, place] - advice.values[0, place]) for row in every]
        errors = [advice.error(judge.name, row) for row in every]
        columns += [
            Column(f"{judge.name}_difference", changes, judge.quantity, judge.quantity.label, difference=True),
            Column(f"{judge.name}_error", errors, judge.quantity, "±"),
            text(f"{judge.name}_verdict", [advice.state(judge.name, row) for row in every], printed=False),
        ]
    columns.append(text("verdict", [_verdict(advice, row) for row in every], in_files=False))
    rows = [row - 1 for row in shown if row]
    return Table("differences", tuple(columns), f"Differences from the {advice.names[0]}", shown_rows=rows)


def _verdict(advice: Advice, alternative: int) -> str:
    """Return in words by which objectives an alternative is better or worse than the present one."""
    states = advice.states(alternative)
    by_state: Mapping[str, list[str]] = {
        state: [short_label(each) for each in advice.objectives if states[each.name] == state]
        for state in (BETTER, WORSE, OPEN)
    }
    parts = [f"{state}: {', '.join(labels)}" for state, labels in by_state.items() if labels]
    return "; ".join(parts) or "no difference worth a change"


def gains_panel(advice: Advice, rows: int) -> Panel:
    """Return what the first alternatives gain on the present one by each objective, in differences worth a change."""
    places = range(1, min(rows, len(advice.names) - 1) + 1)
    marks = [Mark("shade", x0=-1.0, x1=1.0, style=-1), Mark("rule", x=0.0, style=-1)]
    away = 0.6 * (np.arange(len(advice.objectives)) / max(len(advice.objectives) - 1, 1) - 0.5)
    for style, (judge, below) in enumerate(zip(advice.objectives, away, strict=True)):
        worth = advice.worth[judge.name]
        gains = np.array([advice.gain(judge.name, place) for place in places]) / worth
        errors = CERTAIN * np.nan_to_num([advice.error(judge.name, place) for place in places]) / worth
        marks.append(Mark(
            "intervals", gains, np.array(places) - 1 + below, x0=gains - errors, x1=gains + errors, style=style,
            label=f"{short_label(judge)}, {judge.show(worth)}",
        ))  # fmt: skip
    names = ["\n".join(textwrap.wrap(advice.names[place], _LETTERS)) for place in places]
    return Panel(
        marks, Axis(WORTHS), axis(names=names, reversed=True, limits=(len(places) - 0.4, -0.6)),
        f"Gain on the {advice.names[0]}; within the grey it is not worth a change", legend=True,
    )  # fmt: skip
