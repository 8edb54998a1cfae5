"""The rows of a launch monitor's file: header, units, averages and shots, and the values of each shot."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isclose, nan

from clubface.launch_monitor.cells import MIRRORED, WORLD, CellError, heading, reading
from clubface.launch_monitor.columns import Columns, Used, columns_of, is_units_row
from clubface.launch_monitor.formats import Format
from clubface.recorded.possible import can_be
from clubface.recorded.shots import RejectedRow
from clubface.simulation.quantities import inputs
from clubface.tables.cells import hand_of, quoted_cell
from clubface.tables.csv_rows import Row
from clubface.tables.rows import Reject
from clubface.tables.spelling import plain
from clubface.units import to_si, unit

SUMMARIES = frozenset(
    {
        "average", "averages", "avg", "mean", "median", "std dev", "stddev", "std", "sd", "dev", "deviation",
        "standard deviation", "consistency", "min", "max", "minimum", "maximum",
        "durchschnitt", "mittelwert", "standardabweichung", "gemiddelde", "promedio", "moyenne",
    }
)  # fmt: skip
"""What stands first in a row that sums up others."""
COUNTING = ("shot", "no", "index", "shot number")
"""Headings of a column that numbers the shots; in a row that sums them up it says so."""
SAME = 1e-6
"""Relative difference up to which two cells say the same."""


@dataclass
class Shot:
    """The values of one row, by quantity, in SI units; sides across the target line are in world terms.

    Attributes
    ----------
    line
        Line in which the row begins.
    values
        What was measured.
    club, player
        Name of the club and of the player, or "".
    hand
        +1 for right, -1 for left, or NaN if it is not known.
    """

    line: int
    values: dict[str, float]
    club: str = ""
    hand: float = nan
    player: str = ""


@dataclass
class Session:
    """All that a file says.

    Attributes
    ----------
    shots
        One a row.
    rejected
        The rows that give no shot.
    summaries
        Rows of averages and the like that were passed over.
    without_club
        Shots for which the file says that the club was not measured.
    told
        How often each value of the columns to be told of is there, by heading.
    assumed
        Headings whose unit was assumed, with the unit.
    unused
        Headings that would give a quantity but for what is in their brackets.
    guessed_hand
        Whether something told in terms of the club was read as a right-hander's because nothing tells the hand.
    names_clubs, names_players
        Whether the file names clubs and players.
    """

    shots: list[Shot] = field(default_factory=list)
    rejected: list[RejectedRow] = field(default_factory=list)
    summaries: int = 0
    without_club: int = 0
    told: dict[str, Counter[str]] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    unused: dict[str, None] = field(default_factory=dict)
    guessed_hand: bool = False
    names_clubs: bool = False
    names_players: bool = False


class SessionReader:
    """Goes through the rows of a file of a known layout."""

    def __init__(
        self,
        path: str,
        layout: Format,
        hand: float,
        units: Mapping[str, str],
        decimal_comma: bool,
        sample: Sequence[Row | Reject] = (),
    ) -> None:
        self._path = path
        self._sample = [row for row in sample if not isinstance(row, Reject)]
        self._layout = layout
        self._hand = hand
        self._units = units
        self._decimal_comma = decimal_comma
        self._columns: Columns | None = None
        self._header: Sequence[str] = ()
        self._header_line = 0
        self._counting: Sequence[int] = ()
        self._title = re.compile(layout.title_of_player) if layout.title_of_player else None
        self._player = ""
        self.session = Session()

    @property
    def found_header(self) -> bool:
        """Whether a row was the header of the layout."""
        return bool(self._header)

    def read(self, rows: Iterable[Row | Reject]) -> Session:
        """Return what the rows say."""
        for row in rows:
            if isinstance(row, Reject):
                self._reject(row.line, row.reason)
                continue
            cells, line, _ = row
            if not any(cell.strip() for cell in cells):
                continue
            if self._may_be_header(cells) and self._layout.is_marked({heading(each).name for each in cells}):
                self._header, self._header_line, self._columns = cells, line, None
            elif self._title is not None and (found := self._title.fullmatch(cells[0].strip())):
                self._player = found[1]
                self.session.names_players = True
            elif self._header:
                self._body(cells, line)
        return self.session

    def _may_be_header(self, cells: Sequence[str]) -> bool:
        """Tell whether a row is worth a closer look: tables after the first begin with the same heading."""
        return not self._header or cells[0] == self._header[0]

    def _body(self, cells: Sequence[str], line: int) -> None:
        if self._columns is None:
            units = cells if is_units_row(cells) else None
            place = (self._path, self._header_line)
            below = [each for each, at, _ in self._sample if at > self._header_line]
            self._columns = columns_of(self._layout, self._header, units, self._units, place, below)
            self._counting = [place for place, each in enumerate(self._header) if plain(each) in COUNTING]
            self.session.assumed.update(self._columns.assumed)
            self.session.unused.update(dict.fromkeys(self._columns.unused))
            self.session.names_clubs |= bool(self._columns.club)
            self.session.names_players |= self._columns.player is not None
            if units is not None:
                return
        columns = self._columns
        if any(plain(cells[place]) in SUMMARIES for place in (0, *self._counting) if place < len(cells)):
            self.session.summaries += 1
            return
        beyond = [cell for cell in cells[columns.width :] if cell.strip()]
        if len(cells) < columns.width or beyond:
            reason = f"{len(cells)} cell{'s' * (len(cells) != 1)} where there are {columns.width} columns"
            self._reject(line, reason)
            return
        try:
            shot = self._shot(cells, line, columns)
        except CellError as error:
            self._reject(line, str(error))
            return
        self.session.shots.append(shot)
        for place in columns.told:
            if cells[place].strip():
                self.session.told.setdefault(self._header[place].strip(), Counter())[cells[place].strip()] += 1

    def _reject(self, line: int, reason: str) -> None:
        self.session.rejected.append(RejectedRow(line, reason))

    def _shot(self, cells: Sequence[str], line: int, columns: Columns) -> Shot:
        hand = self._hand
        if hand != hand and columns.hand is not None:
            try:
                hand = hand_of(cells[columns.hand])
            except ValueError:
                told = f"{self._header[columns.hand].strip()}: {quoted_cell(cells[columns.hand].strip())}"
                raise CellError(f"{told} is not a hand") from None
        values: dict[str, float] = {}
        for quantity, used in columns.used.items():
            found = [
                (each, value) for each in used if (value := self._value(cells[each.place], each, hand)) is not None
            ]
            if not found:
                continue
            for each, value in found[1:]:
                if not isclose(value, found[0][1], rel_tol=SAME):
                    first, second = (cells[which.place].strip() for which in (found[0][0], each))
                    message = f"{each.heading}: the columns {found[0][0].place + 1} and {each.place + 1} differ"
                    raise CellError(f"{message}: {quoted_cell(first)} and {quoted_cell(second)}")
            values[quantity] = found[0][1]
        club = next((cells[place].strip() for place in columns.club if cells[place].strip()), "")
        player = self._player if columns.player is None else cells[columns.player].strip()
        return Shot(line, self._checked(values), club, hand, player)

    def _checked(self, values: dict[str, float]) -> dict[str, float]:
        if values.get("ball_speed") == 0.0:
            raise CellError("the ball speed is 0: no ball was measured")
        speed = values.get("speed")
        if not can_be("speed", speed) if speed is not None else self._writes_zeros(values):
            self.session.without_club += 1
            values = {name: value for name, value in values.items() if name not in inputs()}
            if speed:
                values["speed"] = speed  # which no club has; it is told with all such values
        if not values:
            raise CellError("nothing was measured: every cell of the club and the ball is empty")
        return values

    @staticmethod
    def _writes_zeros(values: Mapping[str, float]) -> bool:
        """Tell whether all that is said of the club is zeros, as by programs that write them for no measurement."""
        said = [value for name, value in values.items() if name in inputs()]
        return bool(said) and not any(said)

    def _value(self, cell: str, column: Used, hand: float) -> float | None:
        """Return the SI value of a cell with its sign here, None where nothing was measured."""
        try:
            found = reading(cell, column.quantity, self._decimal_comma)
        except CellError as error:
            raise CellError(f"{column.heading}: {quoted_cell(cell.strip())} is {error}") from None
        if found is None:
            return None
        side = found.side or column.side
        value = found.value if found.side else found.value * side.sign
        if side.frame != WORLD and column.quantity in MIRRORED:
            if hand < 0.0:
                value = -value
            self.session.guessed_hand |= hand != hand
        if found.unit is None:
            return to_si(value, column.unit)
        if unit(found.unit).dimension != unit(column.unit).dimension:
            told = f"{quoted_cell(cell.strip())} is not in {column.unit} or another such unit"
            raise CellError(f"{column.heading}: {told}")
        return to_si(value, found.unit)
