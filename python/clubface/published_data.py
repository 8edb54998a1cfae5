"""Published figures to hold a model against: tables in SI, each with where it was printed and what is in doubt.

The files are ``clubface/data/measurements/*.toml``, one for each subject, with long tables as CSV files beside them. A
column is headed by its name and unit, as in ``spin [rpm]``; a column without a unit holds words.

``names()`` lists the tables, and ``table("pga-2019")["ball_speed"]`` is a column in m/s.

The files of published tables, read strictly: nothing unknown, nothing missing, no row that is not complete.

A published table in SI, and where it was printed.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.support.checks import Frozen, check_choice
from clubface.support.files import DATA, builtin_names
from clubface.support.strict_toml import Document


@dataclass(frozen=True, kw_only=True, eq=False)
class PublishedTable:
    """A published table, or a single figure as a table of one row.

    Attributes
    ----------
    name, title
        What it is called here, and what it is.
    kind
        One of ``KINDS``: whether the figures were measured or computed, or are a limit.
    source
        Author, year, title, publication and place in it.
    via
        What the figures were read in; None where it was the source itself.
    conditions
        How the figures came about, and how they are to be read.
    caveat
        What is in doubt; None if nothing is known to be.
    columns
        Each column by its name: an array in SI units and radians, NaN where nothing was printed, or one of words.
    units
        The unit each column of numbers was printed in (``"1"`` for a plain number); columns of words have none.
    derived
        Columns among the measured ones that their source computed from others, and how that is known: a dynamic loft
        that a monitor computes from the ball holds the monitor's model of impact. No model is judged by spin with it.
    """

    name: str
    title: str
    kind: str
    source: str
    via: str | None = None
    conditions: str
    caveat: str | None = None
    columns: dict[str, NDArray[Any]]
    units: dict[str, str]
    derived: Mapping[str, str] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def __getitem__(self, column: str) -> NDArray[Any]:
        check_choice("column", column, self.columns)
        return self.columns[column]

    def get(self, column: str, unit: str) -> NDArray[np.float64]:
        """Return a column of numbers in another unit, as in ``get("spin", "rpm")``."""
        values = self[column]
        if column not in self.units:
            raise InputError("column", column, f"one of numbers: {', '.join(self.units)}")
        units.unit(unit, name=column, dimension=units.unit(self.units[column]).dimension)
        return units.from_si(values, unit)


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


_FOLDER = "measurements"


@cache
def subjects() -> Mapping[str, Mapping[str, PublishedTable]]:
    """Return the tables of every subject by name."""
    return Frozen({name: Frozen(read(DATA / _FOLDER / f"{name}.toml")) for name in builtin_names(_FOLDER)})


def names() -> tuple[str, ...]:
    """List the names of all tables, subject by subject."""
    return tuple(name for tables in subjects().values() for name in tables)


def table(name: str) -> PublishedTable:
    """Return the table called ``name``, as in ``names()``."""
    for tables in subjects().values():
        if name in tables:
            return tables[name]
    raise UnknownNameError("published table", name, names())
