"""``api/live``: shots from launch monitors, sent to every open tab as they arrive."""

from __future__ import annotations

from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from clubface.errors import InputError
from clubface.present.report import csv_text
from clubface.results.result import Result
from clubface.results.table import table, text
from clubface.shots.live import LiveShots, live_result
from clubface.shots.live_links import LiveLinks
from clubface.studio.answers import Signal, answer, document, event, event_stream
from clubface.studio.files import body_of, saved
from clubface.studio.fittings import asked_of

__all__ = ["LiveSession", "live_routes"]

AT_ONCE = 200
"""Maximum number of shots in an event."""
MOST_TEXT = 1000
"""Maximum size of a request with the player's choices [bytes]."""


class LiveSession:
    """Live shots, their connections, and the signal that is set when either changes."""

    def __init__(self, shots: LiveShots, **links: Any) -> None:
        self.shots, self.signal = shots, Signal()
        shots.subscribe(self.signal.set)
        self.links = LiveLinks(shots, on_change=self.signal.set, **links)
        if shots.damaged:
            lines = ", ".join(map(str, shots.damaged[:10]))
            self.links.remark(f"damaged lines of {shots.path.name} are passed over: {lines}")

    def close(self) -> None:
        """Close all connections and the file."""
        self.links.close()
        self.shots.close()

    def state(self) -> dict[str, Any]:
        """Return the connections, their latest events, and the player's choices."""
        return {
            "count": len(self.shots.shots),
            "file": self.shots.path.name,
            **self.shots.player._asdict(),
            "links": [each._asdict() for each in self.links.states],
            "remarks": [each._asdict() for each in self.links.remarks],
        }


def live_routes(session: LiveSession | None) -> list[Route]:
    """Return the routes of live shots."""

    def opened() -> LiveSession:
        if session is None:
            raise InputError("live", None, "given at the start: clubface studio --live FILE")
        return session

    async def every(request: Request) -> Response:
        return answer(await run_in_threadpool(_result, opened()))

    async def state(request: Request) -> Response:
        return document(opened().state())

    async def choose(request: Request) -> Response:
        """Set the club and the hand for the next shots."""
        live, asked = opened(), asked_of(await body_of(request, MOST_TEXT))
        club, hand = (str(asked.get(key, getattr(live.shots.player, key))) for key in ("club", "hand"))
        await run_in_threadpool(live.shots.choose, club, hand)
        return document(live.state())

    async def csv(request: Request) -> Response:
        shown = await run_in_threadpool(_result, opened())
        return saved(csv_text(shown.table("shots")), "live-shots.csv", request, _Csv, {})

    async def events(request: Request) -> Response:
        """Return all shots after the one in ``Last-Event-ID`` or ``after``, then new ones as they arrive."""
        live = opened()
        last = request.headers.get("last-event-id") or request.query_params.get("after") or "0"
        seen = int(last) if last.isascii() and last.isdecimal() and len(last) < 10 else 0
        if seen > len(live.shots.shots):  # the identifier belongs to another file
            seen = 0
        last_state: dict[str, Any] | None = None

        def news() -> tuple[list[str], bool]:
            nonlocal seen, last_state
            events_so_far = []
            while new := live.shots.since(seen)[:AT_ONCE]:
                seen = new[-1].number
                events_so_far.append(event("shots", live_result(new).to_dict(), seen))
            if (now := live.state()) != last_state:
                last_state = now
                events_so_far.append(event("state", now))
            return events_so_far, False

        return event_stream(live.signal, news)

    return [
        Route("/live", every),
        Route("/live/state", state),
        Route("/live/player", choose, methods=["POST"]),
        Route("/live/shots.csv", csv),
        Route("/live/events", events),
    ]


class _Csv(Response):
    media_type = "text/csv"


def _result(live: LiveSession) -> Result:
    shots = live.shots.shots
    return live_result(shots) if shots else Result("shot-list", "Live shots", (table("shots", text("shot", [])),))
