"""Samples of a posterior by tempered, adaptive importance sampling.

The prior is a standard normal distribution; the caller scales the quantities accordingly. The first proposal is the
prior. Its draws are weighted by the likelihood raised to a power, which is as high as the draws can bear. The mean and
covariance of the weighted draws make the next proposal, a multivariate t distribution with heavier tails. Once the
power is one, draws are collected until as many are effective as wanted. All draws of the last proposal are independent,
so their effective number is known, which it is not for a Markov chain. Tempering follows Neal (2001), adaptation
follows Cappé et al. (2004).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.support.arrays import Floats

PER_STAGE = 4000
"""Draws from which a proposal is made."""
TARGET = 0.25
"""Part of a stage's draws that must stay effective; it decides how far the power of the likelihood rises."""
FREEDOM = 7.0
"""Degrees of freedom of the t proposals."""
INFLATION = 1.15
"""By how much their covariance exceeds that of the weighted draws."""
MOST_STAGES = 60
REFINEMENTS = 4
"""Proposals made at power one."""
MOST_DRAWS = 400_000
"""Draws after which a sample is given up to be as large as wanted."""
HOPELESS_DRAWS, HOPELESS = 40_000, 5.0
"""Draws after which a sample is given up that has no more effective ones than this."""
RIDGE = 1e-9
"""Added to the variances, so that a sample without spread in a direction still has a proposal."""


class Sample(NamedTuple):
    """Draws from a posterior, equally weighted.

    Attributes
    ----------
    points
        The draws, shape (draws, dimensions).
    effective
        Effective number of the weighted draws from which they were resampled.
    draws
        Number of weighted draws, of the last proposal alone.
    evaluations
        Number of likelihoods computed in all.
    stages
        Number of proposals made.
    log_evidence
        Logarithm of the mean likelihood under the prior.
    largest_weight
        Largest fraction of the total weight that a single draw has. If it is near 1, the sample rests on one draw.
    """

    points: Floats
    effective: float
    draws: int
    evaluations: int
    stages: int
    log_evidence: float
    largest_weight: float


class Proposal(NamedTuple):
    """A multivariate t, or with infinite freedom a normal distribution.

    Attributes
    ----------
    mean
        Its centre.
    root
        Lower Cholesky factor of its scale matrix.
    freedom
        Degrees of freedom.
    """

    mean: Floats
    root: Floats
    freedom: float

    def draw(self, random: np.random.Generator, count: int) -> Floats:
        """Return draws, shape [count, dimensions]."""
        normal = random.standard_normal((count, self.mean.size))
        if math.isfinite(self.freedom):
            normal /= np.sqrt(random.chisquare(self.freedom, count) / self.freedom)[:, None]
        return self.mean + normal @ self.root.T

    def log_density(self, points: Floats) -> Floats:
        """Return the logarithm of the density at each point."""
        size = self.mean.size
        squares = np.sum(np.linalg.solve(self.root, (points - self.mean).T) ** 2, axis=0)
        scale = -float(np.sum(np.log(np.diag(self.root))))
        if not math.isfinite(self.freedom):
            return scale - 0.5 * size * math.log(2.0 * math.pi) - 0.5 * squares
        nu = self.freedom
        constant = math.lgamma(0.5 * (nu + size)) - math.lgamma(0.5 * nu) - 0.5 * size * math.log(nu * math.pi)
        return scale + constant - 0.5 * (nu + size) * np.log1p(squares / nu)


def standard_normal(dimensions: int) -> Proposal:
    """Return the prior."""
    return Proposal(np.zeros(dimensions), np.eye(dimensions), math.inf)


def sample(
    log_likelihood: Callable[[Floats], Floats],
    dimensions: int,
    *,
    size: int,
    seed: int,
    progress: Callable[[float], object] | None = None,
) -> Sample:
    """Sample the posterior of a likelihood and a standard normal prior.

    Parameters
    ----------
    log_likelihood
        Computes the logarithm of the likelihood of points, shape (n, dimensions); NaN or minus infinity where a point
        is impossible.
    dimensions
        Number of dimensions of the points.
    size
        How many points to return. Twice as many draws are made effective.
    seed
        Seed of the random numbers.
    progress
        Called before each stage with the power of the likelihood that is reached, 0 to 1.

    Raises
    ------
    FloatingPointError
        No draw of the prior is possible.
    """
    random = np.random.default_rng(seed)
    prior = proposal = standard_normal(dimensions)
    power, stages, refined, evaluations, best = 0.0, 0, 0, 0, 0.0
    chosen = proposal
    while stages < MOST_STAGES and refined < REFINEMENTS:
        if progress is not None:
            progress(power)
        points = proposal.draw(random, PER_STAGE)
        likelihood, base = log_likelihood(points), prior.log_density(points) - proposal.log_density(points)
        stages, evaluations = stages + 1, evaluations + PER_STAGE
        possible = np.isfinite(likelihood)
        if not possible.any():
            raise FloatingPointError("no draw is possible")
        # At any power: zero times minus infinity would be none.
        likelihood, base = np.where(possible, likelihood, 0.0), np.where(possible, base, -np.inf)
        power = _power(base, likelihood, power)
        weights = normalised(base + power * likelihood)
        if power == 1.0:
            refined += 1
            if effective(weights) > best:
                best, chosen = effective(weights), proposal
        proposal = _fitted(points, weights)
    last = proposal if refined < REFINEMENTS else chosen
    return _collected(log_likelihood, prior, last, random, size, stages, evaluations)


def _collected(
    log_likelihood: Callable[[Floats], Floats],
    prior: Proposal,
    proposal: Proposal,
    random: np.random.Generator,
    size: int,
    stages: int,
    evaluations: int,
) -> Sample:
    """Draw from the last proposal until enough draws are effective, and resample them."""
    all_points, all_logs = np.empty((0, prior.mean.size)), np.empty(0)
    while True:
        points = proposal.draw(random, max(PER_STAGE, size))
        likelihood = log_likelihood(points)
        base = prior.log_density(points) - proposal.log_density(points)
        logs = np.where(np.isfinite(likelihood), likelihood + base, -np.inf)
        all_points, all_logs = np.concatenate([all_points, points]), np.concatenate([all_logs, logs])
        weights = normalised(all_logs)
        reached = effective(weights)
        if reached >= 2 * size or all_logs.size >= (HOPELESS_DRAWS if reached <= HOPELESS else MOST_DRAWS):
            break
    top = float(all_logs.max())
    return Sample(
        points=all_points[systematic(weights, size, random)],
        effective=reached,
        draws=all_logs.size,
        evaluations=evaluations + all_logs.size,
        stages=stages,
        log_evidence=top + math.log(float(np.mean(np.exp(all_logs - top)))),
        largest_weight=float(weights.max()),
    )


def normalised(logs: Floats) -> Floats:
    """Return weights that add up to 1 from their logarithms."""
    weights = np.exp(logs - logs.max())
    return weights / weights.sum()


def effective(weights: Floats) -> float:
    """Return the effective number of draws with normalised ``weights`` (Kish)."""
    return float(1.0 / np.sum(weights**2))


def systematic(weights: Floats, size: int, random: np.random.Generator) -> NDArray[np.int64]:
    """Return the places of ``size`` draws chosen by weight, in random order."""
    ticks = (random.random() + np.arange(size)) / size
    places = np.minimum(np.searchsorted(np.cumsum(weights), ticks), weights.size - 1)
    return random.permutation(places)


def _power(base: Floats, likelihood: Floats, reached: float) -> float:
    """Return the largest power, from that ``reached`` to 1, at which enough draws are effective."""

    def enough(power: float) -> bool:
        return effective(normalised(base + power * likelihood)) >= TARGET * base.size

    if enough(1.0):
        return 1.0
    low, high = reached, 1.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if enough(middle) else (low, middle)
    return low


def _fitted(points: Floats, weights: Floats) -> Proposal:
    """Return the t proposal with mean and covariance of weighted draws, the latter inflated."""
    mean = weights @ points
    centred = points - mean
    covariance = (centred * weights[:, None]).T @ centred + RIDGE * np.eye(mean.size)
    scale = INFLATION * covariance * (FREEDOM - 2.0) / FREEDOM
    return Proposal(mean, np.asarray(np.linalg.cholesky(scale), dtype=np.float64), FREEDOM)
