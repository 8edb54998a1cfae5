"""Hold-out and bootstrap: the cost on shots that a fit has not seen, and the scatter of the parameters."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.identification.cost import Cost
from clubface.identification.refine import Linear, refine
from clubface.identification.simulator import Simulator
from clubface.support.arrays import Floats

FOLDS = 5
BOOTSTRAP = 200
REACH = 6.0
"""How far the first step of a refit may go, in standard errors."""
NEAR = 2e-3
"""A refit ends where the cost times the number of values, over itself, would fall by less: 1 is one standard error."""
UNKNOWN = 0.05
"""Standard error assumed where the data do not tell, in parts of the range."""


class Refits:
    """Fits to parts of the shots, each started at the optimum of all of them.

    Parameters
    ----------
    simulator, cost
        Simulator and cost of all shots.
    optimum
        The fit to all shots, a point of the unit cube.
    errors
        Standard errors of the coordinates of the optimum; infinite where the shots do not determine one.
    """

    def __init__(self, simulator: Simulator, cost: Cost, optimum: Floats, errors: Floats) -> None:
        self.simulator = simulator
        self.cost = cost
        self.optimum = optimum
        self.errors = np.where(np.isfinite(errors), np.minimum(errors, UNKNOWN), UNKNOWN)
        self.values = int(np.isfinite(simulator.shots.launches).sum())
        self._linear = Linear(*simulator.derivatives(optimum))

    def to(self, counts: NDArray[np.int64]) -> Floats:
        """Return the fit to shots that count as often as ``counts`` says, shape (shots,)."""
        used = np.flatnonzero(counts)
        first = Linear(self._linear.simulated[:, used], self._linear.derivatives[:, :, used])
        part = self.simulator.of(self.simulator.shots.select(used))
        cost = self.cost.select(used, counts[used])
        return refine(part, cost, self.optimum, radius=REACH * self.errors, first=first, fall=NEAR / self.values).point


def interval_of(samples: Floats, confidence: float, groups: int) -> Floats:
    """Return the ends of the intervals of bootstrapped parameters, shape (2, free), when ``groups`` groups were drawn.

    The ends are percentiles. They are moved outwards by as much as Student's t distribution is wider than the normal
    distribution, because plain percentiles are too narrow for few groups: T. C. Hesterberg, What teachers should know
    about the bootstrap, The American Statistician 69 (2015) 371-386. The k-th of B sorted samples stands for the
    fraction (k - 1/3) / (B + 1/3) of all (median-unbiased: R. J. Hyndman and Y. Fan, Sample quantiles in statistical
    packages, The American Statistician 50 (1996) 361-365); numpy's own rule cuts off the tails of few samples.
    """
    from scipy.special import ndtr, stdtrit

    degrees = max(groups - samples.shape[1], 1)
    part = float(ndtr(np.sqrt(groups / degrees) * stdtrit(degrees, 0.5 * (1.0 + confidence))))
    return np.quantile(samples, [1.0 - part, part], axis=0, method="median_unbiased")


def held_out(refits: Refits, folds: int, seed: int, once: Callable[[str, Callable[[], Any]], Any]) -> Floats:
    """Return launches of all shots, shape (quantities, shots), each by a fit to the other folds.

    Groups of shots are dealt to folds at random. ``once`` returns a part by name, computed where it is not yet known.
    """
    groups = refits.simulator.shots.groups
    count = int(groups.max()) + 1
    fold_of = (np.random.default_rng((seed, count, folds)).permutation(count) % folds)[groups]
    predicted = np.empty_like(refits.simulator.shots.launches)
    for fold in range(folds):
        others = (fold_of != fold).astype(np.int64)
        point = once(f"fold {fold}", lambda others=others: refits.to(others).tolist())
        left = np.flatnonzero(fold_of == fold)
        predicted[:, left] = refits.simulator.of(refits.simulator.shots.select(left)).launch(np.array(point))
    return predicted


def bootstrap(refits: Refits, samples: int, seed: int, once: Callable[[str, Callable[[], Any]], Any]) -> Floats:
    """Return fits to groups drawn with replacement, shape (samples, free): B. Efron, Annals of Statistics 7 (1979)."""
    groups = refits.simulator.shots.groups
    count = int(groups.max()) + 1
    found = []
    for sample in range(samples):
        drawn = np.random.default_rng((seed, count, 0, sample)).integers(0, count, count)
        counts = np.bincount(drawn, minlength=count)[groups]
        found.append(once(f"bootstrap {sample}", lambda counts=counts: refits.to(counts).tolist()))
    return np.array(found)
