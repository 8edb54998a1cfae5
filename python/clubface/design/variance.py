"""What spreads a golfer's shots: shares of the variance, by sampling and by derivatives.

For independent variables these are Sobol indices: the share of the variance due to a variable alone (first order), and
the share that would remain if all others were fixed (total). With correlated variables such shares overlap and do not
add up; each variable then gets its Shapley effect instead (Owen, 2014; Song, Nelson and Staum, 2016): the variance it
adds to the others', averaged over all orders in which variables can be added. These effects sum to 1.

Mishits are left out, since a mishit deviates in all variables at once.

By derivatives, with gradient g and Hessian H at the mean delivery and the covariance C without mishits, a quantity f of
normally distributed deliveries has

    mean = f + tr(H C) / 2,    variance = g' C g + tr(H C H C) / 2,

exactly if it has no higher derivatives, otherwise to second order in the spreads. With probability s a mishit deviates
c times as far, which multiplies the second moments by m2 = 1 - s + s c^2 and the fourth moments by m4 = 1 - s + s c^4:

    mean = f + m2 tr(H C) / 2,    variance = m2 g' C g + m4 tr(H C H C) / 2 + (m4 - m2^2) tr(H C)^2 / 4.

Gradients are exact; second derivatives are central differences of gradients.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.design.dispersion import FLOWN, LAUNCHED, ImpactSetup
from clubface.design.golfer import Golfer, uniform
from clubface.errors import InputError, RangeWarning
from clubface.simulation.flight import SPIN, VELOCITY
from clubface.simulation.results import flight_inputs, flight_outputs
from clubface.simulation.sensitivity import flight_derivatives, sensitivity
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_names, without_warnings

FLIGHT_OUTCOMES = ("carry", "side", "total", "total_side")
"""Flight quantities that are differentiated."""
STEP = 0.1
"""Step of the central differences, in standard deviations."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ByDerivatives:
    """Spread by derivatives, in SI units.

    Attributes
    ----------
    golfer, value
        The golfer, and quantities of the mean delivery by name.
    gradient, second
        First and second derivatives of each with respect to the golfer's variables, shapes (k,) and (k, k).
    """

    golfer: Golfer
    value: Mapping[str, float]
    gradient: Mapping[str, Floats]
    second: Mapping[str, Floats]

    def mean(self, name: str) -> float:
        """Return the mean of a quantity, to second order."""
        check_choice("quantity", name, self.value)
        m2, _ = moments(self.golfer)
        return self.value[name] + 0.5 * m2 * float(np.trace(self.second[name] @ self.golfer.covariance))

    def variance(self, name: str, *, order: int = 2) -> float:
        """Return the variance of a quantity, from the gradient alone (``order`` 1) or with curvature (2)."""
        check_choice("quantity", name, self.value)
        if order not in (1, 2):
            raise InputError("order", order, "1 or 2")
        m2, m4 = moments(self.golfer)
        slope, covariance = self.gradient[name], self.golfer.covariance
        first = m2 * float(slope @ covariance @ slope)
        if order == 1:
            return first
        curved = self.second[name] @ covariance
        return first + 0.5 * m4 * float(np.trace(curved @ curved)) + 0.25 * (m4 - m2**2) * float(np.trace(curved)) ** 2

    def spread(self, name: str, *, order: int = 2) -> float:
        """Return the standard deviation of a quantity."""
        return float(np.sqrt(self.variance(name, order=order)))


def moments(golfer: Golfer) -> tuple[float, float]:
    """Return mean square and mean fourth power, over all shots, of the factor by which mishits widen deviations."""
    share, scale = golfer.mishit_share, golfer.mishit_scale
    return 1.0 - share + share * scale**2, 1.0 - share + share * scale**4


def by_derivatives(golfer: Golfer, setup: ImpactSetup) -> ByDerivatives:
    """Return the derivatives of launch and flight at a golfer's mean delivery.

    The golfer plays with the club's hand. A model without derivatives raises an :class:`InputError`.
    """
    value, gradient = _gradients(golfer.mean, golfer, setup)
    second = {name: np.zeros((len(golfer.mean),) * 2) for name in gradient}
    for place, spread in enumerate(golfer.spread):
        if spread == 0.0:
            continue  # a fixed variable needs no curvature
        step = np.zeros_like(golfer.mean)
        step[place] = STEP * spread
        above, below = (_gradients(golfer.mean + side * step, golfer, setup)[1] for side in (1.0, -1.0))
        for name in gradient:
            second[name][place] = (above[name] - below[name]) / (2.0 * step[place])
    second = {name: 0.5 * (matrix + matrix.T) for name, matrix in second.items()}
    return ByDerivatives(golfer=golfer, value=value, gradient=gradient, second=second)


def _gradients(at: Floats, golfer: Golfer, setup: ImpactSetup) -> tuple[dict[str, float], dict[str, Floats]]:
    """Return quantities at a delivery and their derivatives with respect to the variables."""
    values = dict(zip(golfer.variables, map(float, at), strict=True))
    launched = (*VELOCITY, *SPIN)
    with without_warnings(RangeWarning):  # the shots themselves give the warning
        derivatives = sensitivity(
            setup.club, values, model=setup.model, parameters=setup.parameters,
            ball=getattr(setup.ball, "rigid", setup.ball), accuracy=setup.accuracy,
            outputs=(*LAUNCHED, *launched), variables=golfer.variables,
        )  # fmt: skip
    rows: dict[str, Floats] = dict(zip(derivatives.outputs, derivatives.si, strict=True))
    value = {name: float(getattr(derivatives.launch, name)) for name in LAUNCHED}
    slope = {name: rows[name] for name in LAUNCHED}
    if setup.flight:
        flown = flight_derivatives(derivatives.launch, air=setup.air, wind=setup.wind, ground=setup.ground)
        order = list(flight_outputs())
        columns = [list(flight_inputs()).index(name) for name in launched]
        chain = flown.jacobian[:, columns] @ np.array([rows[name] for name in launched])
        slope |= {name: chain[order.index(name)] for name in FLIGHT_OUTCOMES}
        value |= {name: flown.values[name] for name in FLIGHT_OUTCOMES}
    return value, slope


COUNT = 2**10
"""Default number of shots per set of variables."""
ORDERS = 32
"""Maximum number of orders of the variables; if there are more, half are random and half are their reverses."""
CORRELATED = 1e-9
Places = NDArray[np.intp]
Function = Callable[[Floats], Floats]
"""Maps values of the variables, shape (k, n), to outcomes, shape (outcomes, n)."""
Progress = Callable[[int, int], object]


class Indices(NamedTuple):
    """Shares of the variance.

    Attributes
    ----------
    kind, variables
        "sobol" or "shapley", and the variables that vary.
    share
        By outcome: first-order indices or Shapley effects, shape (k,).
    total
        By outcome: total indices, shape (k,); equal to ``share`` for Shapley effects.
    """

    kind: str
    variables: tuple[str, ...]
    share: Mapping[str, Floats]
    total: Mapping[str, Floats]


def indices(
    golfer: Golfer,
    setup: ImpactSetup,
    outcomes: Sequence[str] = ("carry", "side"),
    *,
    count: int = COUNT,
    seed: int = 0,
    progress: Progress | None = None,
) -> Indices:
    """Return each variable's share of the variance, by sampling.

    Parameters
    ----------
    golfer, setup
        The golfer, for the club's hand; equipment, model and conditions.
    outcomes
        Launch or flight quantities. One that does not vary has shares of NaN.
    count, seed
        Shots per variable or set of variables, a power of two, and seed of the quasi-random numbers.
    progress
        For Shapley effects: called with the number of orders of the variables done and the total.
    """
    if not setup.flight and (flown := [name for name in outcomes if name not in LAUNCHED]):
        raise InputError("outcomes", flown[0], "a launch quantity, since the balls do not fly")
    check_names("outcome", outcomes, (*LAUNCHED, *FLOWN))
    varies = golfer.spread > 0.0
    if not varies.any():
        raise InputError("golfer", golfer.name, "one whose deliveries vary")
    names = tuple(name for name, does in zip(golfer.variables, varies, strict=True) if does)
    means = zip(golfer.variables, golfer.mean, strict=True)
    held = {name: np.asarray(mean) for name, mean in means if name not in names}

    def outcome(values: Floats) -> Floats:
        result = setup({**held, **dict(zip(names, values, strict=True))})
        # A shot without a result counts as the mean of the others, which adds no variance.
        rows = [result[name] for name in outcomes]
        return np.stack([np.where(np.isfinite(row), row, np.nanmean(row)) for row in rows])

    mean, covariance = golfer.mean[varies], golfer.covariance[np.ix_(varies, varies)]
    spread = golfer.spread[varies]
    if np.abs(golfer.correlation[np.ix_(varies, varies)] - np.eye(len(names))).max(initial=0.0) < CORRELATED:
        first, total = sobol(outcome, mean, spread, count=count, seed=seed)
        return Indices("sobol", names, dict(zip(outcomes, first, strict=True)), dict(zip(outcomes, total, strict=True)))
    result = shapley(outcome, mean, covariance, count=count, seed=seed, progress=progress)
    effects = dict(zip(outcomes, result, strict=True))
    return Indices("shapley", names, effects, effects)


def indices_by_derivatives(derivatives: ByDerivatives, outcomes: Sequence[str] = ("carry", "side")) -> Indices:
    """Return the Shapley effects of the quadratic approximation at the mean, in closed form.

    The variables u explain the part C_u = C[:, u] C[u, u]^-1 C[u, :] of a normal distribution's covariance; the
    conditional expectation of the outcome has the variance g' C_u g + tr(H C_u H C_u) / 2.
    """
    golfer = derivatives.golfer
    varies = np.flatnonzero(golfer.spread > 0.0)
    covariance = golfer.covariance[np.ix_(varies, varies)]
    effects = {}
    for name in outcomes:
        slope, second = derivatives.gradient[name][varies], derivatives.second[name][np.ix_(varies, varies)]

        def variance(subset: int, slope: Floats = slope, second: Floats = second) -> Floats:
            inside = _members(subset, len(varies))
            across = covariance[:, inside]
            known = across @ np.linalg.solve(covariance[np.ix_(inside, inside)], across.T)
            curved = second @ known
            return np.array([slope @ known @ slope + 0.5 * np.trace(curved @ curved)])

        effects[name] = _effects_over_all_orders(variance, len(varies))[0]
    names = tuple(golfer.variables[place] for place in varies)
    return Indices("shapley", names, effects, effects)


def sobol(function: Function, mean: Floats, spread: Floats, *, count: int, seed: int) -> tuple[Floats, Floats]:
    """Return first-order and total indices, each of shape (outcomes, k), of independent normal variables.

    Uses ``scipy.stats.sobol_indices`` (Saltelli and others, 2010) with (k + 2) ``count`` evaluations.
    """
    from scipy.stats import norm, sobol_indices

    _check_power(count)
    normal = [norm(loc=at, scale=size) for at, size in zip(mean, spread, strict=True)]
    result = sobol_indices(func=function, n=count, dists=normal, rng=np.random.default_rng(seed))
    # scipy drops the axis of a single variable.
    first, total = (np.reshape(each, (-1, len(mean))) for each in (result.first_order, result.total_order))
    return first, total


def shapley(
    function: Function, mean: Floats, covariance: Floats, *, count: int, seed: int, progress: Progress | None = None
) -> Floats:
    """Return the Shapley effects, shape (outcomes, k), of jointly normal variables.

    The variance of the conditional expectation given some variables is the covariance between the outcomes of two shots
    that share these variables, with the others drawn independently from their conditional distribution.
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

    def variance(subset: int) -> Floats:
        if subset not in known:
            inside = _members(subset, size)
            second = function(mean[:, None] + _redrawn(away, fresh, covariance, inside))
            middle = 0.5 * (base.mean(axis=1) + second.mean(axis=1))
            known[subset] = (base * second).mean(axis=1) - middle**2
        return known[subset]

    if factorial(size) <= ORDERS:
        return _effects(variance, size, list(permutations(range(size))), progress)
    drawn = np.random.default_rng(seed)
    some = [tuple(drawn.permutation(size).tolist()) for _ in range(ORDERS // 2)]
    return _effects(variance, size, [each for order in some for each in (order, order[::-1])], progress)


def _effects(
    variance: Callable[[int], Floats], size: int, orders: Sequence[Sequence[int]], progress: Progress | None
) -> Floats:
    """Return the mean over orders of the variance each variable adds; ``variance`` takes a set of variables as bits."""
    result = []
    for number, order in enumerate(orders, start=1):
        subset, before, added = 0, variance(0), np.empty((size, len(variance(0))))
        for place in order:
            subset |= 1 << place
            after = variance(subset)
            added[place] = after - before
            before = after
        result.append(added.T)
        if progress is not None:
            progress(number, len(orders))
    return np.mean(result, axis=0) / variance(2**size - 1)[:, None]


def _effects_over_all_orders(variance: Callable[[int], Floats], size: int) -> Floats:
    """Return the effects over all orders, from the variance of every set of variables."""
    every = np.array([variance(subset) if subset else np.zeros_like(variance(1)) for subset in range(2**size)])
    members = np.array([subset.bit_count() for subset in range(2**size)])
    weight = np.array([factorial(n) * factorial(size - n - 1) / factorial(size) for n in range(size)])
    result = []
    for place in range(size):
        without = np.flatnonzero(~np.arange(2**size) >> place & 1)
        result.append(weight[members[without]] @ (every[without | 1 << place] - every[without]))
    return np.array(result).T / every[-1][:, None]


def _redrawn(away: Floats, fresh: Floats, covariance: Floats, inside: Places) -> Floats:
    """Return deviations that keep the variables ``inside`` of ``away`` and redraw the others conditionally."""
    outside = np.setdiff1d(np.arange(len(away)), inside)
    result = away.copy()
    across = covariance[np.ix_(outside, inside)] @ np.linalg.inv(covariance[np.ix_(inside, inside)])
    left = covariance[np.ix_(outside, outside)] - across @ covariance[np.ix_(inside, outside)]
    result[outside] = across @ away[inside] + np.linalg.cholesky(left) @ fresh[outside]
    return result


def _members(subset: int, size: int) -> Places:
    return np.array([place for place in range(size) if subset >> place & 1], dtype=np.intp)


def _check_power(count: int) -> None:
    if not isinstance(count, int) or count < 2 or count & (count - 1):
        raise InputError("count", count, "a power of two, such as 1024")
