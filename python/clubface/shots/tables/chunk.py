"""What a file of shots is to those who read it: rows with their lines, a chunk at a time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from clubface.shots.tables.headings import Column

if TYPE_CHECKING:
    from numpy.typing import NDArray


GONE = "parts of the unfinished work were removed or damaged meanwhile; give the same command again"


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


class Chunk(Protocol):
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

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, or a list of texts."""
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

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the rows should know of the file, as far as it is read."""
        ...

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
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
