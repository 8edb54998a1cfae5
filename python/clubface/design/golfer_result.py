"""Tables, notes and pictures of golfers: deliveries, sources of the figures, and the sensitivity to them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.design.golfer import Golfer, golfer_sources, is_assumed, to_toml
from clubface.equipment.clubs import Club
from clubface.quantities import Quantity, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.simulation.impact import impact
from clubface.simulation.provenance import flight_conditions, provenance_of

if TYPE_CHECKING:
    from clubface.design.golfer_estimate import Estimate, SpreadSensitivity

WEAK = 0.2
"""Correlations below this are counted but not printed: a few dozen shots give them by chance."""
MOST_BARS = 8
"""Maximum number of figures drawn: those that change the landings most."""


def golfers_result(golfers: Sequence[Golfer]) -> Result:
    """Return a list of golfers as a result."""
    columns = (
        text("name", [each.name for each in golfers], label="golfer"),
        text("title", [each.title for each in golfers], printed=False),
        text("club", [each.club for each in golfers], printed=False),
        column("mean_speed", [_moment(each, "mean", "speed") for each in golfers], label="club speed", digits=0),
        column("spread_speed", [_moment(each, "spread", "speed") for each in golfers], label="±"),
        column("spread_face", [_moment(each, "spread", "face") for each in golfers], label="face ±"),
        column("mishits", [each.mishit_share for each in golfers], "1", unit="%", digits=0),
    )
    return Result("golfers", "Golfers", (Table("golfers", columns),), notes=(note("golfer-list"),))


def golfer_result(
    golfer: Golfer, club: Club | None = None, estimate: Estimate | None = None, doubts: SpreadSensitivity | None = None
) -> Result:
    """Return a golfer as a result, with the shots behind an estimate and the sensitivity to each figure, if given."""
    launches = [] if club is None else [impact(club, golfer.for_hand(club.hand).delivery())]
    inputs = {"golfer": golfer.title or golfer.name, "hand": "right" if golfer.hand > 0 else "left"}
    if doubts is not None:
        inputs |= {"shots of each change": str(doubts.shots), "seed": "0", **flight_conditions()}
    title = f"{golfer.title or golfer.name} ({golfer.club})"
    tables = [_delivery_table(golfer, estimate), *_correlation_tables(golfer)]
    if doubts is not None and doubts.figures:
        tables.append(_doubt_table(doubts))
    values = [
        text("name", [golfer.name], printed=False), text("title", [golfer.title], printed=False),
        text("club", [golfer.club], printed=False),
        text("hand", ["right" if golfer.hand > 0 else "left"], printed=False),
        text("mishit_share", [golfer.mishit_share], printed=False),
        text("mishit_scale", [golfer.mishit_scale], printed=False),
    ]  # fmt: skip
    if estimate is not None:
        title = f"{title}, {estimate.shots} shots"
        values += [
            text("shots", [estimate.shots], printed=False), text("shrinkage", [estimate.shrinkage], printed=False),
            text("like", [estimate.like], printed=False),
        ]  # fmt: skip
    provenance = provenance_of(launches, inputs, golfer_sources(golfer))
    return Result(
        kind="golfer", title=title, values=tuple(values), tables=tuple(tables),
        summary=tuple(_summary(golfer, estimate, doubts)), notes=tuple(_notes(golfer, estimate)),
        provenance=provenance + Provenance(descriptions={f"{golfer.name}.toml": to_toml(golfer)}),
        draw=None if doubts is None or not doubts.figures else lambda: [doubts_picture(doubts)],
    )  # fmt: skip


def _moment(golfer: Golfer, part: str, name: str) -> float | None:
    return float(getattr(golfer, part)[golfer.variables.index(name)]) if name in golfer.variables else None


def _quantity_with_digits(name: str) -> Quantity:
    """Return the quantity of a variable, with an extra digit for speeds and angles."""
    kind = quantity(name)
    return kind._replace(golf=kind.golf._replace(digits=2)) if kind.golf.unit in ("mph", "deg") else kind


def _delivery_table(golfer: Golfer, estimate: Estimate | None) -> Table:
    kinds = [_quantity_with_digits(name) for name in golfer.variables]
    columns = [
        *row_names("variable", golfer.variables, [each.label for each in kinds]),
        Column("mean", golfer.mean.tolist(), kinds), Column("spread", golfer.spread.tolist(), kinds, "±"),
    ]  # fmt: skip
    if estimate is not None:
        error, drift = (
            dict(zip(estimate.measured, map(float, each), strict=True)) for each in (estimate.error, estimate.drift)
        )
        columns += [
            Column("error_of_spread", [error.get(name) for name in golfer.variables], kinds, "error of ±"),
            column("drift", [drift.get(name) for name in golfer.variables], "1", digits=2),
        ]
    return Table("delivery", tuple(columns))


def _correlation_tables(golfer: Golfer) -> list[Table]:
    pairs = [(one, other) for one, other in np.argwhere(np.tril(golfer.covariance, -1)).tolist()]
    if not pairs:
        return []
    pairs.sort(key=lambda pair: -abs(golfer.correlation[pair]))
    columns = (
        text("one", [golfer.variables[one] for one, _ in pairs]),
        text("other", [golfer.variables[other] for _, other in pairs]),
        column("correlation", [float(golfer.correlation[pair]) for pair in pairs], "1", digits=2, difference=True),
        text("covariance", [float(golfer.covariance[pair]) for pair in pairs], printed=False),
    )  # fmt: skip
    strong = [place for place, pair in enumerate(pairs) if abs(golfer.correlation[pair]) >= WEAK]
    return [Table("correlations", columns, "Correlations", printed=bool(strong), shown_rows=strong)]


def _doubt_table(doubts: SpreadSensitivity) -> Table:
    columns = [
        text("figure", [each.figure.replace("_", " ") for each in doubts.figures]),
        text("assumed", [each.assumed for each in doubts.figures]),
    ]
    for name, now in doubts.spread.items():
        for place, way in enumerate(("smaller", "larger")):
            changes = [doubts.changes(each, name)[place] for each in doubts.figures]
            columns += [
                column(f"{name}_change_{way}", changes, "1", label=f"{name} {way}", unit="%", digits=1,
                       difference=True),
                column(f"{name}_spread_{way}", [each.spread[name][place] for each in doubts.figures], "m",
                       printed=False),
            ]  # fmt: skip
        columns.append(column(f"{name}_spread", [now] * len(doubts.figures), "m", printed=False))
    return Table("doubts", tuple(columns), f"Change of landing spread if a figure is {doubts.off:.0%} off")


def _summary(golfer: Golfer, estimate: Estimate | None, doubts: SpreadSensitivity | None) -> Iterator[Note]:
    if estimate is not None:
        yield note("golfer-shots", shots=estimate.shots)
    yield note("golfer-speed", speed=_moment(golfer, "mean", "speed"))
    for name in ("speed", "face"):
        if spread := _moment(golfer, "spread", name):
            yield note(f"golfer-{name}-spread", **{f"spread_{name}": spread})
    if golfer.mishit_share > 0.0:
        yield note("golfer-mishit-share", percent=100.0 * golfer.mishit_share, scale=golfer.mishit_scale)
    varies = [name for name, spread in zip(golfer.variables, golfer.spread, strict=True) if spread > 0.0]
    sourced = [name for name in varies if not is_assumed(golfer, f"spread of {name}")]
    if not sourced:
        yield note("golfer-all-assumed")
    else:
        yield note("golfer-sourced", names=sourced)
        if len(sourced) < len(varies):
            yield note("golfer-rest-assumed")
    if doubts is not None and doubts.figures:
        for name in doubts.spread:
            most = max(doubts.figures, key=lambda each, name=name: each.spread[name][1])
            more = doubts.changes(most, name)[1]
            yield note(
                f"golfer-doubt-{name}", figure=most.figure.replace("_", " "), off=doubts.off, more=more,
                state="assumed" if most.assumed else "sourced", spread_carry=doubts.spread[name],
            )  # fmt: skip


def _notes(golfer: Golfer, estimate: Estimate | None) -> Iterator[Note]:
    yield note("golfer-spread")
    if estimate is not None:
        yield note("golfer-error")
        yield note("golfer-drift", chance=0.5 / estimate.shots**0.5)
    size = np.abs(golfer.correlation[np.tril_indices(len(golfer.variables), -1)])
    if weak := int(((size >= 0.005) & (size < WEAK)).sum()):
        yield note("golfer-weak-correlations", weak=weak, limit=WEAK)
    if golfer.mishit_share > 0.0:
        yield note("golfer-mishits", percent=100.0 * golfer.mishit_share, scale=golfer.mishit_scale)
    if estimate is not None:
        yield from estimate.notes
        return
    for source, figures in golfer.figures_by_source().items():
        yield note("golfer-source", figures=figures, source=source)


def doubts_picture(doubts: SpreadSensitivity) -> Picture:
    """Return bars of the change in spread of the landings if a figure is off; assumed figures are faint."""
    figures = doubts.figures[:MOST_BARS]
    names = [each.figure.replace("_", " ") for each in figures]
    panels: list[Panel | None] = []
    for name, title in (("carry", "Carry"), ("side", "Side")):
        marks = [Mark("rule", x=0.0, style=-2)]
        for way, style, place in (("smaller", 6, 0), ("larger", 1, 1)):
            for assumed in (False, True):
                rows = [row for row, each in enumerate(figures) if each.assumed == assumed]
                change: list[Any] = [doubts.changes(figures[row], name)[place] for row in rows]
                label = f"{doubts.off:.0%} {way}{', assumed' * assumed}"
                if rows:
                    marks.append(
                        Mark("bars", np.array(change), np.array(rows), style=style, faint=assumed, label=label)
                    )
        y = axis(names=names, reversed=True) if not panels else axis(reversed=True, ticks=False)
        panels.append(Panel(marks, axis("change", f"change of the spread of {name}", like="1", unit="%"), y, title))
    return Picture(
        "doubts", f"Change of the landing spread if a figure is {doubts.off:.0%} smaller or larger",
        [panels], height=1.2 + 0.27 * len(figures), legend=True,
    )  # fmt: skip
