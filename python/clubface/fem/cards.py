"""Lines of a keyword deck: fields of fixed width, as LS-DYNA and OpenRadioss read them."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterable, Sequence
from typing import Any

WIDTH = 10
"""Characters of a field, but for nodes and elements."""
LONGEST = 80
"""Characters of a line."""
BALL_SET = 1
"""Number of the set of the parts of the ball."""


class Cards:
    """A deck as it is written: keywords, comments and cards, in order."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def comment(self, *paragraphs: str) -> None:
        """Add comments, wrapped; an empty one is a bare line."""
        for text in paragraphs:
            self.lines += [f"$ {line}" for line in textwrap.wrap(ascii_text(text), LONGEST - 2)] or ["$"]

    def keyword(self, name: str, *cards: Sequence[Any], names: str = "") -> None:
        """Add a keyword with its cards; ``names`` are those of the fields of the first, for a comment."""
        self.lines.append(f"*{name}")
        if names:
            self.lines.append(("$#" + "".join(f"{each:>{WIDTH}}" for each in names.split())[2:])[:LONGEST])
        for card in cards:
            self.card(card)

    def card(self, fields: Sequence[Any]) -> None:
        """Add a line of fields: numbers, None for a blank."""
        self.lines.append("".join(field(value) for value in fields).rstrip() or " " * WIDTH)

    def text(self, text: str) -> None:
        """Add a line of text, as of a title."""
        self.lines.append(ascii_text(text)[:LONGEST])

    def nodes(self, places: Any, first: int = 1) -> None:
        """Add nodes at places (n, 3), numbered from ``first``: I8, then three coordinates of 16 characters."""
        self.keyword("NODE")
        for number, place in enumerate(places.tolist(), first):
            self.lines.append(f"{number:8d}" + "".join(f"{each:16.8e}" for each in place))

    def elements(self, kind: str, parts: Iterable[int], corners: Any, first: int = 1) -> int:
        """Add elements, numbered from ``first``: the part and the nodes (n, k) of each; return the last number."""
        self.keyword(f"ELEMENT_{kind}")
        for number, (part, nodes) in enumerate(zip(parts, corners.tolist(), strict=True), first):
            self.lines.append(element(number, part, nodes))
        return first + len(corners) - 1

    def rows(self, lines: Iterable[str]) -> None:
        """Add lines that are formatted already."""
        self.lines += lines

    def __str__(self) -> str:
        return "\n".join(self.lines) + "\n"


def field(value: float | None, width: int = WIDTH) -> str:
    """Write a number right-aligned in ``width`` characters, a float with as many digits as fit and at most nine."""
    if value is None:
        return " " * width
    if isinstance(value, int):
        text = str(value)
    else:
        if not math.isfinite(value):
            raise ValueError(f"{value} cannot stand in a deck")
        digits = range(9, 0, -1)
        text = next(t for d in digits for t in (_plain(value, d), _scientific(value, d)) if len(t) <= width)
    if len(text) > width:
        raise ValueError(f"{text} does not fit {width} characters")
    return text.rjust(width)


def ascii_text(text: str) -> str:
    """Return ``text`` in the letters every reader of decks knows."""
    return text.encode("ascii", "replace").decode()


def element(number: int, part: int, nodes: Sequence[int]) -> str:
    """Write an element: fields of I8."""
    return "".join(f"{each:8d}" for each in (number, part, *nodes))


def _plain(value: float, digits: int) -> str:
    text = f"{value:.{digits}g}"
    return text if "e" in text or "." in text else text + ".0"


def _scientific(value: float, digits: int) -> str:
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    return f"{mantissa}e{int(exponent)}"
