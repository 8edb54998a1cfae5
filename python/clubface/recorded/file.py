"""Recorded shots from and to files with the columns of clubface."""

from __future__ import annotations

import csv
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.errors import FileError
from clubface.recorded.shots import FACE_AT, SIDES, SPEED_AT, RecordedShots, RejectedRow
from clubface.tables.headings import HAND, Column, Layout, layout, listed, plain_name, shot_words
from clubface.tables.reader import Piece, open_table
from clubface.tables.writer import is_parquet, open_text, unfinished
from clubface.units import display_unit, from_si, unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

POINTS = {"speed_at": SPEED_AT, "face_at": FACE_AT}
"""Columns that say where club data was taken; they are there only where it is not where models want it."""
CLUB_HEADINGS = ("club", "club_name", "club_type")
CHUNK_ROWS = 16384
SHOWN = 3
"""Reasons an error names."""


def read(path: Path) -> RecordedShots:
    """Read recorded shots; see :func:`clubface.recorded.shots.read_shots`."""
    reader = open_table(path)
    try:
        found = layout(reader.headings, reader.path, reader.header_line, shot_words())
        if not [each for each in found.used if each.quantity != HAND]:
            message = f"no column is of a delivery or a launch, such as ball_speed_mph; {listed(found.headings)}"
            raise FileError(reader.path, reader.header_line, message)
        club = next((place for place, name in enumerate(found.headings) if plain_name(name) in CLUB_HEADINGS), None)
        read_so_far = _Columns(found, club)
        for piece in reader.pieces(CHUNK_ROWS, 0):
            read_so_far.take(piece, reader.path)
    finally:
        reader.close()
    rejected = tuple(sorted(read_so_far.rejected, key=lambda each: each.line or 0))
    refuse_empty(reader.path, len(read_so_far.rows), rejected)
    return read_so_far.shots(reader.path, rejected)


def refuse_empty(path: str, shots: int, rejected: tuple[RejectedRow, ...]) -> None:
    """Refuse a file without a single shot, telling why its rows could not be used."""
    if not shots:
        unit_of = "row" if path.lower().endswith((".parquet", ".pq")) else "line"
        reasons = "; ".join(f"{unit_of} {each.line}: {each.reason}" for each in rejected[:SHOWN])
        more = f" (and {len(rejected) - SHOWN} more)" if len(rejected) > SHOWN else ""
        raise FileError(path, None, f"not one shot can be used: {reasons}{more}" if rejected else "there are no shots")


class _Columns:
    """The columns of a file, piece by piece."""

    def __init__(self, found: Layout, club: int | None) -> None:
        self._layout = found
        self._club = club
        self._values: dict[str, list[NDArray[Any]]] = {each.quantity: [] for each in found.used}
        self._clubs: list[str] = []
        self._points = {name: found.headings.index(name) for name in POINTS if name in found.headings}
        self._taken: dict[str, str] = {}
        self.rows: list[int] = []
        self.rejected: list[RejectedRow] = []

    def take(self, piece: Piece, path: str) -> None:
        """Add the rows of a piece; a cell that is empty is NaN, one that is no number rejects its row."""
        self.rejected += [RejectedRow(each.line, each.reason) for each in piece.ragged]
        reasons: dict[int, str] = {}
        values: dict[str, NDArray[Any]] = {}
        for column in self._layout.used:
            values[column.quantity], bad = _numbers(piece, column)
            for row, reason in bad.items():
                reasons.setdefault(row, reason)
        measured = [name for name in values if name != HAND]
        for row in np.flatnonzero(np.all([np.isnan(values[name]) for name in measured], axis=0)):
            reasons.setdefault(int(row), "nothing was measured: every cell of a delivery or launch is empty")
        self.rejected += [RejectedRow(piece.lines[row], reason) for row, reason in reasons.items()]
        kept = [row for row in range(len(piece.lines)) if row not in reasons]
        for name, numbers in values.items():
            self._values[name].append(numbers[kept])
        self.rows += [piece.lines[row] for row in kept]
        for name, place in self._points.items():
            self._take_point(name, {cells[place].strip() for cells in piece.texts(kept)}, path)
        if self._club is not None:
            self._clubs += [cells[self._club].strip() for cells in piece.texts(kept)]

    def _take_point(self, name: str, told: set[str], path: str) -> None:
        """Take where club data was taken, which must be the same for all shots."""
        told |= {self._taken[name]} if name in self._taken else set()
        if len(told) > 1 or not told <= set(POINTS[name]):
            allowed = f"one of {', '.join(POINTS[name])}, the same for all shots"
            raise FileError(
                path, None, f"the column {name!r} holds {', '.join(sorted(told))}; it must be {allowed}", name
            )
        if told:
            self._taken[name] = told.pop()

    def shots(self, path: str, rejected: tuple[RejectedRow, ...]) -> RecordedShots:
        """Return all rows taken."""
        values = {name: np.concatenate(parts) for name, parts in self._values.items()}
        hand = values.pop(HAND, None)
        from clubface.simulation.quantities import inputs

        return RecordedShots(
            deliveries={name: each for name, each in values.items() if name in inputs()},
            launches={name: each for name, each in values.items() if name not in inputs()},
            clubs=np.array(self._clubs, dtype=object) if self._club is not None else None,
            hand=None if hand is None else np.array([SIDES[each] for each in hand], dtype=object),
            rows=np.array(self.rows, dtype=np.int64),
            source=path,
            format="clubface",
            rejected=rejected,
            notes=self._layout.notes,
            **self._taken,  # pyright: ignore[reportArgumentType]
        )


def _numbers(piece: Piece, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
    """Return the SI values of a column, NaN where a cell is empty, and for cells that hold no number, why."""
    values, bad = piece.numbers(column)
    if bad:
        cells = piece.texts(list(bad))
        empty = {row for row, cell in zip(bad, cells, strict=True) if cell[column.place].strip().lower() in ("", "nan")}
        bad = {row: reason for row, reason in bad.items() if column.quantity == HAND or row not in empty}
    if not len(values):
        return np.empty(0), bad
    factor = unit(column.unit)
    return values * factor.numerator / factor.denominator, bad


def heading(name: str, si_unit: str) -> tuple[str, str]:
    """Return the heading of a column and its unit."""
    shown = "mph" if si_unit == "m/s" else display_unit(name, si_unit)
    spelled = "club_speed" if name == "speed" else name
    if shown == "1":
        return spelled, shown
    return (f"{spelled}_{shown}" if shown.isalnum() else f"{spelled} [{shown}]"), shown


def write(shots: RecordedShots, path: Path) -> None:
    """Write recorded shots; see :meth:`clubface.recorded.shots.RecordedShots.write`."""
    parquet = is_parquet(path)
    columns: dict[str, Any] = {}
    for name, texts in (("club", shots.clubs), (HAND, shots.hand)):
        if texts is not None:
            columns[name] = [str(each) for each in texts]
    for name, points in POINTS.items():
        if getattr(shots, name) != points[0]:
            columns[name] = [getattr(shots, name)] * len(shots)
    of = shots.deliveries | shots.launches
    for name, si_unit in shots.units().items():
        named, shown = heading(name, si_unit)
        columns[named] = from_si(of[name], shown)
    part = unfinished(path)
    if parquet:
        _write_parquet(columns, part)
    else:
        with open_text(part, None) as file:
            out = csv.writer(file, delimiter="\t" if path.suffix.lower() == ".tsv" else ",", lineterminator="\n")
            out.writerow(columns)
            out.writerows(zip(*(map(_cell, each) for each in columns.values()), strict=True))
    os.replace(part, path)


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return value
    return "" if math.isnan(value) else repr(float(value))


def _write_parquet(columns: dict[str, Any], path: Path) -> None:
    from clubface.tables.parquet import pyarrow_for

    arrow = pyarrow_for(path)
    arrays = {name: arrow.array(values, from_pandas=True) for name, values in columns.items()}
    try:
        arrow.parquet.write_table(arrow.table(arrays), path)
    except OSError as error:
        raise FileError(str(path), None, f"cannot be written: {error.strerror or error}") from None
