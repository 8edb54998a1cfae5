"""How a launch monitor's file is declared: which heading is which quantity, in which unit and with which sign."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from clubface.launch_monitor.cells import MIRRORED, SIDES, Side, plain

CG, FACE, CONTACT, UNKNOWN = "cg", "face", "contact", "unknown"
POINTS = {
    CG: "the centre of gravity",
    FACE: "the face centre",
    CONTACT: "the point of contact",
    UNKNOWN: "a point that is not published",
}
"""Where a monitor takes the motion of the club (CG, FACE or UNKNOWN) and its face angles (FACE, CONTACT or UNKNOWN)."""


class Field:
    """The columns that may give a quantity.

    Parameters
    ----------
    headings
        Without unit, the preferred one first; case, spaces and punctuation do not count.
    unit
        The unit where neither the heading nor a row of units tells it. None: a heading without a unit is not it.
    positive
        The word for what is positive in the file, such as "right", "in-out", "heel"; a heading may tell otherwise.
    """

    def __init__(self, *headings: str, unit: str | None = None, positive: str | None = None) -> None:
        self.shown = headings
        self.headings = tuple(plain(each) for each in headings)
        self.unit = unit
        self.positive = positive


@dataclass(frozen=True, kw_only=True)
class Format:
    """The layout of a launch monitor's file.

    Attributes
    ----------
    name
        What it is called in ``format=`` and on the command line.
    title
        The monitor and program, for people.
    fields
        The columns of each quantity, by name.
    marks
        Headings by which the layout is recognised: all of one of the groups are in its header.
    club, hand
        Headings of the column that names the club, and of the one that says right or left.
    needs_units
        Whether a file that names no units cannot be read unless they are given.
    speed_at
        Where speed, attack angle and path are taken: "cg", "face" or "unknown".
    face_at
        Where dynamic loft and face angle are taken: "face" (its centre), "contact" or "unknown".
    told
        Headings of columns whose different values are told in a note, such as whether spin was measured.
    notes
        What a reader of the shots should know where a quantity was measured, by its name.
    source
        Where the layout is documented.
    """

    name: str
    title: str
    fields: Mapping[str, Field]
    marks: tuple[tuple[str, ...], ...] = ()
    club: tuple[str, ...] = ("Club", "Club Name", "Club Type")
    hand: tuple[str, ...] = ("Hand", "Handed", "Handedness")
    needs_units: bool = False
    speed_at: str = UNKNOWN
    face_at: str = UNKNOWN
    told: tuple[str, ...] = ()
    notes: Mapping[str, str] = field(default_factory=dict)
    source: str = ""

    @cached_property
    def names(self) -> Mapping[str, tuple[str, int]]:
        """The quantity each plain heading may give, and its rank among the headings of that quantity."""
        return {
            each: (quantity, rank)
            for quantity, columns in self.fields.items()
            for rank, each in enumerate(columns.headings)
        }

    def is_marked(self, names: set[str]) -> bool:
        """Tell whether a row with these plain headings is the header of such a file."""
        return any({plain(each) for each in group} <= names for group in self.marks)


def side_of(quantity: str, positive: str | None) -> Side:
    """Return the sign of a bare number of a quantity and whose terms it is in, from the word for what is positive."""
    if positive is None:
        return Side(1.0, SIDES["azimuth"]["right"].frame)
    return SIDES[quantity][plain(positive)]


def is_mirrored(quantity: str) -> bool:
    """Tell whether a left-hander's value, where told in terms of the club, has the other sign here."""
    return quantity in MIRRORED
