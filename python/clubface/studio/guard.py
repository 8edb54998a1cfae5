"""Access control: only requests from this machine, under its own name, with the token, and from a page served here."""

from __future__ import annotations

import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any

from starlette.datastructures import Headers
from starlette.responses import JSONResponse, Response

from clubface.studio.answers import refusal

__all__ = ["Guard", "new_token"]

HOSTS = ("127.0.0.1", "localhost")
"""Names under which a browser reaches this machine; requests under other names are refused."""
HEADERS = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
}
"""Headers of every answer; the address, which contains the token, is sent to no other site."""
CONTENT = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; media-src 'self' blob:; worker-src 'self' blob:; connect-src 'self' blob:; "
    "frame-src 'self'; object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'self'"
)
"""Content security policy of the studio's pages."""

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
Application = Callable[[Scope, Receive, Send], Awaitable[None]]


def new_token() -> str:
    """Return an unguessable token."""
    return secrets.token_urlsafe(24)


class Guard:
    """Passes permitted requests on to an application under ``/TOKEN/``.

    Parameters
    ----------
    application
        Is asked with the token as the root of its paths.
    token
        The token.
    close
        Ends what goes on, such as streams of events, when the server ends.
    """

    def __init__(self, application: Application, token: str, close: Callable[[], object] = lambda: None) -> None:
        self._application, self._token, self.close = application, token, close

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer or refuse a request."""
        if scope["type"] != "http":
            return
        headers = Headers(scope=scope)
        root, _, rest = scope["path"].removeprefix("/").partition("/")

        async def send_guarded(message: MutableMapping[str, Any]) -> None:
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
            return refusal(421, "Host", "this studio answers to 127.0.0.1 and localhost alone")
        origin = headers.get("origin")
        if origin is not None and origin != f"http://{host}":
            return refusal(403, "Origin", "this studio answers its own pages alone")
        if headers.get("sec-fetch-site", "none") not in ("same-origin", "none"):
            return refusal(403, "Sec-Fetch-Site", "this studio answers its own pages alone")
        if not secrets.compare_digest(root.encode("utf-8", "replace"), self._token.encode()):
            return refusal(403, "address", "open the whole address that clubface studio printed")
        return None
