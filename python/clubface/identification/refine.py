"""From a point near an optimum to the optimum: steps on linearised launches within a trust region."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.identification.cost import Cost
from clubface.identification.linear_step import best_step, linear_cost
from clubface.identification.simulator import Simulator
from clubface.support.arrays import Floats

FIRST_RADIUS = 0.1
"""How far the first step may go, in parts of the range of each parameter."""
SMALLEST_STEP = 1e-10
"""A step that moves no parameter by more than this part of its range ends the refinement."""
SMALLEST_FALL = 1e-12
"""So does a fall of the cost by less than this part of it, where nothing else is said."""
LAST = 50.0
"""A step that promises less than this times the fall that matters is the last: the next one would be far smaller."""
MOST_STEPS = 100

EXPLAINED = 1e-3
"""Mean square of deviation over noise below which the deviations may be those of the integration."""

POOR, GOOD = 0.25, 0.75
"""Shares of the promised fall of the cost below which the region shrinks and above which it grows."""


class Refined(NamedTuple):
    """Where a refinement ended.

    Attributes
    ----------
    point
        In the unit cube, shape (free,).
    cost
        There.
    steps
        Linearisations made.
    """

    point: Floats
    cost: float
    steps: int


class Linear(NamedTuple):
    """Launches at a point, shape (quantities, shots), and their derivatives, shape (quantities, free, shots)."""

    simulated: Floats
    derivatives: Floats


def refine(
    simulator: Simulator,
    cost: Cost,
    start: Floats,
    *,
    radius: Floats | float = FIRST_RADIUS,
    first: Linear | None = None,
    held: NDArray[np.bool_] | None = None,
    fall: float = SMALLEST_FALL,
) -> Refined:
    """Minimise the cost from ``start``, within the bounds, by exact derivatives.

    Parameters
    ----------
    simulator, cost
        Of the same shots.
    start
        A point of the unit cube, shape (free,).
    radius
        How far the first step may go, in all coordinates or in each.
    first
        The launches at ``start`` and their derivatives, where they are known.
    held
        Coordinates that do not move, shape (free,).
    fall
        Part of the cost below which a further fall does not matter.

    Returns
    -------
    Refined
        Never worse than ``start``.
    """
    found = _descend(simulator, cost, start, radius, first, held, fall)
    if cost.loss == "absolute" or not found.cost < EXPLAINED:
        return found
    # Where a contact takes one integration step more, its launch jumps by about 1e-4: an outlier to a linear model,
    # which least absolute deviations pass over. They lead on where squares are stuck at jumps.
    other = _descend(simulator, cost.absolute(), found.point, radius, None, held, fall)
    value = cost.value(simulator.launch(other.point))
    return Refined(other.point, value, found.steps + other.steps) if value < found.cost else found


def _descend(
    simulator: Simulator,
    cost: Cost,
    start: Floats,
    radius: Floats | float,
    first: Linear | None,
    held: NDArray[np.bool_] | None,
    fall: float,
) -> Refined:
    point = np.array(start)
    here = first or Linear(*simulator.derivatives(point))
    value = cost.value(here.simulated)
    steps, reach = 0, np.broadcast_to(radius, point.shape)
    if not np.isfinite(value):
        return Refined(point, value, steps)
    while steps < MOST_STEPS:
        lower, upper = np.maximum(-reach, -point), np.minimum(reach, 1.0 - point)
        if held is not None:
            lower, upper = np.where(held, 0.0, lower), np.where(held, 0.0, upper)
        step = _within(here, cost, lower, upper, held)
        promised = value - linear_cost(cost, here.simulated, here.derivatives, step)
        if promised <= fall * value or np.max(np.abs(step)) <= SMALLEST_STEP:
            break
        trial = np.clip(point + step, 0.0, 1.0)
        found = cost.value(simulator.launch(trial))
        share = (value - found) / promised
        part = float(np.max(np.abs(step) / reach))
        if share < POOR:
            reach = 0.25 * part * reach
        elif share > GOOD and part >= 0.9:
            reach = np.minimum(2.5 * reach, 1.0)
        if found < value:
            point, value = trial, found
            steps += 1
            if promised <= LAST * fall * value:
                break
            here = Linear(*simulator.derivatives(point))
    return Refined(point, value, steps)


def _within(here: Linear, cost: Cost, lower: Floats, upper: Floats, held: NDArray[np.bool_] | None) -> Floats:
    """Return the best step in a box of which some sides may have no width."""
    moving = upper > lower if held is None else (upper > lower) & ~held
    step = np.zeros(len(lower))
    if moving.any():
        step[moving] = best_step(cost, here.simulated, here.derivatives[:, moving], lower[moving], upper[moving])
    return step
