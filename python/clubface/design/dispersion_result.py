"""Tables, notes and picture of a dispersion: where the shots go and what spreads them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from clubface.design.golfer import golfer_sources, variable_label
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.simulation.launch import assumptions_of
from clubface.simulation.provenance import flight_conditions, provenance_of

if TYPE_CHECKING:
    from clubface.design.dispersion import Dispersion
    from clubface.design.variance import ByDerivatives, Indices

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""Quantiles listed."""
MARKED = (0.1, 0.5, 0.9)
"""Quantiles marked by lines in a histogram."""
BINS = {"ball_speed": 0.22352, "launch": np.radians(0.25), "carry": 1.8288, "side": 1.8288}
"""Widths of the bars of a histogram [SI]: half a mph, a quarter of a degree, two yards."""
MOST_BARS = 6
"""Maximum number of variables drawn as bars: those with the largest shares."""


def dispersion_result(
    dispersion: Dispersion, slopes: ByDerivatives | None = None, shares: Indices | None = None
) -> Result:
    """Return a dispersion as a result, optionally with the spread by derivatives and shares of the variance."""
    golfer = dispersion.golfer
    title = (
        f"{golfer.title or golfer.name}: {dispersion.count} shot{'s' * (dispersion.count > 1)}, club "
        f"{dispersion.club.name}, ball {dispersion.ball.name}, by {dispersion.model}"
    )
    tables = [_quantities(dispersion, slopes)]
    if dispersion.points.size:
        tables.append(_ellipses(dispersion))
    if dispersion.hole is not None:
        tables.append(_strokes(dispersion))
    if shares is not None:
        tables.append(_shares(shares))
    inputs = {"golfer": golfer.title or golfer.name, "shots": str(dispersion.count), "seed": str(dispersion.seed)}
    if dispersion.hole is not None:
        inputs["hole"] = dispersion.hole.describe()
    if dispersion.points.size:
        inputs |= flight_conditions(**dispersion.conditions)
    return Result(
        kind="dispersion", title=title, tables=tuple(tables),
        values=(
            text("shots", [dispersion.count], printed=False), text("lost", [dispersion.lost], printed=False),
            text("seed", [dispersion.seed], printed=False),
        ),
        assumptions=assumptions_of([dispersion.mean_launch]),
        summary=tuple(_summary(dispersion, shares)), notes=tuple(_notes(dispersion, slopes, shares)),
        provenance=provenance_of([dispersion.mean_launch], inputs, golfer_sources(golfer)),
        draw=lambda: [dispersion_picture(dispersion, shares)],
    )  # fmt: skip


def _quantities(dispersion: Dispersion, slopes: ByDerivatives | None) -> Table:
    names, kinds = dispersion.quantities, [quantity(name) for name in dispersion.quantities]
    columns = [
        *row_names("quantity", names, [each.label for each in kinds]),
        Column("mean", [dispersion.mean(name) for name in names], kinds),
        Column("spread", [dispersion.spread(name) for name in names], kinds, "±"),
        Column("of_mean_delivery", [dispersion.mean_shot[name] for name in names], kinds, printed=False),
    ]  # fmt: skip
    for share in QUANTILES:
        values = [dispersion.quantile(name, share) for name in names]
        columns.append(Column(f"quantile_{share:g}", values, kinds, f"{share:.0%}"))
    if slopes is not None:
        known = [name if name in slopes.value else None for name in names]
        columns += [
            Column("mean_by_derivatives", [each and slopes.mean(each) for each in known], kinds),
            Column("spread_by_derivatives", [each and slopes.spread(each) for each in known], kinds,
                   "± by derivatives"),
            Column("spread_first_order", [each and slopes.spread(each, order=1) for each in known], kinds,
                   printed=False),
        ]  # fmt: skip
    return Table("quantities", tuple(columns))


def _ellipses(dispersion: Dispersion) -> Table:
    from clubface.design.dispersion import SHARES

    ellipses = [dispersion.ellipse(share) for share in SHARES]
    columns = (
        column("share", SHARES, "1", label="share of landings", unit="%", digits=0),
        column("centre_ahead", [float(each.centre[0]) for each in ellipses], "carry", label="centre ahead"),
        column("centre_right", [float(each.centre[1]) for each in ellipses], "side", label="centre right"),
        column("long_axis", [2.0 * float(each.half_axes[0]) for each in ellipses], "carry"),
        column("short_axis", [2.0 * float(each.half_axes[1]) for each in ellipses], "carry"),
        column("angle", [each.angle for each in ellipses], "rad", label="long axis from the target line"),
    )
    return Table("ellipses", columns, "Landing ellipses")


def _strokes(dispersion: Dispersion) -> Table:
    hole = dispersion.hole
    assert hole is not None
    columns = [
        column("length", [hole.length], "carry", label="length of the hole", digits=0),
        *(column(name, [getattr(hole, name)], "carry", printed=False) for name in ("fairway", "rough", "green")),
        text("lie", [hole.lie], printed=False),
        column("strokes_before", [hole.before()], "1", label=f"strokes from the {hole.lie}"),
        column("strokes_after", [dispersion.strokes], "1"),
        column("strokes_gained", [dispersion.gained], "1", difference=True),
    ]
    for name, share in dispersion.lies.items():
        columns.append(column(f"share_{name}", [share], "1", label=f"at rest, {name}", unit="%", digits=0))
    return Table("strokes", tuple(columns), "Expected strokes of a tour player", layout="list")


def _shares(indices: Indices) -> Table:
    strongest = np.max(list(indices.share.values()), axis=0)
    order = sorted(range(len(indices.variables)), key=lambda place: -strongest[place])
    sobol = indices.kind == "sobol"
    names = [indices.variables[place] for place in order]
    columns = [*row_names("variable", names, [*map(variable_label, names)])]
    for name in indices.share:
        for key, part, label in (
            ("share", indices.share[name], f"{name}, first order" if sobol else name),
            ("total", indices.total[name], f"{name}, total"),
        ):  # fmt: skip
            values = [float(part[place]) for place in order]
            columns.append(
                column(f"{name}_{key}", values, "1", label=label, unit="%", digits=1, printed=sobol or key == "share")
            )
    kind = "Sobol indices" if sobol else "Shapley effects"
    return Table("shares", tuple(columns), f"Sources of the spread: {kind}, % of the variance")


def _summary(dispersion: Dispersion, shares: Indices | None) -> Iterator[Note]:
    low, high = (dispersion.quantile("ball_speed", share) for share in (0.25, 0.75))
    yield note("dispersion-ball-speed", shots=dispersion.count, low_ball_speed=low, high_ball_speed=high)
    if not dispersion.points.size:
        return
    low, high, tenth = (dispersion.quantile("carry", share) for share in (0.25, 0.75, 0.1))
    yield note("dispersion-carry", low_carry=low, high_carry=high, tenth_carry=tenth)
    left, right = (dispersion.quantile("side", share) for share in (0.05, 0.95))
    yield note("dispersion-side", left_side=left, right_side=right)
    if shares is not None:
        for name in ("carry", "side"):
            most = int(np.argmax(np.nan_to_num(parts := shares.share[name])))
            variable = variable_label(shares.variables[most])
            yield note(f"dispersion-{name}-cause", variable=variable, share=float(parts[most]))
    if dispersion.hole is not None:
        yield note("dispersion-strokes", strokes=dispersion.strokes)


def _notes(dispersion: Dispersion, slopes: ByDerivatives | None, shares: Indices | None) -> Iterator[Note]:
    yield note("dispersion-columns")
    if dispersion.lost:
        reasons = "; ".join(dispersion.reasons.values())
        yield note("dispersion-lost", lost=dispersion.lost, share=dispersion.lost / dispersion.count, reasons=reasons)
    if slopes is not None:
        yield note("dispersion-derivatives")
    if dispersion.hole is not None:
        yield note("dispersion-stroke-averages")
    if shares is not None and shares.kind == "shapley":
        yield note("dispersion-shapley")


def dispersion_picture(
    dispersion: Dispersion, shares: Indices | None = None, ellipses: Sequence[float] | None = None
) -> Picture:
    """Return the picture of landings with ellipses, histograms, and shares of the variance.

    Only launches are drawn if no ball flies, and no bars without ``shares``. ``ellipses`` are shares of the landings
    inside; default 50 % and 90 %.
    """
    flies = bool(dispersion.points.size)
    columns: list[list[Panel | None]] = []
    if flies:
        columns.append([_landings(dispersion, ellipses), None])
    counted = ("carry", "side") if flies else ("ball_speed", "launch")
    columns.append([_histogram(dispersion, name) for name in counted])
    if shares is not None:
        bars: list[Panel | None] = [_variance_bars(shares, name) for name in shares.share]
        columns.append([*bars, None][:2])
    return Picture(
        "dispersion", "Landings, and sources of their spread", [list(row) for row in zip(*columns, strict=True)],
        title=f"{dispersion.golfer.title or dispersion.golfer.name}: {dispersion.count} shots by {dispersion.model}",
        legend=True, widths=[1.25, 1.0, 1.0][: len(columns)], height=4.6,
        footnote=f"Dashed lines: {', '.join(f'{share:.0%}' for share in MARKED)} of the shots are below.",
    )  # fmt: skip


def _landings(dispersion: Dispersion, ellipses: Sequence[float] | None) -> Panel:
    from clubface.design.dispersion import SHARES

    ahead, right = dispersion.points[:, 0], dispersion.points[:, 1]
    marks = [Mark("points", right, ahead, label="landings", symbol="", size=2.5)]
    turn = np.linspace(0.0, 2.0 * np.pi, 121)
    for place, share in enumerate(SHARES if ellipses is None else ellipses):
        ellipse = dispersion.ellipse(share)
        along, across = ellipse.half_axes[0] * np.cos(turn), ellipse.half_axes[1] * np.sin(turn)
        sine, cosine = np.sin(ellipse.angle), np.cos(ellipse.angle)
        marks.append(
            Mark(
                "line", ellipse.centre[1] + along * sine + across * cosine,
                ellipse.centre[0] + along * cosine - across * sine, style=1, dash=place % 3,
                label=f"{share:.0%} of the landings",
            )
        )  # fmt: skip
    # A few topped shots would stretch the axes.
    low, high = (dispersion.quantile("carry", share) for share in (0.002, 0.999))
    room, wide = 0.2 * (high - low), 1.05 * max(float(np.abs(right).max()), 1.0)
    return Panel(
        [Mark("rule", x=0.0, style=-1), *marks], axis("side", "side, right is positive", limits=(-wide, wide)),
        axis("carry", "ahead", limits=(low - room, high + room)), equal=True, tall=True,
    )  # fmt: skip


def _histogram(dispersion: Dispersion, name: str) -> Panel:
    edges, counts = dispersion.tally.histogram(name, BINS[name])
    low, high = (dispersion.quantile(name, share) for share in (0.001, 0.999))
    room = 0.15 * (high - low)
    marks = [
        Mark("steps", edges, counts / max(dispersion.tally.counted, 1)),
        Mark("rule", x=[dispersion.quantile(name, share) for share in MARKED], style=-2, dash=1),
    ]
    label = "side, right is positive" if name == "side" else ""
    return Panel(
        marks, axis(name, label, limits=(low - room, high + room)), axis(label="share of the shots")
    )  # fmt: skip


def _variance_bars(indices: Indices, name: str) -> Panel:
    order = np.argsort(indices.share[name])[-MOST_BARS:]
    names = [variable_label(indices.variables[place]) for place in order]
    bars = Mark("bars", indices.share[name][order], np.arange(len(order)), style=2)
    return Panel([bars], axis("variance", f"variance of {name}", like="1", unit="%"), axis(names=names))
