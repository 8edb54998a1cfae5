"""The loft that suits a golfer as a result: what to do, the best lofts, and the curve of what loft is worth."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from clubface.design.optimisation.advice import WORTHS, advice_lead, advice_notes, advice_tables, short_label
from clubface.design.optimisation.result import study_provenance
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text

if TYPE_CHECKING:
    from clubface.design.loft_fit import LoftFit


def loft_fit_result(fitted: LoftFit) -> Result:
    """Return the best lofts, the advice and the curve as a result."""
    study, advice = fitted.optimum.study, fitted.advice
    lofts = [fitted.present, *(fitted.loft(club) for club in list(fitted.optimum.compared.values())[1:])]
    tables = advice_tables(advice, [column("loft", lofts, "loft", label="dynamic loft")])
    return Result(
        kind="loft-fit", title=f"{study.title}, {study.club.name}",
        tables=(_lofts_table(fitted), *tables, _curve_table(fitted)),
        lead=(*advice_lead(advice), *_flat(fitted)), notes=(note("best-loft-delivered"), *advice_notes(advice)),
        provenance=study_provenance(study, [study.club]), draw=lambda: [loft_fit_picture(fitted)],
    )  # fmt: skip


def _lofts_table(fitted: LoftFit) -> Table:
    judges = fitted.objectives
    flat = [fitted.flat(each.name) for each in judges]
    columns = (
        text("objective", [each.name for each in judges], printed=False),
        text("what counts", [each.quantity.label for each in judges], in_files=False),
        column("loft", [fitted.best(each.name) for each in judges], "loft", label="best loft"),
        column("flat_from_loft", [low for low, _ in flat], "loft", label="flat from"),
        column("flat_to_loft", [high for _, high in flat], "loft", label="to"),
        Column("worth", [fitted.advice.worth[each.name] for each in judges], [each.quantity for each in judges],
               "within"),
    )  # fmt: skip
    return Table("lofts", columns, "Dynamic loft, by what counts")


def _flat(fitted: LoftFit) -> Iterator[Note]:
    judge = fitted.objectives[0]
    low, high = fitted.flat(judge.name)
    yield note(
        "best-loft-flat", label=short_label(judge), best_loft=fitted.best(judge.name), low_loft=low, high_loft=high,
        worth=judge.show(fitted.advice.worth[judge.name]),
    )  # fmt: skip
    advice = fitted.advice
    if beyond := [short_label(each) for each in fitted.objectives if advice.best(each.name) in advice.at_an_end]:
        ends = float(fitted.lofts[0]), float(fitted.lofts[-1])
        yield note("best-loft-at-an-end", labels=beyond, low_loft=ends[0], high_loft=ends[1])


def _curve_table(fitted: LoftFit) -> Table:
    columns = (
        column("loft", fitted.lofts, "loft"),
        *(Column(judge.name, [float(each) for each in fitted.values[:, place]], judge.quantity)
          for place, judge in enumerate(fitted.objectives)),
    )  # fmt: skip
    return Table("curve", columns, "What loft is worth", printed=False)


def loft_fit_picture(fitted: LoftFit) -> Picture:
    """Return what each loft gains on the present one by each objective, in differences worth a change."""
    marks = [Mark("rule", x=fitted.present, style=-2, dash=1), Mark("rule", y=[-1.0, 0.0, 1.0], style=-1)]
    for style, judge in enumerate(fitted.objectives):
        worth = fitted.advice.worth[judge.name]
        behind = judge.sign * fitted.values[:, style]
        gain = (float(np.interp(fitted.present, fitted.lofts, behind)) - behind) / worth
        marks.append(Mark("line", fitted.lofts, gain, style=style, label=f"{short_label(judge)}, {judge.show(worth)}"))
    panel = Panel(
        marks, axis("loft", quantity("loft").label), Axis(WORTHS, limits=(-4.0, 4.0)),
        "Gain on the present loft (dashed); between -1 and 1 it is not worth a change", legend=True,
    )  # fmt: skip
    return Picture("loft-fit", "What each loft gains on the present one, by what counts", [[panel]], height=3.6)
