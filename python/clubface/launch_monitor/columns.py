"""From a header and its row of units to the columns that are used."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from clubface.errors import FileError
from clubface.launch_monitor.cells import FACE_TO_PATH, SIDES, Heading, Side, heading, unit_in
from clubface.launch_monitor.formats import Format, side_of
from clubface.tables.headings import listed, shot_words
from clubface.tables.spelling import plain, unit_of_column, unit_symbol
from clubface.units import symbols, unit

_WORD = re.compile(r"[^\W\d_]|[°%]")
"""A unit has one; a number or a dash, which stands for nothing measured, has none."""


class Used(NamedTuple):
    """A column that is used.

    Attributes
    ----------
    place
        Its place in a row.
    heading
        Its heading, as in the file.
    quantity
        The quantity that it gives.
    unit
        The symbol of its unit.
    side
        The sign of a number without a side, and whether it is in world or club terms.
    """

    place: int
    heading: str
    quantity: str
    unit: str
    side: Side


class Columns(NamedTuple):
    """The columns of a table.

    Attributes
    ----------
    width
        How many there are.
    used
        The columns of each quantity: several where a heading is there more than once.
    club, player, hand
        The places of the columns that name the club (the preferred first), the player and the hand.
    told
        Places of columns whose values are told in a note.
    assumed
        Headings whose unit nothing tells, with the one taken.
    unused
        Headings that would give a quantity but for what is in their brackets, which is no unit.
    """

    width: int
    used: Mapping[str, tuple[Used, ...]]
    club: tuple[int, ...]
    player: int | None
    hand: int | None
    told: tuple[int, ...]
    assumed: tuple[tuple[str, str], ...]
    unused: tuple[str, ...]


def is_units_row(cells: Sequence[str]) -> bool:
    """Return whether a row holds nothing but units, usually in brackets."""
    told = [cell.strip() for cell in cells if cell.strip()]
    bracketed = [cell for cell in told if cell[0] in "[(" and cell[-1] in "])"]
    known = [cell for cell in told if cell in ("[]", "()") or (_WORD.search(cell) and unit_symbol(cell) is not None)]
    return bool(told) and (len(bracketed) == len(told) or len(known) == len(told))


def columns_of(
    layout: Format,
    headings: Sequence[str],
    units_row: Sequence[str] | None,
    units: Mapping[str, str],
    place: tuple[str, int],
    rows: Iterable[Sequence[str]] = (),
) -> Columns:
    """Return the columns of a header that a layout uses.

    ``units`` gives the units, by quantity or dimension, for columns where the file names none: neither the heading, nor
    a row of units, nor the first of the cells in ``rows`` that has one.
    """
    heads = [heading(each) for each in headings]
    best: dict[str, int] = {}
    for each in heads:
        known = layout.names.get(each.name)
        if known and (known[0] not in best or known[1] < best[known[0]]):
            best[known[0]] = known[1]
    names = [each.name if each.unit is None else "" for each in heads]
    clubs = tuple(names.index(plain(each)) for each in layout.club if plain(each) in names)
    used: dict[str, list[Used]] = {}
    assumed: list[tuple[str, str]] = []
    for position, each in enumerate(heads):
        known = layout.names.get(each.name)
        # FlightScope calls both the club and its speed "Club"; the one without a unit names it.
        if known is None or best[known[0]] != known[1] or position in clubs:
            continue
        quantity = known[0]
        told = each.unit
        if told is None and units_row is not None and position < len(units_row):
            told = units_row[position].strip().strip("[]()").strip() or None
        if told is None:
            told = next((symbol for row in rows if position < len(row) and (symbol := unit_in(row[position]))), None)
        symbol, was_assumed = _unit(layout, quantity, headings[position], told, units, place)
        if symbol is None:
            continue
        if was_assumed:
            assumed.append((headings[position].strip(), symbol))
        side = _side(layout, quantity, each)
        used.setdefault(quantity, []).append(Used(position, headings[position].strip(), quantity, symbol, side))
    if not used:
        found = listed([each.strip() for each in headings])
        raise FileError(*place, f"no column belongs to a {layout.title} file; {found}")
    return Columns(
        len(headings),
        {quantity: tuple(each) for quantity, each in used.items()},
        clubs,
        next((names.index(plain(each)) for each in layout.player if plain(each) in names), None),
        next((names.index(plain(each)) for each in layout.hand if plain(each) in names), None),
        tuple(names.index(plain(each)) for each in layout.told if plain(each) in names),
        tuple(assumed),
        tuple(
            shown.strip()
            for each, shown in zip(heads, headings, strict=True)
            if each.name != each.bare and each.bare in layout.names and layout.names[each.bare][0] not in used
        ),
    )


def _unit(
    layout: Format, quantity: str, shown: str, told: str | None, units: Mapping[str, str], place: tuple[str, int]
) -> tuple[str | None, bool]:
    """Return the unit of a column, None where it has none and so is another column; and whether it was assumed."""
    dimension = _dimension(quantity)
    if told is not None:
        return unit_of_column(told, dimension, shown.strip(), place), False
    given = units.get(quantity) or units.get(dimension)
    if given is not None:
        return unit(given, name=f"the unit of {quantity}", dimension=dimension).symbol, False
    default = layout.fields[quantity].unit
    if default is None and layout.needs_units:
        examples = symbols(dimension)
        some = " or ".join(examples[:3])
        message = (
            f"the file does not say the unit of {shown.strip()!r} ({some}), which depends on the settings of the app: "
            f'give it, as in units={{"{dimension}": "{examples[0]}"}} or --unit {dimension}={examples[0]}'
        )
        raise FileError(*place, message, shown)
    return default, default is not None and not layout.needs_units and dimension in ("speed", "length")


def _dimension(quantity: str) -> str:
    return shot_words().dimensions["face" if quantity == FACE_TO_PATH else quantity]


def _side(layout: Format, quantity: str, head: Heading) -> Side:
    positive = head.positive if head.positive in SIDES.get(quantity, {}) else layout.fields[quantity].positive
    return side_of(quantity, positive)
