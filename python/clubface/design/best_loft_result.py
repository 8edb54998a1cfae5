"""Best lofts as results: by club speed and attack angle, or with those of a published chart."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from clubface import published_data
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.provenance import flight_conditions, provenance_of

if TYPE_CHECKING:
    from clubface.design.best_loft import BestLoft, ChartComparison

SHOWN = {"loft": "loft", "ball_speed": "ball_speed", "launch": "launch", "spin": "total_spin", "carry": "carry"}
"""Columns that are printed, and what they are of."""
_SAME_ANGLE = 9e-4
"""Attack angles below this are level [rad]."""


def best_loft_result(best_loft: BestLoft) -> Result:
    """Return best lofts as a result."""
    columns = (*_cases(best_loft), *(_own(best_loft, name) for name in SHOWN), *_other(best_loft))
    title = f"Best dynamic loft for carry: {best_loft.flown.club.name}, {best_loft.flown.model}"
    return Result(
        kind="best-loft", title=title, tables=(Table("best_lofts", columns),),
        summary=(*_summary(best_loft), note("best-loft-delivered")),
        notes=(note("best-loft-within", worth_carry=best_loft.worth), note("best-loft-carry")),
        provenance=provenance_of([best_loft.flown], flight_conditions(best_loft.air, best_loft.wind)),
        draw=lambda: [best_loft_picture(best_loft)],
    )  # fmt: skip


def chart_result(comparison: ChartComparison) -> Result:
    """Return best lofts with those of a published chart as a result."""
    best, chart = comparison.best, comparison.chart
    columns = _cases(best)
    for name in comparison.compared:
        columns += [
            _own(best, name),
            column(f"published_{name}", comparison.column(name), SHOWN[name], label=chart),
        ]
    columns += [_own(best, name, printed=False) for name in SHOWN if name not in comparison.compared]
    columns += _other(best, printed=False)
    published = {comparison.quantity(name): name for name in comparison.published}
    columns += [
        column(f"published_{name}", comparison.published[key], SHOWN.get(name, name), printed=False)
        for name, key in published.items()
        if name not in comparison.compared
    ]
    kinds = [quantity(SHOWN[name]) for name in comparison.compared]
    away = [getattr(best, name) - comparison.column(name) for name in comparison.compared]
    differences = (
        text("quantity", comparison.compared, printed=False),
        text("what", [each.label for each in kinds], in_files=False),
        *(Column(word, [float(pick(each)) for each in away], kinds, difference=True)
          for word, pick in (("mean", np.mean), ("least", np.min), ("greatest", np.max))),
    )  # fmt: skip
    launch = "best-loft-launch-difference" if comparison.compared[0] == "launch" else "best-loft-loft-difference"
    source = published_data.table(comparison.table).source
    return Result(
        kind="best-loft", title=f"Best dynamic loft for carry and the chart of {chart}: {best.flown.club.name}, "
        f"{best.flown.model}",
        tables=(
            Table("best_lofts", tuple(columns)), Table("differences", differences, "Best less published"),
        ),
        summary=(
            *_summary(best), note("best-loft-delivered"), note(launch, chart=chart, loft=float(np.mean(away[0]))),
        ),
        provenance=provenance_of(
            [best.flown], flight_conditions(best.air, best.wind), [f"Chart of {chart}: {source}"]
        ),
        draw=lambda: [chart_picture(comparison)],
    )  # fmt: skip


def _cases(best_loft: BestLoft) -> list[Column]:
    return [column("speed", best_loft.speed, digits=1), column("attack", best_loft.attack)]


def _own(best_loft: BestLoft, name: str, *, printed: bool = True) -> Column:
    label = "best loft" if name == "loft" else ""
    return column(
        name, getattr(best_loft, name), SHOWN[name], label=label or quantity(SHOWN[name]).label, printed=printed
    )


def _other(best_loft: BestLoft, *, printed: bool = True) -> list[Column]:
    return [
        column("total", best_loft.total, printed=False),
        column("within_below", best_loft.within[:, 0], "loft", label="as good with less", printed=printed),
        column("within_above", best_loft.within[:, 1], "loft", label="or more", printed=printed),
    ]


def _summary(best_loft: BestLoft) -> Iterator[Note]:
    """Yield the best loft of the slowest and the fastest club that moves most nearly level."""
    level = abs(best_loft.attack) == abs(best_loft.attack).min()
    for speed in sorted({float(best_loft.speed[level].min()), float(best_loft.speed[level].max())}):
        place = int((level & (best_loft.speed == speed)).argmax())
        attack = float(best_loft.attack[place])
        less, more = map(float, best_loft.within[place])
        yield note(
            "best-loft-level" if abs(attack) < _SAME_ANGLE else "best-loft-inclined", attack=attack, speed=speed,
            loft=float(best_loft.loft[place]), carry=float(best_loft.carry[place]), less_loft=less, more_loft=more,
            worth_carry=best_loft.worth,
        )  # fmt: skip


def best_loft_picture(best_loft: BestLoft) -> Picture:
    """Return loft and carry over the club speed; bars reach as far as a loft is as good."""
    lofts, carries = [], []
    for place, attack in enumerate(np.unique(best_loft.attack)):
        rows = np.flatnonzero(best_loft.attack == attack)
        rows = rows[np.argsort(best_loft.speed[rows], kind="stable")]
        speed, loft, carry = best_loft.speed[rows], best_loft.loft[rows], best_loft.carry[rows]
        label = f"attack {np.degrees(attack) + 0.0:.3g}°"
        lofts += [
            Mark("line", speed, loft, style=place, label=label),
            Mark("intervals", speed, loft, y0=loft - best_loft.within[rows, 0],
                 y1=loft + best_loft.within[rows, 1], style=place, symbol=str(place), label=label),
        ]  # fmt: skip
        carries += [
            Mark("line", speed, carry, style=place, label=label),
            Mark("points", speed, carry, style=place, symbol=str(place), label=label),
        ]
    panels: list[Panel | None] = [
        Panel(lofts, axis("speed"), axis("loft", "best dynamic loft"), "Bars: within them the loft is as good"),
        Panel(carries, axis("speed"), axis("carry"), "How far the ball carries with it"),
    ]
    return Picture("best-loft", "Best loft and its carry over the club speed", [panels], height=3.4, legend=True)


def chart_picture(comparison: ChartComparison) -> Picture:
    """Return the picture of the computed values over those of a chart."""
    panels: list[Panel | None] = []
    for name in comparison.compared:
        theirs, ours = comparison.column(name), getattr(comparison.best, name)
        ends = [min(theirs.min(), ours.min()), max(theirs.max(), ours.max())]
        marks = [Mark("line", ends, ends, style=-1, size=0.8, dash=0), Mark("points", theirs, ours)]
        kind = SHOWN[name]
        panels.append(Panel(marks, axis(kind, comparison.chart), axis(kind, "found here"), quantity(kind).label))
    panels += [None] * (len(panels) % 2)
    rows = [panels[place : place + 2] for place in range(0, len(panels), 2)]
    return Picture(
        "best-loft-chart",
        f"What was found here over what the chart of {comparison.chart} has",
        rows,
        height=2.5 * len(rows),
    )
