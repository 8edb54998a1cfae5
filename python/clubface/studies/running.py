"""Running a study on processes of this machine, in shares, or on a cluster; and how far it is."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError, FileError, InputError
from clubface.jobs.workers import Shard, in_processes, on_cluster, shard_of, worker_count
from clubface.results.result import Described, Result
from clubface.shots.tables.parquet import check_pyarrow
from clubface.simulation.impact import Tally
from clubface.studies.chunks import COMPUTED, KEPT, REPAIRED, chunk_size, first_tried, shared
from clubface.studies.kinds.kind import Task
from clubface.studies.store import StudyStore, begin, open_store, store_folder
from clubface.studies.study import StudyFile, read_study
from clubface.support.fingerprint import fingerprint
from clubface.support.version import __version__

__all__ = ["ChunkTally", "Outcome", "Status", "run", "status"]

LONGEST = 10_000
"""Characters of a table that every part repeats."""
SHOWN_REPAIRED, SHOWN_MISSING = 5, 20
"""Chunks that are named by their number."""
Progress = Callable[[int, int], object]


@dataclass(frozen=True, kw_only=True)
class Outcome(Described):
    """What a run has done.

    Attributes
    ----------
    store
        The folder of the store.
    chunks, tasks
        Of this run: all of the study, or those of a shard.
    computed
        The chunks that were computed now; the others were there.
    mended
        How many of them replaced damaged parts, and the first of those.
    failed
        Tasks without a result, and the first reason.
    remark
        The note on shots outside the range of their model, or "".
    missing
        The chunks of the whole study that no run has finished yet.
    """

    store: str
    chunks: int
    tasks: int
    computed: int
    mended: tuple[int, tuple[int, ...]]
    failed: tuple[int, str]
    remark: str
    missing: int

    def to_result(self) -> Result:
        """Return what was computed, and what is left to other runs."""
        from clubface.studies.study_result import run_result

        return run_result(self)


class ChunkTally:
    """Counts what is noted of chunks, in a space that does not grow with their number."""

    def __init__(self) -> None:
        self.computed = self.repaired = self._failed = 0
        self.shown: list[int] = []
        self._first: tuple[int, str] | None = None
        self._outside = Tally()

    def add(self, chunk: int, notes: Mapping[str, Any]) -> None:
        """Count a chunk that a worker has made sure of."""
        self.computed += notes["done"] != KEPT
        if notes["done"] == REPAIRED:
            self.repaired += 1
            if len(self.shown) < SHOWN_REPAIRED:
                self.shown.append(chunk)
        self.add_notes(notes)

    def add_notes(self, notes: Mapping[str, Any]) -> None:
        """Count the tasks of a chunk without a result, and outside of a range."""
        count, *first = notes["failed"]
        self._failed += count
        for index, reason in first:
            if self._first is None or index < self._first[0]:
                self._first = (index, reason)
        self._outside.add_counts(notes["outside"])

    @property
    def failed(self) -> tuple[int, str]:
        """The tasks without a result, and why the first one has none."""
        return self._failed, f"task {self._first[0]}: {self._first[1]}" if self._first else ""

    @property
    def remark(self) -> str:
        """The note on shots outside the range of their model, or ""."""
        return self._outside.remark()


def run(
    study: str | os.PathLike[str] | StudyFile,
    *,
    store: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    shard: str | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Outcome:
    """Compute what is missing of a study; what is there is checked and stays.

    Parameters
    ----------
    study
        The file of the study, or a :class:`StudyFile`.
    store
        The folder of what is finished; next to the file, with the ending ".store", unless given. All who share a study
        name the same folder.
    workers
        Processes at a time on this machine; left out, one for each processor that this process may use.
    shard
        Compute one share alone, see :func:`clubface.jobs.workers.shard_of`.
    scheduler
        Address of the scheduler of a Dask cluster, whose workers compute instead of this machine. They need this
        version of clubface, and the store under the same name as here.
    progress
        Called with the chunks done and the chunks of this run.

    Raises
    ------
    FileError
        The study is mistaken, or the store belongs to another.
    ClubfaceError
        A chunk cannot be computed; what is finished is kept.
    KeyboardInterrupt
        Ctrl-C was pressed; the message says where the finished chunks are.
    """
    if scheduler is not None and workers is not None:
        raise InputError("workers", workers, "leave it out with a scheduler, whose cluster has its own workers")
    count = worker_count(workers)
    share = Shard(1, 1) if shard is None else shard_of(shard)
    described = study if isinstance(study, StudyFile) else read_study(study)
    folder = Path(store) if store is not None else store_folder(described.path)
    check_pyarrow(folder)
    task, fresh = described.task, not folder.exists()
    opened = begin(folder, described, lambda: _description(described, task))
    mine = share.of_all(opened.chunks)
    if scheduler is None:
        how = partial(in_processes, workers=min(count, max(len(mine), 1)))
    else:
        how = partial(on_cluster, address=scheduler)
    tally, done, results = ChunkTally(), 0, 0
    without_result = set(first_tried(mine))
    try:
        for chunk, notes in how(order(opened, share), shared(opened, described)):
            done += 1
            tally.add(chunk, notes)
            failed, *first = notes["failed"]
            tasks = len(opened.tasks(chunk))
            results += tasks - failed
            if notes["done"] == COMPUTED and failed == tasks and chunk in without_result:
                without_result.discard(chunk)
                if not without_result and not results:
                    raise ClubfaceError(f"no task that was tried has a result: {first[0][1]}")
            if progress is not None:
                progress(done, len(mine))
    except (KeyboardInterrupt, ClubfaceError) as stop:
        present = opened.present()
        finished = sum(present[chunk] for chunk in mine)
        kept = f"{finished} of {len(mine)} chunks are done and kept in {folder}"
        if isinstance(stop, KeyboardInterrupt):
            raise KeyboardInterrupt(f"{kept}; the same command goes on after them") from None
        # Other parts are those of other runs, such as other shards, and may have results.
        if fresh and not results and sum(present) == done:
            opened.remove()
            raise
        if not finished:
            raise
        raise ClubfaceError(f"{stop}; {kept}") from None
    missing = opened.present().count(0)
    if not missing:
        opened.tidy()
    return Outcome(
        store=str(folder), chunks=len(mine), tasks=sum(len(opened.tasks(chunk)) for chunk in mine),
        computed=tally.computed, mended=(tally.repaired, tuple(tally.shown)), failed=tally.failed,
        remark=tally.remark, missing=missing,
    )  # fmt: skip


def order(store: StudyStore, share: Shard) -> Iterator[int]:
    """Yield the chunks of a share: first those that are missing, then those that are there, to be checked.

    Of each those by which a study is judged come first.
    """
    present, mine = store.present(), share.of_all(store.chunks)
    first = first_tried(mine)
    for wanted in (0, 1):
        numbers = chain(first, (each for each in mine if each not in first))
        yield from (chunk for chunk in numbers if present[chunk] == wanted)


def _description(study: StudyFile, task: Task) -> dict[str, Any]:
    """Return the rest of the record of a study that begins."""
    axes = [
        {"name": each.name, "unit": each.unit, "choices": each.choices, "count": each.count}
        for each in study.design.axes
    ]
    return {
        "chunk": chunk_size(study, task),
        "axes": axes,
        "columns": {name: list(each) for name, each in task.columns.items()},
        **({"histories": _histories(task)} if task.histories else {}),
        "provenance": {
            "name": study.name,
            "clubface_version": __version__,
            "kind": study.kind.name,
            "design": study.method,
            "seed": study.seed,
            "inputs": _repeated(study.table),
            "sweep": _repeated(study.sweep),
            "files": study.files(),
        },
    }


def _histories(task: Task) -> dict[str, Any]:
    """Return the histories that a study keeps, as its record has them."""
    return {name: {each: list(of) for each, of in columns.items()} for name, columns in task.histories.items()}


def _repeated(table: Mapping[str, Any]) -> Any:
    """Return a table as every part repeats it: of a very long one its fingerprint alone."""
    return table if len(repr(table)) < LONGEST else fingerprint(table)


@dataclass(frozen=True, kw_only=True)
class Status(Described):
    """How far a study is.

    Attributes
    ----------
    name
        Of the study.
    store
        The folder of its store.
    tasks, chunks, chunk
        Tasks and chunks in all, and tasks of a chunk.
    done
        Chunks whose part is there, and whole where that was checked.
    missing, damaged
        The first chunks without a part, and with a damaged one.
    size
        Bytes of all parts.
    """

    name: str
    store: str
    tasks: int
    chunks: int
    chunk: int
    done: int
    missing: tuple[int, ...]
    damaged: tuple[int, ...]
    size: int

    def to_result(self) -> Result:
        """Return how far it is, and the chunks that are missing or damaged."""
        from clubface.studies.study_result import status_result

        return status_result(self)


def status(
    study: str | os.PathLike[str],
    *,
    store: str | os.PathLike[str] | None = None,
    check: bool = False,
    progress: Progress | None = None,
) -> Status:
    """Return how far a study is.

    Parameters
    ----------
    study
        The file of the study, or the folder of its store.
    store
        The folder of the store of a file, unless it is the usual one.
    check
        Whether to read every part, and name the damaged ones.
    progress
        Called with the chunks looked at and the chunks in all.
    """
    opened = open_store(study, store)
    present, damaged = opened.present(), list[int]()
    for chunk in range(opened.chunks) if check else ():
        try:
            if present[chunk]:
                opened.read(chunk)
        except FileError:
            damaged.append(chunk)
        except FileNotFoundError:
            present[chunk] = 0
        if progress is not None:
            progress(chunk + 1, opened.chunks)
    missing = [chunk for chunk in range(opened.chunks) if not present[chunk]]
    return Status(
        name=opened.record["name"], store=str(opened.folder), tasks=opened.count, chunks=opened.chunks,
        chunk=opened.record["chunk"], done=opened.chunks - len(missing) - len(damaged),
        missing=tuple(missing[:SHOWN_MISSING]), damaged=tuple(damaged[:SHOWN_MISSING]), size=opened.size(),
    )  # fmt: skip
