"""The messages of the Flight Relay Protocol 0.1: events of a shot over a WebSocket, put together to one message.

The specification (github.com/flightrelay/spec) has texts such as "67.2mps" for speeds and lengths, angles in degrees
and spins in rpm. Directions and sidespin are positive to the right for either hand, the impact towards the toe and the
crown. ``club_offset`` and ``club_height`` are of the head as it passes the ball, not of a point on the face, and are
not read; nor are the swing plane and the speed after impact. What came of a shot is one shot as soon as the device says
that it is finished, or when nothing more has come of it for some seconds, or the connection ends.
"""

from __future__ import annotations

import json
import re
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from clubface.errors import shortened
from clubface.results.notes import Note, note
from clubface.shots.messages import LARGEST, LARGEST_VALUE, Message, MessageError, in_si, numbers_of, shot_message
from clubface.units import to_si

__all__ = ["PATH", "PORT", "VERSION", "ShotCollector", "critical_alert", "start_message", "text_to_object"]

PORT = 5880
PATH = "/frp"
VERSION = "0.1.0"
UNFINISHED = 5.0
"""Time after which a shot that was not finished is taken as it is [s]."""
MOST_OPEN = 32
"""Shots of a connection that may be unfinished at a time; the oldest of more is taken as it is."""
UNITS = {
    "mps": "m/s", "mph": "mph", "kph": "km/h", "fps": "ft/s", "m": "m", "yd": "yd", "ft": "ft", "in": "in", "mm": "mm",
    "cm": "cm",
}  # fmt: skip
_SPEEDS = ("mps", "mph", "kph", "fps")
_TAGGED = re.compile(r"([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,3})?)([a-z]{1,3})", re.ASCII)
BALL = {
    "launch_speed": ("ball_speed", "speed"),
    "launch_azimuth": ("azimuth", "deg"),
    "launch_elevation": ("launch", "deg"),
    "carry_distance": ("carry", "length"),
    "total_distance": ("total", "length"),
    "max_height": ("apex", "length"),
    "flight_time": ("flight_time", "s"),
    "backspin_rpm": ("backspin", "rpm"),
    "sidespin_rpm": ("sidespin", "rpm"),
}
CLUB = {
    "club_speed": ("speed", "speed"),
    "path": ("path", "deg"),
    "attack_angle": ("attack", "deg"),
    "face_angle": ("face", "deg"),
    "dynamic_loft": ("loft", "deg"),
    "smash_factor": ("smash", "1"),
}
IMPACT = {"lateral": ("toe", "length"), "vertical": ("high", "length")}
"""The quantity of each field, and its unit, or what a text with a unit is of."""
PARTS = {"ball_flight": ("ball", BALL), "club_path": ("club", CLUB), "face_impact": ("impact", IMPACT)}
"""The object and the fields of the events that hold values."""
OF_BALL = {quantity for quantity, _ in BALL.values()} | {"smash"}


def start_message() -> dict[str, Any]:
    """Return the message with which a controller begins."""
    return {"kind": "start", "version": [VERSION], "name": "clubface"}


def critical_alert(reason: str) -> dict[str, Any]:
    """Return the message before a connection is closed."""
    return {"kind": "alert", "severity": "critical", "message": reason}


def text_to_object(text: str | bytes) -> dict[str, Any] | None:
    """Return the JSON object of a frame; None for anything else, which the protocol has ignored in silence."""
    if len(text) > LARGEST:
        return None
    try:
        result = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return result if isinstance(result, dict) else None


@dataclass
class _Open:
    """A shot of which more may come."""

    device: str
    number: int
    identity: str
    heard: float
    values: dict[str, float] = field(default_factory=dict)
    notes: list[Note] = field(default_factory=list)


class ShotCollector:
    """Puts the events of a connection together to messages.

    Attributes
    ----------
    has_begun
        Whether the device has answered the beginning.
    """

    def __init__(self) -> None:
        self.has_begun = False
        self._open: dict[str, _Open] = {}

    def feed(self, data: Mapping[str, Any]) -> list[Message | MessageError]:
        """Return the messages that an object completes: shots, states, and what cannot be used and why."""
        if data.get("kind") == "init":
            self.has_begun = True
            return []
        event = data.get("event")
        if data.get("kind") == "alert" or (isinstance(event, Mapping) and event.get("kind") == "alert"):
            alert = event if isinstance(event, Mapping) else data
            text = shortened(str(alert.get("message", "")), 200)
            return [MessageError(f"{_device(data)} says: {text}")]
        if not isinstance(event, Mapping):
            return []
        kind = event.get("kind")
        if kind == "device_telemetry":
            telemetry = event.get("telemetry")
            ready = telemetry.get("ready") if isinstance(telemetry, Mapping) else None
            return [
                Message(kind="status", device=_device(data), is_ready={"true": True, "false": False}.get(str(ready)))
            ]
        if kind not in ("shot_trigger", "shot_finished", *PARTS):
            return []
        try:
            shot = self._shot(data, event)
            if kind in PARTS:
                part, fields = PARTS[kind]
                _read(shot, event.get(part), part, fields)
        except MessageError as error:
            return [error]
        result = [self._taken(shot.identity)] if kind == "shot_finished" else []
        while len(self._open) > MOST_OPEN:
            result.append(self._taken(next(iter(self._open))))
        return [each for each in result if each is not None]

    def overdue(self, now: float | None = None) -> list[Message | MessageError]:
        """Return the shots of which nothing more has come for some seconds."""
        limit = (time.monotonic() if now is None else now) - UNFINISHED
        late = [identity for identity, each in self._open.items() if each.heard < limit]
        return [each for identity in late if (each := self._taken(identity)) is not None]

    def rest(self) -> list[Message | MessageError]:
        """Return all shots that are not finished, as the connection has ended."""
        return [each for identity in list(self._open) if (each := self._taken(identity)) is not None]

    def _shot(self, data: Mapping[str, Any], event: Mapping[str, Any]) -> _Open:
        key = event.get("key")
        identity = key.get("shot_id") if isinstance(key, Mapping) else None
        if not isinstance(key, Mapping) or not isinstance(identity, str) or not 0 < len(identity) <= 100:
            raise MessageError("key.shot_id must be a text")
        number = key.get("shot_number")
        if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < 2**53:
            number = 0
        shot = self._open.setdefault(identity, _Open(_device(data), number, identity, 0.0))
        shot.heard = time.monotonic()
        return shot

    def _taken(self, identity: str) -> Message | MessageError | None:
        """Return a shot with what has come of it; None where that is nothing but its beginning."""
        shot = self._open.pop(identity)
        if not shot.values and not shot.notes:
            return None
        launch = {name: value for name, value in shot.values.items() if name in OF_BALL}
        delivery = {name: value for name, value in shot.values.items() if name not in OF_BALL}
        try:
            return shot_message(
                device=shot.device, shot_number=shot.number, delivery=delivery, launch=launch, notes=shot.notes,
                identity=identity,
            )  # fmt: skip
        except MessageError as error:
            return error


def _device(data: Mapping[str, Any]) -> str:
    name = data.get("device")
    return name.strip()[:100] if isinstance(name, str) and name.strip() else "a monitor"


def _read(shot: _Open, part: Any, name: str, fields: Mapping[str, tuple[str, str]]) -> None:
    """Add the values of a part to a shot; a field that cannot be read costs that field, and a note says so."""
    if not isinstance(part, Mapping):
        raise MessageError(f"{name} must be an object")
    plain = [each for each, (_, unit) in fields.items() if unit not in ("speed", "length")]
    numbers = numbers_of(part, plain, f"{name}.", shot.notes)
    values = in_si(numbers, fields)
    for each, (quantity, unit) in fields.items():
        if each in plain or part.get(each) is None:
            continue
        value = _tagged(part[each], unit)
        if value is None:
            text = shortened(repr(part[each]), 40)
            shot.notes.append(note("message-field-no-unit", field=f"{name}.{each}", value=text))
        else:
            values[quantity] = value
    if not values.get("ball_speed", 1.0) > 0.0:
        del values["ball_speed"]
    if not values.get("speed", 1.0) > 0.0:
        del values["speed"]
    shot.values.update(values)


def _tagged(text: Any, kind: str) -> float | None:
    """Return a value such as "67.2mps" [SI]; None where it is none of its kind."""
    match = _TAGGED.fullmatch(text) if isinstance(text, str) and len(text) < 40 else None
    if match is None or match[2] not in UNITS or (match[2] in _SPEEDS) != (kind == "speed"):
        return None
    value = float(match[1])
    return to_si(value, UNITS[match[2]]) if abs(value) < LARGEST_VALUE else None
