"""CSV files a piece at a time: every row with the line it begins at, whatever is in its cells."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clubface.errors import FileError
from clubface.table_columns import Column
from clubface.table_reader import Reject, parsed

if TYPE_CHECKING:
    from numpy.typing import NDArray

LONGEST_LINE = 2_000_000
"""Bytes; a longer line is no row of a table."""
LARGEST_PIECE = 64_000_000
"""Characters of text after which a piece ends early, so that long rows do not fill the memory."""

Row = tuple[list[str], int, str]
"""The cells of a row, the line it begins at, and its text."""


class CsvReader:
    """A CSV file: UTF-8, with commas, semicolons or tabs between cells. See :class:`clubface.table_reader.Reader`."""

    counts = "line"

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self.blank = 0
        self._line = 0
        try:
            self._size = path.stat().st_size
            self._file = path.open("rb")
        except (OSError, ValueError) as error:
            raise FileError(self.path, None, f"cannot be read: {getattr(error, 'strerror', None) or error}") from None
        try:
            if not self._file.seekable():
                raise FileError(self.path, None, "a pipe cannot be read twice: save it as a file first")
            self._read_header()
        except BaseException:
            self._file.close()
            raise

    def _read_header(self) -> None:
        start = self._file.read(4)
        if start.startswith((b"\xff\xfe", b"\xfe\xff")):
            raise FileError(self.path, 1, "not UTF-8 text but UTF-16: save it as CSV UTF-8")
        if start.startswith(b"PAR1"):
            raise FileError(self.path, None, "a Parquet file: its name must end in .parquet")
        self._file.seek(3 if start.startswith(b"\xef\xbb\xbf") else 0)
        first = self._file.tell()
        head = self._file.readline(LONGEST_LINE)
        while head and not head.strip():
            first = self._file.tell()
            self._line += 1
            head = self._file.readline(LONGEST_LINE)
        self._file.seek(first)
        self.delimiter = _delimiter(head.decode(errors="replace"))
        self._raw: list[str] = []
        self._reader = csv.reader(self._decoded(self._line), delimiter=self.delimiter, strict=True)
        self._before = self._line
        row = self._next()
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
        """Look at the first rows: with another delimiter, "50,5" is a number with a decimal comma."""
        if self.delimiter == ",":
            return
        while len(self._seen) < 100 and (row := self._next()) is not None:
            self._seen.append(row)
        cells = [cell for row in self._seen if not isinstance(row, Reject) for cell in row[0]]
        commas = sum(_is_number(cell.replace(",", ".")) for cell in cells if cell.count(",") == 1 and "." not in cell)
        points = sum(_is_number(cell) for cell in cells if "." in cell)
        self.decimal_comma = commas > points

    def pieces(self, rows: int, skip: int) -> Iterator[CsvPiece]:
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
                row = self._seen.pop(0) if self._seen else self._next()
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
                if size > LARGEST_PIECE:
                    break
            count = len(kept) + len(ragged)
            if passed >= skip and count:
                yield CsvPiece(kept, lines, written, ragged, self.decimal_comma)
            passed += count

    def progress(self) -> float:
        """Return which part of the file has been read, 0 to 1."""
        return min(1.0, self._file.tell() / self._size) if self._size else 1.0

    def schema(self, place: int) -> None:
        """Return None: every column is text."""
        return

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _decoded(self, line: int) -> Iterator[str]:
        """Yield the lines as text; what is not UTF-8 is an error with its line."""
        for raw in iter(partial(self._file.readline, LONGEST_LINE), b""):
            line += 1
            if len(raw) >= LONGEST_LINE:
                raise FileError(self.path, line, f"longer than {LONGEST_LINE // 1_000_000} MB: this is no table")
            try:
                text = raw.decode()
            except UnicodeDecodeError:
                raise FileError(self.path, line, "not UTF-8 text: save it as CSV UTF-8") from None
            self._raw.append(text)
            yield text

    def _next(self) -> Row | Reject | None:
        """Return the next row that is not blank and the line it begins at; one that is no CSV, all its text."""
        while True:
            begins = self._before + self._reader.line_num + 1
            self._raw.clear()
            try:
                cells = next(self._reader)
            except StopIteration:
                return None
            except csv.Error as error:
                if "new-line character" in str(error):
                    message = "lines end with a carriage return alone: save it with usual line ends"
                    raise FileError(self.path, begins, message) from None
                return Reject(begins, _explained(str(error)), ["".join(self._raw)])
            if cells:
                return cells, begins, "".join(self._raw)
            self.blank += 1


class CsvPiece:
    """Some rows of a CSV file. See :class:`clubface.table_reader.Piece`."""

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
    reason = f"{len(cells)} cell{'s' * (len(cells) != 1)} where there are {width} columns"
    if len(cells) > width:
        reason += "; beyond them: " + ", ".join(map(repr, cells[width:]))
    return Reject(line, reason, (cells + [""] * width)[:width])


def _delimiter(head: str) -> str:
    """Return the delimiter that is most frequent in the first line, outside quotes."""
    plain = "".join(head.split('"')[::2])
    return max(",;\t", key=plain.count)


def _is_number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def _explained(message: str) -> str:
    if "unexpected end of data" in message:
        return "a quoted cell that begins here does not end"
    return f"this is not CSV: {message}"
