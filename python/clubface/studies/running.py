"""Running a study: chunks of a measured size on processes, as one of several jobs; and how far it is.

Running a study: its chunks on processes of this machine, as one of several jobs, or on a cluster.

Which chunks fall to one of several jobs that share a study: every n-th, so that slow regions are shared out.

How far a study is.

How many tasks a chunk has: measured once when a study begins, and kept in its record from then on.
"""

from __future__ import annotations

import json
import os
import re
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import ClubfaceError, FileError, InputError
from clubface.shots.tables.parquet import check_pyarrow
from clubface.simulation.impact import Tally
from clubface.studies.chunks import (
    COMPUTED,
    MENDED,
    StudyStore,
    arguments_of,
    begin,
    check_study,
    checked_part,
    open_store,
    store_of,
)
from clubface.studies.kinds.kind import Computed, Task
from clubface.studies.pool import Pool
from clubface.studies.study import MOST_ROWS, StudyFile, read_study
from clubface.support.checks import check_count, check_text
from clubface.support.files import count_as_read
from clubface.support.fingerprint import fingerprint
from clubface.support.processes import processors
from clubface.support.version import __version__

FORMS = 'such as 3/40 (the third of 40), or "slurm" or "kubernetes/40" in a job of an array'
MOST = 1_000_000


class Shard(NamedTuple):
    """One of several jobs.

    Attributes
    ----------
    number
        From 1 on.
    of
        How many there are.
    """

    number: int
    of: int

    def of_all(self, chunks: int) -> range:
        """Return which of all chunks fall to it."""
        return range(self.number - 1, chunks, self.of)


def shard_of(text: str, environment: Mapping[str, str] = os.environ) -> Shard:
    """Return the shard that a text means.

    Parameters
    ----------
    text
        "3/40"; "slurm" or "slurm/40", which takes the number from ``SLURM_ARRAY_TASK_ID`` beginning at
        ``SLURM_ARRAY_TASK_MIN`` (and how many there are from ``SLURM_ARRAY_TASK_COUNT``); or "kubernetes/40", which
        takes it from ``JOB_COMPLETION_INDEX``, from 0 on. Nothing is taken from the environment unless asked for.
    environment
        The variables.
    """
    check_text("shard", text)
    name, _, count = text.partition("/")
    if name == "slurm":
        step = _variable("SLURM_ARRAY_TASK_STEP", environment, "1") or 1
        first = _variable("SLURM_ARRAY_TASK_MIN", environment)
        number = (_variable("SLURM_ARRAY_TASK_ID", environment) - first) // step + 1
        of = _whole(count, text) if count else _variable("SLURM_ARRAY_TASK_COUNT", environment)
    elif name == "kubernetes" and count:
        number, of = _variable("JOB_COMPLETION_INDEX", environment) + 1, _whole(count, text)
    elif re.fullmatch(r"\d{1,7}/\d{1,7}", text, re.ASCII):
        number, of = int(name), int(count)
    else:
        raise InputError("shard", text, FORMS)
    if not (1 <= number <= of <= MOST):
        told = text if name.isdecimal() else f"{text}, which is {number}/{of} here"
        raise InputError("shard", told, f"a number from 1 to the number of shards, {FORMS}")
    return Shard(number, of)


def _whole(text: str, given: str) -> int:
    if not re.fullmatch(r"\d{1,7}", text, re.ASCII):
        raise InputError("shard", given, FORMS)
    return int(text)


def _variable(name: str, environment: Mapping[str, str], otherwise: str | None = None) -> int:
    found = environment.get(name, otherwise)
    if found is None or not re.fullmatch(r"\d{1,9}", found, re.ASCII):
        raise InputError(name, found, "a whole number, as the scheduler sets it in every job of an array")
    return int(found)


SHOWN_CHUNKS = 20
"""Chunks that are told by their number."""


@dataclass(frozen=True, kw_only=True)
class Status:
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


def opened(which: str | os.PathLike[str], store: str | os.PathLike[str] | None = None) -> StudyStore:
    """Return the store of a study that is named by its file or by the folder of the store itself.

    Raises
    ------
    FileError
        There is none, or it belongs to another study.
    """
    path = Path(which)
    if path.is_dir():
        found = open_store(path)
        count_as_read(found.files_read())
        return found
    study = read_study(path)
    folder = Path(store) if store is not None else store_of(path)
    if not folder.exists():
        raise FileError(str(folder), None, f"nothing of this study is done yet; clubface study run {path} begins it")
    found = open_store(folder)
    check_study(found, study)
    return found


def status(
    which: str | os.PathLike[str],
    *,
    store: str | os.PathLike[str] | None = None,
    check: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Status:
    """Return how far a study is.

    Parameters
    ----------
    which
        The file of the study, or the folder of its store.
    store
        The folder of the store of a file, unless it is the usual one.
    check
        Whether to read every part, and tell the damaged ones.
    progress
        Called with the chunks looked at and the chunks in all.
    """
    found = opened(which, store)
    there = found.present()
    damaged = []
    for chunk in range(found.chunks) if check else ():
        try:
            if there[chunk]:
                checked_part(found, chunk)
        except FileError:
            damaged.append(chunk)
        except FileNotFoundError:
            there[chunk] = 0
        if progress is not None:
            progress(chunk + 1, found.chunks)
    missing = [chunk for chunk in range(found.chunks) if not there[chunk]]
    return Status(
        name=found.record["name"], store=str(found.folder), tasks=found.count, chunks=found.chunks,
        chunk=found.record["chunk"], done=found.chunks - len(missing) - len(damaged),
        missing=tuple(missing[:SHOWN_CHUNKS]), damaged=tuple(damaged[:SHOWN_CHUNKS]), size=found.size(),
    )  # fmt: skip


ENOUGH, LOADING = 0.1, 5.0
"""Time of a processor [s] over which tasks are timed, and that loading libraries does not take."""
LEAST, FEWEST = 0.1, 32
"""A chunk that takes longer [s] is made smaller where there would be fewer chunks than that."""
STEPS = (5, 2, 1)
"""A size is one of these times a power of ten."""


def chunk_size(study: StudyFile, task: Task) -> int:
    """Return the tasks of a chunk: as the study says, or as many as take the time that a chunk should take.

    The results do not depend on it. Where it is measured, a study none of whose tasks can be computed ends before it
    begins.

    Raises
    ------
    ClubfaceError
        The tasks that were tried have no result; the message says why.
    """
    if study.chunk is not None:
        return min(study.chunk, study.design.count)
    begun = time.process_time()
    _check(study, task)
    seconds, tasks = time.process_time() - begun, 1
    # Libraries are loaded in the first time, which tells the time of a task only where that is much longer.
    if seconds < LOADING:
        seconds, tasks = 0.0, 0
    while seconds < ENOUGH and tasks < min(study.design.count, MOST_ROWS):
        tasks = min(max(8 * tasks, 1), study.design.count, MOST_ROWS)
        first = (study.design.count - tasks) // 2
        begun = time.process_time()
        task.run(range(first, first + tasks))
        seconds = time.process_time() - begun
    rate = tasks / max(seconds, 1e-9)
    # A small study is cut into smaller chunks, so that several workers have some.
    shared = max(rounded(LEAST * rate), -(-study.design.count // FEWEST))
    return min(rounded(study.seconds * rate), shared, study.design.count)


def rounded(size: float) -> int:
    """Return the largest number of the form 1, 2 or 5 times a power of ten that is not above ``size``; at least 1."""
    power = 1
    while power * 10 <= min(size, MOST_ROWS):
        power *= 10
    return max(1, next((step * power for step in STEPS if step * power <= min(size, MOST_ROWS)), 1))


def tried_first(of: range) -> tuple[int, ...]:
    """Return the first, the last and the middle one of some chunks or tasks.

    A study none of which has a result is not gone on with: of an input that is swept too far to both sides, the middle
    has one.
    """
    return tuple(dict.fromkeys((*of[:1], *of[-1:], *of[len(of) // 2 :][:1])))


def _check(study: StudyFile, task: Task) -> None:
    """Refuse a study of whose tasks none that is tried first has a result."""
    found = Computed({})
    for index in tried_first(range(study.design.count)):
        try:
            found = task.run(range(index, index + 1))
        except ClubfaceError as error:
            raise study.wrap(error) from None
        if not found.failed:
            return
    raise ClubfaceError(f"no task that was tried has a result: {found.failed[0][1]}")


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
        Compute one share alone, see :func:`clubface.studies.running.shard_of`.
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
