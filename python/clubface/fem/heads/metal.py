"""Metals of heads: elastic, or with a yield stress and hardening."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from clubface import _core as core, units
from clubface.errors import InputError, Wording
from clubface.schema import Choice, PhysicalValue, Place, Table, Value, check_values, count, file_key
from clubface.support.checks import check_count

MAX_HARDENING_POINTS = 8


HARDENS = "zero or above: a metal that softens fails where it yields first"
STRESS = PhysicalValue("MPa", lower=0, allowed=HARDENS, decimals=4)


@dataclass(frozen=True, kw_only=True)
class Hardening:
    """Rise of the yield stress with plastic strain p: ``modulus p + gain (1 - exp(-rate p))``, or a table.

    ``table`` holds points of plastic strain, starting at 0, and yield stress [Pa], interpolated linearly and constant
    after the last; it is empty if the formula is used.
    """

    modulus: float = file_key(STRESS, "modulus of linear hardening", default=0.0)
    gain: float = file_key(STRESS, "final gain of Voce's saturating hardening", default=0.0)
    rate: float = file_key(
        PhysicalValue("1", lower=0, allowed=HARDENS),
        "rate of saturation: 63% of the gain is reached at a plastic strain of 1 / rate", default=0.0,
    )  # fmt: skip
    table: tuple[tuple[float, float], ...] = ()

    def __post_init__(self) -> None:
        check_values(self)
        if (self.gain > 0.0) != (self.rate > 0.0):
            name, other = ("gain", "rate") if self.gain > 0.0 else ("rate", "gain")
            raise InputError(f"hardening.{name}", getattr(self, name), f"give {other} as well")
        object.__setattr__(self, "table", tuple(_point(each) for each in self.table))
        if not self.table:
            return
        if len(self.table) > MAX_HARDENING_POINTS:
            raise InputError("hardening", f"{len(self.table)} points", f"1 to {MAX_HARDENING_POINTS} points")
        strains, stresses = zip(*self.table, strict=True)
        if strains[0] != 0.0 or any(not a < b for a, b in pairwise(strains)):
            raise InputError("hardening", list(strains), "plastic strains that begin at 0 and increase")
        if not stresses[0] > 0.0 or any(not a <= b for a, b in pairwise(stresses)):
            shown = [units.show(stress, "MPa") for stress in stresses]
            raise InputError(
                "hardening", shown, "positive stresses that do not decrease; a softening metal fails at once"
            )


def _point(given: Any) -> tuple[float, float]:
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2:
        raise InputError("hardening", given, "points of plastic strain and yield stress")
    strain = units.parse(given[0], units.DIMENSIONLESS, name="hardening")
    return strain, units.parse(given[1], "pressure", name="hardening")


class HardeningValue(Value):
    """Type of the value of ``hardening`` in a file."""

    def read(self, given: Any, place: Place) -> Hardening:
        """Read a modulus, a table of values, or a list of points."""
        if isinstance(given, Hardening):
            return given
        if isinstance(given, Mapping):
            return Table(Hardening).read(given, place)
        if isinstance(given, Sequence) and not isinstance(given, str):
            if not given:
                allowed = f"1 to {MAX_HARDENING_POINTS} points of plastic strain and yield stress"
                raise InputError("hardening", given, allowed)
            return Hardening(table=tuple(given))
        return Hardening(modulus=STRESS.read(given, place))

    def write(self, value: Hardening) -> str:
        """Write the points of a table, or names and values."""
        stress = STRESS.write
        if value.table:
            return f"[{', '.join(f'[{strain!r}, {stress(each)}]' for strain, each in value.table)}]"
        return f"{{ modulus = {stress(value.modulus)}, gain = {stress(value.gain)}, rate = {value.rate!r} }}"

    def words(self) -> str:
        """Describe the three forms."""
        return "a modulus, a table of `modulus`, `gain` and `rate`, or a list of plastic strains and stresses"


HARDENING = HardeningValue()


RULES = {"gauss": 2, "lobatto": 3}
"""Integration rules through the thickness, with the minimum number of points of each."""
POINTS = 8
"""Number of points in a hardening curve that is not given as a table."""
MAX_POINTS = 31


@dataclass(frozen=True, kw_only=True)
class Metal:
    """A metal, elastic until it yields; default: the titanium alloy Ti-6Al-4V, elastic.

    A metal without ``yield`` stays elastic. ``points`` default to five if the metal yields, and to none if it is
    elastic, since stress resultants are then equally accurate.
    """

    youngs: float = file_key(
        PhysicalValue("GPa", 0.1, 1000, decimals=4), "Young's modulus", example="114 GPa", default=114e9
    )
    poisson: float = file_key(PhysicalValue("1", above=-1, below=0.5), "Poisson's ratio", example="0.34", default=0.34)
    density: float = file_key(
        PhysicalValue("kg/m3", 100, 25000, decimals=4), "density", example="4430 kg/m3", default=4430.0
    )
    yield_stress: float | None = file_key(
        PhysicalValue("MPa", decimals=4), "yield stress in tension", name="yield", example="880 MPa",
        default=None,
    )  # fmt: skip
    hardening: Hardening | None = file_key(
        HARDENING, "increase of the yield stress with plastic strain: a modulus, its values, or points of a table",
        default=None,
    )  # fmt: skip
    points: int | None = file_key(count(2, MAX_POINTS), "points through the thickness of shells", default=None)
    rule: str = file_key(
        Choice(tuple(RULES)), "rule of these points; `lobatto` has points on both surfaces", default="gauss"
    )

    def __post_init__(self) -> None:
        check_values(self)
        if self.points is not None:
            check_count("points", self.points, RULES[self.rule], MAX_POINTS)
        if self.hardening is not None:
            table = self.hardening.table
            if table and self.yield_stress is None:
                object.__setattr__(self, "yield_stress", table[0][1])
            if self.yield_stress is None:
                raise InputError("hardening", Wording("without yield"), "give yield as well, or leave hardening out")
            if table and self.yield_stress != table[0][1]:
                shown = units.show(self.yield_stress, "MPa")
                raise InputError("yield", shown, "leave it out, or give the stress of the first point of hardening")
        if self.yield_stress is not None and not 1e6 <= self.yield_stress <= 0.1 * self.youngs:
            raise InputError("yield", units.show(self.yield_stress, "MPa"), "1 MPa to a tenth of youngs")

    def curve(self) -> list[tuple[float, float]]:
        """Return plastic strains and yield stresses [Pa]: the table, or ``POINTS`` points up to 20% strain."""
        if self.yield_stress is None:
            return []
        hardening = self.hardening or Hardening()
        if hardening.table:
            # A curve needs at least two points.
            last = (hardening.table[-1][0] + 0.2, hardening.table[-1][1])
            return list(hardening.table) if len(hardening.table) > 1 else [*hardening.table, last]
        # Denser at small strains, where a saturating metal hardens most.
        strains = [0.2 * (number / (POINTS - 1)) ** 2 for number in range(POINTS)]
        return list(zip(strains, self.flow_stress(strains), strict=True))

    def flow_stress(self, strains: Sequence[float]) -> list[float]:
        """Return the flow stresses [Pa] of a yielding metal at the given plastic strains."""
        metal = self.plastic()
        if metal is None:
            raise InputError("yield", None, "give it; without it this metal stays elastic")
        return core.fem_yield_stress(metal, list(strains))

    def plastic(self) -> dict[str, Any] | None:
        """Return yield stress and hardening in the core's format; None for an elastic metal."""
        if self.yield_stress is None:
            return None
        hardening = self.hardening or Hardening()
        values = {name: getattr(hardening, name) for name in ("modulus", "gain", "rate")}
        return {"yield_stress": self.yield_stress, **values, "table": list(hardening.table)}
