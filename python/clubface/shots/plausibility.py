"""Plausibility of measured values: an impossible one means "not measured" or is an error.

Launch monitor programs write undocumented placeholders for missing values (the smallest or largest integer, -999, a
negative ratio), so values are judged by what a golf shot can have, with limits wide enough for any player.

Impossible values are the strongest sign of a wrong unit. So are quantities that contradict each other in most shots: a
ball faster than any club can hit it, or a carry longer than any ball of that speed can fly. If another unit would give
plausible values, the column is refused and the unit is named.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.quantities import display_unit
from clubface.results.notes import Note, note
from clubface.shots.club_names import club_kind
from clubface.shots.tables.headings import FACE_TO_PATH, FileColumn, shot_words
from clubface.simulation.spin import wrapped
from clubface.support.arrays import Floats
from clubface.units import SI_UNITS, show, size, to_si, unit

_SPEED = to_si(200.0, "mph")
"""Upper limit of club speed; long drive contests reach about 160 mph."""
_BALL_SPEED = 2.0 * _SPEED
"""Upper limit of ball speed: an elastic collision with a very heavy body gives twice its speed."""
_SPIN = to_si(20_000.0, "rpm")
"""Upper limit of spin; a ball rolling off the most lofted wedge at 50 m/s without slip has 14,000 rpm."""
_STILL = to_si(2.0, "rpm")
"""Spin below this means not measured; programs write 0 or -1 then."""
_RATE = to_si(36_000.0, "deg/s")
"""Upper limit of rotation rates, a hundred turns per second; faces close at 1,000 to 4,000 deg/s."""
_FACE = to_si(150.0, "mm")
"""Upper limit of impact offsets; the rules limit the width of a head to 127 mm."""
_FAR = to_si(600.0, "yd")
_RIGHT_ANGLE, _TURN = math.pi / 2, math.pi
_SOME = 1e-6
"""Lower limit [SI] of quantities that must be positive: club speed, ball speed, total spin."""

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
"""Possible range of each quantity [SI]; others are not judged."""
TURNING = ("azimuth", "spin_axis")
"""Directions that some programs give from 0 to 360 degrees: 352.5 degrees is -7.5."""
RATIOS: Mapping[str, float] = {"driver": 1.6, "wood": 1.6, "hybrid": 1.6, "iron": 1.55, "wedge": 1.4, "putter": 1.8}
"""Largest possible smash factor, by kind of club: (1 + e) M / (M + m) cos(loft) for a free head of mass M, 1.51 for a
driver (200 g, e up to 0.86 with the tolerance of the rules), 1.48 for a long iron, 1.22 for a wedge delivered with 38
degrees, 1.64 for a putter (350 g, e 0.85), plus 5 to 10% for the errors of both speeds."""
MOST_RATIO, MOST_PUTTED = RATIOS["driver"], RATIOS["putter"]
PUTTED = 12.0
"""Ball speed [m/s] below which an unnamed club may be a putter."""


def can_be(name: str, values: Any) -> Any:
    """Return whether values [SI] of a quantity are possible in a golf shot; NaN counts as possible."""
    low, high = RANGES.get(name, (-math.inf, math.inf))
    return ((values >= low) & (values <= high)) | (values != values)


def within_turn(name: str, values: Any) -> Any:
    """Return values [SI] of a quantity, with directions wrapped to -180 to 180 degrees."""
    return wrapped(values) if name in TURNING else values


def impossible(values: Mapping[str, float]) -> dict[str, float]:
    """Return the impossible values [SI] of one shot; see :func:`without_impossible`."""
    values = {name: float(within_turn(name, value)) for name, value in values.items()}
    still = abs(values.get("backspin", math.inf)) < _STILL and abs(values.get("sidespin", math.inf)) < _STILL
    spins = ("backspin", "sidespin") if still else ()
    return {name: value for name, value in values.items() if name in spins or not can_be(name, value)}


def shown(name: str, value: float, unit: str | None = None) -> str:
    """Return a value [SI] of a quantity as text in its usual unit, or in ``unit``."""
    if unit is not None:
        return show(value, unit)
    unit = display_unit(name, SI_UNITS[shot_words().dimensions[name]])
    return show(value, "mph" if unit == "m/s" else unit, 11)


def impossible_note(name: str, wrong: int, shots: int, example: float) -> Note:
    """Return the note on a quantity with impossible values in some shots, such as ``example`` [SI]."""
    return note("impossible-values", example={name: example}, wrong=wrong, shots=shots)


def without_impossible(columns: Mapping[str, Floats]) -> tuple[dict[str, Floats], list[Note]]:
    """Return columns of shots [SI] with NaN for impossible values, and a note on each such column."""
    kept, notes = {name: within_turn(name, values) for name, values in columns.items()}, []
    wrong = {name: ~can_be(name, values) for name, values in kept.items()}
    if "backspin" in kept and "sidespin" in kept:
        still = (np.abs(kept["backspin"]) < _STILL) & (np.abs(kept["sidespin"]) < _STILL)
        wrong.update({name: wrong[name] | still for name in ("backspin", "sidespin")})
    for name, places in wrong.items():
        if places.any():
            values = kept[name]
            notes.append(impossible_note(name, int(places.sum()), values.size, float(values[places][0])))
            kept[name] = np.where(places, np.nan, values)
    return kept, notes


def without_contradictions(
    columns: Mapping[str, Floats], clubs: Any, lines: Sequence[int]
) -> tuple[dict[str, Floats], Note | None]:
    """Return columns of shots [SI] without club and ball speeds that contradict each other, and a note on them.

    If the ball is faster than the club can hit it, either speed may be wrong, so both are dropped, with the smash
    factor.
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
    for name in {"speed", "ball_speed", "smash"} & set(kept):
        kept[name] = kept[name].copy()
        kept[name][wrong] = math.nan
    example = {"ball_speed": float(ball[wrong[0]]), "speed": float(speed[wrong[0]])}
    at = [lines[each] for each in wrong.tolist()]
    return kept, note("faster-than-club", wrong=int(wrong.size), shots=int(speed.size), lines=at, example=example)


FEWEST = 3
"""Minimum number of shots for comparing two quantities."""
SMASH_DIFFERS = 0.1
"""Relative difference between printed and computed smash factor that shows an error, ten times that of rounding."""
IN_USE = {
    "speed": ("mph", "m/s", "km/h", "ft/s"),
    "angle": ("deg", "rad"),
    "length": ("yd", "m", "ft", "mm", "cm", "in"),
    "angular rate": ("rpm", "rad/s", "deg/s"),
    "dimensionless": ("1", "%"),
}
"""Units used in files of shots."""
_DEG, _YD, _RPM = (size(symbol) for symbol in ("deg", "yd", "rpm"))
USUAL: Mapping[str, tuple[float, float]] = {
    "speed": (8.0, 65.0),
    "ball_speed": (8.0, 95.0),
    "smash": (0.8, 1.6),
    "launch": (1.0 * _DEG, 60.0 * _DEG),
    "loft": (3.0 * _DEG, 65.0 * _DEG),
    **dict.fromkeys(("attack", "path", "face", "azimuth", "lie"), (-25.0 * _DEG, 25.0 * _DEG)),
    "spin_axis": (-60.0 * _DEG, 60.0 * _DEG),
    "landing_angle": (5.0 * _DEG, 80.0 * _DEG),
    **dict.fromkeys(("toe", "high"), (-0.06, 0.06)),
    "closure": (-100.0, 100.0),
    **dict.fromkeys(("backspin", "total_spin"), (300.0 * _RPM, 13_000.0 * _RPM)),
    "sidespin": (-4_000.0 * _RPM, 4_000.0 * _RPM),
    **dict.fromkeys(("carry", "total"), (5.0 * _YD, 400.0 * _YD)),
    **dict.fromkeys(("side", "total_side"), (-100.0 * _YD, 100.0 * _YD)),
    "apex": (1.0, 80.0),
}
"""Range of most golf shots [SI]."""
_RATIO = (0.9, 1.55)
"""Range of the smash factor in most shots."""
_GRAVITY = 9.81
_FURTHEST = 4.5
"""Upper limit of carry over initial ball speed [s]; long drive contests reach 3.8."""
_CARRIES = (0.9, 4.0)
"""Range of carry over ball speed in most shots [s]."""


def wrong_unit(columns: Mapping[str, Floats], units: Mapping[str, FileColumn]) -> str | None:
    """Return what is wrong with a column's unit and which unit is more likely; None if all units fit."""
    return next(_wrong(columns, units), None)


def _wrong(columns: Mapping[str, Floats], units: Mapping[str, FileColumn]) -> Iterator[str]:
    for name, column in units.items():
        values = columns[name][~np.isnan(columns[name])] if name in columns else np.empty(0)
        impossible, words = values[~can_be(name, values)], name.replace("_", " ")
        if name not in USUAL or not values.size:
            continue
        median = float(np.median(values))
        if column.is_assumed and name in ("speed", "ball_speed") and median > USUAL[name][1]:
            what = f"{words} is {shown(name, median, column.unit)} in the median of {values.size} shots"
            if others := [each for each in _others(column) if _is_usual(name, median * each[1])]:
                yield _message(what, [(name, column, others)])
        if 2 * impossible.size <= values.size:
            continue
        if others := [each for each in _others(column) if 2 * np.sum(_is_usual(name, values * each[1])) > values.size]:
            such = f"{words} is {shown(name, float(impossible[0]), column.unit)} or another such value"
            what = f"{such} in {impossible.size} of {values.size} shots, which no shot can have"
            yield _message(what, [(name, column, others)])
    if {"speed", "ball_speed"} <= set(columns):
        speed, ball = columns["speed"], columns["ball_speed"]
        ratio = np.full(len(speed), math.nan)
        np.divide(ball, speed, out=ratio, where=speed > 0.0)
        if "smash" in columns:
            yield from _contradiction(
                ratio / np.where(columns["smash"] > 0.0, columns["smash"], math.nan),
                lambda each: abs(each - 1.0) > SMASH_DIFFERS, (0.97, 1.03), {"ball_speed": 1, "speed": -1}, units,
                "ball speed over club speed is {:.3g} times the smash factor",
            )  # fmt: skip
        yield from _contradiction(
            ratio, lambda each: each > MOST_RATIO, _RATIO, {"ball_speed": 1, "speed": -1}, units,
            "ball speed is {:.3g} times club speed, which no club does,",
        )  # fmt: skip
    if {"carry", "ball_speed"} <= set(columns):
        ball = np.where(columns["ball_speed"] > 0.0, columns["ball_speed"], math.nan)
        # Without air the largest range is v2/g; for fast balls drag takes more than lift adds.
        furthest = np.minimum(1.3 * ball**2 / _GRAVITY, _FURTHEST * ball)
        typical = float(np.nanmedian(ball)) if np.isfinite(ball).any() else math.nan
        yield from _contradiction(
            np.where(columns["carry"] > furthest, columns["carry"] / ball, np.where(np.isnan(ball), math.nan, 0.0)),
            lambda each: each > 0.0, _CARRIES, {"carry": 1, "ball_speed": -1}, units,
            f"carry is {{:.3g}} s times ball speed ({show(typical, 'mph', 4)}), which no flight does,",
        )  # fmt: skip


def _contradiction(
    values: Floats,
    is_wrong: Callable[[float], bool],
    usual: tuple[float, float],
    powers: Mapping[str, int],
    units: Mapping[str, FileColumn],
    message: str,
) -> Iterator[str]:
    """Yield what is wrong if the median is, and another unit of one of the quantities would make it usual."""
    known = values[np.isfinite(values)]
    if known.size < FEWEST:
        return
    median = float(np.median(known))
    if not is_wrong(median):
        return
    columns = []
    for name, power in powers.items():
        if name in units:
            others = [each for each in _others(units[name]) if usual[0] <= median * each[1] ** power <= usual[1]]
            if others:
                columns.append((name, units[name], others))
    if columns:
        yield _message(f"{message.format(median)} in the median of {known.size} shots", columns)


def _others(current: FileColumn) -> list[tuple[str, float]]:
    """Return other units of a column's dimension, and the factor by which its values change with each."""
    return [
        (each, size(each) / size(current.unit))
        for each in IN_USE.get(unit(current.unit).dimension, ())
        if each != current.unit
    ]


def _is_usual(name: str, values: Any) -> Any:
    low, high = USUAL[name]
    return (values >= low) & (values <= high)


def _message(what: str, columns: list[tuple[str, FileColumn, list[tuple[str, float]]]]) -> str:
    likely = []
    for name, column, others in columns:
        symbols = " or ".join(each for each, _ in others)
        remedy = "correct its heading" if column.is_named else f"give --unit {name}={others[0][0]}"
        likely.append(f"the column {column.heading!r} is most likely in {symbols} and not in {column.unit}: {remedy}")
    return f"{what}: {'; or '.join(likely)}"


SENTINELS = (
    999.0, 999.9, 9999.0, 9999.9, 99999.0, 32767.0, 32768.0, 65535.0, 65536.0, 8388607.0, 16777215.0, 16777216.0,
    2147483647.0, 2147483648.0, 4294967295.0,
)  # fmt: skip
"""Placeholders, with either sign: largest and smallest numbers of so many digits or bits."""
NEVER = {"sidespin": 9000.0, "closure": 9000.0, "backspin": 9000.0}
"""Size [rpm, deg/s] from which a sentinel within the limits is not a measurement; backspin only if negative."""
ROUNDING = to_si(1.6, "deg")
"""Tolerance between three angles rounded to whole degrees."""


def without_sentinels(
    columns: Mapping[str, Floats], units: Mapping[str, FileColumn]
) -> tuple[dict[str, Floats], list[Note]]:
    """Return columns [SI] without sentinels that could pass for measurements, and a note on each.

    Impossible sentinels are left to :func:`without_impossible`.
    """
    kept, notes = dict(columns), []
    for name in (each for each in (*NEVER, FACE_TO_PATH) if each in columns and each in units):
        values, symbol = columns[name], units[name].unit
        written = values / size(symbol)
        if name == FACE_TO_PATH:
            is_none = ~can_be("face", values)
        else:
            is_none = _are_sentinels(written) & ((-written if name == "backspin" else np.abs(written)) >= NEVER[name])
        if is_none.any():
            kept[name] = np.where(is_none, np.nan, values)
            notes.append(note("placeholders-for-nothing", column=units[name].heading, wrong=int(is_none.sum()),
                              shots=values.size, value=float(written[is_none][0]), unit=symbol))  # fmt: skip
    return kept, notes


def without_any_sentinels(columns: Mapping[str, Floats], units: Mapping[str, FileColumn]) -> dict[str, Floats]:
    """Return columns [SI] without impossible sentinels, which say nothing about the unit."""
    sizes = {name: size(column.unit) for name, column in units.items() if name in columns}
    return dict(columns) | {
        name: np.where(_are_sentinels(columns[name] / each) & ~can_be(name, columns[name]), np.nan, columns[name])
        for name, each in sizes.items()
    }


def _are_sentinels(written: Floats) -> NDArray[np.bool_]:
    return np.isin(np.abs(written).round(3), SENTINELS)


def with_face_and_path(columns: Mapping[str, Floats], lines: list[int]) -> tuple[dict[str, Floats], Note | None]:
    """Return columns [SI] with face to path replaced by face angle and path, and a note on contradictions.

    It supplies a missing face angle from the path, or a missing path from the face angle. If all three were measured
    and disagree, face angle and path stay.
    """
    completed = dict(columns)
    if FACE_TO_PATH not in completed:
        return completed, None
    to_path = completed.pop(FACE_TO_PATH)
    nothing = np.full_like(to_path, np.nan)
    face, path = completed.get("face", nothing), completed.get("path", nothing)
    apart = np.abs(face - path - to_path) > ROUNDING
    for name, values, other in (("face", face, path + to_path), ("path", path, face - to_path)):
        filled = np.where(np.isnan(values), other, values)
        if not np.isnan(filled).all():
            completed[name] = filled
    if not apart.any():
        return completed, None
    first = int(np.flatnonzero(apart)[0])
    values = {"face": float(face[first]), "path": float(path[first]), FACE_TO_PATH: float(to_path[first])}
    return completed, note(
        "face-and-path-contradict", wrong=int(apart.sum()), shots=int(apart.size), line=lines[first], values=values
    )
