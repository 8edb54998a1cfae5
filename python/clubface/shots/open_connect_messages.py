"""The messages of GSPro Open Connect v1: fields, framing, reading and writing, with the units and signs of clubface.

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
from collections.abc import Mapping
from typing import Any

from clubface.errors import AssumptionWarning, InputError, shortened
from clubface.results.notes import Note, note
from clubface.shots.messages import (
    LARGEST as LARGEST,
    LARGEST_VALUE,
    Broken as Broken,
    Message,
    MessageError,
    ObjectStream as ObjectStream,
    in_si,
    number_of,
    numbers_of,
    object_of,
    recorded as recorded,
    shot_message,
)
from clubface.simulation.launch import Launch
from clubface.simulation.spin import AXIS, BACK, DIMENSIONS, SIDE, SPINS, TOTAL, parts
from clubface.support.checks import check_choice, warn_once
from clubface.units import from_si, parse, unit

__all__ = [
    "FAILED", "LARGEST", "OK", "PLAYER", "Broken", "Message", "MessageError", "ObjectStream", "from_json", "heartbeat",
    "player", "recorded", "reply", "to_json", "whole_spin",
]  # fmt: skip


VERSION = "1"
BALL = {
    "Speed": ("ball_speed", "mph"),
    "SpinAxis": ("spin_axis", "deg"),
    "TotalSpin": ("total_spin", "rpm"),
    "BackSpin": ("backspin", "rpm"),
    "SideSpin": ("sidespin", "rpm"),
    "HLA": ("azimuth", "deg"),
    "VLA": ("launch", "deg"),
    "CarryDistance": ("carry", "yd"),
}
CLUB = {
    "Speed": ("speed", "mph"),
    "AngleOfAttack": ("attack", "deg"),
    "FaceToTarget": ("face", "deg"),
    "Lie": ("lie", "deg"),
    "Loft": ("loft", "deg"),
    "Path": ("path", "deg"),
    "VerticalFaceImpact": ("high", "mm"),
    "HorizontalFaceImpact": ("toe", "mm"),
    "ClosureRate": ("closure", "deg/s"),
}
"""The quantity and unit of each field; of the club, ``SpeedAtImpact`` is not used."""
NEVER_ZERO = ("speed", "loft", "closure")
"""Quantities of the club that are zero only where they were not measured."""
CARRY_UNITS = {
    **dict.fromkeys(("yards", "yard", "yds", "yd"), "yd"),
    **dict.fromkeys(("meters", "metres", "meter", "metre", "m"), "m"),
}
"""What ``Units`` may say, and the unit of the carry that it means."""
OK, PLAYER, FAILED = 200, 201, 501
HANDS = {"right": "RH", "left": "LH"}


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
    state = {"is_ready": flags["LaunchMonitorIsReady"], "sees_ball": flags["LaunchMonitorBallDetected"]}
    is_shot = not flags["IsHeartBeat"] and bool(flags["ContainsBallData"] or flags["ContainsClubData"])
    number = number_of(data, "ShotNumber", "") if is_shot or "ShotNumber" in data else 0.0
    if number < 0.0:
        raise MessageError("ShotNumber must be 0 or more")
    known = {"device": device.strip(), "shot_number": int(number), **state}
    if not is_shot:
        return Message(kind="heartbeat" if flags["IsHeartBeat"] else "status", **known)
    notes: list[Note] = []
    launch: dict[str, float] = {}
    ball, club = (
        _part(data, name, notes) if flags[flag] else {}
        for name, flag in (("BallData", "ContainsBallData"), ("ClubData", "ContainsClubData"))
    )
    delivery = _delivery(club or {}, notes)
    if flags["ContainsBallData"] and (ball is not None or not delivery):
        launch = _launch(object_of(data, "BallData"), _carry_unit(data, notes), notes)
    if not launch and not delivery:
        raise MessageError("; ".join(["ClubData holds nothing but zeros", *map(str, notes)]))
    return shot_message(delivery=delivery, launch=launch, notes=notes, **known)


def _options(data: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what the message says it holds; without a word on that, it is a shot of the data that are there."""
    held = {f"Contains{name}": isinstance(data.get(name), Mapping) for name in ("BallData", "ClubData")}
    if data.get("ShotDataOptions") is None and any(held.values()):
        return held
    return object_of(data, "ShotDataOptions")


def _part(data: Mapping[str, Any], name: str, notes: list[Note]) -> Mapping[str, Any] | None:
    """Return the data of ball or club; None, with a note, where the message says it holds them and does not."""
    result = data.get(name)
    if result is None:
        notes.append(note("message-part-missing", part=name))
        return None
    return object_of(data, name)


def _launch(ball: Mapping[str, Any], carry_unit: str | None, notes: list[Note]) -> dict[str, float]:
    needed = ("Speed", "HLA", "VLA")
    given = {name: number_of(ball, name, "BallData.", LARGEST_VALUE) for name in needed}
    if not given["Speed"] > 0.0:
        raise MessageError("BallData.Speed must be above 0")
    given |= numbers_of(ball, [name for name in BALL if name not in needed], "BallData.", notes)
    back, side, total, axis = (given.get(name) for name in ("BackSpin", "SideSpin", "TotalSpin", "SpinAxis"))
    if back == 0.0 == side and total is not None:
        given = {name: value for name, value in given.items() if name not in ("BackSpin", "SideSpin")}
    if total == 0.0 == axis:
        given.pop("SpinAxis")
    if not given.get("CarryDistance") or carry_unit is None:
        given.pop("CarryDistance", None)
    given = {name: given[name] for name in BALL if name in given}
    return in_si(given, BALL | {"CarryDistance": ("carry", carry_unit or "yd")})


def _delivery(club: Mapping[str, Any], notes: list[Note]) -> dict[str, float]:
    given = numbers_of(club, CLUB, "ClubData.", notes)
    if given.get("Speed", 0.0) < 0.0:
        notes.append(note("message-speed-negative", value=given.pop("Speed")))
    if not any(given.values()):
        return {}
    result = {name: value for name, value in in_si(given, CLUB).items() if value or name not in NEVER_ZERO}
    if not result.get("toe") and not result.get("high"):
        result = {name: value for name, value in result.items() if name not in ("toe", "high")}
    return result


def _flag(options: Mapping[str, Any], name: str) -> bool | None:
    result = options.get(name)
    if result is not None and not isinstance(result, bool):
        raise MessageError(f"ShotDataOptions.{name} must be true or false")
    return result


def _carry_unit(data: Mapping[str, Any], notes: list[Note]) -> str | None:
    """Return the unit of the carry; None, with a note, where the message names one that the protocol does not have."""
    units = data.get("Units")
    result = CARRY_UNITS.get(str("yards" if units is None else units).strip().lower())
    if result is None:
        notes.append(note("message-units", value=shortened(repr(units), 40)))
    return result


def to_json(
    launch: Launch | Mapping[str, Any],
    delivery: Mapping[str, Any] | None = None,
    *,
    shot_number: int,
    device: str = "clubface",
) -> dict[str, Any]:
    """Return the message of a shot.

    Parameters
    ----------
    launch
        A :class:`Launch` of a single shot, or a mapping of SI values or texts with units: ``ball_speed``, ``launch``,
        and if known ``azimuth``, ``carry`` and two of ``backspin``, ``sidespin``, ``total_spin`` and ``spin_axis``. The
        message must hold all four; a warning says what is assumed where they do not follow.
    delivery
        The same for the club. If left out: the delivery of a :class:`Launch`, or none.
    shot_number, device
        Shot number and device name in the message.
    """
    if isinstance(launch, Launch):
        delivery = delivery if delivery is not None else launch.delivery
        launch = {name: getattr(launch, name) for name in ("ball_speed", "launch", "azimuth", BACK, SIDE)}
    ball = _written({**launch, **whole_spin(launch)}, BALL)
    if not ball.get("Speed", 0.0) > 0.0:
        raise InputError("ball_speed", launch.get("ball_speed"), "above 0 in a message to a simulator")
    if "VLA" not in ball:
        raise InputError("launch", None, "give the launch angle, which a message to a simulator needs")
    ball.setdefault("HLA", 0.0)
    club = _written(delivery or {}, CLUB)
    return {
        "DeviceID": device,
        "Units": "Yards",
        "ShotNumber": shot_number,
        "APIversion": VERSION,
        "BallData": ball,
        "ClubData": {name: club.get(name, 0.0) for name in (*CLUB, "SpeedAtImpact")},
        "ShotDataOptions": _outgoing_options(ball=True, club=any(club.values())),
    }


def heartbeat(*, device: str = "clubface", is_ready: bool = True) -> dict[str, Any]:
    """Return the message by which a monitor shows that it is there."""
    return {
        "DeviceID": device,
        "Units": "Yards",
        "ShotNumber": 0,
        "APIversion": VERSION,
        "ShotDataOptions": _outgoing_options(heartbeat=True) | {"LaunchMonitorIsReady": is_ready},
    }


def reply(code: int, message: str, player: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Return the answer of a simulator."""
    return {"Code": code, "Message": message, **({"Player": dict(player)} if player is not None else {})}


def player(hand: str, club: str = "") -> dict[str, str]:
    """Return what an answer of code 201 says of the player: ``hand`` "right" or "left", and the club's short name."""
    check_choice("hand", hand, HANDS)
    return {"Handed": HANDS[hand], "Club": club}


def _outgoing_options(*, ball: bool = False, club: bool = False, heartbeat: bool = False) -> dict[str, bool]:
    return {
        "ContainsBallData": ball,
        "ContainsClubData": club,
        "LaunchMonitorIsReady": True,
        "LaunchMonitorBallDetected": True,
        "IsHeartBeat": heartbeat,
    }


def whole_spin(launch: Mapping[str, Any]) -> dict[str, float]:
    """Return all four spins of a launch [rad/s, rad]."""
    given = {name: _si_number(launch[name], name, DIMENSIONS[name]) for name in SPINS if launch.get(name) is not None}
    back, side, assumed = parts({name: value for name, value in given.items() if value == value})
    if assumed:
        warn_once(assumed, AssumptionWarning)
    return {BACK: back, SIDE: side, TOTAL: math.hypot(back, side), AXIS: math.atan2(side, back)}


def _si_number(value: Any, name: str, dimension: str) -> float:
    """Return a number in SI; NaN is one, and means not measured."""
    return value if isinstance(value, float) and value != value else parse(value, dimension, name=name)


def _written(values: Mapping[str, Any], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Return the fields of a message, each in its unit; what is not a number is left out."""
    names = {quantity: name for name, (quantity, _) in fields.items()}
    result = {}
    for quantity, value in values.items():
        if quantity not in names or value is None:
            continue
        symbol = fields[names[quantity]][1]
        number = _si_number(value, quantity, unit(symbol).dimension)
        if number == number:
            result[names[quantity]] = float(from_si(number, symbol))
    return result
