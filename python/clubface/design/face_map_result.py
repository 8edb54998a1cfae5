"""Tables and pictures of face maps: extremes, best points, cost of scattered impacts, and contours."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.contributions import QUANTITIES
from clubface.quantities import Quantity, format_number, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.simulation.launch import assumptions_of
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.units import fixed

if TYPE_CHECKING:
    from clubface.design.face_map import FaceMap, Forgiveness, _Mapped as Mapped

LISTED = ("ball_speed", "launch", "backspin", "sidespin", "azimuth", "carry", "side", "total")
"""Quantities listed and drawn by default."""
LEAST_MISSED = 5e-5
"""Share of swings that miss the face above which a note says so."""
OFF_CENTRE = 0.02
"""Distance of the summary's off-centre strikes from the face centre [m]."""
PRINTED_POINTS = (9, 7)
"""Maximum number of points in a printed table, towards the toe and upwards."""
DRAWN_POINTS = 61
"""Maximum number of points along a side used for contours."""


def face_map_result(mapped: Mapped, names: Sequence[str] = (), spreads: Sequence[Forgiveness] = ()) -> Result:
    """Return a map, or the difference of two, as a result; list, draw and tabulate the quantities ``names``."""
    listed, maps = tuple(names) or LISTED, mapped.maps
    clubs = " less ".join(each.centre.club.name for each in maps)
    first = maps[0]
    title = (
        f"{clubs}, ball {first.centre.ball.name}, by {first.centre.model}: "
        f"{len(mapped.toe)} by {len(mapped.high)} points of the face"
    )
    inputs = {"points of the face": f"{len(mapped.toe)} towards the toe, {len(mapped.high)} upwards"}
    tables = [_extremes(mapped, listed), *(_grid_table(mapped, name) for name in names), _best_table(maps)]
    if spreads:
        tables.append(_spread_table(maps, spreads, listed))
        inputs["impacts that scatter"] = _spread_words(spreads[0])
    return Result(
        kind="face-map", title=title, tables=tuple(tables), summary=tuple(_summary(maps)),
        assumptions=assumptions_of(each.centre for each in maps),
        notes=tuple(_notes(maps, spreads)), hints=() if spreads else (note("map-spread-option"),),
        provenance=provenance_of(
            [each.centre for each in maps], {**inputs, **flight_conditions(**first.conditions)}
        ),
        draw=lambda: [face_map_picture(mapped, listed)],
    )  # fmt: skip


def points_table(mapped: Mapped) -> Table:
    """Return a table of every quantity, with one row per point of the face."""
    values, difference = mapped.columns(), len(mapped.maps) > 1
    columns = [column(name, values[name]) for name in ("toe", "high")]
    for name in QUANTITIES:
        columns.append(_value_column(f"difference_{name}" if difference else name, name, values[name], difference))
    return Table("map", tuple(columns), "All points of the face", printed=False, shown_rows=())


def _value_column(name: str, kind: str, values: Any, difference: bool) -> Column:
    return column(name, values, kind, label=quantity(kind).label, difference=difference)


def _quantity_with_digits(name: str, difference: bool) -> Quantity:
    """Return a quantity, with an extra digit for differences."""
    kind = quantity(name)
    return kind._replace(golf=kind.golf._replace(digits=kind.golf.digits + 1)) if difference else kind


def _extremes(mapped: Mapped, names: Sequence[str]) -> Table:
    difference = len(mapped.maps) > 1
    middles = [each.at(0.0, 0.0) for each in mapped.maps]
    centre = [float(middles[0][name] - (middles[1][name] if difference else 0.0)) for name in names]
    ends: dict[str, list[tuple[float | None, float | None, float | None]]] = {"least": [], "greatest": []}
    for name in names:
        values = mapped.get(name)
        for end, pick in zip(ends, (np.nanargmin, np.nanargmax), strict=True):
            if np.isfinite(values).any():
                up, across = np.unravel_index(pick(values), values.shape)
                ends[end].append((float(values[up, across]), float(mapped.toe[across]), float(mapped.high[up])))
            else:
                ends[end].append((None, None, None))
    kinds = [_quantity_with_digits(name, difference) for name in names]
    columns = [
        *row_names("quantity", names, [each.label for each in kinds]),
        Column("centre", centre, kinds, "at the centre", difference=difference),
    ]  # fmt: skip
    for end, rows in ends.items():
        values, toe, high = zip(*rows, strict=True)
        columns += [
            Column(end, values, kinds, difference=difference),
            column(f"{end}_toe", toe, label="toe", digits=0), column(f"{end}_high", high, label="high", digits=0),
        ]  # fmt: skip
    return Table("extremes", tuple(columns))


def _spread_indices(count: int, most: int) -> NDArray[Any]:
    """Return at most ``most`` evenly spread indices of ``count``, including both ends."""
    return np.unique(np.round(np.linspace(0, count - 1, min(most, count))).astype(int))


def _grid_table(mapped: Mapped, name: str) -> Table:
    """Return the table of a quantity over the grid; only a few points are printed, the highest first."""
    difference = len(mapped.maps) > 1
    toe, high = np.meshgrid(mapped.toe, mapped.high[::-1])
    across, up = (
        _spread_indices(len(each), most) for each, most in zip((mapped.toe, mapped.high), PRINTED_POINTS, strict=True)
    )
    rows = (len(mapped.high) - 1 - up[::-1])[:, None] * len(mapped.toe) + across
    columns = (
        text("up", [f"{format_number(1e3 * each, 1)} mm high" for each in high.ravel()], in_files=False),
        text("across", [f"{format_number(1e3 * each, 0)} mm" for each in toe.ravel()], in_files=False),
        _value_column(f"difference_{name}" if difference else name, name, mapped.get(name)[::-1], difference),
        column("toe", toe, printed=False), column("high", high, printed=False),
    )  # fmt: skip
    title = f"{quantity(name).label} by impact point, from heel to toe"
    return Table(f"map_{name}", columns, title, layout="pivot", shown_rows=rows.ravel().tolist())


def _best_table(maps: Sequence[FaceMap]) -> Table:
    speeds, carries = [each.best() for each in maps], [each.best("carry") for each in maps]
    columns = [
        text("club", [each.centre.club.name for each in maps]),
        *(
            text(name, [getattr(each.centre, name).name for each in maps], printed=False)
            for name in ("ball", "parameters")
        ),
        text("model", [each.centre.model for each in maps], printed=False),
        text("outline", [each.outline.origin for each in maps], printed=False),
        text("interpolated", [each.interpolated for each in maps], printed=False),
    ]
    for what, label, points, name in (
        ("sweet_spot", "sweet spot", speeds, "ball_speed"), ("longest", "longest carry", carries, "carry"),
    ):  # fmt: skip
        columns += [
            column(f"{what}_toe", [each.toe for each in points], "toe", label=f"{label}, towards the toe"),
            column(f"{what}_high", [each.high for each in points], "high", label=f"{label}, up the face"),
            column(f"{what}_{name}", [each.value for each in points], name, label=f"{label}, {quantity(name).label}"),
        ]
    columns += [
        column(
            "effective_area", [each.area() for each in maps], "face_area", label="area within 2 % of the sweet spot"
        ),
        column("face_area", [each.outline.area() for each in maps], label="area of the face"),
    ]
    return Table("best_points", tuple(columns), "Best points", layout="transposed")


def _spread_words(forgiveness: Forgiveness) -> str:
    deviations = " by ".join(fixed(each, "mm", 1) for each in (forgiveness.toe_deviation, forgiveness.high_deviation))
    about = ", ".join(
        f"{name} {fixed(each, 'mm', 1)}" for name, each in (("toe", forgiveness.toe), ("high", forgiveness.high))
    )
    return f"{deviations} about {about if forgiveness.toe or forgiveness.high else 'the face centre'}"


def _spread_table(maps: Sequence[FaceMap], spreads: Sequence[Forgiveness], listed: Sequence[str]) -> Table:
    names = [*listed, *(name for name in QUANTITIES if name not in listed)]
    rows = [(mapped.centre.club.name, each, name) for mapped, each in zip(maps, spreads, strict=True) for name in names]
    kinds, finer = ([_quantity_with_digits(name, more) for _, _, name in rows] for more in (False, True))
    columns = (
        text("club", [club for club, _, _ in rows], printed=len(maps) > 1),
        *row_names("quantity", [name for _, _, name in rows], [each.label for each in kinds]),
        Column("mean", [each.mean[name] for _, each, name in rows], kinds),
        Column("deviation", [each.deviation[name] for _, each, name in rows], finer, "standard deviation"),
        Column("loss", [each.loss[name] for _, each, name in rows], finer, "loss from scatter", difference=True),
        *(
            column(name, [getattr(each, name) for _, each, _ in rows], kind, printed=False)
            for name, kind in (("toe", "toe"), ("high", "high"), ("toe_deviation", "m"), ("high_deviation", "m"))
        ),
        text("missed", [each.missed for _, each, _ in rows], printed=False),
    )  # fmt: skip
    return Table(
        "scatter", columns, f"Impacts scattered by {_spread_words(spreads[0])}",
        shown_rows=[place for place, row in enumerate(rows) if row[2] in listed],
    )  # fmt: skip


def _summary(maps: Sequence[FaceMap]) -> Iterator[Note]:
    for each in maps:
        club, middle = each.centre.club.name, each.at(0.0, 0.0)
        yield note("map-centre", club=club, ball_speed=float(middle["ball_speed"]), carry=float(middle["carry"]))
        for toe, place in ((OFF_CENTRE, "toe"), (-OFF_CENTRE, "heel")):
            if each.outline.holds(toe, 0.0):
                there = each.at(toe, 0.0)
                carry = float(there["carry"] - middle["carry"])
                yield note("map-off-centre", toe=OFF_CENTRE, place=place, carry=carry, side=float(there["side"]))
        best, longest = each.best(), each.best("carry")
        yield note(
            "map-sweet-spot", club=club, toe=best.toe, high=best.high, ball_speed=best.value, carry=longest.value,
            carry_toe=longest.toe, carry_high=longest.high,
        )  # fmt: skip


def _notes(maps: Sequence[FaceMap], spreads: Sequence[Forgiveness]) -> Iterator[Note]:
    for mapped, each in zip(maps, spreads, strict=False):
        if each.missed >= LEAST_MISSED:
            yield note("map-missed", club=mapped.centre.club.name, missed=each.missed)
    for each in maps:
        yield note("map-outline", club=each.centre.club.name, outline=each.outline.origin)
    if maps[0].interpolated:
        yield note("map-interpolated")


def face_map_picture(mapped: Mapped, names: Sequence[str] = LISTED) -> Picture:
    """Return contours over a face with the toe on the right: a right-handed face seen from behind, through the head.

    A cross marks the face centre, a ring the point of greatest ball speed (of the first club).
    """
    first = mapped.maps[0]
    best = first.best()
    columns = min(2, len(names))
    panels: list[Panel | None] = [_contours(mapped, name, (best.toe, best.high)) for name in names]
    panels += [None] * (-len(panels) % columns)
    rows = [panels[start : start + columns] for start in range(0, len(panels), columns)]
    wide, tall = mapped.outline.greatest - mapped.outline.least
    title = " less ".join(each.centre.club.name for each in mapped.maps)
    interpolated = "; interpolated" if first.interpolated else ""
    return Picture(
        "face-map", "Contours over the face", rows, share_x=True, share_y=True, legend=True,
        title=f"{title}, ball {first.centre.ball.name}, by {first.centre.model}; outline {first.outline.origin}"
        f"{interpolated}",
        height=len(rows) * ((7.2 / columns - 0.9) * float(tall / wide) + 0.42) + 1.0,
    )  # fmt: skip


def _contours(mapped: Mapped, name: str, best: tuple[float, float]) -> Panel:
    toe, high, values = mapped.box(name)
    across, up = (_spread_indices(len(each), DRAWN_POINTS) for each in (toe, high))
    inside = np.where(mapped.outline.holds(*np.meshgrid(toe, high)), values, np.nan)
    limits = (float(np.nanmin(inside)), float(np.nanmax(inside)))
    kind, corners = quantity(name), mapped.outline.corners
    low, top = mapped.outline.least, mapped.outline.greatest
    marks = [
        Mark("contour", toe[across], high[up], values=values[np.ix_(up, across)], within=corners),
        Mark("outline", corners[:, 0], corners[:, 1], style=-2, size=1.0),
        Mark("points", [0.0], [0.0], label="centre of the face", symbol="+", style=-2, size=6.0),
        Mark("points", [best[0]], [best[1]], label="greatest ball speed", style=-2, size=5.0, hollow=True),
    ]
    return Panel(
        marks, axis("toe", "← heel   from the centre   toe →", limits=(float(low[0]), float(top[0]))),
        axis("high", "up the face", limits=(float(low[1]), float(top[1]))),
        f"{kind.label}{', right is positive' if kind.sides == ('left', 'right') else ''}", equal=True, grid=False,
        values=axis(name, limits=limits), diverging=len(mapped.maps) > 1 or kind.sides == ('left', 'right'),
    )  # fmt: skip
