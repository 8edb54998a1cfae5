"""User-defined contact laws, written in Python or compiled, which can be used wherever a model is named.

Clubhead and ball are two rigid bodies that move under the law. The core integrates launches and their derivatives.
SciPy integrates histories with differently written equations (:mod:`clubface.simulation.two_bodies`), so that each
checks the other.
"""

from __future__ import annotations

import ctypes
import inspect
import marshal
import math
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.models import MODULES, OWN, Model, Parameter, models
from clubface.errors import InputError, RunError
from clubface.simulation.impact import Backend, Problems, Request
from clubface.simulation.inputs import forget_parameters
from clubface.simulation.results import inputs, outputs
from clubface.simulation.two_bodies import (
    UNFINISHED,
    Law,
    Touch,
    TwoBodies,
    UnfinishedContactError,
    evaluate_law,
    flatten_results,
    launch_outputs,
    sample_history,
)
from clubface.support.checks import check_text

USUAL_TOLERANCE = 1e-7
"""Default relative tolerance per step: the launch is then correct to 1e-5, its peak force to 3e-5."""
MOST_STATES = 24
"""Maximum number of states of a law."""
DIRECTIONS = 8
"""Number of derivatives computed per call of a law."""
CHECKED_BY = "standard"
"""Model whose checks of deliveries, clubs and balls are used; they are the same for all models."""


def function_address(function: Any) -> int:
    """Return the address of a ctypes function or of one with an ``address``, such as a Numba cfunc; else 0."""
    address = getattr(function, "address", None)
    if isinstance(address, int):
        return address
    if isinstance(function, ctypes._CFuncPtr):  # pyright: ignore[reportPrivateUsage, reportAttributeAccessIssue]
        return ctypes.cast(function, ctypes.c_void_p).value or 0
    return 0


class Dual(NDArrayOperatorsMixin):
    """A dual number: a value with derivatives, for arithmetic, comparisons and NumPy functions.

    Comparisons use the value alone. Functions of ``math`` raise a TypeError.
    """

    __slots__ = ("tangent", "value")

    def __init__(self, value: float, tangent: NDArray[Any]) -> None:
        self.value, self.tangent = value, tangent

    def __repr__(self) -> str:
        return f"Dual({self.value!r})"

    def __bool__(self) -> bool:
        return bool(self.value)

    def __array_ufunc__(self, ufunc: Any, method: str, *given: Any, **options: Any) -> Any:
        target = options.pop("out", ())  # of += and the like, which bind a new number
        if method != "__call__" or options or not all(isinstance(each, Dual) for each in target):
            return NotImplemented
        if ufunc in _COMPARISONS:
            return ufunc(*map(_value, given))
        return _call(ufunc, *given)


def _value(number: Any) -> Any:
    return number.value if isinstance(number, Dual) else number


def _call(ufunc: Any, *given: Any) -> Any:
    """Evaluate a function of numbers, at least one of them dual."""
    if ufunc not in _SLOPES:
        return NotImplemented
    numbers = [float(_value(each)) for each in given]
    with np.errstate(all="ignore"):
        value = float(ufunc(*numbers))
        tangent: Any = 0.0
        for each, slope in zip(given, _SLOPES[ufunc](value, *numbers), strict=True):
            if isinstance(each, Dual):
                tangent = tangent + slope * each.tangent
    return Dual(value, tangent)


def _power(value: float, base: float, exponent: float) -> tuple[float, float]:
    by_base = exponent * np.float64(base) ** (exponent - 1.0) if exponent else 0.0
    return by_base, value * math.log(base) if base > 0.0 else 0.0


def _larger(_: float, a: float, b: float) -> tuple[float, float]:
    return float(a >= b), float(a < b)


_Slopes = Callable[..., tuple[Any, ...]]
_SLOPES: dict[Any, _Slopes] = {
    np.add: lambda f, a, b: (1.0, 1.0),
    np.subtract: lambda f, a, b: (1.0, -1.0),
    np.multiply: lambda f, a, b: (b, a),
    np.divide: lambda f, a, b: (1.0 / np.float64(b), -f / np.float64(b)),
    np.power: _power,
    np.float_power: _power,
    np.maximum: _larger,
    np.fmax: _larger,
    np.minimum: lambda f, a, b: _larger(f, -a, -b),
    np.fmin: lambda f, a, b: _larger(f, -a, -b),
    np.hypot: lambda f, a, b: (a / f, b / f) if f else (0.0, 0.0),
    np.arctan2: lambda f, a, b: (b / np.float64(a * a + b * b), -a / np.float64(a * a + b * b)),
    np.copysign: lambda f, a, b: (math.copysign(1.0, a) * math.copysign(1.0, b), 0.0),
    np.negative: lambda f, a: (-1.0,),
    np.positive: lambda f, a: (1.0,),
    np.absolute: lambda f, a: (math.copysign(1.0, a),),
    np.fabs: lambda f, a: (math.copysign(1.0, a),),
    np.sign: lambda f, a: (0.0,),
    np.square: lambda f, a: (2.0 * a,),
    np.reciprocal: lambda f, a: (-f * f,),
    np.sqrt: lambda f, a: (0.5 / np.float64(f),),
    np.cbrt: lambda f, a: (f / (3.0 * np.float64(a)),),
    np.exp: lambda f, a: (f,),
    np.expm1: lambda f, a: (f + 1.0,),
    np.log: lambda f, a: (1.0 / np.float64(a),),
    np.log1p: lambda f, a: (1.0 / np.float64(1.0 + a),),
    np.sin: lambda f, a: (math.cos(a),),
    np.cos: lambda f, a: (-math.sin(a),),
    np.tan: lambda f, a: (1.0 + f * f,),
    np.arcsin: lambda f, a: (1.0 / np.sqrt(1.0 - a * a),),
    np.arccos: lambda f, a: (-1.0 / np.sqrt(1.0 - a * a),),
    np.arctan: lambda f, a: (1.0 / (1.0 + a * a),),
    np.sinh: lambda f, a: (np.cosh(a),),
    np.cosh: lambda f, a: (np.sinh(a),),
    np.tanh: lambda f, a: (1.0 - f * f,),
}
"""Partial derivatives of each NumPy function, given its value and its arguments."""
_COMPARISONS = {
    np.less, np.less_equal, np.greater, np.greater_equal, np.equal, np.not_equal, np.isfinite, np.isnan, np.signbit,
}  # fmt: skip


def register_law(
    name: str,
    law: Law | Any,
    *,
    parameters: Mapping[str, str | float | Parameter] | None = None,
    states: Mapping[str, str | float] | None = None,
    complex_law: Any = None,
    title: str = "",
    summary: str = "User-defined contact law.",
    reference: str = "",
) -> Model:
    """Register a user-defined contact law as a model that :func:`impact` and :func:`history` know by ``name``.

    Clubhead and ball are two rigid bodies; the law gives the forces between them. It describes ball and face together,
    so the characteristic time of the club is not used. The law is known in this process only; registering a name again
    replaces its law.

    Parameters
    ----------
    name
        Name of the model: a word that no built-in model uses.
    law
        Called as ``law(touch, values)`` with a :class:`Touch` and the values of the parameters by name [SI]; returns
        the normal force on the ball, and the friction on the ball up the face and towards the toe [N]. A negative
        normal force counts as zero. With ``states`` it is called as ``law(touch, values, states)``, with their values
        by name, and returns their rates by name as well. For :func:`sensitivity` it is called with dual numbers: use
        functions of NumPy, not of ``math``. A compiled law is a C function, ``void law(const double *touch, const
        double *values, const double *states, double *result)``, given as a ctypes function or an object with its
        ``address``, such as a Numba ``cfunc``. ``touch`` holds the numbers of a :class:`Touch` in order; ``result``
        receives the three forces and the rates of the states.
    parameters
        Default of each parameter by name: text with a unit, an SI number, or a :class:`Parameter` with meaning, bounds
        and source.
    states
        State variables of the law, at most 24, such as the stretch of a spring along the face; they start at zero.
        Given by name with their typical size, text with a unit or an SI number, which scales the error tolerance.
    complex_law
        For a compiled law, the same function of complex numbers, each a pair of doubles, from which derivatives are
        computed.
    title, summary, reference
        As for :class:`Model`.

    Returns
    -------
    Model
        The registered model.

    Raises
    ------
    InputError
        The name is not a word or is that of a built-in model, the law is not callable, or a default or a size is not a
        number.
    """
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("name", name, "a word of letters, digits and underscores")
    if name in models() or name in MODULES or name == "all":
        raise InputError("name", name, "a name that no built-in model has")
    address = function_address(law)
    if not callable(law) and not address:
        raise InputError("law", law, "a function of a Touch and the values of the parameters")
    for what, text in (("title", title), ("summary", summary), ("reference", reference)):
        check_text(what, text)
    if not isinstance(parameters, Mapping | None):
        raise InputError("parameters", parameters, 'values by name, as in {"stiffness": 3e6, "damping": "0.006 s/m"}')
    if not isinstance(states, Mapping | None):
        raise InputError("states", states, 'natural sizes by name, as in {"stretch": "0.1 mm"}')
    declared = tuple(_parameter(key, value) for key, value in (parameters or {}).items())
    sizes = {key: _parameter(key, value).default for key, value in (states or {}).items()}
    if len(sizes) > MOST_STATES or not all(size > 0.0 for size in sizes.values()):
        raise InputError("states", sizes, f"at most {MOST_STATES} sizes above 0")
    model = Model(
        name=name, title=title or name, kind="contact", summary=summary, reference=reference,
        laws=("momentum", "angular_momentum"), laws_without=None, parameters=declared,
    )  # fmt: skip
    OWN[name] = SimpleNamespace(MODEL=model, BACKEND=OwnLaw(model, law, sizes, address, function_address(complex_law)))
    forget_parameters()
    return model


def source_of(model: str) -> list[str]:
    """Return the text that identifies a registered law: its source file, else its code; [] for other models.

    A store of unfinished work must not mix results from before and after the law was edited.
    """
    if model not in OWN:
        return []
    law = OWN[model].BACKEND.law
    function = law if inspect.isroutine(law) or not callable(law) else type(law).__call__
    with suppress(TypeError, OSError):
        return [Path(inspect.getfile(function)).read_text(encoding="utf-8", errors="replace")]
    code = getattr(function, "__code__", None)
    return [os.urandom(16).hex() if code is None else marshal.dumps(code).hex()]


def _parameter(name: str, given: Any) -> Parameter:
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("name of a parameter", name, "a word of letters, digits and underscores")
    if isinstance(given, Parameter):
        return replace(given, name=name)
    dimension = units.dimension_of(given, name=name)
    value, si = units.parse(given, dimension, name=name), units.symbols(dimension)[0]
    return Parameter(name, si, name.replace("_", " "), value, -math.inf, math.inf, "given with the law")


class OwnLaw(Backend):
    """The backend of a user-defined law: the core computes one shot at a time."""

    def __init__(
        self, model: Model, law: Any, sizes: Mapping[str, float], address: int = 0, complex_address: int = 0
    ) -> None:
        self.model, self.states = model, dict(sizes)
        self.has_derivatives = not address or bool(complex_address)
        self.law = law
        sized = [*sizes.values()]
        if address:
            self._compiled = law, complex_address  # kept alive
            self.law = _called_by_pointer(address, [each.name for each in model.parameters], [*sizes])
            self._held = core.LawHandle.at(address, complex_address, sized)
        else:
            self._held = core.LawHandle(self._call, self._call_with_derivatives, sized)

    def _call(self, touch: Any, values: Any, states: Any) -> tuple[float, ...]:
        """Call the law with plain numbers; return the forces and the rates of the states."""
        if not all(map(math.isfinite, touch)):
            return (math.nan,) * (3 + len(states))
        return evaluate_law(
            self.law, Touch._make(touch), self._parameters_by_name(values), dict(zip(self.states, states, strict=True))
        )

    def _call_with_derivatives(self, touch: Any, values: Any, states: Any) -> list[float]:
        """Call the law with dual numbers, each given as its value followed by its derivatives."""
        touch, values, states = (
            [Dual(row[0], row[1:]) for row in np.array(each).reshape(-1, 1 + DIRECTIONS)]
            for each in (touch, values, states)
        )
        if not all(math.isfinite(each.value) for each in touch):
            return [math.nan] * ((3 + len(states)) * (1 + DIRECTIONS))
        now = dict(zip(self.states, states, strict=True))
        try:
            given = (Touch._make(touch), self._parameters_by_name(values), *([now] if now else []))
            returned = flatten_results(self.law(*given), now)
        except (AttributeError, TypeError) as error:
            raise RunError(
                f"the law of contact has no derivatives: {error}; use functions of NumPy, such as np.sqrt and np.tanh,"
                " which take numbers that carry derivatives"
            ) from error
        except RunError:
            raise
        except Exception as error:
            raise RunError(f"the law of contact fails: {type(error).__name__}: {error}") from error
        results = (each.item() if isinstance(each, np.ndarray) else each for each in returned)
        none = np.zeros(DIRECTIONS)  # the derivatives of a plain number
        return [each for one in results for each in (float(_value(one)), *getattr(one, "tangent", none).tolist())]

    def _parameters_by_name(self, values: Any) -> dict[str, Any]:
        return {each.name: value for each, value in zip(self.model.parameters, values, strict=True)}

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Compute one contact after the other; report invalid inputs and contacts that do not end as problems."""
        return self._rows(
            shots, len(outputs()), lambda given, values, tolerance: self._held.impact(given, values, tolerance)
        )

    def sensitivities(
        self, shots: Request, chosen: Sequence[int], variables: Sequence[int]
    ) -> tuple[NDArray[Any], Problems]:
        """Return value and derivatives of each chosen output, as the core does for its own models."""
        if not self.has_derivatives:
            raise InputError("model", self.model.name, "one with derivatives: register the law with a complex_law")

        def differentiated(given: list[float], values: list[float], tolerance: float) -> tuple[Any, str]:
            result, why = self._held.sensitivity(given, values, list(variables), tolerance)
            if result is None:
                return None, why
            launched, jacobian = result
            return np.column_stack([launched, jacobian])[list(chosen)].ravel(), ""

        return self._rows(shots, len(chosen) * (1 + len(variables)), differentiated)

    def _rows(
        self, shots: Request, size: int, compute: Callable[[list[float], list[float], float], tuple[Any, str]]
    ) -> tuple[NDArray[Any], Problems]:
        """Return ``size`` numbers per shot, NaN for shots without a result, and the reasons."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, shots.inputs, usual, shots.size, None, shots.threads, None)
        refused = {row for row, *_ in problems}
        result = np.full((size, shots.size), np.nan)
        for row in range(shots.size):
            if row not in refused:
                given, values = (
                    [float(each if isinstance(each, (int, float)) else each[row]) for each in columns]
                    for columns in (shots.inputs, shots.parameters)
                )
                try:
                    fault = _fault(given)
                    if fault is None:
                        computed, why = compute(given, values, shots.accuracy or USUAL_TOLERANCE)
                        fault = None if not why else ("model", f"{self.model.name}: {UNFINISHED[why]}")
                        result[:, row] = math.nan if fault else computed
                    if fault:
                        problems.append((row, fault[0], fault[1]))
                except RunError as error:
                    if shots.on_error == "raise":
                        raise
                    problems.append((row, "model", str(error)))
            if shots.progress is not None:
                shots.progress(row + 1)
        return result, sorted(problems)

    def history(self, model: str, given: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Compute the time history of one contact at evenly spaced times."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, given, usual, 1, None, 1, None)
        fault = problems[0][1:] if problems else _fault(given)
        if fault is not None:
            raise ValueError(*fault)
        bodies = TwoBodies(
            dict(zip(inputs(), given, strict=True)), self.law, self._parameters_by_name(parameters), self.states
        )
        try:
            solution = bodies.run(accuracy or USUAL_TOLERANCE)
        except UnfinishedContactError as error:
            raise ValueError("model", f"{self.model.name}: {error}") from None
        return {**sample_history(bodies, solution), "launch": launch_outputs(bodies, solution)}


def _fault(given: Sequence[float]) -> tuple[str, str] | None:
    """Return an input that a user-defined law does not support and what to do, or None."""
    named = dict(zip(inputs(), given, strict=True))
    if named["characteristic_time"] != named["included_time"]:
        return "characteristic_time", "leave it out: a user-defined law describes ball and face together"
    return None


def _called_by_pointer(address: int, names: Sequence[str], states: Sequence[str]) -> Law:
    """Wrap a compiled law as a Python function."""
    pointer = ctypes.POINTER(ctypes.c_double)
    function = ctypes.CFUNCTYPE(None, pointer, pointer, pointer, pointer)(address)

    def law(touch: Touch, values: Mapping[str, float], now: Mapping[str, float] | None = None) -> tuple[Any, ...]:
        result = (ctypes.c_double * (3 + len(states)))()
        given = [touch, [values[name] for name in names], [(now or {})[name] for name in states]]
        function(*((ctypes.c_double * max(len(each), 1))(*each) for each in given), result)
        return (*result[:3], result[3:]) if states else tuple(result)

    return law
