"""Spin as one vector: backspin, sidespin, total spin and spin axis, the unknown ones computed from the known ones.

A launch monitor sees no spin about the launch direction, so the vector has two components:

    total spin = sqrt(backspin^2 + sidespin^2),  spin axis = atan2(sidespin, backspin).

Any two of the four determine the others, except that total spin with backspin does not give the sign of the sidespin,
and total spin with sidespin assumes that the ball is not topped. What cannot be determined stays unknown; nothing is
assumed to be zero here.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.errors import InputError, Wording
from clubface.results.notes import Note, entry_text, note
from clubface.support.arrays import Floats
from clubface.units import show, size

SPINS = BACK, SIDE, TOTAL, AXIS = "backspin", "sidespin", "total_spin", "spin_axis"
DIMENSIONS = {BACK: "angular rate", SIDE: "angular rate", TOTAL: "angular rate", AXIS: "angle"}
UNITS = {BACK: "rpm", SIDE: "rpm", TOTAL: "rpm", AXIS: "deg"}
"""Units used by launch monitors."""
STEPS = {"rpm": (10.0, 1.0), "deg": (1.0, 0.1)}
"""Rounding steps of monitors, coarsest first; values on none of them count as rounded to the last."""
WEAKEST = 0.25
"""Maximum relative error of a derived value: a sidespin of 30 rpm at a spin axis of 1 degree does not determine the
backspin."""
ALONG = 0.02
"""Relative excess of total spin allowed over that of backspin and sidespin. Some totals include the spin about the
launch direction, as that of :class:`Launch` does; for drives struck 20 mm off centre this is up to 0.04."""
CLEARLY = 0.5
"""Margin, in units of their rounding, by which three spins must agree better than others to overrule the fourth."""
VECTOR = "total_spin^2 = backspin^2 + sidespin^2 and spin_axis = atan2(sidespin, backspin)"
LISTED = 3
"""Maximum number of contradictions with a note each."""


class Contradiction(NamedTuple):
    """Contradicting spins of one shot."""

    place: int  # index of the shot, from 0
    given: Mapping[str, float]  # the given values [rad/s, rad]
    kept: tuple[str, ...]  # names of the values that are kept

    @property
    def note(self) -> Note:
        """The note on the contradicting values and those that are kept."""
        if not self.kept:
            return note("spins-contradict-none-kept", spins=dict(self.given))
        return note("spins-contradict", spins=dict(self.given), kept=[name.replace("_", " ") for name in self.kept])


class Spins(NamedTuple):
    """Completed spins of shots."""

    values: dict[str, Floats]  # each of the four that is known for any shot [rad/s, rad]; NaN where unknown
    contradictions: tuple[Contradiction, ...]  # in the order of the shots
    notes: tuple[Note, ...]  # on shots assumed not to be topped, and on shots whose direction stays unknown


def wrapped(angle: Any) -> Any:
    """Wrap angles of up to a whole turn to (-180, 180] degrees [rad]; larger ones are invalid and left unchanged."""
    turn = 2.0 * math.pi
    beyond = np.where(angle > math.pi, angle - turn, np.where(angle <= -math.pi, angle + turn, angle))
    return np.where(np.abs(angle) <= turn, beyond, angle)


def complete(given: Mapping[str, Any]) -> Spins:
    """Complete the given spins: compute every spin that they determine, as arrays over the shots.

    Given values are kept unless they contradict others beyond rounding. If three of four agree clearly better than any
    other three, the fourth is dropped. Otherwise, and for three values, total spin and spin axis are kept if both are
    given, else backspin and sidespin, and values that contradict them are dropped. Of two contradicting values, such as
    a total spin below the backspin, neither is kept; a negative total spin is dropped. The spins, some of ``SPINS``
    [rad/s, rad], are arrays of equal length; NaN means unknown.
    """
    arrays = {name: np.asarray(given[name], dtype=np.float64) for name in SPINS if name in given}
    count = len(next(iter(arrays.values()))) if arrays else 0
    completed = {name: arrays[name].copy() if name in arrays else np.full(count, np.nan) for name in SPINS}
    completed[AXIS] = wrapped(completed[AXIS])
    contradictions = _settle(completed)
    lifting = _follow(completed)
    alone = ~np.isnan(completed[TOTAL]) & np.isnan(completed[AXIS])
    notes = [*([note("spin-not-topped")] if lifting.any() else []),
             *([note("spin-direction-unknown")] if alone.any() else [])]  # fmt: skip
    kept = {name: values for name, values in completed.items() if name in given or not np.isnan(values).all()}
    return Spins(kept, contradictions, tuple(notes))


def agreeing(given: Mapping[str, Any]) -> Spins:
    """Complete spins as :func:`complete` does, but raise InputError if they contradict each other."""
    spins = complete(given)
    for first in spins.contradictions:
        words = " and ".join(map(entry_text, first.given, first.given.values()))
        at = f"shot {first.place}: " if len(given[next(iter(first.given))]) > 1 else ""
        raise InputError("spin", Wording(f"{at}{words}"), f"consistent, with {VECTOR}; give two values that agree")
    return spins


def parts(given: Mapping[str, Any]) -> tuple[Any, Any, str]:
    """Return backspin and sidespin for a computation that needs both, and the assumption made in words, or "".

    The ``given`` ones, some of ``SPINS`` [rad/s, rad], are numbers or arrays of equal shape; NaN stays NaN. Raises
    InputError if they contradict each other, or a spin axis is given without a magnitude.
    """
    names = [name for name in SPINS if name in given]
    if names == [BACK, SIDE]:
        return given[BACK], given[SIDE], ""
    whole = {name: np.asarray(given[name], dtype=np.float64) for name in names}
    shape = np.broadcast_shapes(*(each.shape for each in whole.values()))
    flat = {name: np.broadcast_to(each, shape).ravel() for name, each in whole.items()}
    spins = agreeing(flat)
    completed = {name: values.reshape(shape) if shape else float(values[0]) for name, values in spins.values.items()}
    assumed = "; ".join(each.sentence for each in spins.notes if each.code == "spin-not-topped")
    if BACK in completed and SIDE in completed:
        return completed[BACK], completed[SIDE], assumed
    if AXIS in names:
        needs = "give total_spin with it" if names == [AXIS] else "give total_spin too: the axis does not determine it"
        raise InputError(AXIS, Wording(show(float(flat[AXIS][0]), "deg")), needs)
    if BACK in names:
        return completed[BACK], 0.0, "the sidespin is unknown and assumed to be 0: the ball does not curve"
    if TOTAL in names:
        return completed[TOTAL], 0.0, "the spin axis is unknown and assumed to be level: the ball does not curve"
    if SIDE in names:
        return 0.0, completed[SIDE], "the backspin is unknown and assumed to be 0"
    return 0.0, 0.0, "the spin is unknown and assumed to be 0: the ball has no lift"


def notes_of(spins: Spins, places: Iterable[int], row_word: str = "line") -> tuple[Note, ...]:
    """Return the notes on the spins of shots; ``places`` are the lines or rows of the shots."""
    at, more = list(places), len(spins.contradictions) - LISTED
    return (
        *(each.note.of(**{f"at_{row_word}": at[each.place]}) for each in spins.contradictions[:LISTED]),
        *([note("spins-contradict-more", more=more)] if more > 0 else []),
        *spins.notes,
    )


def _settle(spins: dict[str, Floats]) -> tuple[Contradiction, ...]:
    """Remove contradicting values from ``spins`` and return the contradictions."""
    before = {name: values.copy() for name, values in spins.items()}
    has = {name: ~np.isnan(values) for name, values in spins.items()}
    strict, misfit = _misfits(spins, 0.0), _misfits(spins, ALONG)
    polar, parts = has[TOTAL] & has[AXIS], has[BACK] & has[SIDE]
    without_axis, without_total = misfit[BACK, SIDE, TOTAL], misfit[BACK, SIDE, AXIS]
    with_back, with_side = misfit[BACK, TOTAL, AXIS], misfit[SIDE, TOTAL, AXIS]
    with np.errstate(invalid="ignore"):
        best = np.fmin(strict[BACK, SIDE, TOTAL], strict[BACK, SIDE, AXIS])
        by_polar = np.fmin(strict[BACK, TOTAL, AXIS], strict[SIDE, TOTAL, AXIS])
        by_parts = polar & parts & (best <= 1.0) & (by_polar > best + CLEARLY)
        drop = {
            BACK: (with_back > 1.0) & ~by_parts,
            SIDE: (with_side > 1.0) & ~by_parts,
            TOTAL: (without_axis > 1.0) & (by_parts | ~has[AXIS]) | (spins[TOTAL] < 0.0),
            AXIS: (without_total > 1.0) & (by_parts | ~has[TOTAL]),
        }
        for part, other_part in ((BACK, SIDE), (SIDE, BACK)):
            for other, third in ((TOTAL, AXIS), (AXIS, TOTAL)):
                wrong = (misfit[part, other] > 1.0) & ~has[other_part] & ~has[third]
                drop[part], drop[other] = drop[part] | wrong, drop[other] | wrong
    for name, where in drop.items():
        spins[name][where] = np.nan
    result = []
    for place in np.flatnonzero(np.any(list(drop.values()), axis=0)).tolist():
        given = {name: float(before[name][place]) for name in SPINS if has[name][place]}
        result.append(Contradiction(place, given, tuple(name for name in given if not drop[name][place])))
    return tuple(result)


def _misfits(spins: Mapping[str, Floats], along: float) -> dict[tuple[str, ...], Floats]:
    """Return the inconsistency of pairs and triples of spins, divided by the part that rounding explains.

    ``along`` is the relative excess allowed for the total spin over that of the other spins.
    """

    def beyond(by_total: Floats, seen: Floats) -> Floats:
        excess = np.abs(by_total) - np.abs(seen)
        allowed = (by_total * seen >= 0.0) & (excess > 0.0)
        return np.where(allowed, np.maximum(excess - along * np.abs(by_total), 0.0), np.abs(by_total - seen))

    back, side, total, axis = (spins[name] for name in SPINS)
    error = {name: _rounding(values, UNITS[name]) for name, values in spins.items()}
    cos, sin = np.cos(axis), np.sin(axis)
    both, parts = np.hypot(back, side), error[BACK] + error[SIDE]
    turned = error[TOTAL] + np.abs(total) * error[AXIS]
    across, forward = side * cos - back * sin, back * cos + side * sin
    return {
        (BACK, SIDE, TOTAL): beyond(total, both) / (parts + error[TOTAL]),
        (BACK, SIDE, AXIS): np.where(forward < 0.0, both, np.abs(across)) / (parts + both * error[AXIS]),
        (BACK, TOTAL, AXIS): beyond(total * cos, back) / (error[BACK] + turned),
        (SIDE, TOTAL, AXIS): beyond(total * sin, side) / (error[SIDE] + turned),
        (BACK, TOTAL): (np.abs(back) - total) / (error[BACK] + error[TOTAL]),
        (SIDE, TOTAL): (np.abs(side) - total) / (error[SIDE] + error[TOTAL]),
        (BACK, AXIS): -back * cos / (error[BACK] + np.abs(back) * error[AXIS]),
        (SIDE, AXIS): -side * sin / (error[SIDE] + np.abs(side) * error[AXIS]),
    }


def _follow(spins: dict[str, Floats]) -> NDArray[np.bool_]:
    """Fill in the spins that follow; return the shots for which this assumes that the ball is not topped."""
    error = {name: _rounding(values, UNITS[name]) for name, values in spins.items()}

    def known(*names: str) -> NDArray[np.bool_]:
        return ~np.any([np.isnan(spins[name]) for name in names], axis=0)

    def fill(where: NDArray[np.bool_], values: Mapping[str, Floats]) -> None:
        for name, each in values.items():
            spins[name] = np.where(where & np.isnan(spins[name]), each, spins[name])

    with np.errstate(invalid="ignore", divide="ignore"):
        back, side, total, axis = (spins[name] for name in SPINS)
        fill(known(TOTAL, AXIS), {BACK: total * np.cos(axis), SIDE: total * np.sin(axis)})
        tangent = np.abs(np.tan(axis))
        sure = error[BACK] / np.abs(back) + error[AXIS] * tangent < WEAKEST
        fill(known(BACK, AXIS) & sure, {SIDE: back * np.tan(axis)})
        sure = error[SIDE] / np.abs(side) + error[AXIS] / tangent < WEAKEST
        fill(known(SIDE, AXIS) & sure, {BACK: side / np.tan(axis)})
        sure = total - np.abs(side) > error[TOTAL] + error[SIDE]
        lifting = known(TOTAL, SIDE) & ~known(BACK) & sure
        fill(lifting, {BACK: np.sqrt((total - side) * (total + side))})
        back, side = spins[BACK], spins[SIDE]
        fill(known(BACK, SIDE), {TOTAL: np.hypot(back, side), AXIS: np.arctan2(side, back)})
    return lifting


def _rounding(values: Floats, unit: str) -> Floats:
    """Return the rounding error of values [SI]."""
    numbers = values / size(unit)
    steps = np.full(values.shape, STEPS[unit][-1])
    for step in STEPS[unit][-2::-1]:
        counted = numbers / step
        steps = np.where(np.abs(counted - np.round(counted)) < 1e-6, step, steps)
    return 0.5 * steps * size(unit)


def rolling_speed(ball: Ball, spin: Any) -> Any:
    """Return the speed along the face [m/s] of a rigid one-piece ball that friction gave this spin [rad/s]."""
    return ball.inertia * np.asarray(spin) / (ball.mass * ball.radius)
