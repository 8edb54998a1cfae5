"""Metals of heads: elastic, or with a yield stress and hardening.

How a metal hardens once it yields.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import Any

from clubface import units
from clubface.errors import InputError, Told
from clubface.fem import core
from clubface.support.checks import check_choice, check_count, check_names

MAX_HARDENING_POINTS = 8


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
                raise InputError(
                    "hardening", given, f"1 to {MAX_HARDENING_POINTS} points of plastic strain and yield stress"
                )
            return cls(table=tuple(given))
        return cls(modulus=units.parse(given, "pressure", name="hardening"))


def _point(given: Any) -> tuple[float, float]:
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2:
        raise InputError("hardening", given, "points of plastic strain and yield stress")
    strain = units.parse(given[0], units.DIMENSIONLESS, name="hardening")
    return strain, units.parse(given[1], "pressure", name="hardening")


def _check_table(table: Sequence[tuple[float, float]]) -> None:
    if len(table) > MAX_HARDENING_POINTS:
        raise InputError("hardening", f"{len(table)} points", f"1 to {MAX_HARDENING_POINTS} points")
    strains, stresses = zip(*table, strict=True)
    if strains[0] != 0.0 or any(not a < b for a, b in pairwise(strains)):
        raise InputError("hardening", list(strains), "plastic strains that begin at 0 and increase")
    if not stresses[0] > 0.0 or any(not a <= b for a, b in pairwise(stresses)):
        shown = [units.show(stress, "MPa") for stress in stresses]
        raise InputError("hardening", shown, "stresses above 0 that do not fall: a metal that softens fails at once")


RULES = {"gauss": 2, "lobatto": 3}
"""Rules of points through the thickness, and the fewest points of each."""
POINTS = 8
"""Of a curve of hardening that is no table."""
MAX_POINTS = 31


@dataclass(frozen=True, kw_only=True)
class Metal:
    """A metal, elastic until it yields. By default it is the usual titanium alloy Ti-6Al-4V, elastic.

    Attributes
    ----------
    youngs
        Young's modulus [Pa].
    poisson
        Poisson's ratio.
    density
        Density [kg/m3].
    yield_stress
        Stress in tension at which it yields [Pa], ``yield`` in files; None for a metal that stays elastic.
    hardening
        Increase of the yield stress: a modulus [Pa], a :class:`Hardening`, or a table of plastic strain and yield
        stress [Pa] whose first point is where it yields; None for a metal that does not harden.
    points
        Points through the thickness of shells. None means five in a metal that yields, and none in an elastic one, for
        which stress resultants are as accurate.
    rule
        Where the points lie: "gauss", or "lobatto" with points on both surfaces.
    """

    youngs: float = 114e9
    poisson: float = 0.34
    density: float = 4430.0
    yield_stress: float | None = None
    hardening: Hardening | None = None
    points: int | None = None
    rule: str = "gauss"

    def __post_init__(self) -> None:
        for name, dimension in (("youngs", "pressure"), ("density", "density"), ("poisson", units.DIMENSIONLESS)):
            object.__setattr__(self, name, units.parse(getattr(self, name), dimension, name=name))
        if not 1e8 <= self.youngs <= 1e12:
            raise InputError("youngs", units.show(self.youngs, "GPa"), "0.1 to 1000 GPa")
        if not -1.0 < self.poisson < 0.5:
            raise InputError("poisson", self.poisson, "above -1 and below 0.5")
        if not 100.0 <= self.density <= 25e3:
            raise InputError("density", units.show(self.density, "kg/m3"), "100 to 25000 kg/m3")
        self._read_yield()
        check_choice("rule", self.rule, RULES)
        if self.points is not None:
            check_count("points", self.points, RULES[self.rule], MAX_POINTS)

    def _read_yield(self) -> None:
        if self.yield_stress is not None:
            value = units.parse(self.yield_stress, "pressure", name="yield")
            object.__setattr__(self, "yield_stress", value)
        if self.hardening is not None:
            object.__setattr__(self, "hardening", Hardening.of(self.hardening))
            table = self.hardening.table
            if table and self.yield_stress is None:
                object.__setattr__(self, "yield_stress", table[0][1])
            if self.yield_stress is None:
                raise InputError("hardening", Told("without yield"), "give yield as well, or leave hardening out")
            if table and self.yield_stress != table[0][1]:
                shown = units.show(self.yield_stress, "MPa")
                raise InputError("yield", shown, "leave it out, or give the stress of the first point of hardening")
        if self.yield_stress is not None and not 1e6 <= self.yield_stress <= 0.1 * self.youngs:
            raise InputError("yield", units.show(self.yield_stress, "MPa"), "1 MPa to a tenth of youngs")

    def curve(self) -> list[tuple[float, float]]:
        """Return plastic strains and yield stresses [Pa]: those of the table, or ``POINTS`` up to a strain of 20%."""
        if self.yield_stress is None:
            return []
        hardening = self.hardening or Hardening()
        if hardening.table:
            # A curve needs two points.
            last = (hardening.table[-1][0] + 0.2, hardening.table[-1][1])
            return list(hardening.table) if len(hardening.table) > 1 else [*hardening.table, last]
        # Closer where a saturating metal hardens most.
        strains = [0.2 * (number / (POINTS - 1)) ** 2 for number in range(POINTS)]
        return list(zip(strains, self.flow_stress(strains), strict=True))

    def flow_stress(self, strains: Sequence[float]) -> list[float]:
        """Return the stresses [Pa] at which a yielding metal flows, at the given plastic strains."""
        metal = self.plastic()
        if metal is None:
            raise InputError("yield", None, "give it: without it this metal stays elastic")
        return core.fem_yield_stress(metal, list(strains))

    def plastic(self) -> dict[str, Any] | None:
        """Return yield and hardening as the core takes them; None for an elastic metal."""
        if self.yield_stress is None:
            return None
        hardening = self.hardening or Hardening()
        return {
            "yield_stress": self.yield_stress,
            "modulus": hardening.modulus,
            "gain": hardening.gain,
            "rate": hardening.rate,
            "table": list(hardening.table),
        }
