"""All parts of a study as one table in the order of the tasks, and the sums that tell whether two runs are the same."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import FileError
from clubface.shots.tables.headings import heading_of
from clubface.shots.tables.parquet import pyarrow_for
from clubface.shots.tables.writer import csv_lines, delimiter_of, is_parquet, number_cells
from clubface.studies.chunks import TOLD, ColumnSum, Names, StudyStore, Values, arrow_array, checked_part, encoding
from clubface.studies.running import Tallied, opened
from clubface.support.files import whole_file
from clubface.units import from_si

Write = Callable[[Values], object]


@dataclass(frozen=True, kw_only=True)
class Joined:
    """A study as one table.

    Attributes
    ----------
    output
        The file, or None where only the sums were asked for.
    tasks
        Rows.
    sums
        SHA-256 of the values of every column, in the order of the tasks: 8 bytes a number [SI], least significant
        first, or a line a name. Runs of the same study have the same sums, in whatever chunks and wherever they ran.
    failed
        Tasks without a result, and the first reason.
    remark
        What is to be said of shots outside the range of their model, or "".
    processors
        The kinds of processors, where results depend on them in their last digits.
    """

    output: str | None
    tasks: int
    sums: Mapping[str, str]
    failed: tuple[int, str]
    remark: str
    processors: tuple[str, ...]


def parts(store: StudyStore) -> Iterator[tuple[Values, dict[str, Any]]]:
    """Yield columns and what is told of every part, in the order of the tasks.

    Raises
    ------
    FileError
        A part is missing or damaged.
    """
    if missing := store.present().count(0):
        message = f"{missing} of {store.chunks} chunks are not done yet; clubface study run computes them"
        raise FileError(str(store.folder), None, message)
    for chunk in range(store.chunks):
        try:
            yield checked_part(store, chunk)
        except FileNotFoundError:
            raise FileError(str(store.path(chunk)), None, "this part has been removed meanwhile") from None
        except FileError as error:
            raise FileError(error.path, None, f"{error.message}; clubface study run computes it again") from None


def join(
    which: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    store: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Joined:
    """Write all parts of a study to one file, in the order of the tasks; all parts must be there.

    Parameters
    ----------
    which
        The file of the study, or the folder of its store.
    output
        A Parquet file, whose columns are SI and carry their units; or a CSV file, whose headings name practical units.
        Without one, only the sums of the columns are computed.
    store
        The folder of the store of a file, unless it is the usual one.
    progress
        Called with the parts joined and the parts in all.
    """
    found = opened(which, store)
    target = None if output is None else Path(output)
    sums: dict[str, ColumnSum] = {}
    tally, tasks, processors = Tallied(), 0, dict[str, None]()
    with _written(target, found) as write:
        for number, (columns, told) in enumerate(parts(found), 1):
            for name, each in columns.items():
                sums.setdefault(name, ColumnSum()).add(each)
            write(columns)
            tally.notes(told)
            tasks += told["tasks"]
            processors |= dict.fromkeys([told["processor"]] if "processor" in told else ())
            if progress is not None:
                progress(number, found.chunks)
    return Joined(
        output=None if target is None else str(target), tasks=tasks,
        sums={name: each.text() for name, each in sums.items()}, failed=(tally.failed, tally.reason),
        remark=tally.remark, processors=tuple(processors),
    )  # fmt: skip


def _written(path: Path | None, store: StudyStore) -> AbstractContextManager[Write]:
    """Return what takes the columns of each part: a file, or nothing where there is none."""
    if path is None:
        return nullcontext(lambda columns: None)
    return _parquet(path, store) if is_parquet(path) else _csv(path, store)


@contextmanager
def _parquet(path: Path, store: StudyStore) -> Iterator[Write]:
    """Write Parquet, a row group a part."""
    arrow = pyarrow_for(path)
    names = [each["name"] for each in store.record["axes"] if each["unit"] is None]
    how = encoding(_order(store), names)
    units = _units(store)
    kinds = {name: arrow.dictionary(arrow.int32(), arrow.string()) for name in names}
    fields = [
        arrow.field(name, kinds.get(name, arrow.float64()), metadata={"unit": units[name]} if name in units else None)
        for name in _order(store)
    ]
    schema = arrow.schema(fields, {TOLD: json.dumps(store.record["provenance"]).encode()})

    with whole_file(path) as file, arrow.parquet.ParquetWriter(file, schema, **how) as writer:
        yield lambda columns: writer.write_table(
            arrow.Table.from_arrays([arrow_array(arrow, columns[name]) for name in _order(store)], schema=schema)
        )


@contextmanager
def _csv(path: Path, store: StudyStore) -> Iterator[Write]:
    """Write CSV in practical units."""
    headings = {name: heading_of(name, unit) for name, unit in _units(store).items()}
    delimiter = delimiter_of(path)

    def cells(name: str, each: NDArray[Any] | Names) -> list[str]:
        if isinstance(each, Names):
            return [each.choices[code] for code in each.codes.tolist()]
        return number_cells(from_si(each, headings[name][1]))

    def lines(columns: Values) -> bytes:
        return csv_lines(zip(*(cells(name, columns[name]) for name in _order(store)), strict=True), delimiter)

    with whole_file(path) as file:
        file.write(csv_lines([[headings[name][0] if name in headings else name for name in _order(store)]], delimiter))
        yield lambda columns: file.write(lines(columns))


def _order(store: StudyStore) -> Sequence[str]:
    """Return the names of the columns: what is swept, then what is computed."""
    return [*(each["name"] for each in store.record["axes"]), *store.record["columns"]]


def _units(store: StudyStore) -> dict[str, str]:
    """Return the SI units of the columns that hold numbers."""
    axes = {each["name"]: each["unit"] for each in store.record["axes"] if each["unit"] is not None}
    return {**axes, **{name: unit for name, (unit, _) in store.record["columns"].items()}}
