"""The search of an identification: a global search, then a local one with linearised launches.

**Global search**: a genetic algorithm over the unit cube that evaluates a whole generation in one batch.

**Local search**: from a point near an optimum, steps with linearised launches within a trust region.

**Step**: least absolute deviations or bounded least squares of the linearised launches in a box.

The mean absolute error in the cost of Caldwell and McPhee (2023) has no gradient where a deviation vanishes, and at its
minimum as many deviations vanish as there are parameters. A gradient method gets stuck there. The launches themselves
are smooth. They are therefore linearised, and the cost of the linearised launches, with its kinks and the bounds, is
minimised exactly.

**Least absolute deviations** of a linear model in a box are minimised exactly, by an active-set method.

After R. H. Bartels, A. R. Conn and J. W. Sinclair, Minimization techniques for piecewise differentiable functions: the
l1 solution to an overdetermined linear system, SIAM Journal on Numerical Analysis 15 (1978) 224-241. At the minimum as
many deviations vanish, or coordinates lie on a bound, as there are coordinates. A step leaves one of these constraints
and follows the edge past kinks until the cost rises again; a general linear program takes three to five times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.inference.identification.simulator import Cost, Simulator
from clubface.support.arrays import Floats

POPULATION, GENERATIONS, REFINED = 200, 100, 5
"""Settings of Caldwell and McPhee (2023), section 2.3."""


class Population(NamedTuple):
    """The survivors of each generation, starting with the random one.

    The ``points`` of the unit cube have shape (population, free), their ``costs`` shape (population,).
    """

    generation: int
    points: Floats
    costs: Floats

    def best(self, count: int) -> Floats:
        """Return the ``count`` best points, best first, shape (count, free)."""
        return self.points[np.argsort(self.costs, kind="stable")[:count]]


def search(
    costs_of: Callable[[Floats], Floats],
    free: int,
    *,
    population: int = POPULATION,
    generations: int = GENERATIONS,
    seed: int = 1,
    begun: Population | None = None,
    after_generation: Callable[[Population], object] | None = None,
) -> Population:
    """Search the unit cube with pymoo's genetic algorithm: tournament, simulated binary crossover, polynomial mutation.

    ``costs_of`` maps points, shape (n, free), to costs, shape (n,). The random numbers of a generation depend only on
    ``seed`` and its number, so that a search resumed from the population ``begun`` continues as if it had never
    stopped. The random first generation counts among the ``generations``; ``after_generation`` is called with the
    survivors of each.
    """
    from pymoo.algorithms.soo.nonconvex.ga import GA, FitnessSurvival
    from pymoo.core.population import Population as Individuals
    from pymoo.core.problem import Problem

    cube = Problem(n_var=free, n_obj=1, xl=0.0, xu=1.0)
    algorithm = GA(pop_size=population)
    individuals = None if begun is None else Individuals.new(X=begun.points, F=begun.costs[:, None])
    survivors = begun
    for generation in range(begun.generation if begun else 0, generations):
        generator = np.random.default_rng((seed, generation))
        if individuals is None:
            individuals = algorithm.initialization.do(cube, population, random_state=generator)
            individuals.set("F", costs_of(_array(individuals, "X"))[:, None])
        else:
            children = algorithm.mating.do(cube, individuals, population, random_state=generator)
            if not len(children):  # every child is a copy of a parent: the population has collapsed
                break
            children.set("F", costs_of(_array(children, "X"))[:, None])
            together = Individuals.merge(individuals, children)
            individuals = FitnessSurvival().do(cube, together, n_survive=population)
        survivors = Population(generation + 1, _array(individuals, "X"), _array(individuals, "F")[:, 0])
        if after_generation is not None:
            after_generation(survivors)
    assert survivors is not None
    return survivors


def _array(individuals: Any, name: str) -> Floats:
    return np.asarray(individuals.get(name), dtype=np.float64)


STEPS_PER_COORDINATE = 60
"""Largest number of steps; a few per coordinate are usual."""
ROUNDING = 1e-10
TIE, GOLDEN = 1e-9, 0.6180339887498949
"""Perturbation added to deviations to break ties, and the ratio from one to the next."""


class _Active(NamedTuple):
    """An active constraint: a deviation of zero, or a coordinate at a bound (``side`` -1 or +1)."""

    place: int
    side: int

    def normal(self, rows: Floats) -> Floats:
        return np.eye(rows.shape[1])[self.place] if self.side else rows[self.place]


def least_absolute(deviations: Floats, rows: Floats, lower: Floats, upper: Floats) -> Floats:
    """Return the step in the box that minimises the sum of |deviations + rows step|, shapes (n,) and (n, free).

    The box from ``lower`` to ``upper``, shape (free,), holds 0.
    """
    size = np.mean(np.abs(deviations)) if len(deviations) else 0.0
    scales = np.sqrt(np.mean(rows**2, axis=0)) if len(deviations) else np.zeros(len(lower))
    if not (size > 0.0 and np.all(np.isfinite(scales))):
        return np.zeros(len(lower))
    # Scale deviations to size 1 and steps to change them by about 1, so that rounding affects all alike.
    scales = np.where(scales > 0.0, scales, 1.0) / size
    matrix, deviations = rows / (scales * size), deviations / size
    # Deviations of equal shots would vanish together, give more constraints than coordinates and make the method cycle.
    deviations = deviations + TIE * (np.arange(len(deviations)) * GOLDEN % 1.0 - 0.5)
    low, high = lower * scales, upper * scales
    # A deviation that keeps its sign in the whole box only adds a constant slope.
    sure = np.abs(deviations) > np.abs(matrix) @ np.maximum(high, -low)
    slope = np.sign(deviations[sure]) @ matrix[sure]
    step = _descend_deviations(deviations[~sure], matrix[~sure], low, high, slope)
    return np.clip(step / scales, lower, upper)


def _descend_deviations(deviations: Floats, rows: Floats, low: Floats, high: Floats, slope: Floats) -> Floats:
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
    """Return a descent direction, removing the constraint that it leaves from ``active``; None at the minimum."""
    scale = float(np.max(np.abs(gradient))) + 1.0
    if not active:
        return -gradient if np.max(np.abs(gradient)) > ROUNDING * scale else None
    normals = np.array([each.normal(rows) for each in active])
    inverse = np.linalg.pinv(normals)
    multipliers = -gradient @ inverse
    along = -(gradient + multipliers @ normals)
    if len(active) < len(gradient) and np.max(np.abs(along)) > ROUNDING * scale:
        return along
    # At the minimum the multiplier of a deviation lies between -1 and 1; that of a bound points out of the box.
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
    """Return the step to the minimum of the cost along a direction, and the constraint met there."""
    with np.errstate(divide="ignore", invalid="ignore"):
        kinks = -left / changes
        walls = np.where(direction > 0.0, (high - point) / direction, (low - point) / direction)
    walls = np.where(direction == 0.0, np.inf, np.maximum(walls, 0.0))
    wall = int(np.argmin(walls))
    ahead = np.flatnonzero((left != 0.0) & (changes != 0.0) & (kinks >= 0.0) & (kinks <= walls[wall]))
    # The magnitude of a deviation that vanishes without being a constraint grows in either direction.
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


HUBER_ROUNDS = 8
"""Number of reweightings in a step of the robust cost; the next linearisation continues from there."""


def best_step(cost: Cost, simulated: Floats, derivatives: Floats, lower: Floats, upper: Floats) -> Floats:
    """Return the step, shape (free,), that minimises the cost of linearised launches in a box around 0.

    ``simulated`` are the launches at the start of the step, shape (quantities, shots), ``derivatives`` their
    derivatives, shape (quantities, free, shots).
    """
    used = cost.weights > 0.0
    deviations = (simulated - cost.measured)[used]
    rows = np.moveaxis(derivatives, 1, 2)[used]
    weights = cost.weights[used]
    if cost.loss == "absolute":
        return least_absolute(deviations * weights, rows * weights[:, None], lower, upper)
    if cost.loss == "squares":
        roots = np.sqrt(weights)
        return _least_squares(deviations * roots, rows * roots[:, None], lower, upper)
    knees = np.broadcast_to(cost.knees[:, None], cost.weights.shape)[used]
    step = np.zeros(len(lower))
    for _ in range(HUBER_ROUNDS):
        # Huber's loss has the gradient of least squares with these weights.
        sizes = np.maximum(np.abs(deviations + rows @ step), knees)
        roots = np.sqrt(weights * knees / sizes)
        following = _least_squares(deviations * roots, rows * roots[:, None], lower, upper)
        moved = np.max(np.abs(following - step))
        step = following
        if moved <= 1e-3 * np.max(np.abs(step)):
            break
    return step


def linear_cost(cost: Cost, simulated: Floats, derivatives: Floats, step: Floats) -> float:
    """Return the cost after a step for linearised launches."""
    return cost.value(simulated + np.einsum("qfs,f->qs", derivatives, step))


def _least_squares(deviations: Floats, rows: Floats, lower: Floats, upper: Floats) -> Floats:
    """Minimise the sum of squares of deviations + rows step within the box."""
    from scipy.optimize import lsq_linear

    scales = np.sqrt(np.sum(rows**2, axis=0))
    scales = np.where(scales > 0.0, scales, 1.0)
    orthogonal, triangle = np.linalg.qr(rows / scales)
    solution = lsq_linear(
        triangle, -(orthogonal.T @ deviations), bounds=(lower * scales, upper * scales), method="bvls"
    )
    return np.clip(solution.x / scales, lower, upper)


FIRST_RADIUS = 0.1
"""Largest first step, as a fraction of each parameter's range."""
SMALLEST_STEP = 1e-10
"""The refinement ends when no parameter moves by more than this fraction of its range."""
SMALLEST_FALL = 1e-12
"""Default relative fall of the cost below which the refinement ends."""
LAST = 50.0
"""The refinement ends when the predicted fall is below this multiple of the tolerance; the next one is far smaller."""
MOST_STEPS = 100

EXPLAINED = 1e-3
"""Mean square of deviation over noise below which integration errors may dominate."""

POOR, GOOD = 0.25, 0.75
"""Ratios of actual to predicted fall below which the trust region shrinks and above which it grows."""


class Refined(NamedTuple):
    """The end point of a refinement in the unit cube, shape (free,), its cost, and the number of linearisations."""

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
    """Minimise the cost from ``start``, a point of the unit cube, with exact derivatives; never returns a worse point.

    ``radius`` is the maximum first step, for all coordinates or for each; ``first`` are the launches at the start with
    their derivatives, if known. Coordinates that are ``held``, shape (free,), do not move. The refinement ends when the
    cost would fall by less than the fraction ``fall``.
    """
    refined = _descend(simulator, cost, start, radius, first, held, fall)
    if cost.loss == "absolute" or not refined.cost < EXPLAINED:
        return refined
    # Where a contact takes one more integration step, its launch jumps by about 1e-4: an outlier to a linear model.
    # Least absolute deviations are insensitive to it and go on where least squares are stuck at such jumps.
    other = _descend(simulator, cost.absolute(), refined.point, radius, None, held, fall)
    value = cost.value(simulator.launch(other.point))
    return Refined(other.point, value, refined.steps + other.steps) if value < refined.cost else refined


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
        reached = cost.value(simulator.launch(trial))
        share = (value - reached) / promised
        part = float(np.max(np.abs(step) / reach))
        if share < POOR:
            reach = 0.25 * part * reach
        elif share > GOOD and part >= 0.9:
            reach = np.minimum(2.5 * reach, 1.0)
        if reached < value:
            point, value = trial, reached
            steps += 1
            if promised <= LAST * fall * value:
                break
            here = Linear(*simulator.derivatives(point))
    return Refined(point, value, steps)


def _within(here: Linear, cost: Cost, lower: Floats, upper: Floats, held: NDArray[np.bool_] | None) -> Floats:
    """Return the best step in a box, some of whose sides may have zero width."""
    moving = upper > lower if held is None else (upper > lower) & ~held
    step = np.zeros(len(lower))
    if moving.any():
        step[moving] = best_step(cost, here.simulated, here.derivatives[:, moving], lower[moving], upper[moving])
    return step
