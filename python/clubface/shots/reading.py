"""Reading a launch monitor's file: recognise its format by its columns, read its rows, return its shots."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain, islice, zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.equipment.described import HANDS
from clubface.errors import FileError, InputError, UnknownNameError, shortened
from clubface.results.notes import Note, note
from clubface.shots.columns import is_units_row
from clubface.shots.formats import Format, Mapped, mapping_of
from clubface.shots.monitor_file import Session, SessionReader
from clubface.shots.monitors import FORMATS, TABLE
from clubface.shots.plausibility import (
    with_face_and_path,
    without_any_sentinels,
    without_contradictions,
    without_impossible,
    without_sentinels,
    wrong_unit,
)
from clubface.shots.recorded import MEASURED_AT, SIDES, TEXTS, RecordedShots, RejectedRow, iso_dates, join_sessions
from clubface.shots.signs import suspected_signs
from clubface.shots.tables.cells import Decimals, Reject, decimals_of, doubt, quoted_cell
from clubface.shots.tables.headings import check_units, heading, listed, near_name, shot_words
from clubface.shots.tables.parquet import ENDINGS as PARQUET, ParquetReader
from clubface.shots.tables.row_source import DECIMAL_ROWS, Row, RowSource, open_rows
from clubface.simulation.results import inputs
from clubface.support.checks import check_choice

if TYPE_CHECKING:
    from clubface.shots.reference_points import ClubByName

TELLING = frozenset({"speed", "ball_speed", "launch"})
"""Quantities at least one of which is in every table of shots."""
FEWEST_KNOWN = 2
"""Number of known headings that make a row the header of a layout requested by name."""


def detected(path: str, head: Sequence[Row | Reject]) -> Format:
    """Return the layout that knows most columns of a header among the first rows; ``TABLE`` for common names alone."""
    rows = [row for row in head if not isinstance(row, Reject)]
    if not rows:
        raise _no_header(path, head)
    for cells, _, _ in rows:
        known = {name: _known_headings(each, cells) for name, each in FORMATS.items() if _has_marked_row(each, [cells])}
        if known:
            fitting = [name for name, count in known.items() if count == max(known.values())]
            if len(fitting) > 1:
                message = f"this may be a file of {' or '.join(fitting)}; give the format, such as {fitting[0]}"
                raise FileError(path, None, message)
            return FORMATS[fitting[0]]
    if any(TABLE.is_header(cells) and TELLING & _quantities(TABLE, cells) for cells, _, _ in rows):
        return TABLE
    widest, line, _ = max(rows, key=lambda row: sum(bool(cell.strip()) for cell in row[0]))
    counts = {name: _known_headings(each, widest) for name, each in FORMATS.items()}
    alike = [name for name, count in counts.items() if count == max(counts.values()) >= FEWEST_KNOWN]
    advice = f", or the format whose columns they are, perhaps {' or '.join(alike)}" if alike else ""
    raise FileError(path, line, f"the layout is not one of {', '.join(FORMATS)}; {listed([*map(str.strip, widest)])}. "
                                f"Name the columns in a mapping file{advice}")  # fmt: skip


def asked_for(layout: Format, head: Sequence[Row | Reject]) -> Format:
    """Return the requested layout, adapted to the columns of the file.

    The header is the row with most of the layout's columns; without two of them the layout is returned unchanged.
    """
    rows = [row[0] for row in head if not isinstance(row, Reject)]
    header = max(rows, key=lambda cells: _known_headings(layout, cells), default=())
    if _has_marked_row(layout, rows) or _known_headings(layout, header) < FEWEST_KNOWN:
        return layout
    columns = tuple(name for each in header if (name := heading(each).name) in layout.names)
    return replace(layout, marks=(*layout.marks, columns))


def is_foreign(layout: Format, cells: Sequence[str]) -> bool:
    """Return whether a row is the header of a table that a layout cannot read."""
    names = {layout.heading(each).name for each in cells}
    if any(each.is_marked(names) for each in FORMATS.values() if each.name != layout.name):
        return not layout.is_marked(names)
    known = len(_quantities(layout, cells))
    return TABLE.is_header(cells) and known < FEWEST_KNOWN <= len(_quantities(TABLE, cells))


def _quantities(layout: Format, cells: Sequence[str]) -> set[str]:
    """Return the quantities whose headings are among the cells of a row."""
    return {layout.names[name][0] for each in cells if (name := layout.heading(each).name) in layout.names}


def _has_marked_row(layout: Format, rows: Sequence[Sequence[str]]) -> bool:
    """Return whether one of the rows is the header of a layout."""
    return any(layout.is_marked({heading(each).name for each in cells}) for cells in rows)


def _known_headings(layout: Format, cells: Sequence[str]) -> int:
    """Return the number of cells in a row that are headings of a layout."""
    return len({heading(each).name for each in cells} & set(layout.own_names))


HEAD_ROWS = 30
"""Number of rows searched for the header."""
COUNTED = 10
"""Maximum number of different column values listed in a note."""
PARQUET_ROWS = 65536
"""Number of rows of a Parquet file read at a time."""
SHOWN = 3
"""Maximum number of reasons listed in an error."""


def read(
    path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    format: str | None = None,
    hand: str | None = None,
    mapping: str | os.PathLike[str] | None = None,
    *,
    units: Mapping[str, str] | None = None,
    club: ClubByName | None = None,
) -> RecordedShots:
    """Read a launch monitor's file: deliveries and launches in SI units, with clubface's signs.

    Path, face angle, azimuth, sidespin and all other sideways quantities are positive to the right for either hand,
    impact offsets towards toe and crown, whatever the file's own convention.

    Parameters
    ----------
    path
        The file: CSV with commas, semicolons, tabs or bars between cells, an Excel workbook, or a clubface table.
        Several files are sessions, see :func:`clubface.shots.recorded.join_sessions`.
    format
        Name of a layout, see ``FORMATS``; by default recognised from the columns.
    hand
        ``"right"`` or ``"left"``, for all shots; by default taken from the file, if it tells.
    mapping
        A TOML file that names the columns of any other CSV, see :mod:`clubface.shots.formats`.
    units
        Units of columns without one in the file, by quantity or dimension: ``{"speed": "km/h", "carry": "m"}``.
    club
        The club, or a mapping from club names in the file to clubs. With it, velocities measured at the face centre are
        converted to the centre of gravity, and face angles measured at the impact point to the face centre, see
        :func:`refer`. Without it they stay as measured, with a note.

    Raises
    ------
    FileError
        The file cannot be read, its layout is unknown, or it contains no shot.
    """
    if hand is not None:
        check_choice("hand", hand, SIDES.values())
    given_units = check_units(units or {})
    if format is not None and mapping is not None:
        raise InputError("format", format, "leave it out, since the mapping says how the file is laid out")
    if format is not None and format not in (*FORMATS, TABLE.name):
        raise UnknownNameError("format", format, (*FORMATS, TABLE.name))
    mapped = mapping_of(mapping) if mapping is not None else None
    paths = [path] if isinstance(path, str | os.PathLike) else list(path)
    if not paths:
        raise InputError("path", path, "at least one file")
    sessions = [_read(Path(each), format, mapped, hand, given_units) for each in paths]
    sessions = [each.with_notes(*suspected_signs(each)) for each in sessions]
    if club is not None:
        from clubface.shots.reference_points import refer

        sessions = [refer(each, club) for each in sessions]
    return join_sessions(sessions)


def read_shots(path: str | os.PathLike[str], *, units: Mapping[str, str] | None = None) -> RecordedShots:
    """Read recorded shots from a CSV or Parquet file with clubface's columns.

    Columns are recognised by name and carry their unit, as for :func:`predict`: ``club_speed_mph``, ``attack [deg]``,
    ``ball_speed_mph``, ``launch_deg``, ``azimuth_deg``, ``backspin_rpm``, ``sidespin_rpm``, ``total_spin_rpm``,
    ``spin_axis_deg``, ``carry_yd`` and so on; ``club`` and ``player`` hold names, ``hand`` is right or left. An empty
    cell means not measured. ``units`` gives units of columns without one, by quantity or dimension, such as ``{"speed":
    "mph"}``; otherwise such columns are refused.

    Raises a :class:`FileError` if the file cannot be read (the message names the line), is empty, has no delivery or
    launch column, has a unit that is missing or of the wrong dimension, or has no usable row.
    """
    return _read(Path(path), TABLE.name, None, None, check_units(units or {}))


def _read(
    path: Path, format: str | None, mapped: Mapped | None, hand: str | None, units: Mapping[str, str]
) -> RecordedShots:
    """Return the shots of a file as measured, without impossible values."""
    _refuse_no_table(path)
    sign = float("nan") if hand is None else float(HANDS[hand])
    if path.suffix.lower() in PARQUET and mapped is None:
        table = ParquetReader(path)
        try:
            reader = SessionReader(str(path), TABLE, sign, units, decimal_comma=False)
            session = reader.read_chunks(table.headings, table.chunks(PARQUET_ROWS, 0))
        finally:
            table.close()
        return _shots(session, str(path), TABLE)
    rows = open_rows(path, head_lines=HEAD_ROWS, delimiter=mapped.delimiter if mapped else None)
    try:
        every = iter(rows.next, None)
        head = list(islice(every, HEAD_ROWS))
        if mapped:
            layout = mapped.layout
        elif format is not None:
            layout = TABLE if format == TABLE.name else asked_for(FORMATS[format], head)
        else:
            layout = detected(str(path), head)
        session = _session(rows, layout, mapped, sign, units, chain(head, every))
    finally:
        rows.close()
    shots = _shots(session, str(path), layout, rows.notes)
    names = [row[0] for row in head if not isinstance(row, Reject)]
    others = [name for name, each in FORMATS.items() if format is not None and _has_marked_row(each, names)]
    if others and format not in others:
        return replace(shots, notes=(note("read-as-asked", format=format, formats=others), *shots.notes))
    return shots


def is_plain_table(path: str | os.PathLike[str]) -> bool:
    """Return whether a file is a plain table: not from a launch monitor, with the header, including units, in row 1."""
    source = Path(path)
    _refuse_no_table(source)
    if source.suffix.lower() in PARQUET:
        return True
    rows = open_rows(source, head_lines=HEAD_ROWS)
    try:
        head = [each for each in islice(iter(rows.next, None), HEAD_ROWS) if not isinstance(each, Reject)]
        if detected(str(path), head) is not TABLE:
            return False
        return TABLE.is_header(head[0][0]) and not (len(head) > 1 and is_units_row(head[1][0]))
    except FileError:
        return True
    finally:
        rows.close()


def _refuse_no_table(path: Path) -> None:
    """Raise an error with advice for a file of another kind."""
    if path.suffix.lower() == ".c3d":
        raise FileError(str(path), None, "this is motion capture; make a table of it with clubface capture read")


def _session(
    rows: RowSource,
    layout: Format,
    mapped: Mapped | None,
    sign: float,
    units: Mapping[str, str],
    every: Iterator[Row | Reject],
) -> Session:
    """Return the contents of a file with a known layout, after deciding how its numbers are written."""
    path, sample = rows.path, list(islice(every, DECIMAL_ROWS))
    decimals = decimals_of(_cells_with_quantities(layout, sample), rows.delimiter)
    if mapped and mapped.decimal_comma is not None:
        decimals = Decimals(mapped.decimal_comma)
    reader = SessionReader(path, layout, sign, units, decimals.comma, sample, partial(is_foreign, layout))
    session = reader.read(chain(sample, every))
    session.doubtful_number = decimals.doubtful
    if not reader.has_header:
        first = next((row for row in sample if not isinstance(row, Reject)), None)
        if first is None:
            raise _no_header(path, sample)
        if layout is TABLE:
            headings = listed([each.strip() for each in first[0]])
            message = f"no column is of a delivery or a launch, such as ball_speed_mph; {headings}"
            raise FileError(path, first[1], message)
        groups = " or ".join(", ".join(group) for group in layout.marks)
        raise FileError(path, None, f"this is not a {layout.title} file: no row names the columns {groups}")
    return session


def _cells_with_quantities(layout: Format, rows: Sequence[Row | Reject]) -> Iterator[tuple[str, str | None]]:
    """Yield the cells of some rows, each with the quantity of its column, or None."""
    quantities: list[str | None] = []
    for row in rows:
        if isinstance(row, Reject):
            continue
        cells = row[0]
        if layout.is_header(cells):
            quantities = [layout.names.get(layout.heading(each).name, (None, 0))[0] for each in cells]
        yield from zip_longest(cells, quantities[: len(cells)])


def _no_header(path: str, rows: Sequence[Row | Reject]) -> FileError:
    """Return the error for a file without a readable row."""
    reject = next((row for row in rows if isinstance(row, Reject)), None)
    return FileError(path, reject.line, reject.reason) if reject else FileError(path, 1, "the file is empty")


def _shots(session: Session, path: str, layout: Format, of_file: Sequence[Note] = ()) -> RecordedShots:
    """Return the shots of a session, without impossible values."""
    tables = session.tables
    rejected = tuple(sorted(session.rejected, key=lambda each: each.line or 0))
    refuse_empty(path, sum(len(each.lines) for each in tables), rejected)
    columns = {
        name: np.concatenate([each.values.get(name, np.full(len(each.lines), np.nan)) for each in tables])
        for name in dict.fromkeys(name for each in tables for name in each.values)
    }
    lines = [line for each in tables for line in each.lines]
    columns, sentinels = without_sentinels(columns, session.units)
    columns, turned = with_face_and_path(columns, lines)
    columns = {name: values for name, values in columns.items() if not np.isnan(values).all()}
    if (wrong := wrong_unit(without_any_sentinels(columns, session.units), session.units)) is not None:
        raise FileError(path, session.header_line, wrong)
    texts = {key: [text for each in tables for text in each.texts[key]] for key in tables[0].texts}
    texts["date"], date_note = iso_dates(texts["date"])
    known: dict[str, Any] = {
        name: np.array(texts[key], dtype=object)
        for name, key in TEXTS.items()
        if key in texts and (any(texts[key]) if key in ("date", "file") else key in session.named)
    }
    hands = np.concatenate([each.hands for each in tables])
    if not np.isnan(hands).any():
        known["hand"] = np.array([SIDES[each] for each in hands], dtype=object)
    agreeing, contradiction = without_contradictions(columns, known.get("clubs"), lines)
    cleaned, impossible = without_impossible(agreeing)
    notes = (*_notes(session, layout, set(columns), len(lines), of_file), *sentinels, turned, *impossible,
             contradiction, date_note)  # fmt: skip
    every = RecordedShots(
        deliveries={name: each for name, each in cleaned.items() if name in inputs()},
        launches={name: each for name, each in cleaned.items() if name not in inputs()},
        **known,
        rows=np.array(lines, dtype=np.int64),
        source=path,
        format=layout.name,
        rejected=rejected,
        notes=tuple(each for each in notes if each is not None),
        speed_at=session.points.get("speed_at", layout.speed_at),
        face_at=session.points.get("face_at", layout.face_at),
    )
    emptied = np.all([np.ones(len(lines), bool), *(np.isnan(each) for each in cleaned.values())], axis=0)
    if not emptied.any():
        return every
    lost = [RejectedRow(lines[row], "nothing was measured that a shot can have") for row in np.flatnonzero(emptied)]
    rejected = tuple(sorted((*rejected, *lost), key=lambda each: each.line or 0))
    refuse_empty(path, len(lines) - len(lost), rejected)
    return replace(every.select(~emptied), rejected=rejected)


def refuse_empty(path: str, shots: int, rejected: tuple[RejectedRow, ...]) -> None:
    """Raise an error for a file without any shot, with the reasons for rejected rows."""
    if not shots:
        unit_of = "row" if path.lower().endswith(PARQUET) else "line"
        reasons = "; ".join(f"{unit_of} {each.line}: {each.reason}" for each in rejected[:SHOWN])
        more = f" (and {len(rejected) - SHOWN} more)" if len(rejected) > SHOWN else ""
        raise FileError(path, None, f"no shot can be used: {reasons}{more}" if rejected else "there are no shots")


def _notes(session: Session, layout: Format, measured: set[str], shots: int, of_file: Sequence[Note]) -> Iterator[Note]:
    yield from (note(f"monitor-{remark}") for name, remark in layout.notes.items() if name in measured)
    if layout is not TABLE:
        for point, (what, quantities) in MEASURED_AT.items():
            if measured & quantities:
                yield note(f"measured-{what}-at-{getattr(layout, point)}")
    if session.guessed_hand:
        yield note("hand-assumed")
    if session.assumed:
        yield note("units-assumed", columns={shortened(name, 40): each for name, each in session.assumed.items()})
    if session.unused:
        yield note("brackets-without-unit", columns=[shortened(each, 40) for each in session.unused])
    yield from session.remarks
    words = shot_words().names
    lacking = {name for name, meant in words.items() if meant not in measured}
    for each in session.unread:
        if (near := near_name(heading(each).bare, lacking)) is not None:
            yield note("column-misspelled", column=shortened(each, 80), near=near)
    if session.unread:
        yield note("columns-not-read", columns=[shortened(each, 40) for each in session.unread])
    for name, counts in session.counts.items():
        some = {shortened(value, 40): count for value, count in islice(counts.items(), COUNTED)}
        yield note("column-values", column=shortened(name, 40), counts=some)
    for name, (count, cell) in session.unreadable.items():
        yield note("cells-without-number", column=shortened(name, 40), cells=count, example=quoted_cell(cell))
    if session.doubtful_number:
        yield doubt(session.doubtful_number)
    if session.summaries:
        yield note("summary-rows", rows=session.summaries)
    if session.without_club:
        yield note("without-club-data", without=session.without_club, shots=shots)
    yield from of_file
