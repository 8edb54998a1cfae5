"""Running a study: its chunks on processes of this machine, as one of several jobs, or on a cluster."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError, InputError
from clubface.simulation.outside import Tally
from clubface.studies.chunk_size import chunk_size, tried_first
from clubface.studies.chunks import COMPUTED, MENDED
from clubface.studies.kinds.kind import Task
from clubface.studies.pool import Pool
from clubface.studies.shards import Shard, shard as shard_of
from clubface.studies.store import StudyStore, arguments_of, begin, store_of
from clubface.studies.study import StudyFile, read_study
from clubface.support.checks import check_count
from clubface.support.fingerprint import fingerprint
from clubface.support.processors import processors
from clubface.support.version import __version__
from clubface.tables.parquet import check_pyarrow

COMMAND = (sys.executable, "-P", "-W", "ignore", "-m", "clubface.studies.worker")
MOST_WORKERS = 1024
LONGEST = 10_000
"""Characters of a table that every part repeats."""
SHOWN = 5
"""Chunks that are told by their number."""


@dataclass(frozen=True, kw_only=True)
class Outcome:
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
        What is to be said of shots outside the range of their model, or "".
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


class Tallied:
    """Counts what workers tell of chunks, in a space that does not grow with their number."""

    def __init__(self) -> None:
        self.computed = self.mended = self.failed = 0
        self.shown: list[int] = []
        self._first: tuple[int, str] | None = None
        self._outside = Tally()

    def add(self, chunk: int, told: Mapping[str, Any]) -> None:
        """Count a chunk."""
        self.computed += told["did"] in (COMPUTED, MENDED)
        if told["did"] == MENDED:
            self.mended += 1
            if len(self.shown) < SHOWN:
                self.shown.append(chunk)
        self.notes(told)

    def notes(self, told: Mapping[str, Any]) -> None:
        """Count the tasks of a chunk without a result, and outside of a range."""
        count, *first = told["failed"]
        self.failed += count
        for index, reason in first:
            if self._first is None or index < self._first[0]:
                self._first = (index, reason)
        self._outside.add_counts(told["outside"])

    @property
    def reason(self) -> str:
        """Why the first task without a result has none, or ""."""
        return f"task {self._first[0]}: {self._first[1]}" if self._first else ""

    @property
    def remark(self) -> str:
        """What is to be said of shots outside the range of their model, or ""."""
        return self._outside.remark()


def run(
    which: str | os.PathLike[str] | StudyFile,
    *,
    store: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    shard: str | None = None,
    scheduler: str | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Outcome:
    """Compute what is missing of a study; what is there is checked and stays.

    Parameters
    ----------
    which
        The file of the study, or a :class:`StudyFile`.
    store
        The folder of what is finished; beside the file, with the ending ".store", unless given. All who share a study
        name the same folder.
    workers
        Processes at a time on this machine; left out, one for each processor that this process may use.
    shard
        Compute one share alone, see :func:`clubface.studies.shards.shard`.
    scheduler
        Address of the scheduler of a Dask cluster, whose workers compute instead of this machine.
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
    if workers is not None:
        workers = check_count("workers", workers, 1, MOST_WORKERS)
    if scheduler is not None and workers is not None:
        raise InputError("workers", workers, "leave it out with a scheduler, whose cluster has its own workers")
    share = Shard(1, 1) if shard is None else shard_of(shard)
    study = which if isinstance(which, StudyFile) else read_study(which)
    folder = Path(store) if store is not None else store_of(study.path)
    check_pyarrow(folder)
    if scheduler is not None:
        return _run(study, folder, share, None, scheduler, progress)
    most = len(share.of_all(-(-study.design.count // (study.chunk or 1))))
    with Pool(COMMAND, min(workers or processors(), most)) as pool:
        return _run(study, folder, share, pool, None, progress)


def _run(
    study: StudyFile, folder: Path, share: Shard, pool: Pool | None, scheduler: str | None,
    progress: Callable[[int, int], object] | None,
) -> Outcome:  # fmt: skip
    """Compute the chunks of a share by a pool or on a cluster."""
    task = study.task
    fresh = not folder.exists()
    opened = begin(folder, study, lambda: _description(study, task))
    mine = share.of_all(opened.chunks)
    whole, hopeless = len(mine), set(tried_first(mine))
    tally, done, results = Tallied(), 0, 0

    def ended(chunk: int, told: Mapping[str, Any]) -> None:
        nonlocal done, results
        done += 1
        tally.add(chunk, told)
        failed, *first = told["failed"]
        results += (tried := len(opened.tasks(chunk))) - failed
        if told["did"] == COMPUTED and failed == tried and chunk in hopeless:
            hopeless.discard(chunk)
            if not hopeless and not results:
                raise ClubfaceError(f"no task that was tried has a result: {first[0][1]}")
        if progress is not None:
            progress(done, whole)

    arguments = arguments_of(opened, study)
    try:
        if scheduler is not None:
            from clubface.studies.cluster import work_on_cluster

            work_on_cluster(scheduler, arguments, order(opened, share), done=ended)
        elif pool is not None:
            pool.work(order(opened, share), ended, first=json.dumps(arguments) + "\n")
    except (KeyboardInterrupt, ClubfaceError) as stop:
        present = opened.present()
        there = sum(present[chunk] for chunk in mine)
        kept = f"{there} of {whole} chunks are done and kept in {folder}"
        if isinstance(stop, KeyboardInterrupt):
            raise KeyboardInterrupt(f"{kept}; the same command goes on after them") from None
        # Parts that nobody told of here are those of other runs, such as other shards, and may have results.
        if fresh and not results and sum(present) == done:
            opened.remove()
            raise
        if not there:
            raise
        raise ClubfaceError(f"{stop}; {kept}") from None
    missing = opened.present().count(0)
    if not missing:
        opened.tidy()
    tasks = sum(len(opened.tasks(chunk)) for chunk in mine)
    return Outcome(
        store=str(folder), chunks=whole, tasks=tasks, computed=tally.computed,
        mended=(tally.mended, tuple(tally.shown)), failed=(tally.failed, tally.reason), remark=tally.remark,
        missing=missing,
    )  # fmt: skip


def order(store: StudyStore, share: Shard) -> Iterator[int]:
    """Yield the chunks of a share: first those that are missing, then those that are there, to be checked.

    Of each those by which a study is judged come first.
    """
    there, mine = store.present(), share.of_all(store.chunks)
    first = tried_first(mine)
    for wanted in (0, 1):
        yield from (
            chunk for chunk in chain(first, (each for each in mine if each not in first)) if there[chunk] == wanted
        )


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
        "provenance": {
            "name": study.name,
            "clubface_version": __version__,
            "kind": study.kind.name,
            "design": study.method,
            "seed": study.seed,
            "inputs": _told(study.table),
            "sweep": _told(study.sweep),
            "files": study.files(),
        },
    }


def _told(table: Mapping[str, Any]) -> Any:
    """Return a table as every part repeats it: of a very long one its fingerprint alone."""
    return table if len(repr(table)) < LONGEST else fingerprint(table)
