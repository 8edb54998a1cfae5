"""The launches that a prior expects: how surprising a measured launch is, and whether it is out of reach."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.measured.shots import QUANTITIES
from clubface.support.arrays import Floats

DRAWS = 4000
"""Deliveries of the prior whose launches tell what it expects."""


class UnreachableLaunchError(InputError):
    """A launch so far from those of the prior that no delivery can be inferred for it."""


def expected_launches(predict: Callable[[Floats], Floats], dimensions: int, seed: int) -> Floats:
    """Return launches of the prior, shape (draws, quantities), without those that cannot be computed.

    ``predict`` computes the launches of points of a standard normal prior, shape (n, dimensions).
    """
    found = predict(np.random.default_rng([seed, 1]).standard_normal((DRAWS, dimensions)))
    return found[np.isfinite(found).all(axis=1)]


def surprise(expected: Floats, target: Floats, scale: Floats, seed: int) -> float:
    """Return the probability of a launch that lies further from the mean of the ``expected`` launches than ``target``.

    The distance is measured with the covariance of the expected launches, to which the noise of the measurement is
    added, with the standard deviations ``scale``. For normally distributed launches the distance has a chi-squared
    distribution.
    """
    random = np.random.default_rng([seed, 2])
    covariance = np.atleast_2d(np.cov(expected.T)) + np.diag(scale**2)
    away = target - expected.mean(axis=0)
    distance = float(away @ np.linalg.solve(covariance, away))
    others = expected + scale * random.standard_normal(expected.shape) - expected.mean(axis=0)
    further = np.sum(others * np.linalg.solve(covariance, others.T).T, axis=1) >= distance
    return float((1.0 + further.sum()) / (1.0 + len(expected)))


def unreachable(measured: Mapping[str, float], expected: Floats, who: str) -> UnreachableLaunchError:
    """Return the error for a launch that the prior ``who`` cannot reach; ``expected`` are the launches it expects."""
    given = ", ".join(f"{name} {units.show(value, QUANTITIES[name], 4)}" for name, value in measured.items())
    told = ", ".join(
        f"{name} {units.show(float(values.mean()), QUANTITIES[name], 3)}"
        f" +- {units.show(float(values.std()), QUANTITIES[name], 2)}"
        for name, values in zip(measured, expected.T, strict=True)
    )
    advice = f"within reach of {who} expects {told}: if units and club are right, give a prior that suits the golfer"
    return UnreachableLaunchError("launch", given, advice)
