"""Sources of deliveries for predictions: a plain table, read in chunks, or recorded shots, prepared as a whole.

A table of deliveries may have any length. Recorded shots (a launch monitor's file, or a table that names clubs or the
reference points of club data) are prepared by :func:`clubface.shots.measured.ready_shots`; rows of such a table are
passed through unchanged, rows of a monitor's file as ``clubface monitor read`` writes them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.jobs.store import fingerprint
from clubface.results.notes import Note
from clubface.shots.measured import ReadyShots, assumptions, ready_shots
from clubface.shots.monitors import TABLE
from clubface.shots.reading import is_plain_table, read
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.cells import Chunk, Reject
from clubface.shots.tables.headings import (
    HAND,
    POINTS,
    ColumnLayout,
    FileColumn,
    check_units,
    layout,
    plain_name,
    require_speed,
)
from clubface.shots.tables.row_source import Reader, open_table
from clubface.simulation.results import inputs
from clubface.support.arrays import Floats


class Source(NamedTuple):
    """A source of deliveries."""

    table: Reader | MonitorTable  # table whose rows are passed through
    columns: ColumnLayout  # meaning of its columns
    used: tuple[FileColumn, ...]  # columns that give inputs, or the prepared deliveries
    chunks: Callable[[int, int], Iterator[Chunk]]  # yields chunks of a number of rows, after skipping some
    content: str = ""  # fingerprint of recorded shots; "" for a plain table
    remarks: tuple[Note, ...] = ()  # notes on recorded shots

    @property
    def notes(self) -> tuple[Note, ...]:
        """Notes on the file, as far as it has been read."""
        return self.remarks if self.content else (*self.table.notes, *self.columns.notes)


def open_source(
    path: Path, club: Club, *, hand: str | None, reading: Mapping[str, Any], choice: Mapping[str, Any]
) -> Source:
    """Open a file of deliveries or of recorded shots.

    ``reading`` holds ``format``, ``mapping`` and ``units`` for :func:`clubface.shots.read`, and ``choice`` holds
    ``only``, ``where``, ``assume`` and ``mismatch`` for :func:`clubface.shots.measured.ready_shots`.
    """
    units = check_units(reading["units"] or {})
    if reading["format"] or reading["mapping"] or not is_plain_table(path):
        recorded = read(path, hand=hand, **reading)
        ready = ready_shots(recorded, club=club, **choice)
        table = MonitorTable(path, recorded, ready)
        fields = _ready_fields(table.path, table.columns, recorded, ready)
        return Source(table, table.columns, chunks=table.chunks, **fields)
    reader = open_table(path)
    try:
        place = (reader.path, reader.header_line)
        telling = {*map(plain_name, TABLE.club), *POINTS}
        is_recorded = any(choice[name] for name in ("only", "where", "assume"))
        if is_recorded or not telling.isdisjoint(map(plain_name, reader.headings)):
            recorded = read(path, units=units)
            columns = layout(reader.headings, *place, given_units=units)
            ready = ready_shots(recorded, club=club, **choice)
            fields = _ready_fields(reader.path, columns, recorded, ready)
            return Source(reader, columns, chunks=partial(_ready_rows, reader, recorded, ready), **fields)
        columns = layout(reader.headings, *place, given_units=units)
        require_speed(columns, *place)
        return Source(reader, columns, columns.used, reader.chunks)
    except BaseException:
        reader.close()
        raise


class MonitorTable:
    """Prepared shots as a table with the columns of ``clubface monitor read``; interface as of ``CsvReader``."""

    counts, delimiter, decimal_comma = "line", ",", False
    header_line: int | None = None
    blank = 0
    notes: tuple[Note, ...] = ()

    def __init__(self, path: Path, recorded: RecordedShots, ready: ReadyShots) -> None:
        shots = recorded.select(ready.places)
        self.path, self._lines = str(path), shots.rows
        self._cells = {name: np.asarray(each) for name, each in shots.columns().items()}
        self._deliveries = _measured(ready)
        named = {heading: (name, unit) for name, (heading, unit) in shots.headings().items() if name in inputs()}
        named |= {HAND: (HAND, "1")} if HAND in self._cells else {}
        used = tuple(FileColumn(at, each, *named[each]) for at, each in enumerate(self._cells) if each in named)
        passed = tuple(each for each in self._cells if each not in named)
        self.columns = ColumnLayout(tuple(self._cells), used, passed, ())
        empty = [""] * len(self._cells)
        self._rejected = [Reject(each.line or 0, each.reason, empty) for each in recorded.rejected]
        count = len(self._rejected)
        order = [*((int(line), place) for place, line in enumerate(self._lines)),
                 *((each.line, place - count) for place, each in enumerate(self._rejected))]  # fmt: skip
        self._order = [place for _, place in sorted(order)]
        self._done = 0

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
        """Yield chunks of ``rows`` rows, after skipping the first ``skip``."""
        for first in range(skip, len(self._order), rows):
            part = self._order[first : first + rows]
            kept = [place for place in part if place >= 0]
            self._done = first + len(part)
            yield Chunk(
                self._lines[kept].tolist(), [each[kept] for each in self._cells.values()],
                [self._rejected[place] for place in part if place < 0],
                deliveries={name: each[kept] for name, each in self._deliveries.items()},
            )  # fmt: skip

    def progress(self) -> float:
        """Return the share of the rows that has been read, 0 to 1."""
        return self._done / max(len(self._order), 1)

    @property
    def types(self) -> list[Any]:
        """Arrow types of the columns."""
        import pyarrow

        return [pyarrow.float64() if each.dtype.kind == "f" else pyarrow.string() for each in self._cells.values()]

    def close(self) -> None:
        """Do nothing, as no file is open."""


def _ready_rows(reader: Reader, recorded: RecordedShots, ready: ReadyShots, rows: int, skip: int) -> Iterator[Chunk]:
    """Yield the rows of a table unchanged, with the prepared deliveries of the shots read from it."""
    deliveries = _measured(ready)
    places = {line: place for place, line in enumerate(ready.rows.tolist())}
    reasons = {each.line: each.reason for each in recorded.rejected}
    for base in reader.chunks(rows, 0):
        bad = [row for row, line in enumerate(base.lines) if line in reasons]
        lost = [base.lines[row] for row in bad]
        rejects = [Reject(at, reasons[at], cells) for at, cells in zip(lost, base.texts(bad), strict=True)]
        ragged = sorted([*base.ragged, *rejects], key=lambda each: each.line)
        kept = [row for row, line in enumerate(base.lines) if line in places]
        passed = sorted([*(base.lines[row] for row in kept), *(each.line for each in ragged)])[:skip]
        skip -= len(passed)
        last = passed[-1] if passed else -1
        kept = [row for row in kept if base.lines[row] > last]
        ragged = [each for each in ragged if each.line > last]
        if kept or ragged:
            at = [places[base.lines[row]] for row in kept]
            ready_deliveries = {name: each[at] for name, each in deliveries.items()}
            yield replace(base.select(kept), ragged=ragged, deliveries=ready_deliveries)


def _measured(ready: ReadyShots) -> dict[str, Floats]:
    """Return the delivery quantities known for at least one shot [SI]."""
    return {name: values for name, values in ready.delivery().items() if np.isfinite(values).any()}


def _ready_fields(path: str, columns: ColumnLayout, recorded: RecordedShots, ready: ReadyShots) -> dict[str, Any]:
    """Return the fields of a source for prepared shots."""
    deliveries = _measured(ready)
    if "speed" not in deliveries:
        raise FileError(path, None, "no shot has a measured club speed", "speed")
    headings = {each.quantity: each.heading for each in columns.used}
    return {
        "used": tuple(FileColumn(-1, headings.get(name, name), name, inputs()[name].unit) for name in deliveries),
        "remarks": (*ready.notes, *assumptions(ready.club, deliveries)),
        "content": fingerprint([ready.rows, deliveries, [tuple(each) for each in recorded.rejected]]),
    }
