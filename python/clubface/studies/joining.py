"""Joining all parts of a study in the order of tasks: one table, checksums for comparing runs, and histories."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import FileError, InputError
from clubface.results.result import Described, Result
from clubface.shots.tables.headings import heading_of
from clubface.shots.tables.parquet import pyarrow_for
from clubface.shots.tables.writer import columns_file, is_parquet
from clubface.studies.kinds.kind import TASK
from clubface.studies.running import ChunkTally
from clubface.studies.store import METADATA, Names, ParquetFormat, StudyStore, Values, open_store
from clubface.support.checks import check_choice, is_count
from clubface.support.files import whole_file
from clubface.units import from_si

__all__ = ["Joined", "histories", "join"]

Write = Callable[[Values], object]


@dataclass(frozen=True, kw_only=True)
class Joined(Described):
    """A study as one table.

    Attributes
    ----------
    output
        The file, or None if only the sums were computed.
    tasks
        Number of rows.
    sums
        SHA-256 of the values of every column, in the order of tasks: 8 little-endian bytes per number [SI], or one line
        per name. Runs of the same study have the same sums whatever the chunks and machines.
    failed
        Number of tasks without a result, and the first reason.
    remark
        The note on shots outside the model's range, or "".
    processors
        Kinds of processors, if the last digits of the results depend on them.
    """

    output: str | None
    tasks: int
    sums: Mapping[str, str]
    failed: tuple[int, str]
    remark: str
    processors: tuple[str, ...]

    def to_result(self) -> Result:
        """Return the SHA-256 of every column."""
        from clubface.studies.study_result import joined_result

        return joined_result(self)


def join(
    study: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    store: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Joined:
    """Write all parts of a study to one file, in the order of tasks; all parts must be finished.

    Parameters
    ----------
    study, store
        As for :func:`clubface.studies.status`.
    output
        A Parquet file, with SI columns that carry their units, or a CSV file, with practical units in the headings. By
        default only the sums of the columns are computed.
    progress
        Called with the number of parts joined and the total.
    """
    opened = open_store(study, store)
    target = None if output is None else Path(output)
    sums = {name: hashlib.sha256() for name in opened.columns}
    tally, tasks, processors = ChunkTally(), 0, dict[str, None]()
    writer = _parquet_writer if target is not None and is_parquet(target) else _csv_writer
    with nullcontext(lambda columns: None) if target is None else writer(target, opened) as write:
        for number, (columns, metadata) in enumerate(opened.parts(), 1):
            for name, each in columns.items():
                sums[name].update(_summed_bytes(each))
            write(columns)
            tally.add_notes(metadata)
            tasks += metadata["tasks"]
            processors |= dict.fromkeys([metadata["processor"]] if "processor" in metadata else ())
            if progress is not None:
                progress(number, opened.chunks)
    return Joined(
        output=None if target is None else str(target), tasks=tasks,
        sums={name: each.hexdigest() for name, each in sums.items()}, failed=tally.failed, remark=tally.remark,
        processors=tuple(processors),
    )  # fmt: skip


def _summed_bytes(values: NDArray[Any] | Names) -> bytes:
    if isinstance(values, Names):
        return "".join(f"{values.choices[code]}\n" for code in values.codes.tolist()).encode()
    return values.astype("<f8", copy=False).tobytes()


@contextmanager
def _parquet_writer(path: Path, store: StudyStore) -> Iterator[Write]:
    """Write Parquet, with one row group per part."""
    arrow = pyarrow_for(path)
    form = ParquetFormat(store.columns, {METADATA: json.dumps(store.record["provenance"]).encode()})
    with whole_file(path) as file, arrow.parquet.ParquetWriter(file, form.schema, **form.options) as writer:
        yield lambda columns: writer.write_table(form.table(columns))


@contextmanager
def _csv_writer(path: Path, store: StudyStore) -> Iterator[Write]:
    """Write CSV in practical units."""
    headings = {name: heading_of(name, unit) if unit else (name, "1") for name, unit in store.columns.items()}

    def shown(each: NDArray[Any] | Names, unit: str) -> Any:
        if isinstance(each, Names):
            return [each.choices[code] for code in each.codes.tolist()]
        return from_si(each, unit)

    with columns_file(path) as write:
        yield lambda columns: write({head: shown(columns[name], unit) for name, (head, unit) in headings.items()})


def histories(
    study: str | os.PathLike[str],
    name: str,
    *,
    tasks: Iterable[int] | None = None,
    store: str | os.PathLike[str] | None = None,
) -> dict[str, NDArray[np.float64]]:
    """Return a history kept by a study, task by task.

    Parameters
    ----------
    study, store
        As for :func:`clubface.studies.status`.
    name
        The history, such as "contact" in a finite element study.
    tasks
        Task numbers, from 0 in the order of the study; default all.

    Returns
    -------
    dict
        Columns by name [SI], float64, of equal length: the ``task`` number and the columns of the history. Tasks
        without a result have no rows.

    Raises
    ------
    InputError
        The study keeps no such history, or has no such task.
    FileError
        The study, or the requested part of it, has not been computed yet.
    """
    opened = open_store(study, store)
    if not opened.histories:
        raise InputError("history", name, 'left out: the study keeps none; ask for it, as in histories = ["contact"]')
    check_choice("history", name, opened.histories)
    wanted = None if tasks is None else list(tasks)
    for task in wanted or ():
        if not is_count(task, 0, opened.count - 1):
            raise InputError("task", task, f"a whole number from 0 to {opened.count - 1}")
    size = opened.record["chunk"]
    chunks = range(opened.chunks) if wanted is None else sorted({task // size for task in wanted})
    parts: list[dict[str, NDArray[np.float64]]] = []
    for chunk in chunks:
        try:
            columns = opened.read_history(name, chunk)
        except FileNotFoundError:
            message = f"chunk {chunk} is not done yet; clubface study run computes it"
            raise FileError(str(opened.folder), None, message) from None
        if wanted is not None:
            chosen = np.isin(columns[TASK], wanted)
            columns = {each: column[chosen] for each, column in columns.items()}
        parts.append(columns)
    return {each: np.concatenate([part[each] for part in parts] or [np.empty(0)]) for each in opened.histories[name]}
