"""Outgoing messages of Open Connect: shots and heartbeats of a monitor, answers of a simulator."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from clubface.errors import InputError
from clubface.launch_monitor.open_connect.fields import BALL, CLUB, HANDS, VERSION
from clubface.simulation.launch import Launch
from clubface.support.checks import check_choice
from clubface.units import from_si, parse, to_si, unit


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
        and if known ``azimuth``, ``carry`` and ``total_spin`` with ``spin_axis`` or ``backspin`` with ``sidespin``.
    delivery
        The same for the club. If left out: the delivery of a :class:`Launch`, or none.
    shot_number, device
        Shot number and device name in the message.
    """
    if isinstance(launch, Launch):
        delivery = delivery if delivery is not None else launch.delivery
        launch = {name: getattr(launch, name) for name, _ in BALL.values() if name != "carry"}
    ball = _written(launch, BALL)
    if not ball.get("Speed", 0.0) > 0.0:
        raise InputError("ball_speed", launch.get("ball_speed"), "above 0 in a message to a simulator")
    if "VLA" not in ball:
        raise InputError("launch", None, "give the launch angle, which a message to a simulator needs")
    back, side = ball.get("BackSpin", 0.0), ball.get("SideSpin", 0.0)
    ball.setdefault("TotalSpin", math.hypot(back, side))
    ball.setdefault("SpinAxis", from_si(math.atan2(side, back), "deg") if side or back else 0.0)
    axis = to_si(ball["SpinAxis"], "deg")
    ball.setdefault("BackSpin", ball["TotalSpin"] * math.cos(axis))
    ball.setdefault("SideSpin", ball["TotalSpin"] * math.sin(axis))
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


def _written(values: Mapping[str, Any], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Return the fields of a message, each in its unit; what is not a number is left out."""
    names = {quantity: name for name, (quantity, _) in fields.items()}
    found = {}
    for quantity, value in values.items():
        if quantity not in names or value is None:
            continue
        symbol = fields[names[quantity]][1]
        number = (
            value
            if isinstance(value, float) and value != value
            else parse(value, unit(symbol).dimension, name=quantity)
        )
        if number == number:
            found[names[quantity]] = float(from_si(number, symbol))
    return found
