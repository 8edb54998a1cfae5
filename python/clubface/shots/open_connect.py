"""GSPro Open Connect v1: the JSON messages that launch monitors and simulators exchange over a local socket.

:class:`Listener` takes the place of the simulator and yields the shots of a monitor. :class:`Sender` takes the place of
the monitor and sends launches to a simulator.
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

from clubface.errors import LinkError
from clubface.shots.messages import Broken, Message, MessageError, ObjectStream, ValuesNotTaken, recorded as recorded
from clubface.shots.open_connect_messages import FAILED, OK, PLAYER, from_json, heartbeat, player, reply, to_json
from clubface.support.sockets import CHUNK, LOOPBACK, Connection, listen_on

__all__ = [
    "MOST_CLIENTS", "OPEN_CONNECT", "Dialect", "Listener", "Message", "MessageError", "Reply", "Sender", "from_json",
    "heartbeat", "recorded", "to_json",
]  # fmt: skip

PORT = 921
"""The port of GSPro; ports below 1024 need rights on some systems."""
MOST_CLIENTS = 8
TICK = 0.05
"""Longest wait before the clock and the request to stop are looked at [s]."""
NO_ANSWER = "did not answer"
"""How the message about a shot begins that may have arrived all the same."""
PARTIAL = 5.0
"""Time after which a message that has begun and not ended is given up [s]."""
SILENT = 10.0
"""Time after which a connection that has not sent one message is closed [s]."""
IDLE = 1800.0
"""The same since its last message for one that has [s]: people talk and eat, and not every monitor sends heartbeats."""


class Dialect(NamedTuple):
    """How monitors and simulators talk over a socket in one protocol.

    Attributes
    ----------
    name
        Of the protocol.
    port
        Its usual port.
    read
        From a JSON object to the message in it; raises :class:`MessageError`.
    answer
        What a message is answered with, None for nothing.
    refusal
        The answer to a message that cannot be used, for which the reason is given.
    ending
        What stands behind an answer.
    """

    name: str
    port: int
    read: Callable[[Mapping[str, Any]], Message]
    answer: Callable[[Message], dict[str, Any] | None]
    refusal: Callable[[str], dict[str, Any]]
    ending: bytes = b""


OPEN_CONNECT = Dialect(
    "open-connect",
    PORT,
    from_json,
    lambda message: reply(OK, "Shot received successfully") if message.kind == "shot" else None,
    lambda reason: reply(FAILED, reason),
)
_WEB = re.compile(rb"(?:GET|HEAD|POST|PUT|DELETE|OPTIONS|PATCH|CONNECT|TRACE) ")
"""How what a browser sends begins: a page on the web must not make up shots."""


class _Client:
    """One connection."""

    def __init__(self, connection: socket.socket, name: str) -> None:
        self.connection = connection
        self.name = name
        self.stream = ObjectStream()
        self.heard = self.spoke = time.monotonic()
        self.has_spoken = self.has_begun = False
        self.not_taken = ValuesNotTaken()

    def is_idle(self, now: float) -> bool:
        """Whether it has been silent for too long."""
        return now - self.spoke > (IDLE if self.has_spoken else SILENT)


class Listener:
    """Listens for launch monitors on the local machine; iterate over :meth:`messages`, in a ``with`` statement.

    A shot is answered with code 200 once ``keep`` has returned, and a message that cannot be used with code 501 and the
    reason. Heartbeats and states are not answered. Several monitors may be connected at once, and may come and go. A
    connection that sends no message is closed after 10 s, one that has sent some after half an hour; and where all
    places are taken, the one that has been silent longest, and for 10 s, makes room.

    Parameters
    ----------
    port
        The port. 0 takes a free one, which is then the attribute ``port``.
    host
        The address to listen on. Other machines can reach the listener only if this is not the default.
    hand, club
        What every monitor that connects receives, with code 201: "right" or "left", and the club's short name, such as
        "DR".
    keep
        Called with every shot before it is acknowledged. If it raises, the shot is answered with code 501, and the
        error ends the iteration.
    on_problem
        Called with a sentence for bytes that are not a message, for values that no shot can have, and when a monitor
        connects or leaves.
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
        self._player = player(hand, club) if hand is not None else None
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
        """End the iteration over messages. Another thread may call this."""
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
        """Yield every message as it comes, until :meth:`stop`, or until none came for ``timeout`` seconds."""
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
            self._give_up_partial()
            self._close_idle()
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
        if len(self._clients()) >= MOST_CLIENTS and not self._made_room():
            self._report(f"{name} was turned away: {MOST_CLIENTS} monitors are connected")
            connection.close()
            return
        connection.setblocking(False)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        client = _Client(connection, name)
        self._selector.register(connection, selectors.EVENT_READ, client)
        self._report(f"{name} connected")
        if self._player is not None:
            self._answer(client, reply(PLAYER, "GSPro Player Information", self._player))

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
        """Send an answer; a client that does not read is dropped rather than waited for."""
        try:
            client.connection.sendall(json.dumps(answer).encode() + self._dialect.ending)
        except OSError as error:
            self._leave(client, f"was lost: {error.strerror or error}")

    def _leave(self, client: _Client, how: str) -> None:
        with suppress(KeyError, ValueError):
            self._selector.unregister(client.connection)
            self._report(f"{client.name} {how}")
        client.connection.close()

    def _made_room(self) -> bool:
        """Close the connection that has been silent longest, if it is long; return whether there is room."""
        quietest = min(self._clients(), key=lambda client: client.spoke)
        if time.monotonic() - quietest.spoke <= SILENT:
            return False
        self._leave(quietest, "was silent longest, and makes room for another")
        return True

    def _close_idle(self) -> None:
        now = time.monotonic()
        for client in self._clients():
            if client.is_idle(now):
                self._leave(client, "was silent for too long and is disconnected")

    def _give_up_partial(self) -> None:
        now = time.monotonic()
        for client in self._clients():
            if client.stream.is_partial and now - client.heard > PARTIAL:
                client.stream.drop()
                self._report(f"{client.name}: a message did not end within {PARTIAL:g} s")
                self._answer(client, self._dialect.refusal("the message did not end"))


class Reply(NamedTuple):
    """The answer to a shot: code 200 if it was accepted, 5xx if it was not."""

    code: int
    message: str

    @property
    def was_taken(self) -> bool:
        """Whether the simulator accepted the shot."""
        return 200 <= self.code < 300


class Sender:
    """Sends shots to a simulator on the local machine, as a launch monitor does; use it in a ``with`` statement.

    Parameters
    ----------
    port, host
        Where the simulator listens.
    device
        The device name in the messages.
    timeout
        How long to wait for the connection and for each answer [s].

    Attributes
    ----------
    player
        What the simulator last said about its player, as ``{"Handed": "RH", "Club": "DR"}``, or None.

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

    def send(self, launch: Any, delivery: Mapping[str, Any] | None = None) -> Reply:
        """Send a shot, as :func:`to_json` takes it, with the next shot number, and return the answer."""
        message = to_json(launch, delivery, shot_number=self._number + 1, device=self._device)
        self._number += 1
        self._receive(0.0)  # what came before is no answer to this shot
        self._connection.send(message)
        ends = time.monotonic() + self._timeout
        while (left := ends - time.monotonic()) > 0.0:
            for answer in self._receive(left):
                if answer.code != PLAYER:
                    return answer
        raise LinkError(self._connection.address, f"{NO_ANSWER} shot {self._number} within {self._timeout:g} s")

    def heartbeat(self, *, is_ready: bool = True) -> None:
        """Show the simulator that the monitor is there; the simulator does not answer."""
        self._connection.send(heartbeat(device=self._device, is_ready=is_ready))

    def _receive(self, wait: float) -> list[Reply]:
        """Return the answers that came within ``wait`` seconds [s]; the player that they name is kept."""
        received = []
        for answer in self._stream.feed(self._connection.receive(wait)):
            if isinstance(answer, Broken):
                raise LinkError(self._connection.address, f"answered what is no answer: {answer.reason}")
            code = answer.get("Code")
            if isinstance(code, bool) or not isinstance(code, int):
                raise LinkError(self._connection.address, "answered without a code")
            if isinstance(answer.get("Player"), Mapping):
                self.player = answer["Player"]
            received.append(Reply(code, str(answer.get("Message", ""))))
        return received
