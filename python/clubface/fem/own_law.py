"""Material laws of one's own that are functions of C, compiled outside the package and called by its elements."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Mapping
from ctypes import POINTER, c_double, c_size_t
from typing import Any

from clubface import units
from clubface.errors import InputError, Wording
from clubface.fem import core
from clubface.fem.balls import NOT_CONSTANTS
from clubface.fem.materials import REGISTERED, Law, builtin_laws
from clubface.support.checks import check_count, check_text
from clubface.support.functions import function_address

__all__ = ["LawFunction", "register_law"]

MOST_NUMBERS = 64
"""Constants that a law may have, and state variables."""

LawFunction = ctypes.CFUNCTYPE(
    None, c_size_t, POINTER(c_double), POINTER(c_double), c_double, POINTER(c_double), POINTER(c_double)
)
"""The type of the function of a law for :mod:`ctypes`. It loads one of a library,
``LawFunction(("rubber", ctypes.CDLL("./rubber.so")))``, or makes a slow one of a function in Python."""

_functions: list[Any] = []
"""Kept alive, since materials call them."""
_registering = threading.RLock()
"""The core and the package know a law by the same registration, whichever thread came last."""


def register_law(
    name: str, function: Any, *, constants: Mapping[str, Any] | None = None, states: int = 0, summary: str = ""
) -> Law:
    """Make a function of C a law that materials know by ``name``, in code and in files of balls.

    It is known in this process alone, and registering a name again replaces its law in materials that are made later.

    Parameters
    ----------
    name
        A word that no other law has.
    function
        ``void law(size_t count, const double *shapes, const double *constants, double step, double *states, double
        *results)``: a function of ctypes (:data:`LawFunction`), or whatever has its ``address``, as a ``cfunc`` of
        Numba. It computes ``count`` points at once and is called by several threads at a time. Arrays have rows of
        ``count`` numbers, one of each point:

        * ``shapes``: the right Cauchy-Green tensor without its change of volume, C' = J^(-2/3) F^T F, of determinant
          one, in axes that stay with the point but are not those of others; six rows: xx, yy, zz, xy, xz, yz.
        * ``states``: the state variables, zero before any deformation. The function moves them on by ``step`` [s], in
          place; a step of 0 asks for the values at the same time again.
        * ``results``: eight rows. The stress 2 dW/dC' [Pa] in six rows as those of ``shapes``; what is along the
          inverse of C' is taken out, since it belongs to the change of volume. The elastic energy W [J/m3]. The energy
          that became heat so far [J/m3], zero unless it is written.
    constants
        The constants of the material by name, in the order in which ``constants`` of the function has them: typical
        values, text with a unit or numbers, by which the function is checked.
    states
        Number of state variables of a point, at most 64.
    summary
        One line about the law.

    Returns
    -------
    Law
        Its description.

    Raises
    ------
    InputError
        The name is taken or no word, the function is no function of C, or with these constants it has a stress or an
        energy at rest, no stiffness, energies that differ where the axes are turned, or a stress that is not the
        derivative of its energy (which is checked of laws without states).
    """
    if not (isinstance(name, str) and name.replace("-", "_").isidentifier()):
        raise InputError("name", name, "a word of letters, digits, hyphens and underscores")
    if name in builtin_laws() or name == "energy":
        raise InputError("name", name, "one that no law of the package has")
    address = function_address(function)
    if not address:
        raise InputError("function", function, "a function of C: of ctypes (LawFunction), or a cfunc of Numba")
    if not isinstance(constants, Mapping | None):
        raise InputError("constants", constants, 'typical values by name, as in {"c10": "9.5 MPa"}')
    states = check_count("states", states, 0, MOST_NUMBERS)
    check_text("summary", summary)
    dimensions, values = {}, []
    for key, given in (constants or {}).items():
        if not (isinstance(key, str) and key.isidentifier()) or key in NOT_CONSTANTS:
            raise InputError("name of a constant", key, "a word that is no other key of a piece of a ball")
        dimensions[key] = units.dimension_of(given, name=key)
        values.append(units.parse(given, dimensions[key], name=key))
    law = Law(name, dimensions, len(dimensions), 1, summary or "a law of one's own", states)
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
