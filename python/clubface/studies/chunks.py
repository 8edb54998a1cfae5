"""The chunks of a study: how large they are, and one of them found whole in the store or computed and kept there."""

from __future__ import annotations

import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError
from clubface.studies.kinds.kind import Computed, Task
from clubface.studies.store import Names, StudyStore, open_folder
from clubface.studies.study import MOST_ROWS, StudyFile, read_study
from clubface.support.files import InputRecord, absolute, given_files

__all__ = ["COMPUTED", "KEPT", "REPAIRED", "Chunks", "SharedStudy", "chunk_size", "first_tried", "shared"]

COMPUTED, KEPT, REPAIRED = "computed", "kept", "repaired"
"""What was done for a chunk: computed, found in the store, or computed in place of a damaged part."""
NOTES = ("failed", "outside")
"""What a part says of its tasks: how many have no result, with the first of them, and shots outside of a range."""


class Chunks:
    """Computes the chunks of a study into its store."""

    def __init__(self, study: StudyFile, store: StudyStore) -> None:
        self._study, self._store = study, store
        self._task: Task = study.task
        self._axes = {each.name: each for each in study.design.axes}

    def ensure(self, chunk: int) -> dict[str, Any]:
        """Make sure that the part of a chunk is there and whole; return what was ``done`` for it, and ``NOTES``."""
        try:
            return self._kept(chunk)
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
            # First the histories: a part that is there has them.
            for name, columns in computed.histories.items():
                self._store.write_history(name, chunk, columns)
            self._store.write(chunk, {**inputs, **computed.columns}, {**notes, **self._task.depends_on})
        except FileError:
            # Another run may have finished the study meanwhile, and removed what it took for remains.
            with suppress(FileNotFoundError, FileError):
                return self._kept(chunk)
            raise
        return {"done": done, **notes}

    def _kept(self, chunk: int) -> dict[str, Any]:
        _, metadata = self._store.read(chunk)
        for name in self._store.histories:
            self._store.read_history(name, chunk)
        return {"done": KEPT, **{name: metadata[name] for name in NOTES}}

    def _input(self, name: str, values: NDArray[Any]) -> NDArray[Any] | Names:
        axis = self._axes[name]
        return Names(axis.choices, values) if axis.choices else values.astype("float64", copy=False)


class SharedStudy(NamedTuple):
    """A study as its workers know it, on this machine or another one; it computes chunks by their number.

    Attributes
    ----------
    path, folder
        The file of the study and the folder of its store, as all of them see them.
    identity
        Of the store.
    files
        Path, checksum and size of what the study has read; the store has the contents.
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
    """Return a study as its workers know it."""
    files = [(path, each.sha256, each.size) for path, each in study.inputs.by_path().items()]
    return SharedStudy(absolute(study.path), absolute(store.folder), store.identity, files)


TIMED_SECONDS, LOADING_SECONDS = 0.1, 5.0
"""Processor time [s] over which tasks are timed, and that loading libraries does not take."""
SMALL_CHUNK_SECONDS, SMALL_CHUNKS = 0.1, 32
"""A chunk that takes longer [s] is made smaller where there would be fewer chunks than that."""


def chunk_size(study: StudyFile, task: Task) -> int:
    """Return the tasks of a chunk: as the study says, or as many as take the time that a chunk should take.

    The results do not depend on it. Where it is measured, a study none of whose tasks can be computed ends before it
    begins.

    Raises
    ------
    ClubfaceError
        The tasks that were tried have no result; the message says why.
    """
    count = study.design.count
    if study.chunk is not None:
        return min(study.chunk, count)
    begun = time.process_time()
    _check_results(study, task)
    seconds, tasks = time.process_time() - begun, 1
    # The first time includes loading libraries: it is the time of a task only where it is much longer than that.
    if seconds < LOADING_SECONDS:
        seconds, tasks = 0.0, 0
    while seconds < TIMED_SECONDS and tasks < min(count, MOST_ROWS):
        tasks = min(max(8 * tasks, 1), count, MOST_ROWS)
        first = (count - tasks) // 2
        begun = time.process_time()
        task.run(range(first, first + tasks))
        seconds = time.process_time() - begun
    rate = tasks / max(seconds, 1e-9)
    # A small study is cut into smaller chunks, so that several workers have some.
    shared = max(_rounded_down(SMALL_CHUNK_SECONDS * rate), -(-count // SMALL_CHUNKS))
    return min(_rounded_down(study.seconds * rate), shared, count)


def _rounded_down(size: float) -> int:
    """Return the largest 1, 2 or 5 times a power of ten that is not above ``size``; at least 1."""
    steps = (step * 10**power for power in range(6) for step in (1, 2, 5))
    return max((step for step in steps if step <= min(size, MOST_ROWS)), default=1)


def first_tried(numbers: range) -> tuple[int, ...]:
    """Return the first, the last and the middle one of some chunks or tasks: without any result the study ends there.

    An input that is swept too far to both sides has results in the middle.
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
