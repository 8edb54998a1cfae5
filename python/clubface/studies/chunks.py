"""One chunk of a study: found whole in the store, or computed and kept there. All workers do this, anywhere."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError
from clubface.studies.kinds.kind import Task
from clubface.studies.parts import Names, read_part, write_part
from clubface.studies.store import StudyStore, check_study, open_store
from clubface.studies.study import StudyFile, read_study
from clubface.support.input_files import InputRecord, given_files

COMPUTED, KEPT, MENDED = "computed", "kept", "mended"
"""What was done for a chunk: computed, found in the store, or computed in place of a damaged part."""
NOTES = ("failed", "outside")
"""What a part tells of its tasks: how many have no result, with the first of them, and shots outside of a range."""


class Chunks:
    """The chunks of a study and its store.

    Parameters
    ----------
    study
        The study.
    store
        Its store.
    """

    def __init__(self, study: StudyFile, store: StudyStore) -> None:
        self._study, self._store = study, store
        self._task: Task = study.task
        self._axes = {each.name: each for each in study.design.axes}
        self._units = {name: each.unit for name, each in self._axes.items() if each.unit is not None}
        self._units |= {name: each.unit for name, each in self._task.columns.items()}

    def ensure(self, chunk: int) -> dict[str, Any]:
        """See that the part of a chunk is there and whole; return what was ``did``, and ``NOTES``."""
        try:
            return self._kept(chunk)
        except FileNotFoundError:
            did = COMPUTED
        except FileError:
            did = MENDED
        tasks = self._store.tasks(chunk)
        try:
            found = self._task.run(tasks)
        except ClubfaceError as error:
            raise self._study.wrap(error) from None
        columns = {name: self._input(name, each) for name, each in self._study.design.values(tasks).items()}
        notes = {"failed": [len(found.failed), *found.failed[:1]], "outside": found.outside}
        told = {
            "study": self._store.identity,
            "first": tasks.start,
            "tasks": len(tasks),
            **notes,
            **self._store.record["provenance"],
            **self._task.depends_on,
        }
        path = self._store.prepare(self._store.path(chunk))
        try:
            write_part(path, {**columns, **found.columns}, self._units, told)
        except FileError:
            # Another run may have finished the study meanwhile, and tidied up what it took for remains.
            with suppress(FileNotFoundError, FileError):
                return self._kept(chunk)
            raise
        return {"did": did, **notes}

    def _kept(self, chunk: int) -> dict[str, Any]:
        _, told = checked_part(self._store, chunk)
        return {"did": KEPT, **{name: told[name] for name in NOTES}}

    def _input(self, name: str, values: NDArray[Any]) -> NDArray[Any] | Names:
        axis = self._axes[name]
        return Names(axis.choices, values) if axis.choices else values.astype("float64", copy=False)


def checked_part(store: StudyStore, chunk: int) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
    """Return the columns of the part of a chunk and what is told of it.

    Raises
    ------
    FileNotFoundError
        There is none.
    FileError
        It is damaged, or the part of another chunk or study.
    """
    path, tasks = store.path(chunk), store.tasks(chunk)
    columns, told = read_part(path)
    wanted = (store.identity, tasks.start, len(tasks))
    lengths = {len(each) for each in columns.values()}
    if (told.get("study"), told.get("first"), told.get("tasks")) != wanted or lengths != {len(tasks)}:
        raise FileError(str(path), None, "this part belongs to another study")
    return columns, told


_opened: dict[tuple[str, str, str], Chunks] = {}
_opening = threading.Lock()


def ensure(study: str, folder: str, identity: str, files: Sequence[tuple[str, str, int]], chunk: int) -> dict[str, Any]:
    """See that a chunk is done, for a worker that knows the study by its file and its store alone.

    Parameters
    ----------
    study, folder
        The file of the study and the folder of its store, as this machine sees them.
    identity
        Of the store.
    files
        Path, fingerprint and size of what the study has read; the store has the contents.
    chunk
        The number of the chunk.

    Returns
    -------
    dict
        What was ``did``, and ``NOTES``.

    Raises
    ------
    FileError
        The file or the store have become those of another study.
    """
    key = (study, folder, identity)
    with _opening:
        if key not in _opened:
            store = open_store(Path(folder))
            read = read_study(study, InputRecord(given_files(files, store.inputs)))
            check_study(store, read)
            if store.identity != identity:
                raise FileError(folder, None, "this store has become that of another study meanwhile")
            _opened.clear()
            _opened[key] = Chunks(read, store)
        opened = _opened[key]
    return opened.ensure(chunk)
