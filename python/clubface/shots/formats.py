"""The formats of launch monitors' files: which heading gives which quantity, in which unit and with which sign.

A mapping file is a TOML file that describes the columns of any CSV file, which is then read like a known format.

.. code-block:: toml

    name = "my-monitor"     # optional; the name of the format
    delimiter = ";"         # optional; detected if left out
    decimal = ","           # optional; detected if left out
    club = "Schläger"       # optional: the heading of the column that names the club
    player = "Spieler"      # optional: the heading of the column that names the player
    hand = "Hand"           # optional: the heading of the column that says right or left
    speed_at = "cg"         # optional: where speed, attack and path are measured: "cg" or "face"
    face_at = "face"        # optional: where loft and face angle are measured: "face" (its centre) or "contact"

    [columns.speed]         # a quantity of a delivery or launch
    heading = "Tempo"       # without its unit; case, spaces and punctuation do not count
    unit = "km/h"           # needed if neither the heading nor a row of units names it

    [columns.path]
    heading = "Bahn"
    unit = "deg"
    positive = "in-out"     # the positive side: right if left out; or left, open, toe, heel, up, toe up, ...
    optional = true         # the file may lack it
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field as dataclass_field
from functools import cache, cached_property, partial
from typing import Any, NamedTuple

from clubface.errors import InputError
from clubface.schema import FLAG, TEXT, Choice, Document, Place, Record, decode, file_key
from clubface.shots.tables.cells import is_number
from clubface.shots.tables.headings import (
    DELIVERY_QUANTITIES,
    FACE_TO_PATH,
    HAND,
    LAUNCH_QUANTITIES,
    SECOND_CHOICE,
    SIDES,
    HeadingParts,
    KnownHeadings,
    Side,
    plain,
    plain_name,
    shot_words,
    squeezed,
    unit_symbol,
    vocabulary,
)
from clubface.support.checks import check_choice
from clubface.units import DIMENSIONLESS, unit

__all__ = ["Field", "Format", "Mapped", "MappingFile", "dimension_of", "mapping_of", "side_of"]

CG, FACE, CONTACT, UNKNOWN = "cg", "face", "contact", "unknown"
"""Points where monitors measure the club's motion (CG, FACE or UNKNOWN) and face angles (FACE, CONTACT or UNKNOWN)."""
_COLUMNS = vocabulary()["columns"]
CLUB, PLAYER, DATE, HAND_HEADINGS = (tuple(_COLUMNS[each]) for each in ("club", "player", "date", "hand"))
"""Headings used in exports for the club, the player, the date and the hand."""
MEASURED = frozenset({*DELIVERY_QUANTITIES, *LAUNCH_QUANTITIES, FACE_TO_PATH} - {HAND})
"""Quantities that monitors measure; others, such as "roll", are club or ball properties that mean other things
there."""
TO_PATH = ("face_to_path", "ftp", "club_face_to_path", "face_to_path_angle", "face_path")
"""Names of the face-to-path angle."""
BY_UNIT = {
    "side": {"angular rate": "sidespin", "angle": "azimuth"},
    "back": {"angular rate": "backspin"},
    "ball": {"speed": "ball_speed"},
    "club": {"speed": "club_speed"},
    "flight": {"time": "flight_time"},
    "dscnt": {"angle": "landing_angle"},
}
"""Short headings, as in SkyTrak files, whose unit tells the quantity: its name by dimension."""


class Field:
    """The columns that may give one quantity.

    Parameters
    ----------
    headings
        The headings without units, the preferred one first. Case, spaces and punctuation do not count.
    unit
        The unit if neither the heading nor a row of units names one. With None, it must be given.
    positive
        The word for the positive side in the file, such as "right", "in-out" or "heel". A heading that names a side
        takes precedence.
    """

    def __init__(self, *headings: str, unit: str | None = None, positive: str | None = None) -> None:
        self.shown = headings
        self.headings = tuple(plain(each) for each in headings)
        self.unit = unit
        self.positive = positive


COMMON = 100
"""Rank offset of headings from the common vocabulary."""
COMMON_FIELD = Field()


def dimension_of(quantity: str) -> str:
    """Return the dimension of a quantity that a monitor measures."""
    return shot_words().dimensions["face" if quantity == FACE_TO_PATH else quantity]


@cache
def common_names() -> Mapping[str, tuple[str, int]]:
    """Return the quantity and rank of each heading in the common vocabulary."""
    result: dict[str, tuple[str, int]] = {}
    counts: Counter[str] = Counter()
    for name, quantity in (*shot_words().names.items(), *dict.fromkeys(TO_PATH, FACE_TO_PATH).items()):
        if quantity in MEASURED:
            result[plain(name)] = quantity, counts[quantity] + COMMON * (plain_name(name) in SECOND_CHOICE)
            counts[quantity] += 1
    return result


@dataclass(frozen=True, kw_only=True)
class Format:
    """The layout of a launch monitor's file.

    Attributes
    ----------
    name, title
        Name in ``format=`` and on the command line, and readable name of the monitor and program.
    fields
        The columns of each quantity, by name.
    marks
        Groups of headings that identify the layout: the header contains all headings of at least one group.
    club, player, hand, date, file
        Headings of the columns with the names of club and player, the hand, the date of a shot, and the name of the
        file it comes from.
    title_of_player
        Regular expression for the first cell of a row above the header, whose group is the player of all shots below;
        "" if there is no such row.
    needs_units
        Whether units missing in the file must come from a mapping or the user. Otherwise the default units of the
        maker's program are used, and reported as assumed.
    only_own
        Whether only the listed columns are used, without those of the common vocabulary.
    all_columns
        Whether all columns of a quantity are read, and must agree, instead of only the preferred one.
    speed_at
        Where speed, attack angle and path are measured: "cg", "face" or "unknown".
    face_at
        Where dynamic loft and face angle are measured: "face" (its centre), "contact" or "unknown".
    counted
        Headings of columns whose values are counted in a note, such as whether spin was measured or estimated.
    notes
        Codes of notes by quantity, added if the quantity was measured.
    source
        Where the layout is documented.
    """

    name: str
    title: str
    fields: Mapping[str, Field]
    marks: tuple[tuple[str, ...], ...] = ()
    club: tuple[str, ...] = CLUB
    player: tuple[str, ...] = PLAYER
    hand: tuple[str, ...] = HAND_HEADINGS
    date: tuple[str, ...] = DATE
    file: tuple[str, ...] = ()
    title_of_player: str = ""
    needs_units: bool = False
    only_own: bool = False
    all_columns: bool = False
    speed_at: str = UNKNOWN
    face_at: str = UNKNOWN
    counted: tuple[str, ...] = ()
    notes: Mapping[str, str] = dataclass_field(default_factory=dict)
    source: str = ""

    @cached_property
    def own_names(self) -> Mapping[str, tuple[str, int]]:
        """Quantity and rank of each of the layout's own headings, in plain words."""
        return {
            each: (quantity, rank + COMMON * (self.all_columns and plain_name(each) in SECOND_CHOICE))
            for quantity, columns in self.fields.items()
            for rank, each in enumerate(columns.headings)
        }

    @cached_property
    def names(self) -> Mapping[str, tuple[str, int]]:
        """The same, extended by the common vocabulary, which ranks behind the layout's own headings."""
        known = {each: (quantity, rank + COMMON) for each, (quantity, rank) in common_names().items()}
        return self.own_names if self.only_own else {**known, **self.own_names}

    def field(self, quantity: str) -> Field:
        """Return the layout's columns for a quantity; for an unknown one, columns without a default unit."""
        return self.fields.get(quantity) or COMMON_FIELD

    @cached_property
    def _marks(self) -> list[set[str]]:
        return [{squeezed(plain(each)) for each in group} for group in self.marks]

    def is_marked(self, names: set[str]) -> bool:
        """Return whether these headings, in plain words, include all of at least one group of marks."""
        unparted = {squeezed(each) for each in names}
        return any(group <= unparted for group in self._marks)

    def is_header(self, cells: Sequence[str]) -> bool:
        """Return whether a row is a header of this layout.

        A layout without marks is recognised by any of its columns, in a row without numbers.
        """
        names = {self.heading(each).name for each in cells}
        if self.marks:
            return self.is_marked(names)
        return bool(self.known(names)) and not any(map(is_number, cells))

    def known(self, names: set[str]) -> int:
        """Return how many of these headings, in plain words, give a quantity."""
        return len(names & self.names.keys())

    def heading(self, text: str) -> HeadingParts:
        """Return the parts of a heading; its unit may follow without brackets, as in ``club_speed_mph``."""
        parts = self._headings.parts(text)
        return self.by_unit(parts, parts.unit)

    def by_unit(self, head: HeadingParts, written: str | None) -> HeadingParts:
        """Return the full heading for a short one such as "side", given its unit as written."""
        is_own = head.name in self.own_names and not self.all_columns
        if written is None or head.name not in BY_UNIT or is_own or self.only_own:
            return head
        symbol = unit_symbol(written)
        name = BY_UNIT[head.name].get(unit(symbol).dimension) if symbol else None
        return head if name is None else head._replace(name=plain(name), unit=symbol)

    @cached_property
    def _headings(self) -> KnownHeadings:
        return KnownHeadings(self.names, () if self.only_own else BY_UNIT)


def side_of(quantity: str, positive: str | None) -> Side:
    """Return the sign and frame (world or club) of a number without a side, from the name of the positive side."""
    if positive is None:
        return Side(1.0, SIDES["azimuth"]["right"].frame)
    return SIDES[quantity][plain(positive)]


class Mapped(NamedTuple):
    """The content of a mapping file."""

    layout: Format  # the columns
    delimiter: str | None  # the character between cells, if given
    decimal_comma: bool | None  # whether numbers are written with a decimal comma, if given


def _made_column(name: str, values: dict[str, Any], place: Place) -> tuple[Field, bool]:
    """Return the column of a quantity, and whether the file may lack it."""
    if not plain(values["heading"]):
        raise place.key("heading").invalid(values["heading"], "text with a word in it")
    dimension = dimension_of(name)
    symbol = values.get("unit", "1" if dimension == DIMENSIONLESS else None)
    if symbol is not None:
        unit(symbol, name="unit", dimension=dimension)
    positive = values.get("positive")
    if positive is not None:
        if name not in SIDES:
            raise InputError("positive", positive, f"left out: {name} has no sides")
        with place.key("positive").errors():
            check_choice("side", plain(positive), SIDES[name])
    return Field(values["heading"], unit=symbol, positive=positive), values.get("optional", False)


def _columns() -> dict[str, Record]:
    """Return the schema of a column, by quantity."""
    names = [*(name for name in shot_words().dimensions if name != HAND), FACE_TO_PATH]
    keys = {"heading": TEXT, "unit": TEXT, "positive": TEXT, "optional": FLAG}
    return {name: Record(keys, ("heading",), make=partial(_made_column, name)) for name in names}


@dataclass(frozen=True, kw_only=True)
class MappingFile:
    """A mapping file: the columns of a CSV file from any program."""

    name: str | None = file_key(TEXT, "name of the format", default=None)
    delimiter: str | None = file_key(
        Choice((",", ";", "\t", "|")), "character between cells; detected by default", default=None
    )
    decimal: bool | None = file_key(Choice({".": False, ",": True}), "decimal sign; detected by default", default=None)
    club: str | None = file_key(TEXT, "heading of the column that names the club", default=None)
    player: str | None = file_key(TEXT, "heading of the column that names the player", default=None)
    hand: str | None = file_key(TEXT, "heading of the column that says right or left", default=None)
    speed_at: str | None = file_key(Choice((CG, FACE)), "where speed, attack and path are measured", default=None)
    face_at: str | None = file_key(Choice((FACE, CONTACT)), "where loft and face angle are measured", default=None)
    columns: Mapping[str, tuple[Field, bool]] = file_key(
        Record(_columns, example="[columns.speed]"), "the columns, by quantity"
    )

    def __post_init__(self) -> None:
        if self.delimiter == "," and self.decimal:
            raise InputError("decimal", ",", "a sign other than the delimiter: they cannot both be a comma")
        if all(optional for _, optional in self.columns.values()):
            allowed = "columns of which at least one is not optional: the header is known by it"
            raise InputError("columns", list(self.columns), allowed)


def mapping_of(path: str | os.PathLike[str]) -> Mapped:
    """Read a mapping file; raise an error with the line of an unknown key, quantity, unit or word."""
    document = Document.read(path)
    file = decode(MappingFile, document)
    layout = Format(
        name=file.name or "mapping",
        title=file.name or f"mapped by {document.path}",
        fields={name: column for name, (column, _) in file.columns.items()},
        marks=(tuple(column.shown[0] for column, optional in file.columns.values() if not optional),),
        club=() if file.club is None else (file.club,),
        player=PLAYER if file.player is None else (file.player,),
        hand=() if file.hand is None else (file.hand,),
        needs_units=True,
        only_own=True,
        speed_at=file.speed_at or UNKNOWN,
        face_at=file.face_at or UNKNOWN,
    )
    return Mapped(layout, file.delimiter, file.decimal)
