"""The registry of quantities: name, symbol, units, digits, label, meaning and sign of every computed value.

It is defined once, in the compiled core, which Python, C and the browser share. A quantity used by a single
computation, such as strokes gained on a hole, is registered in its module by :func:`register_quantity`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from typing import Any, NamedTuple

from clubface import units
from clubface.errors import UnknownNameError
from clubface.support.checks import check_choice

__all__ = [
    "Quantity",
    "Reading",
    "display_unit",
    "file_unit",
    "format_number",
    "format_value",
    "quantities",
    "quantity",
    "read_in",
    "register_quantity",
    "unit_text",
]


SYSTEMS = ("golf", "metric")
"""Systems of units: mph and yards, or m/s and metres."""
_system: ContextVar[str] = ContextVar("system of units", default="golf")


@contextmanager
def read_in(system: str) -> Iterator[None]:
    """Show sentences, tables and pictures in the units of ``system``, "golf" or "metric", within the block.

    Raises
    ------
    InputError
        There is no such system.
    """
    check_choice("units", system, SYSTEMS)
    before = _system.set(system)
    try:
        yield
    finally:
        _system.reset(before)


class Reading(NamedTuple):
    """How a quantity is shown: its unit and decimal places."""

    unit: str
    digits: int


class Quantity(NamedTuple):
    """One quantity.

    Attributes
    ----------
    name
        Name in keyword arguments, attributes and columns: "ball_speed".
    unit
        SI unit of its values.
    metric, golf
        Readings for files and for people: m/s in files, mph in tables.
    label
        Label in words: "ball speed".
    symbol
        Symbol in equations; "" if it has none.
    meaning
        Meaning in one line.
    sign
        Meaning of a positive sign; "" for a magnitude.
    sides
        Words for negative and positive values, such as ("left", "right"); None for a quantity without sides.
    synonyms
        Other names in files.
    """

    name: str
    unit: str = "1"
    metric: Reading = Reading("1", 3)
    golf: Reading = Reading("1", 3)
    label: str = ""
    symbol: str = ""
    meaning: str = ""
    sign: str = ""
    sides: tuple[str, str] | None = None
    synonyms: tuple[str, ...] = ()

    @property
    def dimension(self) -> str:
        """The dimension, as in ``units``."""
        return units.unit(self.unit).dimension

    @property
    def reading(self) -> Reading:
        """The unit and digits in the system of units set by :func:`read_in`."""
        return self.metric if _system.get() == "metric" else self.golf

    def digits(self, unit: str) -> int:
        """Return the decimal places for showing the quantity in ``unit``, derived from the nearest known reading."""
        for known in (self.golf, self.metric):
            if unit == known.unit:
                return known.digits
        return max(0, self.golf.digits + round(math.log10(units.size(unit) / units.size(self.golf.unit))))


_OWN: dict[str, Quantity] = {}
_HEAD_PREFIXES = ("shape_", "thickness_", "target_", "grooves_")
"""Prefixes of the names of head dimensions, which are shown in millimetres."""


def register_quantity(name: str, unit: str = "1", **fields: Any) -> Quantity:
    """Register a quantity that the core does not know; ``fields`` are the fields of :class:`Quantity`.

    Readings default to those of the dimension; a single reading is used for both.

    Raises
    ------
    ValueError
        The name is used by another quantity.
    """
    usual, _ = _dimension_readings()[units.unit(unit).dimension]
    metric = fields.pop("metric", None) or fields.get("golf") or usual
    golf = fields.pop("golf", None) or metric
    label = fields.pop("label", name.replace("_", " "))
    new = Quantity(name, unit, Reading(metric[0], metric[1]), Reading(golf[0], golf[1]), label, **fields)
    known = _core_quantities().get(name) or _OWN.setdefault(name, new)
    if known != new:
        raise ValueError(f"the quantity {name!r} is registered as {known}, not as {new}")
    return new


def quantities() -> dict[str, Quantity]:
    """Return all registered quantities by name."""
    return _core_quantities() | _OWN


def quantity(name: str, unit: str | None = None) -> Quantity:
    """Return the quantity ``name``, or one described only by its SI ``unit``.

    A compound name, such as ``mean_carry``, belongs to the quantity with which it ends.

    Raises
    ------
    UnknownNameError
        There is no such quantity, and no unit is given.
    """
    core = _core_quantities()
    parts = name.split("_")
    for first in range(len(parts)):
        ending = "_".join(parts[first:])
        known = core.get(ending) or _OWN.get(ending)
        if known is not None and unit in (None, known.unit):
            return known if not first else known._replace(name=name, label=name.replace("_", " "))
    if unit is None:
        raise UnknownNameError("quantity", name, quantities())
    metric, golf = _dimension_readings()[units.unit(unit).dimension]
    return Quantity(name, unit, metric, golf, name.replace("_", " "))


def display_unit(name: str, unit: str) -> str:
    """Return the unit for showing the quantity ``name`` to people; its SI unit is ``unit``."""
    return _reading_of(name, unit).reading.unit


def file_unit(name: str, unit: str) -> str:
    """Return the unit of the quantity ``name`` in files; its SI unit is ``unit``."""
    return _reading_of(name, unit).metric.unit


def _reading_of(name: str, unit: str) -> Quantity:
    if unit == "m" and (name.startswith(_HEAD_PREFIXES) or name.endswith(("_toe", "_high"))):
        return quantity("toe")
    # Statistics of a quantity, such as toe_mean, have its reading.
    base = quantities().get(name.rpartition("_")[0])
    known = quantity(name, unit)
    return base if known.name == name and name not in quantities() and base and base.unit == unit else known


def format_number(value: float | None, digits: int = 1, *, signed: bool = False) -> str:
    """Format a number with ``digits`` decimal places; NaN and None give "", and -0 is never written."""
    if value is None or math.isnan(value):
        return ""
    text = f"{value:{'+' if signed else ''}.{digits}f}"
    if text[0] in "+-" and not text.strip("+-0."):
        return text[1:]
    return text


def format_value(value: float, quantity: Quantity, unit: str | None = None, digits: int | None = None) -> str:
    """Format an SI value with its unit, such as "166.4 mph" or "3.7%"."""
    return with_unit(bare_value(value, quantity, unit, digits), quantity.reading.unit if unit is None else unit)


def bare_value(value: float, quantity: Quantity, unit: str | None = None, digits: int | None = None) -> str:
    """Format an SI value without its unit, such as "166.4"; see :func:`format_value`."""
    if unit is None:
        unit = quantity.reading.unit
        # Digits chosen for mph are one too few for m/s.
        if digits is not None and units.size(unit) > 2.0 * units.size(quantity.golf.unit):
            digits += 1
    digits = quantity.digits(unit) if digits is None else digits
    return format_number(float(units.from_si(value, unit)), digits)


def with_unit(number: str, unit: str) -> str:
    """Append a unit to a number or a range in words: "40 to 50%", "166.4 mph", "1.48"."""
    return number + {"1": "", "%": "%"}.get(unit, f" {unit}")


def unit_text(unit: str) -> str:
    """Return a unit as shown to people: "" for "1", "µs" for "us"."""
    return {"1": "", "us": "µs"}.get(unit, unit)


def convert(value: Any, unit: str, *, difference: bool = False) -> Any:
    """Convert an SI value to ``unit``; for a ``difference``, temperature offsets are left out."""
    return value / units.size(unit) if difference else units.from_si(value, unit)


@cache
def _core_quantities() -> dict[str, Quantity]:
    from clubface import _core

    result = {}
    for each in _core.quantities():
        readings = {key: Reading(*each[key]) for key in ("metric", "golf")}
        result[each["name"]] = Quantity(**{**each, **readings, "synonyms": tuple(each["synonyms"])})
    return result


@cache
def _dimension_readings() -> dict[str, tuple[Reading, Reading]]:
    from clubface import _core

    return {each["name"]: (Reading(*each["metric"]), Reading(*each["golf"])) for each in _core.dimensions()}
