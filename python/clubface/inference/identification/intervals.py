"""Uncertainty of identified parameters: standard errors, profile likelihoods, resampling and Fisher information.

**Standard errors** of the minimum of a cost, for intervals without a bootstrap. Fisher's information gives the standard
errors of the most likely parameters. The minimum of another cost scatters more. The minimum of the mean absolute error
scatters by a quarter more if deviations are normally distributed, and by more still if the weights are not those of the
noise, as in the cost of Caldwell and McPhee (2023). The covariance is A^-1 B A^-1, with A the mean curvature of the
cost and B the variance of its gradient: P. J. Huber, The behavior of maximum likelihood estimates under nonstandard
conditions, Proc. 5th Berkeley Symp. 1 (1967) 221-233.

**Profile likelihoods**: the best fit with one parameter held fixed and all others refitted.

A. Raue et al., Structural and practical identifiability analysis of partially observed dynamical models by exploiting
the profile likelihood, Bioinformatics 25 (2009) 1923-1929.

**Hold-out and bootstrap**: the cost on shots not used in the fit, and the scatter of the parameters.

**Identifiability**: Fisher's information from exact derivatives, and its weak directions.

Launches are assumed to be normally distributed about those of the model, with one standard deviation per quantity. A
direction of the unit cube along which no launch changes by more than these cannot be identified.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.inference.identification.search import Linear, refine
from clubface.inference.identification.simulator import Cost, Simulator, cost_of
from clubface.support.arrays import Floats

CHI_SQUARE_95 = 3.841458820694124
"""95% quantile of chi-square with one degree of freedom."""
STEPS = (0.7, 1.4, 2.1, 2.8, 4.0, 6.0, 9.0, 13.0, 20.0)
"""Points of a profile on each side, in standard errors."""
WIDEST = 0.15
"""Step size for a parameter that the data do not determine, as a fraction of its range."""
NEAR_PROFILE = 1e-2
"""A fit ends when minus twice the log-likelihood would fall by less than this."""


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile likelihood of one parameter.

    Attributes
    ----------
    name
        Name of the parameter.
    values
        Values at which the parameter was held [SI], increasing, shape (places,).
    rise
        Minus twice the log-likelihood above its minimum, shape (places,).
    interval
        The 95% interval: smallest and largest value at which the rise is below 3.84 [SI].
    closed
        For each end, whether the rise reaches 3.84 inside the bounds. Otherwise this end of the interval is a bound,
        and the shots do not determine the parameter on that side.
    """

    name: str
    values: Floats
    rise: Floats
    interval: tuple[float, float]
    closed: tuple[bool, bool]

    @property
    def verdict(self) -> str:
        """Whether the shots determine the parameter: "yes", "from below only", "from above only" or "no"."""
        if all(self.closed):
            return "yes"
        if any(self.closed):
            return "from below only" if self.closed[0] else "from above only"
        return "no"


def outside(value: float, interval: tuple[float, float], profile: Profile | None) -> bool:
    """Return whether the value [SI] of a parameter lies outside its interval or its profile interval."""
    spans = [interval] if profile is None else [interval, profile.interval]
    # Up to rounding: the end of an interval may be the value itself, converted to the unit cube and back.
    return any(not low - abs(low) * 1e-9 <= value <= high + abs(high) * 1e-9 for low, high in spans)


class Profiler:
    """Computes profile likelihoods of the parameters of a fit to all shots.

    ``noise`` is the standard deviation of each quantity [SI]; ``errors`` are those of the coordinates of the unit cube.
    """

    def __init__(self, simulator: Simulator, noise: Floats, errors: Floats) -> None:
        shots = simulator.shots
        given = dict(zip(shots.quantities, noise.tolist(), strict=True))
        self.simulator = simulator
        self.cost = cost_of("least-squares", shots.launches, shots.quantities, noise=given)
        self.values_measured = int(np.isfinite(shots.launches).sum())
        self.errors = np.where(np.isfinite(errors), np.minimum(errors, WIDEST), WIDEST)

    def profile(self, place: int, optimum: Floats) -> Profile:
        """Return the profile of the free parameter with index ``place``, starting from the maximum likelihood point."""
        centre = float(optimum[place])
        least = self.cost.value(self.simulator.launch(optimum))
        sides = [self._side(place, sign, optimum, least) for sign in (-1.0, 1.0)]
        table = [*reversed(sides[0]), (centre, least), *sides[1]]
        where = np.array([each[0] for each in table])
        costs = np.array([each[1] for each in table])
        rise = self.values_measured * (costs - costs.min())
        low, low_closed = _crossing(where, rise, -1)
        high, high_closed = _crossing(where, rise, 1)
        full = np.repeat(optimum[None, :], len(where), axis=0)
        full[:, place] = where
        ends = np.repeat(optimum[None, :], 2, axis=0)
        ends[:, place] = (low, high)
        free = self.simulator.free
        interval = free.values(ends)[:, place]
        return Profile(
            free.names[place], free.values(full)[:, place], rise, (float(interval[0]), float(interval[1])),
            (low_closed, high_closed),
        )  # fmt: skip

    def _side(self, place: int, sign: float, optimum: Floats, least: float) -> list[tuple[float, float]]:
        """Return values and costs from the optimum outwards, until the rise is clear or a bound is reached."""
        held = np.arange(len(optimum)) == place
        point = optimum
        steps: list[tuple[float, float]] = []
        for step in STEPS:
            where = optimum[place] + sign * step * self.errors[place]
            end = not 0.0 < where < 1.0
            point = point.copy()
            point[place] = min(max(where, 0.0), 1.0)
            refined = refine(self.simulator, self.cost, point, held=held, fall=NEAR_PROFILE / self.values_measured)
            point = refined.point
            steps.append((float(point[place]), refined.cost))
            if end or self.values_measured * (refined.cost - least) > 1.5 * CHI_SQUARE_95:
                break
        return steps


def _crossing(where: Floats, rise: Floats, side: int) -> tuple[float, bool]:
    """Return where the rise last crosses 3.84 on one side, and whether it does.

    The last crossing counts: a profile may rise above 3.84 and fall below it again further out.
    """
    likely = np.flatnonzero(rise <= CHI_SQUARE_95)
    place = int(likely[0 if side < 0 else -1])
    if not 0 <= place + side < len(rise):
        return float(where[place]), False
    # Interpolate the square root of the rise: exact for normal deviations and a linear model.
    inner, outer = np.sqrt(rise[place]), np.sqrt(rise[place + side])
    part = (np.sqrt(CHI_SQUARE_95) - inner) / (outer - inner)
    return float(where[place] + part * (where[place + side] - where[place])), True


FOLDS = 5
BOOTSTRAP = 200
REACH = 6.0
"""Largest first step of a refit, in standard errors."""
NEAR_OPTIMUM = 2e-3
"""A refit ends when the predicted relative fall of the cost, times the number of values, is below this; 1 corresponds
to one standard error."""
UNKNOWN_SHARE = 0.05
"""Standard error assumed if the data do not determine a parameter, as a fraction of its range."""


class Refits:
    """Fits to subsets of the shots, each started at the optimum for all shots, a point of the unit cube.

    ``errors`` are the standard errors of its coordinates, infinite for those that the shots do not determine.
    """

    def __init__(self, simulator: Simulator, cost: Cost, optimum: Floats, errors: Floats) -> None:
        self.simulator = simulator
        self.cost = cost
        self.optimum = optimum
        self.errors = np.where(np.isfinite(errors), np.minimum(errors, UNKNOWN_SHARE), UNKNOWN_SHARE)
        self.values = int(np.isfinite(simulator.shots.launches).sum())
        self._linear = Linear(*simulator.derivatives(optimum))

    def to(self, counts: NDArray[np.int64]) -> Floats:
        """Return the fit to shots weighted by ``counts``, shape (shots,)."""
        used = np.flatnonzero(counts)
        first = Linear(self._linear.simulated[:, used], self._linear.derivatives[:, :, used])
        part = self.simulator.of(self.simulator.shots.select(used))
        cost = self.cost.select(used, counts[used])
        return refine(
            part, cost, self.optimum, radius=REACH * self.errors, first=first, fall=NEAR_OPTIMUM / self.values
        ).point


def interval_of(samples: Floats, confidence: float, groups: int) -> Floats:
    """Return the intervals of parameters bootstrapped from ``groups`` groups, shape (2, free).

    The ends are percentiles, widened by the ratio of Student's t to the normal distribution, because plain percentiles
    are too narrow for few groups: T. C. Hesterberg, What teachers should know about the bootstrap, The American
    Statistician 69 (2015) 371-386. The k-th of B sorted samples estimates the quantile (k - 1/3) / (B + 1/3)
    (median-unbiased: R. J. Hyndman and Y. Fan, Sample quantiles in statistical packages, The American Statistician 50
    (1996) 361-365); numpy's default rule cuts off the tails of small samples.
    """
    from scipy.special import ndtr, stdtrit

    degrees = max(groups - samples.shape[1], 1)
    part = float(ndtr(np.sqrt(groups / degrees) * stdtrit(degrees, 0.5 * (1.0 + confidence))))
    return np.quantile(samples, [1.0 - part, part], axis=0, method="median_unbiased")


def held_out(refits: Refits, folds: int, seed: int, once: Callable[[str, Callable[[], Any]], Any]) -> Floats:
    """Return the launches of all shots, shape (quantities, shots), each predicted by a fit to the other folds.

    Groups of shots are assigned to folds at random. ``once`` returns a part by name and computes it only if it is not
    stored.
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
    """Return fits to resampled groups, shape (samples, free): B. Efron, Annals of Statistics 7 (1979)."""
    groups = refits.simulator.shots.groups
    count = int(groups.max()) + 1
    fits = []
    for sample in range(samples):
        drawn = np.random.default_rng((seed, count, 0, sample)).integers(0, count, count)
        counts = np.bincount(drawn, minlength=count)[groups]
        fits.append(once(f"bootstrap {sample}", lambda counts=counts: refits.to(counts).tolist()))
    return np.array(fits)


NORMAL_95 = 1.959963984540054
NULL = 1e-9
"""A singular value below this fraction of the largest counts as zero; derivatives are exact to about 1e-12."""
UNKNOWN = 0.5
"""Half-width of a 95% interval, as a fraction of the range, above which the data add nothing to the bounds."""
WEAK = 0.05
"""Half-width above which a direction is called weak."""
SHOWN, SHOWN_WITHOUT_INFORMATION = 0.25, 0.02
"""Parameters with at least this fraction of the largest share are named in a direction."""


@dataclass(frozen=True, eq=False)
class Direction:
    """A direction in the unit cube of the parameters.

    Attributes
    ----------
    vector
        Unit vector, shape (free,).
    error
        Standard error along the direction, as a fraction of the range of the parameters; infinite if no launch changes
        along it.
    words
        The parameters that change along the direction, and how well it is known, in words.
    """

    vector: Floats
    error: float
    words: str

    @property
    def strength(self) -> str:
        """How well the direction is determined: ``"none"``, ``"unknown"``, ``"weak"`` or ``"known"``."""
        width = NORMAL_95 * self.error
        if not np.isfinite(width):
            return "none"
        return "unknown" if width > UNKNOWN else "weak" if width > WEAK else "known"


@dataclass(frozen=True, eq=False)
class Identifiability:
    """The Fisher information about the parameters at one point.

    Attributes
    ----------
    names
        The free parameters.
    noise
        Standard deviation assumed for each quantity [SI].
    directions
        Eigenvectors of the information, weakest first.
    errors
        Standard errors of the coordinates of the unit cube, shape (free,); infinite for parameters that the shots do
        not determine.
    correlations
        Correlations of the parameters, shape (free, free); NaN where an error is infinite.
    """

    names: tuple[str, ...]
    noise: Floats
    directions: tuple[Direction, ...]
    errors: Floats
    correlations: Floats

    @property
    def unknown(self) -> tuple[str, ...]:
        """The parameters for which the shots add nothing to the bounds."""
        return tuple(
            name for name, error in zip(self.names, self.errors, strict=True) if not NORMAL_95 * error <= UNKNOWN
        )


def identifiability(simulator: Simulator, point: Floats, noise: Floats) -> Identifiability:
    """Return the Fisher information of the shots near ``point``; ``noise`` [SI] has one value per quantity."""
    _, derivatives = simulator.derivatives(point)
    there = np.isfinite(simulator.shots.launches)
    rows = np.moveaxis(derivatives / noise[:, None, None], 1, 2)[there]
    free = rows.shape[1]
    padded = np.vstack([rows, np.zeros((max(0, free - len(rows)), free))])
    _, values, vectors = np.linalg.svd(padded, full_matrices=False)
    null = values <= NULL * max(values[0], 1e-300)
    inverse = np.where(null, 0.0, 1.0 / np.where(null, 1.0, values))
    errors = np.sqrt(np.sum((vectors * inverse[:, None]) ** 2, axis=0))
    # A parameter with a component along a direction without information is itself undetermined.
    touched = np.any(np.abs(vectors[null]) > 1e-6, axis=0) if null.any() else np.zeros(free, dtype=bool)
    errors = np.where(touched, np.inf, errors)
    covariance = (vectors.T * inverse**2) @ vectors
    with np.errstate(invalid="ignore", divide="ignore"):
        correlations = covariance / np.outer(errors, errors)
    correlations[~np.isfinite(correlations) | np.isinf(np.outer(errors, errors))] = np.nan
    names = simulator.free.names
    directions = []
    for vector, value, is_null in zip(vectors[::-1], values[::-1], null[::-1], strict=True):
        error = np.inf if is_null else 1.0 / float(value)
        directions.append(_direction(names, vector, error))
    return Identifiability(names, noise, tuple(directions), errors, correlations)


def scatter(deviations: Floats, noise: Floats) -> Floats:
    """Return the standard deviation to assume for each quantity [SI]: the scatter of its deviations, or its noise.

    The larger of the two is used, because the error of the model may exceed the noise. ``deviations`` has shape
    (quantities, shots), with NaN where nothing was measured. The scatter is 1.4826 times the median magnitude, which is
    the standard deviation of a normal distribution.
    """
    with np.errstate(invalid="ignore"):
        return np.maximum(noise, 1.4826 * np.nanmedian(np.abs(deviations), axis=1))


def _direction(names: tuple[str, ...], vector: Floats, error: float) -> Direction:
    """Describe a direction by its parameters, the strongest first and counted as increasing."""
    order = np.argsort(-np.abs(vector), kind="stable")
    vector = vector * (np.sign(vector[order[0]]) or 1.0)
    least = SHOWN if np.isfinite(error) else SHOWN_WITHOUT_INFORMATION
    main = [place for place in order if abs(vector[place]) >= least * abs(vector[order[0]])]
    moved = [f"{names[place]} {'up' if vector[place] > 0 else 'down'}" for place in main]
    what = moved[0] if len(moved) == 1 else f"{', '.join(moved[:-1])} and {moved[-1]} together"
    if len(moved) > 1:
        shares = " : ".join(f"{abs(vector[place]) / abs(vector[main[0]]):.2g}" for place in main)
        what += f" ({shares} of their ranges)"
    open_words = {
        "none": "no launch changes at all",
        "unknown": "launches change by less than their scatter over the whole range",
    }
    direction = Direction(vector, error, what)
    known = f"known to {100.0 * NORMAL_95 * error:.2g}% of the range (95%)"
    return replace(direction, words=f"{what}: {open_words.get(direction.strength, known)}")


def errors_of_minimum(simulator: Simulator, cost: Cost, point: Floats, information: Identifiability) -> Floats:
    """Return the standard errors of the coordinates of the minimum ``point`` of a cost, shape (free,).

    Deviations are assumed to be independent and normally distributed, with the standard deviations of ``information``.
    Errors that are infinite in ``information`` stay infinite.
    """
    _, derivatives = simulator.derivatives(point)
    curvatures, variances = _moments(cost, information.noise)
    # In units of standard errors along the directions that change launches, both matrices are of order 1.
    known = [each.vector * each.error for each in information.directions if np.isfinite(each.error)]
    if not known:
        return np.full(len(point), np.inf)
    rows = np.einsum("qfs,df->qds", derivatives, known)
    bread = np.einsum("qds,qes,qs->de", rows, rows, cost.weights * curvatures[:, None])
    meat = np.einsum("qds,qes,qs->de", rows, rows, cost.weights**2 * variances[:, None])
    inverse = np.linalg.inv(bread)
    spread = inverse @ known
    covariance = spread.T @ meat @ spread
    return np.where(np.isfinite(information.errors), np.sqrt(np.diag(covariance)), np.inf)


def _moments(cost: Cost, noise: Floats) -> tuple[Floats, Floats]:
    """Return, per quantity, the mean curvature of the loss and the variance of its slope for normal deviations."""
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
