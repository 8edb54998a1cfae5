"""Numbers that carry derivatives through a law of contact: a value and its derivatives in several directions."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray


class Dual(NDArrayOperatorsMixin):
    """A number with derivatives, for arithmetic, comparisons and functions of NumPy.

    Comparisons look at the value alone. Functions of ``math`` take no such numbers, and raise a TypeError.
    """

    __slots__ = ("tangent", "value")

    def __init__(self, value: float, tangent: NDArray[Any]) -> None:
        self.value, self.tangent = value, tangent

    def __repr__(self) -> str:
        return f"Dual({self.value!r})"

    def __bool__(self) -> bool:
        return bool(self.value)

    def __array_ufunc__(self, ufunc: Any, method: str, *given: Any, **options: Any) -> Any:
        target = options.pop("out", ())  # of += and the like, which make a new number of a name
        if method != "__call__" or options or not all(isinstance(each, Dual) for each in target):
            return NotImplemented
        if ufunc in _COMPARISONS:
            return ufunc(*map(_value, given))
        return _call(ufunc, *given)


def dual_of(number: Any, directions: int) -> Dual:
    """Return a number with derivatives; those of a plain one are zero."""
    number = number.item() if isinstance(number, np.ndarray) else number
    return number if isinstance(number, Dual) else Dual(float(number), np.zeros(directions))


def _value(number: Any) -> Any:
    return number.value if isinstance(number, Dual) else number


def _call(ufunc: Any, *given: Any) -> Any:
    """Return the function of numbers at least one of which has derivatives."""
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
"""Of each function of NumPy its slopes by its arguments, given its value and the arguments."""
_COMPARISONS = {
    np.less, np.less_equal, np.greater, np.greater_equal, np.equal, np.not_equal, np.isfinite, np.isnan, np.signbit,
}  # fmt: skip
