"""Which launches a prior expects: how surprising a measured one is beside them, or whether it is out of reach."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.measured.shots import QUANTITIES

Values = NDArray[np.float64]

DRAWS = 4000
"""Deliveries of the prior whose launches tell what it expects."""


class UnreachableLaunchError(InputError):
    """A launch so far from those of the prior that no delivery for it can be told."""


def expected_launches(predict: Callable[[Values], Values], dimensions: int, seed: int) -> Values:
    """Return launches of the prior, shape [draws, quantities], without those that cannot be computed.

    ``predict`` computes the launches of points of a standard normal prior, shape [n, dimensions].
    """
    found = predict(np.random.default_rng([seed, 1]).standard_normal((DRAWS, dimensions)))
    return found[np.isfinite(found).all(axis=1)]


def surprise(expected: Values, target: Values, scale: Values, seed: int) -> float:
    """Return the probability of launches further from the mean of those ``expected`` than ``target``.

    The distance, by their covariance, of a normal launch has a chi-squared distribution; what is measured adds its
    noise, of the standard deviations ``scale``.
    """
    random = np.random.default_rng([seed, 2])
    covariance = np.atleast_2d(np.cov(expected.T)) + np.diag(scale**2)
    away = target - expected.mean(axis=0)
    distance = float(away @ np.linalg.solve(covariance, away))
    others = expected + scale * random.standard_normal(expected.shape) - expected.mean(axis=0)
    further = np.sum(others * np.linalg.solve(covariance, others.T).T, axis=1) >= distance
    return float((1.0 + further.sum()) / (1.0 + len(expected)))


def unreachable(measured: Mapping[str, float], expected: Values, who: str) -> UnreachableLaunchError:
    """Return the error for a launch beyond the reach of ``who`` expects the launches ``expected``."""
    given = ", ".join(f"{name} {units.show(value, QUANTITIES[name], 4)}" for name, value in measured.items())
    told = ", ".join(
        f"{name} {units.show(float(values.mean()), QUANTITIES[name], 3)}"
        f" +- {units.show(float(values.std()), QUANTITIES[name], 2)}"
        for name, values in zip(measured, expected.T, strict=True)
    )
    advice = f"within reach of {who} expects {told}: if units and club are right, give a prior that suits the golfer"
    return UnreachableLaunchError("launch", given, advice)
