"""Deliveries from CSV and Parquet files of any length, a piece at a time, every row with its line."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from clubface.equipment.described import HANDS
from clubface.tables.headings import HAND, Column

if TYPE_CHECKING:
    from numpy.typing import NDArray

PARQUET = (".parquet", ".pq")
_HANDS = {**HANDS, "r": 1, "l": -1, "rh": 1, "lh": -1, "1": 1, "+1": 1, "-1": -1}


class Reject(NamedTuple):
    """A row that cannot be used.

    Attributes
    ----------
    line
        Where it begins (in a Parquet file, the number of the row), from 1.
    reason
        What is wrong.
    cells
        The row as in the file.
    """

    line: int
    reason: str
    cells: Sequence[str]


class Piece(Protocol):
    """Some rows of a file, all with as many cells as there are columns.

    Attributes
    ----------
    lines
        Where each row begins.
    ragged
        Rows with too few or too many cells, which are not among the others.
    """

    lines: Sequence[int]
    ragged: list[Reject]

    def numbers(self, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
        """Return the numbers of a column in its unit, and for rows without one, why."""
        ...

    def texts(self, rows: Sequence[int] | None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        ...

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they stand, or would stand, in a CSV file."""
        ...

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows as an Arrow array."""
        ...


class Reader(Protocol):
    """A file of deliveries.

    Attributes
    ----------
    path
        The file.
    headings
        As in the file.
    header_line
        Where they stand, or None.
    delimiter
        Between cells of text.
    decimal_comma
        Whether its numbers are written with a decimal comma.
    counts
        What a place in the file is counted in: "line" or "row".
    """

    path: str
    headings: list[str]
    header_line: int | None
    delimiter: str
    decimal_comma: bool
    counts: str

    @property
    def blank(self) -> int:
        """Blank lines passed over so far."""
        ...

    def pieces(self, rows: int, skip: int) -> Iterator[Piece]:
        """Yield the rows after the first ``skip``, some ``rows`` at a time."""
        ...

    def progress(self) -> float:
        """Return which part of the file has been read, 0 to 1."""
        ...

    def schema(self, place: int) -> Any:
        """Return the Arrow type of a column, or None for text."""
        ...

    def close(self) -> None:
        """Close the file."""
        ...


def open_table(path: Path) -> Reader:
    """Open a file of deliveries, Parquet by its ending, else CSV."""
    if path.suffix.lower() in PARQUET:
        from clubface.tables.parquet import ParquetReader

        return ParquetReader(path)
    from clubface.tables.csv_reader import CsvReader

    return CsvReader(path)


def parsed(cells: Sequence[str], column: Column, decimal_comma: bool) -> tuple[NDArray[Any], dict[int, str]]:
    """Return the numbers ``cells`` hold, and for those that hold none, why."""
    import numpy as np

    read: Callable[[str], float] = _hand if column.quantity == HAND else float
    joined = "".join(cells)
    if read is float and "_" not in joined and (not decimal_comma or "." not in joined):
        try:
            values = np.array([*map(float, cells if not decimal_comma else [c.replace(",", ".") for c in cells])])
            finite = np.isfinite(values)
            if finite.all():
                return values, {}
        except ValueError:
            pass
    values = np.full(len(cells), math.nan)
    reasons = {}
    for row, cell in enumerate(cells):
        text = cell.strip()
        try:
            if "_" in text or (decimal_comma and "." in text):
                raise ValueError
            values[row] = read(text.replace(",", ".") if decimal_comma else text)
            if not math.isfinite(values[row]):
                reasons[row] = f"{column.heading}: {text!r} is not a finite number"
        except ValueError:
            wanted = "right or left" if read is _hand else "a number"
            shown = repr(text if len(text) <= 40 else text[:37] + "...")
            reasons[row] = f"{column.heading}: " + (f"{shown} is not {wanted}" if text else "the cell is empty")
    return values, reasons


def _hand(text: str) -> float:
    if text.lower() not in _HANDS:
        raise ValueError
    return float(_HANDS[text.lower()])
