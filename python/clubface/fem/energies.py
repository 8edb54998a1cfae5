"""Materials by an energy of one's own: its constants, what it must be, and its values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clubface import units
from clubface.errors import ImplausibleWarning, InputError, Wording
from clubface.fem import core
from clubface.support.checks import check_names, warn_once

__all__ = ["ENERGY", "Energy"]

SAME = 1e-9
"""Relative difference of energies that is rounding."""
MOST_TRIED = 8
"""Constants in proportion to which an energy may grow, of which every selection is tried."""

ENERGY = "energy"
"""The name of the law of a material whose energy is written down."""


@dataclass(frozen=True)
class Energy:
    """An energy of the change of shape per unit reference volume [J/m3], W(I1, I2).

    The invariants are those of the right Cauchy-Green tensor without its change of volume, C' = J^(-2/3) F^T F:
    I1 = tr C' and I2 = tr C'^-1, in principal stretches l1^2 + l2^2 + l3^2 and 1/l1^2 + 1/l2^2 + 1/l3^2, both 3 at
    rest. ``I1bar`` and ``I2bar`` are other names of them. The energy of the change of volume, K/2 (J - 1)^2, is added
    as to every law, with the bulk modulus K from the shear modulus, 2 (dW/dI1 + dW/dI2) at rest, and Poisson's ratio.

    An expression has numbers, constants of any names, ``+ - * / ^`` (or ``**``), parentheses, ``exp``, ``log`` (or
    ``ln``) and ``sqrt``. It is differentiated symbolically, by the core.

    Attributes
    ----------
    text
        The expression.
    constants
        Names of its constants, in the order in which they come in it.
    """

    text: str
    constants: tuple[str, ...]

    @staticmethod
    def read(text: str) -> Energy:
        """Return the energy of an expression; an error says at which character what is wrong."""
        if not isinstance(text, str):
            raise InputError("energy", text, 'an expression in quotes, as in "c10*(I1-3) + c20*(I1-3)^2"')
        return _read(text)

    def given(self, constants: Mapping[str, Any]) -> dict[str, float]:
        """Return the constants [SI] in the order of the core, with checks; they may be text with units."""
        check_names(f"constant of the energy {self.text!r}", constants, self.constants)
        missing = [name for name in self.constants if name not in constants]
        if missing:
            raise InputError("constants", dict(constants), f"give {', '.join(missing)} as well")
        return {name: self.constant_value(name, constants[name]) for name in self.constants}

    def constant_value(self, name: str, given: Any) -> float:
        """Return a constant [SI], checked: a stress, or a number."""
        dimension = self.dimensions[name]
        if dimension is None:
            dimension = units.dimension_of(given, name=name) if isinstance(given, str) else units.DIMENSIONLESS
            dimension = dimension if dimension == "pressure" else units.DIMENSIONLESS
        return units.parse(given, dimension, name=name)

    @cached_property
    def dimensions(self) -> Mapping[str, str | None]:
        """The dimension of each constant, None where the energy leaves it open.

        The stresses among them are those with twice of which the energy is twice itself. There are none such where a
        stress is written as a number in the expression.
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
        """Raise InputError for an energy that no material has at rest, and warn of one that loses its stiffness."""
        values = list(constants.values())
        try:
            core.fem_check_law(ENERGY, values, self.text)
        except ValueError as error:
            name, value, allowed = error.args
            raise InputError(name.removesuffix(f" of {ENERGY}"), Wording(value), _allowed(allowed)) from None
        unstable = core.fem_energy_instability(self.text, values)
        if unstable is not None:
            mode, stretch, undefined = unstable
            what = "is no number" if undefined else "gains no more stress as it is stretched further"
            warn_once(
                f"the material of the energy {self.text!r} {what} at a stretch of {stretch:.3g} in {mode}, which hard "
                "impacts may reach: its elements may then fail or fold; choose other constants, or a lower speed",
                ImplausibleWarning,
            )

    def values(self, constants: Mapping[str, float], invariants: ArrayLike) -> NDArray[Any]:
        """Return W [J/m3], dW/dI1 and dW/dI2 [Pa] at rows of (I1, I2), a row each."""
        at = np.asarray(invariants, dtype=float).reshape(-1, 2)
        rows = core.fem_energy_values(self.text, [constants[name] for name in self.constants], at.tolist())
        return np.asarray(rows, dtype=float).reshape(-1, 3)


def check_volumetric(text: str) -> None:
    """Raise InputError for an energy of the change of volume that cannot be read, or that is none at rest."""
    if not isinstance(text, str):
        raise InputError("volumetric", text, 'an expression in quotes, as in "bulk/4*(J^2 - 1 - 2*log(J))"')
    try:
        core.fem_volumetric(text, 1.0, [])
    except ValueError as error:
        name, value, allowed = error.args if len(error.args) == 3 else ("volumetric", text, "text of letters")
        raise InputError(name, Wording(value), _allowed(allowed)) from None


@lru_cache(maxsize=256)
def _read(text: str) -> Energy:
    try:
        return Energy(text, tuple(core.fem_energy(text)))
    except ValueError as error:
        allowed = error.args[2] if len(error.args) == 3 else "text of letters that can be written"
        raise InputError("energy", text, _allowed(allowed)) from None


def _allowed(allowed: str) -> str:
    """Return what the core allows, as an error of the package says it."""
    return allowed.removeprefix("it must be ") if "at character" not in allowed else f"readable: {allowed}"
