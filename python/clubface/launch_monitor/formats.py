"""How the file of a launch monitor is declared: which heading gives which quantity, in which unit and sign."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field as dataclass_field
from functools import cache, cached_property

from clubface.launch_monitor.cells import FACE_TO_PATH, SIDES, Heading, Side, heading
from clubface.tables import foreign_headings
from clubface.tables.cells import is_number
from clubface.tables.headings import HAND, LAUNCH_SYNONYMS, SECOND_CHOICE, SYNONYMS, shot_words
from clubface.tables.spelling import bracketed, plain, squeezed, unit_symbol, units_behind
from clubface.units import parse_column_name, unit

CG, FACE, CONTACT, UNKNOWN = "cg", "face", "contact", "unknown"
POINTS = {
    CG: "the centre of gravity",
    FACE: "the face centre",
    CONTACT: "the point of contact",
    UNKNOWN: "a point that is not published",
}
"""Where a monitor takes the motion of the club (CG, FACE or UNKNOWN) and its face angles (FACE, CONTACT or UNKNOWN)."""
DATE = (
    "Date", "Date Time", "Datetime", "Date and Time", "Shot Date", "Session Date", "Timestamp", "Datum", "Datum Zeit",
    "Datum Uhrzeit", "Fecha", "Date Heure", "Data", "Dato", "Data Hora", "Fecha y hora", "日付", "日時", "日期", "날짜",
)  # fmt: skip
"""Headings under which exports say when a shot was hit."""
MEASURED = frozenset({*SYNONYMS, *LAUNCH_SYNONYMS, FACE_TO_PATH} - {HAND})
"""Quantities that monitors measure; the others, as "roll", are properties of club and ball, and other things there."""
TO_PATH = ("face_to_path", "ftp", "club_face_to_path", "face_to_path_angle", "face_path")
"""Names of the angle from the path to the face."""
PLAYER = ("Player", "Player Name", "Golfer", *foreign_headings.names(foreign_headings.PLAYER))
"""Headings under which exports name the player."""
CLUB = ("Club", "Club Name", "Club Type", *foreign_headings.names(foreign_headings.CLUB))
"""Headings under which tables of no maker name the club."""
BY_UNIT = {
    "side": {"angular rate": "sidespin", "angle": "azimuth"},
    "back": {"angular rate": "backspin"},
    "ball": {"speed": "ball_speed"},
    "club": {"speed": "club_speed"},
    "flight": {"time": "flight_time"},
    "dscnt": {"angle": "landing_angle"},
}
"""Short headings, as of SkyTrak, that their unit explains: the name of the quantity by its dimension."""


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
"""The rank from which the headings of the vocabulary of all tables count."""
COMMON_FIELD = Field()


@cache
def common_names() -> Mapping[str, tuple[str, int]]:
    """Return the quantity that each heading of the vocabulary of all tables gives, and its rank."""
    found: dict[str, tuple[str, int]] = {}
    counts: Counter[str] = Counter()
    for name, quantity in (*shot_words().names.items(), *dict.fromkeys(TO_PATH, FACE_TO_PATH).items()):
        if quantity in MEASURED:
            found[plain(name.replace("_", " "))] = quantity, counts[quantity] + COMMON * (name in SECOND_CHOICE)
            counts[quantity] += 1
    return found


@dataclass(frozen=True, kw_only=True)
class Format:
    """The layout of a launch monitor's file.

    Attributes
    ----------
    name
        Its name in ``format=`` and on the command line.
    title
        The monitor and program, for people.
    fields
        The columns of each quantity, by name.
    marks
        Groups of headings by which the layout is recognised: its header contains all headings of at least one group.
    club, player, hand
        Headings of the column that names the club, that names the player, and that says right or left.
    date, file
        Headings of the column that says when a shot was hit, and of the one that names the file that it comes from.
    title_of_player
        A regular expression for the first cell of a row above the header that names the player of all shots below, as
        its group; "" where no row does.
    needs_units
        Whether the units of its columns, where the file names none, are those of a mapping or given, and not those
        that the maker's program has when it is installed: the latter are said to be assumed.
    only_own
        Whether its columns are those listed alone, and not those that the vocabulary of all tables names besides.
    all_columns
        Whether all columns of a quantity are read, and must agree, instead of those of the preferred heading.
    speed_at
        Where speed, attack angle and path are measured: "cg", "face" or "unknown".
    face_at
        Where dynamic loft and face angle are measured: "face" (its centre), "contact" or "unknown".
    counted
        Headings of columns whose values a note counts, such as whether spin was measured or estimated.
    notes
        Remarks on quantities, by their names, for shots in which they were measured.
    source
        Where the layout is documented.
    """

    name: str
    title: str
    fields: Mapping[str, Field]
    marks: tuple[tuple[str, ...], ...] = ()
    club: tuple[str, ...] = CLUB
    player: tuple[str, ...] = PLAYER
    hand: tuple[str, ...] = ("Hand", "Handed", "Handedness")
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
        """The quantity that each heading of the layout, in plain words, gives, and its rank among those of it."""
        return {
            each: (quantity, rank + COMMON * (self.all_columns and each.replace(" ", "_") in SECOND_CHOICE))
            for quantity, columns in self.fields.items()
            for rank, each in enumerate(columns.headings)
        }

    @cached_property
    def names(self) -> Mapping[str, tuple[str, int]]:
        """The same with the headings that the vocabulary of all tables has besides, which rank behind its own."""
        known = {each: (quantity, rank + COMMON) for each, (quantity, rank) in common_names().items()}
        return self.own_names if self.only_own else {**known, **self.own_names}

    def field(self, quantity: str) -> Field:
        """Return how the layout writes a quantity; one that it does not know has no unit of its own."""
        return self.fields.get(quantity) or COMMON_FIELD

    @cached_property
    def _marks(self) -> list[set[str]]:
        return [{squeezed(plain(each)) for each in group} for group in self.marks]

    def is_marked(self, names: set[str]) -> bool:
        """Return whether these headings in plain words are all of at least one group of marks."""
        unparted = {squeezed(each) for each in names}
        return any(group <= unparted for group in self._marks)

    def is_header(self, cells: Sequence[str]) -> bool:
        """Return whether a row names the columns of such a file.

        A layout without marks is known by any of its columns, in a row without a number.
        """
        names = {self.heading(each).name for each in cells}
        if self.marks:
            return self.is_marked(names)
        return bool(self.known(names)) and not any(map(is_number, cells))

    def known(self, names: set[str]) -> int:
        """Return how many of these headings in plain words are those of a quantity."""
        return len(names & self.names.keys())

    def heading(self, text: str) -> Heading:
        """Return the parts of a heading, whose unit may follow without brackets: ``club_speed_mph``."""
        if (found := self._headings.get(text)) is None:
            parts = self._parts(text)
            found = self._headings[text] = self.by_unit(parts, parts.unit)
        return found

    def by_unit(self, head: Heading, written: str | None) -> Heading:
        """Return the heading that a short one such as "side" stands for, which its unit, as written, tells."""
        is_own = head.name in self.own_names and not self.all_columns
        if written is None or head.name not in BY_UNIT or is_own or self.only_own:
            return head
        symbol = unit_symbol(written)
        name = BY_UNIT[head.name].get(unit(symbol).dimension) if symbol else None
        return head if name is None else head._replace(name=plain(name.replace("_", " ")), unit=symbol)

    @cached_property
    def _headings(self) -> dict[str, Heading]:
        return {}

    @cached_property
    def _unparted(self) -> Mapping[str, str]:
        return {squeezed(each): each for each in reversed(list(self.names))}

    def _spelled(self, name: str) -> str:
        """Return the name of a quantity that is the same but for where its words part, else ``name``."""
        return name if name in self.names else self._unparted.get(squeezed(name), name)

    def _parts(self, text: str) -> Heading:
        parts = heading(text)
        if (name := self._spelled(parts.name)) in self.names:
            return parts._replace(name=name)
        if bracketed(text)[1] is None:
            words = "_".join(text.replace("-", "_").split())
            for spelled in (words, words.lower()):
                short, symbol = parse_column_name(spelled)
                if symbol is not None and (name := self._spelled(plain(short))) in self.names:
                    return Heading(name, symbol, None, name)
            for before, symbol in units_behind(text):
                name = self._spelled(before)
                if name in self.names or (name in BY_UNIT and not self.only_own):
                    return Heading(name, symbol, None, name)
        return parts


def side_of(quantity: str, positive: str | None) -> Side:
    """Return the sign of a number without a side, and whether it is in world or club terms, from the positive side."""
    if positive is None:
        return Side(1.0, SIDES["azimuth"]["right"].frame)
    return SIDES[quantity][plain(positive)]
