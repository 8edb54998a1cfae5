"""From a file of shots to the shots of one club that a command works on: the one way that every command goes.

The shots are read, those wanted are chosen, their club is checked, what was not measured gets the values that somebody
states, and club data that was taken elsewhere on the club is referred to the points of clubface.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import CLUB_NAMES, Club, club as club_named
from clubface.errors import InputError
from clubface.launch_monitor import read, refer
from clubface.measured.other_club import NOTE, check_club
from clubface.recorded.assumed import with_assumed
from clubface.recorded.club_names import club_kind, same_club
from clubface.recorded.conditions import chosen_shots
from clubface.recorded.loft_origin import LoftOrigin, loft_origins
from clubface.recorded.shots import RecordedShots

WEDGES = ("gap-wedge", "sand-wedge", "lob-wedge")
"""The built-in clubs for which shots may name a loft in place of a club, as in "56"."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ReadyShots(RecordedShots):
    """Recorded shots of one club, referred to its points; attributes as of :class:`RecordedShots`, and these.

    Attributes
    ----------
    club
        The club with which they were hit.
    places
        Place of each shot (from 0) among the shots that were given or read.
    loft_origins
        What all shots of this club in each file tell of where their dynamic lofts come from.
    """

    club: Club
    places: NDArray[np.int64] = field(default_factory=lambda: np.arange(0))
    loft_origins: tuple[LoftOrigin, ...] = ()

    def select(self, which: Any) -> Self:
        """Return some of the shots, as :meth:`RecordedShots.select` does."""
        return replace(super().select(which), places=np.atleast_1d(self.places[which]))


def ready_shots(
    given: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    hand: str | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, Any] | None = None,
) -> ReadyShots:
    """Make recorded shots of one club ready for models.

    Parameters
    ----------
    given
        Recorded shots, or a file that :func:`clubface.launch_monitor.read` reads. :class:`ReadyShots` are ready.
    club
        The club with which they were hit. If left out: the club that the shots name, if that is a built-in one.
    hand
        "right" or "left": the hand of the club. If left out, its own.
    only
        Take only the shots of the club that the file calls so. If left out: all shots, which must then be of one club.
    where
        Take only the shots that fulfil this condition, see :func:`clubface.recorded.conditions.chosen`. It is judged on
        what was measured, where it was measured.
    mismatch
        What to do with shots that by their names or their dynamic loft look like those of another club: "refuse" or
        "note".
    assume
        Values for what was not measured, such as ``{"toe": "0 mm"}``; see
        :func:`clubface.recorded.assumed.with_assumed`.

    Raises
    ------
    InputError
        No shot is left; or the shots are of several clubs, or of another club than the one given.
    """
    if isinstance(given, ReadyShots):
        return given
    recorded = given if isinstance(given, RecordedShots) else read(given)
    origins = loft_origins(recorded)  # of all shots, and before lofts are assumed or referred
    recorded, places = (recorded, np.arange(len(recorded))) if where is None else chosen_shots(recorded, where)
    takes_all = club is not None and only is None and mismatch == NOTE
    of_club = np.arange(len(recorded)) if takes_all else of_one_club(recorded, only, club is not None)
    recorded, places = recorded.select(of_club), places[of_club]
    head = club_of(recorded, club)
    if hand is not None:
        head = head.replace(hand=hand)
    lofts = recorded.deliveries.get("loft", np.empty(0))
    notes = check_club(head, recorded.clubs if only is None else None, lofts[np.isfinite(lofts)], mismatch)
    found = refer(with_assumed(recorded, assume or {}), head)
    told = {each.name: getattr(found, each.name) for each in fields(RecordedShots)}
    clubs, files = (None if each is None else set(map(str, each)) for each in (recorded.clubs, recorded.files))
    of_these = (clubs or {""}, files or {""})
    return ReadyShots(
        **{**told, "notes": tuple(dict.fromkeys((*found.notes, *notes)))}, club=head, places=places,
        loft_origins=tuple(each for each in origins if each.club in of_these[0] and each.file in of_these[1]),
    )  # fmt: skip


def of_one_club(recorded: RecordedShots, only: str | None, club_is_given: bool) -> NDArray[np.int64]:
    """Return the places of the shots of the one club wanted; an error says what to do where there are several."""
    if recorded.clubs is None:
        if only is not None:
            raise InputError("only", only, "leave it out: the shots name no club")
        return np.arange(len(recorded))
    counts = {name: int(np.sum(recorded.clubs == name)) for name in dict.fromkeys(recorded.clubs)}
    listed = ", ".join(f"{name or 'without a name'} ({count})" for name, count in counts.items())
    if only is None:
        first = next(iter(counts), "")
        if not all(same_club(name, first) for name in counts):
            others = ', or mismatch="note" (--mismatch note) for all of them as one club' if club_is_given else ""
            raise InputError("only", None, f"give one of the several clubs that were hit: {listed}{others}")
        return np.arange(len(recorded))
    chosen_names = [name for name in counts if same_club(name, only)]
    if not chosen_names:
        raise InputError("only", only, f"one of the clubs that were hit: {listed}")
    return np.flatnonzero(np.isin(recorded.clubs, chosen_names))


def club_of(recorded: RecordedShots, given: str | os.PathLike[str] | Club | None) -> Club:
    """Return the club given, or the built-in one that the shots name."""
    if isinstance(given, Club):
        return given
    if given is not None:
        return club_named(given)
    named = str(recorded.clubs[0]) if recorded.clubs is not None and len(recorded) else ""
    kind = _built_in(club_kind(named))
    if kind is None:
        told = f"give it: the shots name {named!r}" if named else "give it: the shots name none"
        raise InputError("club", None, f"{told}; clubface clubs lists the built-in clubs")
    return club_named(kind)


def _built_in(kind: str | None) -> str | None:
    """Return the built-in club of a kind, a wedge that goes by its loft as the wedge of that loft; None without one."""
    if kind in CLUB_NAMES:
        return kind
    return next((name for name in WEDGES if kind == f"{units.from_si(club_named(name).loft, 'deg'):.0f}-wedge"), None)
