"""The engine of long computations: parts that are kept as they are finished, so that nothing is computed twice.

Computations that are rows of a CSV table are kept there; later runs of the same work add rows.
"""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Generic, TypeVar

from clubface.errors import FileError
from clubface.jobs.store import Finished, Store, fingerprint, unfinished_folder
from clubface.jobs.workers import in_sequence, in_threads
from clubface.support.files import prepared_folder

__all__ = ["Job", "Place", "Row", "interrupted", "run", "run_table"]

P = TypeVar("P")
R = TypeVar("R")
Compute = Callable[..., Any]
Progress = Callable[[int, int], object]
"""Function called with the number of finished parts and the number of all parts."""
Place = tuple[float, float]
"""The values of the first two columns, which identify a row."""
Row = Mapping[str, Any]


@dataclass(frozen=True)
class Job(Generic[P, R]):
    """A long computation that consists of independent parts.

    Attributes
    ----------
    what
        Name of the parts in messages, in the plural.
    parts
        The distinct parts; hashable.
    compute
        Function from a part to its result, which must consist of JSON types if it is stored. Further arguments depend
        on where it runs, see :mod:`clubface.jobs.workers`.
    name
        Function from a part to the name of its stored result.
    accepts
        Function that returns whether a stored result belongs to a part, if the name is not enough.
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
        Where the parts are computed: one of the functions of :mod:`clubface.jobs.workers`.
    store
        Store of the results; stored results are not computed again.
    finished
        Results known from elsewhere.
    progress
        Function called with the number of finished parts and the number of all parts.

    Raises
    ------
    KeyboardInterrupt
        Ctrl-C was pressed; the message gives the progress and where it is stored.
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
    """Return the error with the progress of the interrupted work and where it is stored."""
    kept = "" if folder is None or not done else f"; they are in {folder}, and the same command continues from there"
    return KeyboardInterrupt(f"{done} of {whole} {what} are done{kept}")


def run_table(
    job: Job[Place, Row],
    path: str | os.PathLike[str] | None,
    content: Mapping[str, Any],
    columns: Mapping[str, Callable[[str], Any]],
    *,
    workers: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Return the rows of a job; rows already in its table are not computed again.

    Finished rows are kept in a store next to the table until all are finished, and then written together: first the
    rows of this job, then the other rows of the table.

    Parameters
    ----------
    job
        Job from places to rows, computed by :func:`clubface.jobs.workers.in_threads`.
    path
        The CSV file, whose first line holds a fingerprint of the content. None stores no rows.
    content
        Inputs that the rows depend on, by the names used in messages. A table with other inputs raises FileError.
    columns
        Function that reads a cell, by column.
    workers
        Number of rows computed at a time. Default: the number of cores.
    progress
        Function called with the number of finished rows and of all rows.

    Raises
    ------
    FileError
        The file belongs to something else, is damaged, or is being written by another process.
    """
    if path is None:
        return list(run(job, partial(in_threads, workers=workers), progress=progress).values())
    target = Path(path)
    folder = unfinished_folder(target)
    head = f"# case {fingerprint(list(content.values()))[:16]}\n{','.join(columns)}\n"
    prepared_folder(target.parent)
    complete = _finished_rows(job, _read(target, head, columns)).keys() == set(job.parts)
    remedy = f"finish that with the same command, or remove {folder}"
    idle = complete and not folder.exists()
    with Finished() if idle else Store(folder, content, output=target, remedy=remedy) as store:
        before = _read(target, head, columns)  # read again: another process may have written it meanwhile
        finished = _finished_rows(job, before)
        rows = run(job, partial(in_threads, workers=workers), store=store, finished=finished, progress=progress)
        if not idle:
            own = {_key(place): row for place, row in rows.items()}
            others = before | {_key([store[name][each] for each in columns]): store[name] for name in store}
            text = head + _text([*own.values(), *(row for key, row in others.items() if key not in own)], columns)
            store.write_result(target, lambda file: file.write(text.encode()))
            store.remove()
    return list(rows.values())


def _finished_rows(job: Job[Place, Row], rows: Mapping[Place, Row]) -> dict[Place, Row]:
    """Return the rows of a table that are results of a job."""
    present = {place: rows[_key(place)] for place in job.parts if _key(place) in rows}
    return {place: row for place, row in present.items() if job.accepts(place, row)}


def _key(values: Sequence[float]) -> Place:
    """Return the first two values, without rounding errors of unit conversion."""
    return round(values[0], 9), round(values[1], 9)


def _read(path: Path, head: str, columns: Mapping[str, Callable[[str], Any]]) -> dict[Place, Row]:
    """Return the rows of a table by key; empty without a file."""
    if not path.exists():
        return {}
    text = path.read_bytes().decode(errors="replace").replace("\r\n", "\n")  # a Windows editor may have saved it
    lines = text.split("\n")[:-1]
    if lines[:2] != head.splitlines():
        raise FileError(str(path), 1, "this is not the table of this case; give another file, or remove it")
    rows = {}
    # Parse line by line, so that a quotation mark in a damaged line does not swallow the others.
    for number, line in enumerate(lines[2:], 3):
        try:
            (cells,) = csv.reader([line], strict=True)
            values = [read(text) for read, text in zip(columns.values(), cells, strict=True)]
        except (ValueError, csv.Error):
            raise FileError(str(path), number, "this is not a row of the table; remove it") from None
        rows[_key(values)] = dict(zip(columns, values, strict=True))
    return rows


def _text(rows: Sequence[Row], columns: Mapping[str, Any]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(
        [row[name] if isinstance(row[name], str) else repr(row[name]) for name in columns] for row in rows
    )
    return text.getvalue()
