"""``api/fittings`` and ``api/jobs``: fittings for the golfer of a file, or for a study, with progress."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from clubface.design.optimisation.fitting import Fitting
from clubface.design.optimisation.fitting_run import fit
from clubface.design.optimisation.landings import JUDGED
from clubface.design.optimisation.run import optimise
from clubface.design.optimisation.study import DesignStudy, from_text
from clubface.equipment.balls import ball as ball_named
from clubface.equipment.clubs import CLUB_NAMES, club as club_named
from clubface.errors import FileError, InputError, RangeWarning, RuleWarning
from clubface.results.result import Result
from clubface.shots.recorded import RecordedShots
from clubface.studio.answers import answer, document, event_stream
from clubface.studio.files import REPORT_HEADERS, Uploads, body_of, estimated, own_files_only, report_page, saved
from clubface.studio.jobs import StudioJob, StudioJobs
from clubface.support.checks import check_choice, check_count, without_warnings
from clubface.support.files import builtin_names
from clubface.units import parse

__all__ = ["BALLS", "asked_of", "fitting_routes"]

BALLS = builtin_names("balls")
FITTING_SHOTS = (256, 20_000)
"""Minimum and maximum number of shots of a golfer in a fitting."""
USUAL_SHOTS = 2000
LONGEST = 200
"""Maximum length of a name [characters]."""
MOST_TEXT = 100_000
"""Maximum size of a request for a fitting [bytes]."""


def fitting_routes(uploads: Uploads, jobs: StudioJobs) -> list[Route]:
    """Return the routes of fittings and of their jobs."""

    async def start(request: Request) -> Response:
        """Start a fitting for the golfer of a file; the body has its options as JSON."""
        upload, asked = uploads.get(request.path_params["file"]), asked_of(await body_of(request, MOST_TEXT))
        fitting = await run_in_threadpool(upload.compute, lambda shots: _fitting(shots, asked))
        job = jobs.start(lambda job: _compute_result(fitting, job))
        return document(job.describe(), 202, {"location": f"api/jobs/{job.identity}"})

    async def start_study(request: Request) -> Response:
        """Start the study in the request's body, a file of ``clubface optimise``."""
        text = (await body_of(request, MOST_TEXT)).decode("utf-8", "replace")
        study = await run_in_threadpool(_study, text)
        job = jobs.start(lambda job: _compute_result(study, job))
        return document(job.describe(), 202, {"location": f"api/jobs/{job.identity}"})

    async def state(request: Request) -> Response:
        return document(jobs.get(request.path_params["job"]).describe())

    async def result(request: Request) -> Response:
        job = jobs.get(request.path_params["job"])
        if job.result is None:
            raise InputError("job", job.state, "done before it has a result")
        return answer(job.result)

    async def job_report(request: Request) -> Response:
        job = jobs.get(request.path_params["job"])
        if job.result is None:
            raise InputError("job", job.state, "done before it has a report")
        page = await run_in_threadpool(report_page, job.result)
        return saved(page, "fitting.html", request, HTMLResponse, REPORT_HEADERS)

    async def events(request: Request) -> Response:
        job = jobs.get(request.path_params["job"])
        return event_stream(job.signal, job.news)

    async def cancel(request: Request) -> Response:
        job = jobs.get(request.path_params["job"])
        job.cancel()
        return document(job.describe())

    return [
        Route("/files/{file}/fittings", start, methods=["POST"]),
        Route("/fittings", start_study, methods=["POST"]),
        Route("/jobs/{job}", cancel, methods=["DELETE"]),
        Route("/jobs/{job}", state),
        Route("/jobs/{job}/events", events),
        Route("/jobs/{job}/result", result),
        Route("/jobs/{job}/report", job_report),
    ]


def _fitting(shots: RecordedShots, asked: Mapping[str, Any]) -> Fitting:
    """Return a fitting for the golfer of the shots, with the golfer's own club first."""
    player, own = estimated(shots, asked)
    others = [each for each in _names(asked, "clubs", CLUB_NAMES) if each != own.name]
    balls = _names(asked, "balls", BALLS)
    objective = asked.get("objective", "carry")
    check_choice("objective", objective, JUDGED)
    loft = asked.get("loft")
    bounds = {} if loft is None else {"loft": (-parse(loft, "angle", name="loft"), parse(loft, "angle", name="loft"))}
    with without_warnings(RuleWarning):
        return Fitting(
            title="A fitting", golfers=((player.golfer, 1.0),), objective=objective,
            clubs=(own, *(club_named(each).replace(hand=own.hand) for each in others)),
            balls=tuple(map(ball_named, balls)) or (None,), bounds=bounds,
            shots=check_count("shots", asked.get("shots", USUAL_SHOTS), *FITTING_SHOTS),
        )  # fmt: skip


def _study(text: str) -> Fitting | DesignStudy:
    with own_files_only(), without_warnings(RuleWarning):
        try:
            return from_text(text)
        except FileError as error:
            raise FileError("the study", error.line, error.message, error.parameter) from None


def _compute_result(study: Fitting | DesignStudy, job: StudioJob) -> Result:
    with own_files_only(), without_warnings(RuleWarning), without_warnings(RangeWarning):
        if isinstance(study, Fitting):
            return fit(study, progress=job.progress).to_result()
        return optimise(study, progress=job.progress).to_result()


def _names(asked: Mapping[str, Any], key: str, known: Any) -> list[str]:
    names = asked.get(key, [])
    if not isinstance(names, list):
        raise InputError(key, names, "a list of names")
    for each in names:
        check_choice(key, each, known)
    return list(dict.fromkeys(names))


def asked_of(body: bytes) -> dict[str, Any]:
    """Return the JSON object of a request, after checking that its texts are short."""
    try:
        result = json.loads(body)
    except (ValueError, RecursionError):
        result = None
    if not isinstance(result, dict):
        raise InputError("body", body[:40], "a JSON object")
    for key in ("club", "hand", "only", "name", "like", "loft", "objective"):
        value = result.get(key, "")
        if not isinstance(value, str) or len(value) > LONGEST:
            raise InputError(key, value, "a short text")
    return result
