"""Outgoing messages of Open Connect: shots and heartbeats of a monitor, answers of a simulator."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from clubface.errors import AssumptionWarning, InputError
from clubface.launch_monitor.open_connect.fields import BALL, CLUB, HANDS, VERSION
from clubface.simulation.launch import Launch
from clubface.simulation.spin import AXIS, BACK, DIMENSIONS, SIDE, SPINS, TOTAL, parts
from clubface.support.checks import check_choice
from clubface.support.warning import warn_once
from clubface.units import from_si, parse, unit


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
    ball = _written({**launch, **_spins(launch)}, BALL)
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
        "ShotDataOptions": _options(ball=True, club=any(club.values())),
    }


def heartbeat(*, device: str = "clubface", is_ready: bool = True) -> dict[str, Any]:
    """Return the message by which a monitor shows that it is there."""
    return {
        "DeviceID": device,
        "Units": "Yards",
        "ShotNumber": 0,
        "APIversion": VERSION,
        "ShotDataOptions": _options(heartbeat=True) | {"LaunchMonitorIsReady": is_ready},
    }


def reply(code: int, message: str, player: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Return the answer of a simulator."""
    return {"Code": code, "Message": message, **({"Player": dict(player)} if player is not None else {})}


def player(hand: str, club: str = "") -> dict[str, str]:
    """Return what an answer of code 201 says of the player: ``hand`` "right" or "left", and the club's short name."""
    check_choice("hand", hand, HANDS)
    return {"Handed": HANDS[hand], "Club": club}


def _options(*, ball: bool = False, club: bool = False, heartbeat: bool = False) -> dict[str, bool]:
    return {
        "ContainsBallData": ball,
        "ContainsClubData": club,
        "LaunchMonitorIsReady": True,
        "LaunchMonitorBallDetected": True,
        "IsHeartBeat": heartbeat,
    }


def _spins(launch: Mapping[str, Any]) -> dict[str, float]:
    """Return all four spins of a launch [rad/s, rad]."""
    given = {name: _number(launch[name], name, DIMENSIONS[name]) for name in SPINS if launch.get(name) is not None}
    back, side, assumed = parts({name: value for name, value in given.items() if value == value})
    if assumed:
        warn_once(assumed, AssumptionWarning)
    return {BACK: back, SIDE: side, TOTAL: math.hypot(back, side), AXIS: math.atan2(side, back)}


def _number(value: Any, name: str, dimension: str) -> float:
    """Return a number in SI; NaN is one, and means not measured."""
    return value if isinstance(value, float) and value != value else parse(value, dimension, name=name)


def _written(values: Mapping[str, Any], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Return the fields of a message, each in its unit; what is not a number is left out."""
    names = {quantity: name for name, (quantity, _) in fields.items()}
    found = {}
    for quantity, value in values.items():
        if quantity not in names or value is None:
            continue
        symbol = fields[names[quantity]][1]
        number = _number(value, quantity, unit(symbol).dimension)
        if number == number:
            found[names[quantity]] = float(from_si(number, symbol))
    return found
