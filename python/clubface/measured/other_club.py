"""Whether shots are of another club than the one given: by the names in their file and by their dynamic loft."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.recorded.club_names import club_kind, may_be
from clubface.support.checks import check_choice

REFUSE, NOTE = MISMATCH = ("refuse", "note")
"""What shots of another club may do."""
LOFT_DIFFERENCE = units.to_si(12.0, "deg")
"""Median dynamic loft further than this [rad] from the static loft is most likely another club's."""
LEAST_LOFT = 0.6
"""So is one below this part of the static loft, where that allows more: of short irons, players take off more than of
long ones. The launch angles of the published tour averages need 0.60 (5-iron) to 0.72 (pitching wedge) of it."""


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
    if mismatch == REFUSE:
        advice = 'the club of these shots: {} (mismatch="note" or --mismatch note takes them all the same)'
        raise InputError("club", club.name, advice.format(found))
    return [f"{found}: is this the right club?"]


def _other_name(club: Club, names: Iterable[object] | None) -> str | None:
    wanted = club_kind(club.name)
    if names is None or wanted is None:
        return None
    kinds = {str(name): club_kind(str(name)) for name in dict.fromkeys(names)}
    others = [name for name, kind in kinds.items() if kind is not None and not may_be(kind, wanted)]
    return f"the shots name {', '.join(others)}, not {club.name}" if others else None


def _other_loft(club: Club, lofts: NDArray[np.float64] | None) -> str | None:
    if lofts is None or not len(lofts):
        return None
    median = float(np.median(lofts))
    if min(club.loft - LOFT_DIFFERENCE, LEAST_LOFT * club.loft) <= median <= club.loft + LOFT_DIFFERENCE:
        return None
    delivered, static = units.show(median, "deg", 3), units.show(club.loft, "deg", 3)
    return f"the median dynamic loft is {delivered}, the static loft of {club.name} {static}"
