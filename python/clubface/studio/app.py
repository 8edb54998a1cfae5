"""The web application: the site, and the API under ``api/``."""

from __future__ import annotations

from pathlib import Path

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Mount, Route, Router
from starlette.types import ASGIApp, Receive, Scope, Send

from clubface.design.golfer import golfers
from clubface.design.optimisation.landings import JUDGED
from clubface.equipment.clubs import CLUB_NAMES
from clubface.errors import ClubfaceError
from clubface.quantities import read_in
from clubface.shots.monitors import FORMATS
from clubface.studio.answers import document, mistake, refusal
from clubface.studio.files import file_routes
from clubface.studio.fittings import BALLS, fitting_routes
from clubface.studio.guard import Guard
from clubface.studio.jobs import StudioJobs
from clubface.studio.live import LiveSession, live_routes
from clubface.studio.site import site_routes
from clubface.studio.studies import study_routes
from clubface.studio.uploads import LARGEST, TooLargeError, Uploads
from clubface.support.version import __version__

__all__ = ["make_application"]

EXPECTED = (ClubfaceError, ModuleNotFoundError, MemoryError)
"""Errors that tell the user what to do; all others are printed as well."""


def make_application(site: Path, token: str, *, studies: Path | None = None, live: LiveSession | None = None) -> Guard:
    """Return the web application.

    Parameters
    ----------
    site
        The folder of the built site.
    token
        What the address must hold.
    studies
        The folder of the stores of studies, None for no studies.
    live
        Live shots, None for none.
    """
    uploads, jobs = Uploads(), StudioJobs()

    async def offers(request: Request) -> Response:
        """Return the requests that the API offers."""
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
        return refusal(status, request.url.path, "nothing is answered under this address in this way")

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
    routes = [Mount("/api", app=_in_units(Router(routes=api))), *site_routes(site)]

    def close() -> None:
        jobs.close()
        if live is not None:
            live.signal.close()

    return Guard(Starlette(routes=routes, exception_handlers=handlers), token, close)


def _in_units(application: ASGIApp) -> ASGIApp:
    """Return an application that answers in the units given by ``units`` of a request, by default "golf"."""

    async def answer_in_units(scope: Scope, receive: Receive, send: Send) -> None:
        with read_in(Request(scope).query_params.get("units", "golf")):
            await application(scope, receive, send)

    return answer_in_units
