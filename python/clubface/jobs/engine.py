"""The engine for long computations: finished parts are kept, so that nothing is computed twice."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

from clubface.jobs.store import Finished
from clubface.jobs.workers import in_sequence

__all__ = ["Job", "interrupted", "run"]

P = TypeVar("P")
R = TypeVar("R")
Compute = Callable[..., Any]
Progress = Callable[[int, int], object]
"""Called with the parts that are done and the parts in all."""


@dataclass(frozen=True)
class Job(Generic[P, R]):
    """A long computation that consists of independent parts.

    Attributes
    ----------
    what
        What the parts are, in the plural, for people.
    parts
        The parts, each once; hashable.
    compute
        From a part to its result, of what JSON holds where it is kept. What else it takes depends on where it runs, see
        :mod:`clubface.jobs.workers`.
    name
        From a part to the name under which its result is kept.
    accepts
        Whether a kept result is that of a part, where its name does not say so.
    """

    what: str
    parts: Sequence[P]
    compute: Callable[..., R]
    name: Callable[[P], str] = str
    accepts: Callable[[P, R], bool] = lambda part, result: True


def run(
    job: Job[P, R],
    how: Callable[[Iterable[P], Callable[..., R]], Iterator[tuple[P, R]]] = in_sequence,
    *,
    store: Finished | None = None,
    finished: Mapping[P, R] | None = None,
    progress: Progress | None = None,
) -> dict[P, R]:
    """Return the results of all parts of a job, in order.

    Parameters
    ----------
    job
        The job.
    how
        Where its parts are computed: one of the functions of :mod:`clubface.jobs.workers`.
    store
        What keeps the results. Those that it has are not computed again.
    finished
        Results that are known from elsewhere.
    progress
        Called with the parts that are done and the parts in all.

    Raises
    ------
    KeyboardInterrupt
        Ctrl-C was pressed; the message says what is done and where it is kept.
    """
    store = Finished() if store is None else store
    results = dict(finished or {})
    for part in job.parts:
        if part not in results and job.name(part) in store and job.accepts(part, store[job.name(part)]):
            results[part] = store[job.name(part)]
    todo = [part for part in job.parts if part not in results]
    if progress is not None and results:
        progress(len(results), len(job.parts))
    try:
        for part, result in how(todo, job.compute):
            results[part] = result
            store.keep(job.name(part), result)
            if progress is not None:
                progress(len(results), len(job.parts))
    except KeyboardInterrupt:
        raise interrupted(len(results), len(job.parts), job.what, store.folder) from None
    return {part: results[part] for part in job.parts}


def interrupted(done: int, whole: int, what: str, folder: Path | None) -> KeyboardInterrupt:
    """Return the error that says how much of the interrupted work is done, and where it is kept."""
    kept = "" if folder is None or not done else f"; they are in {folder}, and the same command goes on after them"
    return KeyboardInterrupt(f"{done} of {whole} {what} are done{kept}")
