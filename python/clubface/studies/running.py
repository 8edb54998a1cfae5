"""Running a study chunk by chunk, in processes, in shards or on a cluster; and its status."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError, InputError
from clubface.jobs.store import fingerprint
from clubface.jobs.workers import Shard, in_processes, on_cluster, shard_of, worker_count
from clubface.results.result import Described, Result
from clubface.shots.tables.parquet import check_pyarrow
from clubface.simulation.impact import Tally
from clubface.studies.kinds.kind import Computed, Task
from clubface.studies.store import Names, StudyStore, begin, open_folder, open_store, store_folder
from clubface.studies.study import MOST_ROWS, StudyFile, read_study
from clubface.support.files import InputRecord, absolute, given_files
from clubface.support.version import __version__

__all__ = [
    "COMPUTED", "KEPT", "REPAIRED", "ChunkTally", "Chunks", "Outcome", "SharedStudy", "Status", "chunk_size",
    "first_tried", "run", "shared", "status",
]  # fmt: skip

COMPUTED, KEPT, REPAIRED = "computed", "kept", "repaired"
"""How a chunk was obtained: computed, found in the store, or recomputed to replace a damaged part."""
NOTES = ("failed", "outside")
"""Notes in a part: number of tasks without a result, with the first of them, and shots out of range."""


LONGEST = 10_000
"""Maximum length [characters] of a table repeated in every part."""
SHOWN_REPAIRED, SHOWN_MISSING = 5, 20
"""Maximum number of repaired and of missing chunks listed."""
Progress = Callable[[int, int], object]


class Chunks:
    """Computes the chunks of a study into its store."""

    def __init__(self, study: StudyFile, store: StudyStore) -> None:
        self._study, self._store = study, store
        self._task: Task = study.task
        self._axes = {each.name: each for each in study.design.axes}

    def ensure(self, chunk: int) -> dict[str, Any]:
        """Make sure that the part of a chunk is complete; return what was ``done``, and ``NOTES``."""
        try:
            return self._read_kept(chunk)
        except FileNotFoundError:
            done = COMPUTED
        except FileError:
            done = REPAIRED
        tasks = self._store.tasks(chunk)
        try:
            computed = self._task.run(tasks)
        except ClubfaceError as error:
            raise self._study.wrap(error) from None
        inputs = {name: self._input(name, each) for name, each in self._study.design.values(tasks).items()}
        notes = {"failed": [len(computed.failed), *computed.failed[:1]], "outside": computed.outside}
        try:
            # Histories first: a part that exists must have them.
            for name, columns in computed.histories.items():
                self._store.write_history(name, chunk, columns)
            self._store.write(chunk, {**inputs, **computed.columns}, {**notes, **self._task.depends_on})
        except FileError:
            # Another run may have finished the study meanwhile and removed temporary files.
            with suppress(FileNotFoundError, FileError):
                return self._read_kept(chunk)
            raise
        return {"done": done, **notes}

    def _read_kept(self, chunk: int) -> dict[str, Any]:
        _, metadata = self._store.read(chunk)
        for name in self._store.histories:
            self._store.read_history(name, chunk)
        return {"done": KEPT, **{name: metadata[name] for name in NOTES}}

    def _input(self, name: str, values: NDArray[Any]) -> NDArray[Any] | Names:
        axis = self._axes[name]
        return Names(axis.choices, values) if axis.choices else values.astype("float64", copy=False)


class SharedStudy(NamedTuple):
    """A study in the form sent to workers on any machine; called with a chunk number, it computes the chunk.

    Attributes
    ----------
    path, folder
        The study file and the folder of its store, as all workers see them.
    identity
        Identity of the store.
    files
        Path, checksum and size of the files read by the study; the store has their contents.
    """

    path: str
    folder: str
    identity: str
    files: Sequence[tuple[str, str, int]]

    def __call__(self, chunk: int) -> dict[str, Any]:
        """Make sure that a chunk is done, see :meth:`Chunks.ensure`."""
        with _opening:
            if self[:3] not in _opened:
                store = open_folder(Path(self.folder))
                study = read_study(self.path, InputRecord(given_files(self.files, store.inputs)))
                store.check(study)
                if store.identity != self.identity:
                    raise FileError(self.folder, None, "this store now belongs to another study")
                _opened.clear()
                _opened[self[:3]] = Chunks(study, store)
            chunks = _opened[self[:3]]
        return chunks.ensure(chunk)


_opened: dict[tuple[Any, ...], Chunks] = {}
_opening = threading.Lock()


def shared(store: StudyStore, study: StudyFile) -> SharedStudy:
    """Return a study in the form sent to workers."""
    files = [(path, each.sha256, each.size) for path, each in study.inputs.by_path().items()]
    return SharedStudy(absolute(study.path), absolute(store.folder), store.identity, files)


TIMED_SECONDS, LOADING_SECONDS = 0.1, 5.0
"""Minimum processor time [s] for timing tasks, and upper limit of the time for loading libraries."""
SMALL_CHUNK_SECONDS, SMALL_CHUNKS = 0.1, 32
"""Chunks longer than this time [s] are made smaller if there would be fewer than this number of chunks."""


def chunk_size(study: StudyFile, task: Task) -> int:
    """Return the number of tasks per chunk, as given in the study or measured to take the wanted time.

    Results do not depend on it. If it is measured, a study without any result ends before it begins.

    Raises
    ------
    ClubfaceError
        The tasks tried have no result; the message says why.
    """
    count = study.design.count
    if study.chunk is not None:
        return min(study.chunk, count)
    begun = time.process_time()
    _check_results(study, task)
    seconds, tasks = time.process_time() - begun, 1
    # The first time includes loading libraries, so it counts only if it is much longer than that.
    if seconds < LOADING_SECONDS:
        seconds, tasks = 0.0, 0
    while seconds < TIMED_SECONDS and tasks < min(count, MOST_ROWS):
        tasks = min(max(8 * tasks, 1), count, MOST_ROWS)
        first = (count - tasks) // 2
        begun = time.process_time()
        task.run(range(first, first + tasks))
        seconds = time.process_time() - begun
    rate = tasks / max(seconds, 1e-9)
    # A small study gets smaller chunks, so that several workers have something to do.
    shared = max(_rounded_down(SMALL_CHUNK_SECONDS * rate), -(-count // SMALL_CHUNKS))
    return min(_rounded_down(study.seconds * rate), shared, count)


def _rounded_down(size: float) -> int:
    """Return the largest 1, 2 or 5 times a power of ten up to ``size``, and at least 1."""
    steps = (step * 10**power for power in range(6) for step in (1, 2, 5))
    return max((step for step in steps if step <= min(size, MOST_ROWS)), default=1)


def first_tried(numbers: range) -> tuple[int, ...]:
    """Return the first, last and middle of some chunks or tasks; if none of them has a result, the study ends.

    An input swept too far on both sides still has results in the middle.
    """
    return tuple(dict.fromkeys((*numbers[:1], *numbers[-1:], *numbers[len(numbers) // 2 :][:1])))


def _check_results(study: StudyFile, task: Task) -> None:
    computed = Computed({})
    for index in first_tried(range(study.design.count)):
        try:
            computed = task.run(range(index, index + 1))
        except ClubfaceError as error:
            raise study.wrap(error) from None
        if not computed.failed:
            return
    raise ClubfaceError(f"no task that was tried has a result: {computed.failed[0][1]}")


@dataclass(frozen=True, kw_only=True)
class Outcome(Described):
    """The outcome of a run.

    Attributes
    ----------
    store
        The folder of the store.
    chunks, tasks
        Numbers for this run: the whole study, or a shard.
    computed
        Number of chunks computed now; the others existed.
    mended
        Number of these that replaced damaged parts, and the first of them.
    failed
        Number of tasks without a result, and the first reason.
    remark
        The note on shots outside the model's range, or "".
    missing
        Number of chunks of the whole study that no run has finished.
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
        """Return what was computed, and what is left to other runs, as a result."""
        from clubface.studies.study_result import run_result

        return run_result(self)


class ChunkTally:
    """Sums of the notes of chunks, in constant memory."""

    def __init__(self) -> None:
        self.computed = self.repaired = self._failed = 0
        self.shown: list[int] = []
        self._first: tuple[int, str] | None = None
        self._outside = Tally()

    def add(self, chunk: int, notes: Mapping[str, Any]) -> None:
        """Add a chunk finished by a worker."""
        self.computed += notes["done"] != KEPT
        if notes["done"] == REPAIRED:
            self.repaired += 1
            if len(self.shown) < SHOWN_REPAIRED:
                self.shown.append(chunk)
        self.add_notes(notes)

    def add_notes(self, notes: Mapping[str, Any]) -> None:
        """Add a chunk's tasks without a result, and shots out of range."""
        count, *first = notes["failed"]
        self._failed += count
        for index, reason in first:
            if self._first is None or index < self._first[0]:
                self._first = (index, reason)
        self._outside.add_counts(notes["outside"])

    @property
    def failed(self) -> tuple[int, str]:
        """Number of tasks without a result, and the reason for the first."""
        return self._failed, f"task {self._first[0]}: {self._first[1]}" if self._first else ""

    @property
    def remark(self) -> str:
        """The note on shots outside the model's range, or ""."""
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
    """Compute the missing chunks of a study; existing ones are checked and kept.

    Parameters
    ----------
    study
        The study file, or a :class:`StudyFile`.
    store
        The folder for finished chunks; default next to the file, with the ending ".store". All runs that share a study
        must use the same folder.
    workers
        Number of processes on this machine; default one per processor available to this process.
    shard
        Compute only one share, see :func:`clubface.jobs.workers.shard_of`.
    scheduler
        Address of a Dask scheduler, whose workers compute instead of this machine. They need this version of clubface,
        and the store under the same path as here.
    progress
        Called with the number of chunks done and the total of this run.

    Raises
    ------
    FileError
        The study has an error, or the store belongs to another study.
    ClubfaceError
        A chunk cannot be computed; finished chunks are kept.
    KeyboardInterrupt
        Ctrl-C was pressed; the message says where the finished chunks are kept.
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
            raise KeyboardInterrupt(f"{kept}; the same command continues from there") from None
        # Other parts are from other runs, such as other shards, and may have results.
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
    """Yield the chunks of a share: first missing ones, then existing ones, which are checked.

    In each group, the chunks of :func:`first_tried` come first.
    """
    present, mine = store.present(), share.of_all(store.chunks)
    first = first_tried(mine)
    for wanted in (0, 1):
        numbers = chain(first, (each for each in mine if each not in first))
        yield from (chunk for chunk in numbers if present[chunk] == wanted)


def _description(study: StudyFile, task: Task) -> dict[str, Any]:
    """Return the remaining record of a new study."""
    axes = [{name: getattr(each, name) for name in ("name", "unit", "choices", "count")} for each in study.design.axes]
    kept = {name: {each: list(of) for each, of in columns.items()} for name, columns in task.histories.items()}
    return {
        "chunk": chunk_size(study, task),
        "axes": axes,
        "columns": {name: list(each) for name, each in task.columns.items()},
        **({"histories": kept} if kept else {}),
        "provenance": {
            "name": study.name,
            "clubface_version": __version__,
            "kind": study.kind.name,
            "design": study.method,
            "seed": study.seed,
            "inputs": _table_or_fingerprint(study.table),
            "sweep": _table_or_fingerprint(study.sweep),
            "files": study.files(),
        },
    }


def _table_or_fingerprint(table: Mapping[str, Any]) -> Any:
    """Return a table for the record of every part; a very long table is replaced by its fingerprint."""
    return table if len(repr(table)) < LONGEST else fingerprint(table)


@dataclass(frozen=True, kw_only=True)
class Status(Described):
    """The status of a study.

    Attributes
    ----------
    tasks, chunks, chunk
        Total tasks and chunks, and tasks per chunk.
    done
        Number of chunks with a part (undamaged, if checked).
    missing, damaged
        The first chunks without a part, and with a damaged one.
    size
        Size of all parts [bytes].
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
        """Return the status, with missing and damaged chunks, as a result."""
        from clubface.studies.study_result import status_result

        return status_result(self)


def status(
    study: str | os.PathLike[str],
    *,
    store: str | os.PathLike[str] | None = None,
    check: bool = False,
    progress: Progress | None = None,
) -> Status:
    """Return the status of a study.

    Parameters
    ----------
    study
        The study file, or the folder of its store.
    store
        The folder of the study's store; default next to the file.
    check
        Whether to read every part and list damaged ones.
    progress
        Called with the number of chunks checked and the total.
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
