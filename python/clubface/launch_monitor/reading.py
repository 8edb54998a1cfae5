"""Reading the file of a launch monitor: find its layout, go through its rows, and make shots of them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, islice
from pathlib import Path
from typing import Any

import numpy as np

from clubface.equipment.described import HANDS
from clubface.errors import FileError, InputError, UnknownNameError, shortened
from clubface.launch_monitor.cells import FACE_TO_PATH
from clubface.launch_monitor.detection import OWN, asked_for, detected, others
from clubface.launch_monitor.formats import POINTS, Format
from clubface.launch_monitor.mapping import Mapped, mapping_of
from clubface.launch_monitor.registry import FORMATS
from clubface.launch_monitor.rows import Session, SessionReader, Shot
from clubface.recorded.file import read_shots, refuse_empty, without_emptied
from clubface.recorded.possible import without_impossible
from clubface.recorded.shots import SIDES, RecordedShots
from clubface.recorded.signs import suspected_signs
from clubface.simulation.quantities import inputs
from clubface.support.checks import check_choice
from clubface.tables.cells import uses_decimal_comma
from clubface.tables.csv_rows import DECIMAL_ROWS, CsvRows, Row
from clubface.tables.headings import shot_words
from clubface.tables.parquet import ENDINGS as PARQUET
from clubface.tables.rows import Reject
from clubface.units import unit

HEAD_ROWS = 30
"""Rows among which the header must be."""
TOLD = 10
"""Different values of a column that a note counts."""


def read(
    path: str | os.PathLike[str],
    format: str | None = None,
    hand: str | None = None,
    mapping: str | os.PathLike[str] | None = None,
    *,
    units: Mapping[str, str] | None = None,
    club: Any = None,
) -> RecordedShots:
    """Read the file of a launch monitor: deliveries and launches in SI units, with the signs of clubface.

    Path, face angle, azimuth, sidespin and everything else across the target line are positive to the right for either
    hand. Impact offsets are positive towards the toe and the crown. The convention of the file does not matter.

    Parameters
    ----------
    path
        The file: CSV in UTF-8 or Windows-1252, with commas, semicolons or tabs; or a table with clubface's own columns.
    format
        The name of a layout, see ``FORMATS``. If left out, it is recognised by its columns.
    hand
        ``"right"`` or ``"left"``: the hand for every shot. If left out, it is what the file says, if anything.
    mapping
        A TOML file that names the columns of any other CSV, see :mod:`clubface.launch_monitor.mapping`.
    units
        Units of columns for which the file names none, by quantity or dimension: ``{"speed": "km/h", "carry": "m"}``.
    club
        The club, or a mapping from the names of clubs in the file to clubs. With it, velocities measured at the face
        centre are converted to the centre of gravity, and face angles measured at the point of contact to the face
        centre, see :func:`refer`. Without it they stay as measured, and a note says so.

    Returns
    -------
    RecordedShots
        The shots. ``rejected`` holds the rows that gave no shot, each with its line and reason, and ``notes`` holds
        what you should know.

    Raises
    ------
    FileError
        The file cannot be read, its layout is unknown, or it holds no shot.
    """
    if hand is not None:
        check_choice("hand", hand, SIDES.values())
    told_units = _units(units or {})
    if format is not None and mapping is not None:
        raise InputError("format", format, "leave it out, since the mapping says how the file is laid out")
    if format is not None and format not in (*FORMATS, OWN):
        raise UnknownNameError("format", format, (*FORMATS, OWN))
    source = Path(path)
    mapped = mapping_of(mapping) if mapping is not None else None
    _refuse_no_table(source)
    if mapped is None and (format == OWN or source.suffix.lower() in PARQUET):
        return _own(path, hand, told_units, club)
    rows = CsvRows(source, any_encoding=True, head_lines=HEAD_ROWS, delimiter=mapped.delimiter if mapped else None)
    try:
        every = _rows(rows)
        head = list(islice(every, HEAD_ROWS))
        layout = mapped.layout if mapped else asked_for(FORMATS[format], head) if format else detected(str(path), head)
        if layout is None:
            return _own(path, hand, told_units, club)
        session = _session(str(path), layout, mapped, hand, told_units, head, every, rows.delimiter)
    finally:
        rows.close()
    refuse_empty(str(path), len(session.shots), tuple(session.rejected))
    shots = _laid_out(session, str(path), layout, rows.other_encoding)
    if format is not None and (other := others(layout, head)):
        note = f"read as {format}, as asked, though the columns are those of {' and '.join(other)}"
        shots = replace(shots, notes=(note, *shots.notes))
    return _referred(shots, club)


def is_monitors(path: str | os.PathLike[str]) -> bool:
    """Tell whether a file is one of a launch monitor: CSV with the columns of a known layout."""
    source = Path(path)
    _refuse_no_table(source)
    if source.suffix.lower() in PARQUET:
        return False
    rows = CsvRows(source, any_encoding=True, head_lines=HEAD_ROWS)
    try:
        return detected(str(path), list(islice(_rows(rows), HEAD_ROWS))) is not None
    except FileError:
        return False
    finally:
        rows.close()


def _refuse_no_table(path: Path) -> None:
    """Say of files that people have, and that are no tables, what to do with them."""
    ending = path.suffix.lower()
    if ending == ".c3d":
        raise FileError(str(path), None, "this is motion capture; clubface capture read makes a table of it")
    if ending in (".xlsx", ".xls", ".ods", ".numbers"):
        raise FileError(str(path), None, "this is a spreadsheet; save it as CSV")


def _own(path: str | os.PathLike[str], hand: str | None, units: Mapping[str, str], club: Any) -> RecordedShots:
    """Return the shots of a table of clubface."""
    return _referred(_with_hand(read_shots(path, units=units), hand), club)


def _referred(shots: RecordedShots, club: Any) -> RecordedShots:
    """Return the shots with notes on signs, referred to the points of a club where one is given."""
    shots = replace(shots, notes=(*shots.notes, *suspected_signs(shots)))
    if club is None:
        return shots
    from clubface.launch_monitor.reference_points import refer

    return refer(shots, club)


def _rows(rows: CsvRows) -> Iterator[Row | Reject]:
    while (row := rows.next()) is not None:
        yield row


def _session(
    path: str,
    layout: Format,
    mapped: Mapped | None,
    hand: str | None,
    units: Mapping[str, str],
    head: Sequence[Row | Reject],
    rest: Iterable[Row | Reject],
    delimiter: str,
) -> Session:
    sample = [*head, *islice(rest, DECIMAL_ROWS - len(head))]
    comma = mapped.decimal_comma if mapped else None
    if comma is None:
        cells = [cell for row in sample if not isinstance(row, Reject) for cell in row[0]]
        comma = uses_decimal_comma(cells, delimiter)
    side = float(HANDS[hand]) if hand is not None else float("nan")
    reader = SessionReader(path, layout, side, units, comma, sample)
    session = reader.read(chain(sample, rest))
    if not reader.found_header:
        first = next((row for row in sample if not isinstance(row, Reject)), None)
        if first is None:
            raise FileError(path, 1, "the file is empty")
        groups = " or ".join(", ".join(group) for group in layout.marks)
        raise FileError(path, None, f"this is no {layout.title} file: no row names the columns {groups}")
    return session


def _laid_out(session: Session, path: str, layout: Format, other_encoding: bool) -> RecordedShots:
    shots = session.shots
    for shot in shots:
        to_path = shot.values.pop(FACE_TO_PATH, None)
        if to_path is not None and "path" in shot.values:
            shot.values.setdefault("face", shot.values["path"] + to_path)
    names = [name for name in (*inputs(), *shot_words().dimensions) if any(name in shot.values for shot in shots)]
    columns = {name: np.array([shot.values.get(name, np.nan) for shot in shots]) for name in dict.fromkeys(names)}
    found = without_impossible(columns)
    every = RecordedShots(
        deliveries={name: values for name, values in found.columns.items() if name in inputs()},
        launches={name: values for name, values in found.columns.items() if name not in inputs()},
        clubs=np.array([shot.club for shot in shots], dtype=object) if session.names_clubs else None,
        players=np.array([shot.player for shot in shots], dtype=object) if session.names_players else None,
        hand=_hands(shots),
        rows=np.array([shot.line for shot in shots], dtype=np.int64),
        source=path,
        format=layout.name,
        rejected=tuple(session.rejected),
        notes=(*_notes(session, layout, other_encoding), *found.notes),
        speed_at=layout.speed_at,
        face_at=layout.face_at,
    )
    return without_emptied(every, found.emptied)


def _hands(shots: Sequence[Shot]) -> Any:
    if any(shot.hand != shot.hand for shot in shots):
        return None
    return np.array([SIDES[shot.hand] for shot in shots], dtype=object)


def _notes(session: Session, layout: Format, other_encoding: bool) -> Iterator[str]:
    measured = {name for shot in session.shots for name in shot.values}
    yield from (text for name, text in layout.notes.items() if name in measured)
    if measured & {"speed", "attack", "path"}:
        yield f"club speed, attack angle and path were taken at {POINTS[layout.speed_at]}"
    if measured & {"loft", "face"}:
        yield f"dynamic loft and face angle were taken at {POINTS[layout.face_at]}"
    if session.guessed_hand:
        yield "the file does not say the hand: taken as right-handed; give the hand, left, if the player is not"
    if session.assumed:
        told = ", ".join(f"{name} in {symbol}" for name, symbol in session.assumed.items())
        yield f"the file does not name these units, which were assumed: {told}"
    if session.unused:
        unused = ", ".join(shortened(each, 40) for each in islice(session.unused, TOLD))
        yield f"not used, since what is in brackets is no unit: {unused}"
    for name, counts in session.told.items():
        shown = [f"{count} {shortened(value, 40)}" for value, count in islice(counts.items(), TOLD)]
        yield f"{shortened(name, 40)}: {', '.join(shown)}" + ", ..." * (len(counts) > TOLD)
    if session.summaries:
        yield f"rows of averages and deviations that were passed over: {session.summaries}"
    if session.without_club:
        yield f"shots without club data, for which the file holds no club speed that can be: {session.without_club}"
    if other_encoding:
        yield "the file is not UTF-8: read as Windows-1252"


def _with_hand(shots: RecordedShots, hand: str | None) -> RecordedShots:
    return shots if hand is None else replace(shots, hand=np.array([hand] * len(shots), dtype=object))


def _units(units: Mapping[str, str]) -> dict[str, str]:
    """Return units by quantity or dimension, each checked."""
    dimensions = shot_words().dimensions
    known = [*dict.fromkeys(dimensions.values()), *dimensions]
    for name, symbol in units.items():
        check_choice("quantity or dimension", name, known)
        unit(symbol, name=f"the unit of {name}", dimension=dimensions.get(name, name))
    return dict(units)
