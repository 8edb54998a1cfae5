"""A published table in SI, and where it was printed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_choice


@dataclass(frozen=True, kw_only=True, eq=False)
class PublishedTable:
    """A published table, or a single figure as a table of one row.

    Attributes
    ----------
    name, title
        What it is called here, and what it is.
    kind
        One of ``KINDS``: whether the figures were measured or computed, or are a limit.
    source
        Author, year, title, publication and place in it.
    via
        What the figures were read in; None where it was the source itself.
    conditions
        How the figures came about, and how they are to be read.
    caveat
        What is in doubt; None if nothing is known to be.
    columns
        Each column by its name: an array in SI units and radians, NaN where nothing was printed, or one of words.
    units
        The unit each column of numbers was printed in (``"1"`` for a plain number); columns of words have none.
    derived
        Columns among the measured ones that their source computed from others, and how that is known: a dynamic loft
        that a monitor computes from the ball holds the monitor's model of impact. No model is judged by spin with it.
    """

    name: str
    title: str
    kind: str
    source: str
    via: str | None = None
    conditions: str
    caveat: str | None = None
    columns: dict[str, NDArray[Any]]
    units: dict[str, str]
    derived: Mapping[str, str] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def __getitem__(self, column: str) -> NDArray[Any]:
        check_choice("column", column, self.columns)
        return self.columns[column]

    def get(self, column: str, unit: str) -> NDArray[np.float64]:
        """Return a column of numbers in another unit, as in ``get("spin", "rpm")``."""
        values = self[column]
        if column not in self.units:
            raise InputError("column", column, f"one of numbers: {', '.join(self.units)}")
        units.unit(unit, name=column, dimension=units.unit(self.units[column]).dimension)
        return units.from_si(values, unit)
