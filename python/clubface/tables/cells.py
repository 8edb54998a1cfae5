"""What the cells of a table say: numbers with a point or a decimal comma, hands, nothing measured."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from clubface.equipment.described import HANDS
from clubface.errors import shortened
from clubface.tables.headings import HAND, Column
from clubface.tables.spelling import unit_symbol
from clubface.units import from_si, to_si, unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

MISSING = frozenset({"", "-", "--", "---", "–", "—", "n/a", "na", "nan", "null", "none"})
"""Cells that say that nothing was measured, in lower case."""
NUMBER = re.compile(
    r"(?:(?P<before>[LR])\s*+)?(?P<number>[-+]?[\d.,]++(?:e[-+]?\d++)?)\s*+(?P<rest>\D*+)", re.IGNORECASE
)
"""A number, which a side may precede or follow, and a unit follow. It gives nothing back (``++``): a cell of 40,000
commas and a digit would be tried in a billion ways."""
THOUSANDS = {
    ",": re.compile(r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?"),
    ".": re.compile(r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"),
}
"""Numbers whose thousands are separated by a sign, by that sign."""
SHOWN = 3
"""Cells beyond the columns that a reason shows."""
_HANDS = {**HANDS, "r": 1, "l": -1, "rh": 1, "lh": -1, "right handed": 1, "left handed": -1, "1": 1, "+1": 1, "-1": -1}


def is_missing(text: str) -> bool:
    """Tell whether a cell says that nothing was measured."""
    return text.strip().lower() in MISSING


def is_number(text: str) -> bool:
    """Tell whether a text is a finite number with a decimal point."""
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def uses_decimal_comma(cells: Iterable[str], delimiter: str) -> bool:
    """Return whether numbers have a decimal comma: whether more cells are numbers that way than with a point.

    If commas separate the cells, a comma inside a cell and before three digits separates thousands.
    """
    numbers = [found["number"] for cell in cells if (found := NUMBER.fullmatch(cell.strip()))]
    commas = sum(
        is_number(each.replace(",", ".")) and not (delimiter == "," and THOUSANDS[","].fullmatch(each))
        for each in numbers
        if each.count(",") == 1 and "." not in each
    )
    points = sum(is_number(each) for each in numbers if "." in each)
    return commas > points


def number(text: str, decimal_comma: bool) -> float:
    """Return the number that a text stands for; else a ``ValueError``."""
    if "_" in text or (decimal_comma and "." in text):
        raise ValueError
    return float(text.replace(",", ".") if decimal_comma else text)


def without_thousands(text: str, decimal_comma: bool) -> str:
    """Return a number without the signs that separate its thousands, if there are any."""
    group = "." if decimal_comma else ","
    return text.replace(group, "") if THOUSANDS[group].fullmatch(text) else text


def hand_of(text: str) -> float:
    """Return +1 for a right hand and -1 for a left one, as people and monitors write them; else a ``ValueError``."""
    told = text.strip().lower().replace("-handed", " handed")
    if told not in _HANDS:
        raise ValueError
    return float(_HANDS[told])


def parsed(cells: Sequence[str], column: Column, decimal_comma: bool) -> tuple[NDArray[Any], dict[int, str]]:
    """Return the numbers ``cells`` hold, and for those that hold none, why."""
    import numpy as np

    is_hand = column.quantity == HAND
    joined = "".join(cells)
    if not is_hand and "_" not in joined and (not decimal_comma or "." not in joined):
        # As below, but for most columns of most files at a tenth of the cost.
        try:
            values = np.array([*map(float, [c.replace(",", ".") for c in cells] if decimal_comma else cells)])
            if np.isfinite(values).all():
                return values, {}
        except ValueError:
            pass
    values = np.full(len(cells), math.nan)
    reasons = {}
    for row, cell in enumerate(cells):
        text = cell.strip()
        try:
            values[row] = hand_of(text) if is_hand else _in_unit(text, column.unit, decimal_comma)
            if not math.isfinite(values[row]):
                reasons[row] = f"{column.heading}: {quoted_cell(text)} is not a finite number"
        except ValueError:
            told = f"{quoted_cell(text)} is not {'right or left' if is_hand else 'a number'}"
            reasons[row] = f"{column.heading}: {told if text else 'the cell is empty'}"
    return values, reasons


def _in_unit(text: str, symbol: str, decimal_comma: bool) -> float:
    """Return the number of a cell, which may name a unit of its own, in the unit of its column; else ValueError."""
    found = NUMBER.fullmatch(text)
    if found is None or found["before"] or not found["rest"]:
        return number(text, decimal_comma)
    told = unit_symbol(found["rest"])
    if told is None or unit(told).dimension != unit(symbol).dimension:
        raise ValueError
    value = number(found["number"], decimal_comma)
    return value if told == symbol else from_si(to_si(value, told), symbol)


def quoted_cell(text: str) -> str:
    """Return a cell as an error shows it."""
    return repr(shortened(text, 40))


def ragged_reason(cells: Sequence[str], width: int) -> str:
    """Return what is wrong with a row that has too few or too many cells."""
    reason = f"{len(cells)} cell{'s' * (len(cells) != 1)} where there are {width} columns"
    if len(cells) > width:
        beyond = cells[width : width + SHOWN]
        reason += "; beyond them: " + ", ".join(map(quoted_cell, beyond)) + ", ..." * (len(cells) > width + SHOWN)
    return reason
