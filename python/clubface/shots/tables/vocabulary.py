"""The words of tables of shots in the languages of golfers: those of ``data/vocabulary.toml``, and of sides."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from clubface.support.files import DATA


@cache
def vocabulary() -> dict[str, Any]:
    """Return the words by subject: units, headings, columns, clubs, summaries, months."""
    return tomllib.loads((DATA / "vocabulary.toml").read_text(encoding="utf-8"))


def by_word(lists: dict[str, list[str]]) -> dict[str, str]:
    """Return the meaning of each word, from the words of each meaning."""
    return {word: meaning for meaning, words in lists.items() for word in words}


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
