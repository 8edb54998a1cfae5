"""Some rows of a table by column, and the rows that cannot be used."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from clubface.shots.tables.cells import cell_text, parsed
from clubface.shots.tables.headings import HAND, FileColumn

if TYPE_CHECKING:
    from clubface.support.arrays import Floats

PARTS_MISSING = "parts of the unfinished work were removed or damaged meanwhile; give the same command again"


class Reject(NamedTuple):
    """A row that cannot be used."""

    line: int  # where it begins (in a Parquet file, the number of the row), from 1
    reason: str  # what is wrong
    cells: Sequence[str]  # the row as in the file


@dataclass(frozen=True)
class Chunk:
    """Some rows of a table, all with as many cells as there are columns."""

    lines: Sequence[int]  # where each row begins
    columns: Sequence[Any]  # each a sequence of texts, an array of numbers or texts, or an Arrow array
    ragged: Sequence[Reject] = ()  # rows with too few or too many cells, which are not among the others
    decimal_comma: bool = False  # whether texts write numbers with a decimal comma
    as_written: Sequence[str] | None = None  # the rows as they stand in a CSV file
    deliveries: Mapping[str, Floats] | None = None  # inputs of an impact [SI], where they need not be read from cells

    def select(self, rows: Sequence[int] | None) -> Self:
        """Return the chunk of some rows; None stands for all."""
        if rows is None:
            return self
        written = None if self.as_written is None else [self.as_written[row] for row in rows]
        columns = [_taken(each, rows) for each in self.columns]
        return replace(self, lines=[self.lines[row] for row in rows], columns=columns, as_written=written)

    def numbers(self, column: FileColumn) -> tuple[Any, dict[int, str]]:
        """Return the numbers of a column in its unit, and for rows without one, why."""
        import numpy as np

        numbers = self.cells(column.place)
        if isinstance(numbers, Sequence) or column.quantity == HAND:
            return parsed(_texts(self.columns[column.place]), column, self.decimal_comma)
        missing = self.columns[column.place].is_null()
        return numbers, {
            int(row): f"{column.heading}: "
            + ("the cell is empty" if missing[int(row)].as_py() else f"{numbers[row]} is not a finite number")
            for row in np.flatnonzero(~np.isfinite(numbers))
        }

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, NaN where there is none, or a list of texts."""
        column = self.columns[place]
        if _is_arrow(column):
            import pyarrow

            if pyarrow.types.is_integer(column.type) or pyarrow.types.is_floating(column.type):
                return column.cast(pyarrow.float64(), safe=False).to_numpy(zero_copy_only=False)
        elif not isinstance(column, Sequence) and column.dtype.kind == "f":
            return column
        return _texts(column)

    def texts(self, rows: Sequence[int] | None = None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        columns = self.columns if rows is None else [_taken(each, rows) for each in self.columns]
        return [list(cells) for cells in zip(*map(_texts, columns), strict=True)]

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they stand, or would stand, in a CSV file."""
        if self.as_written is not None:
            texts = self.as_written if rows is None else [self.as_written[row] for row in rows]
            return [text.rstrip("\r\n") for text in texts]
        lines = []
        for cells in self.texts(rows):
            line = io.StringIO()
            csv.writer(line, delimiter=delimiter, lineterminator="").writerow(cells)
            lines.append(line.getvalue())
        return lines

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows (None: all) as an Arrow array; NaN becomes null."""
        import pyarrow

        column = self.columns[place] if rows is None else _taken(self.columns[place], rows)
        if _is_arrow(column):
            return column
        if isinstance(column, Sequence):
            return pyarrow.array(column, pyarrow.string())
        return pyarrow.array(column, from_pandas=True)


def _is_arrow(column: Any) -> bool:
    return hasattr(column, "to_pylist")


def _taken(column: Any, rows: Sequence[int]) -> Any:
    """Return some cells of a column."""
    if _is_arrow(column):
        import pyarrow

        return column.take(pyarrow.array(rows, pyarrow.int64()))
    return [column[row] for row in rows] if isinstance(column, Sequence) else column[list(rows)]


def _texts(column: Any) -> Sequence[str]:
    """Return the cells of a column as texts, those without a value as empty ones."""
    if _is_arrow(column):
        return ["" if each is None else _arrow_text(each) for each in column.to_pylist()]
    return column if isinstance(column, Sequence) else [cell_text(each) for each in column]


def _arrow_text(value: Any) -> str:
    if isinstance(value, float) and math.isfinite(value):
        return f"{value:.15g}" if float(f"{value:.15g}") == value else repr(value)
    return str(value)
