"""The built site: its folder, and its pages, which know from a line in their head that this package serves them."""

from __future__ import annotations

import os
from pathlib import Path

from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, Response
from starlette.routing import Route

from clubface.errors import FileError
from clubface.support.files import DATA

__all__ = ["SITE_VARIABLE", "site_folder", "site_routes"]

SITE_VARIABLE = "CLUBFACE_STUDIO_SITE"
"""Environment variable for another folder with a built site."""
INDEX = "index.html"
KINDS = {".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml"}
"""Media types by file extension; some systems have others for these."""
MARK = '<meta name="clubface-api" content="api/">'
"""The line by which a page knows that this server offers more than the static site."""
NOT_SERVED = ("sw.js",)
"""Files for offline use of the static site; from this server, they would leave pages without answers once it stops."""


def site_folder(given: str | os.PathLike[str] | None = None) -> Path:
    """Return the folder of the built site: the given one, or the one in the package or in the checkout.

    Raises
    ------
    FileError
        There is none; the message says what makes one.
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
