"""All unit conversions of the package, between text with a unit and SI with radians.

Internally, everything is SI; users write ``"108 mph"`` or ``"2 deg"``. A bare number is SI. The table of units is in
the core, shared by all languages. Factors are fractions: ``"204 g"`` is ``0.204`` to the last bit.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from clubface import _core
from clubface.errors import InputError, UnitError, Wording, nearest_names

if TYPE_CHECKING:
    from fractions import Fraction

    from numpy.typing import NDArray

__all__ = [
    "DIMENSIONLESS", "SI_UNITS", "UNITS", "Unit", "dimension_of", "fixed", "from_si", "is_missing", "key", "numbers",
    "parse", "parse_column_name", "parse_exactly", "parse_values", "show", "show_range", "size", "symbols", "to_si",
    "unit",
]  # fmt: skip


DIMENSIONLESS = "dimensionless"


class Unit(NamedTuple):
    """One unit: SI value = value * numerator / denominator + offset."""

    symbol: str
    dimension: str
    numerator: float
    denominator: float
    offset: float


_SUPERSCRIPTS = str.maketrans({"²": "2", "³": "3", "^": None, "*": None, "·": None, "⋅": None, " ": None, "\t": None})


def key(spelling: str) -> str:
    """Return the common spelling of ``kg m2``, ``kg m^2``, ``kg·m²`` and ``kg*m^2``."""
    return spelling.translate(_SUPERSCRIPTS)


UNITS: dict[str, Unit] = {
    key(spelling): Unit(each["symbol"], each["dimension"], each["numerator"], each["denominator"], each["offset"])
    for each in _core.units()
    for spelling in (each["symbol"], *each["spellings"])
}
"""Every unit by its spellings, from the core."""

SI_UNITS: dict[str, str] = {
    unit.dimension: unit.symbol
    for unit in reversed(UNITS.values())
    if unit.numerator == unit.denominator and not unit.offset
}
"""The SI unit of each dimension."""

MOST_DIMENSIONS = 32
"""Maximum number of dimensions of an array in the core."""


def unit(symbol: str, *, name: str = "unit", dimension: str | None = None) -> Unit:
    """Return the unit ``symbol``, which must be of ``dimension`` if given; raise :class:`UnitError` otherwise."""
    if not isinstance(symbol, str):
        raise UnitError(name, symbol, "text, such as " + symbols(dimension)[0])
    return _unit(symbol, dimension, name, symbol)


@lru_cache(maxsize=256)
def _unit(symbol: str, dimension: str | None, name: str, value: str) -> Unit:
    """Return the unit ``symbol``, in which ``value`` was given for the quantity ``name``."""
    result = UNITS.get(key(symbol)) if symbol.strip() else UNITS["1"]
    if result is not None and dimension in (None, result.dimension):
        return result
    allowed = symbols(dimension)
    words = f"in {' or '.join(allowed)}"
    if result is not None:
        raise UnitError(name, value, f"{words}, not {'an' if result.dimension[0] in 'aei' else 'a'} {result.dimension}")
    near = nearest_names(symbol, allowed)
    raise UnitError(name, value, words + (f" (did you mean {' or '.join(near)}?)" if near else ""))


def symbols(dimension: str | None = None) -> tuple[str, ...]:
    """List the units of one dimension, or all units, with the SI unit first."""
    return tuple(dict.fromkeys(each.symbol for each in UNITS.values() if dimension in (None, each.dimension)))


def parse(value: object, dimension: str, *, name: str = "value") -> float:
    """Convert ``"108 mph"``, ``"2 deg"`` or a bare SI number to a finite float in SI.

    Text needs a unit: it comes from a file or a command, where a bare number is rarely meant in SI. Only 0 and
    dimensionless values may omit it.

    Parameters
    ----------
    value
        Text with a unit, or a real number (SI).
    dimension
        One of ``SI_UNITS``: ``"speed"``, ``"angle"``, ``"length"``, ...
    name
        Name of the quantity in errors.

    Raises
    ------
    UnitError
        The unit is unknown or of another dimension.
    InputError
        The value is not a number, is NaN, infinite, or too large for a float.
    """
    if dimension not in SI_UNITS:
        raise ValueError(f"unknown dimension {dimension!r}; known: {', '.join(SI_UNITS)}")
    if isinstance(value, str):
        digits, symbol = _split(value)
        if not digits:
            raise InputError(name, value, _wanted(dimension))
        number = float(digits)
        if symbol:
            result = _unit(symbol, dimension, name, value)
            number = number * result.numerator / result.denominator + result.offset
        elif number and SI_UNITS[dimension] != "1":
            raise InputError(name, value, f"a number, or text with its unit: {' or '.join(symbols(dimension))}")
    elif isinstance(value, bool) or not hasattr(value, "__float__") or _kind(value) not in "iuf":
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
    """Return the number exactly as written, and its unit; errors as in :func:`parse`.

    Values too small for a float are returned as 0.
    """
    from fractions import Fraction

    result = parse(value, dimension, name=name)
    si = _unit(SI_UNITS[dimension], dimension, name, "")
    if not isinstance(value, str):
        return Fraction(repr(result)), si
    digits, symbol = _split(value)
    return Fraction(digits if float(digits) else 0), _unit(symbol, dimension, name, value) if symbol else si


def _kind(value: object) -> str:
    """Return the kind of a NumPy number, and "f" for any other."""
    return getattr(getattr(value, "dtype", None), "kind", "f")


def dimension_of(value: object, *, name: str = "value") -> str:
    """Return the dimension of text with a unit: "force" of ``"12 kN"``; a bare number is dimensionless.

    Raises
    ------
    UnitError
        The unit is unknown.
    """
    symbol = _split(value)[1] if isinstance(value, str) else ""
    return _unit(symbol, None, name, str(value)).dimension


def _wanted(dimension: str) -> str:
    return f"a finite number, in {' or '.join(symbols(dimension))}"


def parse_values(value: object, dimension: str, *, name: str = "value") -> float | NDArray[Any]:
    """Convert like :func:`parse`; a list or array gives a float64 array of the same shape.

    NaN and infinite elements are accepted, because bad rows are reported with the batch. Missing elements become NaN:
    masked ones, None, pandas' NA and NaT, Arrow nulls. Truth values, complex numbers, objects and numbers as text
    without a unit raise InputError.
    """
    if isinstance(value, str) or not hasattr(value, "__len__"):
        return parse(value, dimension, name=name)
    import numpy as np

    from clubface.support.processes import check_request

    if isinstance(value, (list, tuple)) and not set(map(type, value)) <= {float, int}:
        return _parse_list(value, dimension, name)
    masked = isinstance(value, np.ma.MaskedArray)
    try:
        given = np.ma.getdata(value) if masked else np.asarray(value)
    except ValueError:
        raise InputError(name, value, _ONE_LENGTH) from None
    if given.ndim > MOST_DIMENSIONS:
        raise InputError(name, Wording(f"an array of {given.ndim} dimensions"), _FEW_DIMENSIONS)
    check_request(given.size, 8)
    if given.dtype.kind in "bcSV":
        raise InputError(name, Wording(f"an array of {given.dtype}"), _wanted(dimension))
    missing = np.ma.getmaskarray(value) if masked else np.zeros(given.shape, dtype=bool)
    if given.dtype.kind in "iuf":
        result = given.astype(np.float64)
    else:
        names = (f"{name}[{index}]" if given.ndim else name for index in range(given.size))
        flat = zip(given.ravel().tolist(), missing.ravel().tolist(), names, strict=True)
        numbers = [
            math.nan if gone or is_missing(each) else _parse_element(each, dimension, at) for each, gone, at in flat
        ]
        result = np.array(numbers, dtype=np.float64).reshape(given.shape)
    return np.where(missing, math.nan, result) if missing.any() else result


_ONE_LENGTH = "a number or an array with rows of equal length"
_FEW_DIMENSIONS = f"one of at most {MOST_DIMENSIONS}"


def _parse_list(values: list[Any] | tuple[Any, ...], dimension: str, name: str) -> NDArray[Any]:
    """Return an array from a list with anything but plain numbers, converting element by element."""
    import numpy as np

    depth, inner = name.count("["), values
    while isinstance(inner, (list, tuple)) and inner and depth < 1000:
        depth, inner = depth + 1, inner[0]
    if depth > MOST_DIMENSIONS:
        raise InputError(name.partition("[")[0], Wording(f"an array of {depth} dimensions"), _FEW_DIMENSIONS)

    def taken(each: Any, at: str) -> Any:
        if hasattr(each, "__len__") and (isinstance(each, (list, tuple)) or hasattr(each, "__array__")):
            return parse_values(each, dimension, name=at)
        return math.nan if is_missing(each) else _parse_element(each, dimension, at)

    parts = [taken(each, f"{name}[{index}]") for index, each in enumerate(values)]
    if len({np.shape(each) for each in parts}) > 1:
        raise InputError(name, values, _ONE_LENGTH)
    return np.array(parts, dtype=np.float64)


def _parse_element(value: Any, dimension: str, name: str) -> float:
    """Convert one element of a batch; infinity is accepted, because its row is reported with the batch."""
    value = _plain(value)
    return float(value) if isinstance(value, float) else parse(value, dimension, name=name)


def numbers(values: Any, *, name: str) -> NDArray[Any]:
    """Return an array of dimensionless or SI numbers, with NaN for missing ones; raise InputError for texts."""
    import numpy as np

    if type(values) is np.ndarray and values.dtype == np.float64:
        return values
    kind = getattr(getattr(values, "dtype", None), "kind", "O")
    texts = () if kind in "iuf" else np.ravel(np.asarray(values, dtype=object))
    for each in texts:
        if isinstance(each, (str, bytes)):
            raise InputError(name, each, "numbers, not text")
    return np.asarray(parse_values(values, DIMENSIONLESS, name=name))


def _plain(value: Any) -> Any:
    """Return the value of an Arrow scalar, which before pyarrow 21 is not a Python number, or any other value."""
    return value.as_py() if hasattr(value, "as_py") else value


def is_missing(value: Any) -> bool:
    """Return whether a value counts as missing: None, pandas' NA and NaT, an Arrow null, or NaN."""
    value = _plain(value)
    if value is None or type(value).__name__ in ("NAType", "NaTType"):
        return True
    return isinstance(value, float) and math.isnan(value)


def to_si(value: Any, symbol: str) -> Any:
    """Convert a number or array from the unit ``symbol`` to SI."""
    result = unit(symbol)
    return value * result.numerator / result.denominator + result.offset


def from_si(value: Any, symbol: str) -> Any:
    """Convert an SI number or array to the unit ``symbol``."""
    result = unit(symbol)
    return (value - result.offset) * result.denominator / result.numerator


def size(symbol: str) -> float:
    """Return the size of one unit in SI, as for differences, without offset."""
    result = unit(symbol)
    return result.numerator / result.denominator


def show(value: float, symbol: str, digits: int = 6) -> str:
    """Format an SI value in the unit ``symbol`` with ``digits`` significant digits."""
    suffix = "" if symbol in ("", "1") else f" {symbol}"
    return f"{from_si(value, symbol):.{digits}g}{suffix}"


def fixed(value: float, symbol: str, decimals: int) -> str:
    """Format an SI value in the unit ``symbol`` with ``decimals`` decimal places."""
    return f"{from_si(value, symbol):.{decimals}f} {symbol}"


def show_range(least: float, most: float, symbol: str) -> str:
    """Format two SI values as "``least`` to ``most``" in the unit ``symbol``."""
    return f"{from_si(least, symbol):g} to {show(most, symbol)}"


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


_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def _split(text: str) -> tuple[str, str]:
    """Split ``text`` into its leading number ("" if there is none) and the rest, stripped."""
    text = text.strip().replace("−", "-")
    number = _NUMBER.match(text)
    return (number[0], text[number.end() :].strip()) if number else ("", text)
