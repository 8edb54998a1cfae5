"""The types of values in files: how each is read, checked, written and described.

Every type has the methods of :class:`Value`. Values are read in SI and in the form that the program uses.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from clubface import units
from clubface.schema.document import Place, quoted
from clubface.support.checks import check_choice, is_count, is_name, is_text
from clubface.support.files import resolve_name

__all__ = [
    "FLAG", "NAME", "TEXT", "Choice", "Either", "FilePath", "Interval", "Items", "PhysicalValue", "Record", "Reference",
    "Simple", "Tables", "Unread", "Value", "count", "written",
]  # fmt: skip

OPEN = "none"
"""Word for an open end of an interval."""


class Value:
    """A type of value."""

    def read(self, given: Any, place: Place) -> Any:
        """Return the value read from a file or mapping; raise ``InputError`` if it is not allowed."""
        raise NotImplementedError

    def check(self, value: Any, place: Place) -> Any:
        """Check and return a value given in Python, which may already have the form that :meth:`read` returns."""
        return self.read(value, place)

    def write(self, value: Any) -> str:
        """Return a value as TOML."""
        return (
            quoted(value) if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else repr(value)
        )

    def show(self, value: Any) -> str:
        """Return a value as shown in the documentation."""
        return self.write(value).strip('"')

    def json(self) -> dict[str, Any]:
        """Return the JSON Schema of the value."""
        return {}

    def words(self) -> str:
        """Return what is allowed, in words."""
        return ""

    def keys(self) -> Mapping[str, Any]:
        """Return the keys of a table, or of the tables in a list."""
        return {}


@dataclass(repr=False, eq=False)
class Simple(Value):
    """A value that is kept unchanged.

    Attributes
    ----------
    allowed
        Description of allowed values in errors.
    accepts
        Function that returns whether a value is allowed.
    schema
        JSON Schema of the value.
    """

    allowed: str = ""
    accepts: Callable[[Any], bool] = lambda value: True
    schema: Mapping[str, Any] = field(default_factory=dict)

    def read(self, given: Any, place: Place) -> Any:
        if not self.accepts(given):
            raise place.invalid(given, self.allowed)
        return given

    def json(self) -> dict[str, Any]:
        return dict(self.schema)

    def words(self) -> str:
        return self.allowed


FLAG = Simple("true or false", lambda value: isinstance(value, bool), {"type": "boolean"})
TEXT = Simple("text in quotes", is_text, {"type": "string"})
NAME = Simple("printable text, not empty", is_name, {"type": "string", "minLength": 1})


def count(least: int, most: int) -> Simple:
    """Return the type of a whole number within limits."""
    schema = {"type": "integer", "minimum": least, "maximum": most}
    return Simple(f"a whole number from {least} to {most}", lambda value: is_count(value, least, most), schema)


ROUNDING = 1e-12
"""Relative tolerance for a limit that is a round number in a unit other than SI."""


@dataclass(repr=False, eq=False)
class PhysicalValue(Value):
    """A number with a unit: text names its unit, and a bare number is SI.

    Attributes
    ----------
    unit
        Unit in which users write it; "1" for none.
    lower, upper
        Inclusive limits in that unit.
    above, below
        Exclusive limits in that unit.
    allowed
        Description of allowed values in errors. Default: derived from the limits.
    special
        Words for special numbers [SI], such as "flat".
    decimals
        Number of decimal places written. Default: as many as needed to restore the exact value.
    """

    unit: str
    lower: float | None = None
    upper: float | None = None
    above: float | None = None
    below: float | None = None
    allowed: str = ""
    special: Mapping[str, float] = field(default_factory=dict)
    decimals: int | None = None

    @property
    def dimension(self) -> str:
        """The dimension, as in :mod:`clubface.units`."""
        return units.unit(self.unit).dimension

    @property
    def _limits(self) -> tuple[float | None, ...]:
        return self.lower, self.upper, self.above, self.below

    def read(self, given: Any, place: Place) -> float:
        if isinstance(given, str | float) and self.special:
            given = self.special.get(given, given) if isinstance(given, str) else given
            if given in self.special.values():
                return given
        value = units.parse(given, self.dimension, name=place.title)
        low, high, above, below = (None if each is None else units.to_si(each, self.unit) for each in self._limits)
        if ((low is not None and value < low - ROUNDING * abs(low))
                or (high is not None and value > high + ROUNDING * abs(high))
                or (above is not None and value <= above) or (below is not None and value >= below)):  # fmt: skip
            shown = value if self.unit == "1" else units.show(value, self.unit)
            raise place.invalid(shown, self.allowed or self.words())
        return value

    def write(self, value: float) -> str:
        word = next((word for word, number in self.special.items() if number == value), None)
        if word is None and self.decimals is not None:
            word = f"{round(units.from_si(value, self.unit), self.decimals) + 0.0:.10g} {self.unit}"
        return repr(value) if self.unit == "1" else quoted(word or written(value, self.unit))

    def show(self, value: float) -> str:
        word = next((word for word, number in self.special.items() if number == value), None)
        return word or units.show(value, self.unit)

    def json(self) -> dict[str, Any]:
        pairs = zip(("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum"), self._limits, strict=True)
        limits = {name: each for name, each in pairs if each is not None and self.unit == "1"}
        return {"type": ["string", "number"], **limits}

    def words(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        if self.lower is not None and self.upper is not None:
            return f"{self.lower:g} to {self.upper:g}{unit}"
        names = ("from", "at most", "above", "below")
        limits = [f"{name} {each:g}{unit}" for name, each in zip(names, self._limits, strict=True) if each is not None]
        return " and ".join(limits) or (f"in {self.unit}" if unit else "a number")


@dataclass(repr=False, eq=False)
class Unread(Value):
    """A value that is checked but kept as given, for code that reads it later."""

    kind: Value

    def read(self, given: Any, place: Place) -> Any:
        self.kind.read(given, place)
        return given

    def json(self) -> dict[str, Any]:
        return self.kind.json()

    def words(self) -> str:
        return self.kind.words()


@dataclass(repr=False, eq=False)
class Choice(Value):
    """One of several words.

    Attributes
    ----------
    choices
        The words, with their values if these differ from the words; or a function that returns them.
    what
        Name of a word in messages. Default: the key.
    """

    choices: Collection[str] | Mapping[str, Any] | Callable[[], Collection[str]]
    what: str = ""

    @property
    def known(self) -> Mapping[str, Any]:
        """The value of each word."""
        choices = self.choices() if callable(self.choices) else self.choices
        return choices if isinstance(choices, Mapping) else {each: each for each in choices}

    def read(self, given: Any, place: Place) -> Any:
        check_choice(self.what or place.title, given, self.known)
        return self.known[given]

    def check(self, value: Any, place: Place) -> Any:
        stands_for_itself = not isinstance(value, str) and value in list(self.known.values())
        return value if stands_for_itself else self.read(value, place)

    def write(self, value: Any) -> str:
        return quoted(next(word for word, each in self.known.items() if each == value))

    def json(self) -> dict[str, Any]:
        return {"enum": list(self.known)}

    def words(self) -> str:
        return ", ".join(f"`{each}`" for each in self.known)


@dataclass(repr=False, eq=False)
class Items(Value):
    """A list of values of one type, read as a tuple; ``allowed`` is the error text for a wrong length."""

    item: Value
    least: int = 0
    most: int | None = None
    allowed: str = ""

    def read(self, given: Any, place: Place) -> tuple[Any, ...]:
        if not isinstance(given, list | tuple) or not self.least <= len(given) <= (self.most or len(given)):
            raise place.invalid(given, self.words())
        return tuple(self.item.read(each, place) for each in given)

    def write(self, value: Any) -> str:
        return f"[{', '.join(map(self.item.write, value))}]"

    def json(self) -> dict[str, Any]:
        most = {} if self.most is None else {"maxItems": self.most}
        return {"type": "array", "items": self.item.json(), "minItems": self.least, **most}

    def words(self) -> str:
        return self.allowed or f"a list, each {self.item.words()}"


@dataclass(repr=False, eq=False)
class Interval(Value):
    """The smallest and largest value of a quantity.

    Attributes
    ----------
    quantity
        Type of both ends, with unit and limits.
    example
        Example as written in a file.
    no_limits
        Ends [SI] represented by the word "none"; None if both ends are required.
    is_range
        Whether the ends must differ.
    """

    quantity: PhysicalValue
    example: str = '["8 deg", "14 deg"]'
    no_limits: tuple[float, float] | None = None
    is_range: bool = True

    def read(self, given: Any, place: Place) -> tuple[float, float]:
        if not isinstance(given, list | tuple) or len(given) != 2:
            raise place.invalid(given, self.words())
        ends = self.no_limits or (math.nan, math.nan)
        low, high = (
            end if self.no_limits and each in (OPEN, end) else self.quantity.read(each, place)
            for each, end in zip(given, ends, strict=True)
        )
        if low > high or (self.is_range and low == high) or (low, high) == ends:
            raise place.invalid(given, self.words())
        return low, high

    def write(self, value: Any) -> str:
        ends = zip(value, self.no_limits or (math.nan, math.nan), strict=True)
        return f"[{', '.join(quoted(OPEN) if each == end else self.quantity.write(each) for each, end in ends)}]"

    def json(self) -> dict[str, Any]:
        return {"type": "array", "items": {"type": ["string", "number"]}, "minItems": 2, "maxItems": 2}

    def words(self) -> str:
        no_limit = f'; "{OPEN}" is no limit' if self.no_limits else ""
        return f"two values, least and greatest, as in {self.example}{no_limit}"


@dataclass(repr=False, eq=False)
class Record(Value):
    """A table that is read as a dictionary.

    Attributes
    ----------
    values
        Types of values by key, or a function that returns them; or one type for all keys.
    required
        Required keys.
    example
        Example as written in a file; if given, the table is written in braces.
    make
        Function that converts the values and their place to another object.
    """

    values: Mapping[str, Value] | Callable[[], Mapping[str, Value]] | Value
    required: Collection[str] = ()
    example: str = ""
    make: Callable[[dict[str, Any], Place], Any] | None = None

    def read(self, given: Any, place: Place) -> Any:
        if not isinstance(given, Mapping):
            example = f", as in {self.example}" if self.example else f": [{place.name}]" if place.document else ""
            raise place.invalid(given, f"a table{example}")
        kinds = dict.fromkeys(given, self.values) if isinstance(self.values, Value) else self.keys()
        place.check_keys(given, kinds, self.required)
        values = {}
        for key, kind in kinds.items():
            if key in given:
                with (at := place.key(key)).errors():
                    values[key] = kind.read(given[key], at)
        return values if self.make is None else self.make(values, place)

    def write(self, value: Any) -> str:
        pairs = getattr(value, "_asdict", lambda: value)().items()
        kinds = dict.fromkeys(dict(pairs), self.values) if isinstance(self.values, Value) else self.keys()
        return "{ " + ", ".join(f"{key} = {kinds[key].write(each)}" for key, each in pairs) + " }"

    def json(self) -> dict[str, Any]:
        if isinstance(self.values, Value):
            return {"type": "object", "additionalProperties": self.values.json()}
        keys = {key: each.json() for key, each in self.keys().items()}
        return {"type": "object", "properties": keys, "required": list(self.required), "additionalProperties": False}

    def words(self) -> str:
        words = self.values.words() if isinstance(self.values, Value) else ""
        return f"a table, each {words}" if words else "a table"

    def keys(self) -> Mapping[str, Any]:
        return {} if isinstance(self.values, Value) else self.values() if callable(self.values) else self.values


@dataclass(repr=False, eq=False)
class Tables(Value):
    """A list of tables, each under a heading in double brackets; names must be unique.

    Attributes
    ----------
    table
        Type of each table.
    what
        Word before its name in messages, as in "x of trim toe".
    least, most
        Minimum and maximum number of tables.
    """

    table: Value
    what: str = ""
    least: int = 0
    most: int | None = None

    def read(self, given: Any, place: Place) -> Any:
        if not (isinstance(given, list | tuple) and all(isinstance(each, Mapping) for each in given)):
            raise place.invalid(given, self.words().format(place.name))
        if not self.least <= len(given) <= (self.most or len(given)):
            raise place.invalid(len(given), f"{self.least} to {self.most}" if self.most else f"at least {self.least}")
        tables, names = [], set[str]()
        for index, each in enumerate(given):
            name = each.get("name")
            at = place.item(index, f"{self.what} {name}".strip() if isinstance(name, str) and name.strip() else "")
            with at.errors():
                if isinstance(name, str):
                    if name in names:
                        raise at.key("name").invalid(name, "unique")
                    names.add(name)
                tables.append(self.table.read(each, at))
        return tuple(tables)

    def check(self, value: Any, place: Place) -> Any:
        return value

    def rows(self, value: Any) -> Iterable[Any]:
        return value

    def json(self) -> dict[str, Any]:
        return Items(self.table, self.least, self.most).json()

    def words(self) -> str:
        return "tables, each under [[{}]]"

    def keys(self) -> Mapping[str, Any]:
        return self.table.keys()


@dataclass(repr=False, eq=False)
class Reference(Value):
    """A built-in name, or the path of a file, relative to the folder of the file that names it."""

    load: Callable[[Any], Any]

    def read(self, given: Any, place: Place) -> Any:
        return self.load(resolve_name(TEXT.read(given, place), place.folder) if place.folder else given)

    def check(self, value: Any, place: Place) -> Any:
        return self.load(value)

    def json(self) -> dict[str, Any]:
        return TEXT.json()

    def words(self) -> str:
        return "a name or a file"


class FilePath(Simple):
    """The path of a file, relative to the folder of the file that names it."""

    def read(self, given: Any, place: Place) -> Any:
        return (place.folder or Path()) / TEXT.read(given, place)

    def check(self, value: Any, place: Place) -> Any:
        return value


@dataclass(repr=False, eq=False)
class Either(Value):
    """A value of one of several types, told apart by their TOML type; ``allowed`` names them in messages."""

    kinds: Mapping[type, Value]
    allowed: str

    def read(self, given: Any, place: Place) -> Any:
        for each, kind in self.kinds.items():
            if isinstance(given, each) and isinstance(given, bool) == (each is bool):
                return kind.read(given, place)
        raise place.invalid(given, self.allowed)

    def write(self, value: Any) -> str:
        first, *_ = self.kinds.values()
        pairs = self.kinds.items()
        return next((kind for each, kind in pairs if isinstance(value, tuple if each is list else each)), first).write(
            value
        )

    def json(self) -> dict[str, Any]:
        return {"anyOf": [each.json() for each in self.kinds.values()]}

    def words(self) -> str:
        return self.allowed


def written(value: float, unit: str) -> str:
    """Return a number [SI] as text that parses to exactly the same value, in ``unit`` if possible."""
    dimension = units.unit(unit).dimension
    for symbol in (unit, units.SI_UNITS[dimension]):
        number = float(units.from_si(value, symbol))
        neighbours = (number, math.nextafter(number, 0.0), math.nextafter(number, 1e300))
        for digits in (f"{number:.15g}", *map(repr, neighbours)):
            text = digits + ("" if symbol == "1" else f" {symbol}")
            if math.isfinite(float(digits)) and units.parse(text, dimension) == value:
                return text
    return f"{value!r} {units.SI_UNITS[dimension]}"
