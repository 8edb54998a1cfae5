"""Choosing the columns to use from a header and its row of units."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

from clubface.errors import FileError, shortened
from clubface.results.notes import Note, note
from clubface.shots.club_names import is_club_name
from clubface.shots.formats import COMMON, MEASURED, Format, dimension_of, side_of
from clubface.shots.tables.cells import unit_in
from clubface.shots.tables.headings import (
    POINTS,
    SIDES,
    FileColumn,
    HeadingParts,
    given_unit,
    listed,
    missing_units,
    plain,
    squeezed,
    unit_of_column,
    unit_symbol,
    vocabulary,
)
from clubface.units import DIMENSIONLESS

_COLUMNS = vocabulary()["columns"]
NOT_MEASURED = frozenset({*_COLUMNS["numbering"], *_COLUMNS["not_measured"]})
"""Headings of numeric columns that are not measurements."""
UNSIGNED = frozenset(_COLUMNS["unsigned"])
"""Headings of impact points that leave open whether toe or heel is positive."""
WITHOUT_UNIT = 10_000
"""Rank penalty of a heading without a unit."""
_WORD = re.compile(r"[^\W\d_]|[°%]")
"""A letter or symbol, as in any unit; a number, or a dash for nothing measured, has none."""


class Columns(NamedTuple):
    """The columns of a table, by position."""

    width: int  # number of columns
    needed: int  # number of cells a row must have: trailing columns without a heading may be absent
    first: int  # the first column used
    used: Mapping[str, tuple[FileColumn, ...]]  # by quantity; several if a heading occurs more than once
    texts: Mapping[str, tuple[int, ...]]  # "club" (the preferred first), "player", "hand", "date", "file"
    points: Mapping[str, int]  # columns that give the point on the club where its data was taken
    labels: Mapping[int, str]  # text columns where a summary row may name itself: "club", "player", or the heading
    others: tuple[int, ...]  # all remaining columns, except shot numbers
    counted: tuple[int, ...]  # columns whose values are counted in a note
    unused: tuple[str, ...]  # headings that would give a quantity if their brackets held a unit
    remarks: tuple[Note, ...]  # other remarks on the columns


def is_units_row(cells: Sequence[str]) -> bool:
    """Return whether a row contains only units, usually in brackets."""
    named = [cell.strip() for cell in cells if cell.strip()]
    bracketed = [cell for cell in named if cell[0] in "[(" and cell[-1] in "])"]
    known = [cell for cell in named if cell in ("[]", "()") or (_WORD.search(cell) and unit_symbol(cell) is not None)]
    words = [cell for cell in named if _WORD.search(cell) or any(map(str.isdigit, cell))]
    return bool(named) and (len(bracketed) == len(named) or (bool(known) and len(known) >= len(words)))


def columns_of(
    layout: Format,
    headings: Sequence[str],
    units_row: Sequence[str] | None,
    units: Mapping[str, str],
    place: tuple[str, int | None],
    rows: Iterable[Sequence[str]] = (),
) -> Columns:
    """Return the columns of a header that a layout uses.

    ``units`` gives units, by quantity or dimension, for columns without one in the heading, in a row of units, or in
    the cells of ``rows``. Raises a ``FileError`` if no column belongs to the layout, a unit does not fit, or units are
    missing; it then names all such columns.
    """
    heads = [layout.by_unit(layout.heading(each), _written(units_row, at)) for at, each in enumerate(headings)]
    with_unit = {each.name for at, each in enumerate(heads) if each.unit or _written(units_row, at)}
    preferred = _preferred(layout, heads, with_unit)
    names = [squeezed(each.name) if each.unit is None else "" for each in heads]
    texts = {key: _places(getattr(layout, key), names)[:1] for key in ("player", "hand", "date", "file")}
    texts["club"] = _places(layout.club, names)
    used: dict[str, list[FileColumn]] = {}
    without_unit: list[tuple[str, str]] = []
    remarks: list[Note] = []
    for position, each in enumerate(heads):
        # FlightScope calls both the club and its speed "Club"; the one without a unit names it.
        if each.name not in preferred or position in texts["club"]:
            continue
        quantity, shown = layout.names[each.name][0], headings[position].strip()
        if not _is_clear(layout, each.name, quantity, shown):
            if quantity == "speed":
                remarks.append(note("speed-of-club-or-ball", column=shortened(shown, 40)))
            continue
        dimension, field = dimension_of(quantity), layout.field(quantity)
        named = each.unit or _written(units_row, position)
        if named is None:
            cells = (row[position] for row in rows if position < len(row))
            named = next((symbol for cell in cells if (symbol := unit_in(cell, quantity))), None)
        symbol = unit_of_column(named, dimension, shown, place) if named else given_unit(units, quantity, dimension)
        is_assumed = symbol is None and not layout.needs_units and dimension in ("speed", "length")
        symbol = symbol or field.unit
        if symbol is None:
            if quantity in layout.fields:  # other columns have no documented unit
                without_unit.append((shown, quantity))
            continue
        side = side_of(quantity, each.positive if each.positive in SIDES.get(quantity, {}) else field.positive)
        if quantity == "toe" and each.name in UNSIGNED and not (each.positive or field.positive):
            remarks.append(note("toe-unsigned", column=shortened(shown, 40)))
        column = FileColumn(position, shown, quantity, symbol, side, named is not None, is_assumed)
        used.setdefault(quantity, []).append(column)
    if without_unit:
        raise missing_units(without_unit, *place, {name: dimension_of(name) for _, name in without_unit})
    if not used and remarks:
        raise FileError(*place, remarks[0].sentence)
    if not used:
        raise FileError(*place, f"no column belongs to a {layout.title} file; {listed([h.strip() for h in headings])}")
    places = {each.place for columns in used.values() for each in columns}
    taken = {*places, *chain.from_iterable(texts.values())}
    if not texts["club"] and not layout.only_own:
        texts["club"] = _clubs_by_cells(rows, {*range(len(headings))} - taken)
        remarks += [note("club-column", column=shortened(headings[at].strip(), 40)) for at in texts["club"]]
    labels = {place: key for key in ("date", "player", "club") for place in texts[key]}
    return Columns(
        width=len(headings),
        needed=max((place for place, each in enumerate(headings) if each.strip()), default=0) + 1,
        first=min(places),
        used={quantity: tuple(each) for quantity, each in used.items()},
        texts=texts,
        points={name: names.index(squeezed(plain(name))) for name in POINTS if squeezed(plain(name)) in names},
        labels={
            place: labels.get(place, each.name)
            for place, each in enumerate(heads)
            if place not in {*places, *texts["hand"]}
        },
        others=tuple(
            place
            for place, each in enumerate(heads)
            if place not in {*taken, *texts["club"]} and each.name not in NOT_MEASURED
        ),
        counted=_places(layout.counted, names),
        unused=tuple(
            shown.strip()
            for each, shown in zip(heads, headings, strict=True)
            if each.name != each.bare and each.bare in layout.names and layout.names[each.bare][0] not in used
        ),
        remarks=tuple(remarks),
    )


def _is_clear(layout: Format, name: str, quantity: str, shown: str) -> bool:
    """Return whether a heading has clubface's meaning, as any heading in clubface's own style has.

    Elsewhere "Speed" may be club or ball speed, and "Roll" is what the ball does on the ground.
    """
    is_general = layout.all_columns or name not in layout.own_names
    if not is_general or (shown == shown.lower() and "(" not in shown):
        return True
    return name != "speed" and quantity in MEASURED


def _written(units_row: Sequence[str] | None, place: int) -> str | None:
    """Return a column's unit in the row of units, or None."""
    return (units_row[place].strip().strip("[]()").strip() or None) if units_row and place < len(units_row) else None


def _places(known: Sequence[str], names: Sequence[str]) -> tuple[int, ...]:
    """Return the positions of known headings among column names without spaces, in the order of the headings."""
    return tuple(dict.fromkeys(names.index(each) for each in map(squeezed, map(plain, known)) if each in names))


def _clubs_by_cells(rows: Iterable[Sequence[str]], places: Iterable[int]) -> tuple[int, ...]:
    """Return the position of a column whose cells are club names, whatever its heading; empty if there is none."""
    for place in sorted(places):
        texts = [text for row in rows if place < len(row) and (text := row[place].strip())]
        named = [each for each in texts if is_club_name(each)]
        if named and 2 * len(named) > len(texts):
            return (place,)
    return ()


def _preferred(layout: Format, heads: Sequence[HeadingParts], with_unit: Collection[str]) -> set[str]:
    """Return the headings to use: the preferred one for each quantity, or all if the layout reads all columns.

    A heading with a unit has priority over headings of the same quantity without one.
    """
    known: dict[str, tuple[str, int]] = {}
    for each in heads:
        if each.name in layout.names:
            quantity, rank = layout.names[each.name]
            lacks_unit = dimension_of(quantity) != DIMENSIONLESS and each.name not in with_unit
            known[each.name] = quantity, rank + WITHOUT_UNIT * lacks_unit
    best: dict[str, int] = {}
    for quantity, rank in known.values():
        best[quantity] = min(rank, best.get(quantity, rank))
    if layout.all_columns:  # second-choice headings only if there is no other
        return {name for name, (quantity, rank) in known.items() if rank // COMMON == best[quantity] // COMMON}
    return {name for name, (quantity, rank) in known.items() if rank == best[quantity]}
