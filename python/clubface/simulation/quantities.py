"""What goes into the core and what comes out: names, units and meanings, in the order of its columns."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from clubface import units
from clubface.simulation import core
from clubface.support.frozen import Frozen


class Quantity(NamedTuple):
    """One input or output of the core.

    Attributes
    ----------
    name
        The name in keyword arguments and tables.
    unit
        The SI unit it is held in.
    meaning
        One line; says what positive means where there is a sign.
    group
        What an input belongs to: "delivery", "club", "ball", "parameters", "launch", "air" or "ground".
    differentiable
        Whether a launch can be differentiated with respect to it.
    default, lower, upper
        For an input of a flight: the value that is used if none is given (NaN if it must be given), and its limits.
    """

    name: str
    unit: str
    meaning: str
    group: str = ""
    differentiable: bool = False
    default: float = math.nan
    lower: float = -math.inf
    upper: float = math.inf

    @property
    def dimension(self) -> str:
        """The dimension, as in ``units``."""
        return units.unit(self.unit).dimension


@cache
def inputs() -> Mapping[str, Quantity]:
    """Return the inputs of an impact by name, in the order of the columns."""
    return _read(core.inputs())


@cache
def outputs() -> Mapping[str, Quantity]:
    """Return the outputs of an impact by name, in order."""
    return _read(core.outputs())


@cache
def flight_inputs() -> Mapping[str, Quantity]:
    """Return the inputs of a flight by name, in the order of the columns."""
    return _read(core.flight_inputs())


@cache
def flight_outputs() -> Mapping[str, Quantity]:
    """Return the outputs of a flight by name, in order."""
    return _read(core.flight_outputs())


@cache
def input_columns() -> Mapping[str, int]:
    """Return the column of each input of an impact."""
    return Frozen({name: column for column, name in enumerate(inputs())})


@cache
def input_dimensions() -> Mapping[str, str]:
    """Return the dimension of each input of an impact."""
    return Frozen({name: each.dimension for name, each in inputs().items()})


def in_unit(value: Any, quantity: Quantity, unit: str) -> Any:
    """Express SI ``value`` of ``quantity`` in ``unit``, which must be of its dimension."""
    units.unit(unit, name=quantity.name, dimension=quantity.dimension)
    return units.from_si(value, unit)


def _read(entries: list[dict[str, Any]]) -> Mapping[str, Quantity]:
    found = {}
    for entry in entries:
        values = {key: entry[key] for key in Quantity._fields if key in entry}
        found[entry["name"]] = Quantity(**values)
    return Frozen(found)
