"""Launches to CSV and Parquet files: written beside the final name, which they take when they are complete."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol

from clubface.errors import FileError
from clubface.tables.reader import PARQUET, Piece, Reader, Reject

DIGITS = 9
"""Significant digits in a CSV file, far below the error of any model."""


class Writer(Protocol):
    """A file of launches that is being written."""

    def write(self, piece: Piece, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a piece (None: all), each followed by its results."""
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

    def write(self, piece: Piece, rows: Sequence[int] | None, results: Sequence[Any]) -> None:
        """Write some rows of a piece (None: all), each followed by its results."""
        form = self._delimiter.join([f"%.{DIGITS}g"] * len(results)) + "\n"
        found = [form % row for row in zip(*(each.tolist() for each in results), strict=True)]
        if self._comma:
            found = [text.replace(".", ",") for text in found]
        rows_written = piece.written(rows, self._delimiter)
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


class Journal:
    """How far an unfinished file has come, kept beside it, so that a later run goes on from there."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def write(self, state: dict[str, Any]) -> None:
        """Record ``state``, whole or not at all."""
        fresh = self.path.with_name(self.path.name + ".new")
        fresh.write_text(json.dumps(state))
        os.replace(fresh, self.path)

    def read(self, settings: str) -> dict[str, Any] | None:
        """Return what was recorded, None where nothing was; refuse that of a run with other ``settings``."""
        try:
            state = json.loads(self.path.read_text())
            begun, counts = state["settings"], {name: int(state[name]) for name in STATE}
        except FileNotFoundError:
            return None
        except (OSError, ValueError, KeyError, TypeError):
            raise FileError(str(self.path), None, "this file cannot be read; start again without resuming") from None
        if begun != settings:
            message = "this file was begun from another file or with other settings; start again without resuming"
            raise FileError(str(self.path), None, message)
        return counts

    def remove(self) -> None:
        """Remove it: the work is done."""
        self.path.unlink(missing_ok=True)


STATE = ("rows", "written", "rejected", "output_bytes", "rejects_bytes")
"""What a journal counts: rows read, written and rejected, and the length of both files."""


def is_parquet(path: Path) -> bool:
    """Tell from the ending whether to write Parquet or CSV; another ending is an error."""
    if path.suffix.lower() in PARQUET:
        return True
    if path.suffix.lower() in (".csv", ".txt", ".tsv"):
        return False
    raise FileError(str(path), None, "the name must end in .csv or .parquet")


def unfinished(path: Path) -> Path:
    """Return the name a file has until it is complete."""
    return path.with_name(f"{path.stem}.part{path.suffix}")


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
