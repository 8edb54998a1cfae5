"""GSPro Open Connect v1: the JSON messages that launch monitors and simulators exchange over a local socket.

:class:`Listener` acts as the simulator and yields a monitor's shots. :class:`Sender` acts as the monitor and sends
launches to a simulator.

The fields follow the protocol's page (gsprogolf.com, "GSPro Open Connect v1 Documentation"): speeds in mph, angles in
degrees, spin in rpm, and carry in yards or metres according to ``Units``. HLA, spin axis and sidespin are positive to
the right. The page does not define signs for club data. Here path and face angle are positive to the right for either
hand, the horizontal impact point is positive towards the toe in mm, as connectors for the protocol write it, and the
closure rate is in deg/s. Clients must send a number, so zero club speed, loft or closure rate, or zeros for both impact
offsets, mean not measured; so do impossible values. Total spin and spin axis are required, backspin and sidespin are
not.
"""

from __future__ import annotations

import json
import re
import selectors
import socket
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Any, NamedTuple, Self

from clubface.errors import InputError, LinkError, shortened
from clubface.results.notes import Note, note
from clubface.shots.messages import (
    Broken,
    Message,
    MessageError,
    ObjectStream,
    ValuesNotTaken,
    in_si,
    in_units,
    number_of,
    numbers_of,
    object_of,
    recorded,
    shot_message,
    whole_spin,
)  # fmt: skip
from clubface.simulation.launch import Launch
from clubface.simulation.spin import BACK, SIDE
from clubface.support.arrays import ValueLike
from clubface.support.checks import check_choice
from clubface.support.sockets import CHUNK, LOOPBACK, Connection, listen_on

__all__ = [
    "MOST_CLIENTS", "OPEN_CONNECT", "Dialect", "Listener", "Message", "MessageError", "Reply", "Sender", "from_json",
    "heartbeat", "recorded", "to_json",
]  # fmt: skip

PORT = 921
"""GSPro's port; ports below 1024 need special rights on some systems."""
MOST_CLIENTS = 8
TICK = 0.05
"""Longest wait before checking the clock and the stop request [s]."""
NO_ANSWER = "did not answer"
"""Beginning of the error for a shot that may have arrived nevertheless."""
PARTIAL = 5.0
"""Time after which an unfinished message is dropped [s]."""
SILENT = 10.0
"""Time after which a connection that has sent no message is closed [s]."""
IDLE = 1800.0
"""Idle time after which any other connection is closed [s]; long, as not every monitor sends heartbeats."""

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
"""Quantity and unit of each field; the club's ``SpeedAtImpact`` is not used."""
NEEDED = ("Speed", "HLA", "VLA")
"""Fields required for a launch."""
NEVER_ZERO = ("speed", "loft", "closure")
"""Club quantities for which zero means not measured."""
CARRY_UNITS = {
    **dict.fromkeys(("yards", "yard", "yds", "yd"), "yd"),
    **dict.fromkeys(("meters", "metres", "meter", "metre", "m"), "m"),
}
"""Unit of carry by the value of ``Units``."""
OK, PLAYER, FAILED = 200, 201, 501
HANDS = {"right": "RH", "left": "LH"}


def from_json(data: Mapping[str, Any]) -> Message:
    """Return the message in a JSON object; a :class:`MessageError` names a required field that is missing or wrong.

    Club, spin and carry fields that are not numbers, impossible values, and contradictory spins are left out and
    reported in ``notes`` and ``impossible``.
    """
    options: Mapping[str, Any] = {f"Contains{name}": isinstance(data.get(name), Mapping) for name in
                                  ("BallData", "ClubData")}  # fmt: skip
    if data.get("ShotDataOptions") is not None or not any(options.values()):
        options = object_of(data, "ShotDataOptions")
    has_ball, has_club, is_heartbeat, is_ready, sees_ball = (
        _flag(options, name)
        for name in (
            "ContainsBallData", "ContainsClubData", "IsHeartBeat", "LaunchMonitorIsReady", "LaunchMonitorBallDetected",
        )
    )  # fmt: skip
    device = data.get("DeviceID")
    if not isinstance(device, str) or not device.strip():
        raise MessageError("DeviceID must be a text")
    version = str(data.get("APIversion", VERSION)).strip()
    if version.partition(".")[0] != VERSION:
        raise MessageError(f"APIversion is {version[:20]!r}; it must be {VERSION!r}")
    is_shot = not is_heartbeat and bool(has_ball or has_club)
    number = number_of(data, "ShotNumber", "") if is_shot or "ShotNumber" in data else 0.0
    if number < 0.0:
        raise MessageError("ShotNumber must be 0 or more")
    notes: list[Note] = []
    launch: dict[str, float] = {}
    delivery: dict[str, float] = {}
    if is_shot:
        parts = [name for name, has in (("BallData", has_ball), ("ClubData", has_club)) if has]
        notes += [note("message-part-missing", part=name) for name in parts if data.get(name) is None]
        if "ClubData" in parts and data.get("ClubData") is not None:
            delivery = _delivery(object_of(data, "ClubData"), notes)
        if "BallData" in parts and (data.get("BallData") is not None or not delivery):
            launch = _launch(data, notes)
        if not launch and not delivery:
            raise MessageError("; ".join(["ClubData holds nothing but zeros", *map(str, notes)]))
    message = Message(
        kind="shot" if is_shot else "heartbeat" if is_heartbeat else "status", device=device.strip(),
        shot_number=int(number), delivery=delivery, launch=launch, notes=tuple(notes), is_ready=is_ready,
        sees_ball=sees_ball,
    )  # fmt: skip
    return shot_message(message) if is_shot else message


def _launch(data: Mapping[str, Any], notes: list[Note]) -> dict[str, float]:
    ball = object_of(data, "BallData")
    units = data.get("Units")
    carry_unit = CARRY_UNITS.get(str("yards" if units is None else units).strip().lower())
    if carry_unit is None:
        notes.append(note("message-units", value=shortened(repr(units), 40)))
    given = numbers_of(ball, BALL, "BallData.", notes, NEEDED)
    if not given["Speed"] > 0.0:
        raise MessageError("BallData.Speed must be above 0")
    back, side, total, axis = (given.get(name) for name in ("BackSpin", "SideSpin", "TotalSpin", "SpinAxis"))
    if back == 0.0 == side and total is not None:
        del given["BackSpin"], given["SideSpin"]
    if total == 0.0 == axis:
        del given["SpinAxis"]
    if not given.get("CarryDistance") or carry_unit is None:
        given.pop("CarryDistance", None)
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


def to_json(
    launch: Launch | Mapping[str, ValueLike],
    delivery: Mapping[str, ValueLike] | None = None,
    *,
    shot_number: int,
    device: str = "clubface",
) -> dict[str, Any]:
    """Return the message of a shot.

    Parameters
    ----------
    launch
        A :class:`Launch` of a single shot, or a mapping of SI values or text with units: ``ball_speed``, ``launch``,
        and if known ``azimuth``, ``carry`` and two of ``backspin``, ``sidespin``, ``total_spin`` and ``spin_axis``. The
        message needs all four; a warning reports what is assumed if they cannot be derived.
    delivery
        The same for the club; default the delivery of a :class:`Launch`, or none.
    shot_number, device
        Shot number and device name in the message.
    """
    if isinstance(launch, Launch):
        delivery = delivery if delivery is not None else launch.delivery
        launch = {name: getattr(launch, name) for name in ("ball_speed", "launch", "azimuth", BACK, SIDE)}
    ball = in_units({**launch, **whole_spin(launch)}, BALL)
    if not ball.get("Speed", 0.0) > 0.0:
        raise InputError("ball_speed", launch.get("ball_speed"), "above 0 in a message to a simulator")
    if "VLA" not in ball:
        raise InputError("launch", None, "give the launch angle, which a message to a simulator needs")
    ball.setdefault("HLA", 0.0)
    club = dict.fromkeys((*CLUB, "SpeedAtImpact"), 0.0) | in_units(delivery or {}, CLUB)
    return _outgoing(device, shot_number, {"BallData": ball, "ClubData": club})


def heartbeat(*, device: str = "clubface", is_ready: bool = True) -> dict[str, Any]:
    """Return the heartbeat message of a monitor."""
    return _outgoing(device, 0, {}, is_ready=is_ready)


def _outgoing(
    device: str, shot_number: int, parts: Mapping[str, Mapping[str, float]], *, is_ready: bool = True
) -> dict[str, Any]:
    """Return the message of a shot with ball and club data, or a heartbeat without data."""
    return {
        "DeviceID": device,
        "Units": "Yards",
        "ShotNumber": shot_number,
        "APIversion": VERSION,
        **parts,
        "ShotDataOptions": {
            "ContainsBallData": "BallData" in parts,
            "ContainsClubData": any(parts.get("ClubData", {}).values()),
            "LaunchMonitorIsReady": is_ready,
            "LaunchMonitorBallDetected": True,
            "IsHeartBeat": not parts,
        },
    }


class Dialect(NamedTuple):
    """One protocol between monitors and simulators over a socket."""

    name: str  # name of the protocol
    port: int  # default port
    read: Callable[[Mapping[str, Any]], Message]  # reads a JSON object; raises MessageError
    answer: Callable[[Message], dict[str, Any] | None]  # returns the answer to a message, or None
    refusal: Callable[[str], dict[str, Any]]  # returns the answer to an invalid message, from the reason
    ending: bytes = b""  # end of every answer


OPEN_CONNECT = Dialect(
    "open-connect",
    PORT,
    from_json,
    lambda message: {"Code": OK, "Message": "Shot received successfully"} if message.kind == "shot" else None,
    lambda reason: {"Code": FAILED, "Message": reason},
)
_WEB = re.compile(rb"(?:GET|HEAD|POST|PUT|DELETE|OPTIONS|PATCH|CONNECT|TRACE) ")
"""Beginning of a web request: a web page must not be able to send fake shots."""


class _Client:
    def __init__(self, connection: socket.socket, name: str) -> None:
        self.connection = connection
        self.name = name
        self.stream = ObjectStream()
        self.heard = self.spoke = time.monotonic()
        self.has_spoken = self.has_begun = False
        self.not_taken = ValuesNotTaken()


class Listener:
    """Listens for launch monitors; iterate over :meth:`messages` in a ``with`` statement.

    A shot is answered with code 200 once ``keep`` has returned, an invalid message with code 501 and the reason.
    Heartbeats and states are not answered. Several monitors may be connected at once. A connection without any message
    is closed after 10 s, any other after half an hour of silence. If all places are taken, the connection silent for
    longest, and for at least 10 s, makes room.

    Parameters
    ----------
    port
        The port; 0 picks a free one, given by the attribute ``port``.
    host
        The address to listen on; by default other machines cannot reach the listener.
    hand, club
        Player information sent to every monitor, with code 201: "right" or "left", and the club's short name, such as
        "DR".
    keep
        Called with every shot before it is acknowledged. If it raises, the shot is answered with code 501, and the
        error ends the iteration.
    on_problem
        Called with a sentence for invalid messages, for impossible values, and when a monitor connects or leaves.
    dialect
        The protocol.

    Raises
    ------
    LinkError
        The port is taken or not allowed.
    """

    def __init__(
        self,
        port: int = PORT,
        *,
        host: str = LOOPBACK,
        hand: str | None = None,
        club: str = "",
        keep: Callable[[Message], object] | None = None,
        on_problem: Callable[[str], object] | None = None,
        dialect: Dialect = OPEN_CONNECT,
    ) -> None:
        self._dialect = dialect
        if hand is not None:
            check_choice("hand", hand, HANDS)
        self._player = hand and {"Handed": HANDS[hand], "Club": club}
        self._keep = keep or (lambda message: None)
        self._report = on_problem or (lambda message: None)
        self._selector = selectors.DefaultSelector()
        self._stopped = False
        self._socket = listen_on(port, host=host, waiting=MOST_CLIENTS)
        self._socket.setblocking(False)
        self.port: int = self._socket.getsockname()[1]
        self._selector.register(self._socket, selectors.EVENT_READ)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def stop(self) -> None:
        """End the iteration over messages; may be called from another thread."""
        self._stopped = True

    def close(self) -> None:
        """Close all connections."""
        self._stopped = True
        if self._selector.get_map() is None:
            return
        for key in list(self._selector.get_map().values()):
            key.fileobj.close()  # pyright: ignore[reportAttributeAccessIssue]
        self._selector.close()

    def messages(self, *, timeout: float | None = None) -> Iterator[Message]:
        """Yield messages as they arrive, until :meth:`stop` or ``timeout`` seconds [s] without one."""
        last = time.monotonic()
        while not self._stopped:
            for key, _ in self._selector.select(TICK):
                if key.data is None:
                    self._accept()
                    continue
                for message in self._read(key.data):
                    last = time.monotonic()
                    yield message
                    if self._stopped:
                        return
            self._close_stale()
            if timeout is not None and time.monotonic() - last > timeout:
                return

    def _clients(self) -> list[_Client]:
        return [key.data for key in self._selector.get_map().values() if key.data is not None]

    def _accept(self) -> None:
        try:
            connection, address = self._socket.accept()
        except OSError:
            return
        name = f"{address[0]}:{address[1]}"
        if len(self._clients()) >= MOST_CLIENTS and not self._make_room():
            self._report(f"{name} was turned away: {MOST_CLIENTS} monitors are connected")
            connection.close()
            return
        connection.setblocking(False)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        client = _Client(connection, name)
        self._selector.register(connection, selectors.EVENT_READ, client)
        self._report(f"{name} connected")
        if self._player is not None:
            answer = {"Code": PLAYER, "Message": "GSPro Player Information", "Player": self._player}
            self._answer(client, answer)

    def _read(self, client: _Client) -> Iterator[Message]:
        try:
            data = client.connection.recv(CHUNK)
        except BlockingIOError:
            return
        except OSError as error:
            self._leave(client, f"was lost: {error.strerror or error}")
            return
        if not data:
            self._leave(client, "left in the middle of a message" if client.stream.is_partial else "left")
            return
        client.heard = time.monotonic()
        if not client.has_begun and _WEB.match(data):
            self._leave(client, "is a web page and no monitor, and is disconnected")
            return
        client.has_begun = True
        for received in client.stream.feed(data):
            if not isinstance(received, Broken):
                client.spoke, client.has_spoken = client.heard, True
            try:
                if isinstance(received, Broken):
                    raise MessageError(received.reason)
                message = self._dialect.read(received)
            except MessageError as error:
                self._report(f"{client.name}: {error}")
                self._answer(client, self._dialect.refusal(str(error)))
                continue
            for sentence in client.not_taken.sentences(message):
                self._report(sentence)
            if message.kind == "shot":
                try:
                    self._keep(message)
                except BaseException:
                    self._answer(client, self._dialect.refusal("the shot could not be kept"))
                    raise
            if (answer := self._dialect.answer(message)) is not None:
                self._answer(client, answer)
            yield message

    def _answer(self, client: _Client, answer: dict[str, Any]) -> None:
        """Send an answer; a client that does not read it is disconnected."""
        try:
            client.connection.sendall(json.dumps(answer).encode() + self._dialect.ending)
        except OSError as error:
            self._leave(client, f"was lost: {error.strerror or error}")

    def _leave(self, client: _Client, how: str) -> None:
        with suppress(KeyError, ValueError):
            self._selector.unregister(client.connection)
            self._report(f"{client.name} {how}")
        client.connection.close()

    def _make_room(self) -> bool:
        """Close the connection silent for longest, if for long enough; return whether there is room."""
        quietest = min(self._clients(), key=lambda client: client.spoke)
        if time.monotonic() - quietest.spoke <= SILENT:
            return False
        self._leave(quietest, "was silent longest, and makes room for another")
        return True

    def _close_stale(self) -> None:
        """Drop unfinished messages, and close connections that have been silent for too long."""
        now = time.monotonic()
        for client in self._clients():
            if client.stream.is_partial and now - client.heard > PARTIAL:
                client.stream.drop()
                self._report(f"{client.name}: a message did not end within {PARTIAL:g} s")
                self._answer(client, self._dialect.refusal("the message did not end"))
            if now - client.spoke > (IDLE if client.has_spoken else SILENT):
                self._leave(client, "was silent for too long and is disconnected")


class Reply(NamedTuple):
    """The answer to a shot: code 200 if it was accepted, 5xx if it was not."""

    code: int
    message: str

    @property
    def was_taken(self) -> bool:
        """Whether the simulator accepted the shot."""
        return 200 <= self.code < 300


class Sender:
    """Sends shots to a simulator as a launch monitor does; use it in a ``with`` statement.

    Parameters
    ----------
    port, host
        Address of the simulator.
    device
        Device name in the messages.
    timeout
        Maximum wait for the connection and for each answer [s].

    Attributes
    ----------
    player
        The simulator's latest player information, as ``{"Handed": "RH", "Club": "DR"}``, or None.

    Raises
    ------
    LinkError
        Nobody listens there, the connection was lost, or no answer came in time.
    """

    def __init__(
        self, port: int = PORT, *, host: str = LOOPBACK, device: str = "clubface", timeout: float = 5.0
    ) -> None:
        self._connection = Connection(port, host=host, timeout=timeout)
        self._device = device
        self._timeout = timeout
        self._stream = ObjectStream()
        self._number = 0
        self.player: Mapping[str, Any] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the connection."""
        self._connection.close()

    def send(self, launch: Launch | Mapping[str, ValueLike], delivery: Mapping[str, ValueLike] | None = None) -> Reply:
        """Send a shot, as :func:`to_json` takes it, with the next shot number, and return the answer."""
        message = to_json(launch, delivery, shot_number=self._number + 1, device=self._device)
        self._number += 1
        self._receive(0.0)  # earlier messages are not the answer to this shot
        self._connection.send(message)
        ends = time.monotonic() + self._timeout
        while (left := ends - time.monotonic()) > 0.0:
            for answer in self._receive(left):
                if answer.code != PLAYER:
                    return answer
        raise LinkError(self._connection.address, f"{NO_ANSWER} shot {self._number} within {self._timeout:g} s")

    def heartbeat(self, *, is_ready: bool = True) -> None:
        """Send a heartbeat, which the simulator does not answer."""
        self._connection.send(heartbeat(device=self._device, is_ready=is_ready))

    def _receive(self, wait: float) -> list[Reply]:
        """Return the answers received within ``wait`` [s], and store player information."""
        received = []
        for answer in self._stream.feed(self._connection.receive(wait)):
            if isinstance(answer, Broken):
                raise LinkError(self._connection.address, f"sent an invalid answer: {answer.reason}")
            code = answer.get("Code")
            if isinstance(code, bool) or not isinstance(code, int):
                raise LinkError(self._connection.address, "answered without a code")
            if isinstance(answer.get("Player"), Mapping):
                self.player = answer["Player"]
            received.append(Reply(code, str(answer.get("Message", ""))))
        return received
