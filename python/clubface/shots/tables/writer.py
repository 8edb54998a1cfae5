"""Writing launches and other tables to CSV and Parquet files."""

from __future__ import annotations

import csv
import io
import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, BinaryIO

from clubface.errors import LINES, FileError, legible
from clubface.shots.tables.cells import PARTS_MISSING, Chunk, cell_text
from clubface.shots.tables.parquet import ENDINGS as PARQUET, pyarrow_for
from clubface.support.files import whole_file

KINDS = (".csv", ".tsv", *PARQUET)
"""Endings of table file names."""
DIGITS = 9
"""Significant digits in a CSV file, far below the error of any model."""


class CsvForm:
    """Launches written as CSV in pieces, with cells and decimals as in the source file."""

    def __init__(self, headings: Sequence[str], delimiter: str, decimal_comma: bool) -> None:
        self._headings = headings
        self._comma = decimal_comma
        self._delimiter = delimiter

    def piece(self, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> bytes:
        """Return some rows of a chunk (None: all), each followed by its results."""
        cell = f'"%.{DIGITS}g"' if self._comma and self._delimiter == "," else f"%.{DIGITS}g"
        form = self._delimiter.join([cell] * len(results)) + "\n"
        results_written = [form % row for row in zip(*(each.tolist() for each in results), strict=True)]
        if self._comma:
            results_written = [text.replace(".", ",") for text in results_written]
        rows_written = chunk.written(rows, self._delimiter)
        lines = (f"{text}{self._delimiter}{more}" for text, more in zip(rows_written, results_written, strict=True))
        return legible("".join(lines), LINES).encode()

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the headings and all pieces."""
        join_csv(file, self._headings, self._delimiter, pieces)


def join_csv(file: BinaryIO, headings: Sequence[str], delimiter: str, pieces: Iterable[Path]) -> None:
    """Write headings, then the contents of some files one after another."""
    file.write(csv_lines([headings], delimiter))
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


def is_parquet(path: Path) -> bool:
    """Return whether a file name ends as Parquet, or False for CSV; raise an error for another ending."""
    if path.suffix.lower() not in KINDS:
        raise FileError(str(path), None, f"the name must end in {' or '.join(KINDS)}")
    return path.suffix.lower() in PARQUET


@contextmanager
def columns_file(path: Path, *, exact: bool = False) -> Iterator[Callable[[Mapping[str, Any]], None]]:
    """Open a CSV or Parquet file for columns by heading, written a piece at a time.

    The file appears under its name, complete, only when the block ends without an error. NaN becomes an empty cell, or
    null in Parquet. Numbers in CSV have ``DIGITS`` significant digits, or all of them if ``exact``.
    """
    arrow = pyarrow_for(path) if is_parquet(path) else None
    delimiter = delimiter_of(path)
    writer: Any = None

    def cells(values: Any) -> list[str]:
        listed = values if isinstance(values, list) else values.tolist()
        if exact:
            return [cell_text(each) for each in listed]
        return [each if isinstance(each, str) else "" if each != each else f"{each:.{DIGITS}g}" for each in listed]

    with whole_file(path) as file, ExitStack() as stack:

        def write(columns: Mapping[str, Any]) -> None:
            nonlocal writer
            if arrow is None:
                headings = [list(columns)] if writer is None else []
                writer = file
                file.write(csv_lines([*headings, *zip(*map(cells, columns.values()), strict=True)], delimiter))
                return
            table = arrow.table({name: arrow.array(each, from_pandas=True) for name, each in columns.items()})
            if writer is None:
                writer = stack.enter_context(arrow.parquet.ParquetWriter(file, table.schema))
            writer.write_table(table)

        yield write
