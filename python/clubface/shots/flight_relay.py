"""The Flight Relay Protocol 0.1 over a WebSocket: the events of a shot are combined into one message.

The specification (github.com/flightrelay/spec) uses text such as "67.2mps" for speeds and lengths, angles in degrees
and spins in rpm. Directions and sidespin are positive to the right for either hand, the impact point towards toe and
crown. ``club_offset`` and ``club_height`` describe the head as it passes the ball, not a point on the face, and are not
read; neither are swing plane and speed after impact. A shot is complete when the device says so, when no event has
arrived for some seconds, or when the connection ends.

clubface, the controller, connects to devices and bridges that listen, as most do, and accepts connections from the
others. Web pages are refused, since any page open in a browser could send fake shots.
"""

from __future__ import annotations

import json
import re
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from clubface.errors import InputError, shortened
from clubface.results.notes import Note, note
from clubface.shots.messages import (
    LARGEST,
    LARGEST_VALUE,
    Message,
    MessageError,
    ValuesNotTaken,
    in_si,
    numbers_of,
    shot_message,
)  # fmt: skip
from clubface.shots.open_connect import MOST_CLIENTS
from clubface.support.sockets import LOOPBACK, listen_on
from clubface.units import to_si

TICK = 0.2
"""Longest wait before checking the clock and the stop request [s]."""
RETRY_AFTER = 2.0
"""Time between two connection attempts [s]."""
ANSWER_TIMEOUT = 10.0
"""Time within which a device must answer the start message [s]."""
Keep = Callable[[Message], object]
Report = Callable[[str], object]

PORT, PATH = 5880, "/frp"
"""Default port and path of a device."""
VERSION = "0.1.0"
UNFINISHED = 5.0
"""Time after which an unfinished shot is taken as it is [s]."""
MOST_OPEN = 32
"""Maximum number of unfinished shots per connection; beyond it the oldest is taken as it is."""
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
"""Quantity of each field and its unit, or the dimension of a text with a unit."""
PARTS = {"ball_flight": ("ball", BALL), "club_path": ("club", CLUB), "face_impact": ("impact", IMPACT)}
"""Object and fields of each kind of event that holds values."""
OF_BALL = {quantity for quantity, _ in BALL.values()} | {"smash"}


def critical_alert(reason: str) -> str:
    """Return the message sent before a connection is closed."""
    return json.dumps({"kind": "alert", "severity": "critical", "message": reason})


def text_to_object(text: str | bytes) -> dict[str, Any] | None:
    """Return the JSON object of a frame; None for anything else, which the protocol ignores."""
    if len(text) > LARGEST:
        return None
    try:
        result = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return result if isinstance(result, dict) else None


@dataclass
class _Open:
    """An unfinished shot."""

    device: str
    number: int
    identity: str
    heard: float
    values: dict[str, float] = field(default_factory=dict)
    notes: list[Note] = field(default_factory=list)


class ShotCollector:
    """Combines the events of a connection into messages."""

    def __init__(self) -> None:
        self.has_begun = False  # whether the device has answered the start message
        self._open: dict[str, _Open] = {}

    def feed(self, data: Mapping[str, Any]) -> list[Message | MessageError]:
        """Return the messages an object completes: shots, states, and errors for what cannot be used."""
        if data.get("kind") == "init":
            self.has_begun = True
            return []
        event = data.get("event")
        alert = event if isinstance(event, Mapping) else data
        if "alert" in (data.get("kind"), alert.get("kind")):
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
        finished = self._taken([shot.identity] if kind == "shot_finished" else [])
        return finished + self._taken([*self._open][: max(len(self._open) - MOST_OPEN, 0)])

    def overdue(self, now: float | None = None) -> list[Message | MessageError]:
        """Return the shots for which no event has arrived for some seconds."""
        limit = (time.monotonic() if now is None else now) - UNFINISHED
        return self._taken([identity for identity, each in self._open.items() if each.heard < limit])

    def rest(self) -> list[Message | MessageError]:
        """Return all unfinished shots, since the connection has ended."""
        return self._taken([*self._open])

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

    def _taken(self, identities: list[str]) -> list[Message | MessageError]:
        """Return the messages of shots, leaving out shots without any values."""
        result: list[Message | MessageError] = []
        for shot in map(self._open.pop, identities):
            if shot.values or shot.notes:
                try:
                    result.append(shot_message(Message(
                        kind="shot", device=shot.device, shot_number=shot.number, identity=shot.identity,
                        launch={name: value for name, value in shot.values.items() if name in OF_BALL},
                        delivery={name: value for name, value in shot.values.items() if name not in OF_BALL},
                        notes=tuple(shot.notes),
                    )))  # fmt: skip
                except MessageError as error:
                    result.append(error)
        return result


def _device(data: Mapping[str, Any]) -> str:
    name = data.get("device")
    return name.strip()[:100] if isinstance(name, str) and name.strip() else "a monitor"


def _read(shot: _Open, part: Any, name: str, fields: Mapping[str, tuple[str, str]]) -> None:
    """Add the values of a part to a shot; leave out unreadable fields, with a note."""
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
    shot.values |= {name: value for name, value in values.items() if value > 0.0 or name not in ("ball_speed", "speed")}


def _tagged(text: Any, kind: str) -> float | None:
    """Return the value of a text such as "67.2mps" [SI]; None if it is not of this kind."""
    match = _TAGGED.fullmatch(text) if isinstance(text, str) and len(text) < 40 else None
    if match is None or match[2] not in UNITS or (match[2] in _SPEEDS) != (kind == "speed"):
        return None
    value = float(match[1])
    return to_si(value, UNITS[match[2]]) if abs(value) < LARGEST_VALUE else None


class _Link:
    """Common part of both ways of connecting."""

    def __init__(self, keep: Keep, on_problem: Report, on_message: Keep) -> None:
        self._keep, self._report, self._on_message = keep, on_problem, on_message
        self._stopped = threading.Event()

    def _converse(self, socket: Any, name: str) -> None:
        """Receive a device's messages until the connection or the link ends."""
        from websockets.exceptions import ConnectionClosed

        collector, not_taken, waited = ShotCollector(), ValuesNotTaken(), 0.0
        try:
            socket.send(json.dumps({"kind": "start", "version": [VERSION], "name": "clubface"}))
            while not self._stopped.is_set():
                try:
                    text = socket.recv(timeout=TICK)
                except TimeoutError:
                    waited += TICK
                    if not collector.has_begun and waited > ANSWER_TIMEOUT:
                        socket.send(critical_alert("no answer to start"))
                        self._report(f"{name} did not answer and is disconnected")
                        return
                else:
                    if (data := text_to_object(text)) is not None:
                        self._take(collector.feed(data), name, not_taken)
                self._take(collector.overdue(), name, not_taken)
        except ConnectionClosed:
            pass
        finally:
            self._take(collector.rest(), name, not_taken)

    def _take(self, messages: list[Message | MessageError], name: str, not_taken: ValuesNotTaken) -> None:
        for each in messages:
            if isinstance(each, MessageError):
                self._report(f"{name}: {each}")
                continue
            for sentence in not_taken.sentences(each):
                self._report(sentence)
            if each.kind == "shot":
                self._keep(each)
            self._on_message(each)


class FlightRelayListener(_Link):
    """Accepts connections from devices, on this machine; port 0 picks a free one, given by the attribute ``port``.

    ``keep`` is called with every shot, before ``on_message``, which is called with every message; ``on_problem`` with a
    sentence for every unusable message, and when a device connects or leaves; all on other threads. A port that is
    taken or not allowed raises a ``LinkError``.
    """

    def __init__(self, port: int, keep: Keep, on_problem: Report, on_message: Keep = lambda message: None) -> None:
        from websockets.sync.server import serve

        super().__init__(keep, on_problem, on_message)
        self._places = threading.BoundedSemaphore(MOST_CLIENTS)
        listening = listen_on(port, waiting=MOST_CLIENTS)
        self.port: int = listening.getsockname()[1]
        self.address = f"{LOOPBACK}:{self.port}"
        # Browsers send the page's origin; monitors send none.
        self._server = serve(self._serve, sock=listening, origins=[None], max_size=LARGEST, compression=None)
        threading.Thread(target=self._server.serve_forever, name="flight-relay", daemon=True).start()

    def _serve(self, socket: Any) -> None:
        name = "{}:{}".format(*socket.remote_address[:2])
        if not self._places.acquire(blocking=False):
            socket.send(critical_alert(f"{MOST_CLIENTS} devices are connected"))
            self._report(f"{name} was turned away: {MOST_CLIENTS} devices are connected")
            return
        try:
            self._report(f"{name} connected")
            self._converse(socket, name)
            self._report(f"{name} left")
        finally:
            self._places.release()

    def close(self) -> None:
        """Close all connections."""
        self._stopped.set()
        self._server.shutdown()


class FlightRelayClient(_Link):
    """Connects to a device or a bridge on its own thread, retrying until it is there.

    The address is such as ``ws://localhost:5880/frp``, whose path may be left out; the functions are called as by
    :class:`FlightRelayListener`.
    """

    def __init__(self, address: str, keep: Keep, on_problem: Report, on_message: Keep = lambda message: None) -> None:
        super().__init__(keep, on_problem, on_message)
        self.is_connected = False
        self.address = _whole_address(address)
        self._thread = threading.Thread(target=self._run, name="flight-relay", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        from websockets.exceptions import InvalidHandshake
        from websockets.sync.client import connect

        while not self._stopped.is_set():
            with (
                suppress(OSError, InvalidHandshake),
                connect(
                    self.address,
                    max_size=LARGEST,
                    compression=None,
                    open_timeout=ANSWER_TIMEOUT,
                    close_timeout=1.0,
                    proxy=None,
                ) as socket,
            ):
                self.is_connected = True
                self._report(f"connected to {self.address}")
                try:
                    self._converse(socket, self.address)
                finally:
                    self.is_connected = False
                self._report(f"{self.address} left")
            self._stopped.wait(RETRY_AFTER)

    def close(self) -> None:
        """End the connection."""
        self._stopped.set()
        self._thread.join(5.0)


def _whole_address(address: str) -> str:
    """Return the address of a device, with the default path if it has none."""
    from websockets.exceptions import InvalidURI
    from websockets.uri import parse_uri

    try:
        parse_uri(address).host.encode("idna")
    except (InvalidURI, ValueError):
        example = "an address such as ws://localhost:5880/frp, or a port"
        raise InputError("flight_relay", address, example) from None
    parts = urlsplit(address)
    return address if parts.path.strip("/") else f"{parts.scheme}://{parts.netloc}{PATH}"
