"""The notes of the report on a club: what a fitter says to a customer. All their data are statistics of the club."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

from clubface.inference.player_statistics import ClubStatistics
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.shots.formats import CONTACT
from clubface.shots.mishits import Statistic, difference_error
from clubface.units import to_si

__all__ = ["change_note", "doubt_notes", "line_notes", "mishit_notes", "strike_notes", "typical_notes", "what_if_notes"]

TYPICAL = ("speed", "ball_speed", "launch", "total_spin")
"""Quantities of the typical shot, before carry and side."""
CLUB_DATA = ("speed", "attack", "path", "face", "toe", "high")
"""Club data that a report names where they were not measured."""
FEW, ENOUGH = 5, 10
"""Shots below which a median says little (of four its 95% interval is two standard deviations either way), and from
which the range of two in three is given."""
LEAST_ANGLE = to_si(0.3, "deg")
"""Smallest angle between face and path, or effect of the closing, that is mentioned [rad]; assumed."""
LEARNED = to_si(4.0, "mm")
"""Standard deviation of an estimated strike, below which it says something: half of that of golfers of any skill."""


def typical_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield the typical shot: what is measured at its start, and where it finishes."""
    shots = len(club.shots) - int(club.mishit.sum())
    if figures := {name: club.measured[name].median for name in TYPICAL if name in club.measured}:
        yield note("player-typical-shot", shots=shots, figures=figures)
    if carry := club.measured.get("carry"):
        data = {"carry": carry.median, "low_carry": carry.low, "high_carry": carry.high, "spread_carry": carry.spread}
        yield note(f"player-carry{_how_spread(carry)}", **data)
    if side := club.measured.get("side"):
        data = {"side": side.median, "low_side": side.low, "high_side": side.high, "spread_side": side.spread}
        yield note(f"player-side{_how_spread(side)}", **data)


def _how_spread(statistic: Statistic) -> str:
    """Return the ending of the code by how many shots there are: a range, a standard deviation, or none of them."""
    return "" if statistic.shots >= ENOUGH else "-few" if statistic.shots > 1 else "-alone"


def mishit_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield a note on each mishit, with its place in the file and what is far off."""
    for place in dict.fromkeys(each.place for each in club.mishits):
        reasons = [each for each in club.mishits if each.place == place]
        yield note(
            "player-mishit", place=club.shots.row_word, row=int(club.shots.rows[place]),
            figures={each.quantity: each.value for each in reasons},
            usual={each.quantity: each.median for each in reasons},
        )  # fmt: skip


def line_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield where the ball starts and how far it curves, with face and path.

    Without a carry and side there is no curve, and the tilt of the spin axis says to which side the ball bends.
    """
    start, axis = club.measured.get("azimuth"), club.measured.get("spin_axis")
    if start is None:
        return
    if shape := club.shot_shape:
        yield note("player-start-and-curve", azimuth=start.median, curve=club.measured["curve"].median, shape=shape)
    elif axis is not None:
        yield note("player-start-and-spin-axis", azimuth=start.median, spin_axis=axis.median)
    else:
        yield note("player-start", azimuth=start.median)
    angles, margins = {}, {}
    for name in ("face", "path"):
        if name in club.measured:
            angles[name] = club.measured[name].median
        elif club.inferred is not None:
            angles[name] = club.inferred.mean[name]
            margins[name] = 2.0 * club.inferred.doubt[name]
    if len(angles) < 2:
        return
    if margins:
        yield note("player-face-and-path-estimated", **angles, margins=margins)
    elif club.shots.face_at == CONTACT:
        yield note("player-face-and-path-at-contact", **angles)
    else:
        yield note("player-face-and-path", **angles)
    if club.start:
        yield note("player-start-causes", by_face=club.start["face"], by_path=club.start["path"])
    apart = angles["face"] - angles["path"]
    if abs(apart) > max([LEAST_ANGLE, *margins.values()]):
        yield note("player-face-to-path", face=apart)
    if club.closing and abs(club.closing["azimuth"]) >= LEAST_ANGLE:
        yield note("player-closing" if "closure" in club.measured else "player-closing-usual", **club.closing)


def strike_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield where the ball meets the face, measured, or estimated as far as the flight tells."""
    toe, high = (club.measured.get(name) for name in ("toe", "high"))
    if toe is not None and high is not None:
        yield note("player-strike", toe=toe.median, high=high.median)
    elif toe is not None:
        yield note("player-strike-toe", toe=toe.median)
    elif high is not None:
        yield note("player-strike-high", high=high.median)
    elif club.inferred is not None and (doubt := club.inferred.doubt["toe"]) < LEARNED:
        middle = club.inferred.mean["toe"]
        ends = {"low_toe": middle - 2.0 * doubt, "high_toe": middle + 2.0 * doubt}
        yield note("player-strike-estimated", toe=middle, **ends)
    if toe is not None and toe.shots >= ENOUGH:
        yield note("player-strike-toe-range", low_toe=toe.low, high_toe=toe.high)
    if high is not None and high.shots >= ENOUGH:
        yield note("player-strike-high-range", low_high=high.low, high_high=high.high)


def what_if_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield what a change does to the typical shot, all else the same."""
    for each in club.changes:
        effects = {name: each.launch[name] for name in ("ball_speed", "launch", "backspin")} | {"carry": each.carry}
        yield note(f"player-change-{each.name}", **{f"step_{each.name}": each.step}, effects=effects, side=each.side)


def doubt_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield how sure the report is, and what limits it."""
    count = len(club.shots)
    carry = club.measured.get("carry")
    if carry is not None and carry.shots >= 2:
        yield note("player-carry-margin", shots=carry.shots, margin_carry=carry.margin)
    if count < FEW:
        yield note("player-few-shots", shots=count, more=FEW)
    elif count < ENOUGH:  # the median of four times as many shots is twice as sure
        yield note("player-more-shots", more=3 * count)
    inferred = club.inferred
    if inferred is not None and club.club is not None:
        if inferred.shots + inferred.refused < min(count, club.measured["launch"].measured) - int(club.mishit.sum()):
            yield note("player-delivery-of-some", shots=inferred.shots)
        if inferred.remarked:
            yield note("player-inconsistent-rows", rows=list(inferred.remarked))
        if inferred.refused:
            yield note("player-impossible-shots", shots=inferred.refused)
    elif club.club is None:
        yield note("player-no-model", club=club.name)
    if absent := not_measured([club]):
        yield note("player-not-measured", quantities=absent)


def not_measured(clubs: Iterable[ClubStatistics]) -> list[str]:
    """Return the labels of the club data that were measured of none of the clubs."""
    known = {name for each in clubs for name in each.measured}
    return [quantity(name).label for name in CLUB_DATA if name not in known]


def change_note(name: str, first: Statistic, last: Statistic) -> Note:
    """Return how a median changed, and how sure that is."""
    change, margin = last.median - first.median, difference_error(first, last)
    data: Mapping[str, Mapping[str, float]] = {"change": {name: change}, "margin": {name: margin}}
    is_sure = math.isfinite(margin) and abs(change) > margin
    return note("player-session-changed" if is_sure else "player-session-no-sure-change", **data)
