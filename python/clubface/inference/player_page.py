"""Notes of a player's report: on each club what a fitter would tell a customer, and the first page.

The first page gives the gaps of the bag, what stands out, what to practise and buy, and how sure that is. It uses
measured values only; carry and side count as measured if computed from a complete measured launch. Parts of the swing
are ranked for practice by the spread they cause: measured scatter times the derivative of impact and flight. A club is
recommended for a gap in the bag or for the loft of the longest club.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from clubface.inference.player_statistics import ClubStatistics
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.result import Result
from clubface.shots.formats import CONTACT
from clubface.shots.mishits import Statistic, difference_error
from clubface.shots.session_summary import ClubSummary
from clubface.units import to_si

TYPICAL = ("speed", "ball_speed", "launch", "total_spin")
"""Quantities of the typical shot, listed before carry and side."""
CLUB_DATA = ("speed", "attack", "path", "face", "toe", "high")
"""Club data that a report lists as missing if they were not measured."""
FEW, ENOUGH = 5, 10
"""Number of shots below which a median says little (with four, its 95% interval is two standard deviations either way),
and number from which the range of two in three shots is given."""
LEAST_ANGLE = to_si(0.3, "deg")
"""Minimum face-to-path angle, or effect of the closure rate, that is mentioned [rad]; assumed."""
LEARNED = to_si(4.0, "mm")
"""Maximum standard deviation of an estimated strike that is reported: half the spread of golfers of any skill."""
MOST_FINDINGS = 3
MOST_PRACTISED = 3
"""Maximum number of things to practise, as many as a golfer keeps in mind; assumed."""
NARROW = to_si(7.0, "yd")
"""Gap below which two clubs do the work of one. In the tour averages of 2019 and 2023 only a hybrid, or a wood in its
place, is this close to the next club (3 to 5 yd); all others are at least 8 yd apart."""
WIDE = 1.5
"""Ratio to the usual gap of the bag above which a gap is wide. Above the square root of two, a club in the middle makes
two gaps whose ratios are closer to the usual one; rounded up."""
LEAST_SIDE = to_si(5.0, "yd")
"""Minimum distance from the target line that is mentioned. It adds 0.6 to 1.2 yd to the root mean square side of the
built-in golfers, about what :data:`clubface.design.optimisation.advice.WORTH` counts as worth a change."""
LEAST_STRIKE = to_si(5.0, "mm")
"""Minimum distance of the strike from the middle that is mentioned: the step of the what-if, and more than the accuracy
of a monitor for one strike, 3 mm. It costs a 94 mph drive up to 2 yd of carry, enough to be worth a change."""
LEAST_SHARE = 0.4
"""Share of the spread above which a part of the swing is named as its cause. Without that part, the side of the
built-in golfers would spread 8%, 0.8 to 1.8 yd, less, about as much as is worth a change."""
FEWEST_GAPS = 2
"""Minimum number of gaps of a bag; a single gap cannot be called wide or narrow."""


def typical_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield notes on the typical shot: its measured start, and where it finishes."""
    shots = len(club.shots) - int(club.mishit.sum())
    if figures := {name: club.measured[name].median for name in TYPICAL if name in club.measured}:
        yield note("player-typical-shot", shots=shots, figures=figures)
    for name in ("carry", "side"):
        if each := club.measured.get(name):
            # A range, a standard deviation, or neither.
            suffix = "" if each.shots >= ENOUGH else "-few" if each.shots > 1 else "-alone"
            data = {
                name: each.median,
                f"low_{name}": each.low,
                f"high_{name}": each.high,
                f"spread_{name}": each.spread,
            }
            yield note(f"player-{name}{suffix}", **data)


def mishit_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield a note on each mishit, with its row in the file and the values that are far off."""
    for place in dict.fromkeys(each.place for each in club.mishits):
        reasons = [each for each in club.mishits if each.place == place]
        yield note(
            "player-mishit", place=club.shots.row_word, row=int(club.shots.rows[place]),
            figures={each.quantity: each.value for each in reasons},
            usual={each.quantity: each.median for each in reasons},
        )  # fmt: skip


def line_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield notes on start and curve of the ball, with face and path.

    Without carry and side the curve is unknown, and the tilt of the spin axis gives its direction.
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
    """Yield notes on the impact point, measured, or estimated if the flight determines it."""
    strike = {name: club.measured[name] for name in ("toe", "high") if name in club.measured}
    if strike:
        code = "player-strike" if len(strike) == 2 else f"player-strike-{min(strike)}"
        yield note(code, **{name: each.median for name, each in strike.items()})
    elif club.inferred is not None and (doubt := club.inferred.doubt["toe"]) < LEARNED:
        middle = club.inferred.mean["toe"]
        ends = {"low_toe": middle - 2.0 * doubt, "high_toe": middle + 2.0 * doubt}
        yield note("player-strike-estimated", toe=middle, **ends)
    for name, each in strike.items():
        if each.shots >= ENOUGH:
            yield note(f"player-strike-{name}-range", **{f"low_{name}": each.low, f"high_{name}": each.high})


def what_if_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield notes on the effect of single changes on the typical shot."""
    for each in club.changes:
        effects = {name: each.launch[name] for name in ("ball_speed", "launch", "backspin")} | {"carry": each.carry}
        yield note(f"player-change-{each.name}", **{f"step_{each.name}": each.step}, effects=effects, side=each.side)


def doubt_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield notes on how sure the report is, and what limits it."""
    count = len(club.shots)
    carry = club.measured.get("carry")
    if carry is not None and carry.shots >= 2:
        yield note("player-carry-margin", shots=carry.shots, margin_carry=carry.margin)
    if count < FEW:
        yield note("player-few-shots", shots=count, more=FEW)
    elif count < ENOUGH:  # the median of four times as many shots is twice as certain
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
    """Return the labels of the club data that were measured for none of the clubs."""
    known = {name for each in clubs for name in each.measured}
    return [quantity(name).label for name in CLUB_DATA if name not in known]


def change_note(name: str, first: Statistic, last: Statistic) -> Note:
    """Return the note on the change of a median and how sure it is."""
    change, margin = last.median - first.median, difference_error(first, last)
    data: Mapping[str, Mapping[str, float]] = {"change": {name: change}, "margin": {name: margin}}
    is_sure = math.isfinite(margin) and abs(change) > margin
    return note("player-session-changed" if is_sure else "player-session-no-sure-change", **data)


class _Finding(NamedTuple):
    """A note and its importance [m]."""

    weight: float
    note: Note


LoftNotes = Callable[[ClubStatistics], Iterable[Note]]
"""Function that returns notes on the benefit of another loft for a club."""


def page_parts(
    clubs: Sequence[ClubStatistics], bag: Sequence[ClubSummary], loft_notes: LoftNotes | None = None
) -> tuple[Result, ...]:
    """Return the parts of the first page: findings, practice, clubs to buy, and how sure all of it is.

    ``bag`` holds the clubs of one player with their gaps, longest first. ``loft_notes`` assesses the loft of the
    driver; without it, lofts are not assessed.
    """
    findings = _findings(clubs, bag)
    heading = {1: "One finding", 2: "Two findings", MOST_FINDINGS: "Three findings"}.get(len(findings), "Findings")
    is_enough = max(len(each.shots) for each in clubs) >= FEW
    nothing = note("player-all-alike") if is_enough else note("player-too-few-shots", least=FEW)
    parts = [
        ("findings", heading, findings or [nothing]),
        ("practice", "Worth practising", list(_practice(clubs))),
        ("purchases", "Worth buying", list(_purchases(clubs, bag, loft_notes))),
        ("confidence", "How sure this is", list(_confidence(clubs))),
    ]
    return tuple(Result(kind, title, notes=tuple(notes)) for kind, title, notes in parts)


def _findings(clubs: Sequence[ClubStatistics], bag: Sequence[ClubSummary]) -> list[Note]:
    """Return the findings that matter most, at most three of different kinds."""
    best: dict[str, _Finding] = {}
    for each in (*_gap_findings(bag), *(one for club in clubs for one in _club_findings(club))):
        if each.note.code not in best or each.weight > best[each.note.code].weight:
            best[each.note.code] = each
    if len(clubs) < 2:  # with one club, no comparison of scatter between clubs is possible
        best.pop("player-finding-side-spread", None)
    ranked = sorted(best.values(), key=lambda each: -each.weight)
    return [each.note for each in ranked[:MOST_FINDINGS]]


def _gap_findings(bag: Sequence[ClubSummary]) -> Iterator[_Finding]:
    for each in _gaps(bag):
        if each.is_wide:
            yield _Finding(each.gap - each.usual, note("player-finding-gap-wide", **each.data, usual_carry=each.usual))
        elif each.is_narrow:
            carry, less = (club.spreads["carry"].median for club in (each.longer, each.shorter))
            overlap = note("player-finding-gap-overlap", **each.data, carry=carry, shorter_carry=less)
            yield _Finding(each.usual - each.gap, overlap)


class _Gap(NamedTuple):
    """The gap between the median carries of neighbours [m], half of its 95% interval, and the usual gap of the bag."""

    longer: ClubSummary
    shorter: ClubSummary
    gap: float
    margin: float
    usual: float

    @property
    def is_wide(self) -> bool:
        """Whether the gap is surely wider than usual in the bag."""
        return self.gap - self.margin > WIDE * self.usual

    @property
    def is_narrow(self) -> bool:
        """Whether the gap is narrow, and surely narrower than usual."""
        return self.gap < NARROW and self.gap + self.margin < self.usual

    @property
    def data(self) -> dict[str, Any]:
        """Clubs and gap as data of a note."""
        return {"longer": self.longer.club, "shorter": self.shorter.club, "gap_carry": self.gap}


def _gaps(bag: Sequence[ClubSummary]) -> list[_Gap]:
    """Return the gaps between clubs with enough shots, or none if there are too few for a usual gap."""
    gaps = [
        (longer, shorter, longer.gap.length, 2.0 * longer.gap.error)
        for longer, shorter in pairwise(bag)
        if longer.gap is not None and min(each.spreads["carry"].shots for each in (longer, shorter)) >= FEW
    ]
    if len(gaps) < FEWEST_GAPS:
        return []
    usual = float(np.median([gap for _, _, gap, _ in gaps]))
    return [_Gap(*each, usual) for each in gaps]


def _club_findings(club: ClubStatistics) -> Iterator[_Finding]:
    """Yield findings on one club; none if there are too few shots for a median."""
    carry, side = (club.measured.get(name) for name in ("carry", "side"))
    if side is not None and side.shots >= FEW:
        margin = side.margin
        if abs(side.median) > max(LEAST_SIDE, margin):
            low, high = side.median - margin, side.median + margin
            remark = note("player-finding-side", club=club.name, side=side.median, low_side=low, high_side=high)
            yield _Finding(abs(side.median), remark)
        if carry is not None:
            data = {"low_side": side.low, "high_side": side.high}
            # The angle times a carry of 200 yards, so that clubs of different lengths compare.
            weight = side.spread / carry.median * to_si(200.0, "yd")
            yield _Finding(weight, note("player-finding-side-spread", club=club.name, **data))
    if carry is not None and carry.shots >= FEW:
        data = {"low_carry": carry.low, "high_carry": carry.high}
        yield _Finding(carry.spread, note("player-finding-carry-spread", club=club.name, **data))
        if club.mishits:
            lost = carry.usual_mean - carry.mean
            yield _Finding(lost, note("player-finding-mishits", **_mishit_data(club), lost_carry=lost))
    for name in ("toe", "high"):
        strike = club.measured.get(name)
        if strike is None or strike.shots < FEW or abs(strike.median) <= max(LEAST_STRIKE, strike.margin):
            continue
        effect = next((each for each in club.changes if each.name == name), None)
        weight = 0.0 if effect is None else abs(strike.median / effect.step) * math.hypot(effect.carry, effect.side)
        yield _Finding(weight, note(f"player-finding-strike-{name}", club=club.name, **{name: strike.median}))


def _practice(clubs: Sequence[ClubStatistics]) -> Iterator[Note]:
    """Yield notes on the parts of the swing whose measured scatter spreads the shots, most costly first."""
    causes = sorted((each for club in clubs for each in _causes(club)), key=lambda each: -each.weight)
    notes: list[Note] = []
    for each in causes:
        if all(one.code != each.note.code for one in notes):
            notes.append(each.note)
    yield from notes[:MOST_PRACTISED]
    if not any(effect.name in each.measured for each in clubs for effect in each.changes):
        yield note("player-practise-unknown")
    elif not notes:
        yield note("player-practise-nothing")


def _causes(club: ClubStatistics) -> Iterator[_Finding]:
    """Yield the measured causes of the spread of a club's shots, each with its contribution [m]."""
    for direction in ("side", "carry"):
        whole = club.measured.get(direction)
        if whole is None or whole.shots < FEW:
            continue
        parts = [
            (abs(getattr(each, direction) / each.step) * measured.spread, each.name, measured)
            for each in club.changes
            if (measured := club.measured.get(each.name)) is not None and measured.shots >= FEW
        ]
        size, name, measured = max(parts, default=(0.0, "", None), key=lambda each: each[0])
        if measured is not None and size > LEAST_SHARE * whole.spread:
            data = {f"part_{direction}": size, f"spread_{direction}": whole.spread, "spread": {name: measured.spread}}
            code, label = f"player-practise-{direction}", quantity(name).label
            yield _Finding(size, note(code, club=club.name, quantity=label, **data))
        elif direction == "side" and not parts:
            yield from _start_cause(club, whole)
    if club.mishits and (carry := club.measured.get("carry")):
        lost = carry.usual_mean - carry.mean
        yield _Finding(lost, note("player-practise-mishits", **_mishit_data(club), lost_carry=lost))


def _mishit_data(club: ClubStatistics) -> dict[str, Any]:
    return {"club": club.name, "mishits": int(club.mishit.sum()), "shots": len(club.shots)}


def _start_cause(club: ClubStatistics, side: Statistic) -> Iterator[_Finding]:
    """Yield the contribution of the start direction to the side, if no club data explain it."""
    start, carry = club.measured.get("azimuth"), club.measured.get("carry")
    if start is None or carry is None or start.shots < FEW:
        return
    size = carry.median * math.tan(start.spread)
    if size > LEAST_SHARE * side.spread:
        data = {"spread_azimuth": start.spread, "part_side": size, "spread_side": side.spread}
        yield _Finding(size, note("player-practise-start", club=club.name, **data))


def _purchases(
    clubs: Sequence[ClubStatistics], bag: Sequence[ClubSummary], loft_notes: LoftNotes | None
) -> Iterator[Note]:
    """Yield notes on clubs to buy, on the loft of the driver, and on what was not assessed."""
    gaps = _gaps(bag)
    wide, narrow = [each for each in gaps if each.is_wide], [each for each in gaps if each.is_narrow]
    for each in wide:
        middle = 0.5 * (each.longer.spreads["carry"].median + each.shorter.spreads["carry"].median)
        yield note("player-buy-gap", **each.data, carry=middle)
    for each in narrow:
        yield note("player-buy-one-of-two", **each.data)
    if not wide and not narrow:
        yield note("player-buy-nothing")
    longest = next((each for each in clubs if any(one.name == "loft" for one in each.changes)), None)
    if loft_notes and longest is not None and longest.club is not None and longest.club.name == "driver":
        yield from loft_notes(longest)
    yield note("player-heads-not-judged")


def _confidence(clubs: Sequence[ClubStatistics]) -> Iterator[Note]:
    """Yield notes on how sure the page is: margins of carries, few shots, computed or missing values."""
    carries = [each.measured["carry"] for each in clubs if "carry" in each.measured]
    repeated = [each for each in carries if each.shots > 1]
    margins = [each.margin for each in repeated]
    if len(repeated) == 1:
        yield note("player-carry-margin", shots=repeated[0].shots, margin_carry=margins[0])
    elif margins:
        yield note("player-carry-margins", least_carry=min(margins), most_carry=max(margins))
    if any(each.computed for each in clubs):
        yield note("player-carry-computed")
    if not carries:
        yield note("player-no-carry")
    fewest = min(len(each.shots) for each in clubs)
    if fewest < FEW:
        yield note("player-few-shots", shots=fewest, more=FEW)
    if mishits := sum(int(each.mishit.sum()) for each in clubs):
        yield note("player-mishits-left-out", mishits=mishits)
    if absent := not_measured(clubs):
        yield note("player-not-measured", quantities=absent)
    if any(each.changes for each in clubs):
        yield note("player-model-standard")
