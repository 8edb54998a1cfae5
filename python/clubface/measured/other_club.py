"""Whether shots are of another club than the one given: by the names in their file and by their dynamic loft."""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.support.checks import check_choice

MISMATCH = ("refuse", "note")
"""What shots of another club may do."""
LOFT_DIFFERENCE = units.to_si(12.0, "deg")
"""Median dynamic loft further than this [rad] from the static loft is most likely another club's."""
LEAST_LOFT = 0.6
"""So is one below this part of the static loft, where that allows more: of short irons, players take off more than of
long ones. The launch angles of the published tour averages need 0.60 (5-iron) to 0.72 (pitching wedge) of it."""

_SHORT = {
    "d": "driver", "dr": "driver", "1w": "driver", "1-wood": "driver", "pw": "pitching-wedge", "gw": "gap-wedge",
    "aw": "gap-wedge", "sw": "sand-wedge", "lw": "lob-wedge",
}  # fmt: skip
_WORDS = {"w": "wood", "i": "iron", "h": "hybrid", "hy": "hybrid", "wood": "wood", "iron": "iron", "hybrid": "hybrid"}


def club_kind(name: str) -> str | None:
    """Return what a club is from its name: "driver", "7-iron", "pitching-wedge"; None if the name does not tell."""
    plain = "-".join(re.findall(r"[a-z]+|\d+", name.lower()))
    if plain.replace("-", "") in _SHORT:
        return _SHORT[plain.replace("-", "")]
    if plain in _SHORT:
        return _SHORT[plain]
    for whole in ("driver", "pitching-wedge", "gap-wedge", "sand-wedge", "lob-wedge"):
        if whole in plain:
            return whole
    number = re.search(r"(?<![a-z\d])(\d)-(wood|iron|hybrid|w|i|hy|h)(?![a-z])", plain)
    if number:
        return f"{number[1]}-{_WORDS[number[2]]}"
    turned = re.search(r"(?<![a-z])(wood|iron|hybrid|w|i|hy|h)-(\d)(?!\d)", plain)
    return f"{turned[2]}-{_WORDS[turned[1]]}" if turned else None


def check_club(
    club: Club, names: Iterable[object] | None, lofts: NDArray[np.float64] | None, mismatch: str = "refuse"
) -> list[str]:
    """Refuse shots of another club than ``club``, or return a note that says why they look so.

    Parameters
    ----------
    club
        The club given.
    names
        What the file calls the club of each shot, None if it does not or if that was chosen on purpose.
    lofts
        Measured dynamic lofts [rad], or None.
    mismatch
        "refuse" or "note".
    """
    check_choice("mismatch", mismatch, MISMATCH)
    found = _other_name(club, names) or _other_loft(club, lofts)
    if found is None:
        return []
    if mismatch == "refuse":
        advice = 'the club of these shots: {} (mismatch="note" or --mismatch note takes them all the same)'
        raise InputError("club", club.name, advice.format(found))
    return [f"{found}: is this the right club?"]


def _other_name(club: Club, names: Iterable[object] | None) -> str | None:
    wanted = club_kind(club.name)
    if names is None or wanted is None:
        return None
    kinds = {str(name): club_kind(str(name)) for name in dict.fromkeys(names)}
    others = [name for name, kind in kinds.items() if kind not in (None, wanted)]
    return f"the shots name {', '.join(others)}, not {club.name}" if others else None


def _other_loft(club: Club, lofts: NDArray[np.float64] | None) -> str | None:
    if lofts is None or not len(lofts):
        return None
    median = float(np.median(lofts))
    if min(club.loft - LOFT_DIFFERENCE, LEAST_LOFT * club.loft) <= median <= club.loft + LOFT_DIFFERENCE:
        return None
    delivered, static = units.show(median, "deg", 3), units.show(club.loft, "deg", 3)
    return f"the median dynamic loft is {delivered}, the static loft of {club.name} {static}"
