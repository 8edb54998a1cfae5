"""Columns whose unit is most likely another one than the file, a mapping or a person says.

Values that no shot can have are the strongest sign of a wrong unit, and so are quantities that contradict each other in
most shots: a ball faster than any club can send it, a carry longer than any ball of that speed can fly. Where another
unit would make them those of golf, the column is refused, and the unit is named.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.recorded.possible import MOST_RATIO, can_be, shown
from clubface.support.arrays import Floats
from clubface.units import show, size, unit

FEWEST = 3
"""Shots in which two quantities must contradict each other."""
SMASH_DIFFERS = 0.1
"""Relative difference of a printed smash factor from that of the speeds, ten times what rounding does."""
IN_USE = {
    "speed": ("mph", "m/s", "km/h", "ft/s"),
    "angle": ("deg", "rad"),
    "length": ("yd", "m", "ft", "mm", "cm", "in"),
    "angular rate": ("rpm", "rad/s", "deg/s"),
    "dimensionless": ("1", "%"),
}
"""Units in which shots are written."""
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
"""Where golf shots lie [SI], most of them."""
_RATIO = (0.9, 1.55)
"""Ball speed over club speed of most shots."""
_GRAVITY = 9.81
_FURTHEST = 4.5
"""Seconds of its first speed that the carry of a ball lasts at most: those of long drive contests make 3.8."""
_CARRIES = (0.9, 4.0)
"""The same of most shots [s]."""


class Unit(NamedTuple):
    """The unit of a column.

    Attributes
    ----------
    heading
        Of the column.
    symbol
        Its unit.
    is_named
        Whether the file names it, so that the file is to be corrected and not the command.
    is_assumed
        Whether neither the file nor anyone says it: it is the one that the maker's program has when it is installed.
    """

    heading: str
    symbol: str
    is_named: bool
    is_assumed: bool = False


def wrong_unit(columns: Mapping[str, Floats], units: Mapping[str, Unit]) -> str | None:
    """Return what is wrong with the unit of a column and which it most likely is; None where all go together."""
    return next(_wrong(columns, units), None)


def _wrong(columns: Mapping[str, Floats], units: Mapping[str, Unit]) -> Iterator[str]:
    for name, of in units.items():
        values = columns[name][~np.isnan(columns[name])] if name in columns else np.empty(0)
        if of.is_assumed and name in ("speed", "ball_speed") and values.size:
            median = float(np.median(values))
            others = [each for each in _others(of) if _is_usual(name, np.array([median * each[1]]))[0]]
            if not _is_usual(name, np.array([median]))[0] and median > USUAL[name][1] and others:
                what = (
                    f"{name.replace('_', ' ')} is {shown(name, median, of.symbol)} in the median of {values.size} shots"
                )
                yield _message(what, [(name, of, others)])
        impossible = values[~can_be(name, values)]
        if name not in USUAL or 2 * impossible.size <= values.size:
            continue
        if others := [each for each in _others(of) if 2 * np.sum(_is_usual(name, values * each[1])) > values.size]:
            said = f"{name.replace('_', ' ')} is {shown(name, float(impossible[0]), of.symbol)} or another such value"
            what = f"{said} in {impossible.size} of {values.size} shots, which no shot can have"
            yield _message(what, [(name, of, others)])
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
        # Without air a ball flies v2/g at most; what lift adds for fast balls, drag more than takes.
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
    units: Mapping[str, Unit],
    message: str,
) -> Iterator[str]:
    """Yield what is wrong where most values are, and another unit of one of the quantities makes their median usual."""
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


def _others(current: Unit) -> list[tuple[str, float]]:
    """Return the other units of the dimension of a column, and by what values must be multiplied to be in them."""
    return [
        (each, size(each) / size(current.symbol))
        for each in IN_USE.get(unit(current.symbol).dimension, ())
        if each != current.symbol
    ]


def _is_usual(name: str, values: Floats) -> NDArray[np.bool_]:
    low, high = USUAL[name]
    return (values >= low) & (values <= high)


def _message(what: str, columns: list[tuple[str, Unit, list[tuple[str, float]]]]) -> str:
    likely = []
    for name, of, others in columns:
        symbols = " or ".join(each for each, _ in others)
        remedy = "correct its heading" if of.is_named else f"give --unit {name}={others[0][0]}"
        likely.append(f"the column {of.heading!r} is most likely in {symbols} and not in {of.symbol}: {remedy}")
    return f"{what}: {'; or '.join(likely)}"
