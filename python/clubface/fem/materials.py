"""Materials of a ball's pieces: elastic laws and energies, built in or user-defined, and viscoelasticity.

A user-defined law is an energy, written as an expression, or a C function compiled outside the package and called by
the elements.
"""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Iterable, Mapping, Sequence
from ctypes import POINTER, c_double, c_size_t
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clubface import _core as core, units
from clubface.errors import ImplausibleWarning, InputError, Wording
from clubface.schema import PhysicalValue, Place, check_values, file_key
from clubface.simulation.own_law import function_address
from clubface.support.arrays import Floats
from clubface.support.checks import Frozen, check_choice, check_count, check_names, check_text, warn_once

__all__ = ["Energy", "Law", "LawFunction", "Material", "Maxwell", "laws", "register_law"]

NOT_CONSTANTS = (
    "name", "layers", "thickness", "law", "youngs", "energy", "volumetric", "poisson", "density", "maxwell", "radius",
    "bulk",
)  # fmt: skip
"""Names that no constant may have: keys of a piece, or its variables in derivatives."""
SAME = 1e-9
"""Relative difference between energies that is treated as rounding."""
MOST_TRIED = 8
"""Maximum number of constants that an energy may be linear in for every subset of them to be tried."""

ENERGY = "energy"
"""Law name of a material that is defined by its energy."""


@dataclass(frozen=True)
class Energy:
    """Strain energy of the change of shape per unit reference volume [J/m3], W(I1, I2).

    The invariants are those of the right Cauchy-Green tensor without the change of volume, C' = J^(-2/3) F^T F:
    I1 = tr C' and I2 = tr C'^-1; in principal stretches l1^2 + l2^2 + l3^2 and 1/l1^2 + 1/l2^2 + 1/l3^2, both 3 at
    rest. ``I1bar`` and ``I2bar`` are alternative names. As for every law, the energy of the change of volume,
    K/2 (J - 1)^2, is added; the bulk modulus K follows from Poisson's ratio and the shear modulus,
    2 (dW/dI1 + dW/dI2) at rest.

    An expression may contain numbers, constants with any names, ``+ - * / ^`` (or ``**``), parentheses, ``exp``,
    ``log`` (or ``ln``) and ``sqrt``. The core differentiates it symbolically.

    Attributes
    ----------
    text
        The expression.
    constants
        Names of its constants, in order of appearance.
    """

    text: str
    constants: tuple[str, ...]

    @staticmethod
    def read(text: str) -> Energy:
        """Parse an expression; errors give the character at fault."""
        if not isinstance(text, str):
            raise InputError("energy", text, 'an expression in quotes, as in "c10*(I1-3) + c20*(I1-3)^2"')
        return _read(text)

    def given(self, constants: Mapping[str, float | str]) -> dict[str, float]:
        """Check the constants, which may be text with units, and return them [SI] in the core's order."""
        check_names(f"constant of the energy {self.text!r}", constants, self.constants)
        missing = [name for name in self.constants if name not in constants]
        if missing:
            raise InputError("constants", dict(constants), f"give {', '.join(missing)} as well")
        return {name: self.constant_value(name, constants[name]) for name in self.constants}

    def constant_value(self, name: str, given: float | str) -> float:
        """Return a constant [SI], checked: a stress or a dimensionless number."""
        dimension = self.dimensions[name]
        if dimension is None:
            is_stress = isinstance(given, str) and units.dimension_of(given, name=name) == "pressure"
            dimension = "pressure" if is_stress else units.DIMENSIONLESS
        return units.parse(given, dimension, name=name)

    @cached_property
    def dimensions(self) -> Mapping[str, str | None]:
        """The dimension of each constant; None if the energy does not determine it.

        Doubling all the stresses among the constants doubles the energy, which identifies them. This fails if the
        expression contains a stress as a plain number.
        """
        at = [(3.05, 3.04), (3.02, 3.03)]
        for scale in (1.0, 10.0, 0.1):
            tried = {name: scale * (1.7 + 0.3 * place) for place, name in enumerate(self.constants)}

            def energies(times: float, names: Iterable[str], tried: dict[str, float] = tried) -> NDArray[Any]:
                return self.values(tried | {name: times * tried[name] for name in names}, at)[:, 0]

            once = energies(1.0, ())
            if not np.all(np.isfinite(once)):
                continue
            steps = {name: [energies(times, [name]) for times in (0.0, 2.0)] for name in self.constants}
            in_proportion = [
                name for name, (less, more) in steps.items() if np.allclose(more - once, once - less, SAME)
            ]
            sizes = range(len(in_proportion), 0, -1) if len(in_proportion) <= MOST_TRIED else [len(in_proportion)]
            for names in (each for size in sizes for each in combinations(in_proportion, size)):
                if np.allclose(energies(2.0, names), 2.0 * once, SAME, 0.0):
                    return {name: "pressure" if name in names else units.DIMENSIONLESS for name in self.constants}
            break
        return dict.fromkeys(self.constants)

    def check(self, constants: Mapping[str, float]) -> None:
        """Raise InputError if the energy is impossible at rest; warn if stiffness is lost under tension."""
        values = list(constants.values())
        try:
            core.fem_check_law(ENERGY, values, self.text)
        except ValueError as error:
            name, value, allowed = error.args
            raise InputError(name.removesuffix(f" of {ENERGY}"), Wording(value), _reword_allowed(allowed)) from None
        unstable = core.fem_energy_instability(self.text, values)
        if unstable is not None:
            mode, stretch, undefined = unstable
            what = "is not a number" if undefined else "stops gaining stress"
            warn_once(
                f"the material of the energy {self.text!r} {what} at a stretch of {stretch:.3g} in {mode}, which hard "
                "impacts may reach: its elements may then fail or fold; choose other constants, or a lower speed",
                ImplausibleWarning,
            )

    def values(self, constants: Mapping[str, float], invariants: ArrayLike) -> Floats:
        """Return rows of W [J/m3], dW/dI1 and dW/dI2 [Pa] at rows of (I1, I2)."""
        at = np.asarray(invariants, dtype=float).reshape(-1, 2)
        rows = core.fem_energy_values(self.text, [constants[name] for name in self.constants], at.tolist())
        return np.asarray(rows, dtype=float).reshape(-1, 3)


def check_volumetric(text: str) -> None:
    """Raise InputError for an energy of the change of volume that is unreadable or impossible at rest."""
    if not isinstance(text, str):
        raise InputError("volumetric", text, 'an expression in quotes, as in "bulk/4*(J^2 - 1 - 2*log(J))"')
    try:
        core.fem_volumetric(text, 1.0, [])
    except ValueError as error:
        name, value, allowed = error.args if len(error.args) == 3 else ("volumetric", text, "text of letters")
        raise InputError(name, Wording(value), _reword_allowed(allowed)) from None


@lru_cache(maxsize=256)
def _read(text: str) -> Energy:
    try:
        return Energy(text, tuple(core.fem_energy(text)))
    except ValueError as error:
        allowed = error.args[2] if len(error.args) == 3 else "text of letters that can be written"
        raise InputError("energy", text, _reword_allowed(allowed)) from None


def _reword_allowed(allowed: str) -> str:
    """Return the core's text on what is allowed, worded for an InputError."""
    return allowed.removeprefix("it must be ") if "at character" not in allowed else f"readable: {allowed}"


class Law(NamedTuple):
    """An elastic law of the core.

    Attributes
    ----------
    name
        Its name in files.
    constants
        Names of its constants, each with its dimension as in :mod:`clubface.units`.
    needed
        How many constants are required, counted from the first.
    group
        How many of the remaining constants belong together, such as 2 for pairs.
    summary
        One-line description.
    states
        Number of state variables of a user-defined law.
    """

    name: str
    constants: Mapping[str, str]
    needed: int
    group: int
    summary: str
    states: int = 0

    def given(self, constants: Mapping[str, float | str]) -> dict[str, float]:
        """Check the constants, which may be text with units, and return them [SI] in the core's order."""
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
            # The shear modulus is not among the constants: the material checks it separately.
            if name in constants:
                pressure = self.constants[name] == "pressure"
                shown = units.show(constants[name], "MPa") if pressure else constants[name]
                raise InputError(name, shown, allowed.removeprefix("it must be ")) from None


REGISTERED: dict[str, Law] = {}
"""User-defined laws, see :func:`clubface.fem.register_law`."""


def laws() -> Mapping[str, Law]:
    """Return the elastic laws by name, user-defined ones last."""
    return Frozen({**builtin_laws(), **REGISTERED})


@cache
def builtin_laws() -> Mapping[str, Law]:
    """Return the built-in elastic laws by name."""
    laws_by_name = {}
    for each in core.fem_laws():
        constants = Frozen({constant["name"]: constant["dimension"] for constant in each["constants"]})
        rest = (each[key] for key in ("needed", "group", "summary"))
        laws_by_name[each["name"]] = Law(each["name"], constants, *rest)
    return Frozen(laws_by_name)


MOST_NUMBERS = 64
"""Maximum number of constants, and of state variables, of a law."""

LawFunction = ctypes.CFUNCTYPE(
    None, c_size_t, POINTER(c_double), POINTER(c_double), c_double, POINTER(c_double), POINTER(c_double)
)
"""The :mod:`ctypes` type of a law's function. It wraps a function of a library,
``LawFunction(("rubber", ctypes.CDLL("./rubber.so")))``, or a Python function, which is slow."""

_functions: list[Any] = []
"""Keeps the functions alive that materials call."""
_registering = threading.RLock()
"""Held so that core and package register the same function when threads compete for a name."""


def register_law(
    name: str, function: Any, *, constants: Mapping[str, str | float] | None = None, states: int = 0, summary: str = ""
) -> Law:
    """Register a C function as a law that materials, in code and in ball files, refer to by ``name``.

    The registration lasts for this process only. Registering a name again replaces the law for materials made later.

    Parameters
    ----------
    name
        A word that is not yet the name of a built-in law.
    function
        ``void law(size_t count, const double *shapes, const double *constants, double step, double *states, double
        *results)``: a ctypes function (:data:`LawFunction`), or any object with an ``address``, such as a Numba
        ``cfunc``. It computes ``count`` points per call and is called from several threads at once. Arrays have rows
        of ``count`` numbers, one per point:

        * ``shapes``: the right Cauchy-Green tensor without the change of volume, C' = J^(-2/3) F^T F, with determinant
          one. Each point has axes of its own, fixed over time. Six rows: xx, yy, zz, xy, xz, yz.
        * ``states``: the state variables, zero in the undeformed state. The function advances them in place by
          ``step`` [s]; a step of 0 asks for the values at the same time again.
        * ``results``: eight rows. Six rows of the stress 2 dW/dC' [Pa], ordered like ``shapes``; its component along
          the inverse of C' is removed, since it belongs to the change of volume. Then the elastic energy W [J/m3], and
          the energy dissipated so far [J/m3], which is zero unless the function sets it.
    constants
        The constants by name, in the order in which the function's ``constants`` argument holds them, each with a
        typical value (a number, or text with a unit) at which the function is checked.
    states
        Number of state variables per point, at most 64.
    summary
        One-line description of the law.

    Returns
    -------
    Law
        The registered law.

    Raises
    ------
    InputError
        The name is taken or not a word; the function is not a C function; or, with these constants, it has stress or
        energy at rest, no stiffness, an energy that depends on the orientation of the axes, or a stress that is not
        the derivative of its energy (checked for laws without state variables).
    """
    if not (isinstance(name, str) and name.replace("-", "_").isidentifier()):
        raise InputError("name", name, "a word of letters, digits, hyphens and underscores")
    if name in builtin_laws() or name == "energy":
        raise InputError("name", name, "a name that no built-in law has")
    address = function_address(function)
    if not address:
        raise InputError("function", function, "a C function: from ctypes (LawFunction), or a Numba cfunc")
    if not isinstance(constants, Mapping | None):
        raise InputError("constants", constants, 'typical values by name, as in {"c10": "9.5 MPa"}')
    states = check_count("states", states, 0, MOST_NUMBERS)
    check_text("summary", summary)
    dimensions, values = {}, []
    for key, given in (constants or {}).items():
        if not (isinstance(key, str) and key.isidentifier()) or key in NOT_CONSTANTS:
            raise InputError("name of a constant", key, "a word that is not already a key of a ball piece")
        dimensions[key] = units.dimension_of(given, name=key)
        values.append(units.parse(given, dimensions[key], name=key))
    law = Law(name, dimensions, len(dimensions), 1, summary or "a user-defined law", states)
    with _registering:
        try:
            core.fem_register_law(name, address, list(dimensions), values, states)
        except ValueError as error:
            label, value, allowed = error.args
            label = label.removesuffix(f" of {name}").replace("law", "function")
            raise InputError(label, Wording(value), allowed.removeprefix("it must be ")) from None
        _functions.append(function)
        REGISTERED[name] = law
    return law


@dataclass(frozen=True)
class Maxwell:
    """A viscoelastic (Maxwell) branch, parallel to the elastic law."""

    modulus: float = file_key(
        PhysicalValue("1", above=0, upper=1e3, allowed="above 0 and at most 1000 (times the elastic law's)"),
        "shear modulus relative to the elastic law's",
    )
    time: float = file_key(
        PhysicalValue("us", 0.1, 1e9, allowed="0.1 us to 1000 s"),
        "relaxation time (stress falls to 1/e)",
        example="100 us",
    )

    def __post_init__(self) -> None:
        check_values(self)


MAX_BRANCHES = 4
SHEAR = (1e3, 1e12)
"""Limits for the shear modulus [Pa]."""
_INCOMPRESSIBLE = "-0.9 to 0.4999; a material with 0.5 is incompressible, which explicit time steps cannot handle"
VALUES = {
    "youngs": PhysicalValue("MPa", above=0, allowed="above 0"),
    "density": PhysicalValue("kg/m3", 10, 30e3),
    "poisson": PhysicalValue("1", -0.9, 0.4999, allowed=_INCOMPRESSIBLE),
}


@dataclass(frozen=True, kw_only=True)
class Material:
    """A material for large (finite) strains.

    Attributes
    ----------
    law
        Name of an elastic law, see :func:`laws`. "linear" may also be given by ``youngs``.
    energy
        Alternative to a law: the strain energy of the change of shape per unit reference volume, as an expression in
        the invariants I1 and I2 and constants with any names, such as "c10*(I1-3) + c20*(I1-3)^2"; see
        :class:`clubface.fem.Energy`.
    constants
        Constants of the law or the energy by name [Pa; exponents are plain numbers].
    poisson
        Poisson's ratio at small strain, below 0.5; determines the bulk modulus.
    volumetric
        Energy of the change of volume per unit reference volume, as an expression in the volume ratio J and the bulk
        modulus, such as "bulk/4*(J^2 - 1 - 2*log(J))"; default "bulk/2*(J - 1)^2".
    density
        Density [kg/m3]; None for a core whose density follows from the mass of the ball.
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
        for name in ("poisson", "density"):
            if (given := getattr(self, name)) is not None:
                object.__setattr__(self, name, VALUES[name].read(given, Place(name=name)))
        if self.volumetric is not None:
            check_volumetric(self.volumetric)
        object.__setattr__(self, "maxwell", tuple(self.maxwell))
        if len(self.maxwell) > MAX_BRANCHES:
            raise InputError("maxwell", len(self.maxwell), f"at most {MAX_BRANCHES} branches")
        if self.maxwell and isinstance(law, Law) and law.states:
            raise InputError("maxwell", len(self.maxwell), "left out; the law has its own state variables")
        law.check(values)
        if not SHEAR[0] <= self.shear <= SHEAR[1]:
            if self.energy is not None:
                raise InputError("energy", self.energy, _shear_allowed(self.shear))
            name, value = next(iter(values.items()), ("law", None))
            shown = self.law if value is None else units.show(value, "MPa")
            raise InputError(name, shown, _shear_allowed(self.shear))

    def _law(self) -> Law | Energy:
        """Return the law or the energy, before its constants are checked."""
        if self.energy is not None:
            if self.law != ENERGY:
                raise InputError("law", self.law, "leave it out; energy is given in its place")
            return Energy.read(self.energy)
        if self.law == ENERGY:
            raise InputError("law", None, f"give a law ({', '.join(laws())}), or an energy in its place")
        check_choice("law", self.law, laws())
        return laws()[self.law]

    @property
    def shear(self) -> float:
        """Shear modulus for small, slow deformation [Pa]."""
        return core.fem_shear(self.law, list(self.constants.values()), self.energy)[0]

    def shear_slope(self, constant: str) -> float:
        """Return the derivative of the shear modulus with respect to a constant of the law."""
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
        """Young's modulus for small, slow deformation [Pa]."""
        return 2.0 * self.shear * (1.0 + self.poisson)

    @classmethod
    def linear(
        cls,
        youngs: float | str,
        poisson: float | str,
        density: float | str | None = None,
        maxwell: Sequence[Maxwell] = (),
        volumetric: str | None = None,
    ) -> Material:
        """Return a material that is linear in logarithmic strain."""
        modulus = VALUES["youngs"].read(youngs, Place(name="youngs"))
        ratio = VALUES["poisson"].read(poisson, Place(name="poisson"))
        shear = modulus / (2.0 * (1.0 + ratio))
        if not SHEAR[0] <= shear <= SHEAR[1]:
            raise InputError("youngs", units.show(modulus, "MPa"), _shear_allowed(shear))
        own: dict[str, Any] = {"density": density, "maxwell": maxwell, "volumetric": volumetric}
        return cls(law="linear", constants={"shear": shear}, poisson=ratio, **own)


def _shear_allowed(shear: float) -> str:
    least, most = (units.show(each, "MPa", 7) for each in SHEAR)
    return f"such that the shear modulus is {least} to {most}; it is {units.show(shear, 'MPa')}"
