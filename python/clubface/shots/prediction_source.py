"""The deliveries of a file: a plain table, read as it goes, or recorded shots, which are made ready first.

A table of deliveries may be of any length and is never held as a whole. What was recorded (a launch monitor's file, or
a table that names clubs or says where on the club its data was taken) goes the way of all recorded shots,
:func:`clubface.shots.measured.ready_shots`; the rows of such a table are still passed through as they stand.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.shots.measured import ReadyShots, assumptions, ready_shots
from clubface.shots.monitors import TABLE
from clubface.shots.reading import is_plain_table, read
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.chunk import Chunk, Reader, Reject
from clubface.shots.tables.headings import POINTS, Column, Layout, check_units, layout, plain_name, require_speed
from clubface.shots.tables.reader import MemoryReader, open_table
from clubface.simulation.results import inputs
from clubface.support.fingerprint import fingerprint

LAID_OUT = ("format", "mapping")
READING = (*LAID_OUT, "units")
CHOICE = ("only", "where", "assume")
"""What may be said of a file of shots: how it is read, and which shots are meant and completed."""


class Source(NamedTuple):
    """Where deliveries come from.

    Attributes
    ----------
    reader
        The rows.
    columns
        What the columns of the file mean.
    used
        The columns that give inputs: those of the file, or the deliveries that were made ready.
    notes
        What a reader of the result should know.
    content
        A text that is the same only for the same deliveries, or "" for a plain table.
    """

    reader: Reader
    columns: Layout
    used: tuple[Column, ...]
    notes: tuple[str, ...]
    content: str = ""


def open_source(path: Path, club: Club, *, hand: str | None, mismatch: str, **said: Any) -> Source:
    """Open a file of deliveries or of recorded shots.

    Parameters
    ----------
    path
        The file.
    club
        The club.
    hand
        The hand of the player of a launch monitor's file, if it was given.
    mismatch, **said
        As for :func:`clubface.shots.measured.ready_shots` and :func:`clubface.shots.read`: those of
        ``CHOICE`` and ``READING``.
    """
    units = check_units(said["units"] or {})
    if any(said[name] for name in LAID_OUT) or not is_plain_table(path):
        recorded = read(path, hand=hand, **{name: said[name] for name in READING})
        ready = ready_shots(recorded, club=club, mismatch=mismatch, **{name: said[name] for name in CHOICE})
        reader = _as_read(recorded, ready, path)
        return _of_shots(reader, layout(reader.headings, reader.path, reader.header_line), recorded, ready)
    reader = open_table(path)
    try:
        place = (reader.path, reader.header_line)
        telling = {*map(plain_name, TABLE.club), *POINTS}
        if telling.isdisjoint(map(plain_name, reader.headings)) and not any(said[name] for name in CHOICE):
            columns = layout(reader.headings, *place, given_units=units)
            require_speed(columns, *place)
            return Source(reader, columns, columns.used, (*reader.notes, *columns.notes))
        recorded = read(path, units=units)
        columns = layout(reader.headings, *place, given_units=units)
        ready = ready_shots(recorded, club=club, mismatch=mismatch, **{name: said[name] for name in CHOICE})
        return _of_shots(reader, columns, recorded, ready)
    except BaseException:
        reader.close()
        raise


def _as_read(recorded: RecordedShots, ready: ReadyShots, path: Path) -> MemoryReader:
    """Return shots as a table, as they were read: what ``clubface monitor read`` writes."""
    shots = recorded.select(ready.places)
    columns = shots.columns()
    rejected = [Reject(each.line or 0, each.reason, [""] * len(columns)) for each in recorded.rejected]
    return MemoryReader(str(path), columns, shots.rows.tolist(), rejected)


def _of_shots(reader: Reader, columns: Layout, recorded: RecordedShots, ready: ReadyShots) -> Source:
    """Return the rows of a table whose deliveries are those of recorded shots."""
    deliveries = {name: values for name, values in ready.delivery().items() if np.isfinite(values).any()}
    if "speed" not in deliveries:
        raise FileError(reader.path, None, "the clubhead speed was measured for no shot", "speed")
    headings = {each.quantity: each.heading for each in columns.used}
    used = tuple(Column(-1, headings.get(name, name), name, inputs()[name].unit) for name in deliveries)
    notes = (*ready.notes, *assumptions(ready.club, deliveries))
    content = fingerprint([ready.rows, deliveries, [tuple(each) for each in ready.rejected]])
    return Source(_ReadyReader(reader, recorded, ready, deliveries), columns, used, notes, content)


class _ReadyReader:
    """The rows of a table of recorded shots that were chosen, with the deliveries that were made ready."""

    def __init__(
        self, base: Reader, recorded: RecordedShots, ready: ReadyShots, deliveries: dict[str, NDArray[Any]]
    ) -> None:
        self._base = base
        self._deliveries = deliveries
        self._place = {line: place for place, line in enumerate(ready.rows.tolist())}
        self._rejected = {each.line: each.reason for each in recorded.rejected}
        self.path, self.headings, self.header_line = base.path, base.headings, base.header_line
        self.delimiter, self.decimal_comma, self.counts = base.delimiter, base.decimal_comma, base.counts
        self.progress, self.schema, self.close = base.progress, base.schema, base.close

    @property
    def blank(self) -> int:
        """Blank lines passed over so far."""
        return self._base.blank

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the rows should know of the file, as far as it is read."""
        return self._base.notes

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
        """Yield the rows after the first ``skip`` that were chosen or rejected, some at a time."""
        for base in self._base.chunks(rows, 0):
            kept = [row for row, line in enumerate(base.lines) if line in self._place]
            bad = [row for row, line in enumerate(base.lines) if line in self._rejected]
            cells = base.texts(bad) if bad else []
            lines = [base.lines[row] for row in bad]
            rejects = [Reject(at, self._rejected[at], each) for at, each in zip(lines, cells, strict=True)]
            ragged = sorted([*base.ragged, *rejects], key=lambda each: each.line)
            passed = sorted([*(base.lines[row] for row in kept), *(each.line for each in ragged)])[:skip]
            skip -= len(passed)
            last = passed[-1] if passed else -1
            kept = [row for row in kept if base.lines[row] > last]
            ragged = [each for each in ragged if each.line > last]
            if kept or ragged:
                yield _ReadyChunk(base, kept, ragged, self._place, self._deliveries)


class _ReadyChunk:
    """Some rows of recorded shots. See :class:`clubface.shots.tables.chunk.Chunk`."""

    def __init__(
        self,
        base: Chunk,
        kept: Sequence[int],
        ragged: list[Reject],
        place: dict[int, int],
        deliveries: dict[str, NDArray[Any]],
    ) -> None:
        self._base = base
        self._kept = kept
        self._deliveries = deliveries
        self.lines: Sequence[int] = [base.lines[row] for row in kept]
        self.ragged = ragged
        self._places = [place[line] for line in self.lines]

    def numbers(self, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
        """Return the values [SI] of a column, and for rows without one, why."""
        values = self._deliveries[column.quantity][self._places]
        remedy = f'not measured; --assume "{column.quantity}=..." states a value'
        return values, dict.fromkeys(np.flatnonzero(np.isnan(values)).tolist(), f"{column.heading}: {remedy}")

    def _rows(self, rows: Sequence[int] | None) -> Sequence[int]:
        return self._kept if rows is None else [self._kept[row] for row in rows]

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, or a list of texts."""
        cells = self._base.cells(place)
        return [cells[row] for row in self._kept] if isinstance(cells, list) else cells[self._kept]

    def texts(self, rows: Sequence[int] | None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        return self._base.texts(self._rows(rows))

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as they stand, or would stand, in a CSV file."""
        return self._base.written(self._rows(rows), delimiter)

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows as an Arrow array."""
        return self._base.arrow(place, self._rows(rows))
