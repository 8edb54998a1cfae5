"""The files of published tables, read strictly: nothing unknown, nothing missing, no row that is not complete."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.measurements.published import PublishedTable
from clubface.support.frozen import Frozen
from clubface.support.strict_toml import Document

KINDS = {
    "measured": "measured",
    "computed": "computed by its source, not measured",
    "limit": "a limit of rules or claims",
}
"""What the figures of a table can be."""

_WORDS = ("name", "title", "kind", "source", "conditions")
_OPTIONAL = ("via", "caveat")
_DERIVED = "derived"


def read(path: Path) -> dict[str, PublishedTable]:
    """Read a file of published tables; whatever is missing, unknown or incomplete is a :class:`FileError`."""
    file = Document.read(path)
    file.check_keys(file.data, ("table",), ("table",))
    tables: dict[str, PublishedTable] = {}
    for index, entry in enumerate(file.data["table"]):
        found = _table(file, index, entry)
        if found.name in tables:
            raise file.error(f"a second table {found.name!r}", "name", "table", index)
        tables[found.name] = found
    return tables


def _table(file: Document, index: int, entry: dict[str, Any]) -> PublishedTable:
    inside = ("file",) if "file" in entry else ("columns", "rows")
    file.check_keys(entry, (*_WORDS, *_OPTIONAL, _DERIVED, *inside), (*_WORDS, *inside), "table", index)
    words = {key: entry[key] for key in (*_WORDS, *_OPTIONAL) if key in entry}
    file.check_text(entry, (*words, "file"), "table", index)
    for key, text in words.items():
        if not text.strip():
            raise file.error(f"{key} is empty", key, "table", index)
    if entry["kind"] not in KINDS:
        raise file.error(str(UnknownNameError("kind", entry["kind"], KINDS)), "kind", "table", index)
    path, line = Path(file.path), file.line("rows", "table", index)
    if "file" in entry:
        path, line = path.with_name(entry["file"]), None
    try:
        heads, rows = _csv(path) if "file" in entry else (entry["columns"], entry["rows"])
        columns, printed = _columns(heads, rows)
    except (OSError, ValueError, csv.Error) as error:
        raise FileError(str(path), line, f"table {entry['name']}: {error}") from None
    derived = entry.get(_DERIVED, {})
    for column, reason in derived.items() if isinstance(derived, dict) else [("", "")]:
        if column not in columns or not isinstance(reason, str) or not reason.strip():
            known = ", ".join(columns)
            raise file.error(
                f"{_DERIVED} = {derived!r}: give columns ({known}) with the reason", _DERIVED, "table", index
            )
    return PublishedTable(**words, columns=columns, units=printed, derived=Frozen(derived))


def _csv(path: Path) -> tuple[list[str], list[list[str]]]:
    with path.open(newline="", encoding="utf-8") as file:
        heads, *rows = csv.reader(file, strict=True)
    return heads, rows


def _columns(heads: list[str], rows: list[list[Any]]) -> tuple[dict[str, NDArray[Any]], dict[str, str]]:
    """Return the columns in SI by name and the unit each was printed in; what is not complete is a ValueError."""
    if not rows:
        raise InputError("rows", rows, "at least one row")
    for number, row in enumerate(rows, 1):
        if len(row) != len(heads):
            raise InputError(f"row {number}", row, f"{len(heads)} cells: {', '.join(heads)}")
    columns: dict[str, NDArray[Any]] = {}
    printed: dict[str, str] = {}
    for head, cells in zip(heads, zip(*rows, strict=True), strict=True):
        name, symbol = units.parse_column_name(head) if "[" in head else (head, None)
        if name in columns or name != name.lower() or not name.isidentifier():
            raise InputError("column", head, "a name in small letters with its unit in brackets, once in a table")
        if symbol is None:
            columns[name] = np.array([_word(cell, f"{name} in row {number}") for number, cell in enumerate(cells, 1)])
        else:
            values = [_number(cell, f"{name} in row {number}", symbol) for number, cell in enumerate(cells, 1)]
            unit = units.unit(symbol)
            columns[name] = np.array(values) * unit.numerator / unit.denominator + unit.offset
            printed[name] = symbol
        columns[name].setflags(write=False)  # tables are read once and shared
    return columns, printed


def _word(cell: object, where: str) -> str:
    if not isinstance(cell, str) or not cell.strip():
        raise InputError(where, cell, "words, or its heading must name a unit")
    return cell


def _number(cell: Any, where: str, symbol: str) -> float:
    """Return a number; an empty cell of a CSV file is one that was not printed."""
    try:
        value = math.nan if cell == "" else float(cell)
    except (TypeError, ValueError):
        value = math.inf
    if math.isinf(value):
        raise InputError(where, cell, f"a number in {symbol}")
    return value
