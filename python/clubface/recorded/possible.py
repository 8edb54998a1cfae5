"""Which values can have been measured at all: what lies beyond them is a sign for "not measured", or a slip.

Programs of launch monitors write many things where nothing was measured: the least whole number that they can hold, the
greatest, -999, a negative ratio. They do not publish which, so a value is judged by what a golf shot can be. The limits
are wide: they are no judgement of a player.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.recorded.club_names import club_kind
from clubface.simulation.spin import wrapped
from clubface.support.arrays import Floats
from clubface.tables.headings import shot_words
from clubface.units import SI_UNITS, display_unit, show, to_si

_SPEED = to_si(200.0, "mph")
"""The fastest clubs of long drive contests reach about 160 mph."""
_BALL_SPEED = 2.0 * _SPEED
"""A heavy body that hits a light one elastically sends it off at twice its own speed: nothing sends it off faster."""
_SPIN = to_si(20_000.0, "rpm")
"""A ball that rolls off the steepest wedge at 50 m/s without slipping turns with 14,000 rpm."""
_STILL = to_si(2.0, "rpm")
"""A ball with less spin was not measured: programs write 0 or -1 then."""
_RATE = to_si(36_000.0, "deg/s")
"""A club that goes round a hundred times a second; faces close at 1,000 to 4,000 deg/s."""
_FACE = to_si(150.0, "mm")
"""No face is wider than 127 mm, the limit of the rules, so that no point of it is so far from its centre."""
_FAR = to_si(600.0, "yd")
_RIGHT_ANGLE, _TURN = math.pi / 2, math.pi
_SOME = 1e-6
"""More than nothing [SI]: a club that hits moves, the ball moves then, and no ball leaves without any spin at all."""

NAMED = 3
"""Shots that a note names."""

RANGES: Mapping[str, tuple[float, float]] = {
    "speed": (_SOME, _SPEED),
    **dict.fromkeys(("attack", "path", "loft", "face", "lie", "launch", "azimuth"), (-_RIGHT_ANGLE, _RIGHT_ANGLE)),
    **dict.fromkeys(("toe", "high"), (-_FACE, _FACE)),
    **dict.fromkeys(("closure", "pitch_rate", "lie_rate"), (-_RATE, _RATE)),
    "ball_speed": (_SOME, _BALL_SPEED),
    "smash": (_SOME, 2.0),
    **dict.fromkeys(("backspin", "sidespin"), (-_SPIN, _SPIN)),
    "total_spin": (_SOME, _SPIN),
    "spin_axis": (-_TURN, _TURN),
    "landing_angle": (0.0, _RIGHT_ANGLE),
    **dict.fromkeys(("carry", "total", "apex"), (0.0, _FAR)),
    **dict.fromkeys(("side", "total_side"), (-_FAR, _FAR)),
    "flight_time": (0.0, 60.0),
    "landing_speed": (0.0, _BALL_SPEED),
}
"""The least and the greatest value [SI] that a shot can have of each quantity; others are not judged."""
TURNING = ("azimuth", "spin_axis")
"""Directions that some programs count through a whole turn: 352.5 degrees is -7.5."""


RATIOS: Mapping[str, float] = {"driver": 1.6, "wood": 1.6, "hybrid": 1.6, "iron": 1.55, "wedge": 1.4, "putter": 1.8}
"""The most that ball speed over club speed can be, by kind of club.

A head of mass M that is free sends a ball of mass m off at (1 + e) M / (M + m) cos(loft) times its own speed. A driver
(200 g, e up to 0.86 with the tolerance of the rules) makes 1.51, a long iron 1.48, a wedge that delivers 38 degrees
1.22, a putter (350 g, e 0.85) 1.64. On top come 5 to 10% for the errors of both speeds.
"""
MOST_RATIO, MOST_PUTTED = RATIOS["driver"], RATIOS["putter"]
PUTTED = 12.0
"""Ball speed [m/s] below which a club that is not named may be a putter."""


def can_be(name: str, values: Any) -> Any:
    """Tell which values [SI] of a quantity a golf shot can have; NaN, nothing measured, counts as one."""
    low, high = RANGES.get(name, (-math.inf, math.inf))
    return (
        ~((values < low) | (values > high)) if isinstance(values, np.ndarray) else not (values < low or values > high)
    )


def within_turn(name: str, values: Any) -> Any:
    """Return values [SI] of a quantity; directions that programs count from 0 to 360 degrees from -180 to 180."""
    return wrapped(values) if name in TURNING else values


class Cleaned(NamedTuple):
    """Columns without values that cannot be.

    Attributes
    ----------
    columns
        The columns, NaN where a value was taken out.
    emptied
        Which rows lost all that they had.
    notes
        What was taken out, with counts and an example.
    """

    columns: dict[str, Floats]
    emptied: NDArray[np.bool_]
    notes: tuple[str, ...]


def impossible(values: Mapping[str, float]) -> dict[str, float]:
    """Return which values [SI] of one shot cannot have been measured; see :func:`without_impossible`."""
    values = {name: float(within_turn(name, value)) for name, value in values.items()}
    still = abs(values.get("backspin", math.inf)) < _STILL and abs(values.get("sidespin", math.inf)) < _STILL
    spins = ("backspin", "sidespin") if still else ()
    return {name: value for name, value in values.items() if name in spins or not can_be(name, value)}


def shown(name: str, value: float, unit: str | None = None) -> str:
    """Return a value [SI] of a quantity as people read it, or in a unit."""
    if unit is not None:
        return show(value, unit)
    unit = display_unit(name, SI_UNITS[shot_words().dimensions[name]])
    return show(value, "mph" if unit == "m/s" else unit, 11)


def describe_impossible(name: str, wrong: int, shots: int, example: float) -> str:
    """Return how many shots have a value of a quantity that cannot be, and one such value [SI], in words."""
    return f"{name} in {wrong} of {shots} shots, such as {shown(name, example)}"


def note_of(every: Iterable[str]) -> str:
    """Return the note on values that cannot be, from what :func:`describe_impossible` says of each quantity."""
    return f"values that no shot can have were taken as not measured: {'; '.join(every)}"


def without_impossible(columns: Mapping[str, Floats]) -> Cleaned:
    """Return columns of shots [SI] without values that no golf shot can have, which count as not measured."""
    kept, found = {}, []
    columns = {name: within_turn(name, values) for name, values in columns.items()}
    wrong = {name: ~can_be(name, values) for name, values in columns.items()}
    if "backspin" in columns and "sidespin" in columns:
        still = (np.abs(columns["backspin"]) < _STILL) & (np.abs(columns["sidespin"]) < _STILL)
        wrong.update({name: wrong[name] | still for name in ("backspin", "sidespin")})
    for name, values in columns.items():
        kept[name] = np.where(wrong[name], np.nan, values) if wrong[name].any() else values
        if wrong[name].any():
            found.append(describe_impossible(name, int(wrong[name].sum()), values.size, float(values[wrong[name]][0])))
    had, has = (np.any([~np.isnan(each) for each in of.values()], axis=0) for of in (columns, kept))
    return Cleaned(kept, had & ~has, (note_of(found),) if found else ())


def without_contradictions(
    columns: Mapping[str, Floats], clubs: Any, lines: Sequence[int]
) -> tuple[dict[str, Floats], str | None]:
    """Return columns of shots [SI] without speeds that no club makes of each other, and a note on them.

    Where the ball is faster than the club can send it, either speed may be wrong, so that neither is taken as measured,
    and no smash factor.
    """
    if not {"speed", "ball_speed"} <= set(columns):
        return dict(columns), None
    speed, ball = columns["speed"], columns["ball_speed"]
    most = np.where(ball < PUTTED, MOST_PUTTED, MOST_RATIO)
    if clubs is not None:
        names, places = np.unique(np.asarray(clubs, dtype=str), return_inverse=True)
        kinds = [(club_kind(str(each)) or "").rpartition("-")[2] for each in names]
        by_name = np.array([RATIOS.get(each, math.nan) for each in kinds])[places]
        most = np.where(np.isnan(by_name), most, by_name)
    possible = can_be("speed", speed) & can_be("ball_speed", ball)
    wrong = np.flatnonzero(possible & (ball > most * speed))
    if not wrong.size:
        return dict(columns), None
    kept = dict(columns)
    for name in ("speed", "ball_speed", "smash"):
        if name in kept:
            kept[name] = kept[name].copy()
            kept[name][wrong] = math.nan
    pairs = [f"line {lines[each]}: {_mph(float(ball[each]))} from {_mph(float(speed[each]))}" for each in wrong[:NAMED]]
    one = wrong.size == 1
    return kept, (
        f"the ball is faster than the club can send it in {wrong.size} of {speed.size} shots ({'; '.join(pairs)}"
        f"{', ...' * (wrong.size > NAMED)}): both speeds of {'it' if one else 'them'} count as not measured"
    )


def _mph(value: float) -> str:
    return show(value, "mph", 4)
