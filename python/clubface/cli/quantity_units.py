"""Quantities of a launch and its flight in tables: units, digits, and the keys of JSON documents and files."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Annotated

from clubface import units
from clubface.cli import option_values, options
from clubface.reports.quantity_units import SHOWN
from clubface.support.checks import check_names

KEYS = {
    "ball_speed_mps": ("ball_speed", "m/s"), "smash": ("smash", "1"), "launch_deg": ("launch", "deg"),
    "azimuth_deg": ("azimuth", "deg"), "backspin_rpm": ("backspin", "rpm"), "sidespin_rpm": ("sidespin", "rpm"),
    "total_spin_rpm": ("total_spin", "rpm"), "spin_axis_deg": ("spin_axis", "deg"), "carry_m": ("carry", "m"),
    "side_m": ("side", "m"), "total_m": ("total", "m"), "total_side_m": ("total_side", "m"), "apex_m": ("apex", "m"),
    "landing_deg": ("landing_angle", "deg"),
}  # fmt: skip
"""Keys of JSON and columns of a file: quantity and unit."""
VALUES = {name: SHOWN[name] for name, _ in KEYS.values()}
"""Unit and digits of what is listed."""

Units = Annotated[
    list[str] | None,
    options.option("--unit", metavar="NAME=UNIT", text='The unit of a quantity for people: "carry=m". Repeatable.'),
]
Shown = Mapping[str, tuple[str, int]]
"""Unit and digits by quantity."""


def shown_units(texts: Iterable[str] | None) -> dict[str, tuple[str, int]]:
    """Return unit and digits of each quantity of a table; of another unit as many digits as tell as much."""
    told = option_values.pairs(texts or (), "--unit")
    check_names("quantity of --unit", told, VALUES)
    found = dict(VALUES)
    for name, symbol in told.items():
        usual, digits = VALUES[name]
        unit = units.unit(symbol, name="--unit", dimension=units.unit(usual).dimension).symbol
        more = round(math.log10(units.size(unit) / units.size(usual)))
        found[name] = (unit, max(0, digits + more))
    return found


def label(quantity: str, unit: str) -> str:
    """Return the name of a quantity with its unit, for a row."""
    words = quantity.replace("_", " ")
    return words if unit == "1" else f"{words}, {unit}"
