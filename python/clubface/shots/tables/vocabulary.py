"""The words of tables of shots in the languages of golfers, from ``data/vocabulary.toml``."""

from __future__ import annotations

import tomllib
from functools import cache
from typing import Any

from clubface.support.files import DATA

__all__ = ["by_word", "vocabulary"]


@cache
def vocabulary() -> dict[str, Any]:
    """Return the words by subject: units, headings, columns, clubs, summaries, months."""
    return tomllib.loads((DATA / "vocabulary.toml").read_text(encoding="utf-8"))


def by_word(lists: dict[str, list[str]]) -> dict[str, str]:
    """Return the meaning of each word, from the words of each meaning."""
    return {word: meaning for meaning, words in lists.items() for word in words}
