"""Flight Relay over a WebSocket, as the controller: connected to a device, or listening for devices that connect.

Most devices and bridges listen, and clubface connects to them; some connect to who listens. A web page is refused,
which any browser would otherwise let make up shots.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any
from urllib.parse import urlsplit

from clubface.errors import InputError
from clubface.shots.flight_relay import PATH, ShotCollector, critical_alert, start_message, text_to_object
from clubface.shots.messages import LARGEST, Message, MessageError, ValuesNotTaken
from clubface.shots.open_connect import MOST_CLIENTS
from clubface.support.sockets import listen_on

__all__ = ["FlightRelayClient", "FlightRelayListener"]

TICK = 0.2
"""Longest wait before the clock and the request to stop are looked at [s]."""
RETRY_AFTER = 2.0
"""Time between two tries to reach a device [s]."""
ANSWER_TIMEOUT = 10.0
"""Time within which a device must answer the beginning [s]."""
Keep = Callable[[Message], object]
Report = Callable[[str], object]


class _Link:
    """What both ways of connecting share."""

    def __init__(self, keep: Keep, on_problem: Report, on_message: Keep) -> None:
        self._keep, self._report, self._on_message = keep, on_problem, on_message
        self._stopped = threading.Event()

    def _converse(self, socket: Any, name: str) -> None:
        """Hear a device out until the connection or the link ends."""
        from websockets.exceptions import ConnectionClosed

        collector, not_taken, waited = ShotCollector(), ValuesNotTaken(), 0.0
        try:
            socket.send(json.dumps(start_message()))
            while not self._stopped.is_set():
                try:
                    text = socket.recv(timeout=TICK)
                except TimeoutError:
                    waited += TICK
                    if not collector.has_begun and waited > ANSWER_TIMEOUT:
                        socket.send(json.dumps(critical_alert("no answer to start")))
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
    """Listens for devices that open the connection, on this machine.

    Parameters
    ----------
    port
        The port. 0 takes a free one, which is then the attribute ``port``.
    keep
        Called with every shot, before ``on_message``, which is called with every message; both on threads.
    on_problem
        Called with a sentence for what cannot be used, and when a device connects or leaves.

    Raises
    ------
    LinkError
        The port is taken or not allowed.
    """

    def __init__(self, port: int, keep: Keep, on_problem: Report, on_message: Keep = lambda message: None) -> None:
        from websockets.sync.server import serve

        super().__init__(keep, on_problem, on_message)
        self._places = threading.BoundedSemaphore(MOST_CLIENTS)
        listening = listen_on(port, waiting=MOST_CLIENTS)
        self.port: int = listening.getsockname()[1]
        # Browsers name the page that connects as the origin; monitors name none.
        self._server = serve(self._serve, sock=listening, origins=[None], max_size=LARGEST, compression=None)
        threading.Thread(target=self._server.serve_forever, name="flight-relay", daemon=True).start()

    def _serve(self, socket: Any) -> None:
        name = "{}:{}".format(*socket.remote_address[:2])
        if not self._places.acquire(blocking=False):
            socket.send(json.dumps(critical_alert(f"{MOST_CLIENTS} devices are connected")))
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
    """Connects to a device or a bridge, again and again until it is there, on a thread of its own.

    Parameters
    ----------
    address
        As in ``ws://localhost:5880/frp``; the path may be left out.
    keep, on_problem, on_message
        As of :class:`FlightRelayListener`.
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
    """Return the address of a device, with the usual path where it has none."""
    from websockets.exceptions import InvalidURI
    from websockets.uri import parse_uri

    try:
        parse_uri(address).host.encode("idna")
    except (InvalidURI, ValueError):
        example = "an address such as ws://localhost:5880/frp, or a port"
        raise InputError("flight_relay", address, example) from None
    parts = urlsplit(address)
    return address if parts.path.strip("/") else f"{parts.scheme}://{parts.netloc}{PATH}"
