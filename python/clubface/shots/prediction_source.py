"""The deliveries of a file: a plain table, read as it goes, or recorded shots, which are made ready first.

A table of deliveries may be of any length and is never held as a whole. What was recorded (a launch monitor's file, or
a table that names clubs or says where on the club its data was taken) goes the way of all recorded shots,
:func:`clubface.shots.measured.ready_shots`, whose arrays are computed with as they are; the rows of such a table are
passed through as they stand, and of a monitor's file as ``clubface monitor read`` writes them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.results.notes import Note
from clubface.shots.measured import ReadyShots, assumptions, ready_shots
from clubface.shots.monitors import TABLE
from clubface.shots.reading import is_plain_table, read
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.chunk import Chunk, Reject
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
from clubface.shots.tables.reader import Reader, open_table
from clubface.simulation.results import inputs
from clubface.support.arrays import Floats
from clubface.support.fingerprint import fingerprint

__all__ = ["Source", "open_source"]


@dataclass(frozen=True, kw_only=True)
class Source:
    """Where deliveries come from.

    Attributes
    ----------
    path, header_line, counts
        The file, the line of its headings, and what a place in it is counted in: "line" or "row".
    delimiter, decimal_comma
        How its cells and numbers are written.
    columns
        What its columns mean.
    used
        The columns that give inputs: those of the file, or the deliveries that were made ready.
    content
        A text that is the same only for the same deliveries, or "" for a plain table.
    types
        Arrow types of the columns; None for text.
    chunks
        Yields the rows after the first so many, some at a time.
    notes
        Returns what is to be known of the file, as far as it is read.
    progress
        Returns which part of the file has been read, 0 to 1.
    blank
        Returns how many blank lines were passed over.
    close
        Closes the file.
    """

    path: str
    header_line: int | None = None
    counts: str = "line"
    delimiter: str = ","
    decimal_comma: bool = False
    columns: ColumnLayout
    used: tuple[FileColumn, ...]
    content: str = ""
    types: Callable[[], Sequence[Any]]
    chunks: Callable[[int, int], Iterator[Chunk]]
    notes: Callable[[], tuple[Note, ...]]
    progress: Callable[[], float]
    blank: Callable[[], int] = field(default=lambda: 0)
    close: Callable[[], None] = field(default=lambda: None)


def open_source(
    path: Path, club: Club, *, hand: str | None, reading: Mapping[str, Any], choice: Mapping[str, Any]
) -> Source:
    """Open a file of deliveries or of recorded shots.

    Parameters
    ----------
    path, club
        The file, and the club.
    hand
        The hand of the player of a launch monitor's file, if it was given.
    reading
        ``format``, ``mapping`` and ``units``, as for :func:`clubface.shots.read`.
    choice
        ``only``, ``where``, ``assume`` and ``mismatch``, as for :func:`clubface.shots.measured.ready_shots`.
    """
    units = check_units(reading["units"] or {})
    if reading["format"] or reading["mapping"] or not is_plain_table(path):
        recorded = read(path, hand=hand, **reading)
        return _monitor_source(path, recorded, ready_shots(recorded, club=club, **choice))
    reader = open_table(path)
    try:
        place = (reader.path, reader.header_line)
        telling = {*map(plain_name, TABLE.club), *POINTS}
        is_recorded = any(choice[name] for name in ("only", "where", "assume"))
        if is_recorded or not telling.isdisjoint(map(plain_name, reader.headings)):
            recorded = read(path, units=units)
            columns = layout(reader.headings, *place, given_units=units)
            return _table_source(reader, columns, recorded, ready_shots(recorded, club=club, **choice))
        columns = layout(reader.headings, *place, given_units=units)
        require_speed(columns, *place)
        notes = lambda: (*reader.notes, *columns.notes)  # noqa: E731 - those of numbers come as they are read
        return _source_of(reader, columns=columns, used=columns.used, chunks=reader.chunks, notes=notes)
    except BaseException:
        reader.close()
        raise


def _source_of(reader: Reader, **fields: Any) -> Source:
    """Return the source of a table that is read as it goes."""
    return Source(
        path=reader.path, header_line=reader.header_line, counts=reader.counts, delimiter=reader.delimiter,
        decimal_comma=reader.decimal_comma, types=lambda: reader.types, progress=reader.progress,
        blank=lambda: reader.blank, close=reader.close, **fields,
    )  # fmt: skip


def _monitor_source(path: Path, recorded: RecordedShots, ready: ReadyShots) -> Source:
    """Return recorded shots as a source whose columns are those of ``clubface monitor read``."""
    shots = recorded.select(ready.places)
    columns = {name: np.asarray(each) for name, each in shots.columns().items()}
    headings = {name: each for name, each in shots.headings().items() if name in inputs()}
    headings |= {HAND: (HAND, "1")} if HAND in columns else {}
    named = {heading: (quantity, unit) for quantity, (heading, unit) in headings.items()}
    used = tuple(FileColumn(place, each, *named[each]) for place, each in enumerate(columns) if each in named)
    meant = ColumnLayout(tuple(columns), used, tuple(each for each in columns if each not in named), ())
    deliveries, fields = _ready_fields(str(path), meant, recorded, ready)
    lines = shots.rows
    rejected = [Reject(each.line or 0, each.reason, [""] * len(columns)) for each in recorded.rejected]
    order = sorted([*((int(line), place) for place, line in enumerate(lines)),
                    *((each.line, place - len(rejected)) for place, each in enumerate(rejected))])  # fmt: skip
    done = 0

    def chunks(rows: int, skip: int) -> Iterator[Chunk]:
        nonlocal done
        for first in range(skip, len(order), rows):
            part = [place for _, place in order[first : first + rows]]
            kept = [place for place in part if place >= 0]
            done = first + len(part)
            yield Chunk(
                lines[kept].tolist(), [each[kept] for each in columns.values()],
                [rejected[place] for place in part if place < 0],
                deliveries={name: each[kept] for name, each in deliveries.items()},
            )  # fmt: skip

    def types() -> list[Any]:
        import pyarrow

        return [pyarrow.float64() if each.dtype.kind == "f" else pyarrow.string() for each in columns.values()]

    return Source(path=str(path), types=types, chunks=chunks, progress=lambda: done / max(len(order), 1), **fields)


def _table_source(reader: Reader, columns: ColumnLayout, recorded: RecordedShots, ready: ReadyShots) -> Source:
    """Return the rows of a table as they stand, with the deliveries of the recorded shots that were read from it."""
    deliveries, fields = _ready_fields(reader.path, columns, recorded, ready)
    places = {line: place for place, line in enumerate(ready.rows.tolist())}
    reasons = {each.line: each.reason for each in recorded.rejected}

    def chunks(rows: int, skip: int) -> Iterator[Chunk]:
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

    return _source_of(reader, chunks=chunks, **fields)


def _ready_fields(
    path: str, columns: ColumnLayout, recorded: RecordedShots, ready: ReadyShots
) -> tuple[dict[str, Floats], dict[str, Any]]:
    """Return the deliveries of shots that are ready [SI], and what a source says of them."""
    deliveries = {name: values for name, values in ready.delivery().items() if np.isfinite(values).any()}
    if "speed" not in deliveries:
        raise FileError(path, None, "the clubhead speed was measured for no shot", "speed")
    headings = {each.quantity: each.heading for each in columns.used}
    used = tuple(FileColumn(-1, headings.get(name, name), name, inputs()[name].unit) for name in deliveries)
    notes = (*ready.notes, *assumptions(ready.club, deliveries))
    content = fingerprint([ready.rows, deliveries, [tuple(each) for each in recorded.rejected]])
    return deliveries, {"columns": columns, "used": used, "notes": lambda: notes, "content": content}
