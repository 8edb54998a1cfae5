"""Recognising clubs by the names people and monitors give them: ``Dr``, ``3W``, ``Fer 7``, ``PW``, ``56``."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from itertools import pairwise

from clubface.shots.tables.headings import by_word, vocabulary

WEDGES = {"pitching": (40, 49), "gap": (48, 53), "sand": (52, 58), "lob": (57, 64)}
"""Range of lofts of each wedge in degrees; makers differ, so the ranges overlap."""
WEDGE = "wedge"

_CLUBS = vocabulary()["clubs"]
_WEDGE_LETTERS = by_word(_CLUBS["letters"])
_ALONE = {"d": "driver", **{each: kind for each, kind in _WEDGE_LETTERS.items() if each != "u"}}
"""Clubs named by a single letter, as stamped on soles, or as Rapsodo writes the driver."""
_WHOLE, _FAMILIES, _SHORT = (by_word(_CLUBS[each]) for each in ("names", "families", "short"))
"""Words that alone name a club, words that need a number, and letters that do so if nothing else is there."""
_NUMBERS = {"wood": range(1, 16), "hybrid": range(1, 10), "iron": range(1, 12)}
"""Valid club numbers, by family."""
_PASSED_OVER = frozenset(_CLUBS["passed_over"])
_EASTERN = by_word(_CLUBS["eastern"])
"""Words in Japanese, Chinese and Korean, which are written without spaces."""
_EASTERN_WORDS = re.compile("|".join(sorted(_EASTERN, key=len, reverse=True)))
_NUMERALS = str.maketrans("一二三四五六七八九", "123456789")
_COMPOUND = re.compile(
    r"(fairway|driving|pitching|sand|lob|gap|approach|attack|utility|vayla|[pgasul])"
    r"(wedge|wood|woods|holz|iron|eisen|hout|trae?|puu)"
)
"""Compound words: ``Sandwedge``, ``Fairwayholz``, ``PWedge``."""
_PIECES = re.compile(r"[a-z]+|\d+(?:[.,]\d+)?")
_LOFT = re.compile(r"(4[4-9]|5\d|6[0-4])(?:[.,]\d+)?")
"""The loft of a wedge; the digits after a point may be its bounce: ``56.10``."""


@lru_cache(maxsize=4096)
def club_kind(name: str) -> str | None:
    """Return the kind of club from its name, or None if the name does not tell.

    Kinds are ``"driver"``, ``"3-wood"``, ``"4-hybrid"``, ``"7-iron"``, ``"pitching-wedge"``, ``"gap-wedge"``,
    ``"sand-wedge"``, ``"lob-wedge"``, ``"putter"``, ``"56-wedge"`` for a wedge named by loft, and ``"hybrid"`` for one
    without a number. Numbers in model names (``ZX5``, ``AP2``, ``SM9``) do not count.
    """
    words = _words(name)
    if len(words) == 1 and words[0] in _ALONE:
        return _ALONE[words[0]]
    whole = next((_WHOLE[each] for each in words if each in _WHOLE), None)
    if whole is not None:
        return whole
    pairs = list(pairwise(words))
    letter = next((first for first, second in pairs if first in _WEDGE_LETTERS and second == WEDGE), None)
    if letter is None and len(words) == 2 and words[1] == "w" and words[0] in _WEDGE_LETTERS:
        letter = words[0]
    if letter is not None:
        return _WEDGE_LETTERS[letter]
    lofts = [match[1] for each in words if (match := _LOFT.fullmatch(each))]
    short = len(words) <= 2 and len(words) - len(lofts) == sum(len(each) == 1 for each in words)
    if len(lofts) == 1 and (short or WEDGE in words or "vokey" in words):
        return f"{lofts[0]}-{WEDGE}"
    # A letter behind a number names the family in a longer name too ("P790 7i"); before one, a model ("Ping i5").
    after = [(second, first) for first, second in pairs if len(first) > 1 or len(words) == 2]
    for number, word in (*pairs, *after):
        family = _FAMILIES.get(word) or (_SHORT.get(word) if (number, word) in after and len(words) == 2 else None)
        # int() refuses a number of thousands of digits.
        if family and number.isdecimal() and len(number) <= 2 and int(number) in _NUMBERS[family]:
            return "driver" if (number, family) == ("1", "wood") else f"{int(number)}-{family}"
    return "hybrid" if len(words) == 1 and len(words[0]) > 1 and _FAMILIES.get(words[0]) == "hybrid" else None


def is_club_name(text: str) -> bool:
    """Return whether a text is a club name and nothing else; a single letter or a number is not enough."""
    if len(text.strip()) < 2 or not any(map(str.isalpha, text)) or club_kind(text) is None:
        return False
    return all(each in _KNOWN or each.replace(".", "").isdigit() for each in _words(text))


def same_club(one: str, other: str) -> bool:
    """Return whether two names mean the same club, as ``7i`` and ``7 Iron``; unknown names must be equal."""
    kinds = club_kind(one), club_kind(other)
    return same_text(one, other) if None in kinds else kinds[0] == kinds[1]


def same_text(one: str, other: str) -> bool:
    """Return whether two texts are equal, apart from case and spaces around them."""
    return one.strip().casefold() == other.strip().casefold()


def may_be(one: str, other: str) -> bool:
    """Return whether two kinds may be one club, such as a wedge by loft and by name, or a hybrid without number."""
    if one == other:
        return True
    families = one.rpartition("-")[2], other.rpartition("-")[2]
    if families == ("hybrid", "hybrid"):
        return "hybrid" in (one, other)
    if families != (WEDGE, WEDGE):
        return False
    (first, *lofts), (second, *others) = _lofts(one), _lofts(other)
    return isinstance(first, int) != isinstance(second, int) and lofts[0] <= others[1] and others[0] <= lofts[1]


def _lofts(kind: str) -> tuple[str | int, int, int]:
    """Return a wedge's loft or name, and the range of its loft [deg]."""
    name = kind.partition("-")[0]
    return (int(name), int(name), int(name)) if name.isdigit() else (name, *WEDGES[name])


def _words(name: str) -> list[str]:
    """Return words and numbers in lower case without accents: two each for ``PitchingWedge``, ``7er Eisen``, ``5h``.

    Letters that name no club are left out along with a number after them, as in ``ZX5``.
    """
    text = unicodedata.normalize("NFKC", name.replace("º", "°")).translate(_NUMERALS)
    text = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", _EASTERN_WORDS.sub(lambda match: f" {_EASTERN[match[0]]} ", text))
    letters = "".join(each for each in unicodedata.normalize("NFKD", text) if not unicodedata.combining(each)).lower()
    letters = re.sub(r"(?<=\d):an?\b", " ", letters.replace("æ", "ae"))  # Swedish: 7:an
    words: list[str] = []
    for chunk in re.findall(r"[a-z\d]+(?:(?<=\d)[.,]\d+[a-z]*)?", letters):
        pieces = _PIECES.findall(_COMPOUND.sub(r"\1 \2", chunk))
        is_model = len(pieces) > 1 and pieces[1][0].isdigit() and not (pieces[0] in _KNOWN or pieces[0].isdigit())
        words += [pieces[0]] if is_model else pieces
    return [each for each in words if each not in _PASSED_OVER]


_KNOWN = frozenset({*_FAMILIES, *_SHORT, *_WHOLE, *_PASSED_OVER, *_WEDGE_LETTERS, WEDGE})
