"""Materials of the pieces of a ball: an elastic law, the resistance to a change of volume, and viscoelasticity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple

from clubface import units
from clubface.errors import InputError, Wording
from clubface.fem import core
from clubface.fem.energies import ENERGY, Energy, check_volumetric
from clubface.schema import PhysicalValue, check_values, file_key
from clubface.support.checks import Frozen, check_choice, check_names

__all__ = ["Law", "Material", "Maxwell", "laws"]


class Law(NamedTuple):
    """An elastic law of the core.

    Attributes
    ----------
    name
        Its name in files.
    constants
        The names of its constants, each with its dimension as in :mod:`clubface.units`.
    needed
        How many constants must be given, counted from the first.
    group
        How many of the others come at a time.
    summary
        One line about it.
    states
        Number of state variables of a law of one's own.
    """

    name: str
    constants: Mapping[str, str]
    needed: int
    group: int
    summary: str
    states: int = 0

    def given(self, constants: Mapping[str, Any]) -> dict[str, float]:
        """Return the constants [SI] in the order of the core, with checks; they may be text with units."""
        check_names(f"constant of {self.name}", constants, self.constants)
        names = list(self.constants)
        last = max((names.index(name) for name in constants), default=0)
        groups = -(-max(last + 1 - self.needed, 0) // self.group)
        wanted = names[: self.needed + groups * self.group]
        missing = [name for name in wanted if name not in constants]
        if missing:
            raise InputError("constants", dict(constants), f"give {', '.join(missing)} as well")
        return {name: units.parse(constants[name], self.constants[name], name=name) for name in wanted}

    def check(self, constants: Mapping[str, float]) -> None:
        """Raise InputError for a constant that is not allowed."""
        try:
            core.fem_check_law(self.name, list(constants.values()))
        except ValueError as error:
            label, _, allowed = error.args
            name = label.removesuffix(f" of {self.name}")
            if name == "law":
                raise InputError(name, Wording(error.args[1]), allowed.removeprefix("it must be ")) from None
            # The shear modulus is no constant: the material has limits of its own for it.
            if name in constants:
                pressure = self.constants[name] == "pressure"
                shown = units.show(constants[name], "MPa") if pressure else constants[name]
                raise InputError(name, shown, allowed.removeprefix("it must be ")) from None


REGISTERED: dict[str, Law] = {}
"""Laws of one's own, see :func:`clubface.fem.register_law`."""


def laws() -> Mapping[str, Law]:
    """Return the elastic laws by name, those of one's own last."""
    return Frozen({**builtin_laws(), **REGISTERED})


@cache
def builtin_laws() -> Mapping[str, Law]:
    """Return the elastic laws of the package by name."""
    laws_by_name = {}
    for each in core.fem_laws():
        constants = Frozen({constant["name"]: constant["dimension"] for constant in each["constants"]})
        rest = (each[key] for key in ("needed", "group", "summary"))
        laws_by_name[each["name"]] = Law(each["name"], constants, *rest)
    return Frozen(laws_by_name)


@dataclass(frozen=True)
class Maxwell:
    """One viscoelastic branch, parallel to the elastic law."""

    modulus: float = file_key(
        PhysicalValue("1", above=0, upper=1e3, allowed="above 0 and at most 1000 times that of the elastic law"),
        "its shear modulus divided by that of the elastic law",
    )
    time: float = file_key(
        PhysicalValue("us", 0.1, 1e9, allowed="0.1 us to 1000 s"), "in which its stress falls to 1/e", example="100 us"
    )

    def __post_init__(self) -> None:
        check_values(self)


MAX_BRANCHES = 4
SHEAR = (1e3, 1e12)
"""Limits of the shear modulus [Pa]."""
_POISSON = "-0.9 to 0.4999; a material of 0.5 cannot change its volume, which explicit steps cannot follow"


@dataclass(frozen=True, kw_only=True)
class Material:
    """A material for finite strain.

    Attributes
    ----------
    law
        The name of an elastic law, see :func:`laws`. "linear" may also be given by ``youngs``.
    energy
        In place of a law: the energy of a change of shape per unit reference volume as an expression in the invariants
        I1 and I2 and constants of any names, as in "c10*(I1-3) + c20*(I1-3)^2"; see
        :class:`clubface.fem.Energy`.
    constants
        The constants of the law, or of the energy, by name [Pa; exponents are plain numbers].
    poisson
        Poisson's ratio at small strain, below 0.5; it sets the bulk modulus.
    volumetric
        The energy of the change of volume per unit reference volume as an expression in its ratio J and the bulk
        modulus, as in "bulk/4*(J^2 - 1 - 2*log(J))"; "bulk/2*(J - 1)^2" unless given.
    density
        Density [kg/m3]; None for a core that takes what the mass of the ball leaves.
    maxwell
        Viscoelastic branches.
    """

    law: str = ENERGY
    constants: Mapping[str, float]
    poisson: float
    energy: str | None = None
    volumetric: str | None = None
    density: float | None = None
    maxwell: tuple[Maxwell, ...] = field(default=())

    def __post_init__(self) -> None:
        law = self._law()
        values = law.given(self.constants)
        object.__setattr__(self, "constants", Frozen(values))
        object.__setattr__(self, "poisson", units.parse(self.poisson, units.DIMENSIONLESS, name="poisson"))
        if not -0.9 <= self.poisson <= 0.4999:
            raise InputError("poisson", self.poisson, _POISSON)
        if self.density is not None:
            object.__setattr__(self, "density", units.parse(self.density, "density", name="density"))
            if not 10.0 <= self.density <= 30e3:
                raise InputError("density", units.show(self.density, "kg/m3"), "10 to 30000 kg/m3")
        if self.volumetric is not None:
            check_volumetric(self.volumetric)
        object.__setattr__(self, "maxwell", tuple(self.maxwell))
        if len(self.maxwell) > MAX_BRANCHES:
            raise InputError("maxwell", len(self.maxwell), f"at most {MAX_BRANCHES} branches")
        if self.maxwell and isinstance(law, Law) and law.states:
            raise InputError("maxwell", len(self.maxwell), "left out, since the law has state variables of its own")
        law.check(values)
        if not SHEAR[0] <= self.shear <= SHEAR[1]:
            if self.energy is not None:
                raise InputError("energy", self.energy, _shear_allowed(self.shear))
            name, value = next(iter(values.items()), ("law", None))
            shown = self.law if value is None else units.show(value, "MPa")
            raise InputError(name, shown, _shear_allowed(self.shear))

    def _law(self) -> Law | Energy:
        """Return the law, or the energy in its place, before the constants are known to fit."""
        if self.energy is not None:
            if self.law != ENERGY:
                raise InputError("law", self.law, "leave it out, since the energy is given")
            return Energy.read(self.energy)
        if self.law == ENERGY:
            raise InputError("law", None, f"give a law ({', '.join(laws())}), or an energy in its place")
        check_choice("law", self.law, laws())
        return laws()[self.law]

    @property
    def shear(self) -> float:
        """Shear modulus of small, slow deformation [Pa]."""
        return core.fem_shear(self.law, list(self.constants.values()), self.energy)[0]

    def shear_slope(self, constant: str) -> float:
        """Return the derivative of the shear modulus by a constant of the law."""
        slopes = core.fem_shear(self.law, list(self.constants.values()), self.energy)[1]
        return slopes[list(self.constants).index(constant)]

    def constant_dimensions(self) -> dict[str, str]:
        """Return the dimension of each constant, as in :mod:`clubface.units`."""
        law = self._law()
        known = law.dimensions if isinstance(law, Energy) else law.constants
        return {name: known[name] or units.DIMENSIONLESS for name in self.constants}

    @property
    def bulk(self) -> float:
        """Bulk modulus [Pa]."""
        return 2.0 * self.shear * (1.0 + self.poisson) / (3.0 * (1.0 - 2.0 * self.poisson))

    @property
    def youngs(self) -> float:
        """Young's modulus of small, slow deformation [Pa]."""
        return 2.0 * self.shear * (1.0 + self.poisson)

    @classmethod
    def linear(
        cls,
        youngs: Any,
        poisson: Any,
        density: Any = None,
        maxwell: Sequence[Maxwell] = (),
        volumetric: str | None = None,
    ) -> Material:
        """Return a material that is linear in logarithmic strain, from Young's modulus and Poisson's ratio."""
        modulus = units.parse(youngs, "pressure", name="youngs")
        ratio = units.parse(poisson, units.DIMENSIONLESS, name="poisson")
        if not modulus > 0.0:
            raise InputError("youngs", units.show(modulus, "MPa"), "above 0")
        if not -0.9 <= ratio <= 0.4999:
            raise InputError("poisson", ratio, _POISSON)
        shear = modulus / (2.0 * (1.0 + ratio))
        if not SHEAR[0] <= shear <= SHEAR[1]:
            raise InputError("youngs", units.show(modulus, "MPa"), _shear_allowed(shear))
        return cls(law="linear", constants={"shear": shear}, poisson=ratio, volumetric=volumetric, density=density,
                   maxwell=tuple(maxwell))  # fmt: skip


def _shear_allowed(shear: float) -> str:
    least, most = (units.show(each, "MPa", 7) for each in SHEAR)
    return f"such that the shear modulus is {least} to {most}; it is {units.show(shear, 'MPa')}"
