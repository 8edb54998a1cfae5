"""What a club is from the name that people and monitors give it: ``Dr``, ``3W``, ``5h``, ``7 Iron``, ``PW``, ``56``."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from itertools import pairwise

WEDGES = {"pitching": (40, 49), "gap": (48, 53), "sand": (52, 58), "lob": (57, 64)}
"""Lofts in degrees by which wedges go, from and to; makers differ, so that the ranges overlap."""

_ALONE = {"d": "driver", "p": "pitching-wedge", "g": "gap-wedge", "a": "gap-wedge", "s": "sand-wedge", "l": "lob-wedge"}
"""What a single letter is, as it is stamped on soles and as Rapsodo writes the driver."""
_WHOLE = {
    "driver": "driver", "dr": "driver", "drv": "driver", "putter": "putter", "pt": "putter",
    "pitching": "pitching-wedge", "pw": "pitching-wedge",
    "gap": "gap-wedge", "gw": "gap-wedge", "approach": "gap-wedge", "attack": "gap-wedge", "aw": "gap-wedge",
    "sand": "sand-wedge", "sw": "sand-wedge", "lob": "lob-wedge", "lw": "lob-wedge",
}  # fmt: skip
"""Words of which one tells the club, whatever stands beside it."""
_FAMILIES = {
    "w": "wood", "fw": "wood", "wood": "wood", "fairway": "wood", "holz": "wood", "madera": "wood", "hout": "wood",
    "h": "hybrid", "hy": "hybrid", "hyb": "hybrid", "hybrid": "hybrid", "rescue": "hybrid", "hibrido": "hybrid",
    "i": "iron", "iron": "iron", "eisen": "iron", "hierro": "iron", "ijzer": "iron",
}  # fmt: skip
"""Words that go with a number; those of other languages are those of the layouts that are read."""
_PASSED_OVER = frozenset({"er", "driving", "deg", "degree", "degrees"})
WEDGE = "wedge"


@lru_cache(maxsize=4096)
def club_kind(name: str) -> str | None:
    """Return what a club is from its name, or None if the name does not tell.

    ``"driver"``, ``"3-wood"``, ``"4-hybrid"``, ``"7-iron"``, ``"pitching-wedge"``, ``"gap-wedge"``, ``"sand-wedge"``,
    ``"lob-wedge"``, ``"putter"``; a wedge that goes by its loft is ``"56-wedge"``; ``"hybrid"`` is one without number.
    """
    words = _words(name)
    if len(words) == 1 and words[0] in _ALONE:
        return _ALONE[words[0]]
    whole = next((_WHOLE[each] for each in words if each in _WHOLE), None)
    if whole is not None:
        return whole
    pairs = list(pairwise(words))
    for number, family in (*pairs, *((second, first) for first, second in pairs)):
        if re.fullmatch(r"[1-9]", number) and family in _FAMILIES:
            return "driver" if (number, _FAMILIES[family]) == ("1", "wood") else f"{number}-{_FAMILIES[family]}"
    lofts = [each for each in words if re.fullmatch(r"4[4-9]|5\d|6[0-4]", each)]
    if len(lofts) == 1 and (WEDGE in words or len(words) == 1):
        return f"{lofts[0]}-{WEDGE}"
    return "hybrid" if words == ["hybrid"] else None


def same_club(one: str, other: str) -> bool:
    """Tell whether two names mean the same club, as ``7i`` and ``7 Iron``; names that tell nothing must be one text."""
    kinds = club_kind(one), club_kind(other)
    if kinds[0] is None or kinds[1] is None:
        return one.strip().casefold() == other.strip().casefold()
    return kinds[0] == kinds[1]


def may_be(one: str, other: str) -> bool:
    """Tell whether two kinds can be the same club: a wedge by its loft and one by its name, a hybrid without number."""
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
    """Return by what a wedge goes, its loft or its name, and the lofts that it can have [deg]."""
    name = kind.partition("-")[0]
    return (int(name), int(name), int(name)) if name.isdigit() else (name, *WEDGES[name])


def _words(name: str) -> list[str]:
    """Return words and whole numbers in lower case: ``PitchingWedge``, ``7er Eisen`` and ``5h`` are two each."""
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", unicodedata.normalize("NFKD", name))
    letters = "".join(each for each in apart if not unicodedata.combining(each)).lower()
    return [each for each in re.findall(r"[a-z]+|\d+", letters) if each not in _PASSED_OVER]
