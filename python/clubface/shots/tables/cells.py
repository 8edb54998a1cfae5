"""Parsing table cells, and chunks of table rows by column, with the rejected rows.

A cell holds a number with a decimal point or comma, with a side or unit, a hand, or nothing.
"""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from clubface.equipment.described import HANDS
from clubface.errors import shortened
from clubface.results.notes import Note, note
from clubface.shots.tables.headings import HAND, SIDES, FileColumn, Side, narrow, plain, unit_symbol
from clubface.units import from_si, to_si, unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from clubface.support.arrays import Floats

MISSING = frozenset({"", "n/a", "#n/a", "na", "n/m", "nan", "null", "none", "no data", "not measured"})
"""Cells for missing values, in lower case; cells with only dashes, points and the like are missing too."""
_DASHES = "-–—−.,:_*?~ \xa0"
NUMBER = re.compile(
    r"(?P<before>(?:[^\d.,+-]++(?:[-/]\s?(?=[^\W\d_])[^\d.,+-]++)*+)?+)"
    r"(?P<number>(?:[-+]\s?)?+[\d.,]++(?:[\s'’ʼ]\d{3}(?!\d)[\d.,]*+)*+(?:e[-+]?\d++)?)"
    r"\s*+(?P<rest>\D*+)",
    re.IGNORECASE,
)
"""A number, possibly with separated thousands, with words before and after it for side and unit; it does not backtrack
(``++``), as a cell of 40,000 commas and a digit would be tried in a billion ways."""
_APART = re.compile(r"[-+]?\d{1,3}(?:[\s'’ʼ]\d{3})+(?:[.,]\d*)?")
"""A number with thousands separated by spaces or apostrophes, which have no other meaning."""
THOUSANDS = {
    ",": re.compile(r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?"),
    ".": re.compile(r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"),
}
"""Patterns of numbers with separated thousands, by separator."""
LARGE = frozenset({"total_spin", "backspin", "sidespin", "closure"})
"""Quantities that reach thousands in their usual units; for others, 1.386 and 147.512 are decimals."""
SHOWN = 3
"""Maximum number of surplus cells shown in a reason."""
_HANDS = {**HANDS, "r": 1, "l": -1, "rh": 1, "lh": -1, "right handed": 1, "left handed": -1, "1": 1, "+1": 1, "-1": -1}
PARTS_MISSING = "parts of the unfinished work were removed or damaged meanwhile; give the same command again"


def is_missing(text: str) -> bool:
    """Return whether a cell means not measured."""
    return text.strip().lower() in MISSING or not text.strip(_DASHES)


def is_number(text: str) -> bool:
    """Return whether a text is a finite number with a decimal point."""
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


class Decimals(NamedTuple):
    """How the numbers of a file are written."""

    comma: bool  # whether numbers have a decimal comma
    doubtful: str = ""  # an ambiguous cell, if nothing in the file decides


def decimals_of(cells: Iterable[tuple[str, str | None]], delimiter: str) -> Decimals:
    """Return how numbers are written, from cells with the quantity of their column (None if unknown).

    "12,5" and "1.234,5" have a decimal comma, "12.5" and "1,234.5" a point. "2.845" is ambiguous and depends on the
    column: only spins reach thousands in rpm, unless some have decimals, as 2845.312. The majority of cells decides. If
    only unknown columns could decide, a comma that is the delimiter is not a decimal comma, and a point is a decimal
    point.
    """
    votes = {",": 0, ".": 0}
    doubtful = {",": "", ".": ""}
    large, shown = {",": 0, ".": 0}, {",": False, ".": False}
    for cell, quantity in cells:
        if "." not in cell and "," not in cell:
            continue
        whole, _, decimals = cell.partition(".")
        if whole.removeprefix("-").isdecimal() and decimals.isdecimal() and len(decimals) != 3 and cell.isascii():
            votes["."] += 1  # fast path for the most common cells, ten times faster
            shown["."] |= quantity in LARGE
            continue
        match = NUMBER.fullmatch(cell.strip())
        text = "".join(match["number"].split()) if match else ""
        marks = {mark: text.count(mark) for mark in ",." if mark in text}
        if not marks or not any(map(str.isdigit, text)):
            continue
        last = max(marks, key=text.rfind)
        other = "," if last == "." else "."
        if len(marks) == 2:
            if marks[last] == 1 and THOUSANDS[other].fullmatch(text):
                votes[last] += 1
        elif not THOUSANDS[last].fullmatch(text):
            if marks[last] == 1:
                votes[last] += 1
                shown[last] |= quantity in LARGE
        elif marks[last] > 1:
            votes[other] += 1
        elif quantity in LARGE:
            large[last] += 1
        elif quantity is not None:
            votes[last] += 1
        else:
            doubtful[last] = doubtful[last] or cell.strip()
    for mark, other in (",.", ".,"):
        votes[mark if shown[mark] else other] += large[mark]
    if votes[","] != votes["."]:
        return Decimals(votes[","] > votes["."])
    comma = bool(doubtful[","]) and not doubtful["."] and delimiter != ","
    return Decimals(comma, doubtful[","] or doubtful["."])


def may_be_thousands(columns: Iterable[Sequence[str]], decimal_comma: bool) -> set[str]:
    """Return the cells whose decimal mark could separate thousands: 2.845, 2.845 rpm.

    There are none if another number of the column, such as 2845.312 or 12.5, shows that the mark is for decimals, since
    one program writes the whole column.
    """
    mark = "," if decimal_comma else "."
    result = set()
    for cell in (cell for column in columns for cell in column if mark in cell):
        match = NUMBER.fullmatch(cell.strip())
        text = "".join(match["number"].split()) if match else ""
        if THOUSANDS[mark].fullmatch(text):
            result.add(cell)
        elif text.count(mark) == 1 and not text.startswith(mark):
            return set()
    return result


def doubt(cell: str) -> Note:
    """Return the note on a number that is ambiguous between thousands and decimals."""
    return note("decimals-or-thousands", mark="comma" if "," in cell else "point", example=quoted_cell(cell))


def number(text: str, decimal_comma: bool) -> float:
    """Return the number in a text, with or without separated thousands; raise a ``ValueError`` for other text."""
    if "_" in text:
        raise ValueError
    text = re.sub(r"^([-+])\s", r"\1", text.strip())
    if _APART.fullmatch(text):
        text = re.sub(r"[\s'’ʼ]", "", text)
    mark, group = (",", ".") if decimal_comma else (".", ",")
    if THOUSANDS[group].fullmatch(text):
        text = text.replace(group, "")
    if group in text:
        raise ValueError
    return float(text.replace(mark, "."))


def hand_of(text: str) -> float:
    """Return +1 for a right hand and -1 for a left one, in any common spelling; else raise a ``ValueError``."""
    words = text.strip().lower().replace("-handed", " handed")
    if words not in _HANDS:
        raise ValueError
    return float(_HANDS[words])


def all_numbers(cells: Sequence[str], decimal_comma: bool) -> NDArray[Any] | None:
    """Return a column of finite numbers, ten times faster than by cell; None if there are other cells."""
    import numpy as np

    joined = "".join(cells)
    if "_" in joined or (decimal_comma and "." in joined):
        return None
    try:
        values = np.array([*map(float, [each.replace(",", ".") for each in cells] if decimal_comma else cells)])
    except ValueError:
        return None
    return values if np.isfinite(values).all() else None


def parsed(cells: Sequence[str], column: FileColumn, decimal_comma: bool) -> tuple[NDArray[Any], dict[int, str]]:
    """Return the numbers in ``cells``, and the reasons for cells without one."""
    import numpy as np

    is_hand = column.quantity == HAND
    if not is_hand and (quick := all_numbers(cells, decimal_comma)) is not None:
        return quick, {}
    values = np.full(len(cells), math.nan)
    reasons = {}
    for row, cell in enumerate(cells):
        text = cell.strip()
        try:
            values[row] = hand_of(text) if is_hand else _in_unit(text, column.unit, decimal_comma)
            if not math.isfinite(values[row]):
                reasons[row] = f"{column.heading}: {quoted_cell(text)} is not a finite number"
        except ValueError:
            what = f"{quoted_cell(text)} is not {'right or left' if is_hand else 'a number'}"
            reasons[row] = f"{column.heading}: {what if text else 'the cell is empty'}"
    return values, reasons


def _in_unit(text: str, symbol: str, decimal_comma: bool) -> float:
    """Return the number of a cell, which may have its own unit, in the unit of its column; else raise ValueError."""
    match = NUMBER.fullmatch(text)
    if match is None or match["before"] or not match["rest"]:
        return number(text, decimal_comma)
    named = unit_symbol(match["rest"])
    if named is None or unit(named).dimension != unit(symbol).dimension:
        raise ValueError
    value = number(match["number"], decimal_comma)
    return value if named == symbol else from_si(to_si(value, named), symbol)


def cell_text(value: Any) -> str:
    """Return a text or a number as the content of a cell; NaN is empty."""
    if isinstance(value, str):
        return value
    return "" if math.isnan(value) else repr(float(value))


def quoted_cell(text: str) -> str:
    """Return a cell for display in an error."""
    return repr(shortened(text, 40))


def ragged_reason(cells: Sequence[str], width: int) -> str:
    """Return the reason for rejecting a row with too few or too many cells."""
    reason = f"{len(cells)} cell{'s' * (len(cells) != 1)} where there are {width} columns"
    if len(cells) > width:
        beyond = cells[width : width + SHOWN]
        reason += "; beyond them: " + ", ".join(map(quoted_cell, beyond)) + ", ..." * (len(cells) > width + SHOWN)
    return reason


_NO_SIDE = frozenset({"n", "neutral", "s", "straight", "square", "sq", "m", "middle", "c", "center", "centre"})
"""Words allowed next to zero."""
LISTED = 8
"""Maximum number of sides listed in an error."""
PLAIN = re.compile(r"-?\d{1,15}(\.\d{0,20})?", re.ASCII)
"""A number in its most common form."""


class CellError(ValueError):
    """A cell that cannot be read; its text completes the sentence "the cell is ..."."""


class CellReading(NamedTuple):
    """The content of a cell."""

    value: float
    side: Side | None = None  # None if the sign alone counts
    unit: str | None = None  # None for the column's unit


def reading(cell: str, quantity: str, decimal_comma: bool, positive: float = 1.0) -> CellReading | None:
    """Return the content of a cell; None if nothing was measured.

    A number may have a side (``10.5 L``, ``L3.1``, ``3.1 In-Out``) and a unit (``422 R rpm``, ``8.5 mm Toe``), before
    or after it, in any order. A sign must agree with the side: if positive numbers of the column mean right
    (``positive`` is clubface's sign of the column's positive side), -1.2 L is 1.2 to the left and -1.2 R is an error.
    """
    if not decimal_comma and PLAIN.fullmatch(cell):
        return CellReading(float(cell))  # fast path for the most common cells, ten times faster
    if is_missing(cell):
        return None
    match, side, unit = _parts(cell, quantity)
    try:
        value = number(match["number"], decimal_comma)
    except ValueError:
        raise CellError("not a number") from None
    if side is None:
        return CellReading(value, None, unit)
    written = match["number"][0]
    if value and written in "-+" and (positive if written == "+" else -positive) != side.sign:
        raise CellError("a number whose sign and side contradict each other")
    return CellReading(abs(value) * side.sign, side, unit)


def unit_in(cell: str, quantity: str = "") -> str | None:
    """Return the symbol of the unit next to the number in a cell, or None."""
    try:
        return _parts(cell, quantity)[2]
    except CellError:
        return None


def _parts(cell: str, quantity: str) -> tuple[re.Match[str], Side | None, str | None]:
    """Return number, side and unit of a cell; side and unit may stand before or after the number."""
    text = narrow(cell.replace("−", "-")).strip()
    match = NUMBER.fullmatch("-" + text[1:] if text[:1] == "–" else text)
    if not match or not any(map(str.isdigit, match["number"])):
        raise CellError("not a number")
    sides = SIDES.get(quantity, {})
    before, after = (_side_and_unit(match[each], quantity) for each in ("before", "rest"))
    if before is None or after is None or any(map(all, zip(before, after, strict=True))):
        if not match["number"].strip("+-0.,") and plain(match["before"] + match["rest"]) in _NO_SIDE:
            return match, None, None
        some = ", ".join(islice(sides, LISTED)) + ", ..." * (len(sides) > LISTED)
        raise CellError("not a number" + f", or one with its side ({some})" * bool(sides))
    return match, before[0] or after[0], before[1] or after[1]


@lru_cache(maxsize=4096)
def _side_and_unit(text: str, quantity: str) -> tuple[Side | None, str | None] | None:
    """Return side and unit from the words next to a number, in any order; None for other words."""
    sides = SIDES.get(quantity, {})
    words = re.sub(r"[°º](?!/)", r" ° ", text).split()
    only_unit = None
    for place in range(len(words) + 1):
        parts = " ".join(words[:place]), " ".join(words[place:])
        for named, other in (parts, parts[::-1]):
            side, symbol = None if "°" in named else sides.get(plain(named)), unit_symbol(other)
            if side and (symbol or not other):
                return side, symbol
            if not named and (symbol or not other):
                only_unit = None, symbol  # "1.3 C" is closed where it can be, and degrees Celsius elsewhere
    return only_unit


class Reject(NamedTuple):
    """A row that cannot be used."""

    line: int  # line at which it begins (in a Parquet file, the row), from 1
    reason: str  # what is wrong
    cells: Sequence[str]  # the row as in the file


@dataclass(frozen=True)
class Chunk:
    """Some rows of a table, each with a cell for every column."""

    lines: Sequence[int]  # line at which each row begins
    columns: Sequence[Any]  # each a sequence of texts, an array of numbers or texts, or an Arrow array
    ragged: Sequence[Reject] = ()  # rows with too few or too many cells, not included above
    decimal_comma: bool = False  # whether texts write numbers with a decimal comma
    as_written: Sequence[str] | None = None  # the rows as written in a CSV file
    deliveries: Mapping[str, Floats] | None = None  # inputs of an impact [SI], if known without reading cells

    def select(self, rows: Sequence[int] | None) -> Self:
        """Return the chunk of some rows; None stands for all."""
        if rows is None:
            return self
        written = None if self.as_written is None else [self.as_written[row] for row in rows]
        columns = [_taken(each, rows) for each in self.columns]
        return replace(self, lines=[self.lines[row] for row in rows], columns=columns, as_written=written)

    def numbers(self, column: FileColumn) -> tuple[Any, dict[int, str]]:
        """Return the numbers of a column in its unit, and the reasons for rows without one."""
        import numpy as np

        numbers = self.cells(column.place)
        if isinstance(numbers, Sequence) or column.quantity == HAND:
            return parsed(_texts(self.columns[column.place]), column, self.decimal_comma)
        missing = self.columns[column.place].is_null()
        return numbers, {
            int(row): f"{column.heading}: "
            + ("the cell is empty" if missing[int(row)].as_py() else f"{numbers[row]} is not a finite number")
            for row in np.flatnonzero(~np.isfinite(numbers))
        }

    def cells(self, place: int) -> Any:
        """Return the cells of a column: an array of numbers, with NaN for missing ones, or a list of texts."""
        column = self.columns[place]
        if _is_arrow(column):
            import pyarrow

            if pyarrow.types.is_integer(column.type) or pyarrow.types.is_floating(column.type):
                return column.cast(pyarrow.float64(), safe=False).to_numpy(zero_copy_only=False)
        elif not isinstance(column, Sequence) and column.dtype.kind == "f":
            return column
        return _texts(column)

    def texts(self, rows: Sequence[int] | None = None) -> list[list[str]]:
        """Return the cells of some rows (None: all) as text."""
        columns = self.columns if rows is None else [_taken(each, rows) for each in self.columns]
        return [list(cells) for cells in zip(*map(_texts, columns), strict=True)]

    def written(self, rows: Sequence[int] | None, delimiter: str) -> list[str]:
        """Return some rows (None: all) as lines of a CSV file."""
        if self.as_written is not None:
            texts = self.as_written if rows is None else [self.as_written[row] for row in rows]
            return [text.rstrip("\r\n") for text in texts]
        lines = []
        for cells in self.texts(rows):
            line = io.StringIO()
            csv.writer(line, delimiter=delimiter, lineterminator="").writerow(cells)
            lines.append(line.getvalue())
        return lines

    def arrow(self, place: int, rows: Sequence[int] | None) -> Any:
        """Return the cells of a column in some rows (None: all) as an Arrow array; NaN becomes null."""
        import pyarrow

        column = self.columns[place] if rows is None else _taken(self.columns[place], rows)
        if _is_arrow(column):
            return column
        if isinstance(column, Sequence):
            return pyarrow.array(column, pyarrow.string())
        return pyarrow.array(column, from_pandas=True)


def _is_arrow(column: Any) -> bool:
    return hasattr(column, "to_pylist")


def _taken(column: Any, rows: Sequence[int]) -> Any:
    if _is_arrow(column):
        import pyarrow

        return column.take(pyarrow.array(rows, pyarrow.int64()))
    return [column[row] for row in rows] if isinstance(column, Sequence) else column[list(rows)]


def _texts(column: Any) -> Sequence[str]:
    """Return the cells of a column as texts, those without a value as empty ones."""
    if _is_arrow(column):
        return ["" if each is None else _arrow_text(each) for each in column.to_pylist()]
    return column if isinstance(column, Sequence) else [cell_text(each) for each in column]


def _arrow_text(value: Any) -> str:
    if isinstance(value, float) and math.isfinite(value):
        return f"{value:.15g}" if float(f"{value:.15g}") == value else repr(value)
    return str(value)
