"""The sentences of a report: what a fitter says to a customer. Every number in them is a statistic of the club."""

from __future__ import annotations

import math
from collections.abc import Iterator

from clubface import units
from clubface.inference.player_statistics import ClubStatistics, Statistic
from clubface.quantities import display_unit
from clubface.shots.formats import CONTACT
from clubface.simulation.inputs import DIMENSIONS
from clubface.simulation.results import outputs

__all__ = ["NAMES", "SIDES", "STEPS", "amount", "counted", "doubt", "line", "measured", "sided", "strike", "what_if"]

NAMES = {
    "speed": "club speed", "attack": "attack angle", "path": "club path", "loft": "dynamic loft", "face": "face angle",
    "toe": "strike sideways", "high": "strike up and down", "ball_speed": "ball speed", "launch": "launch angle",
    "azimuth": "start direction", "total_spin": "spin", "carry": "carry", "side": "distance from the line",
}  # fmt: skip
"""What players call the quantities of a report."""
UNITS = {"ball_speed": "mph", "speed": "mph", "carry": "yd", "side": "yd", "total_spin": "rpm", "backspin": "rpm"}
DIGITS = {"mph": 0, "deg": 1, "yd": 0, "rpm": 0, "mm": 0}
WRITTEN = {"deg": "°", "mph": " mph", "yd": " yards", "rpm": " rpm", "mm": " mm"}
SIDES = {"azimuth": "right left", "side": "right left", "face": "right left", "path": "right left",
         "toe": "toe heel", "high": "high low", "attack": "up down"}  # fmt: skip
SMALL = {"deg": 0.3, "yd": 1.0, "mm": 1.5}
"""Sizes below which a direction counts as straight, and a strike as centred."""
FEW, ENOUGH = 5, 10
"""Shots below which a mean says little, and from which the range of two in three is given."""
BEND = 0.5
"""Degrees of spin axis below which a ball flies straight."""
STEPS = {
    "speed": "swing 1 mph faster", "attack": "hit 1° more upwards", "loft": "deliver 1° more loft",
    "face": "turn the face 1° more to the right", "path": "swing 1° more to the right",
    "toe": "strike 5 mm closer to the toe",
}  # fmt: skip


def unit_of(name: str) -> str:
    """Return the unit in which players read a quantity."""
    if name in UNITS:
        return UNITS[name]
    return display_unit(name, units.SI_UNITS[DIMENSIONS[name]] if name in DIMENSIONS else outputs()[name].unit)


def amount(value: float, name: str, *, signed: bool = False, digits: int | None = None) -> str:
    """Write a value [SI] with its unit: "148 mph", "12.3°", with the digits of the unit unless given."""
    unit = unit_of(name)
    number = float(units.from_si(value, unit))
    text = f"{number:{'+' if signed else ''}.{DIGITS.get(unit, 1) if digits is None else digits}f}"
    text = text if text.strip("+-0.") else text.lstrip("+-")
    one = unit == "yd" and text.lstrip("+-") == "1"
    return text + (" yard" if one else WRITTEN.get(unit, f" {unit}"))


def sided(value: float, name: str) -> str:
    """Write a value with its side in words: "2.4° to the right"; one that is hardly there: "straight"."""
    more, less = SIDES[name].split()
    unit = unit_of(name)
    if abs(float(units.from_si(value, unit))) < SMALL[unit]:
        return {"toe": "in the middle", "high": "at the middle height", "attack": "level"}.get(name, "straight")
    word = more if value > 0.0 else less
    how = {"toe": f"towards the {word}", "high": f"{word}", "attack": f"{word}wards"}.get(name, f"to the {word}")
    return f"{amount(abs(value), name)} {how}"


def counted(shots: int) -> str:
    """Write a number of shots."""
    return f"{shots} shot{'s' * (shots != 1)}"


def measured(club: ClubStatistics) -> Iterator[str]:
    """Yield what was measured and the typical shot."""
    there = [
        NAMES[name] for name in NAMES if name in club.measured and not (club.computed and name in ("carry", "side"))
    ]
    yield f"We measured {counted(len(club.shots))}: {_listed(there)}."
    lacking = [NAMES[name] for name in ("speed", "path", "face", "toe") if name not in club.measured]
    if lacking:
        yield f"Your monitor did not give us: {_listed(lacking)}."
    typical = [
        f"{NAMES[name]} {amount(club.measured[name].mean, name)}"
        for name in ("speed", "ball_speed", "launch", "total_spin")
        if name in club.measured
    ]
    if typical:
        yield f"Your typical shot: {_listed(typical)}."
    if carry := club.measured.get("carry"):
        how = " (computed from the start of its flight, in still air)" if club.computed else ""
        yield f"It carries {amount(carry.mean, 'carry')}{how}{_spread(carry, 'carry', '; ')}."
    if side := club.measured.get("side"):
        yield f"On average it finishes {sided(side.mean, 'side')}{_spread(side, 'side', '; ')}."


def line(club: ClubStatistics) -> Iterator[str]:
    """Yield where the ball starts and how it bends, with face and path."""
    start, axis = club.measured.get("azimuth"), club.measured.get("spin_axis")
    if start is None:
        return
    bends = ""
    if axis is not None:
        degrees = math.degrees(axis.mean)
        bends = " and flies on without a bend" if abs(degrees) < BEND else _bend(degrees)
    yield f"Your ball starts {sided(start.mean, 'azimuth')}{bends}."
    angles, guessed = {}, []
    for name in ("face", "path"):
        if name in club.measured:
            angles[name] = club.measured[name].mean
        elif club.inferred is not None:
            angles[name] = club.inferred.mean[name]
            guessed.append(f"the {NAMES[name]} to about {amount(2.0 * club.inferred.doubt[name], name)} either way")
    if len(angles) < 2:
        return
    face, path = angles["face"], angles["path"]
    where = " at the point of contact" if "face" in club.measured and club.shots.face_at == CONTACT else ""
    known = "Judging by the flight of the ball" if guessed else "As measured"
    yield (
        f"{known}, your club face points {sided(face, 'face')}{where} at impact, and your club moves"
        f" {sided(path, 'path')}."
    )
    if guessed:
        yield f"This is an estimate: it gives {_listed(guessed)} (19 times out of 20)."
    if club.start:
        turned, swung = (club.start[name] for name in ("face", "path"))
        yield (
            f"With this club, one degree of face turns the start of the ball by {turned:.1f}°, one degree of path by"
            f" {swung:.1f}°: where it starts is mostly your face."
            if turned > swung
            else f"With this club, one degree of face turns the start of the ball by {turned:.1f}°, one degree of path"
            f" by {swung:.1f}°."
        )
    apart = face - path
    known_to = 0.0 if not guessed or club.inferred is None else 2.0 * max(club.inferred.doubt[name] for name in angles)
    if abs(apart) > known_to and abs(math.degrees(apart)) >= SMALL["deg"]:
        side = "right" if apart > 0.0 else "left"
        yield (
            f"The face looks {amount(abs(apart), 'face')} further {side} than the club moves, which by itself"
            f" bends a ball struck in the middle to the {side}."
        )
    if club.closing and abs(math.degrees(club.closing["azimuth"])) >= SMALL["deg"]:
        yield _closing(club)


def _closing(club: ClubStatistics) -> str:
    """Return the sentence on how the closing of the face changes start and bend."""
    start, spin = club.closing["azimuth"], club.closing["sidespin"]
    side, bend = ("right" if each > 0.0 else "left" for each in (start, spin))
    typical = "" if "closure" in club.measured else " at the rate that is usual for golfers of your speed"
    return (
        f"The face also closes while it meets the ball{typical}, and so moves to the {side}: that alone starts the ball"
        f" {amount(abs(start), 'azimuth')} further {side} and bends it to the {bend}."
    )


def strike(club: ClubStatistics) -> Iterator[str]:
    """Yield where the ball meets the face."""
    seen = [name for name in ("toe", "high") if name in club.measured]
    if seen:
        parts = [sided(club.measured[name].mean, name) for name in seen]
        yield f"On average the ball meets the face {_listed(parts)}."
        many = [name for name in seen if club.measured[name].count > 1]
        yield from (f"{NAMES[name].capitalize()}: {_spread(club.measured[name], name)}." for name in many)
    elif club.inferred is not None:
        for name in ("toe", "high"):
            value, doubt = club.inferred.mean[name], 2.0 * club.inferred.doubt[name]
            ends = " to ".join(sided(each, name) for each in (value - doubt, value + doubt))
            what = "sideways" if name == "toe" else "up and down"
            yield (
                f"Your monitor does not see where the ball meets the face. From its flight we estimate, {what}:"
                f" {sided(value, name)}. It may be anywhere from {ends} (19 times out of 20)."
                if name == "toe"
                else f"And {what}: {sided(value, name)}, anywhere from {ends}."
            )
        yield "Spray or impact tape on the face would show this far better than any computation."


def what_if(club: ClubStatistics) -> Iterator[str]:
    """Yield what a change does to the average shot, all else the same."""
    for each in club.changes:
        parts = [
            f"{NAMES[name]} {change}"
            for name in ("ball_speed", "launch")
            if (change := amount(each.launch[name], name, signed=True, digits=1)).strip("+-0. °mph")
        ]
        spin = amount(each.launch["backspin"], "backspin", signed=True)
        parts.append(f"backspin {spin}")
        carry = amount(each.carry, "carry", signed=True)
        parts.append(f"carry {carry}" if carry.strip("+-0. yards") else "carry as before")
        side = amount(abs(each.side), "side")
        parts.append(f"finishing {side} more to the {'right' if each.side > 0.0 else 'left'}")
        shown = parts[:-1] if abs(units.from_si(each.side, "yd")) < 0.5 else parts
        yield f"If you {STEPS[each.name]}: {', '.join(shown)}."


def doubt(club: ClubStatistics) -> Iterator[str]:
    """Yield how sure the report is, and what limits it."""
    count = len(club.shots)
    carry = club.measured.get("carry")
    if carry is not None and carry.count >= 2:
        error = amount(carry.error, "carry")
        yield (
            f"From {carry.count} shots we know your average carry to about {error} either way (19 times out of 20)."
            f" Another club must carry further or shorter by more than that before we call it different."
        )
    if count < FEW:
        yield f"{count} shot{'s are' if count != 1 else ' is'} few: {FEW} more could change every average here."
    elif count < ENOUGH:
        # An average of four times as many shots is twice as sure.
        yield f"With {3 * count} more shots we would know the averages about twice as well."
    inferred = club.inferred
    if inferred is not None and club.club is not None:
        if inferred.shots + inferred.refused < min(count, club.measured["launch"].count):
            yield f"The delivery of the club was computed for {inferred.shots} of the shots, spread evenly over all."
        yield (
            "The what-if, and face, path and strike where they were not measured, come from a model of impact with a"
            f" standard {club.club.name} and average golfers, not from your own club: trust the direction and the rough"
            " size, not the last digit."
        )
        if inferred.remarked:
            rows = ", ".join(str(row) for row in inferred.remarked[:10])
            more = f" and {len(inferred.remarked) - 10} more" * (len(inferred.remarked) > 10)
            yield (
                "The figures in these lines of the file hardly go together, so that one of them may be wrong:"
                f" {rows}{more}."
            )
        if inferred.refused:
            yield f"{inferred.refused} of the shots, as measured, cannot come from this club; they are left out there."
    elif club.club is None:
        yield (
            f"We have no model of {club.name}, so the report gives face, path and strike only as measured,"
            " and no what-if."
        )


def _spread(club: Statistic, name: str, before: str = "") -> str:
    """Return how much shots differ, after the text ``before``; nothing for a single shot."""
    if club.count < 2:
        return ""
    if club.count < ENOUGH:
        return f"{before}the shots differ by {amount(club.spread, name)} on average"
    low, high = (sided(each, name) if name in SIDES else amount(each, name) for each in (club.low, club.high))
    return f"{before}two out of three shots lie between {low} and {high}"


def _bend(degrees: float) -> str:
    return f" and bends to the {'right' if degrees > 0.0 else 'left'} (its spin axis is tilted {abs(degrees):.0f}°)"


def _listed(texts: list[str]) -> str:
    return texts[0] if len(texts) == 1 else f"{', '.join(texts[:-1])} and {texts[-1]}" if texts else "nothing"
