"""Which limits a head breaks, in words."""

from __future__ import annotations

from collections.abc import Mapping

from clubface import units
from clubface.design.shells.study import QUANTITIES

DIGITS = {"mph": 2, "yd": 1, "us": 1, "MPa": 0, "g": 1, "g cm2": 0, "cm3": 1, "mm": 3, "deg": 2}
"""Digits after the point, by unit."""


def number(value: float, unit: str) -> str:
    """Return a value [SI] in a unit, without it."""
    return units.fixed(value, unit, DIGITS[unit]).removesuffix(f" {unit}").strip()


def broken(limits: Mapping[str, tuple[float, float]], values: Mapping[str, float]) -> str:
    """Return which limits are broken, and by what values."""
    told = []
    for name, (least, most) in limits.items():
        words, _, unit = QUANTITIES[name]
        value = values[name]
        if not least <= value <= most:
            limit, beyond = (most, "above") if value > most else (least, "below")
            told.append(f"{words} {number(value, unit)} {unit} {beyond} {number(limit, unit)} {unit}")
    return ", ".join(told)
