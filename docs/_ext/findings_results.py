"""The results of the study of the benchmark shots, and how its tables write them."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path
from typing import Any

from clubface import units
from clubface.shots.measured import QUANTITIES

TITLES = {
    "ball_speed": "Ball speed", "launch": "Launch angle", "azimuth": "Azimuth", "backspin": "Backspin",
    "sidespin": "Sidespin",
}  # fmt: skip
RESULTS = Path(__file__).parent.parent / "findings.json"
DIGITS = {"ball_speed": 2, "launch": 2, "azimuth": 2, "backspin": 0, "sidespin": 0, "spin": 0, "carry": 1}
UNITS = {**QUANTITIES, "spin": "rpm", "carry": "yd"}


@cache
def results() -> dict[str, Any]:
    """Return the results of the study."""
    return json.loads(RESULTS.read_text(encoding="utf-8"))


def shown(value: float | None, quantity: str, sign: str = "") -> str:
    """Write an SI value in the unit it is read in; None and NaN stay empty."""
    if value is None or math.isnan(value):
        return ""
    return f"{float(units.from_si(value, UNITS[quantity])):{sign}.{DIGITS[quantity]}f}"


def heads(first: str) -> list[str]:
    """Return the headings of a table over the launch quantities."""
    return [first, *(f"{TITLES[name].lower()}, {unit}" for name, unit in QUANTITIES.items())]


def percent(part: float, whole: float) -> str:
    """Write a percentage with two digits."""
    return "" if whole == 0.0 or math.isnan(part) else f"{plain_number(100.0 * part / whole, 2)}%"


def plain_number(value: float, digits: int = 3) -> str:
    """Write a value with some significant digits, and never with an exponent."""
    decimals = digits - 1 - math.floor(math.log10(abs(value))) if value else 0
    return f"{value:.{max(decimals, 0)}f}"


def duration(seconds: float) -> str:
    """Write a time with a unit that suits it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"
