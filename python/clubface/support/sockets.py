"""Sockets on this machine: port numbers, listening, and connections whose errors say what failed."""

from __future__ import annotations

import errno
import json
import socket
from collections.abc import Mapping
from typing import Any

from clubface.errors import InputError, LinkError

__all__ = ["CHUNK", "LOOPBACK", "Connection", "check_port", "listen_on"]

LOOPBACK = "127.0.0.1"
HIGHEST_PORT = 65535
ADVICE = {
    errno.EADDRINUSE: "; give another port",
    **dict.fromkeys((errno.EACCES, errno.EPERM), "; ports below 1024 need rights: give another"),
}
"""Advice for a port that cannot be opened, by error number."""
CHUNK = 65_536
"""Size of a read [bytes]."""


def check_port(port: int, lowest: int, name: str = "port") -> None:
    """Raise InputError for a value that is not a port number; ``name`` is the parameter or option."""
    if isinstance(port, bool) or not isinstance(port, int) or not lowest <= port <= HIGHEST_PORT:
        raise InputError(name, port, f"a whole number from {lowest} to {HIGHEST_PORT}")


def listen_on(port: int, *, host: str = LOOPBACK, waiting: int) -> socket.socket:
    """Return a socket that listens on a port; 0 chooses a free one.

    Parameters
    ----------
    port, host
        Port and address to listen on.
    waiting
        Maximum number of connections waiting to be accepted.

    Raises
    ------
    LinkError
        The port is taken or not allowed.
    """
    check_port(port, 0)
    try:
        return socket.create_server((host, port), backlog=waiting)
    except OSError as error:
        hint = ADVICE.get(error.errno or 0, "")
        raise LinkError(f"{host}:{port}", f"cannot be listened on: {error.strerror or error}{hint}") from None


class Connection:
    """A connection to a program that listens, such as a simulator.

    Parameters
    ----------
    port, host
        Port and address of the program.
    timeout
        Maximum time to wait for the connection, and for data to be sent [s].

    Raises
    ------
    LinkError
        Nothing listens there; or, from any method, the connection was lost.
    """

    def __init__(self, port: int, *, host: str = LOOPBACK, timeout: float = 5.0) -> None:
        if not timeout > 0.0:
            raise InputError("timeout", timeout, "above 0 s")
        check_port(port, 1)
        self.address = f"{host}:{port}"
        self._timeout = timeout
        try:
            self._socket = socket.create_connection((host, port), timeout)
        except OSError as error:
            raise self._problem("cannot be reached", error) from None
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def send(self, message: Mapping[str, Any], ending: bytes = b"") -> None:
        """Send a message as JSON, followed by ``ending``."""
        self._socket.settimeout(self._timeout)
        try:
            self._socket.sendall(json.dumps(message, allow_nan=False).encode() + ending)
        except OSError as error:
            raise self._problem("was lost", error) from None

    def receive(self, wait: float) -> bytes:
        """Return the data received, waiting up to ``wait`` seconds; empty if nothing arrives."""
        self._socket.settimeout(wait)
        try:
            data = self._socket.recv(CHUNK)
        except (TimeoutError, BlockingIOError):
            return b""
        except OSError as error:
            raise self._problem("was lost", error) from None
        if not data:
            raise LinkError(self.address, "closed the connection")
        return data

    def close(self) -> None:
        """Close the connection."""
        self._socket.close()

    def _problem(self, what: str, error: OSError) -> LinkError:
        return LinkError(self.address, f"{what}: {error.strerror or error}")
