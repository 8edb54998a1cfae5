"""Which part of the variance of an outcome comes from which part of the delivery.

Where the variables are independent these are Sobol's indices: the share of the variance that goes with a variable alone
(first order), and the share that would be left if all others were held (total). Where variables are correlated such
shares overlap, and do not add up. Then each variable has its Shapley effect instead (Owen, 2014; Song, Nelson and
Staum, 2016): the variance it adds to what others tell already, averaged over all orders in which they can be told.
These effects add up to 1.

All are of shots that are no mishits: a mishit is further off in all variables at once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import permutations
from math import factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.design.dispersion.derivatives import ByDerivatives
from clubface.design.dispersion.hitting import Hitting
from clubface.design.dispersion.tally import FLOWN, LAUNCHED
from clubface.design.golfer.golfer import Golfer
from clubface.design.golfer.quasi_random import uniform
from clubface.errors import InputError
from clubface.support.arrays import Floats
from clubface.support.checks import check_names

COUNT = 2**10
"""Shots for each set of variables, unless told otherwise."""
ORDERS = 32
"""Orders in which variables are told, half of them the others reversed; all orders where they are as few."""
CORRELATED = 1e-9
Places = NDArray[np.intp]
Function = Callable[[Floats], Floats]
"""Outcomes, shape (outcomes, n), of values of the variables, shape (k, n)."""
Progress = Callable[[int, int], object]


class Indices(NamedTuple):
    """Shares of the variance.

    Attributes
    ----------
    kind
        "sobol" or "shapley".
    variables
        The variables, those that do not vary left out.
    share
        By outcome: first-order indices or Shapley effects, shape (k,).
    total
        By outcome: total indices, shape (k,); for Shapley effects the same as ``share``.
    """

    kind: str
    variables: tuple[str, ...]
    share: Mapping[str, Floats]
    total: Mapping[str, Floats]


def indices(
    of: Golfer,
    hit: Hitting,
    outcomes: Sequence[str] = ("carry", "side"),
    *,
    count: int = COUNT,
    seed: int = 0,
    progress: Progress | None = None,
) -> Indices:
    """Return the shares of the variables by sampling.

    Parameters
    ----------
    of
        The golfer, of the club's hand.
    hit
        How shots are hit.
    outcomes
        Quantities of launch or flight. One that does not vary has shares of NaN.
    count
        Shots for each variable or set of variables, a power of two.
    seed
        Of the quasi-random numbers.
    progress
        For Shapley effects: called with the number of orders of the variables done and that of all.
    """
    if not hit.flight and (flown := [name for name in outcomes if name not in LAUNCHED]):
        raise InputError("outcomes", flown[0], "of a launch, where the balls do not fly")
    check_names("outcome", outcomes, (*LAUNCHED, *FLOWN))
    varies = of.spread > 0.0
    if not varies.any():
        raise InputError("golfer", of.name, "one whose deliveries vary: nothing spreads the shots")
    names = tuple(name for name, does in zip(of.variables, varies, strict=True) if does)
    held = {name: np.asarray(mean) for name, mean in zip(of.variables, of.mean, strict=True) if name not in names}

    def outcome(values: Floats) -> Floats:
        found = hit({**held, **dict(zip(names, values, strict=True))})
        # A shot without a result tells nothing: it counts as the mean of the others.
        rows = [found[name] for name in outcomes]
        return np.stack([np.where(np.isfinite(row), row, np.nanmean(row)) for row in rows])

    mean, covariance = of.mean[varies], of.covariance[np.ix_(varies, varies)]
    spread = of.spread[varies]
    if np.abs(of.correlation[np.ix_(varies, varies)] - np.eye(len(names))).max(initial=0.0) < CORRELATED:
        first, total = sobol(outcome, mean, spread, count=count, seed=seed)
        return Indices("sobol", names, dict(zip(outcomes, first, strict=True)), dict(zip(outcomes, total, strict=True)))
    found = shapley(outcome, mean, covariance, count=count, seed=seed, progress=progress)
    effects = dict(zip(outcomes, found, strict=True))
    return Indices("shapley", names, effects, effects)


def indices_by_derivatives(of: ByDerivatives, outcomes: Sequence[str] = ("carry", "side")) -> Indices:
    """Return the Shapley effects of the outcome that gradient and curvature at the mean describe, in closed form.

    What the variables u tell of a normal distribution has the covariance C_u = C[:, u] C[u, u]^-1 C[u, :], and the
    expectation of the outcome given them the variance g' C_u g + tr(H C_u H C_u) / 2.
    """
    golfer = of.golfer
    varies = np.flatnonzero(golfer.spread > 0.0)
    covariance = golfer.covariance[np.ix_(varies, varies)]
    effects = {}
    for name in outcomes:
        slope, second = of.gradient[name][varies], of.second[name][np.ix_(varies, varies)]

        def variance(told: int, slope: Floats = slope, second: Floats = second) -> Floats:
            known = _told(covariance, _members(told, len(varies)))
            curved = second @ known
            return np.array([slope @ known @ slope + 0.5 * np.trace(curved @ curved)])

        effects[name] = _effects_of_all(variance, len(varies))[0]
    names = tuple(golfer.variables[place] for place in varies)
    return Indices("shapley", names, effects, effects)


def sobol(function: Function, mean: Floats, spread: Floats, *, count: int, seed: int) -> tuple[Floats, Floats]:
    """Return first-order and total indices, each of shape (outcomes, k), of independent, normal variables.

    They are those of ``scipy.stats.sobol_indices`` (Saltelli and others, 2010), from (k + 2) ``count`` evaluations.
    """
    from scipy.stats import norm, sobol_indices

    _check_power(count)
    normal = [norm(loc=at, scale=size) for at, size in zip(mean, spread, strict=True)]
    found = sobol_indices(func=function, n=count, dists=normal, rng=np.random.default_rng(seed))
    # scipy drops an axis of one variable.
    first, total = (np.reshape(each, (-1, len(mean))) for each in (found.first_order, found.total_order))
    return first, total


def shapley(
    function: Function, mean: Floats, covariance: Floats, *, count: int, seed: int, progress: Progress | None = None
) -> Floats:
    """Return the Shapley effects, shape (outcomes, k), of jointly normally distributed variables.

    The variance of the expectation given some variables is the covariance of the outcome with that of a second shot,
    which shares them and has the others drawn anew as they go with those.
    """
    from scipy.special import ndtri

    _check_power(count)
    size = len(mean)
    standard = ndtri(uniform(2 * size, count, seed=seed)).T
    root = np.linalg.cholesky(covariance)
    away, fresh = root @ standard[:size], standard[size:]
    base = function(mean[:, None] + away)
    total = base.var(axis=1)
    known: dict[int, Floats] = {0: np.zeros(len(base)), 2**size - 1: total}

    def variance(told: int) -> Floats:
        if told not in known:
            inside = _members(told, size)
            second = function(mean[:, None] + _redrawn(away, fresh, covariance, inside))
            middle = 0.5 * (base.mean(axis=1) + second.mean(axis=1))
            known[told] = (base * second).mean(axis=1) - middle**2
        return known[told]

    if factorial(size) <= ORDERS:
        return _effects(variance, size, list(permutations(range(size))), progress)
    drawn = np.random.default_rng(seed)
    some = [tuple(drawn.permutation(size).tolist()) for _ in range(ORDERS // 2)]
    return _effects(variance, size, [each for order in some for each in (order, order[::-1])], progress)


def _effects(
    variance: Callable[[int], Floats], size: int, orders: Sequence[Sequence[int]], progress: Progress | None
) -> Floats:
    """Return the effects as the mean over orders of what each variable adds; ``variance`` takes a set as bits."""
    found = []
    for number, order in enumerate(orders, start=1):
        told, before, added = 0, variance(0), np.empty((size, len(variance(0))))
        for place in order:
            told |= 1 << place
            after = variance(told)
            added[place] = after - before
            before = after
        found.append(added.T)
        if progress is not None:
            progress(number, len(orders))
    return np.mean(found, axis=0) / variance(2**size - 1)[:, None]


def _effects_of_all(variance: Callable[[int], Floats], size: int) -> Floats:
    """Return the effects over all orders, from the variance of every set of variables."""
    every = np.array([variance(told) if told else np.zeros_like(variance(1)) for told in range(2**size)])
    members = np.array([told.bit_count() for told in range(2**size)])
    weight = np.array([factorial(n) * factorial(size - n - 1) / factorial(size) for n in range(size)])
    found = []
    for place in range(size):
        without = np.flatnonzero(~np.arange(2**size) >> place & 1)
        found.append(weight[members[without]] @ (every[without | 1 << place] - every[without]))
    return np.array(found).T / every[-1][:, None]


def _redrawn(away: Floats, fresh: Floats, covariance: Floats, inside: Places) -> Floats:
    """Return deviations that share the variables ``inside`` with ``away`` and are drawn anew in the others."""
    outside = np.setdiff1d(np.arange(len(away)), inside)
    found = away.copy()
    across = covariance[np.ix_(outside, inside)] @ np.linalg.inv(covariance[np.ix_(inside, inside)])
    left = covariance[np.ix_(outside, outside)] - across @ covariance[np.ix_(inside, outside)]
    found[outside] = across @ away[inside] + np.linalg.cholesky(left) @ fresh[outside]
    return found


def _told(covariance: Floats, inside: Places) -> Floats:
    """Return the covariance of what the variables ``inside`` tell of all."""
    across = covariance[:, inside]
    return across @ np.linalg.solve(covariance[np.ix_(inside, inside)], across.T)


def _members(told: int, size: int) -> Places:
    return np.array([place for place in range(size) if told >> place & 1], dtype=np.intp)


def _check_power(count: int) -> None:
    if not isinstance(count, int) or count < 2 or count & (count - 1):
        raise InputError("count", count, "a power of two, such as 1024")
