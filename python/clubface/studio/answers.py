"""Answers: results as they describe themselves, and mistakes as where, what and what is allowed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from starlette.responses import JSONResponse, Response

from clubface.errors import ClubfaceError, FileError, InputError, in_a_line, missing_extra
from clubface.present.files import json_text
from clubface.results.result import Result

__all__ = ["answer", "describe_mistake", "document", "mistake", "refusal"]

OURS = "this is a bug in clubface, not your mistake; please report it with what the terminal shows"


def document(content: Any, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return JSON, NaN and infinities being null."""
    text = json_text(content, indent=None)
    return Response(text, status, dict(headers or {}), media_type="application/json")


def answer(result: Result, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return a result."""
    return document(result.to_dict(), status, headers)


def refusal(status: int, where: str, what: str, allowed: str | None = None) -> JSONResponse:
    """Return what is wrong, where, and what would have been accepted."""
    return JSONResponse({"where": where, "what": what, "allowed": allowed}, status)


def describe_mistake(error: BaseException) -> tuple[int, dict[str, str | None]]:
    """Return the status of an error and what to say of it."""
    status, where, what, allowed = 422, "", str(error), None
    if isinstance(error, InputError):
        where, allowed = error.parameter, error.allowed
    elif isinstance(error, FileError):
        where = error.path if error.line is None else f"{error.path}, line {error.line}"
        what = error.message
    elif isinstance(error, MemoryError):
        what = "there is not enough memory for this; try a smaller file"
    elif isinstance(error, ModuleNotFoundError) and (message := missing_extra(error)) is not None:
        what = message
    elif not isinstance(error, ClubfaceError):
        status, what = 500, OURS
    return status, {"where": in_a_line(where), "what": in_a_line(what), "allowed": allowed and in_a_line(allowed)}


def mistake(error: BaseException, status: int | None = None) -> Response:
    """Return the answer to a request that ended with an error."""
    usual, description = describe_mistake(error)
    return Response(json.dumps(description), status or usual, media_type="application/json")
