"""Recorded shots from and to files with the columns of clubface."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import FileError, shortened
from clubface.recorded.possible import without_impossible
from clubface.recorded.shots import SIDES, RecordedShots, RejectedRow
from clubface.simulation.quantities import inputs
from clubface.tables.cells import is_missing
from clubface.tables.headings import HAND, POINTS, Column, Layout, layout, listed, plain_name, shot_words
from clubface.tables.reader import open_table
from clubface.tables.rows import Chunk
from clubface.units import to_si

CLUB_HEADINGS = ("club", "club_name", "club_type")
PLAYER_HEADINGS = ("player", "player_name")
CHUNK_ROWS = 16384
SHOWN = 3
"""Reasons an error names."""


def read_shots(path: str | os.PathLike[str], *, units: Mapping[str, str] | None = None) -> RecordedShots:
    """Read recorded shots from a CSV or Parquet file with the columns of clubface.

    Columns are found by name and carry their unit, as for :func:`predict`: ``club_speed_mph``, ``attack [deg]``, and
    of the launch ``ball_speed_mph``, ``launch_deg``, ``azimuth_deg``, ``backspin_rpm``, ``sidespin_rpm``,
    ``total_spin_rpm``, ``spin_axis_deg``, ``carry_yd`` and so on; ``club`` names the club, ``player`` the player,
    ``hand`` is right or left.
    An empty cell is a value not measured. ``units`` are those of columns that name none, by quantity or dimension, such
    as ``{"speed": "mph"}``; without it, such columns are in SI units.

    Raises
    ------
    FileError
        A file that cannot be read, with the line: empty, without a column of a delivery or launch, a column twice, a
        unit of another dimension, not UTF-8, or without a single row that can be used.
    """
    reader = open_table(Path(path))
    try:
        found = layout(reader.headings, reader.path, reader.header_line, shot_words(), units)
        if not [each for each in found.used if each.quantity != HAND]:
            message = f"no column is of a delivery or a launch, such as ball_speed_mph; {listed(found.headings)}"
            raise FileError(reader.path, reader.header_line, message)
        club, player = (
            next((place for place, name in enumerate(found.headings) if plain_name(name) in headings), None)
            for headings in (CLUB_HEADINGS, PLAYER_HEADINGS)
        )
        read_so_far = _Columns(found, club, player)
        for chunk in reader.chunks(CHUNK_ROWS, 0):
            read_so_far.take(chunk, reader.path)
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


def without_emptied(shots: RecordedShots, emptied: NDArray[np.bool_]) -> RecordedShots:
    """Reject shots of which nothing is left without the values that cannot be."""
    if not emptied.any():
        return shots
    lost = [RejectedRow(int(row), "nothing was measured that a shot can have") for row in shots.rows[emptied]]
    rejected = tuple(sorted((*shots.rejected, *lost), key=lambda each: each.line or 0))
    refuse_empty(shots.source, len(shots) - len(lost), rejected)
    return replace(shots.select(~emptied), rejected=rejected)


class _Columns:
    """The columns of a file, chunk by chunk."""

    def __init__(self, found: Layout, club: int | None, player: int | None) -> None:
        self._layout = found
        self._club = club
        self._player = player
        self._values: dict[str, list[NDArray[Any]]] = {each.quantity: [] for each in found.used}
        self._clubs: list[str] = []
        self._players: list[str] = []
        self._points = {name: found.headings.index(name) for name in POINTS if name in found.headings}
        self._taken: dict[str, str] = {}
        self.rows: list[int] = []
        self.rejected: list[RejectedRow] = []

    def take(self, chunk: Chunk, path: str) -> None:
        """Add the rows of a chunk; a cell that is empty is NaN, one that is no number rejects its row."""
        self.rejected += [RejectedRow(each.line, each.reason) for each in chunk.ragged]
        reasons: dict[int, str] = {}
        values: dict[str, NDArray[Any]] = {}
        for column in self._layout.used:
            values[column.quantity], bad = _numbers(chunk, column)
            for row, reason in bad.items():
                reasons.setdefault(row, reason)
        measured = [name for name in values if name != HAND]
        for row in np.flatnonzero(np.all([np.isnan(values[name]) for name in measured], axis=0)):
            reasons.setdefault(int(row), "nothing was measured: every cell of a delivery or launch is empty")
        self.rejected += [RejectedRow(chunk.lines[row], reason) for row, reason in reasons.items()]
        kept = [row for row in range(len(chunk.lines)) if row not in reasons]
        for name, numbers in values.items():
            self._values[name].append(numbers[kept])
        self.rows += [chunk.lines[row] for row in kept]
        for name, place in self._points.items():
            self._take_point(name, {cells[place].strip() for cells in chunk.texts(kept)}, path)
        if self._club is not None:
            self._clubs += [cells[self._club].strip() for cells in chunk.texts(kept)]
        if self._player is not None:
            self._players += [cells[self._player].strip() for cells in chunk.texts(kept)]

    def _take_point(self, name: str, told: set[str], path: str) -> None:
        """Take where club data was taken, which must be the same for all shots."""
        told |= {self._taken[name]} if name in self._taken else set()
        if len(told) > 1 or not told <= set(POINTS[name]):
            held = ", ".join(shortened(each, 40) for each in sorted(told)[:SHOWN])
            allowed = f"one of {', '.join(POINTS[name])}, the same for all shots"
            raise FileError(path, None, f"the column {name!r} holds {held}; it must be {allowed}", name)
        if told:
            self._taken[name] = told.pop()

    def shots(self, path: str, rejected: tuple[RejectedRow, ...]) -> RecordedShots:
        """Return all rows taken."""
        values = {name: np.concatenate(parts) for name, parts in self._values.items()}
        hand = values.pop(HAND, None)
        found = without_impossible(values)
        every = RecordedShots(
            deliveries={name: each for name, each in found.columns.items() if name in inputs()},
            launches={name: each for name, each in found.columns.items() if name not in inputs()},
            clubs=np.array(self._clubs, dtype=object) if self._club is not None else None,
            players=np.array(self._players, dtype=object) if self._player is not None else None,
            hand=None if hand is None else np.array([SIDES[each] for each in hand], dtype=object),
            rows=np.array(self.rows, dtype=np.int64),
            source=path,
            format="clubface",
            rejected=rejected,
            notes=(*self._layout.notes, *found.notes),
            **self._taken,  # pyright: ignore[reportArgumentType]
        )
        return without_emptied(every, found.emptied)


def _numbers(chunk: Chunk, column: Column) -> tuple[NDArray[Any], dict[int, str]]:
    """Return the SI values of a column, NaN where a cell is empty, and for cells that hold no number, why."""
    values, bad = chunk.numbers(column)
    if bad:
        cells = chunk.texts(list(bad))
        empty = {row for row, cell in zip(bad, cells, strict=True) if is_missing(cell[column.place])}
        bad = {row: reason for row, reason in bad.items() if column.quantity == HAND or row not in empty}
    if not len(values):
        return np.empty(0), bad
    return to_si(values, column.unit), bad
