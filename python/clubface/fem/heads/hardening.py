"""How a metal hardens once it yields."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_names

MAX_POINTS = 8


@dataclass(frozen=True, kw_only=True)
class Hardening:
    """Increase of the yield stress with the plastic strain p: ``modulus p + gain (1 - exp(-rate p))``; or a table.

    Attributes
    ----------
    modulus
        Modulus of linear hardening [Pa].
    gain
        Final gain of Voce's saturating hardening [Pa].
    rate
        Rate of saturation: 63% of the gain is reached at a plastic strain of 1 / rate.
    table
        Points of plastic strain, the first 0, and yield stress [Pa], joined by straight lines and constant after the
        last; or none.
    """

    modulus: float = 0.0
    gain: float = 0.0
    rate: float = 0.0
    table: tuple[tuple[float, float], ...] = ()

    def __post_init__(self) -> None:
        for name, dimension in (("modulus", "pressure"), ("gain", "pressure"), ("rate", units.DIMENSIONLESS)):
            value = units.parse(getattr(self, name), dimension, name=f"hardening.{name}")
            object.__setattr__(self, name, value)
            if not 0.0 <= value < math.inf:
                shown = value if dimension == units.DIMENSIONLESS else units.show(value, "MPa")
                raise InputError(
                    f"hardening.{name}", shown, "zero or above: a metal that softens fails where it yields first"
                )
        if (self.gain > 0.0) != (self.rate > 0.0):
            name, other = ("gain", "rate") if self.gain > 0.0 else ("rate", "gain")
            raise InputError(f"hardening.{name}", getattr(self, name), f"give {other} as well")
        object.__setattr__(self, "table", tuple(_point(each) for each in self.table))
        if self.table:
            _check_table(self.table)

    @classmethod
    def of(cls, given: Any) -> Hardening:
        """Return the hardening given by a modulus, by names and values, or by the points of a table."""
        if isinstance(given, Hardening):
            return given
        if isinstance(given, Mapping):
            known = [each.name for each in fields(cls) if each.name != "table"]
            check_names("key of hardening", given, known)
            return cls(**given)
        if isinstance(given, Sequence) and not isinstance(given, str):
            if not given:
                raise InputError("hardening", given, f"1 to {MAX_POINTS} points of plastic strain and yield stress")
            return cls(table=tuple(given))
        return cls(modulus=units.parse(given, "pressure", name="hardening"))


def _point(given: Any) -> tuple[float, float]:
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2:
        raise InputError("hardening", given, "points of plastic strain and yield stress")
    strain = units.parse(given[0], units.DIMENSIONLESS, name="hardening")
    return strain, units.parse(given[1], "pressure", name="hardening")


def _check_table(table: Sequence[tuple[float, float]]) -> None:
    if len(table) > MAX_POINTS:
        raise InputError("hardening", f"{len(table)} points", f"1 to {MAX_POINTS} points")
    strains, stresses = zip(*table, strict=True)
    if strains[0] != 0.0 or any(not a < b for a, b in pairwise(strains)):
        raise InputError("hardening", list(strains), "plastic strains that begin at 0 and increase")
    if not stresses[0] > 0.0 or any(not a <= b for a, b in pairwise(stresses)):
        shown = [units.show(stress, "MPa") for stress in stresses]
        raise InputError("hardening", shown, "stresses above 0 that do not fall: a metal that softens fails at once")
