"""``api/studies``: the stores of studies in the folder given at the start."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from clubface.errors import ClubfaceError, FileError, InputError
from clubface.results.result import Result
from clubface.results.table import table, text
from clubface.studies.running import status
from clubface.studies.store import open_folder
from clubface.studies.summaries import summary
from clubface.studio.answers import answer
from clubface.studio.files import REPORT_HEADERS, report_page, saved

__all__ = ["study_routes"]

MOST = 500
"""Maximum number of studies listed."""


def study_routes(folder: Path | None) -> list[Route]:
    """Return the routes of studies; ``folder`` holds their stores, or is None."""

    async def listing(request: Request) -> Response:
        return answer(await run_in_threadpool(lambda: _listing(folder)))

    def shown(compute: Callable[[Path], Result]) -> Callable[[Request], Any]:
        async def show(request: Request) -> Response:
            return answer(await run_in_threadpool(lambda: compute(_store(folder, request.path_params["study"]))))

        return show

    async def report(request: Request) -> Response:
        name = request.path_params["study"]
        page = await run_in_threadpool(lambda: report_page(_summary(_store(folder, name))))
        return saved(page, "study.html", request, HTMLResponse, REPORT_HEADERS)

    return [
        Route("/studies", listing),
        Route("/studies/{study}", shown(lambda store: status(store).to_result())),
        Route("/studies/{study}/summary", shown(_summary)),
        Route("/studies/{study}/report", report),
    ]


def _summary(store: Path) -> Result:
    return summary(store).to_result()


def _stores(folder: Path | None) -> dict[str, Path]:
    """Return the subfolders that hold a study, by name."""
    if folder is None:
        return {}
    result = {}
    for each in sorted(path for path in folder.iterdir() if path.is_dir()):
        try:
            open_folder(each)
        except ClubfaceError:
            continue
        result[each.name] = each
        if len(result) == MOST:
            break
    return result


def _store(folder: Path | None, name: str) -> Path:
    if folder is None:
        raise InputError("studies", None, "given at the start: clubface studio --studies FOLDER")
    stores = _stores(folder)
    if name not in stores:
        raise InputError("study", name, "one of the folder that was named at the start")
    return stores[name]


def _listing(folder: Path | None) -> Result:
    rows = []
    for name, path in _stores(folder).items():
        try:
            store, state = open_folder(path), status(path)
        except FileError:  # removed meanwhile
            continue
        rows.append((name, str(store.record["name"]), state.tasks, state.chunks, state.done))
    names = ("store", "name", "tasks", "chunks", "done")
    columns = [text(name, [row[place] for row in rows]) for place, name in enumerate(names)]
    return Result("studies", "Studies", (table("studies", *columns),))
