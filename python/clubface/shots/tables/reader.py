"""Tables of shots read a chunk at a time, from files and from memory.

Opening a file of shots, by the ending of its name.

CSV files and workbooks a chunk at a time: every row with the line it begins at, whatever is in its cells.

A table in memory that is read as a file is, a chunk at a time.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import FileError
from clubface.shots.tables.cells import decimals_of, doubt, parsed, ragged_reason
from clubface.shots.tables.chunk import Reader, Reject
from clubface.shots.tables.headings import Column, shot_words, split_heading
from clubface.shots.tables.parquet import ENDINGS, ParquetReader
from clubface.shots.tables.row_source import DECIMAL_ROWS, Row, open_rows
from clubface.shots.tables.writer import cell_text

LARGEST_CHUNK = 64_000_000
"""Characters of text after which a chunk ends early, so that long rows do not fill the memory."""


class CsvReader:
    """A CSV file, with commas, semicolons, tabs or bars between cells, or a workbook. See :class:`rows.Reader`."""

    counts = "line"

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self._rows = open_rows(path)
        self.delimiter = self._rows.delimiter
        try:
            self._read_header()
        except BaseException:
            self._rows.close()
            raise

    @property
    def blank(self) -> int:
        """Blank lines passed over so far."""
        return self._rows.blank

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the rows should know of the file, as far as it is read."""
        return (*self._rows.notes, *([doubt(self._doubtful)] if self._doubtful else []))

    def _read_header(self) -> None:
        row = self._rows.next()
        if row is None:
            raise FileError(self.path, 1, "the file is empty: its first row must name the columns")
        if isinstance(row, Reject):
            raise FileError(self.path, row.line, row.reason)
        self.headings = row[0]
        self.header_line: int | None = row[1]
        self.decimal_comma = False
        self._seen: list[Row | Reject] = []
        self._decide_decimal()

    def _decide_decimal(self) -> None:
        """Look at the first rows: a number such as "50,5" is one with a decimal comma."""
        while len(self._seen) < DECIMAL_ROWS and (row := self._rows.next()) is not None:
            self._seen.append(row)
        rows = [row[0] for row in self._seen if not isinstance(row, Reject)]
        words = shot_words()
        quantities = [words.names.get(split_heading(each, words)[0]) for each in self.headings]
        cells = ((cell, quantity) for row in rows for cell, quantity in zip(row, quantities, strict=False))
        self.decimal_comma, self._doubtful = decimals_of(cells, self.delimiter)

    def chunks(self, rows: int, skip: int) -> Iterator[CsvChunk]:
        """Yield the rows after the first ``skip``, some ``rows`` at a time."""
        width = len(self.headings)
        passed = 0
        at_end = False
        while not at_end:
            kept: list[list[str]] = []
            lines: list[int] = []
            written: list[str] = []
            ragged: list[Reject] = []
            size = 0
            for _ in range(rows if passed >= skip else min(rows, skip - passed)):
                row = self._seen.pop(0) if self._seen else self._rows.next()
                if row is None:
                    at_end = True
                    break
                if isinstance(row, Reject):
                    ragged.append(row._replace(cells=[*row.cells, *[""] * width][:width]))
                    continue
                cells, line, text = row
                size += len(text)
                if len(cells) == width:
                    kept.append(cells)
                    lines.append(line)
                    written.append(text)
                else:
                    ragged.append(_ragged(cells, line, width))
                if size > LARGEST_CHUNK:
                    break
            count = len(kept) + len(ragged)
            if passed >= skip and count:
                yield CsvChunk(kept, lines, written, ragged, self.decimal_comma)
            passed += count

    def progress(self) -> float:
        """Return which part of the file has been read, 0 to 1."""
        return self._rows.progress()

    def schema(self, place: int) -> None:
        """Return None: every column is text."""
        return

    def close(self) -> None:
        """Close the file."""
        self._rows.close()


class CsvChunk:
    """Some rows of a CSV file. See :class:`clubface.shots.tables.chunk.Chunk`."""

    def __init__(
        self,
        rows: list[list[str]],
        lines: list[int],
        written: list[str],
        ragged: list[Reject],
        decimal_comma: bool,
    ) -> None:
        self._rows = rows
        self._written = written
        self.lines: Sequence[int] = lines
        self.ragged = ragged
        self._decimal_comma = decimal_comma

    def numbers(self, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
        """Return the numbers of a column in its unit, and for rows without one, why."""
        cells = [row[column.place] for row in self._rows]
        return parsed(cells, column, self._decimal_comma)

    def cells(self, place: int) -> list[str]:
        """Return the cells of a column."""
        return [row[place] for row in self._rows]

    def texts(self, rows: Sequence[int] | None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        return self._rows if rows is None else [self._rows[row] for row in rows]

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they stand in the file, untouched."""
        texts = self._written if rows is None else [self._written[row] for row in rows]
        return [text.rstrip("\r\n") for text in texts]

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows as an Arrow array of text."""
        import pyarrow

        return pyarrow.array([row[place] for row in self.texts(rows)], pyarrow.string())


def _ragged(cells: list[str], line: int, width: int) -> Reject:
    return Reject(line, ragged_reason(cells, width), (cells + [""] * width)[:width])


def open_table(path: Path) -> Reader:
    """Open a file of deliveries, Parquet by its ending, else CSV."""
    if path.suffix.lower() in ENDINGS:
        return ParquetReader(path)
    return CsvReader(path)


class MemoryReader:
    """Columns by their headings, texts or numbers, and where each row stands.

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
    """Some rows of a table in memory. See :class:`clubface.shots.tables.chunk.Chunk`."""

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
