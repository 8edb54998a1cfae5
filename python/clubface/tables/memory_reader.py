"""A table in memory that is read as a file is, a chunk at a time."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.tables.headings import Column
from clubface.tables.rows import Reject
from clubface.tables.writer import cell_text


class MemoryReader:
    """Columns by their headings, texts or numbers, and where each row stands. See :class:`clubface.tables.rows.Reader`.

    ``rejected`` are rows that the source has besides; they come first.
    """

    blank = 0
    notes: tuple[str, ...] = ()

    def __init__(
        self, path: str, columns: Mapping[str, Any], lines: Sequence[int], rejected: Sequence[Reject] = ()
    ) -> None:
        self.path = path
        self.header_line: int | None = None
        self.delimiter, self.decimal_comma, self.counts = ",", False, "line"
        self.headings = list(columns)
        self._columns = [np.asarray(each) for each in columns.values()]
        self._lines = lines
        self._rejected = rejected
        self._done = 0

    def chunks(self, rows: int, skip: int) -> Iterator[MemoryChunk]:
        """Yield the rows after the first ``skip``, some ``rows`` at a time."""
        rejected = list(self._rejected[skip:])
        for first in range(max(0, skip - len(self._rejected)), max(len(self._lines), 1), rows):
            self._done = first + rows
            part = slice(first, self._done)
            yield MemoryChunk([each[part] for each in self._columns], self._lines[part], rejected)
            rejected = []

    def progress(self) -> float:
        """Return which part of the table has been read, 0 to 1."""
        return min(1.0, self._done / max(len(self._lines), 1))

    def schema(self, place: int) -> Any:
        """Return the Arrow type of a column."""
        import pyarrow

        return pyarrow.float64() if self._columns[place].dtype.kind == "f" else pyarrow.string()

    def close(self) -> None:
        """Do nothing: no file is open."""


class MemoryChunk:
    """Some rows of a table in memory. See :class:`clubface.tables.rows.Chunk`."""

    def __init__(self, columns: Sequence[NDArray[Any]], lines: Sequence[int], ragged: list[Reject]) -> None:
        self._columns = columns
        self.lines = lines
        self.ragged = ragged

    def numbers(self, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
        """Return the numbers of a column, and for rows without one, why."""
        values = self._columns[column.place]
        return values, dict.fromkeys(np.flatnonzero(np.isnan(values)).tolist(), f"{column.heading}: the cell is empty")

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, or a list of texts."""
        column = self._columns[place]
        return column if column.dtype.kind == "f" else [cell_text(each) for each in column]

    def texts(self, rows: Sequence[int] | None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        which = range(len(self.lines)) if rows is None else rows
        return [[cell_text(column[row]) for column in self._columns] for row in which]

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they would stand in a CSV file."""
        text = io.StringIO()
        out = csv.writer(text, delimiter=delimiter, lineterminator="\n")
        found = []
        for cells in self.texts(rows):
            out.writerow(cells)
            found.append(text.getvalue().removesuffix("\n"))
            text.seek(0)
            text.truncate()
        return found

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows as an Arrow array."""
        import pyarrow

        values = self._columns[place] if rows is None else self._columns[place][list(rows)]
        return pyarrow.array(values, from_pandas=True)  # NaN is null: nothing was measured
