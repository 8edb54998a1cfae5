"""The server on 127.0.0.1: access control, the built site, and the computations under ``api/``."""

from __future__ import annotations

import os
import secrets
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any

import uvicorn
from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, JSONResponse, Response
from starlette.routing import Mount, Route, Router
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from clubface.design.golfer import golfers
from clubface.design.optimisation.landings import JUDGED
from clubface.equipment.clubs import CLUB_NAMES
from clubface.errors import ClubfaceError, FileError
from clubface.quantities import read_in
from clubface.shots.live import LiveShots
from clubface.shots.monitors import FORMATS
from clubface.studio.answers import document, mistake, refusal
from clubface.studio.files import LARGEST, TooLargeError, Uploads, file_routes
from clubface.studio.fittings import BALLS, fitting_routes
from clubface.studio.jobs import StudioJobs
from clubface.studio.live import LiveSession, live_routes
from clubface.studio.studies import study_routes
from clubface.support.files import DATA
from clubface.support.sockets import LOOPBACK, listen_on
from clubface.support.version import __version__

__all__ = ["PORT", "SITE_VARIABLE", "Guard", "make_application", "new_token", "serve", "site_folder", "site_routes"]

HOSTS = ("127.0.0.1", "localhost")
"""Host names under which a browser reaches this machine; others are refused."""
HEADERS = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
}
"""Headers of every response; the address, which contains the token, is not sent to other sites."""
CONTENT = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; media-src 'self' blob:; worker-src 'self' blob:; connect-src 'self' blob:; "
    "frame-src 'self'; object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'self'"
)
"""Content security policy of the studio's pages."""
SITE_VARIABLE = "CLUBFACE_STUDIO_SITE"
"""Environment variable for another folder with a built site."""
INDEX = "index.html"
KINDS = {".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml"}
"""Media types by file extension, since some systems register others."""
MARK = '<meta name="clubface-api" content="api/">'
"""Line that tells a page that this server offers an API, unlike the static site."""
NOT_SERVED = ("sw.js",)
"""Files for offline use of the static site; here they would keep pages open without a server after it stops."""
PORT = 8642
WAITING = 64
"""Maximum number of connections waiting to be accepted; a browser opens several at once."""
SHUTDOWN_TIMEOUT = 2
"""Time allowed for open connections, such as live shots, to finish at shutdown [s]."""
EXPECTED = (ClubfaceError, ModuleNotFoundError, MemoryError)
"""Errors that tell the user what to do; all others are also printed."""


def new_token() -> str:
    """Return an unguessable token."""
    return secrets.token_urlsafe(24)


class Guard:
    """Passes permitted requests on to an application under ``/TOKEN/``.

    Parameters
    ----------
    application
        Application called with the token as the root of its paths.
    token
        The token.
    close
        Function that ends running work, such as event streams, at shutdown.
    """

    def __init__(self, application: ASGIApp, token: str, close: Callable[[], object] = lambda: None) -> None:
        self._application, self._token, self.close = application, token, close

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on or refuse a request."""
        if scope["type"] != "http":
            return
        headers = Headers(scope=scope)
        root, _, rest = scope["path"].removeprefix("/").partition("/")

        async def send_guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                own = {name for name, _ in message["headers"]}
                every = HEADERS | {"content-security-policy": CONTENT, "cache-control": "no-store"}
                message["headers"] = [
                    *message["headers"],
                    *((name.encode(), value.encode()) for name, value in every.items() if name.encode() not in own),
                ]
            await send(message)

        response = self._refusal(headers, root)
        if response is None and not scope["path"].startswith(f"/{root}/"):
            response = Response(status_code=307, headers={"location": f"/{root}/"})
        if response is not None:
            await response(scope, receive, send_guarded)
            return
        inner = {**scope, "path": f"/{rest}", "root_path": "", "raw_path": b""}
        await self._application(inner, receive, send_guarded)

    def _refusal(self, headers: Headers, root: str) -> JSONResponse | None:
        host = headers.get("host", "")
        name, _, port = host.partition(":")
        if name not in HOSTS or (port and not port.isdecimal()) or len(headers.getlist("host")) != 1:
            return refusal(421, "Host", "this studio answers only to 127.0.0.1 and localhost")
        origin = headers.get("origin")
        if origin is not None and origin != f"http://{host}":
            return refusal(403, "Origin", "this studio answers only its own pages")
        if headers.get("sec-fetch-site", "none") not in ("same-origin", "none"):
            return refusal(403, "Sec-Fetch-Site", "this studio answers only its own pages")
        if not secrets.compare_digest(root.encode("utf-8", "replace"), self._token.encode()):
            return refusal(403, "address", "open the whole address that clubface studio printed")
        return None


def site_folder(given: str | os.PathLike[str] | None = None) -> Path:
    """Return the folder of the built site: the given one, or the one in the package or in the checkout.

    Raises
    ------
    FileError
        There is no built site; the message says how to build one.
    """
    named = given if given is not None else os.environ.get(SITE_VARIABLE) or None
    if named is not None:
        if not (Path(named) / INDEX).is_file():
            raise FileError(str(named), None, f"this folder holds no built studio: there is no {INDEX} in it")
        return Path(named)
    package = DATA.parent
    checkout = package.parent.parent / "studio"
    for each in (package / "studio_site", checkout / "dist"):
        if (each / INDEX).is_file():
            return each
    if (checkout / "package.json").is_file():
        raise FileError(str(checkout / "dist"), None, "the studio is not built yet: make studio-build builds it")
    message = (
        "this installation has no built studio: build it in a checkout by make studio-build, and name its folder "
        f"studio/dist with --site or {SITE_VARIABLE}"
    )
    raise FileError(str(package / "studio_site"), None, message)


def site_routes(folder: Path) -> list[Route]:
    """Return the route of every file of the site."""
    root = folder.resolve()

    async def show(request: Request) -> Response:
        path = request.path_params["path"] or INDEX
        if path == INDEX:
            page = (root / INDEX).read_text(encoding="utf-8")
            return HTMLResponse(page.replace("<head>", f"<head>{MARK}", 1))
        file = (root / path).resolve()
        if path in NOT_SERVED or not file.is_relative_to(root) or not file.is_file():
            return Response("there is no such file", 404, media_type="text/plain")
        return FileResponse(file, media_type=KINDS.get(file.suffix))

    return [Route("/{path:path}", show)]


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
        The port; 0 chooses a free one.
    site, studies
        Folders of the built site and of studies.
    live
        File of live shots.
    on_start
        Function called at the start with the address to open and the live shots, if any.
    links
        Connections of live shots, as for :class:`clubface.shots.live_links.LiveLinks`.

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
    """A server that ends event streams before it waits for open responses."""

    def __init__(self, config: uvicorn.Config, application: Guard) -> None:
        super().__init__(config)
        self._application = application

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        self._application.close()
        await super().shutdown(sockets)


def make_application(site: Path, token: str, *, studies: Path | None = None, live: LiveSession | None = None) -> Guard:
    """Return the web application.

    Parameters
    ----------
    site
        Folder of the built site.
    token
        Token required in the address.
    studies
        Folder of the study stores, or None.
    live
        Live shots, or None.
    """
    uploads, jobs = Uploads(), StudioJobs()

    async def offers(request: Request) -> Response:
        """Return the services that the API offers."""
        return document({
            "clubface": __version__, "studies": studies is not None, "live": live is not None,
            "largest_file": LARGEST, "formats": [*FORMATS], "clubs": [*CLUB_NAMES], "balls": [*BALLS],
            "golfers": [*golfers()], "objectives": [*JUDGED],
        })  # fmt: skip

    async def unknown_address(request: Request) -> Response:
        return refusal(404, request.url.path, "there is nothing under this address")

    async def failed(request: Request, error: Exception) -> Response:
        return mistake(error)

    async def too_large(request: Request, error: Exception) -> Response:
        return mistake(error, 413)

    async def http_error(request: Request, error: Exception) -> Response:
        status = error.status_code if isinstance(error, HTTPException) else 404
        return refusal(status, request.url.path, "this address does not support the request")

    api = [
        Route("/", offers), *file_routes(uploads), *fitting_routes(uploads, jobs), *study_routes(studies),
        *live_routes(live), Route("/{path:path}", unknown_address),
    ]  # fmt: skip
    handlers = {
        HTTPException: http_error,
        TooLargeError: too_large,
        **dict.fromkeys(EXPECTED, failed),
        Exception: failed,
    }
    routes = [Mount("/api", app=_answer_in_units(Router(routes=api))), *site_routes(site)]

    def close() -> None:
        jobs.close()
        if live is not None:
            live.signal.close()

    return Guard(Starlette(routes=routes, exception_handlers=handlers), token, close)


def _answer_in_units(application: ASGIApp) -> ASGIApp:
    """Wrap an application so that it answers in the units given by ``units`` of a request, by default "golf"."""

    async def answer_in_units(scope: Scope, receive: Receive, send: Send) -> None:
        with read_in(Request(scope).query_params.get("units", "golf")):
            await application(scope, receive, send)

    return answer_in_units
