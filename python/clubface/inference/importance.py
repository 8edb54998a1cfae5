"""Importance sampling of the posterior of one shot, in coordinates that bend with it.

**Tempered, adaptive importance sampling.**

Draws from a first proposal are weighted by the ratio of posterior to proposal. If enough of them are effective, they
are the sample. Otherwise the ratio is raised to the largest power that keeps enough draws effective, and the mean and
covariance of the weighted draws define the next proposal, a multivariate t distribution with heavier tails. Once the
power is one, draws are collected until enough are effective. All draws of the last proposal are independent, so that
their effective number is known, unlike that of a Markov chain. Tempering follows Neal (2001), adaptation follows Cappé
et al. (2004).

**Coordinates that bend with the posterior.**

The origin is its most probable point, and the posterior is nearly standard normal in them.

Few numbers are measured, but far more precisely than the prior knows them. The posterior is therefore a thin curved
sheet in the many dimensions of a delivery: thin in the directions determined by the measurement, broad in the others. A
normal distribution fits it badly, but curved coordinates fit well: those along the sheet are drawn first, and the
others are measured from the nearest point of the sheet in units of its thickness there. Two steps of Broyden's method
find both. Whatever they find, the density of the draws is known exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.support.arrays import Floats

FEWEST_A_STAGE, MOST_A_STAGE = 1500, 4000
"""Minimum and maximum number of draws per stage; in between, four times the sample size."""
TARGET = 0.25
"""Fraction of a stage's draws that must be effective; it limits the power of the likelihood."""
FREEDOM = 7.0
"""Degrees of freedom of the t proposals."""
INFLATION = 1.15
"""Factor of the covariance of the t proposals over that of the weighted draws."""
MOST_STAGES = 60
REFINEMENTS = 3
"""Number of proposals at power one."""
LEAST_GAIN, STALLED, MOST_WHEN_STALLED = 0.01, 8, 16_000
"""A stage that raises the power by less than ``LEAST_GAIN`` is followed by one with twice as many draws, up to
``MOST_WHEN_STALLED``. After ``STALLED`` such stages the power is left: the distribution reached is wider than the
posterior, so that its proposal is usable."""
MOST_DRAWS, MOST_DRAWS_A_POINT = 400_000, 100
"""Maximum number of draws for a sample, in total and per point wanted; the sample may then be too small."""
HOPELESS_DRAWS, HOPELESS = 40_000, 5.0
"""After this number of draws, sampling stops if no more than this number of them are effective."""
RIDGE = 1e-9
"""Added to the variances, so that a proposal exists even for a sample without spread in some direction."""


class Sample(NamedTuple):
    """Draws from a posterior, equally weighted.

    Attributes
    ----------
    points
        The draws, shape (draws, dimensions).
    effective
        Effective number of the weighted draws before resampling.
    draws
        Number of weighted draws from the last proposal.
    evaluations, stages
        Total numbers of densities computed and of proposals.
    log_evidence
        Logarithm of the integral of the density.
    largest_weight
        Largest share of the total weight on a single draw. If it is near 1, the sample consists of copies of one draw.
    """

    points: Floats
    effective: float
    draws: int
    evaluations: int
    stages: int
    log_evidence: float
    largest_weight: float


class Proposal(NamedTuple):
    """A multivariate t distribution, or a normal distribution if ``freedom`` is infinite.

    ``root`` is the lower Cholesky factor of its scale matrix.
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
    """Return the standard normal distribution."""
    return Proposal(np.zeros(dimensions), np.eye(dimensions), math.inf)


def standard_t(dimensions: int) -> Proposal:
    """Return the t distribution about the origin with the identity as scale matrix."""
    return Proposal(np.zeros(dimensions), np.eye(dimensions), FREEDOM)


def sample(
    log_density: Callable[[Floats], Floats],
    first: Proposal,
    *,
    size: int,
    seed: int,
    progress: Callable[[float], object] | None = None,
) -> Sample:
    """Sample a posterior: ``size`` points, resampled from twice as many effective draws.

    ``log_density`` returns the log-density, up to a constant, at points of shape (n, dimensions), NaN or minus infinity
    for impossible ones. The ``first`` proposal is the prior or an approximation of the posterior; FloatingPointError is
    raised if none of its draws is possible. ``progress`` is called before each stage with the power reached, 0 to 1.
    """
    random, count = np.random.default_rng(seed), _stage_size(size)
    proposal = chosen = first
    power, stages, refined, evaluations, best, stalled = 0.0, 0, 0, 0, 0.0, 0
    while stages < MOST_STAGES and refined < REFINEMENTS and stalled < STALLED:
        if progress is not None:
            progress(power)
        points = proposal.draw(random, count)
        density, own = log_density(points), proposal.log_density(points)
        stages, evaluations = stages + 1, evaluations + count
        start = own if proposal is first else first.log_density(points)
        possible = np.isfinite(density)
        if not possible.any():
            raise FloatingPointError("no draw is possible")
        # Impossible points have weight 0 at any power; 0 times minus infinity would be NaN.
        ratio, base = np.where(possible, density - start, 0.0), np.where(possible, start - own, -np.inf)
        before, power = power, _power(base, ratio, power)
        if power - before < LEAST_GAIN and power < 1.0:
            stalled, count = stalled + 1, min(2 * count, MOST_WHEN_STALLED)
        weights = normalised(base + power * ratio)
        if power == 1.0:
            if proposal is first:
                logs = base + ratio
                return _collect_draws(
                    log_density, first, random, size, stages, evaluations - count, points, logs, count, MOST_DRAWS
                )
            refined += 1
            if effective(weights) > best:
                best, chosen = effective(weights), proposal
        proposal = _fit_proposal(points, weights)
    last = proposal if refined < REFINEMENTS else chosen
    none, count = (np.empty((0, first.mean.size)), np.empty(0)), max(MOST_A_STAGE, size)
    return _collect_draws(log_density, last, random, size, stages, evaluations, *none, count, MOST_DRAWS)


def attempt(log_density: Callable[[Floats], Floats], proposal: Proposal, *, size: int, seed: int) -> Sample:
    """Sample a posterior from one proposal if it is good enough; otherwise return the small sample of one stage.

    Arguments as for :func:`sample`.
    """
    random, count = np.random.default_rng(seed), _stage_size(size)
    points = proposal.draw(random, count)
    logs = log_density(points) - proposal.log_density(points)
    logs = np.where(np.isfinite(logs), logs, -np.inf)
    if not np.isfinite(logs).any():
        raise FloatingPointError("no draw is possible")
    good = effective(normalised(logs)) >= TARGET * count
    return _collect_draws(log_density, proposal, random, size, 1, 0, points, logs, count, MOST_DRAWS if good else count)


def _stage_size(size: int) -> int:
    return min(max(4 * size, FEWEST_A_STAGE), MOST_A_STAGE)


def _collect_draws(
    log_density: Callable[[Floats], Floats],
    proposal: Proposal,
    random: np.random.Generator,
    size: int,
    stages: int,
    evaluations: int,
    all_points: Floats,
    all_logs: Floats,
    count: int,
    most: int,
) -> Sample:
    """Draw from the last proposal until enough draws, given ones included, are effective; resample them."""
    most = min(most, max(MOST_DRAWS_A_POINT * size, HOPELESS_DRAWS))
    while True:
        reached = effective(normalised(all_logs)) if all_logs.size else 0.0
        if reached >= 2 * size or all_logs.size >= (HOPELESS_DRAWS if reached <= HOPELESS else most):
            break
        points = proposal.draw(random, count)
        density = log_density(points)
        logs = np.where(np.isfinite(density), density - proposal.log_density(points), -np.inf)
        all_points, all_logs = np.concatenate([all_points, points]), np.concatenate([all_logs, logs])
    weights, top = normalised(all_logs), float(all_logs.max())
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
    """Return weights that sum to 1 from their logarithms."""
    weights = np.exp(logs - logs.max())
    return weights / weights.sum()


def effective(weights: Floats) -> float:
    """Return the effective number of draws with normalised ``weights`` (Kish)."""
    return float(1.0 / np.sum(weights**2))


def systematic(weights: Floats, size: int, random: np.random.Generator) -> NDArray[np.int64]:
    """Return the indices of ``size`` draws chosen by weight (systematic resampling), in random order."""
    ticks = (random.random() + np.arange(size)) / size
    places = np.minimum(np.searchsorted(np.cumsum(weights), ticks), weights.size - 1)
    return random.permutation(places)


def _power(base: Floats, ratio: Floats, reached: float) -> float:
    """Return the largest power, from ``reached`` to 1, at which enough draws are effective."""

    def enough(power: float) -> bool:
        return effective(normalised(base + power * ratio)) >= TARGET * base.size

    if enough(1.0):
        return 1.0
    low, high = reached, 1.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if enough(middle) else (low, middle)
    return low


def _fit_proposal(points: Floats, weights: Floats) -> Proposal:
    """Return the t proposal with the mean and the inflated covariance of weighted draws."""
    mean = weights @ points
    centred = points - mean
    covariance = (centred * weights[:, None]).T @ centred + RIDGE * np.eye(mean.size)
    scale = INFLATION * covariance * (FREEDOM - 2.0) / FREEDOM
    return Proposal(mean, np.asarray(np.linalg.cholesky(scale), dtype=np.float64), FREEDOM)


MOST_STEPS, HALVINGS = 50, 12
ENOUGH = 1e-3
"""The search ends when minus twice the log-posterior falls by less than this."""
SHARP = 3.0
"""Singular value of the slopes above which the measurement rather than the prior determines a direction."""
Residuals = Callable[[Floats], Floats]
"""Function of points (n, d): computed minus measured values in standard deviations (n, m); NaN if impossible."""
Slopes = Callable[[Floats], tuple[Floats, Floats]]
"""Function of one point (d,): the residuals (m,) and their derivatives (m, d)."""


class Peak(NamedTuple):
    """The most probable point of a posterior, in standard deviations of the prior.

    ``slopes`` are the derivatives of the residuals there, shape (m, d). The ``misfit``, the sum of squares of point and
    residuals, is chi-squared distributed with m degrees of freedom if the launch is linear and the prior is true.
    """

    point: Floats
    slopes: Floats
    misfit: float


def peak(residuals: Residuals, slopes: Slopes, start: Floats) -> Peak | None:
    """Return the most probable point near ``start`` by the Gauss-Newton method, or None if it does not converge."""
    point, dimensions = start, start.size
    misfit = _misfit(residuals, point)
    if not np.isfinite(misfit):
        return None
    for _ in range(MOST_STEPS):
        off, table = slopes(point)
        if not (np.isfinite(table).all() and np.isfinite(off).all()):
            return None
        step = -np.linalg.solve(np.eye(dimensions) + table.T @ table, point + table.T @ off)
        for halving in range(HALVINGS):
            following = point + 0.5**halving * step
            reached = _misfit(residuals, following)
            if reached < misfit:
                break
        else:
            return Peak(point, table, misfit)
        point, gained, misfit = following, misfit - reached, reached
        if gained < ENOUGH:
            _, table = slopes(point)
            return Peak(point, table, misfit) if np.isfinite(table).all() else None
    return None


def _misfit(residuals: Residuals, point: Floats) -> float:
    misfit = float(point @ point + np.sum(residuals(point[None, :]) ** 2))
    return misfit if np.isfinite(misfit) else np.inf


class Sheet:
    """Curved coordinates in which a posterior is about standard normal, ``at`` its most probable point."""

    def __init__(self, at: Peak, residuals: Residuals) -> None:
        _, values, rows = np.linalg.svd(at.slopes, full_matrices=True)
        strength = np.zeros(len(at.point))
        strength[: len(values)] = values
        sharp = strength > SHARP
        self._residuals = residuals
        self._along, self._across = rows[~sharp], rows[sharp]
        self._wide = 1.0 / np.hypot(1.0, strength[~sharp])
        self._centre_along, self._centre_across = self._along @ at.point, self._across @ at.point
        self._slopes = at.slopes @ self._across.T
        self._gain = np.linalg.inv(np.eye(len(self._across)) + self._slopes.T @ self._slopes)

    def points(self, coordinates: Floats) -> tuple[Floats, Floats]:
        """Return points in standard deviations of the prior, shape (n, d), and the log-determinant of the mapping.

        The determinant is the volume per unit volume of the coordinates.
        """
        along, across = np.split(coordinates, [len(self._along)], axis=1)
        base = (self._centre_along + self._wide * along) @ self._along
        sibling, root = self._next_places(base)
        sibling = sibling + _solve_transposed(root, across.T).T
        volume = np.log(self._wide).sum() - sum(np.log(root[place][place]) for place in range(len(root)))
        return base + sibling @ self._across, np.broadcast_to(volume, len(coordinates))

    def _next_places(self, base: Floats) -> tuple[Floats, list[list[Floats]]]:
        """Return the points of the sheet nearest to ``base``, shape (n, sharp), and the factor of the curvature there.

        The curvature is that of minus the log-posterior, its lower Cholesky factor given by rows. Where the start of a
        step is impossible, the sheet at the peak is used.
        """
        start = np.tile(self._centre_across, (len(base), 1))
        off = self._residuals(base + start @ self._across)
        step = -_possible((start + off @ self._slopes) @ self._gain)
        after = self._residuals(base + (start + step) @ self._across)
        # Broyden's update of the slopes to match the step, S + missed step', and of the curvature, I + S' S.
        length = np.sum(step**2, axis=1)
        missed = _possible(after - off - step @ self._slopes.T) / np.where(length > 0.0, length, 1.0)[:, None]
        bent, along, square = (missed @ self._slopes).T, step.T, np.sum(missed**2, axis=1)
        straight = np.eye(len(along)) + self._slopes.T @ self._slopes
        columns = [
            [
                straight[i, j] + bent[i] * along[j] + along[i] * bent[j] + square * along[i] * along[j]
                for j in range(i + 1)
            ]
            for i in range(len(along))
        ]
        root = _cholesky(columns)
        downhill = (start + step + after @ self._slopes).T + along * np.sum(missed * after, axis=1)
        last = -_possible(_solve_transposed(root, _solve(root, downhill)).T)
        return start + step + last, root


def _possible(values: Floats) -> Floats:
    """Return rows, with zeros in place of rows that are not finite."""
    return np.where(np.isfinite(values).all(axis=1, keepdims=True), values, 0.0)


def _cholesky(matrix: list[list[Floats]]) -> list[list[Floats]]:
    """Return the lower Cholesky factors of many small matrices at once; LAPACK would take them one by one."""
    root: list[list[Floats]] = [[] for _ in matrix]
    for i, row in enumerate(root):
        for j in range(i):
            row.append((matrix[i][j] - sum(row[k] * root[j][k] for k in range(j))) / root[j][j])
        row.append(np.sqrt(matrix[i][i] - sum(each**2 for each in row)))
    return root


def _solve(root: list[list[Floats]], right: Floats) -> Floats:
    """Return x with root x = right, shape (k, n)."""
    solution: list[Floats] = []
    for i, row in enumerate(root):
        solution.append((right[i] - sum(row[k] * solution[k] for k in range(i))) / row[i])
    return np.array(solution)


def _solve_transposed(root: list[list[Floats]], right: Floats) -> Floats:
    """Return x with root' x = right, shape (k, n)."""
    solution = np.empty_like(right)
    for i in reversed(range(len(root))):
        later = sum(root[k][i] * solution[k] for k in range(i + 1, len(root)))
        solution[i] = (right[i] - later) / root[i][i]
    return solution


MOST_CENTRES = 4
"""Maximum number of centres tried without adaptation, before the proposals are adapted."""


def drawn(
    residuals: Residuals,
    slopes: Slopes,
    dimensions: int,
    *,
    size: int,
    seed: int,
    progress: Callable[[float], object] | None,
) -> tuple[Sample, float]:
    """Sample a posterior with a standard normal prior; return the sample and the misfit of the peak.

    The peak may lie in a corner away from the bulk of the posterior; the coordinates are then centred in the bulk.
    Without a peak, the draws start from the prior, and the misfit is NaN. Other arguments are as for :func:`sample`.
    """
    before, after = standard_normal(dimensions), standard_t(dimensions)

    def density(points: Floats) -> Floats:
        return before.log_density(points) - 0.5 * np.sum(residuals(points) ** 2, axis=1)

    def bent(sheet: Sheet) -> Callable[[Floats], Floats]:
        def of(coordinates: Floats) -> Floats:
            points, log_volume = sheet.points(coordinates)
            return density(points) + log_volume

        return of

    top = peak(residuals, slopes, np.zeros(dimensions))
    if top is None:
        return sample(density, before, size=size, seed=seed, progress=progress), math.nan
    centre: Peak | None = top
    tried: list[tuple[Sample, Sheet]] = []
    while centre is not None and len(tried) < MOST_CENTRES:
        sheet = Sheet(centre, residuals)
        draws = attempt(bent(sheet), after, size=size, seed=seed)
        draws = draws._replace(points=sheet.points(draws.points)[0])
        if draws.effective >= 2 * size:
            return draws, top.misfit
        tried.append((draws, sheet))
        centre = _bulk(draws, slopes)
    sheet = max(tried, key=lambda each: each[0].effective)[1]
    draws = sample(bent(sheet), after, size=size, seed=seed, progress=progress)
    return draws._replace(points=sheet.points(draws.points)[0]), top.misfit


def _bulk(draws: Sample, slopes: Slopes) -> Peak | None:
    """Return the mean of a sample as the centre of coordinates, or None if it cannot be computed there."""
    middle = draws.points.mean(axis=0)
    off, table = slopes(middle)
    possible = np.isfinite(off).all() and np.isfinite(table).all()
    return Peak(middle, table, math.nan) if possible else None
