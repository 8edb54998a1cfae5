"""The rows of an Excel workbook (.xlsx), read as those of a CSV file are; the only module that needs openpyxl."""

from __future__ import annotations

import datetime
import warnings
import zipfile
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from clubface.errors import FileError, shortened
from clubface.support.input_files import open_input
from clubface.tables.csv_rows import MOST_CELLS, Row
from clubface.tables.rows import Reject
from clubface.tables.writer import csv_lines

LARGEST, LARGEST_PART = 1_000_000_000, 100_000_000
"""Bytes of a workbook once it is unpacked, and of each part but the sheets, which are read a row at a time."""
SEARCHED = 200
"""First rows of a sheet among which its table begins."""


class WorkbookRows:
    """The rows of the first sheet with a table, numbers as text with a decimal point. See :class:`CsvRows`.

    Attributes
    ----------
    encoding
        None, as for UTF-8.
    notes
        Which sheet is read where others hold tables too.
    """

    delimiter = ","
    encoding: str | None = None

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self.blank = 0
        try:
            from openpyxl import load_workbook
        except ImportError:
            message = 'an Excel workbook needs openpyxl, pip install "clubface[excel]"; or save the sheet as CSV'
            raise FileError(self.path, None, message) from None
        self._file = open_input(path)
        try:
            with zipfile.ZipFile(self._file) as archive:
                sizes = {each.filename: each.file_size for each in archive.infolist()}
            parts = [size for name, size in sizes.items() if not name.startswith("xl/worksheets/")]
            if sum(sizes.values()) > LARGEST or max(parts) > LARGEST_PART:
                message = f"this workbook has {sum(sizes.values()) // 1_000_000} MB unpacked; save the sheet as CSV"
                raise FileError(self.path, None, message)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of styles and extensions that openpyxl passes over
                self._book: Any = load_workbook(self._file, read_only=True, data_only=True)
        except Exception as error:  # openpyxl raises what its XML and ZIP raise
            self._file.close()
            raise self._damaged(error) from None
        try:
            sheets = [each for each in self._book.worksheets if self._has_table(each)]
            if not sheets:
                raise FileError(self.path, None, "no sheet of this workbook holds a table: names above numbers")
            self._rows = self._cells(sheets[0])
            self._count = max(sheets[0].max_row or 1, 1)
        except BaseException:
            self.close()
            raise
        others = ", ".join(repr(shortened(each.title, 40)) for each in sheets[1:])
        read = f"the sheet {shortened(sheets[0].title, 40)!r} was read and {others} not: save each as a file of its own"
        self.notes: tuple[str, ...] = (read,) if others else ()
        self._line = 0

    def next(self) -> Row | Reject | None:
        """Return the next row that is not blank, its number, and its cells as a line of CSV."""
        for cells in self._rows:
            self._line += 1
            if any(cells):
                return cells, self._line, csv_lines([cells], self.delimiter).decode()
            self.blank += 1
        return None

    def progress(self) -> float:
        """Return which part of the sheet has been read, 0 to 1."""
        return min(1.0, self._line / self._count)

    def close(self) -> None:
        """Close the workbook."""
        self._book.close()
        self._file.close()

    def _has_table(self, sheet: Any) -> bool:
        """Tell whether a sheet begins with a row of two names or more and a number below it."""
        named = False
        for cells in islice(self._cells(sheet), SEARCHED):
            words = sum(any(map(str.isalpha, each)) for each in cells)
            if named and any(map(str.isdigit, "".join(cells))):
                return True
            named |= words >= 2
        return False

    def _cells(self, sheet: Any) -> Iterator[list[str]]:
        """Yield the rows of a sheet, all as wide as its widest named row so far, without empty cells beyond it."""
        width = 0
        try:
            sheet.reset_dimensions()  # programs write wrong ones
            for row in sheet.iter_rows(values_only=True):
                cells = [_text(each) for each in row]
                while cells and not cells[-1]:
                    cells.pop()
                if len(cells) > MOST_CELLS:
                    message = f"a row has {len(cells)} cells; a table has at most {MOST_CELLS}"
                    raise FileError(self.path, None, message)
                width = max(width, len(cells))
                yield cells + [""] * (width - len(cells))
        except FileError:
            raise
        except Exception as error:  # as above: sheets are read as they are gone through
            raise self._damaged(error) from None

    def _damaged(self, error: Exception) -> FileError:
        if isinstance(error, FileError):
            return error
        reason = (str(error).splitlines() or [type(error).__name__])[0]
        return FileError(self.path, None, f"this Excel workbook cannot be read: {shortened(reason, 80)}")


def _text(value: object) -> str:
    """Return the value of a cell as a CSV file has it."""
    match value:
        case None:
            return ""
        case bool():
            return str(value).upper()
        case float():
            return f"{value:.15g}"  # 0.1 + 0.2 as Excel shows it
        case datetime.datetime():
            return str(value.replace(microsecond=0))
        case _:
            return str(value)
