"""Published data for testing models: tables in SI, each with its source and doubts.

The files are ``clubface/data/measurements/*.toml``, one per subject, with long tables as CSV files next to them. A
heading gives name and unit of a column, as in ``spin [rpm]``; a column without a unit holds words. Unknown or missing
keys and incomplete rows are errors.

``names()`` lists the tables, and ``table("pga-2019")["ball_speed"]`` is a column in m/s.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.schema.document import Document, Place
from clubface.schema.tables import Table, decode, file_key
from clubface.schema.values import TEXT, Choice, FilePath, Items, Record, Simple, Tables
from clubface.support.checks import Frozen, check_choice, check_names
from clubface.support.files import DATA, builtin_names

__all__ = ["PublishedTable", "names", "read", "subjects", "table"]


@dataclass(frozen=True, kw_only=True, eq=False)
class PublishedTable:
    """A published table, or a single value as a table of one row.

    Attributes
    ----------
    name, title
        Name in the package, and title.
    kind
        One of ``KINDS``: whether the values were measured or computed, or are a limit.
    source
        Author, year, title, publication, and position in it.
    via
        Where the values were read, if not in the source itself; else None.
    conditions
        How the values were obtained, and how to read them.
    caveat
        Known doubts, or None.
    columns
        Columns by name: an array in SI units and radians, NaN where nothing was printed, or an array of words.
    units
        Printed unit of each column of numbers (``"1"`` for a plain number); columns of words have none.
    derived
        Columns that the source computed from others, with the evidence: a dynamic loft computed by a monitor from the
        ball contains the monitor's impact model, so that the spin with it does not test a model.
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
"""Kinds of tables, with their meaning."""

WORDS = Simple("text in quotes, not empty", lambda given: isinstance(given, str) and given.strip() != "")


@dataclass(frozen=True, kw_only=True)
class TableEntry:
    """A published table."""

    name: str = file_key(WORDS, "what it is called here")
    title: str = file_key(WORDS, "what it is")
    kind: str = file_key(Choice(tuple(KINDS)), "what the figures are")
    source: str = file_key(WORDS, "author, year, title, publication and place in it")
    via: str | None = file_key(WORDS, "where the figures were read, if not in the source", default=None)
    conditions: str = file_key(WORDS, "how the figures were obtained, and how to read them")
    caveat: str | None = file_key(WORDS, "what is in doubt", default=None)
    derived: Mapping[str, str] = file_key(
        Record(WORDS), "columns that the source computed from others, with the reason", default_factory=dict
    )
    file: Path | None = file_key(FilePath("text in quotes"), "a CSV file, instead of columns and rows", default=None)
    columns: tuple[str, ...] | None = file_key(Items(TEXT), "names of columns, with units in brackets", default=None)
    rows: tuple[tuple[Any, ...], ...] | None = file_key(Items(Items(Simple())), "the rows", default=None)

    def __post_init__(self) -> None:
        for key, value in {"columns": self.columns, "rows": self.rows}.items():
            if (value is None) == (self.file is None):
                raise InputError(
                    key, value, "give it, or a file" if value is None else "leave it out where a file is given"
                )

    def table(self, path: str, line: int | None) -> PublishedTable:
        """Return the table of the file at ``path``, whose entry begins in ``line``."""
        if self.file is not None:
            path, line = str(self.file), None
        try:
            heads, rows = (self.columns, self.rows) if self.file is None else _csv(self.file)
            columns, printed = _columns(heads or (), rows or ())
        except (OSError, ValueError, csv.Error) as error:
            raise FileError(path, line, f"table {self.name}: {error}") from None
        check_names("derived column", self.derived, columns)
        return PublishedTable(
            name=self.name, title=self.title, kind=self.kind, source=self.source, via=self.via,
            conditions=self.conditions, caveat=self.caveat, columns=columns, units=printed,
            derived=Frozen(self.derived),
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class PublishedFile:
    """A file of published tables."""

    table: tuple[TableEntry, ...] = file_key(Tables(Table(TableEntry), least=1), "the tables")


def read(path: Path) -> dict[str, PublishedTable]:
    """Read a file of published tables; raise :class:`FileError` for missing, unknown or incomplete entries."""
    document = Document.read(path)
    tables = {}
    for index, entry in enumerate(decode(PublishedFile, document).table):
        with (at := Place(document).key("table").item(index)).errors():
            tables[entry.name] = entry.table(document.path, document.line_of((*at.path, "rows")))
    return tables


def _csv(path: Path) -> tuple[list[str], list[list[str]]]:
    with path.open(newline="", encoding="utf-8") as file:
        heads, *rows = csv.reader(file, strict=True)
    return heads, rows


def _columns(heads: Sequence[str], rows: Sequence[Sequence[Any]]) -> tuple[dict[str, NDArray[Any]], dict[str, str]]:
    """Return the columns in SI by name, and their printed units; raise ValueError if something is missing."""
    if not rows:
        raise InputError("rows", rows, "at least one row")
    for number, row in enumerate(rows, 1):
        if len(row) != len(heads):
            raise InputError(f"row {number}", list(row), f"{len(heads)} cells: {', '.join(heads)}")
    columns: dict[str, NDArray[Any]] = {}
    printed: dict[str, str] = {}
    for head, cells in zip(heads, zip(*rows, strict=True), strict=True):
        name, symbol = units.parse_column_name(head) if "[" in head else (head, None)
        if name in columns or name != name.lower() or not name.isidentifier():
            raise InputError("column", head, "a lower-case name with its unit in brackets, used once in a table")
        if symbol is None:
            columns[name] = np.array([_word(cell, f"{name} in row {number}") for number, cell in enumerate(cells, 1)])
        else:
            values = [_number(cell, f"{name} in row {number}", symbol) for number, cell in enumerate(cells, 1)]
            columns[name] = units.to_si(np.array(values), symbol)
            printed[name] = symbol
        columns[name].setflags(write=False)  # tables are read once and shared
    return columns, printed


def _word(cell: object, where: str) -> str:
    if not isinstance(cell, str) or not cell.strip():
        raise InputError(where, cell, "words, or its heading must name a unit")
    return cell


def _number(cell: Any, where: str, symbol: str) -> float:
    """Return a number in SI, or NaN for an empty cell of a CSV file, which means not printed."""
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
