"""The side of the launch monitor: shots sent to a simulator, and the answers."""

from __future__ import annotations

import json
import socket
import time
from collections.abc import Mapping
from typing import Any, NamedTuple, Self

from clubface.errors import InputError, LinkError
from clubface.launch_monitor.open_connect.fields import PLAYER
from clubface.launch_monitor.open_connect.framing import Broken, ObjectStream
from clubface.launch_monitor.open_connect.listener import LOOPBACK, PORT, check_port
from clubface.launch_monitor.open_connect.outgoing import heartbeat, to_json


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
        if not timeout > 0.0:
            raise InputError("timeout", timeout, "above 0 s")
        check_port(port, 1)
        self._address = f"{host}:{port}"
        self._device = device
        self._timeout = timeout
        self._stream = ObjectStream()
        self._number = 0
        self.player: Mapping[str, Any] | None = None
        try:
            self._socket = socket.create_connection((host, port), timeout)
        except OSError as error:
            raise self._problem("cannot be reached", error) from None
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the connection."""
        self._socket.close()

    def send(self, launch: Any, delivery: Mapping[str, Any] | None = None) -> Reply:
        """Send a shot, as :func:`to_json` takes it, with the next shot number, and return the answer."""
        message = to_json(launch, delivery, shot_number=self._number + 1, device=self._device)
        self._number += 1
        self._receive(0.0)  # what came before is no answer to this shot
        self._write(message)
        ends = time.monotonic() + self._timeout
        while (left := ends - time.monotonic()) > 0.0:
            for answer in self._receive(left):
                if answer.code != PLAYER:
                    return answer
        raise LinkError(self._address, f"did not answer shot {self._number} within {self._timeout:g} s")

    def heartbeat(self, *, is_ready: bool = True) -> None:
        """Tell the simulator that the monitor is there; the simulator does not answer."""
        self._write(heartbeat(device=self._device, is_ready=is_ready))

    def _write(self, message: dict[str, Any]) -> None:
        self._socket.settimeout(self._timeout)
        try:
            self._socket.sendall(json.dumps(message, allow_nan=False).encode())
        except OSError as error:
            raise self._problem("was lost", error) from None

    def _receive(self, wait: float) -> list[Reply]:
        """Return the answers that came within ``wait`` seconds [s]; of the player they say, it is kept."""
        self._socket.settimeout(wait)
        try:
            data = self._socket.recv(65_536)
        except (TimeoutError, BlockingIOError):
            return []
        except OSError as error:
            raise self._problem("was lost", error) from None
        if not data:
            raise LinkError(self._address, "closed the connection")
        found = []
        for answer in self._stream.feed(data):
            if isinstance(answer, Broken):
                raise LinkError(self._address, f"answered what is no answer: {answer.reason}")
            code = answer.get("Code")
            if isinstance(code, bool) or not isinstance(code, int):
                raise LinkError(self._address, "answered without a code")
            if isinstance(answer.get("Player"), Mapping):
                self.player = answer["Player"]
            found.append(Reply(code, str(answer.get("Message", ""))))
        return found

    def _problem(self, what: str, error: OSError) -> LinkError:
        return LinkError(self._address, f"{what}: {error.strerror or error}")
