"""The only conversions of the package: text with a unit to SI and radians, and back.

Inside, everything is SI; a person writes ``"108 mph"`` or ``"2 deg"``. A bare number is SI. The units are a
plain table, which costs nothing at start-up. Each factor is a fraction: ``"204 g"`` is ``0.204`` to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from clubface.errors import InputError, Told, UnitError, nearest_names
from clubface.units.table import (
    DIMENSIONLESS as DIMENSIONLESS,
    DISPLAY_UNITS,
    DISPLAY_UNITS_BY_NAME,
    OF_A_HEAD,
    SI_UNITS as SI_UNITS,
    UNITS,
    Unit as Unit,
    key,
)

if TYPE_CHECKING:
    from fractions import Fraction

    from numpy.typing import NDArray

MOST_DIMENSIONS = 32
"""Of an array, as the core takes it."""


def unit(symbol: str, *, name: str = "unit", dimension: str | None = None) -> Unit:
    """Return the unit written ``symbol``, of ``dimension`` where one is given; else a :class:`UnitError`."""
    if not isinstance(symbol, str):
        raise UnitError(name, symbol, "text, such as " + symbols(dimension)[0])
    return _unit(symbol, dimension, name, symbol)


@lru_cache(maxsize=256)
def _unit(symbol: str, dimension: str | None, name: str, value: str) -> Unit:
    """Return the unit written ``symbol``, with which ``value`` was given for the quantity called ``name``."""
    found = UNITS.get(key(symbol)) if symbol.strip() else UNITS["1"]
    if found is not None and dimension in (None, found.dimension):
        return found
    allowed = symbols(dimension)
    told = f"in {' or '.join(allowed)}"
    if found is not None:
        raise UnitError(name, value, f"{told}, not {'an' if found.dimension[0] in 'aei' else 'a'} {found.dimension}")
    near = nearest_names(symbol, allowed)
    raise UnitError(name, value, told + (f" (did you mean {' or '.join(near)}?)" if near else ""))


def symbols(dimension: str | None = None) -> tuple[str, ...]:
    """List the units of one dimension, or all, the SI unit first."""
    return tuple(dict.fromkeys(each.symbol for each in UNITS.values() if dimension in (None, each.dimension)))


def parse(value: object, dimension: str, *, name: str = "value") -> float:
    """Convert ``"108 mph"``, ``"2 deg"`` or a bare SI number to a finite float in SI.

    Parameters
    ----------
    value
        Text with a unit, text without one (SI), or a real number (SI).
    dimension
        One of ``SI_UNITS``: ``"speed"``, ``"angle"``, ``"length"``, ...
    name
        What the quantity is called in an error.

    Raises
    ------
    UnitError
        An unknown unit, or one of another dimension.
    InputError
        Not a number, NaN, infinite, or too large for a float.
    """
    if dimension not in SI_UNITS:
        raise ValueError(f"unknown dimension {dimension!r}; known: {', '.join(SI_UNITS)}")
    if isinstance(value, str):
        digits, symbol = _split(value)
        if not digits:
            raise InputError(name, value, _wanted(dimension))
        number = float(digits)
        if symbol:
            found = _unit(symbol, dimension, name, value)
            number = number * found.numerator / found.denominator + found.offset
    elif isinstance(value, bool) or not hasattr(value, "__float__"):
        raise InputError(name, value, _wanted(dimension))
    else:
        try:
            number = float(value)  # pyright: ignore[reportArgumentType]
        except (TypeError, ValueError, OverflowError):
            raise InputError(name, value, _wanted(dimension)) from None
    if not math.isfinite(number):
        raise InputError(name, value, _wanted(dimension))
    return number


def parse_exactly(value: object, dimension: str, *, name: str = "value") -> tuple[Fraction, Unit]:
    """Return the number as it was written, to the last digit, and its unit; errors are those of :func:`parse`.

    A value too small for a float is 0.
    """
    from fractions import Fraction

    found = parse(value, dimension, name=name)
    si = _unit(SI_UNITS[dimension], dimension, name, "")
    if not isinstance(value, str):
        return Fraction(repr(found)), si
    digits, symbol = _split(value)
    return Fraction(digits if float(digits) else 0), _unit(symbol, dimension, name, value) if symbol else si


def dimension_of(value: object, *, name: str = "value") -> str:
    """Return the dimension of text with a unit: "force" of ``"12 kN"``; a bare number is dimensionless.

    Raises
    ------
    UnitError
        An unknown unit.
    """
    symbol = _split(value)[1] if isinstance(value, str) else ""
    return _unit(symbol, None, name, str(value)).dimension


def _wanted(dimension: str) -> str:
    return f"a finite number, in {' or '.join(symbols(dimension))}"


def parse_values(value: object, dimension: str, *, name: str = "value") -> float | NDArray[Any]:
    """Convert as :func:`parse`, but a list or array gives a float64 array of the same shape.

    Elements that are NaN or infinite pass: a bad row of a batch is reported with the batch, not refused here.
    Masked elements become NaN.
    """
    if isinstance(value, str) or not hasattr(value, "__len__"):
        return parse(value, dimension, name=name)
    import numpy as np

    from clubface.support.memory import check_request

    try:
        given = np.asarray(value)
    except ValueError:
        raise InputError(name, value, "a number or an array, whose rows are of one length") from None
    if given.ndim > MOST_DIMENSIONS:
        raise InputError(name, Told(f"an array of {given.ndim} dimensions"), f"one of at most {MOST_DIMENSIONS}")
    check_request(given.size, 8)
    if given.dtype.kind in "iuf" and hasattr(value, "filled"):
        return value.astype(np.float64).filled(math.nan)  # pyright: ignore[reportAttributeAccessIssue]
    if given.dtype.kind in "iuf":
        return given.astype(np.float64)
    flat = [
        each if isinstance(each, float) else parse(each, dimension, name=f"{name}[{index}]")
        for index, each in enumerate(given.ravel().tolist())
    ]
    return np.array(flat, dtype=np.float64).reshape(given.shape)


def to_si(value: Any, symbol: str) -> Any:
    """Express a value (number or array) in the unit ``symbol`` in SI."""
    found = unit(symbol)
    return value * found.numerator / found.denominator + found.offset


def from_si(value: Any, symbol: str) -> Any:
    """Express an SI value (number or array) in the unit ``symbol``."""
    found = unit(symbol)
    return (value - found.offset) * found.denominator / found.numerator


def size(symbol: str) -> float:
    """Return the size of a unit in SI: what a difference of one of it is."""
    found = unit(symbol)
    return found.numerator / found.denominator


def show(value: float, symbol: str, digits: int = 6) -> str:
    """Write an SI value as text in the unit ``symbol``, to ``digits`` significant digits."""
    suffix = "" if symbol in ("", "1") else f" {symbol}"
    return f"{from_si(value, symbol):.{digits}g}{suffix}"


def fixed(value: float, symbol: str, decimals: int) -> str:
    """Write an SI value as text in the unit ``symbol``, to ``decimals`` places behind the point."""
    return f"{from_si(value, symbol):.{decimals}f} {symbol}"


def show_range(least: float, most: float, symbol: str) -> str:
    """Write two SI values as "``least`` to ``most``" in the unit ``symbol``."""
    return f"{from_si(least, symbol):g} to {show(most, symbol)}"


def display_unit(quantity: str, si_unit: str) -> str:
    """Return the unit people read ``quantity`` (held in ``si_unit``) in: spin in rpm, loft in degrees."""
    if quantity in DISPLAY_UNITS_BY_NAME:
        return DISPLAY_UNITS_BY_NAME[quantity]
    found = unit(si_unit)
    # What is computed of a quantity, such as its mean, is read in its unit.
    of = DISPLAY_UNITS_BY_NAME.get(quantity.rpartition("_")[0])
    if of is not None and unit(of).dimension == found.dimension:
        return of
    begins, ends = OF_A_HEAD
    if found.dimension == "length" and (quantity.startswith(begins) or quantity.endswith(ends)):
        return "mm"
    return DISPLAY_UNITS.get(found.dimension, found.symbol)


def parse_column_name(column: str, names: Collection[str] = ()) -> tuple[str, str | None]:
    """Split a column heading into quantity and unit.

    ``"club_speed_mph"``, ``"club_speed [mph]"`` and ``"club_speed (mph)"`` give ``("club_speed", "mph")``;
    ``"club_speed"`` gives ``("club_speed", None)``, which means SI. A heading found in ``names`` has no unit.
    """
    text = column.strip()
    if text in names:
        return text, None
    for opening, closing in ("[]", "()"):
        if text.endswith(closing) and opening in text:
            name, _, inner = text[:-1].rpartition(opening)
            return name.strip(), unit(inner, name=f"column {column!r}").symbol
    words = text.split("_")
    for count in (2, 1):
        suffix = "_".join(words[-count:])
        if len(words) > count and suffix not in ("1", "-") and suffix in UNITS:
            return "_".join(words[:-count]), UNITS[suffix].symbol
    return text, None


def _split(text: str) -> tuple[str, str]:
    """Split off the leading number of ``text`` ("" where there is none) and what follows it, stripped."""
    text = text.strip().replace("−", "-")
    digits = "0123456789"
    end, size = 0, len(text)
    if end < size and text[end] in "+-":
        end += 1
    start = end
    while end < size and text[end] in digits:
        end += 1
    if end < size and text[end] == ".":
        end += 1
        while end < size and text[end] in digits:
            end += 1
    if text[start:end] in ("", "."):
        return "", text
    if end < size and text[end] in "eE":
        exponent = end + 1
        if exponent < size and text[exponent] in "+-":
            exponent += 1
        last = exponent
        while last < size and text[last] in digits:
            last += 1
        if last > exponent:
            end = last
    return text[:end], text[end:].strip()
