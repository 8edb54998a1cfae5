"""Several runs at a time, one on each core, which Ctrl-C ends."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextvars import copy_context
from typing import TypeVar

from clubface.errors import InputError
from clubface.fem.core import Progress
from clubface.support.checks import is_count
from clubface.support.processors import processors

P = TypeVar("P")
R = TypeVar("R")


def workers_of(asked: int | None) -> int:
    """Return how many runs go side by side: as many as asked for, or as there are cores."""
    if asked is None:
        return processors()
    if not is_count(asked, 1, 1024):
        raise InputError("workers", asked, "a whole number from 1 to 1024, or None for all cores")
    return int(asked)


def side_by_side(
    points: Iterable[P], run: Callable[[P, Progress, int], R], ended: Callable[[P, R], object], *, workers: int | None
) -> None:
    """Run a function at each of some points, several at a time.

    Parameters
    ----------
    points
        The points.
    run
        Called in other threads with a point, a function to call as its run proceeds, and the number of threads it may
        use. That is one, except for the last points if there are fewer of them than workers.
    ended
        Called in this thread with every point whose run has ended, and its result.
    workers
        Number of runs at a time; if left out, one for each core.
    """
    count, open_ = workers_of(workers), list(points)
    last = len(open_) % count
    # More threads than cores would wait for each other.
    cores = min(count, processors())
    running: dict[Future[R], P] = {}
    stop: list[bool] = []

    def keep_going(time: float, whole: float) -> None:
        if stop:
            raise KeyboardInterrupt

    with ThreadPoolExecutor(count) as pool:
        try:
            while open_ or running:
                while open_ and len(running) < count:
                    threads = max(cores // last, 1) if len(open_) <= last else 1
                    point = open_.pop(0)
                    running[pool.submit(copy_context().run, run, point, keep_going, threads)] = point
                finished, _ = wait(running, timeout=0.05, return_when=FIRST_COMPLETED)
                for future in finished:
                    ended(running.pop(future), future.result())
        except BaseException:
            stop.append(True)
            raise
