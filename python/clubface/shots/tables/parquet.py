"""Deliveries from and launches to Parquet files; the only module that needs pyarrow."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any, BinaryIO

from clubface.errors import FileError
from clubface.shots.tables.cells import parsed
from clubface.shots.tables.chunk import GONE, Chunk, Reject
from clubface.shots.tables.file_kind import START, refuse_no_table
from clubface.shots.tables.headings import HAND, Column
from clubface.support.files import open_input

ENDINGS = (".parquet", ".pq")


def pyarrow_for(path: Path | str) -> Any:
    """Return the module pyarrow, or say what ``path`` needs it for."""
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise _missing(path) from None
    return pyarrow


def check_pyarrow(path: Path | str) -> None:
    """Say what ``path`` needs pyarrow for where it is not installed, without the time that loading it takes."""
    if find_spec("pyarrow") is None:
        raise _missing(path)


def _missing(path: Path | str) -> FileError:
    return FileError(str(path), None, 'a Parquet file needs pyarrow: pip install "clubface[tables]"')


class ParquetReader:
    """A Parquet file. See :class:`clubface.shots.tables.chunk.Reader`."""

    counts = "row"
    header_line: int | None = None
    delimiter = ","
    decimal_comma = False
    blank = 0
    notes: tuple[str, ...] = ()

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self._arrow, source = pyarrow_for(path), open_input(path)
        try:
            start = source.read(START)
            if not start.startswith(b"PAR1"):
                refuse_no_table(path, start)
                raise FileError(self.path, None, "this is no Parquet file; the name of a text must end in .csv or .tsv")
            source.seek(0)
            self._file = self._arrow.parquet.ParquetFile(source)
        except (OSError, ValueError, self._arrow.ArrowException) as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise FileError(self.path, None, f"cannot be read as Parquet: {reason}") from None
        self.headings: list[str] = list(self._file.schema_arrow.names)
        self._rows = self._file.metadata.num_rows
        self._read = 0

    def chunks(self, rows: int, skip: int) -> Iterator[ParquetChunk]:
        """Yield the rows after the first ``skip``, some ``rows`` at a time."""
        try:
            for batch in self._file.iter_batches(rows):
                batch.validate(full=True)  # text that is not UTF-8, which a damaged page brings
                first, self._read = self._read, self._read + batch.num_rows
                if self._read > skip:
                    from_ = max(0, skip - first)
                    yield ParquetChunk(batch.slice(from_), first + from_)
        except (OSError, self._arrow.ArrowException) as error:
            raise FileError(self.path, None, f"cannot be read after row {self._read}: {error}") from None

    def column_parts(self, rows: int) -> Iterator[tuple[list[Any], Sequence[int]]]:
        """Yield the cells of some ``rows`` at a time by column, as an array of numbers or as texts, and the rows."""
        for chunk in self.chunks(rows, 0):
            yield [chunk.cells(place) for place in range(len(self.headings))], chunk.lines

    def progress(self) -> float:
        """Return which part of the file has been read, 0 to 1."""
        return self._read / self._rows if self._rows else 1.0

    def schema(self, place: int) -> Any:
        """Return the Arrow type of a column."""
        return self._file.schema_arrow.field(place).type

    def close(self) -> None:
        """Close the file."""
        self._file.close()


class ParquetChunk:
    """Some rows of a Parquet file. See :class:`clubface.shots.tables.chunk.Chunk`."""

    def __init__(self, batch: Any, first: int) -> None:
        self._batch = batch
        self.lines: Sequence[int] = range(first + 1, first + 1 + batch.num_rows)
        self.ragged: list[Reject] = []

    def numbers(self, column: Column) -> tuple[Any, dict[int, str]]:
        """Return the numbers of a column in its unit, and for rows without one, why."""
        import numpy as np

        values = self._batch.column(column.place)
        numbers = self.cells(column.place)
        if isinstance(numbers, list):
            return parsed(numbers, column, False)
        if column.quantity == HAND:
            return parsed(["" if each is None else _text(each) for each in values.to_pylist()], column, False)
        bad = np.flatnonzero(~np.isfinite(numbers))
        missing = values.is_null()
        reasons = {
            int(row): f"{column.heading}: "
            + ("the cell is empty" if missing[int(row)].as_py() else f"{numbers[row]} is not a finite number")
            for row in bad
        }
        return numbers, reasons

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, NaN where there is none, or a list of texts."""
        import pyarrow

        values = self._batch.column(place)
        if pyarrow.types.is_integer(values.type) or pyarrow.types.is_floating(values.type):
            return values.cast(pyarrow.float64(), safe=False).to_numpy(zero_copy_only=False)
        return ["" if each is None else _text(each) for each in values.to_pylist()]

    def texts(self, rows: Sequence[int] | None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        batch = self._batch if rows is None else self._batch.take(_indices(rows))
        columns = [["" if each is None else _text(each) for each in column.to_pylist()] for column in batch.columns]
        return [list(cells) for cells in zip(*columns, strict=True)]

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they would stand in a CSV file."""
        found = []
        for cells in self.texts(rows):
            line = io.StringIO()
            csv.writer(line, delimiter=delimiter, lineterminator="").writerow(cells)
            found.append(line.getvalue())
        return found

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows as an Arrow array of its own type."""
        column = self._batch.column(place)
        return column if rows is None else column.take(_indices(rows))


class ParquetForm:
    """Launches written to Parquet, a row group a chunk. See :class:`clubface.shots.tables.writer.Form`."""

    def __init__(
        self, path: Path, headings: Sequence[str], types: Sequence[Any], results: Sequence[str], provenance: Any
    ) -> None:
        self._arrow = arrow = pyarrow_for(path)
        kinds = [arrow.string() if kind is None else kind for kind in types] + [arrow.float64()] * len(results)
        metadata = {"clubface": json.dumps(provenance, default=str)}
        self._schema = arrow.schema(list(zip([*headings, *results], kinds, strict=True)), metadata)
        self._width = len(headings)

    def piece(self, file: BinaryIO, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a chunk (None: all), each followed by its results."""
        cells = [chunk.arrow(place, rows) for place in range(self._width)]
        arrays = [*cells, *(self._arrow.array(each) for each in results)]
        self._arrow.parquet.write_table(self._arrow.Table.from_arrays(arrays, schema=self._schema), file)

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the row groups of all pieces."""
        with self._arrow.parquet.ParquetWriter(file, self._schema) as writer:
            for path in pieces:
                try:
                    table = self._arrow.parquet.read_table(path, schema=self._schema)
                except (OSError, ValueError, self._arrow.ArrowException):
                    raise FileError(str(path), None, GONE) from None
                writer.write_table(table)


def write_parquet(columns: Mapping[str, Any], file: BinaryIO, path: Path) -> None:
    """Write a whole table to the ``file`` that will be ``path``; NaN becomes null."""
    arrow = pyarrow_for(path)
    arrays = {name: arrow.array(values, from_pandas=True) for name, values in columns.items()}
    arrow.parquet.write_table(arrow.table(arrays), file)


def _indices(rows: Sequence[int]) -> Any:
    import pyarrow

    return pyarrow.array(rows, pyarrow.int64())


def _text(value: Any) -> str:
    if isinstance(value, float) and math.isfinite(value):
        return f"{value:.15g}" if float(f"{value:.15g}") == value else repr(value)
    return str(value)
