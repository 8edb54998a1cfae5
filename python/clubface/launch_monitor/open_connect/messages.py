"""Messages of GSPro Open Connect v1: from JSON to a shot with the units and signs of clubface.

The fields are those of the protocol's page (gsprogolf.com, "GSPro Open Connect v1 Documentation"): speeds in mph,
angles in degrees, spin in rpm, and the carry in yards or metres as ``Units`` says. HLA, spin axis and sidespin are
positive to the right. The page does not give the signs of the club data. Here path and face angle are positive to the
right for either hand, the horizontal impact is positive towards the toe in mm, as connectors for the protocol write it,
and the closure rate is in deg/s. Clients must send a number, so a zero of club speed, loft or closure rate, or zeros of
both impact offsets, mean not measured. So does a value that no golf shot can have.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from clubface.errors import ClubfaceError
from clubface.launch_monitor.open_connect.fields import (
    BALL,
    CLUB,
    LARGEST_NUMBER,
    LARGEST_VALUE,
    METRES,
    NEVER_ZERO,
    VERSION,
)
from clubface.recorded.possible import impossible, note_of, told
from clubface.units import to_si

if TYPE_CHECKING:
    from clubface.recorded.shots import RecordedShots


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
    is_ready, sees_ball
        The state that the monitor reports; None if it reports none.
    """

    kind: str
    device: str
    shot_number: int
    delivery: Mapping[str, float] = field(default_factory=dict)
    launch: Mapping[str, float] = field(default_factory=dict)
    impossible: Mapping[str, float] = field(default_factory=dict)
    is_ready: bool | None = None
    sees_ball: bool | None = None


def from_json(data: Mapping[str, Any]) -> Message:
    """Return the message in a JSON object.

    Raises
    ------
    MessageError
        A field is missing or wrong; the text names it.
    """
    options = _object(data, "ShotDataOptions")
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
    launch: dict[str, float] = {}
    delivery: dict[str, float] = {}
    wrong: dict[str, float] = {}
    if flags["IsHeartBeat"]:
        kind = "heartbeat"
    elif flags["ContainsBallData"] or flags["ContainsClubData"]:
        kind = "shot"
        if flags["ContainsBallData"]:
            launch = _launch(_object(data, "BallData"), _metric(data))
        if flags["ContainsClubData"]:
            delivery = _delivery(_object(data, "ClubData"))
        if not launch and not delivery:
            raise MessageError("ClubData holds nothing but zeros")
        wrong = impossible(delivery | launch)
        launch, delivery = (
            {name: value for name, value in each.items() if name not in wrong} for each in (launch, delivery)
        )
        if not launch and not delivery:
            raise MessageError(f"no shot can have such values: {', '.join(wrong)}")
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
        is_ready=flags["LaunchMonitorIsReady"],
        sees_ball=flags["LaunchMonitorBallDetected"],
    )


def _launch(ball: Mapping[str, Any], metric: bool) -> dict[str, float]:
    given = {name: _number(ball, name, "BallData.", LARGEST_VALUE) for name in BALL if ball.get(name) is not None}
    for name in ("Speed", "HLA", "VLA"):
        if name not in given:
            raise MessageError(f"BallData.{name} is missing")
    if not given["Speed"] > 0.0:
        raise MessageError("BallData.Speed must be above 0")
    if not ({"TotalSpin", "SpinAxis"} <= set(given) or {"BackSpin", "SideSpin"} <= set(given)):
        raise MessageError("BallData needs TotalSpin and SpinAxis, or BackSpin and SideSpin")
    for name in ("BackSpin", "SideSpin") if {"TotalSpin", "SpinAxis"} <= set(given) else ("TotalSpin", "SpinAxis"):
        given.pop(name, None)
    if not given.get("CarryDistance"):
        given.pop("CarryDistance", None)
    return _si(given, BALL | ({"CarryDistance": ("carry", "m")} if metric else {}))


def _delivery(club: Mapping[str, Any]) -> dict[str, float]:
    given = {name: _number(club, name, "ClubData.", LARGEST_VALUE) for name in CLUB if club.get(name) is not None}
    if given.get("Speed", 0.0) < 0.0:
        raise MessageError("ClubData.Speed must not be below 0")
    if not any(given.values()):
        return {}
    found = {name: value for name, value in _si(given, CLUB).items() if value or name not in NEVER_ZERO}
    if not found.get("toe") and not found.get("high"):
        found = {name: value for name, value in found.items() if name not in ("toe", "high")}
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
        number = math.nan if isinstance(found, bool) or found is None else float(found)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not abs(number) < largest:
        raise MessageError(f"{where}{name} must be a number" if found is not None else f"{where}{name} is missing")
    return number


def _metric(data: Mapping[str, Any]) -> bool:
    return str(data.get("Units", "Yards")).strip().lower() in METRES


def recorded(messages: Iterable[Message], *, hand: str | None = None) -> RecordedShots:
    """Return the shots among the messages as :class:`RecordedShots`; ``rows`` are the shot numbers.

    A note counts the values that no shot can have.
    """
    import numpy as np

    from clubface.recorded.shots import RecordedShots

    shots = [each for each in messages if each.kind == "shot"]

    def columns(of: Sequence[Mapping[str, float]]) -> dict[str, Any]:
        names = dict.fromkeys(name for each in of for name in each)
        return {name: np.array([each.get(name, math.nan) for each in of]) for name in names}

    wrong: dict[str, list[float]] = {}
    for each in shots:
        for name, value in each.impossible.items():
            wrong.setdefault(name, []).append(value)
    counts = [told(name, len(values), len(shots), values[0]) for name, values in wrong.items()]
    return RecordedShots(
        deliveries=columns([each.delivery for each in shots]),
        launches=columns([each.launch for each in shots]),
        hand=None if hand is None else np.array([hand] * len(shots), dtype=object),
        rows=np.array([each.shot_number for each in shots], dtype=np.int64),
        source="Open Connect",
        format="open-connect",
        notes=(note_of(counts),) if counts else (),
    )
