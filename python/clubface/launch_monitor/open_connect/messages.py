"""Messages of GSPro Open Connect v1: from JSON to a shot with the units and signs of clubface.

The fields are those of the protocol's page (gsprogolf.com, "GSPro Open Connect v1 Documentation"): speeds in mph,
angles in degrees, spin in rpm, and the carry in yards or metres as ``Units`` says. HLA, spin axis and sidespin are
positive to the right. The page does not give the signs of the club data. Here path and face angle are positive to the
right for either hand, the horizontal impact is positive towards the toe in mm, as connectors for the protocol write it,
and the closure rate is in deg/s. Clients must send a number, so a zero of club speed, loft or closure rate, or zeros of
both impact offsets, mean not measured. So does a value that no golf shot can have. Total spin and spin axis are
required, backspin and sidespin are not.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.errors import ClubfaceError, shortened
from clubface.launch_monitor.open_connect.fields import (
    BALL,
    CARRY_UNITS,
    CLUB,
    LARGEST_NUMBER,
    LARGEST_VALUE,
    NEVER_ZERO,
    VERSION,
)
from clubface.recorded.possible import describe_impossible, impossible, note_of, within_turn
from clubface.simulation.spin import SPINS, complete
from clubface.units import to_si

if TYPE_CHECKING:
    from clubface.recorded.shots import RecordedShots


LISTED = 10
"""Notes of messages that are repeated of a session, the most frequent ones."""


class MessageError(ClubfaceError, ValueError):
    """A message that is no shot, heartbeat or status; its text names the field at fault and is sent back."""


@dataclass(frozen=True, kw_only=True)
class Message:
    """The content of a message of a launch monitor, in SI units.

    Attributes
    ----------
    kind
        "shot", "heartbeat" or "status".
    device, shot_number
        Name and shot number that the sender gives.
    delivery
        Inputs of an impact by name; empty if the club was not measured.
    launch
        Quantities of the launch by name; empty without ball data.
    impossible
        The values of both that no shot can have, and which therefore are in neither.
    notes
        What else of the message was not taken, and why.
    is_ready, sees_ball
        The state that the monitor reports; None if it reports none.
    """

    kind: str
    device: str
    shot_number: int
    delivery: Mapping[str, float] = field(default_factory=dict)
    launch: Mapping[str, float] = field(default_factory=dict)
    impossible: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    is_ready: bool | None = None
    sees_ball: bool | None = None


def from_json(data: Mapping[str, Any]) -> Message:
    """Return the message in a JSON object.

    A field of the club, of the spin or the carry that holds no number costs that field; so do values that no shot can
    have, and spins that contradict others. The message says so in ``notes`` and ``impossible``.

    Raises
    ------
    MessageError
        A field without which there is no shot is missing or wrong; the text names it.
    """
    options = _options(data)
    flags = {
        name: _flag(options, name)
        for name in (
            "ContainsBallData", "ContainsClubData", "IsHeartBeat", "LaunchMonitorIsReady", "LaunchMonitorBallDetected",
        )
    }  # fmt: skip
    device = data.get("DeviceID")
    if not isinstance(device, str) or not device.strip():
        raise MessageError("DeviceID must be a text")
    version = str(data.get("APIversion", VERSION)).strip()
    if version.partition(".")[0] != VERSION:
        raise MessageError(f"APIversion is {version[:20]!r}; it must be {VERSION!r}")
    notes: list[str] = []
    launch: dict[str, float] = {}
    delivery: dict[str, float] = {}
    wrong: dict[str, float] = {}
    if flags["IsHeartBeat"]:
        kind = "heartbeat"
    elif flags["ContainsBallData"] or flags["ContainsClubData"]:
        kind = "shot"
        ball, club = (
            _part(data, name, notes) if flags[flag] else {}
            for name, flag in (("BallData", "ContainsBallData"), ("ClubData", "ContainsClubData"))
        )
        delivery = _delivery(club or {}, notes)
        if flags["ContainsBallData"] and (ball is not None or not delivery):
            launch = _launch(_object(data, "BallData"), _carry_unit(data, notes), notes)
        if not launch and not delivery:
            raise MessageError("; ".join(["ClubData holds nothing but zeros", *notes]))
        wrong = impossible(delivery | launch)
        launch, delivery = (
            {name: value for name, value in each.items() if name not in wrong} for each in (launch, delivery)
        )
        if not launch and not delivery:
            raise MessageError(f"no shot can have such values: {', '.join(wrong)}")
        launch = _whole(launch, notes)
    else:
        kind = "status"
    number = _number(data, "ShotNumber", "") if kind == "shot" or "ShotNumber" in data else 0.0
    if number < 0.0:
        raise MessageError("ShotNumber must be 0 or more")
    return Message(
        kind=kind,
        device=device.strip(),
        shot_number=int(number),
        delivery=delivery,
        launch=launch,
        impossible=wrong,
        notes=tuple(notes),
        is_ready=flags["LaunchMonitorIsReady"],
        sees_ball=flags["LaunchMonitorBallDetected"],
    )


def _options(data: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what the message says it holds; without a word on that, it is a shot of the data that are there."""
    held = {f"Contains{name}": isinstance(data.get(name), Mapping) for name in ("BallData", "ClubData")}
    if data.get("ShotDataOptions") is None and any(held.values()):
        return held
    return _object(data, "ShotDataOptions")


def _part(data: Mapping[str, Any], name: str, notes: list[str]) -> Mapping[str, Any] | None:
    """Return the data of ball or club; None, with a note, where the message says it holds them and does not."""
    found = data.get(name)
    if found is None:
        notes.append(f"{name} is missing")
        return None
    return _object(data, name)


def _launch(ball: Mapping[str, Any], carry_unit: str | None, notes: list[str]) -> dict[str, float]:
    needed = ("Speed", "HLA", "VLA")
    given = {name: _number(ball, name, "BallData.", LARGEST_VALUE) for name in needed}
    if not given["Speed"] > 0.0:
        raise MessageError("BallData.Speed must be above 0")
    given |= _numbers(ball, [name for name in BALL if name not in needed], "BallData.", notes)
    back, side, total, axis = (given.get(name) for name in ("BackSpin", "SideSpin", "TotalSpin", "SpinAxis"))
    if back == 0.0 == side and total is not None:
        given = {name: value for name, value in given.items() if name not in ("BackSpin", "SideSpin")}
    if total == 0.0 == axis:
        given.pop("SpinAxis")
    if not given.get("CarryDistance") or carry_unit is None:
        given.pop("CarryDistance", None)
    given = {name: given[name] for name in BALL if name in given}
    return _si(given, BALL | {"CarryDistance": ("carry", carry_unit or "yd")})


def _whole(launch: Mapping[str, float], notes: list[str]) -> dict[str, float]:
    """Return a launch with all that follows of its spin, and directions within half a turn."""
    spins = complete({name: np.array([launch[name]]) for name in SPINS if name in launch})
    notes += [*(str(each) for each in spins.contradictions), *spins.notes]
    known = {name: float(values[0]) for name, values in spins.values.items() if values[0] == values[0]}
    rest = {name: float(within_turn(name, value)) for name, value in launch.items() if name not in SPINS}
    return rest | known


def _delivery(club: Mapping[str, Any], notes: list[str]) -> dict[str, float]:
    given = _numbers(club, CLUB, "ClubData.", notes)
    if given.get("Speed", 0.0) < 0.0:
        notes.append(f"ClubData.Speed is {given.pop('Speed'):g}, which is below 0: taken as not measured")
    if not any(given.values()):
        return {}
    found = {name: value for name, value in _si(given, CLUB).items() if value or name not in NEVER_ZERO}
    if not found.get("toe") and not found.get("high"):
        found = {name: value for name, value in found.items() if name not in ("toe", "high")}
    return found


def _numbers(data: Mapping[str, Any], names: Iterable[str], where: str, notes: list[str]) -> dict[str, float]:
    """Return the fields that hold a number; a note says which hold something else. Null is not measured."""
    found = {}
    for name in names:
        if data.get(name) is None:
            continue
        try:
            found[name] = _number(data, name, where, LARGEST_VALUE)
        except MessageError:
            text = shortened(repr(data[name]), 40)
            notes.append(f"{where}{name} is {text}, which is no number: taken as not measured")
    return found


def _si(given: Mapping[str, float], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    found = {}
    for name, value in given.items():
        quantity, symbol = fields[name]
        found[quantity] = to_si(value, symbol)
    return found


def _object(data: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = data.get(name)
    if not isinstance(found, Mapping):
        raise MessageError(f"{name} is missing" if found is None else f"{name} must be an object")
    return found


def _flag(options: Mapping[str, Any], name: str) -> bool | None:
    found = options.get(name)
    if found is not None and not isinstance(found, bool):
        raise MessageError(f"ShotDataOptions.{name} must be true or false")
    return found


def _number(data: Mapping[str, Any], name: str, where: str, largest: float = LARGEST_NUMBER) -> float:
    found = data.get(name)
    try:
        is_none = isinstance(found, bool) or found is None or (isinstance(found, str) and "_" in found)
        number = math.nan if is_none else float(found)  # pyright: ignore[reportArgumentType]
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not abs(number) < largest:
        raise MessageError(f"{where}{name} must be a number" if found is not None else f"{where}{name} is missing")
    return number


def _carry_unit(data: Mapping[str, Any], notes: list[str]) -> str | None:
    """Return the unit of the carry; None, with a note, where the message names one that the protocol does not have."""
    units = data.get("Units")
    found = CARRY_UNITS.get(str("yards" if units is None else units).strip().lower())
    if found is None:
        text = shortened(repr(units), 40)
        notes.append(f"Units is {text} and must be Yards or Meters: the carry is taken as not measured")
    return found


def recorded(messages: Iterable[Message], *, hand: str | None = None) -> RecordedShots:
    """Return the shots among the messages as :class:`RecordedShots`; ``rows`` are the shot numbers.

    Notes count the values that no shot can have, and say what else of the messages was not taken.
    """
    from clubface.recorded.shots import RecordedShots

    shots = [each for each in messages if each.kind == "shot"]

    def columns(of: Sequence[Mapping[str, float]]) -> dict[str, Any]:
        names = dict.fromkeys(name for each in of for name in each)
        return {name: np.array([each.get(name, math.nan) for each in of]) for name in names}

    wrong: dict[str, list[float]] = {}
    for each in shots:
        for name, value in each.impossible.items():
            wrong.setdefault(name, []).append(value)
    notes = Counter(note for each in shots for note in each.notes)
    counts = [describe_impossible(name, len(values), len(shots), values[0]) for name, values in wrong.items()]
    return RecordedShots(
        deliveries=columns([each.delivery for each in shots]),
        launches=columns([each.launch for each in shots]),
        hand=None if hand is None else np.array([hand] * len(shots), dtype=object),
        rows=np.array([each.shot_number for each in shots], dtype=np.int64),
        source="Open Connect",
        format="open-connect",
        notes=(
            *([note_of(counts)] if counts else []),
            *(f"{note} (in {count} of {len(shots)} shots)" for note, count in notes.most_common(LISTED)),
            *([f"and {len(notes) - LISTED} more such notes"] if len(notes) > LISTED else []),
        ),
    )
