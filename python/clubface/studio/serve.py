"""The server: on 127.0.0.1 only, until Ctrl-C."""

from __future__ import annotations

import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any

import uvicorn

from clubface.shots.live import LiveShots
from clubface.studio.app import make_application
from clubface.studio.guard import Guard, new_token
from clubface.studio.live import LiveSession
from clubface.studio.site import site_folder
from clubface.support.sockets import LOOPBACK, listen_on

__all__ = ["PORT", "serve"]

PORT = 8642
WAITING = 64
"""Number of connections waiting to be accepted; a browser opens several at once."""
SHUTDOWN_TIMEOUT = 2
"""Time that open connections, such as live shots, have to finish at the end [s]."""


def serve(
    *,
    port: int = PORT,
    site: str | None = None,
    studies: str | None = None,
    live: str | None = None,
    on_start: Callable[[str, LiveSession | None], object],
    **links: Any,
) -> None:
    """Serve the studio until Ctrl-C, or another signal, ends the process.

    Parameters
    ----------
    port
        The port. 0 takes a free one.
    site, studies
        The folder of the built site, and that of studies.
    live
        The file of live shots.
    on_start
        Called with the address to open, and the live shots where there are any, once both are there.
    links
        The connections of live shots, as :class:`clubface.shots.live_links.LiveLinks` takes them.

    Raises
    ------
    LinkError
        The port is taken.
    FileError
        There is no built site, or a folder or file cannot be used.
    """
    folder = site_folder(site)
    listening = listen_on(port, waiting=WAITING)
    session = None
    try:
        session = None if live is None else LiveSession(LiveShots(live), **links)
        token = new_token()
        stores = None if studies is None else Path(studies)
        application = make_application(folder, token, studies=stores, live=session)
        config = uvicorn.Config(
            application, log_level="warning", access_log=False, lifespan="off", ws="none", server_header=False,
            timeout_graceful_shutdown=SHUTDOWN_TIMEOUT, http="h11",
        )  # fmt: skip
        on_start(f"http://{LOOPBACK}:{listening.getsockname()[1]}/{token}/", session)
        _Server(config, application).run([listening])
    finally:
        listening.close()
        if session is not None:
            session.close()


class _Server(uvicorn.Server):
    """A server that ends event streams before it waits for open answers."""

    def __init__(self, config: uvicorn.Config, application: Guard) -> None:
        super().__init__(config)
        self._application = application

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        self._application.close()
        await super().shutdown(sockets)
