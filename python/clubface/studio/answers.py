"""Responses: results as JSON, mistakes with place, reason and what is allowed, and event streams.

Server-sent events report changes made by threads to every tab; a tab that reconnects continues where it was.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Callable, Mapping
from typing import Any

from starlette.responses import JSONResponse, Response, StreamingResponse

from clubface.errors import ClubfaceError, FileError, InputError, in_a_line, missing_extra
from clubface.present.report import json_text
from clubface.results.result import Result

__all__ = ["Signal", "answer", "describe_mistake", "document", "event", "event_stream", "mistake", "refusal"]

OURS = "this is a bug in clubface, not your mistake; please report it with what the terminal shows"
ALIVE = 15.0
"""Time without an event after which a comment is sent, to detect lost connections [s]."""


def document(content: Any, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return a JSON response, with null for NaN and infinities."""
    text = json_text(content, indent=None)
    return Response(text, status, dict(headers or {}), media_type="application/json")


def answer(result: Result, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return a result as a JSON response."""
    return document(result.to_dict(), status, headers)


def refusal(status: int, where: str, what: str, allowed: str | None = None) -> JSONResponse:
    """Return a response that says what is wrong, where, and what is allowed."""
    return JSONResponse({"where": where, "what": what, "allowed": allowed}, status)


def describe_mistake(error: BaseException) -> tuple[int, dict[str, str | None]]:
    """Return the HTTP status and the description of an error."""
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
    """Return the response to a request that ended with an error."""
    usual, description = describe_mistake(error)
    return Response(json.dumps(description), status or usual, media_type="application/json")


def event(name: str, data: Any, identity: int | None = None) -> str:
    """Return an event with its data as one line of JSON."""
    own = "" if identity is None else f"id: {identity}\n"
    return f"{own}event: {name}\ndata: {json_text(data, indent=None)}\n\n"


class Signal:
    """Wakes waiting coroutines on a change; may be set from any thread."""

    def __init__(self) -> None:
        self._waiting: dict[asyncio.Event, asyncio.AbstractEventLoop] = {}
        self._ended = False

    def set(self) -> None:
        """Wake all waiting coroutines."""
        for each, loop in tuple(self._waiting.items()):
            if not loop.is_closed():
                loop.call_soon_threadsafe(each.set)

    def close(self) -> None:
        """End all waiting."""
        self._ended = True
        self.set()

    async def changes(self) -> AsyncIterator[bool]:
        """Yield True at the start and after changes, and False from time to time without one, until closed."""
        changed = asyncio.Event()
        self._waiting[changed] = asyncio.get_running_loop()
        try:
            yield True
            while not self._ended:
                try:
                    await asyncio.wait_for(changed.wait(), ALIVE)
                except TimeoutError:
                    yield False
                else:
                    changed.clear()
                    yield True
        finally:
            del self._waiting[changed]


def event_stream(signal: Signal, news: Callable[[], tuple[list[str], bool]]) -> StreamingResponse:
    """Return a stream of events.

    Parameters
    ----------
    signal
        Signal set at every change.
    news
        Function that returns the events since its last call, and whether they are the last ones.
    """

    async def stream() -> AsyncIterator[str]:
        changes = signal.changes()
        try:
            async for changed in changes:
                if not changed:
                    yield ": still here\n\n"
                    continue
                events, ended = await asyncio.to_thread(news)
                for each in events:
                    yield each
                if ended:
                    return
        finally:
            await changes.aclose()  # pyright: ignore[reportAttributeAccessIssue]

    return StreamingResponse(stream(), media_type="text/event-stream")
