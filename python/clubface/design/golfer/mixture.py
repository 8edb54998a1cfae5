"""Shots as a mixture of two normal distributions, of which that of the mishits is c times as wide.

A difference of two shots then has the covariance 2 C with the probability (1 - s)^2, (1 + c^2) C with 2 s (1 - s), and
2 c^2 C with s^2; share s, scale c and covariance C are those of the greatest likelihood. A mishit counts for little in
C, as in other robust estimates. How far C could be another with other mishits that go nearly as well with the shots is
part of its stated error.

Correlations are drawn towards zero by the share that makes their expected square error least (Ledoit and Wolf, 2004):
few shots and many quantities make strong correlations by chance alone. Spreads stay, and any number of shots gives
correlations that are possible together.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from clubface.support.arrays import Floats

ENOUGH = 40
"""Shots from which on mishits are looked for; with fewer they are those of the golfer that fills the gaps."""
SCALES = np.arange(1.5, 6.01, 0.25)
"""The scales of mishits that are tried."""
GAIN = 4.0
"""Least gain in logarithmic likelihood by which mishits are taken to exist."""
ROUNDS = 60
SETTLED = 1e-7
"""Part of the variances by which a covariance still changes when it is taken to be that of the greatest likelihood."""
VANISHES = 1e-12
"""Part of a variance below which a quantity is one that hardly ever changes: all its changes count as mishits."""
STANDARD_ERROR = 0.75
"""Variance of the estimated spread, in squared spreads over the number of shots: 3/4 from successive differences of
normally distributed shots, where it is 1/2 about the mean."""
MIXTURES = [(0.0, 1.0), *product((0.03, 0.08, 0.15, 0.25), (1.5, 2.0, 3.0, 4.5))]
"""Shares and scales of mishits between which shots may leave open what the golfer is."""
NO_MISHITS = 0.15
"""How likely the first of these is before any shot is seen; the others are all alike."""
TOLD = 2 / 3
"""What differences of successive shots tell, in shots: each of these is in two of them. Beside 1/2 about the mean, the
variance of a spread is 3/4 (``STANDARD_ERROR``)."""
BLOCKS = 20
"""Parts of a longer session, of which each is left out once to see how sure the spreads are (jackknife)."""
OF_FEW = 1.07
"""How much wider intervals from so few parts are: Student's distribution of 19 degrees of freedom, 2.09 for 1.96."""


def mixture(steps: Floats) -> tuple[Floats, float, float]:
    """Return covariance, share and scale of mishits of the greatest likelihood; share 0 where they gain too little."""
    covariance = covariance_of(steps, 0.0, 1.0)
    best = _weighed(steps, covariance, 0.0, 1.0).likelihood + GAIN
    found = (covariance, 0.0, 1.0)
    for scale in map(float, SCALES):
        share = 0.1
        for _ in range(ROUNDS):
            covariance = covariance_of(steps, share, scale, start=covariance)
            before, share = share, _weighed(steps, covariance, share, scale).mishits
            if abs(share - before) < 1e-5:
                break
        if (likelihood := _weighed(steps, covariance, share, scale).likelihood) > best:
            best, found = likelihood, (covariance, share, scale)
    return found


def covariance_of(steps: Floats, share: float, scale: float, *, start: Floats | None = None) -> Floats:
    """Return the covariance of shots that are no mishits, of the greatest likelihood for a share and scale of these.

    ``start`` is a covariance to begin with, such as that of another share.
    """
    first = shrunk(steps, np.full(len(steps), 0.5)).covariance
    covariance = first if start is None else start
    for _ in range(ROUNDS):
        weights = _weighed(steps, covariance, share, scale).weights
        before, covariance = covariance, shrunk(steps, weights).covariance
        size = np.sqrt(np.outer(np.diag(first), np.diag(first)))
        if (np.diag(covariance) < VANISHES * np.diag(first)).any():
            raise np.linalg.LinAlgError
        if (np.abs(covariance - before) <= SETTLED * size).all():
            break
    return covariance


class Shrunk(NamedTuple):
    """A covariance whose correlations are drawn towards zero, and by which share of them."""

    covariance: Floats
    share: float


def shrunk(steps: Floats, weights: Floats) -> Shrunk:
    """Return the covariance of weighted differences of shots with correlations shrunk after Ledoit and Wolf (2004).

    Their target is a multiple of the identity; here each quantity is in its own spread, so that spreads stay. The share
    is the sum of the variances of the correlations over the sum of their squares, at most 1.

    Parameters
    ----------
    steps
        Differences of successive shots, shape (n, k).
    weights
        By which the square of each counts, shape (n,): 1/2 each for normally distributed shots.
    """
    count = len(steps)
    weighted = steps * np.sqrt(weights)[:, None]
    spread = np.sqrt((weighted**2).mean(axis=0))
    if not (spread > 0.0).all():
        raise np.linalg.LinAlgError
    scaled = weighted / spread
    correlation = scaled.T @ scaled / count
    apart = ~np.eye(len(spread), dtype=bool)
    sampled = ((scaled**2).T @ scaled**2 / count - correlation**2)[apart].sum() / max(TOLD * count - 1.0, 1.0)
    squares = (correlation[apart] ** 2).sum()
    share = float(min(sampled / squares, 1.0)) if squares > 0.0 else 0.0
    correlation[apart] *= 1.0 - share
    return Shrunk(correlation * np.outer(spread, spread), share)


def shrinkage(steps: Floats, covariance: Floats, share: float, scale: float) -> float:
    """Return by which share the correlations of an estimated covariance were drawn towards zero."""
    return shrunk(steps, _weighed(steps, covariance, share, scale).weights).share


class _Weighed(NamedTuple):
    """How differences of shots go with a covariance: expected 1 / width, log likelihood, share of mishits they tell."""

    weights: Floats
    likelihood: float
    mishits: float


def _weighed(steps: Floats, covariance: Floats, share: float, scale: float) -> _Weighed:
    widths = np.array([2.0, 1.0 + scale**2, 2.0 * scale**2])
    chances = np.array([(1.0 - share) ** 2, 2.0 * share * (1.0 - share), share**2])
    root = np.linalg.cholesky(covariance)
    squares = (np.linalg.solve(root, steps.T) ** 2).sum(axis=0)[:, None]
    with np.errstate(divide="ignore"):
        logs = np.log(chances) - 0.5 * steps.shape[1] * np.log(widths) - 0.5 * squares / widths
    most = logs.max(axis=1, keepdims=True)
    each = np.exp(logs - most)
    total = each.sum(axis=1, keepdims=True)
    each /= total
    likelihood = float((most + np.log(total)).sum()) - len(steps) * float(np.log(np.diag(root)).sum())
    return _Weighed((each / widths).sum(axis=1), likelihood, float((each[:, 1] + 2.0 * each[:, 2]).mean() / 2.0))


def error_of(steps: Floats, covariance: Floats, share: float, scale: float) -> Floats:
    """Return the standard errors of the spreads: of the sample, and of not knowing the mishits."""
    spread = np.sqrt(np.diag(covariance))
    of_sample = spread * np.sqrt(STANDARD_ERROR / (len(steps) + 1))
    if len(steps) + 1 >= ENOUGH:
        parts = np.array_split(np.arange(len(steps)), BLOCKS)
        without = [np.delete(steps, part, axis=0) for part in parts]
        spreads = np.sqrt([np.diag(covariance_of(each, share, scale, start=covariance)) for each in without])
        of_sample = np.maximum(of_sample, OF_FEW * np.sqrt((BLOCKS - 1) * spreads.var(axis=0)))
    return np.hypot(of_sample, spread * _doubt(steps, spread))


def _doubt(steps: Floats, spread: Floats) -> Floats:
    """Return how far off the spreads are in proportion: in the root mean square over mixtures by their likelihood."""
    found = [covariance_of(steps, *each) for each in MIXTURES]
    logs = np.array([_weighed(steps, each, *of).likelihood for of, each in zip(MIXTURES, found, strict=True)])
    before = [NO_MISHITS, *[(1.0 - NO_MISHITS) / (len(MIXTURES) - 1)] * (len(MIXTURES) - 1)]
    chances = before * np.exp(TOLD * (logs - logs.max()))
    away = np.log(np.sqrt([np.diag(each) for each in found]) / spread)
    return np.sqrt(chances @ away**2 / chances.sum())


def mean_of(values: Floats, covariance: Floats, share: float, scale: float) -> Floats:
    """Return the mean in which a shot counts the less, the more likely it is a mishit."""
    mean, size = np.median(values, axis=0), values.shape[1]
    if share == 0.0:
        return values.mean(axis=0)
    widths, chances = np.array([1.0, scale**2]), np.array([1.0 - share, share])
    for _ in range(ROUNDS):
        away = values - mean
        squares = np.einsum("ni,ij,nj->n", away, np.linalg.inv(covariance), away)[:, None]
        logs = np.log(chances) - 0.5 * size * np.log(widths) - 0.5 * squares / widths
        weights = np.exp(logs - logs.max(axis=1, keepdims=True))
        weights = (weights / widths).sum(axis=1) / weights.sum(axis=1)
        mean = (values * weights[:, None]).sum(axis=0) / weights.sum()
    return mean
