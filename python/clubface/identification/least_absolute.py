"""Least absolute deviations of a linear model in a box, exactly: an active-set method.

After R. H. Bartels, A. R. Conn and J. W. Sinclair, Minimization techniques for piecewise differentiable functions: the
l1 solution to an overdetermined linear system, SIAM Journal on Numerical Analysis 15 (1978) 224-241. At the minimum as
many deviations vanish, or coordinates lie on a bound, as there are coordinates. A step leaves one of these constraints
and follows the edge past kinks until the cost rises again; a general linear program takes three to five times as long.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface.support.arrays import Floats

STEPS_PER_COORDINATE = 60
"""Steps after which the point reached is returned; a few per coordinate are usual."""
ROUNDING = 1e-10
TIE, GOLDEN = 1e-9, 0.6180339887498949
"""Size of what is added to deviations to tell equal ones apart, and its ratio from one to the next."""


class _Active(NamedTuple):
    """A constraint that holds: a deviation that vanishes, or a coordinate on a bound (``side`` -1 or +1)."""

    place: int
    side: int

    def normal(self, rows: Floats) -> Floats:
        return np.eye(rows.shape[1])[self.place] if self.side else rows[self.place]


def least_absolute(deviations: Floats, rows: Floats, lower: Floats, upper: Floats) -> Floats:
    """Return the step in the box that minimises the sum of |deviations + rows step|.

    Parameters
    ----------
    deviations
        Shape (n,).
    rows
        Shape (n, free).
    lower, upper
        The box, which holds 0; shape (free,).
    """
    size = np.mean(np.abs(deviations)) if len(deviations) else 0.0
    scales = np.sqrt(np.mean(rows**2, axis=0)) if len(deviations) else np.zeros(len(lower))
    if not (size > 0.0 and np.all(np.isfinite(scales))):
        return np.zeros(len(lower))
    # Deviations of size 1, and steps that change them by about 1, so that rounding means the same for all.
    scales = np.where(scales > 0.0, scales, 1.0) / size
    matrix, deviations = rows / (scales * size), deviations / size
    # Equal shots would vanish together, more constraints than coordinates, and the method turn in circles among them.
    deviations = deviations + TIE * (np.arange(len(deviations)) * GOLDEN % 1.0 - 0.5)
    low, high = lower * scales, upper * scales
    # A deviation that keeps its sign in the whole box adds a constant slope and need not be looked at again.
    sure = np.abs(deviations) > np.abs(matrix) @ np.maximum(high, -low)
    slope = np.sign(deviations[sure]) @ matrix[sure]
    step = _descend(deviations[~sure], matrix[~sure], low, high, slope)
    return np.clip(step / scales, lower, upper)


def _descend(deviations: Floats, rows: Floats, low: Floats, high: Floats, slope: Floats) -> Floats:
    free = len(low)
    point, active = np.zeros(free), [_Active(place, 1) for place in range(free) if high[place] <= low[place]]
    for _ in range(STEPS_PER_COORDINATE * free):
        left = deviations + rows @ point
        left[[each.place for each in active if not each.side]] = 0.0
        gradient = slope + np.sign(left) @ rows
        direction = _direction(gradient, active, rows)
        if direction is None:
            break
        direction[[each.place for each in active if each.side]] = 0.0
        changes = rows @ direction
        changes[[each.place for each in active if not each.side]] = 0.0
        length, reached = _edge(left, changes, float(gradient @ direction), point, direction, low, high)
        point = np.clip(point + length * direction, low, high)
        if reached is None:
            break
        active.append(reached)
    return point


def _direction(gradient: Floats, active: list[_Active], rows: Floats) -> Floats | None:
    """Return a direction of descent, with the constraint it leaves taken out of ``active``; None at the minimum."""
    scale = float(np.max(np.abs(gradient))) + 1.0
    if not active:
        return -gradient if np.max(np.abs(gradient)) > ROUNDING * scale else None
    normals = np.array([each.normal(rows) for each in active])
    inverse = np.linalg.pinv(normals)
    multipliers = -gradient @ inverse
    along = -(gradient + multipliers @ normals)
    if len(active) < len(gradient) and np.max(np.abs(along)) > ROUNDING * scale:
        return along
    # The multiplier of a deviation lies between -1 and 1 at the minimum; of a bound it points out of the box.
    excess = [
        abs(value) - 1.0 if not each.side else -value * each.side
        for each, value in zip(active, multipliers, strict=True)
    ]
    worst = int(np.argmax(excess))
    if excess[worst] <= ROUNDING * scale:
        return None
    leaving = active.pop(worst)
    sign = np.sign(multipliers[worst]) if not leaving.side else -leaving.side
    return np.asarray(inverse[:, worst] * sign, dtype=np.float64)


def _edge(
    left: Floats, changes: Floats, slope: float, point: Floats, direction: Floats, low: Floats, high: Floats
) -> tuple[float, _Active | None]:
    """Return how far the cost falls along a direction, and the constraint met there."""
    with np.errstate(divide="ignore", invalid="ignore"):
        kinks = -left / changes
        walls = np.where(direction > 0.0, (high - point) / direction, (low - point) / direction)
    walls = np.where(direction == 0.0, np.inf, np.maximum(walls, 0.0))
    wall = int(np.argmin(walls))
    ahead = np.flatnonzero((left != 0.0) & (changes != 0.0) & (kinks >= 0.0) & (kinks <= walls[wall]))
    # A deviation that vanishes without being a constraint turns positive at once, whichever way it goes.
    slope += float(np.sum(np.abs(changes[left == 0.0])))
    order = ahead[np.argsort(kinks[ahead], kind="stable")]
    slopes = slope + 2.0 * np.cumsum(np.abs(changes[order]))
    turn = int(np.searchsorted(slopes, 0.0))
    if slope >= 0.0:
        return 0.0, None
    if turn < len(order):
        return float(kinks[order[turn]]), _Active(int(order[turn]), 0)
    if not np.isfinite(walls[wall]):
        return 0.0, None
    return float(walls[wall]), _Active(wall, 1 if direction[wall] > 0.0 else -1)
