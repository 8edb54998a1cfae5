"""Reading the rows of a file of recorded shots: headers, units, summaries and shots, and values by column."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite, nan
from typing import Any, NamedTuple

import numpy as np

from clubface.errors import FileError, shortened
from clubface.results.notes import Note, note
from clubface.shots.club_names import club_kind, is_club_name
from clubface.shots.columns import Columns, columns_of, is_units_row
from clubface.shots.formats import Format
from clubface.shots.plausibility import can_be
from clubface.shots.recorded import RejectedRow, date_among
from clubface.shots.summary_rows import summary_rows
from clubface.shots.tables.cells import (
    LARGE,
    NUMBER,
    PLAIN,
    CellError,
    Chunk,
    Reject,
    all_numbers,
    hand_of,
    is_missing,
    may_be_thousands,
    quoted_cell,
    ragged_reason,
    reading,
)
from clubface.shots.tables.headings import FACE_TO_PATH, MIRRORED, POINTS, WORLD, FileColumn, plain, squeezed
from clubface.shots.tables.row_source import Row
from clubface.simulation.results import inputs
from clubface.support.arrays import Floats
from clubface.units import size, to_si, unit

DERIVED = frozenset(
    {"smash", FACE_TO_PATH, "apex", "landing_angle", "landing_speed", "flight_time", "total", "total_side"}
)
"""Quantities that monitors derive from others; an unreadable cell loses only its own value, not the shot."""
BLOCK_ROWS = 16384
"""Number of rows turned into shots at a time."""
JUDGED = 200
"""Number of cells inspected to find out whether an unused column is numeric."""
HEADINGS = 2
"""Number of known headings that make a later row without numbers a new header."""
SHOWN = 3
"""Maximum number of values listed in an error."""
SAME = 1e-9
"""Relative difference up to which two cells have the same value."""
_NUMERIC = frozenset("0123456789+-.,−")


class ShotBlock(NamedTuple):
    """Consecutive shots, in SI units; sides are in world terms."""

    lines: list[int]  # line at which each row begins
    values: dict[str, Floats]  # by quantity; NaN where not measured
    hands: Floats  # +1 for right, -1 for left, NaN if unknown
    texts: dict[str, list[str]]  # "club", "player", "date" and "file" as in the file, or ""


@dataclass
class Session:
    """The contents of a file."""

    tables: list[ShotBlock] = field(default_factory=list)  # the shots of each part of the file
    rejected: list[RejectedRow] = field(default_factory=list)
    summaries: int = 0  # number of rows of averages and the like, which are left out
    without_club: int = 0  # number of shots without measured club data
    counts: dict[str, Counter[str]] = field(default_factory=dict)  # counts of values in columns listed in a note
    assumed: dict[str, str] = field(default_factory=dict)  # assumed units by heading
    unused: dict[str, None] = field(default_factory=dict)  # headings not used because their brackets hold words
    remarks: dict[Note, None] = field(default_factory=dict)  # other remarks on the columns
    unread: dict[str, None] = field(default_factory=dict)  # headings of numeric columns without a known quantity
    unreadable: dict[str, tuple[int, str]] = field(default_factory=dict)  # cells without number: count and example
    points: dict[str, str] = field(default_factory=dict)  # reference points of club data, from columns
    units: dict[str, FileColumn] = field(default_factory=dict)  # the first column of each quantity
    header_line: int | None = None  # line of the first header
    guessed_hand: bool = False  # whether club terms were read as right-handed because the hand is unknown
    doubtful_number: str = ""  # a number whose decimal mark may separate thousands
    named: set[str] = field(default_factory=set)  # which of "club" and "player" the file names


class _Faults:
    """Faults of some rows: reasons for rejection, and unreadable cells of derived quantities by heading."""

    def __init__(self) -> None:
        self.reasons: dict[int, str] = {}
        self.unreadable: dict[str, dict[int, str]] = {}

    @property
    def rows(self) -> set[int]:
        """The rows with any fault."""
        return {*self.reasons, *(row for cells in self.unreadable.values() for row in cells)}

    def reject(self, row: int, reason: str) -> None:
        """Reject a row for a reason, unless it is rejected already."""
        self.reasons.setdefault(row, reason)

    def add(self, row: int, cell: str, what: str, column: FileColumn) -> None:
        """Add an unreadable cell; it rejects the row unless the quantity is derived."""
        if column.quantity in DERIVED:
            self.unreadable.setdefault(column.heading, {})[row] = cell.strip()
        else:
            self.reject(row, f"{column.heading}: {quoted_cell(cell.strip())} is {what}")


class SessionReader:
    """Reads the rows of a file with a known layout.

    ``hand`` is +1 or -1 for all shots, or NaN to take it from the file. The first rows, ``sample``, may contain units
    in their cells. ``is_foreign`` tells whether a row is the header of a table that the layout cannot read.
    """

    def __init__(
        self,
        path: str,
        layout: Format,
        hand: float,
        units: Mapping[str, str],
        decimal_comma: bool,
        sample: Sequence[Row | Reject] = (),
        is_foreign: Callable[[Sequence[str]], bool] = lambda cells: False,
    ) -> None:
        self._path = path
        self._sample = [row for row in sample if not isinstance(row, Reject)]
        self._layout = layout
        self._hand = hand
        self._units = units
        self._decimal_comma = decimal_comma
        self._is_foreign = is_foreign
        self._columns: Columns | None = None
        self._header: Sequence[str] = ()
        self._header_line: int | None = 0
        self._block: list[Sequence[str]] = []
        self._lines: list[int] = []
        headings = {"date": layout.date, "player": layout.player, "club": layout.club}
        self._keys = {squeezed(plain(each)): key for key, names in headings.items() for each in names}
        self._title = re.compile(layout.title_of_player) if layout.title_of_player else None
        self._titles = {"club": "", "player": "", "date": ""}  # titles for the shots below, for lack of a column
        self._above: Sequence[str] = ()
        self.session = Session()

    @property
    def has_header(self) -> bool:
        """Whether a header has been found."""
        return bool(self._header)

    def read(self, rows: Iterable[Row | Reject]) -> Session:
        """Return the contents of the rows."""
        for row in rows:
            if isinstance(row, Reject):
                self._reject(row.line, row.reason)
                continue
            cells, line, _ = row
            columns = self._columns
            # Fast path: most rows are shots, which begin with a number that is not a title such as "7 Iron".
            if (
                columns
                and len(cells) == columns.width
                and (first := cells[columns.first].lstrip())[:1] in _NUMERIC
                and (columns.texts["club"] or not first[-1:].isalpha())
            ):
                self._block.append(cells)
                self._lines.append(line)
                if len(self._lines) >= BLOCK_ROWS:
                    self._end_block()
            elif any(cell.strip() for cell in cells):
                self._read_other(cells, line)
        self._end_block()
        return self.session

    def read_chunks(self, headings: Sequence[str], chunks: Iterable[Chunk]) -> Session:
        """Return the contents of a table given in chunks, whose columns are texts or numbers."""
        self._begin_table(headings, None)
        self._choose_columns(None, [])
        for chunk in chunks:
            self._take([chunk.cells(place) for place in range(len(headings))], list(chunk.lines))
        return self.session

    def _note_unread(self, cells: Sequence[Any]) -> None:
        """Record unused numeric columns, judging by the first rows below a header."""
        columns = self._columns
        assert columns is not None
        for place in columns.others:
            column = cells[place]
            shown = self._header[place].strip() or f"column {place + 1}"
            if _is_array(column):
                is_numeric = bool(np.isfinite(column).any())
            else:
                texts = [each for each in column[:JUDGED] if not is_missing(each)]
                is_numeric = 2 * sum(map(_is_measurement, texts)) > len(texts)
            if is_numeric:
                self.session.unread.setdefault(shown, None)

    def _texts(self, cells: Sequence[Any], place: int) -> Sequence[str]:
        """Return the cells of a text column, which may be numbers in a Parquet file."""
        column = cells[place]
        return ["" if each != each else f"{each:.15g}" for each in column] if _is_array(column) else column

    def _read_other(self, cells: Sequence[str], line: int) -> None:
        """Read a row that may not be a shot."""
        if self._take_names(cells):
            return
        if not self._has_numbers(cells):
            if self._is_header(cells):
                self._begin_table(cells, line)
                return
            if self._header and self._is_foreign(cells):
                message = "a table with columns of another kind begins here; save each table as a file of its own"
                raise FileError(self._path, line, message)
            if not self._header or self._title is not None:
                self._take_date(cells)
            first = next((text for cell in cells if (text := cell.strip())), "")
            if self._title is not None and (title := self._title.fullmatch(first)):
                self._take_title("player", title[1])
                return
        if not self._header:
            return
        if self._columns is None:
            units_row = cells if is_units_row(cells) else None
            below = [each for each, at, _ in self._sample if at > (self._header_line or 0)]
            self._choose_columns(units_row, below)
            if units_row is not None:
                return
        elif sum(bool(each.strip()) for each in cells) > 1 and is_units_row(cells):
            self._begin_table(self._header, self._header_line)  # the same columns in other units
            self._choose_columns(cells, [])
            return
        columns = self._columns
        assert columns is not None
        beyond = [cell for cell in cells[columns.width :] if cell.strip()]
        if len(cells) < columns.needed or beyond:
            self._reject(line, ragged_reason(cells, columns.width))
            return
        self._block.append([*cells, *[""] * columns.width][: columns.width])
        self._lines.append(line)

    def _take_date(self, cells: Sequence[str]) -> None:
        """Take a date above a table, if any, for the shots below."""
        if (date := date_among(cells)) is not None:
            self._take_title("date", date)

    def _take_title(self, key: str, text: str) -> None:
        self._end_block()
        self._titles[key] = text
        self.session.named.add(key)

    def _take_names(self, cells: Sequence[str]) -> bool:
        """Take club and player from a row above shots, such as ``Club: Driver``, ``Player,Ann`` or ``7 Iron``.

        The headings may also be in a row above the names.
        """
        above, self._above = self._above, ()
        texts = [each.strip() for each in cells if each.strip()]
        if above:
            taken = [self._take_name(key, cell.strip()) for key, cell in zip(above, cells, strict=False)]
            return any(taken)
        if texts and (colon := re.fullmatch(r"([^:：]+)[:：]\s*(.*)", texts[0])):
            texts = [each for each in (*colon.groups(), *texts[1:]) if each]
        elif len(texts) == 1 and is_club_name(texts[0]):
            return self._take_name("club", texts[0])
        keys = [*map(self._key, texts)]
        if len(texts) > 1 and all(keys):
            self._above = [*map(self._key, cells)]
            return True
        return len(texts) == 2 and not self._layout.is_header(cells) and self._take_name(keys[0], texts[1])

    def _key(self, text: str) -> str:
        """Return "club", "player" or "date" for a heading of that kind, else ""."""
        return self._keys.get(squeezed(plain(text)), "")

    def _take_name(self, key: str, name: str) -> bool:
        """Take a club, player or date for the shots below; return whether the text is one."""
        if key == "date":
            self._take_date((name,))
            return bool(self._titles["date"])
        has_column = self._columns is not None and bool(self._columns.texts[key or "club"])
        if not name or has_column or not (key == "player" or (key == "club" and club_kind(name))):
            return False
        self._take_title(key, name)
        return True

    def _is_header(self, cells: Sequence[str]) -> bool:
        """Return whether a row is a header; after the first, a single word such as "Total" is not enough."""
        if self._layout.is_header(cells) and (not self._header or sum(bool(each.strip()) for each in cells) > 1):
            return True
        known = self._layout.known({self._layout.heading(each).name for each in cells})
        return bool(self._header) and known >= HEADINGS and not self._is_foreign(cells)

    def _has_numbers(self, cells: Sequence[str]) -> bool:
        """Return whether a used column has a number in this row, which then is not a header."""
        if self._columns is None:
            return False
        places = (each.place for used in self._columns.used.values() for each in used)
        return any(place < len(cells) and any(map(str.isdigit, cells[place])) for place in places)

    def _begin_table(self, headings: Sequence[str], line: int | None) -> None:
        self._end_block()
        self._header, self._header_line, self._columns = headings, line, None

    def _choose_columns(self, units_row: Sequence[str] | None, below: Sequence[Sequence[str]]) -> None:
        place = (self._path, self._header_line)
        self._columns = columns = columns_of(self._layout, self._header, units_row, self._units, place, below)
        session = self.session
        if not session.units:
            session.header_line = self._header_line
        for quantity, (first, *_) in columns.used.items():
            session.units.setdefault(quantity, first)
        every = (each for used in columns.used.values() for each in used)
        session.assumed.update({each.heading: each.unit for each in every if each.is_assumed})
        session.unused.update(dict.fromkeys(columns.unused))
        session.remarks.update(dict.fromkeys(columns.remarks))
        session.named |= {key for key, places in columns.texts.items() if places}

    def _reject(self, line: int, reason: str) -> None:
        self.session.rejected.append(RejectedRow(line, reason))

    def _end_block(self) -> None:
        if self._lines:
            block, lines = self._block, self._lines
            self._block, self._lines = [], []
            self._take(list(zip(*block, strict=True)), lines)

    def _take(self, cells: Sequence[Any], lines: list[int]) -> None:
        """Add the shots of some rows below one header, given by column."""
        columns, session = self._columns, self.session
        assert columns is not None
        self._note_unread(cells)
        faults = _Faults()
        large = (cells[each.place] for name in columns.used.keys() & LARGE for each in columns.used[name])
        self._doubtful = may_be_thousands((each for each in large if not _is_array(each)), self._decimal_comma)
        hands = self._hands(cells, len(lines), faults)
        values = {quantity: self._quantity(cells, used, hands, faults) for quantity, used in columns.used.items()}
        labels = {place: each for place, each in columns.labels.items() if not _is_array(cells[place])}
        left_out = summary_rows(labels, cells, values, faults.rows)
        session.summaries += len(left_out)
        for row in np.flatnonzero(values.get("ball_speed", np.empty(0)) == 0.0):
            faults.reject(int(row), "the ball speed is 0: no ball was measured")
        for row in np.flatnonzero(np.logical_and.reduce([np.isnan(each) for each in values.values()])):
            faults.reject(int(row), "nothing was measured: every cell of a delivery or launch is empty")
        reasons = faults.reasons
        for row in sorted(reasons.keys() - left_out):
            self._reject(lines[row], reasons[row])
        for heading, bad in faults.unreadable.items():
            if wrong := [cell for row, cell in bad.items() if row not in left_out and row not in reasons]:
                count, first = session.unreadable.get(heading, (0, wrong[0]))
                session.unreadable[heading] = (count + len(wrong), first)
        gone = left_out | reasons.keys()
        kept = [row for row in range(len(lines)) if row not in gone] if gone else range(len(lines))
        if not kept:
            return
        self._leave_out_clubs(values, kept)
        self._take_points(cells, kept)
        for place in columns.counted:
            texts = self._texts(cells, place)
            shown = Counter(text for row in kept if (text := texts[row].strip()))
            session.counts.setdefault(self._header[place].strip(), Counter()).update(shown)
        texts = {key: self._names(cells, key, kept) for key in ("club", "player", "date", "file")}
        values = {name: each[kept] for name, each in values.items()} if gone else values
        session.tables.append(ShotBlock([lines[row] for row in kept], values, hands[kept], texts))

    def _names(self, cells: Sequence[Any], key: str, kept: Sequence[int]) -> list[str]:
        """Return the texts of a kind in some rows, or the title for all of them if there is no column."""
        assert self._columns is not None
        places = self._columns.texts[key]
        if not places:
            return [self._titles.get(key, "")] * len(kept)
        texts, *others = ([*map(str.strip, self._texts(cells, place))] for place in places)
        for other in others:
            texts = [one or another for one, another in zip(texts, other, strict=True)]
        return [texts[row] for row in kept]

    def _hands(self, cells: Sequence[Any], count: int, faults: _Faults) -> Floats:
        assert self._columns is not None
        hands = np.full(count, self._hand)
        if not np.isnan(self._hand) or not self._columns.texts["hand"]:
            return hands
        (place,) = self._columns.texts["hand"]
        known: dict[str, float] = {}
        for row, cell in enumerate(self._texts(cells, place)):
            try:
                hands[row] = known[cell] = known[cell] if cell in known else hand_of(cell)
            except ValueError:
                text = cell.strip()
                what = f"{quoted_cell(text)} is not a hand" if text else "the cell is empty"
                faults.reject(row, f"{self._header[place].strip()}: {what}")
        return hands

    def _quantity(self, cells: Sequence[Any], used: Sequence[FileColumn], hands: Floats, faults: _Faults) -> Floats:
        """Return the values of a quantity; among several columns, take the most finely rounded value."""
        values = self._numbers(cells[used[0].place], used[0], hands, faults)
        if len(used) == 1:
            return values
        step = _steps(cells[used[0].place], used[0], self._decimal_comma)
        for each in used[1:]:
            other = self._numbers(cells[each.place], each, hands, faults)
            other_step = _steps(cells[each.place], each, self._decimal_comma)
            # With different units both are rounded; with the same unit, one is a rounding of the other.
            coarser = np.where(step == other_step, 0.0, np.maximum(step, other_step))
            rounding = coarser if each.unit == used[0].unit else step + other_step
            apart = np.abs(values - other) > 0.5 * rounding * (1.0 + 1e-6) + SAME * np.abs(values)
            for row in np.flatnonzero(apart):
                pair = [quoted_cell(str(cells[column.place][row]).strip()) for column in (used[0], each)]
                faults.reject(int(row), f"{_both(used[0], each)}: {pair[0]} and {pair[1]}")
            taken = np.isnan(values) | (other_step < step)
            taken &= ~np.isnan(other)
            values, step = np.where(taken, other, values), np.where(taken, other_step, step)
        return values

    def _numbers(self, cells: Any, column: FileColumn, hands: Floats, faults: _Faults) -> Floats:
        """Return the values of a column in SI with clubface's signs; NaN where not measured."""
        if column.quantity in LARGE and self._doubtful and not _is_array(cells):
            for row, cell in enumerate(cells):
                if cell in self._doubtful:
                    what = "a number that may have thousands or decimals; other columns decide for decimals"
                    faults.add(row, cell, what, column)
        quick = cells if _is_array(cells) else all_numbers(cells, self._decimal_comma)
        values = np.full(len(cells), nan) if quick is None else np.where(np.isinf(quick), nan, quick)
        for row in [] if quick is None else np.flatnonzero(np.isinf(quick)):
            faults.add(int(row), f"{cells[row]}", "not a finite number", column)
        other_units: dict[int, str] = {}
        signs = np.full(len(cells), column.side.sign)
        in_club_terms = np.full(len(cells), column.side.frame != WORLD)
        for row, cell in enumerate(cells if quick is None else []):
            if not self._decimal_comma and PLAIN.fullmatch(cell):
                values[row] = float(cell)
                continue
            if cell.rstrip()[-1:] in ("*", "†"):
                cell = cell.rstrip().rstrip("*†")
                self.session.remarks.setdefault(note("marks-read", column=shortened(column.heading, 40)))
            try:
                content = reading(cell, column.quantity, self._decimal_comma, column.side.sign)
            except CellError as error:
                faults.add(row, cell, str(error), column)
                continue
            if content is None:
                continue
            if content.unit is not None and unit(content.unit).dimension != unit(column.unit).dimension:
                faults.add(row, cell, f"not in {column.unit} or another such unit", column)
                continue
            if not isfinite(content.value):
                faults.add(row, cell, "not a finite number", column)
                continue
            values[row] = content.value
            if content.side is not None:
                signs[row], in_club_terms[row] = 1.0, content.side.frame != WORLD
            if content.unit is not None:
                other_units[row] = content.unit
        values *= signs
        if column.quantity in MIRRORED and in_club_terms.any():
            self.session.guessed_hand |= bool((np.isnan(hands) & in_club_terms & ~np.isnan(values)).any())
            values = np.where(in_club_terms & (hands < 0.0), -values, values)
        in_si = to_si(values, column.unit)
        for row, symbol in other_units.items():
            in_si[row] = to_si(values[row], symbol)
        return in_si

    def _leave_out_clubs(self, values: dict[str, Floats], kept: Sequence[int]) -> None:
        """Leave out the club data of shots whose club speed is impossible, which means the club was not measured."""
        of_club = [name for name in values if name in inputs()]
        if not of_club:
            return
        speed = values.get("speed", np.full_like(values[of_club[0]], nan))
        table = np.array([values[name] for name in of_club])
        measured = ~np.isnan(table)
        # Programs write zeros for missing measurements.
        zeros = np.isnan(speed) & measured.any(axis=0) & ((table == 0.0) | ~measured).all(axis=0)
        lacking = zeros | ~can_be("speed", speed)
        if lacking.any():
            self.session.without_club += int(lacking[kept].sum())
            for name in of_club:
                # Any other impossible speed stays, to be reported with all such values.
                gone = lacking & (speed == 0.0) if name == "speed" else lacking
                values[name] = np.where(gone, nan, values[name])

    def _take_points(self, cells: Sequence[Any], kept: Sequence[int]) -> None:
        """Take the reference points of club data, which must be the same for all shots."""
        assert self._columns is not None
        for name, place in self._columns.points.items():
            held = {str(cells[place][row]).strip() for row in kept}
            held |= {self.session.points[name]} if name in self.session.points else set()
            if len(held) > 1 or not held <= set(POINTS[name]):
                shown = ", ".join(shortened(each, 40) for each in sorted(held)[:SHOWN])
                allowed = f"one of {', '.join(POINTS[name])}, the same for all shots"
                raise FileError(self._path, None, f"the column {name!r} holds {shown}; it must be {allowed}", name)
            self.session.points[name] = held.pop()


def _is_array(cells: Any) -> bool:
    return isinstance(cells, np.ndarray)


def _is_measurement(cell: str) -> bool:
    """Return whether a cell is a number, possibly with a unit or a side, rather than a date, club or name."""
    match = NUMBER.fullmatch(cell.strip())
    if match is None or len(match["before"]) > 2 or len(match["rest"]) > 6:
        return False
    words = match["before"] + match["rest"]
    return any(map(str.isdigit, match["number"])) and not (words and club_kind(cell))


def _steps(cells: Any, column: FileColumn, decimal_comma: bool) -> Floats:
    """Return the value of the last digit [SI] of each cell in a column."""
    if _is_array(cells):
        return np.zeros(len(cells))
    point = "," if decimal_comma else "."
    match = [re.search(rf"\d+(?:{re.escape(point)}(\d*))?", cell.replace("'", "")) for cell in cells]
    places = np.array([len(each[1] or "") if each else 0 for each in match])
    return 10.0**-places * size(column.unit)


def _both(one: FileColumn, other: FileColumn) -> str:
    if one.heading == other.heading:
        return f"{one.heading}: the column is there twice, and columns {one.place + 1} and {other.place + 1} differ"
    return f"the columns {one.heading!r} and {other.heading!r} both give the {one.quantity} and differ"
