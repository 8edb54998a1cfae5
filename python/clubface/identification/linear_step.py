"""The best step within a box where launches are linear: least absolute deviations or bounded least squares.

The mean absolute error in the cost of Caldwell and McPhee (2023) has no gradient where a deviation vanishes, and at its
minimum as many deviations vanish as there are parameters. A gradient method gets stuck there. The launches themselves
are smooth. They are therefore made linear, and the cost of the linear launches is minimised exactly, with its kinks and
the bounds.
"""

from __future__ import annotations

import numpy as np

from clubface.identification.cost import Cost
from clubface.identification.least_absolute import least_absolute
from clubface.support.arrays import Floats

HUBER_ROUNDS = 8
"""Reweightings of a step of the robust cost; the next linearisation goes on from there."""


def best_step(cost: Cost, simulated: Floats, derivatives: Floats, lower: Floats, upper: Floats) -> Floats:
    """Return the step between ``lower`` and ``upper``, shape (free,), that minimises the cost of linear launches.

    Parameters
    ----------
    cost
        To be minimised.
    simulated
        Launches where the step begins, shape (quantities, shots).
    derivatives
        Their derivatives, shape (quantities, free, shots).
    lower, upper
        The box, which holds 0.
    """
    used = cost.weights > 0.0
    deviations = (simulated - cost.measured)[used]
    rows = np.moveaxis(derivatives, 1, 2)[used]
    weights = cost.weights[used]
    if cost.loss == "absolute":
        return least_absolute(deviations * weights, rows * weights[:, None], lower, upper)
    if cost.loss == "squares":
        roots = np.sqrt(weights)
        return _least_squares(deviations * roots, rows * roots[:, None], lower, upper)
    knees = np.broadcast_to(cost.knees[:, None], cost.weights.shape)[used]
    step = np.zeros(len(lower))
    for _ in range(HUBER_ROUNDS):
        # Huber's loss has the gradient of least squares with these weights.
        sizes = np.maximum(np.abs(deviations + rows @ step), knees)
        roots = np.sqrt(weights * knees / sizes)
        following = _least_squares(deviations * roots, rows * roots[:, None], lower, upper)
        moved = np.max(np.abs(following - step))
        step = following
        if moved <= 1e-3 * np.max(np.abs(step)):
            break
    return step


def linear_cost(cost: Cost, simulated: Floats, derivatives: Floats, step: Floats) -> float:
    """Return the cost after a step if the launches were linear."""
    return cost.value(simulated + np.einsum("qfs,f->qs", derivatives, step))


def _least_squares(deviations: Floats, rows: Floats, lower: Floats, upper: Floats) -> Floats:
    """Minimise the sum of squares of deviations + rows step in the box."""
    from scipy.optimize import lsq_linear

    scales = np.sqrt(np.sum(rows**2, axis=0))
    scales = np.where(scales > 0.0, scales, 1.0)
    orthogonal, triangle = np.linalg.qr(rows / scales)
    found = lsq_linear(triangle, -(orthogonal.T @ deviations), bounds=(lower * scales, upper * scales), method="bvls")
    return np.clip(found.x / scales, lower, upper)
