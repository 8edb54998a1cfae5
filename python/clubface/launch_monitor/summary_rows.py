"""Rows that sum up others, such as averages and deviations, which are no shots."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

from clubface.support.arrays import Floats
from clubface.tables.spelling import plain

CLEAR = frozenset(
    {
        "average", "averages", "avg", "mean", "median", "std dev", "stddev", "std", "sd", "dev", "deviation",
        "standard deviation", "consistency", "min", "max", "minimum", "maximum",
        "durchschnitt", "mittelwert", "standardabweichung", "gemiddelde", "promedio", "moyenne",
    }
)  # fmt: skip
"""What such a row is called."""


def summary_rows(labels: Mapping[int, str], cells: Sequence[Any], values: Mapping[str, Floats]) -> set[int]:
    """Return which rows sum up others, from the cells of the columns that may say so and the values by quantity."""
    found: set[int] = set()
    for place in labels:
        found |= {row for row, cell in enumerate(cells[place]) if _is_summary(str(cell))}
    return found


@lru_cache(maxsize=4096)
def _is_summary(text: str) -> bool:
    return plain(text) in CLEAR
