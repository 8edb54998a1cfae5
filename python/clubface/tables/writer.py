"""Launches to CSV and Parquet files: written beside the final name, which they take when they are complete."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from clubface.errors import FileError
from clubface.support.resuming import unfinished
from clubface.tables.parquet import ENDINGS as PARQUET, write_parquet
from clubface.tables.rows import Chunk, Reader, Reject

KINDS = (".csv", ".tsv", *PARQUET)
"""How the name of a table may end."""
DIGITS = 9
"""Significant digits in a CSV file, far below the error of any model."""


class Writer(Protocol):
    """A file of launches that is being written."""

    def write(self, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a chunk (None: all), each followed by its results."""
        ...

    def place(self) -> int:
        """Bring all to the disk and return the length of the file [bytes]."""
        ...

    def close(self) -> None:
        """End the file."""
        ...


class CsvWriter:
    """Launches written as CSV, cells and decimals as in the file they come from. See :class:`Writer`."""

    def __init__(self, path: Path, headings: Sequence[str], reader: Reader, keep: int | None) -> None:
        self._file = open_text(path, keep)
        self._comma = reader.decimal_comma
        self._delimiter = reader.delimiter
        if keep is None:
            csv.writer(self._file, delimiter=self._delimiter, lineterminator="\n").writerow(headings)

    def write(self, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a chunk (None: all), each followed by its results."""
        cell = f'"%.{DIGITS}g"' if self._comma and self._delimiter == "," else f"%.{DIGITS}g"
        form = self._delimiter.join([cell] * len(results)) + "\n"
        found = [form % row for row in zip(*(each.tolist() for each in results), strict=True)]
        if self._comma:
            found = [text.replace(".", ",") for text in found]
        rows_written = chunk.written(rows, self._delimiter)
        self._file.writelines(f"{text}{self._delimiter}{more}" for text, more in zip(rows_written, found, strict=True))

    def place(self) -> int:
        """Bring all to the disk and return the length of the file [bytes]."""
        return flushed(self._file)

    def close(self) -> None:
        """End the file."""
        self._file.close()


class RejectsWriter:
    """The rows that cannot be used, each with its line and the reason; the file is there once there is one."""

    def __init__(self, path: Path, reader: Reader, headings: Sequence[str], keep: int | None) -> None:
        self._path = path
        self._reader = reader
        self._headings = headings
        self._file: io.TextIOWrapper | None = None
        if keep:
            self._open(keep)
        else:
            path.unlink(missing_ok=True)

    def _open(self, keep: int | None) -> None:
        self._file = open_text(self._path, keep)
        self._rows = csv.writer(self._file, delimiter=self._reader.delimiter, lineterminator="\n")
        if not keep:
            self._rows.writerow([self._reader.counts, "reason", *self._headings])

    def write(self, rejects: Sequence[Reject]) -> None:
        """Write rows with line and reason."""
        if rejects and self._file is None:
            self._open(None)
        if rejects:
            self._rows.writerows([each.line, each.reason, *each.cells] for each in rejects)

    def place(self) -> int:
        """Bring all to the disk and return the length of the file [bytes]; 0 where there is none."""
        return flushed(self._file) if self._file is not None else 0

    def close(self) -> None:
        """End the file."""
        if self._file is not None:
            self._file.close()


def is_parquet(path: Path) -> bool:
    """Tell from the ending whether to write Parquet or CSV; another ending is an error."""
    if path.suffix.lower() not in KINDS:
        raise FileError(str(path), None, f"the name must end in {' or '.join(KINDS)}")
    return path.suffix.lower() in PARQUET


def open_text(path: Path, keep: int | None) -> io.TextIOWrapper:
    """Open a file for text, new, or to go on after its first ``keep`` bytes."""
    try:
        file = path.open("wb" if keep is None else "r+b")
        if keep is not None:
            file.truncate(keep)
            file.seek(keep)
    except OSError as error:
        raise FileError(str(path), None, f"cannot be written: {error.strerror}") from None
    return io.TextIOWrapper(file, encoding="utf-8", newline="")


def flushed(file: io.TextIOWrapper) -> int:
    """Bring text to the disk and return the length of the file [bytes]."""
    file.flush()
    return os.fstat(file.fileno()).st_size


def write_columns(columns: Mapping[str, Any], path: Path) -> None:
    """Write a whole table to a CSV or Parquet file, by its ending, which has its name only once it is complete.

    Numbers that are NaN become empty cells; there are no others.
    """
    parquet = is_parquet(path)
    part = unfinished(path)
    if parquet:
        write_parquet(columns, part)
    else:
        with open_text(part, None) as file:
            out = csv.writer(file, delimiter="\t" if path.suffix.lower() == ".tsv" else ",", lineterminator="\n")
            out.writerow(columns)
            out.writerows(zip(*(map(cell_text, each) for each in columns.values()), strict=True))
    os.replace(part, path)


def cell_text(value: Any) -> str:
    """Return a text or a number as a cell has it, NaN as an empty one."""
    if isinstance(value, str):
        return value
    return "" if math.isnan(value) else repr(float(value))
