"""``api/files``: a launch monitor's file, kept in memory, becomes shots, a report and a golfer.

The file is read as by the command line. Computations see its content under a bare file name, and no other files except
those of the package.
"""

from __future__ import annotations

import hashlib
import os
import secrets
from collections import OrderedDict
from collections.abc import Callable, Mapping
from contextlib import contextmanager
from threading import RLock
from typing import Any, NamedTuple, TypeVar

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import Route

from clubface.design.golfer import golfers, to_toml
from clubface.design.golfer_estimate import Estimate, estimate_golfer
from clubface.design.golfer_result import golfer_result
from clubface.design.loft_fit import player_loft_notes
from clubface.equipment.clubs import CLUB_NAMES, Club, club as club_named
from clubface.errors import InputError, Wording
from clubface.inference.player_report import player_result
from clubface.present.document import as_html, file_name
from clubface.present.report import report_blocks
from clubface.results.result import Result
from clubface.shots.measured import ready_shots
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots
from clubface.shots.recorded_result import shots_result
from clubface.shots.session_summary import session_result
from clubface.shots.shot_list import shot_list_result
from clubface.studio.answers import answer
from clubface.support.checks import check_choice
from clubface.support.files import InputFile, InputRecord, absolute

__all__ = [
    "LARGEST", "MOST_FILES", "TooLargeError", "Upload", "Uploads", "bare_name", "body_of", "estimated",
    "file_routes", "own_files_only", "report_page", "saved",
]  # fmt: skip

LARGEST = 20_000_000
"""Maximum size of a file [bytes]: a hundred thousand shots."""
MOST_FILES = 8
"""Maximum number of files kept; the least recently used one is dropped."""
LONGEST_NAME = 100
R = TypeVar("R")
REPORT_HEADERS = {
    "content-security-policy": "sandbox allow-downloads; default-src 'none'; style-src 'unsafe-inline'; img-src data:"
}
"""Headers of a report, which has no scripts and loads nothing from elsewhere."""


class TooLargeError(InputError):
    """A request that is too large."""


class Upload(NamedTuple):
    """A file and its shots.

    Attributes
    ----------
    name
        Name without folders.
    content
        Content [bytes].
    shots
        Shots read from it.
    """

    name: str
    content: bytes
    shots: RecordedShots

    def compute(self, function: Callable[[RecordedShots], R]) -> R:
        """Call a function with the shots, without access to other files."""
        with own_files_only(self.name, self.content):
            return function(self.shots)


class Uploads:
    """The files of this run, under generated names."""

    def __init__(self) -> None:
        self._files: OrderedDict[str, Upload] = OrderedDict()
        self._lock = RLock()

    def add(self, name: str, content: bytes, options: Mapping[str, Any]) -> tuple[str, Upload]:
        """Read a file; ``options`` are those of :func:`clubface.shots.read`."""
        if not content:
            raise InputError("file", Wording("empty"), "one with the shots of a launch monitor")
        with own_files_only(name, content):
            upload = Upload(name, content, read(name, **options))
        identity = secrets.token_urlsafe(9)
        with self._lock:
            self._files[identity] = upload
            while len(self._files) > MOST_FILES:
                self._files.popitem(last=False)
        return identity, upload

    def get(self, identity: str) -> Upload:
        """Return a file."""
        with self._lock:
            if identity not in self._files:
                raise InputError("file", identity, "a file that is still open here; choose it again")
            self._files.move_to_end(identity)
            return self._files[identity]


@contextmanager
def own_files_only(name: str = "", content: bytes | None = None) -> Any:
    """Restrict a computation to reading this file, if given, and the files of the package."""
    given = {}
    if content is not None:
        path, sum_ = absolute(name), hashlib.sha256(content).hexdigest()
        given[path] = InputFile(name, path, len(content), sum_, False, content)
    with InputRecord(given).active() as record:
        yield record


def bare_name(name: str) -> str:
    """Return the name of a file without folders, for messages and reports."""
    plain = "".join(each for each in name.replace("\\", "/").rpartition("/")[2] if each.isprintable())
    stem, ending = os.path.splitext(plain.strip(". "))
    return f"{stem[: LONGEST_NAME - len(ending[:10])]}{ending[:10]}" or "session.csv"


async def body_of(request: Request, most: int = LARGEST) -> bytes:
    """Return the body of a request; raise TooLargeError while reading one that is too long."""
    result = bytearray()
    async for piece in request.stream():
        result += piece
        if len(result) > most:
            size = f"{most // 1_000_000} MB" if most >= 1_000_000 else f"{most // 1000} kB"
            raise TooLargeError("file", Wording(f"larger than {size}"), "a smaller one, such as that of one session")
    return bytes(result)


def file_routes(uploads: Uploads) -> list[Route]:
    """Return the routes of files."""

    async def add(request: Request) -> Response:
        """Read the file in the request's body; answer like ``clubface monitor read --json``."""
        content = await body_of(request)
        name = bare_name(request.query_params.get("name", ""))
        options = {key: request.query_params.get(key) or None for key in ("format", "hand")}
        units = _pairs(request.query_params.getlist("unit"))
        identity, upload = await run_in_threadpool(uploads.add, name, content, {**options, "units": units})
        result = await run_in_threadpool(upload.compute, shots_result)
        return answer(result, 201, {"location": f"api/files/{identity}"})

    def shown(compute: Callable[[RecordedShots], Result]) -> Callable[[Request], Any]:
        async def show(request: Request) -> Response:
            upload = uploads.get(request.path_params["file"])
            return answer(await run_in_threadpool(upload.compute, compute))

        return show

    async def report(request: Request) -> Response:
        """Return the report of ``clubface monitor report``."""
        upload = uploads.get(request.path_params["file"])
        page = await run_in_threadpool(upload.compute, lambda shots: report_page(_player(shots)))
        return saved(page, f"{file_name(upload.name)}.html", request, HTMLResponse, REPORT_HEADERS)

    async def golfer(request: Request) -> Response:
        """Return the golfer of ``clubface golfer estimate``."""
        upload, asked = uploads.get(request.path_params["file"]), request.query_params
        return answer(await run_in_threadpool(upload.compute, lambda shots: _golfer(shots, asked)))

    async def golfer_file(request: Request) -> Response:
        """Return the TOML file of the golfer."""
        upload, asked = uploads.get(request.path_params["file"]), request.query_params
        player, _ = await run_in_threadpool(upload.compute, lambda shots: estimated(shots, asked))
        return saved(to_toml(player.golfer), "golfer.toml", request, PlainTextResponse, {})

    return [
        Route("/files", add, methods=["POST"]),
        Route("/files/{file}", shown(shots_result)),
        Route("/files/{file}/shots", shown(shot_list_result)),
        Route("/files/{file}/summary", shown(session_result)),
        Route("/files/{file}/report", report),
        Route("/files/{file}/golfer", golfer),
        Route("/files/{file}/golfer.toml", golfer_file),
    ]


def report_page(result: Result) -> str:
    """Return the report on a result as a page."""
    return as_html(list(report_blocks(result)))


def saved(text: str, name: str, request: Request, kind: Any, headers: Mapping[str, str]) -> Response:
    """Return a text for display, or for download under a name if the request has ``save``."""
    saved = {"content-disposition": f'attachment; filename="{name}"'} if "save" in request.query_params else {}
    return kind(text, headers={**headers, **saved})


def _player(shots: RecordedShots) -> Result:
    result = player_result(shots, loft_notes=player_loft_notes)
    return result.replace(provenance=result.provenance.with_files())


def _own_club(name: str | None) -> Club | None:
    """Return a built-in club; the browser cannot name files."""
    if not name:
        return None
    check_choice("club", name, CLUB_NAMES)
    return club_named(name)


def estimated(shots: RecordedShots, asked: Mapping[str, Any]) -> tuple[Estimate, Club]:
    """Return the golfer of the shots of one club, and the club; ``asked`` may have ``club``, ``only``, ``like``."""
    ready = ready_shots(shots, club=_own_club(asked.get("club")), only=asked.get("only") or None)
    like = asked.get("like") or None
    if like is not None:
        check_choice("like", like, golfers())
    return estimate_golfer(ready, name=asked.get("name") or "my golfer", like=like), ready.club


def _golfer(shots: RecordedShots, asked: Mapping[str, Any]) -> Result:
    player, club = estimated(shots, asked)
    return golfer_result(player.golfer, club, player)


def _pairs(texts: list[str]) -> dict[str, str]:
    result = {}
    for each in texts:
        name, sign, unit = each.partition("=")
        if not sign:
            raise InputError("unit", each, "a name and a unit, as in speed=mph")
        result[name.strip()] = unit.strip()
    return result
