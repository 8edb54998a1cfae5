"""The headings and cells of a launch monitor's file: names, units, numbers, and the side to which they point."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from clubface.tables.cells import NUMBER, is_missing, number, without_thousands
from clubface.tables.spelling import bracketed, plain, unit_symbol

WORLD, CLUB = "world", "club"
"""Whose left and right a side is told in: that of the course, or that of the club, which a left-hander mirrors."""


class Side(NamedTuple):
    """The meaning of a word such as "left" or "open": its sign for a right-hander, in world or club terms."""

    sign: float
    frame: str


_L, _R = Side(-1.0, WORLD), Side(1.0, WORLD)
_MINUS, _PLUS = Side(-1.0, CLUB), Side(1.0, CLUB)
_ACROSS = {
    "l": _L, "left": _L, "r": _R, "right": _R,
    "in out": _PLUS, "in to out": _PLUS, "out in": _MINUS, "out to in": _MINUS,
    "open": _PLUS, "closed": _MINUS, "close": _MINUS,
}  # fmt: skip
_FACE = {"toe": _PLUS, "heel": _MINUS}
_HEIGHT = {"high": _PLUS, "low": _MINUS, "up": _PLUS, "down": _MINUS}
_LIE = {"toe up": _PLUS, "toe down": _MINUS, "up": _PLUS, "down": _MINUS}
FACE_TO_PATH = "face_to_path"
"""Face angle less path: not a quantity of a shot, but with the path it gives the face angle."""
SIDES: Mapping[str, Mapping[str, Side]] = {
    **dict.fromkeys(("path", "face", FACE_TO_PATH, "azimuth", "sidespin", "spin_axis", "side", "total_side"), _ACROSS),
    "toe": _FACE,
    "high": _HEIGHT,
    "attack": _HEIGHT,
    "lie": _LIE,
}
"""The words for the sides of each quantity."""
MIRRORED = tuple(name for name, words in SIDES.items() if words is _ACROSS)
"""Quantities across the target line: told in terms of the club, a left-hander's change their sign."""

_WORDS = "|".join(sorted({re.sub(" ", "[ -]", each) for words in SIDES.values() for each in words}, key=len)[::-1])
_TWO_SIDES = re.compile(rf"(?:^|\s)({_WORDS})([-+])\s*/\s*({_WORDS})([-+])$", re.IGNORECASE)
_PLAIN = re.compile(r"-?\d{1,15}(\.\d{0,20})?", re.ASCII)


class CellError(ValueError):
    """A cell that cannot be read; its text completes the sentence "the cell is ..."."""


class Heading(NamedTuple):
    """The parts of a heading.

    Attributes
    ----------
    name
        Its words in lower case, without punctuation.
    unit
        The text of the unit in brackets, or None.
    positive
        The word for the positive side, as in ``(deg closed-/open+)``, or None.
    bare
        Its words without those in brackets: "spin axis" for ``Spin Axis (Sim)``. Words in brackets that are not a unit
        belong to ``name``.
    """

    name: str
    unit: str | None
    positive: str | None
    bare: str


def heading(text: str) -> Heading:
    """Return the parts of a heading such as ``Push/Pull (deg L-/R+)``."""
    before, inner = bracketed(text)
    if inner is None:
        return Heading(plain(text), None, None, plain(text))
    positive = None
    sides = _TWO_SIDES.search(inner)
    if sides:
        inner = inner[: sides.start()].strip()
        positive = plain(sides[1] if sides[2] == "+" else sides[3])
    bare = plain(before)
    is_unit = not inner or unit_symbol(inner) is not None
    return Heading(bare if is_unit else plain(text), inner if inner and is_unit else None, positive, bare)


class Reading(NamedTuple):
    """The content of a cell: a number, its side and its unit.

    Without a ``side`` the sign is as the file has it; without a ``unit`` it is that of the column.
    """

    value: float
    side: Side | None = None
    unit: str | None = None


def reading(cell: str, quantity: str, decimal_comma: bool) -> Reading | None:
    """Return the content of a cell; None if nothing was measured.

    A number may be followed by its side (``10.5 L``, ``3.1 In-Out``) or preceded by it (``L3.1``), and followed by its
    unit, on either side of the side (``422 R rpm``, ``8.5 mm Toe``).
    """
    if not decimal_comma and _PLAIN.fullmatch(cell):
        return Reading(float(cell))  # as below, but for most cells of most files at a tenth of the cost
    text = cell.replace("\xa0", " ").replace("−", "-").strip()
    if is_missing(text):
        return None
    found = NUMBER.fullmatch(text)
    if not found:
        raise CellError("not a number")
    try:
        value = number(without_thousands(found["number"], decimal_comma), decimal_comma)
    except ValueError:
        raise CellError("not a number") from None
    side, unit = _side_and_unit(found["before"] or "", found["rest"], quantity)
    if side is not None and found["number"][0] in "-+":
        raise CellError("a number with both a sign and a side")
    return Reading(value if side is None else value * side.sign, side, unit)


def unit_in(cell: str) -> str | None:
    """Return the symbol of the unit that a cell names after its number, or None."""
    found = NUMBER.fullmatch(cell.strip())
    words = found["rest"].split() if found else []
    return next((symbol for each in (" ".join(words), *words[:1], *words[-1:]) if (symbol := unit_symbol(each))), None)


def _side_and_unit(before: str, rest: str, quantity: str) -> tuple[Side | None, str | None]:
    """Return the side told before or after a number, and the unit told after it."""
    sides = SIDES.get(quantity, {})
    words = rest.split()
    for place in range(len(words) + 1):
        parts = " ".join(words[:place]), " ".join(words[place:])
        for told, other in (parts, parts[::-1]):
            named = told or before
            side, symbol = sides.get(plain(named)), unit_symbol(other)
            if not (told and before) and (side or not named) and (symbol or not other):
                return side, symbol
    raise CellError(_no_number(sides))


def _no_number(sides: Mapping[str, Side]) -> str:
    return "not a number" + (f", or one with its side ({', '.join(sides)})" if sides else "")
