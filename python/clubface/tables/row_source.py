"""Opening the rows of a table, CSV or Excel, by what the file is and not by its name."""

from __future__ import annotations

from pathlib import Path

from clubface.tables.csv_rows import CsvRows
from clubface.tables.file_kind import is_workbook
from clubface.tables.workbook import WorkbookRows

RowSource = CsvRows | WorkbookRows
"""The rows of a file, one after the other."""


def open_rows(path: Path, *, head_lines: int = 1, delimiter: str | None = None) -> RowSource:
    """Open the rows of a file; the options are those of :class:`CsvRows` and hold for text."""
    return WorkbookRows(path) if is_workbook(path) else CsvRows(path, head_lines=head_lines, delimiter=delimiter)
