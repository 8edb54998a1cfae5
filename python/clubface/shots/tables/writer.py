"""Writing launches and other tables to CSV and Parquet files."""

from __future__ import annotations

import csv
import io
import shutil
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Protocol

from clubface.errors import LINES, FileError, legible
from clubface.shots.tables.cells import PARTS_MISSING, Chunk, Reject, cell_text
from clubface.shots.tables.parquet import ENDINGS as PARQUET, write_parquet
from clubface.support.files import whole_file

if TYPE_CHECKING:
    from numpy.typing import NDArray

KINDS = (".csv", ".tsv", *PARQUET)
"""Endings of table file names."""
DIGITS = 9
"""Significant digits in a CSV file, far below the error of any model."""


class OutputFormat(Protocol):
    """A format for launches: chunks are written to separate files, which are joined at the end."""

    def piece(self, file: BinaryIO, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a chunk (None: all), each followed by its results."""
        ...

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the file of all pieces."""
        ...


class CsvForm:
    """Launches written as CSV, with cells and decimals as in the source file. See :class:`OutputFormat`."""

    def __init__(self, headings: Sequence[str], delimiter: str, decimal_comma: bool) -> None:
        self._headings = headings
        self._comma = decimal_comma
        self._delimiter = delimiter

    def piece(self, file: BinaryIO, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a chunk (None: all), each followed by its results."""
        cell = f'"%.{DIGITS}g"' if self._comma and self._delimiter == "," else f"%.{DIGITS}g"
        form = self._delimiter.join([cell] * len(results)) + "\n"
        results_written = [form % row for row in zip(*(each.tolist() for each in results), strict=True)]
        if self._comma:
            results_written = [text.replace(".", ",") for text in results_written]
        rows_written = chunk.written(rows, self._delimiter)
        lines = (f"{text}{self._delimiter}{more}" for text, more in zip(rows_written, results_written, strict=True))
        file.write(legible("".join(lines), LINES).encode())

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the headings and all pieces."""
        file.write(csv_lines([self._headings], self._delimiter))
        put_together(file, pieces)


class RejectsForm:
    """Rejected rows, each with its line and reason."""

    def __init__(self, headings: Sequence[str], delimiter: str, counts: str) -> None:
        self._headings = [counts, "reason", *headings]
        self._delimiter = delimiter

    def piece(self, file: BinaryIO, rejects: Iterable[Reject]) -> None:
        """Write rows with line and reason."""
        file.write(csv_lines([[each.line, each.reason, *each.cells] for each in rejects], self._delimiter))

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the headings and all pieces."""
        file.write(csv_lines([self._headings], self._delimiter))
        put_together(file, pieces)


def put_together(file: BinaryIO, pieces: Iterable[Path]) -> None:
    """Write the contents of some files one after another."""
    for path in pieces:
        try:
            piece = path.open("rb")
        except OSError:
            raise FileError(str(path), None, PARTS_MISSING) from None
        with piece:
            shutil.copyfileobj(piece, file)


def csv_lines(rows: Iterable[Sequence[Any]], delimiter: str) -> bytes:
    """Return rows of cells as lines of a CSV file."""
    text = io.StringIO()
    csv.writer(text, delimiter=delimiter, lineterminator="\n").writerows(rows)
    return legible(text.getvalue(), LINES).encode()


def delimiter_of(path: Path) -> str:
    """Return the delimiter of a text file: a tab for .tsv, else a comma."""
    return "\t" if path.suffix.lower() == ".tsv" else ","


def number_cells(values: NDArray[Any]) -> list[str]:
    """Return numbers as cells with ``DIGITS`` significant digits; NaN gives an empty cell."""
    return ["" if value != value else f"{value:.{DIGITS}g}" for value in values.tolist()]


def is_parquet(path: Path) -> bool:
    """Return whether a file name ends as Parquet, or False for CSV; raise an error for another ending."""
    if path.suffix.lower() not in KINDS:
        raise FileError(str(path), None, f"the name must end in {' or '.join(KINDS)}")
    return path.suffix.lower() in PARQUET


def write_columns(columns: Mapping[str, Any], path: Path) -> None:
    """Write a table to a CSV or Parquet file, by its ending; the file appears only when it is complete.

    NaN becomes an empty cell.
    """
    parquet = is_parquet(path)
    with whole_file(path) as file:
        if parquet:
            write_parquet(columns, file, path)
        else:
            rows = zip(*(map(cell_text, each) for each in columns.values()), strict=True)
            file.write(csv_lines([list(columns), *rows], delimiter_of(path)))
