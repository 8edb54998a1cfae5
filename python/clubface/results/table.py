"""Tables of a result: columns of quantities in SI at full precision, and how they are shown."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from clubface import units
from clubface.errors import UnknownNameError
from clubface.quantities import Quantity, convert, format_number, quantity as quantity_named

if TYPE_CHECKING:
    import pandas


Layout = Literal["rows", "list", "transposed", "pivot"]
"""Layout of a printed table: one line per row; its only row as a list; one line per column; or a pivot of its third
column, with the values of the first two as headings of lines and columns."""
FLAT = "flat"
"""Text for an infinite radius of a face."""
_SUFFIXES = {"m/s": "mps", "deg/s": "degps", "rad/s": "radps", "km/h": "kmh", "%": "pct"}


@dataclass(frozen=True)
class Column:
    """One column of a table.

    Attributes
    ----------
    name
        Name in files, without the unit.
    values
        One value per row: number in SI, whole number, truth value, text, or None if missing.
    quantity
        Quantity of the numbers; None for texts and counts. A sequence has one per row.
    label
        Heading. Default: the label of the quantity.
    unit, digits
        Unit and decimal places when printed. Default: those of the quantity. Negative ``digits`` are significant
        digits; a sequence has one per row.
    difference
        Whether the numbers are differences, to which the offset of a unit does not apply.
    signed
        Whether numbers are printed with their sign. Default: for differences.
    in_files
        Whether files and JSON include it; printed-only columns repeat in words what others give in numbers.
    printed
        Whether it is printed; otherwise it is only in files and JSON.
    """

    name: str
    values: Sequence[Any]
    quantity: Quantity | Sequence[Quantity | None] | None = None
    label: str = ""
    unit: str | None = None
    digits: int | Sequence[int] | None = None
    difference: bool = False
    signed: bool | None = None
    in_files: bool = True
    printed: bool = True

    def quantity_at(self, row: int) -> Quantity | None:
        """Return the quantity of one row."""
        if self.quantity is None or isinstance(self.quantity, Quantity):
            return self.quantity
        return self.quantity[row]

    @property
    def is_mixed(self) -> bool:
        """Whether the rows hold different quantities."""
        return not isinstance(self.quantity, (Quantity, type(None)))

    @property
    def heading(self) -> str:
        """The heading of the column."""
        own = self.quantity.label if isinstance(self.quantity, Quantity) else ""
        return self.label or own or self.name.replace("_", " ")

    @property
    def key(self) -> str:
        """The name of the column in files, with the unit: "ball_speed_mps"."""
        if not isinstance(self.quantity, Quantity) or self.quantity.metric.unit == "1":
            return self.name
        unit = self.quantity.metric.unit
        return f"{self.name}_{_SUFFIXES.get(unit) or unit.replace(' ', '_').replace('/', '_per_')}"

    def exact(self, row: int) -> Any:
        """Return the value of a row for files, with all its digits; None if it is missing."""
        value = self.values[row]
        if hasattr(value, "item"):
            value = value.item()
        quantity = self.quantity_at(row)
        if quantity is not None and value is not None:
            value = (
                FLAT
                if value == math.inf and quantity.dimension == "length"
                else convert(value, quantity.metric.unit, difference=self.difference)
            )
        return None if isinstance(value, float) and not math.isfinite(value) else value

    def shown(self, row: int, shown_units: Mapping[str, str] | None = None) -> str:
        """Return the value of a row as it is shown, without its unit."""
        value, quantity = self.values[row], self.quantity_at(row)
        if value is None:
            return ""
        if isinstance(value, bool) or type(value).__name__ == "bool":
            return "yes" if value else "no"
        if isinstance(value, str):
            return value
        digits = self.digits if self.digits is None or isinstance(self.digits, int) else self.digits[row]
        if quantity is None:
            whole = float(value).is_integer() and digits is None
            return str(int(value)) if whole else self._number(float(value), digits or 0)
        unit = self.printed_unit_at(row, shown_units)
        digits = quantity.digits(unit) if digits is None else digits
        return self._number(float(convert(value, unit, difference=self.difference)), digits)

    def printed_unit_at(self, row: int, shown_units: Mapping[str, str] | None = None) -> str:
        """Return the unit in which a row is printed; ``shown_units`` are the requested ones, by quantity."""
        quantity = self.quantity_at(row)
        if quantity is None:
            return "1"
        asked = shown_units or {}
        return asked.get(quantity.name) or asked.get(self.name) or self.unit or quantity.reading.unit

    @property
    def _signed(self) -> bool:
        return self.difference if self.signed is None else self.signed

    def _number(self, value: float, digits: int) -> str:
        if math.isinf(value):
            return FLAT if value > 0.0 else str(value)
        if digits < 0:
            return "" if math.isnan(value) else f"{value + 0.0:{'+' if self._signed else ''}.{-digits}g}"
        return format_number(value, digits, signed=self._signed)


@dataclass(frozen=True)
class Table:
    """A table of a result.

    Attributes
    ----------
    name
        Name in JSON and of its CSV file.
    columns
        At least one column; texts that name the rows come first.
    title
        In words.
    layout
        Layout when printed.
    summary
        Whether the last row summarises the others and is set apart.
    printed
        Whether the terminal shows it; otherwise only files, JSON and reports have it.
    shown_rows
        Rows shown to people; None for all. Files and JSON have all rows.
    """

    name: str
    columns: tuple[Column, ...]
    title: str = ""
    layout: Layout = "rows"
    summary: bool = False
    printed: bool = True
    shown_rows: Sequence[int] | None = None

    def __post_init__(self) -> None:
        lengths = {each.name: len(each.values) for each in self.columns}
        if len(set(lengths.values())) > 1:
            raise ValueError(f"table {self.name}: columns of different lengths: {lengths}")
        if len(lengths) < len(self.columns):
            raise ValueError(f"table {self.name}: two columns have the same name")

    def __len__(self) -> int:
        return len(self.columns[0].values)

    def __getitem__(self, name: str) -> Column:
        for each in self.columns:
            if each.name == name:
                return each
        raise UnknownNameError(f"column of {self.name}", name, [each.name for each in self.columns])

    @property
    def file_columns(self) -> tuple[Column, ...]:
        """The columns of files; quantities and units that differ from row to row become columns at the front."""
        kept: list[Column] = []
        named = any(each.name == "quantity" for each in self.columns)
        before: list[str] | None = None
        for each in (one for one in self.columns if one.in_files):
            if each.is_mixed:
                quantities = [each.quantity_at(row) for row in range(len(self))]
                if before is None and not named:
                    kept.append(text("quantity", ["" if one is None else one.name for one in quantities]))
                units_of = ["" if one is None else one.metric.unit for one in quantities]
                if units_of != before:
                    kept.append(text("unit" if before is None else f"{each.name}_unit", units_of))
                before = units_of
            kept.append(each)
        return tuple(kept)

    def keys(self) -> list[str]:
        """Return the headings of the columns in files."""
        return [each.key for each in self.file_columns]

    def records(self) -> list[dict[str, Any]]:
        """Return the rows as written to files, by heading: full digits, metric units."""
        columns = self.file_columns
        return [{each.key: each.exact(row) for each in columns} for row in range(len(self))]

    def describe(self) -> dict[str, Any]:
        """Return quantity, unit, label and meaning of every column, by its heading in files."""
        described = {}
        for each in self.file_columns:
            quantity = each.quantity if isinstance(each.quantity, Quantity) else None
            described[each.key] = {"label": each.heading} | (
                {}
                if quantity is None
                else {"quantity": quantity.name, "unit": quantity.metric.unit, "meaning": quantity.meaning}
            )
        return described

    def csv_rows(self) -> Iterator[list[Any]]:
        """Yield the headings and the rows for a CSV file; missing values are empty."""
        yield self.keys()
        for record in self.records():
            yield ["" if value is None else value for value in record.values()]

    def to_pandas(self) -> pandas.DataFrame:
        """Return the rows as SI values; ``attrs["units"]`` has the units."""
        import pandas

        kept = [each for each in self.columns if each.in_files]
        frame = pandas.DataFrame({each.name: list(each.values) for each in kept})
        frame.attrs["units"] = {each.name: each.quantity.unit for each in kept if isinstance(each.quantity, Quantity)}
        return frame


def table(name: str, *columns: Column | None, **options: Any) -> Table:
    """Return a table of the columns that are not None; options as for :class:`Table`."""
    return Table(name, tuple(each for each in columns if each is not None), **options)


def column(name: str, values: Any, like: str | Quantity | None = None, **options: Any) -> Column:
    """Return a column of numbers in SI. Its quantity is the one called ``name`` if there is one, else ``like``.

    ``like`` may be the name of a quantity or an SI unit, such as "m".
    """
    if like is None or like == name:
        quantity = quantity_named(name)
    elif isinstance(like, Quantity):
        quantity = like
    elif like in units.SI_UNITS.values():
        quantity = quantity_named(name, like)
    else:
        quantity = quantity_named(like)._replace(label=name.replace("_", " "))
    return Column(name, _sequence(values), quantity, **options)


def text(name: str, values: Sequence[Any], **options: Any) -> Column:
    """Return a column of texts, whole numbers or truth values."""
    return Column(name, _sequence(values), None, **options)


def row_names(name: str, names: Sequence[str], labels: Sequence[str]) -> tuple[Column, Column]:
    """Return the names of the rows for files, and their labels for print, both as the column ``name``."""
    return text(name, names, printed=False), text(f"{name} in words", labels, label=name, in_files=False)


def _sequence(values: Any) -> Sequence[Any]:
    return values.reshape(-1).tolist() if hasattr(values, "reshape") else list(values)
