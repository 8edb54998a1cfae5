"""Writes results to files with all digits: JSON, and tables as CSV or Parquet."""

from __future__ import annotations

import csv
import io
import json
import os
from pathlib import Path
from typing import Any

from clubface.errors import LINES, FileError, legible
from clubface.results.result import Result
from clubface.results.table import Table
from clubface.support.checks import plain
from clubface.support.files import whole_file, write_text

TABLES = (".csv", ".tsv", ".parquet", ".pq")
"""Endings of table files."""


def json_text(document: Any, *, indent: int | None = 2) -> str:
    """Return JSON text; NaN and infinities become null, and control characters are escaped."""
    text = json.dumps(plain(document), indent=indent, allow_nan=False, ensure_ascii=False)
    return "".join(each if each.isprintable() or each == "\n" else json.dumps(each)[1:-1] for each in text)


def csv_text(table: Table, delimiter: str = ",") -> str:
    """Return a table as CSV text; numbers keep all their digits."""
    kept = io.StringIO()
    csv.writer(kept, delimiter=delimiter, lineterminator="\n").writerows(table.csv_rows())
    return legible(kept.getvalue(), LINES)


def write_table(table: Table, path: str | os.PathLike[str]) -> Path:
    """Write a table to a CSV or Parquet file, by its ending."""
    target = Path(path)
    ending = target.suffix.lower()
    if ending not in TABLES:
        raise FileError(str(target), None, f"the name must end in {' or '.join(TABLES)}")
    if ending in (".csv", ".tsv"):
        return write_text(target, csv_text(table, "\t" if ending == ".tsv" else ","))
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise FileError(str(target), None, 'a Parquet file needs pyarrow: pip install "clubface[tables]"') from None
    columns = {each.key: [each.exact(row) for row in range(len(table))] for each in table.file_columns}
    with whole_file(target) as file:
        pyarrow.parquet.write_table(pyarrow.table(columns), file)
    return target


def write_json(result: Result, path: str | os.PathLike[str]) -> Path:
    """Write a result to a JSON file."""
    return write_text(path, json_text(result.to_dict()) + "\n")
