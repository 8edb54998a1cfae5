"""Finding summary rows, such as averages and deviations, which are not shots.

A summary row is recognised by a word in one of its cells. A word such as "Max" may also be a person or a club; then the
numbers must confirm that the row is a summary. A row without a name, or with a name unlike any club or other row, is an
average, in whatever language, if its numbers match one.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from clubface.shots.club_names import club_kind
from clubface.shots.formats import PLAYER
from clubface.shots.tables.cells import Chunk
from clubface.shots.tables.headings import HAND, ColumnLayout, by_word, plain, vocabulary
from clubface.support.arrays import Floats

MEAN, MEDIAN, DEVIATION, MOST, LEAST, SUM = "mean", "median", "deviation", "most", "least", "sum"
_WORDS = vocabulary()["summaries"]
_PHRASES = {tuple(phrase.split()): kind for phrase, kind in by_word(_WORDS["words"]).items()}
_LONGEST = max(map(len, _PHRASES))
_BEGINNINGS = by_word(_WORDS["stems"])
"""Stems of summary words, for abbreviations: ``Standardabw.``, ``Durchschn.``."""
_NAMES_TOO, _PASSED_OVER = (frozenset(_WORDS[each]) for each in ("names_too", "passed_over"))
"""Words for means and deviations that are also names, and words to ignore."""
NUMBERING = frozenset(vocabulary()["columns"]["numbering"])
"""Headings of columns that number the shots."""
TELLING = NUMBERING | set(vocabulary()["columns"]["labels"])
"""Headings of columns in which a summary word cannot be a name."""
NAMES = ("club", "player")
AGREES = 0.6
"""Share of a row's numbers that must match a summary."""
FEWEST_CLOSE, AGREES_CLOSELY = 4, 0.75
"""Minimum number of comparable numbers in a row without a summary word, and share of them that must match."""
MOST_JUDGED = 200
"""Maximum number of candidate rows; with more, none counts as a summary."""
_LETTER = re.compile(r"[^\W\d_]")
MANY = 1000
"""Number of different texts in a column above which those beginning with a digit, such as dates, are skipped."""


class _Label(NamedTuple):
    """Meaning of a text: kind of summary, whether it is unambiguous, and the remaining words."""

    kind: str
    is_clear: bool
    rest: str


def summary_rows(
    labels: Mapping[int, str], cells: Sequence[Any], values: Mapping[str, Floats], doubtful: Iterable[int] = ()
) -> set[int]:
    """Return the indices of summary rows.

    ``labels`` maps positions of text columns to "club", "player", or the heading in plain words; ``cells`` are given by
    column, and ``doubtful`` rows have text in a numeric cell, which may be a summary word.
    """
    certain: set[int] = set()
    possible: dict[int, str] = {}
    for place, heading in labels.items():
        column = cells[place]
        texts = set(column)
        if len(texts) > MANY:
            texts = {each for each in texts if not each.lstrip()[:1].isdigit()}
        known = {each: label for each in texts if (label := _label(each)) is not None}
        if not known:
            continue
        others = {_spelled(each) for each in texts if each not in known}
        rows = [(row, label) for row, each in enumerate(column) if (label := known.get(each)) is not None]
        for row, (kind, is_clear, rest) in rows:
            if rest and rest not in others and club_kind(rest) is None:
                continue
            is_telling = heading in TELLING or (place == 0 and heading not in NAMES and is_clear)
            is_rare = 2 * len(rows) <= len(column) + 1
            if (is_telling and (is_clear or is_rare)) or (is_clear and heading in NAMES):
                certain.add(row)
            elif is_rare:
                possible[row] = kind
    for row in doubtful:
        texts = (each[row] for each in cells if not isinstance(each, np.ndarray))
        if any((label := _label(each)) is not None and label.is_clear for each in texts):
            certain.add(row)
    if len(possible) > MOST_JUDGED:
        return certain  # so many rows share the word that it is a remark on shots
    uncounted = _uncounted(labels, cells)
    unnamed = _unnamed(labels, cells) - certain - possible.keys()
    may_be_shot = np.ones(len(next(iter(values.values()))), dtype=bool)
    may_be_shot[[*certain, *possible]] = False
    is_shot = may_be_shot.copy()
    is_shot[[*unnamed]] = False
    for row, kind in possible.items():
        # A remark on most shots does not make the others summaries.
        if row not in certain and (
            row in uncounted or any(_summarises(row, kind, each, values) for each in (is_shot, may_be_shot))
        ):
            certain.add(row)
    return certain | {
        row
        for row in unnamed
        if any(_summarises(row, kind, is_shot, values, closely=True) for kind in (MEAN, DEVIATION))
    }


def _unnamed(labels: Mapping[int, str], cells: Sequence[Any]) -> set[int]:
    """Return the few rows that lack a text most others have, or whose club name is unknown and unique."""
    few: set[int] = set()
    for place, heading in labels.items():
        column = cells[place]
        empty = [row for row, cell in enumerate(column) if not cell.strip()]
        if 2 * len(empty) < len(column):
            few.update(empty)
        if heading == "club" and len(counts := Counter(column)) <= MOST_JUDGED:
            few.update(
                row for row, cell in enumerate(column) if counts[cell] == 1 and cell.strip() and not club_kind(cell)
            )
    return few if len(few) <= MOST_JUDGED else set()


def summaries_in(chunk: Chunk, columns: ColumnLayout) -> dict[int, str]:
    """Return the summary rows of a plain table of deliveries, each with a note."""
    used = {each.place for each in columns.used}
    cells = [np.empty(0) if place in used else chunk.cells(place) for place in range(len(columns.headings))]
    texts = {place: each for place, each in enumerate(cells) if not isinstance(each, np.ndarray)}
    if not any(_LETTER.search(each) and _label(each) for column in texts.values() for each in set(column)):
        return {}
    names = {place: plain(columns.headings[place]) for place in texts}
    players = set(map(plain, PLAYER))
    labels = {place: "player" if each in players and each not in NUMBERING else each for place, each in names.items()}
    values = {each.quantity: chunk.numbers(each)[0] for each in columns.used if each.quantity != HAND}
    rows = summary_rows(labels, cells, values)
    words = {row: next(each[row] for each in texts.values() if _label(each[row])) for row in rows}
    return {row: f"{word!r}: the row sums up others and is not a shot" for row, word in words.items()}


@lru_cache(maxsize=8192)
def _label(text: str) -> _Label | None:
    """Return the meaning of a text; None if it is not a summary word."""
    words = _spelled(text).split()
    kind, is_clear, rest, place = "", False, [], 0
    while place < len(words):
        for count in range(_LONGEST, 0, -1):
            phrase = tuple(words[place : place + count])
            if len(phrase) == count and phrase in _PHRASES:
                meaning = _PHRASES[phrase]
                kind = kind or meaning
                is_clear |= meaning in (MEAN, MEDIAN, DEVIATION) and not (count == 1 and phrase[0] in _NAMES_TOO)
                place += count
                break
        else:
            word = words[place]
            if stem := next((each for start, each in _BEGINNINGS.items() if word.startswith(start)), ""):
                kind, is_clear = kind or stem, True
            elif word not in _PASSED_OVER and not (kind and word.isdigit()):
                rest.append(word)
            place += 1
    if not kind:
        return None
    return _Label(kind, is_clear, " ".join(rest))


def _spelled(text: str) -> str:
    """Return the words of a text in lower case without accents."""
    letters = unicodedata.normalize("NFC", "".join(
        each for each in unicodedata.normalize("NFKD", text) if not "\u0300" <= each <= "\u036f"
    ))  # fmt: skip
    return " ".join(re.findall(r"[^\W_]+", letters.casefold()))


def _uncounted(labels: Mapping[int, str], cells: Sequence[Any]) -> set[int]:
    """Return the rows without a number in a column that numbers most rows."""
    for place, heading in labels.items():
        if heading in NUMBERING:
            empty = {row for row, cell in enumerate(cells[place]) if not cell.strip()}
            return empty if 2 * len(empty) < len(cells[place]) else set()
    return set()


def _summarises(row: int, kind: str, is_shot: Any, values: Mapping[str, Floats], closely: bool = False) -> bool:
    """Return whether a row's numbers summarise shots: the adjacent ones, those on one side, or all."""
    shots = np.flatnonzero(is_shot)
    groups = [shots]
    for side, last in ((shots[shots < row], True), (shots[shots > row], False)):
        if side.size:
            parts = np.split(side, np.flatnonzero(np.diff(side) > 1) + 1)
            groups += [side, parts[-1] if last else parts[0]]
    return any(each.size > closely and _agrees(row, kind, each, values, closely) for each in groups)


def _agrees(row: int, kind: str, group: Any, values: Mapping[str, Floats], closely: bool) -> bool:
    compared = agreed = 0
    for column in values.values():
        value, shots = float(column[row]), column[group]
        shots = shots[~np.isnan(shots)]
        spread = float(np.ptp(shots)) if shots.size else 0.0
        if value != value or not shots.size or (closely and not spread):
            continue
        compared += 1
        close = 0.03 * spread if closely else 0.005 * float(np.abs(shots).max()) + 0.02 * spread
        agreed += any(abs(value - each) <= close for each in _summaries(kind, shots))
    fewest, part = (FEWEST_CLOSE, AGREES_CLOSELY) if closely else (1, AGREES)
    return compared >= fewest and agreed >= part * compared


def _summaries(kind: str, shots: Floats) -> list[float]:
    """Return the possible values of a kind of summary; for sides, extremes also count without sign."""
    mean = float(shots.mean())
    if kind == MEAN:
        return [mean]
    if kind == MEDIAN:
        return [float(np.median(shots))]
    if kind == DEVIATION:
        return [float(shots.std()), float(shots.std(ddof=1)) if shots.size > 1 else 0.0]
    ends = [float(shots.max()), float(shots.min())]
    if kind in (MOST, LEAST):
        size = np.abs(shots)
        return [*ends, float(size.max() if kind == MOST else size.min())]
    return [mean, float(shots.sum()), ends[0] - ends[1], float(shots.size)]
