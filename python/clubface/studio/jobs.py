"""Long computations for the browser: one thread each, with progress, and cancellable."""

from __future__ import annotations

import secrets
import threading
import traceback
from collections import OrderedDict
from collections.abc import Callable
from contextvars import copy_context
from typing import Any

from clubface.errors import ClubfaceError, InputError, Wording
from clubface.results.result import Result
from clubface.studio.answers import Signal, describe_mistake, event

__all__ = ["Cancelled", "StudioJob", "StudioJobs"]

MOST_KEPT = 8
"""Maximum number of finished jobs kept."""


class Cancelled(BaseException):
    """The computation was cancelled."""


class StudioJob:
    """One computation.

    Attributes
    ----------
    identity
        Generated name.
    state
        "running", "done", "failed" or "cancelled".
    result
        Result, once it is done.
    signal
        Signal set at every step of its progress and at its end.
    """

    def __init__(self, compute: Callable[[StudioJob], Result]) -> None:
        self.identity = secrets.token_urlsafe(9)
        self.state = "running"
        self.result: Result | None = None
        self.signal = Signal()
        self._mistake: dict[str, Any] | None = None
        self._done = (0, 0)
        self._step = ""
        self._asked_to_stop = threading.Event()
        context = copy_context()
        threading.Thread(target=context.run, args=(self._run, compute), name="studio-job", daemon=True).start()

    def progress(self, done: int, whole: int, step: str = "") -> None:
        """Record the progress; raise :class:`Cancelled` if the job was cancelled."""
        if self._asked_to_stop.is_set():
            raise Cancelled
        self._done, self._step = (done, whole), step
        self.signal.set()

    def cancel(self) -> None:
        """Cancel the job before its next part."""
        self._asked_to_stop.set()
        if self.state == "running":
            self.state = "cancelled"
        self.signal.set()

    def describe(self) -> dict[str, Any]:
        """Return the progress and any error."""
        done, whole = self._done
        return {"job": self.identity, "state": self.state, "done": done, "whole": whole, "step": self._step,
                "mistake": self._mistake}  # fmt: skip

    def news(self) -> tuple[list[str], bool]:
        """Return the state as an event, with the result if there is one, and whether the job has ended."""
        state, ended = self.describe(), self.state != "running"
        events = [event("progress", state)]
        if ended:
            result = None if self.result is None else self.result.to_dict()
            events.append(event("end", {**state, "result": result}))
        return events, ended

    def _run(self, compute: Callable[[StudioJob], Result]) -> None:
        try:
            result = compute(self)
            self.progress(*self._done)
            self.result, self.state = result, "done"
        except Cancelled:
            self.state = "cancelled"
        except BaseException as error:
            if not isinstance(error, ClubfaceError):
                traceback.print_exception(error)
            self._mistake, self.state = describe_mistake(error)[1], "failed"
        self.signal.set()


class StudioJobs:
    """The computations of this run; one at a time, since each uses the whole machine."""

    def __init__(self) -> None:
        self._jobs: OrderedDict[str, StudioJob] = OrderedDict()
        self._lock = threading.RLock()

    def start(self, compute: Callable[[StudioJob], Result]) -> StudioJob:
        """Start a computation."""
        with self._lock:
            if any(each.state == "running" for each in self._jobs.values()):
                raise InputError("fitting", Wording("running"), "leave it to finish, or cancel it")
            job = StudioJob(compute)
            self._jobs[job.identity] = job
            while len(self._jobs) > MOST_KEPT:
                self._jobs.popitem(last=False)
        return job

    def get(self, identity: str) -> StudioJob:
        """Return a computation."""
        if identity not in self._jobs:
            raise InputError("job", identity, "one of this run of the studio")
        return self._jobs[identity]

    def close(self) -> None:
        """Cancel all computations."""
        for each in tuple(self._jobs.values()):
            each.cancel()
            each.signal.close()
