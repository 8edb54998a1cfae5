"""What published errors say of themselves: a mean absolute error beside a standard deviation implies a bias.

For a normal error of bias b and deviation s the mean magnitude is s sqrt(2/pi) exp(-b^2/(2 s^2)) + b erf(b/(s sqrt 2)).
Without a bias it is 0.8 of the deviation; where it is more, the rest is bias. If the published deviation is one of
magnitudes, its square and that of their mean add up to b^2 + s^2 instead.
"""

from __future__ import annotations

import math
from collections.abc import Callable


def mean_magnitude(bias: float, deviation: float) -> float:
    """Return the mean magnitude of a normal error."""
    ratio = bias / (deviation * math.sqrt(2.0))
    return deviation * math.sqrt(2.0 / math.pi) * math.exp(-(ratio**2)) + bias * math.erf(ratio)


def bias_of(mae: float, deviation: float) -> float:
    """Return the bias, not negative, of a normal error with mean magnitude ``mae`` and standard ``deviation``.

    Zero where the magnitude is no more than an error without bias has; then its tails are heavier than normal.
    """
    if mae <= mean_magnitude(0.0, deviation):
        return 0.0
    return _root(lambda bias: mean_magnitude(bias, deviation) - mae, 0.0, mae)


def bias_of_magnitudes(mae: float, deviation: float) -> float:
    """Return the bias where ``deviation`` is that of the magnitudes of the error; zero as for :func:`bias_of`."""
    total = math.hypot(mae, deviation)

    def short(bias: float) -> float:
        return mean_magnitude(bias, math.sqrt(max(total**2 - bias**2, 1e-30))) - mae

    return 0.0 if short(0.0) >= 0.0 else _root(short, 0.0, total)


def _root(of: Callable[[float], float], low: float, high: float) -> float:
    """Return where ``of``, which rises, is zero."""
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if of(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)
