"""The words of tables of shots in the languages of golfers, those of ``data/vocabulary.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from clubface.support.files import DATA


@cache
def vocabulary() -> dict[str, Any]:
    """Return the words by subject: units, headings, sides, columns, clubs, summaries, months."""
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


FACE_TO_PATH = "face_to_path"
"""Face angle less path: not a quantity of a shot, but with the path it gives the face angle."""
_SIGNS = {"<": Side(-1.0, WORLD), ">": Side(1.0, WORLD), "-": Side(-1.0, CLUB), "+": Side(1.0, CLUB)}


def _sides(groups: list[str]) -> dict[str, Side]:
    lines = (line.split() for each in groups for line in vocabulary()["sides"][each])
    return {word.replace("_", " "): _SIGNS[sign] for sign, *words in lines for word in words}


SIDES: Mapping[str, Mapping[str, Side]] = {name: _sides(groups) for name, groups in vocabulary()["sides"]["of"].items()}
"""The words for the sides of each quantity, the usual ones first."""
MIRRORED = tuple(name for name, words in SIDES.items() if "left" in words)
"""Quantities across the target line: in terms of the club, a left-hander's change their sign."""
