"""Server-sent events: changes made on threads reach every tab, and a tab that reconnects continues where it was."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Any

from starlette.responses import StreamingResponse

from clubface.present.files import json_text

__all__ = ["Signal", "event", "event_stream"]

ALIVE = 15.0
"""Time without an event after which a comment is sent, so that a lost connection is noticed [s]."""


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
        """Wake everyone who waits."""
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
        Set at every change.
    news
        Returns the events since it was called last, and whether they are the last ones.
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
