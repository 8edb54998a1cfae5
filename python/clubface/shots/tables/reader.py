"""CSV files, workbooks and Parquet files, read a chunk at a time: every row with the line at which it begins."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from clubface.errors import FileError
from clubface.results.notes import Note
from clubface.shots.tables.cells import decimals_of, doubt, ragged_reason
from clubface.shots.tables.chunk import Chunk, Reject
from clubface.shots.tables.headings import shot_words
from clubface.shots.tables.parquet import ENDINGS, ParquetReader
from clubface.shots.tables.row_source import DECIMAL_ROWS, open_rows

LARGEST_CHUNK = 64_000_000
"""Characters of text after which a chunk ends early, so that long rows do not fill the memory."""


class CsvReader:
    """A CSV file, with commas, semicolons, tabs or bars between cells, or a workbook; its rows go by their lines."""

    counts = "line"

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self._rows = open_rows(path)
        self.delimiter = self._rows.delimiter
        try:
            row = self._rows.next()
            if row is None:
                raise FileError(self.path, 1, "the file is empty: its first row must name the columns")
            if isinstance(row, Reject):
                raise FileError(self.path, row.line, row.reason)
            self.headings = row[0]
            self.header_line: int | None = row[1]
            self._seen = [*islice(iter(self._rows.next, None), DECIMAL_ROWS)]
            quantities = [*map(shot_words().quantity, self.headings)]
            rows = (row[0] for row in self._seen if not isinstance(row, Reject))
            cells = (each for row in rows for each in zip(row, quantities, strict=False))
            self.decimal_comma, self._doubtful = decimals_of(cells, self.delimiter)
        except BaseException:
            self._rows.close()
            raise

    @property
    def blank(self) -> int:
        """Blank lines passed over so far."""
        return self._rows.blank

    @property
    def notes(self) -> tuple[Note, ...]:
        """Remarks on the file, as far as it is read."""
        return (*self._rows.notes, *([doubt(self._doubtful)] if self._doubtful else []))

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
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
                    ragged.append(Reject(line, ragged_reason(cells, width), [*cells, *[""] * width][:width]))
                if size > LARGEST_CHUNK:
                    break
            count = len(kept) + len(ragged)
            if passed >= skip and count:
                columns = list(zip(*kept, strict=True)) or [()] * width
                yield Chunk(lines, columns, ragged, self.decimal_comma, written)
            passed += count

    def progress(self) -> float:
        """Return the share of the file that has been read, 0 to 1."""
        return self._rows.progress()

    @property
    def types(self) -> list[None]:
        """The Arrow types of the columns; None for text."""
        return [None] * len(self.headings)

    def close(self) -> None:
        """Close the file."""
        self._rows.close()


Reader = CsvReader | ParquetReader
"""A file that is read a chunk at a time."""


def open_table(path: Path) -> Reader:
    """Open a table, Parquet by its ending, else CSV or a workbook."""
    if path.suffix.lower() in ENDINGS:
        return ParquetReader(path)
    return CsvReader(path)
