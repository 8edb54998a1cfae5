"""The headings and cells of a launch monitor's file: names, units, numbers, and the side to which they point."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from itertools import islice
from typing import NamedTuple

from clubface.shots.tables.cells import NUMBER, is_missing, number
from clubface.shots.tables.headings import bracketed, narrow, plain, unit_symbol

__all__ = [
    "FACE_TO_PATH", "MIRRORED", "PLAIN", "SIDES", "WORLD", "CellError", "HeadingParts", "Side", "heading", "reading",
    "unit_in",
]  # fmt: skip

WORLD, CLUB = "world", "club"
"""The frame of left and right: that of the course, or that of the club, which a left-hander mirrors."""


class Side(NamedTuple):
    """The meaning of a word such as "left" or "open": its sign for a right-hander, in world or club terms."""

    sign: float
    frame: str


_L, _R = Side(-1.0, WORLD), Side(1.0, WORLD)
_MINUS, _PLUS = Side(-1.0, CLUB), Side(1.0, CLUB)


def _words(*sides: tuple[Side, str]) -> dict[str, Side]:
    """Return the side that each word means; words of two have a ``+`` between them."""
    return {word.replace("+", " "): side for side, words in sides for word in words.split()}


_LEFT_RIGHT = _words(
    (_L, "l left"),
    (_R, "r right"),
    (_L, "links linke gauche izquierda izq vänster venstre sinistra sx esquerda vasen 左 왼쪽 좌"),
    (_R, "rechts rechte droite derecha der dcha höger høyre højre destra dx direita oikea 右 오른쪽 우"),
)
_LETTERS = _words((_L, "g v i"), (_R, "d h"))
_OPENING = _words(
    (_PLUS, "in+out in+to+out"), (_MINUS, "out+in out+to+in"), (_PLUS, "open"), (_MINUS, "closed close"),
    (_PLUS, "offen ouvert ouverte abierta abierto aperta aperto öppen åpen åben aberta 开 開"),
    (_MINUS, "geschlossen zu fermé fermée cerrada cerrado chiusa chiuso stängd lukket fechada 闭 閉 关"),
    (_PLUS, "inside+out io i+o i+to+o innen+außen"), (_MINUS, "outside+in oi o+i o+to+i außen+innen"),
)  # fmt: skip
_ACROSS = {**_LEFT_RIGHT, **_OPENING}
_OF_FACE = _words((_PLUS, "o op"), (_MINUS, "c cl"))
_CURVES = _words((_MINUS, "draw hook"), (_PLUS, "fade slice"))
_STARTS = _words((_MINUS, "pull"), (_PLUS, "push"))
_FACE = _words(
    (_PLUS, "toe t"), (_MINUS, "heel h"), (_PLUS, "spitze pointe punta puntera tå teen"),
    (_MINUS, "ferse hacke talon talón tacco häl hæl hiel"),
)  # fmt: skip
_HEIGHT = _words(
    (_PLUS, "high up"), (_MINUS, "low down"), (_PLUS, "u h"), (_MINUS, "d l"),
    (_PLUS, "auf hoch oben aufwärts haut montant arriba alto upp opp op omhoog 上 위"),
    (_MINUS, "ab tief unten abwärts bas descendant abajo basso ned omlaag 下 아래"),
    (_PLUS, "above ascending upward"), (_MINUS, "below descending downward"),
)  # fmt: skip
_LIE = _words((_PLUS, "toe+up"), (_MINUS, "toe+down"), (_PLUS, "up u upright tu"), (_MINUS, "down d flat td"))
FACE_TO_PATH = "face_to_path"
"""Face angle less path: not a quantity of a shot, but with the path it gives the face angle."""
SIDES: Mapping[str, Mapping[str, Side]] = {
    "path": {**_ACROSS, **_LETTERS},
    "face": {**_ACROSS, **_OF_FACE, **_LETTERS},
    FACE_TO_PATH: {**_ACROSS, **_OF_FACE, **_LETTERS},
    "azimuth": {**_ACROSS, **_STARTS, **_LETTERS},
    "sidespin": {**_ACROSS, **_CURVES},
    "spin_axis": {**_ACROSS, **_CURVES},
    "side": {**_ACROSS, **_LETTERS},
    "total_side": {**_ACROSS, **_LETTERS},
    "toe": _FACE,
    **dict.fromkeys(("high", "attack", "launch"), _HEIGHT),
    "lie": _LIE,
}
"""The words for the sides of each quantity, the usual ones first. Letters of French, Spanish and the languages of the
north (droite, izquierda, höger) are among them only where "D" cannot be a draw nor "H" a hook."""
MIRRORED = tuple(name for name, words in SIDES.items() if "left" in words)
"""Quantities across the target line: in terms of the club, a left-hander's change their sign."""
_NO_SIDE = frozenset({"n", "neutral", "s", "straight", "square", "sq", "m", "middle", "c", "center", "centre"})
"""Words that go with zero."""
LISTED = 8
"""Sides that an error lists."""

_WORDS = "|".join(sorted({re.sub(" ", "[ -]", each) for words in SIDES.values() for each in words}, key=len)[::-1])
_TWO_SIDES = re.compile(rf"(?:^|\s)({_WORDS})([-+])\s*/\s*({_WORDS})([-+])$", re.IGNORECASE)
PLAIN = re.compile(r"-?\d{1,15}(\.\d{0,20})?", re.ASCII)
"""A number as most cells of most files hold it."""


class CellError(ValueError):
    """A cell that cannot be read; its text completes the sentence "the cell is ..."."""


class HeadingParts(NamedTuple):
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


def heading(text: str) -> HeadingParts:
    """Return the parts of a heading such as ``Push/Pull (deg L-/R+)``."""
    before, inner = bracketed(text)
    if inner is None:
        return HeadingParts(plain(text), None, None, plain(text))
    positive = None
    sides = _TWO_SIDES.search(inner)
    if sides:
        inner = inner[: sides.start()].strip()
        positive = plain(sides[1] if sides[2] == "+" else sides[3])
    bare = plain(before)
    is_unit = not inner or unit_symbol(inner) is not None
    return HeadingParts(bare if is_unit else plain(text), inner if inner and is_unit else None, positive, bare)


class CellReading(NamedTuple):
    """The content of a cell: a number, its side and its unit.

    Without a ``side`` the sign is as the file has it; without a ``unit`` it is that of the column.
    """

    value: float
    side: Side | None = None
    unit: str | None = None


def reading(cell: str, quantity: str, decimal_comma: bool, positive: float = 1.0) -> CellReading | None:
    """Return the content of a cell; None if nothing was measured.

    A number may stand with its side (``10.5 L``, ``L3.1``, ``3.1 In-Out``) and its unit (``422 R rpm``,
    ``8.5 mm Toe``), before it and after it, in any order. A sign next to a side must say the same: where positive
    numbers of the column are to the right (``positive`` is the sign of its positive side here), -1.2 L is 1.2 to the
    left and -1.2 R is an error.
    """
    if not decimal_comma and PLAIN.fullmatch(cell):
        return CellReading(float(cell))  # as below, but for most cells of most files at a tenth of the cost
    if is_missing(cell):
        return None
    match, side, unit = _parts(cell, quantity)
    try:
        value = number(match["number"], decimal_comma)
    except ValueError:
        raise CellError("not a number") from None
    if side is None:
        return CellReading(value, None, unit)
    written = match["number"][0]
    if value and written in "-+" and (positive if written == "+" else -positive) != side.sign:
        raise CellError("a number whose sign and side contradict each other")
    return CellReading(abs(value) * side.sign, side, unit)


def unit_in(cell: str, quantity: str = "") -> str | None:
    """Return the symbol of the unit that a cell names next to its number, or None."""
    try:
        return _parts(cell, quantity)[2]
    except CellError:
        return None


def _parts(cell: str, quantity: str) -> tuple[re.Match[str], Side | None, str | None]:
    """Return the number of a cell, its side and its unit, each of which may stand before the number or after it."""
    text = narrow(cell.replace("−", "-")).strip()
    match = NUMBER.fullmatch("-" + text[1:] if text[:1] == "–" else text)
    if not match or not any(map(str.isdigit, match["number"])):
        raise CellError("not a number")
    sides = SIDES.get(quantity, {})
    before, after = (_side_and_unit(match[each], quantity) for each in ("before", "rest"))
    if before is None or after is None or any(map(all, zip(before, after, strict=True))):
        if not match["number"].strip("+-0.,") and plain(match["before"] + match["rest"]) in _NO_SIDE:
            return match, None, None
        raise CellError(_no_number(sides))
    return match, before[0] or after[0], before[1] or after[1]


@lru_cache(maxsize=4096)
def _side_and_unit(text: str, quantity: str) -> tuple[Side | None, str | None] | None:
    """Return the side and the unit that words next to a number name, in any order; None where they are others."""
    sides = SIDES.get(quantity, {})
    words = re.sub(r"[°º](?!/)", r" ° ", text).split()
    only_unit = None
    for place in range(len(words) + 1):
        parts = " ".join(words[:place]), " ".join(words[place:])
        for named, other in (parts, parts[::-1]):
            side, symbol = None if "°" in named else sides.get(plain(named)), unit_symbol(other)
            if side and (symbol or not other):
                return side, symbol
            if not named and (symbol or not other):
                only_unit = None, symbol  # "1.3 C" is closed where it can be, and degrees Celsius elsewhere
    return only_unit


def _no_number(sides: Mapping[str, Side]) -> str:
    some = ", ".join(islice(sides, LISTED)) + ", ..." * (len(sides) > LISTED)
    return "not a number" + (f", or one with its side ({some})" if sides else "")
