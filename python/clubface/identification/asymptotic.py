"""Standard errors of the minimum of a cost, for intervals without a bootstrap.

Fisher's information gives the standard errors of the most likely parameters. The minimum of another cost scatters more.
The minimum of the mean absolute error scatters by a quarter more if deviations are normally distributed, and by more
still if the weights are not those of the noise, as in the cost of Caldwell and McPhee (2023). The covariance is A^-1 B
A^-1, with A the mean curvature of the cost and B the variance of its gradient: P. J. Huber, The behavior of maximum
likelihood estimates under nonstandard conditions, Proc. 5th Berkeley Symp. 1 (1967) 221-233.
"""

from __future__ import annotations

import numpy as np

from clubface.identification.cost import Cost
from clubface.identification.identifiability import Identifiability
from clubface.identification.simulator import Simulator
from clubface.support.arrays import Floats


def errors_of_minimum(simulator: Simulator, cost: Cost, point: Floats, told: Identifiability) -> Floats:
    """Return the standard errors of the coordinates of the minimum ``point`` of a cost, shape (free,).

    Deviations are taken as independent and normally distributed, with the standard deviations of ``told``. An error is
    infinite where that of ``told`` is infinite.
    """
    _, derivatives = simulator.derivatives(point)
    curvatures, variances = _moments(cost, told.noise)
    # Along the directions in which launches change at all, in standard errors: both matrices are of the order of 1.
    known = [each.vector * each.error for each in told.directions if np.isfinite(each.error)]
    if not known:
        return np.full(len(point), np.inf)
    rows = np.einsum("qfs,df->qds", derivatives, known)
    bread = np.einsum("qds,qes,qs->de", rows, rows, cost.weights * curvatures[:, None])
    meat = np.einsum("qds,qes,qs->de", rows, rows, cost.weights**2 * variances[:, None])
    inverse = np.linalg.inv(bread)
    spread = inverse @ known
    covariance = spread.T @ meat @ spread
    return np.where(np.isfinite(told.errors), np.sqrt(np.diag(covariance)), np.inf)


def _moments(cost: Cost, noise: Floats) -> tuple[Floats, Floats]:
    """Return, a quantity, the mean curvature of the loss and the variance of its slope where deviations are normal."""
    from scipy.special import ndtr

    if cost.loss == "absolute":
        # The slope jumps by 2 at 0, where a normal distribution has the density 1 / (noise sqrt(2 pi)).
        return np.sqrt(2.0 / np.pi) / noise, np.ones_like(noise)
    if cost.loss == "squares":
        return np.full_like(noise, 2.0), 4.0 * noise**2
    knee = cost.knees / noise
    inside = 2.0 * ndtr(knee) - 1.0
    density = np.exp(-0.5 * knee**2) / np.sqrt(2.0 * np.pi)
    return 2.0 * inside, 4.0 * noise**2 * (inside - 2.0 * knee * density + knee**2 * (1.0 - inside))
