"""What a session says of each club of a player: how many shots, means and spreads, and the gaps in carry."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.shots.club_names import same_club
from clubface.shots.recorded import RecordedShots

QUANTITIES = {
    "speed": "mph", "ball_speed": "mph", "smash": "1", "attack": "deg", "launch": "deg", "azimuth": "deg",
    "total_spin": "rpm", "spin_axis": "deg", "carry": "yd", "side": "yd", "total": "yd",
}  # fmt: skip
"""The quantities that are summed up, and the units in which people read them."""


class Spread(NamedTuple):
    """One quantity of the shots of a club, SI.

    Attributes
    ----------
    shots
        The shots in which it was measured.
    mean, deviation
        Mean, and standard deviation from shot to shot (NaN for a single shot).
    """

    shots: int
    mean: float
    deviation: float

    @property
    def error(self) -> float:
        """Standard error of the mean."""
        return self.deviation / math.sqrt(self.shots)


class Gap(NamedTuple):
    """How much further a club carries than the next shorter one, and the standard error of that [m]."""

    length: float
    error: float


@dataclass(frozen=True)
class ClubSummary:
    """The shots of one club.

    Attributes
    ----------
    player
        Who hit it, as in the file; "" where the file names no one, or the same player for all shots.
    club
        Its name as in the file, or "" where the file has none.
    places
        Its shots among those of the session.
    spreads
        What was measured, by quantity.
    gap
        How much further it carries than the next shorter club of the player; None for the shortest, or without carry.
    """

    player: str
    club: str
    places: NDArray[np.intp]
    spreads: Mapping[str, Spread]
    gap: Gap | None


def summarised(shots: RecordedShots) -> list[ClubSummary]:
    """Return a summary of each club, the longest first; names of the same club, as 7i and 7 Iron, are taken together.

    The clubs of several players are summed up player by player, as these appear in the file. Values that were not
    measured count for nothing, not even as shots of their quantity.
    """
    return [each for player, places in shots.by_player() for each in _of_player(player, shots.select(places), places)]


def _of_player(player: str, shots: RecordedShots, whole: NDArray[np.intp]) -> list[ClubSummary]:
    """Return a summary of each club of a player, whose shots have the places ``whole`` in the session."""
    names = [str(each) for each in shots.clubs] if shots.clubs is not None else [""] * len(shots)
    groups: dict[str, list[int]] = {}
    known: dict[str, str] = {}
    for place, name in enumerate(names):
        if name not in known:
            known[name] = next((each for each in groups if same_club(each, name)), name)
        groups.setdefault(known[name], []).append(place)
    values = shots.deliveries | shots.launches
    found = [(name, np.array(places), _spreads(values, places)) for name, places in groups.items()]
    length = "carry" if any("carry" in each for _, _, each in found) else "ball_speed"
    found.sort(key=lambda each: -each[2][length].mean if length in each[2] else math.inf)
    shorter = [*(each[2] for each in found[1:]), None]
    return [
        ClubSummary(player, name, whole[places], spreads, _gap(spreads, after))
        for (name, places, spreads), after in zip(found, shorter, strict=True)
    ]


def _spreads(values: Mapping[str, NDArray[np.float64]], places: list[int]) -> dict[str, Spread]:
    found = {}
    for name in QUANTITIES:
        told = values[name][places] if name in values else np.empty(0)
        told = told[np.isfinite(told)]
        if told.size:
            deviation = float(told.std(ddof=1)) if told.size > 1 else math.nan
            found[name] = Spread(told.size, float(told.mean()), deviation)
    return found


def _gap(longer: Mapping[str, Spread], shorter: Mapping[str, Spread] | None) -> Gap | None:
    if shorter is None or "carry" not in longer or "carry" not in shorter:
        return None
    one, other = longer["carry"], shorter["carry"]
    return Gap(one.mean - other.mean, math.hypot(one.error, other.error))
