"""Optimisation problems and their limits, solved by sequential quadratic programming (Kraft, 1988) from many starts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, Envelope, of_club, pseudo_inertia, pseudo_inertia_derivatives
from clubface.design.optimisation.landings import Landings, Objective
from clubface.design.optimisation.variables import Variables
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Wording
from clubface.support.arrays import Floats

REMEMBERED = 4
"""Number of points cached: an optimiser asks for objective, limits and gradients one after another."""


@dataclass(frozen=True)
class State:
    """Club and objectives at a point of the optimiser."""

    club: Mapping[str, float]  # its variable fields [SI]
    slopes: Mapping[str, Floats]  # derivatives of the fields with respect to the variables, each of shape (variables,)
    judged: Mapping[str, float]  # the objectives in use, averaged over the golfers
    gradients: Mapping[str, Floats]  # derivatives of the objectives; empty unless requested


@dataclass(frozen=True, kw_only=True)
class RangeLimit:
    """A range [SI] for a club field or an objective; an end without a limit is infinite."""

    name: str  # in reports
    limited: str  # the field or objective
    least: float
    most: float
    unit: str
    size: float | None = None  # by which margins are divided [SI]; default the size of the limit

    def margins(self, state: State) -> Floats:
        """Return the scaled distance from each limit."""
        value = {**state.club, **state.judged}[self.limited]
        return np.array([side * (value - limit) / size for side, limit, size in self._sides()])

    def gradients(self, state: State) -> Floats:
        """Return the derivatives of the margins."""
        slope = {**state.slopes, **state.gradients}[self.limited]
        return np.array([side * slope / size for side, _, size in self._sides()])

    def describe(self, state: State) -> tuple[str, str]:
        """Return a club's value and the allowed values, in words."""
        allowed = " to ".join(units.show(limit, self.unit, 4) for _, limit, _ in self._sides())
        if len(self._sides()) == 1:
            allowed = f"{'at least' if math.isfinite(self.least) else 'at most'} {allowed}"
        return units.show({**state.club, **state.judged}[self.limited], self.unit, 5), allowed

    def _sides(self) -> list[tuple[float, float, float]]:
        return [
            (side, limit, self.size or max(abs(limit), 1e-9))
            for side, limit in ((1.0, self.least), (-1.0, self.most)) if math.isfinite(limit)
        ]  # fmt: skip


class Buildable:
    """Feasibility of the head: the discretionary mass must fit into the volume and into its budget.

    Mass properties that are not among ``fields`` are those of ``base``. If the mass is ``distributed``, the variables
    ensure positive semidefinite moments. If the mass does not change, the budget is left out, because a margin that is
    always 0 would upset the solver.
    """

    name = "the head"

    def __init__(
        self, base: Club, envelope: Envelope, fields: tuple[str, ...], *, distributed: bool, mass_changes: bool
    ) -> None:
        self.envelope, self._values, self._distributed = envelope, of_club(base), distributed
        self._mass_changes = mass_changes
        self._changing = [name for name in fields if name in MASS_PROPERTIES]
        self._forms = np.array([each.matrix for each in envelope.volume.forms()])

    def values(self, state: State) -> Floats:
        """Return the mass properties of a head, in the order of ``MASS_PROPERTIES``."""
        result = self._values.copy()
        for name in self._changing:
            result[MASS_PROPERTIES.index(name)] = state.club[name]
        return result

    def margins(self, state: State) -> Floats:
        """Return the traces, the rest of the budget and, unless they cannot be negative, the principal moments."""
        placed = self.envelope.placed(pseudo_inertia(self.values(state)))
        result = [np.einsum("fij,ij->f", self._forms, placed) / self.envelope.budget]
        if self._mass_changes:
            result.append(np.array([1.0 - placed[3, 3] / self.envelope.budget]))
        if not self._distributed:
            scale = np.outer(self.envelope.scale, self.envelope.scale)
            result.append(np.linalg.eigvalsh(placed * scale))
        return np.concatenate(result)

    def describe(self, state: State) -> tuple[str, str]:
        """Return that the head cannot be built, and why, in words."""
        margins = self.envelope.margins(pseudo_inertia(self.values(state)))
        return "impossible", f"one that can be built: {min(margins, key=lambda each: each.value).reason}"

    def gradients(self, state: State) -> Floats:
        """Return the derivatives of the margins; those of eigenvalues follow Magnus (1985)."""
        values, budget = self.values(state), self.envelope.budget
        by_name: dict[str, Floats] = dict(zip(MASS_PROPERTIES, pseudo_inertia_derivatives(values), strict=True))
        by_numbers = sum(by_name[name][..., None] * state.slopes[name] for name in self._changing)
        assert isinstance(by_numbers, np.ndarray)  # at least one mass property changes
        result = [np.einsum("fij,ijn->fn", self._forms, by_numbers) / budget]
        if self._mass_changes:
            result.append(-by_numbers[3, 3][None] / budget)
        if not self._distributed:
            scale = self.envelope.scale
            placed = self.envelope.placed(pseudo_inertia(values)) * np.outer(scale, scale)
            vectors = np.linalg.eigh(placed)[1] * scale[:, None]
            result.append(np.einsum("ik,ijn,jk->kn", vectors, by_numbers, vectors))
        return np.concatenate(result)


Limit = RangeLimit | Buildable
"""One or more margins, scaled to about 1, that must not be negative."""


class Problem:
    """An objective to optimise over variables, subject to limits; ``others`` are objectives used by limits or reported.

    ``golfers`` holds shots and weight of each golfer; weights need not sum to 1.
    """

    def __init__(
        self,
        variables: Variables,
        golfers: Sequence[tuple[Landings, float]],
        objective: Objective,
        limits: Sequence[Limit],
        others: Sequence[Objective] = (),
    ) -> None:
        self.variables, self.golfers, self.objective, self.limits = variables, tuple(golfers), objective, tuple(limits)
        self.judges = {each.name: each for each in (objective, *others)}
        total = sum(weight for _, weight in golfers)
        self._weights = [weight / total for _, weight in golfers]
        self._values: dict[bytes, State] = {}
        self._slopes: dict[bytes, State] = {}

    @property
    def shots(self) -> int:
        """Number of shots of all golfers, without those that miss the face."""
        return sum(landings.count for landings, _ in self.golfers)

    def values(self, point: Floats) -> State:
        """Return the state at a point, without derivatives of the landings."""
        key = np.ascontiguousarray(point).tobytes()
        if key in self._slopes:
            return self._slopes[key]
        if key not in self._values:
            club = self.variables.club(point)
            landed = [each.of(club) for each, _ in self.golfers]
            judged = {name: self._mean([each.judge(one)[0] for one in landed]) for name, each in self.judges.items()}
            _keep(self._values, key, State(club, self._by_field(self.variables.slopes(point)), judged, {}))
        return self._values[key]

    def differentiated(self, point: Floats) -> State:
        """Return the state at a point, with derivatives."""
        key = np.ascontiguousarray(point).tobytes()
        if key not in self._slopes:
            club, slopes = self.variables.club(point), self.variables.slopes(point)
            result = [each.differentiated(club, self.variables.fields) for each, _ in self.golfers]
            judged, gradients = {}, {}
            for name, each in self.judges.items():
                values = [each.judge(landed) for landed, _ in result]
                judged[name] = self._mean([value for value, _ in values])
                each_by_fields = [by.gradient(weights) for (_, weights), (_, by) in zip(values, result, strict=True)]
                gradients[name] = self._mean(each_by_fields) @ slopes
            _keep(self._slopes, key, State(club, self._by_field(slopes), judged, gradients))
        return self._slopes[key]

    def _by_field(self, slopes: Floats) -> dict[str, Floats]:
        return dict(zip(self.variables.fields, slopes, strict=True))

    def _mean(self, of_golfers: Sequence[Any]) -> Any:
        return sum(weight * each for weight, each in zip(self._weights, of_golfers, strict=True))

    def cost(self, point: Floats) -> float:
        """Return the objective with the sign for minimisation."""
        return self.objective.sign * self.values(point).judged[self.objective.name]

    def slope(self, point: Floats) -> Floats:
        """Return the derivatives of the cost, shape (variables,)."""
        return self.objective.sign * self.differentiated(point).gradients[self.objective.name]

    def margins(self, point: Floats) -> Floats:
        """Return all margins, which must not be negative."""
        state = self.values(point)
        return np.concatenate([np.empty(0), *(each.margins(state) for each in self.limits)])

    def margin_slopes(self, point: Floats) -> Floats:
        """Return the derivatives of all margins, shape (margins, variables)."""
        state = self.differentiated(point)
        return np.concatenate([np.empty((0, self.variables.count)), *(each.gradients(state) for each in self.limits)])


def _keep(kept: dict[bytes, State], key: bytes, state: State) -> None:
    kept[key] = state
    while len(kept) > REMEMBERED:
        del kept[next(iter(kept))]


COARSE = 512
"""Shots per golfer with which all starts are tried; the best is then solved again on more."""
SLACK = 1e-6
"""Safety margin during the solution, so that the solver's rounding breaks no limit."""
MOST_STEPS = 200
PATIENCE = 6
"""Steps without progress after which the solver stops: expected strokes are smooth only to about 1e-6."""
PENALTIES = (0.03, 0.3, 3.0)
"""Weights of a broken limit, relative to the starting cost, with which progress is measured."""
ALIKE = 1e-4
"""Relative difference in cost below which two optima count as the same."""
REFUSED = 10.0
"""Relative cost of a club whose shots cannot be computed, so that a line search turns back."""


class Solution(NamedTuple):
    """Final point, cost, steps and message of the solver."""

    point: Floats
    cost: float  # the objective with the sign for minimisation
    least_margin: float  # negative if a limit is broken
    steps: int
    message: str

    @property
    def allowed(self) -> bool:
        """Whether all limits are met."""
        return self.least_margin >= 0.0


def starts(problem: Problem, count: int, seed: int) -> list[Floats]:
    """Return starting points: the base club, then points spread evenly over the bounds."""
    from scipy.stats import qmc

    uniform = qmc.Sobol(problem.variables.count + 1, scramble=True, rng=np.random.default_rng(seed))
    spread = [problem.variables.random(each) for each in uniform.random_base2(max(count - 1, 1).bit_length())]
    return [problem.variables.start(), *spread][:count]


def solve(problem: Problem, start: Floats) -> Solution:
    """Return the optimum reached from a starting point."""
    from scipy.optimize import minimize

    best_yet = _Best()
    scale = max(abs(problem.cost(start)), 1e-6) if np.isfinite(problem.cost(start)) else 1.0

    def cost(point: Floats) -> float:
        result = problem.cost(point) / scale
        return result if np.isfinite(result) else REFUSED

    def slope(point: Floats) -> Floats:
        broken = max(-float(margins(point).min()), 0.0) if limited else 0.0
        best_yet.record(point, cost(point), broken, problem.objective.precision)
        return np.nan_to_num(problem.slope(point) / scale)

    def margins(point: Floats) -> Floats:
        return np.nan_to_num(problem.margins(point), nan=-REFUSED) - SLACK

    def margin_slopes(point: Floats) -> Floats:
        return np.nan_to_num(problem.margin_slopes(point))

    limited = problem.margins(start).size > 0
    box = problem.variables.box
    try:
        result = minimize(
            cost, start, jac=slope, method="SLSQP", bounds=box,
            constraints=[{"type": "ineq", "fun": margins, "jac": margin_slopes}] if limited else [],
            options={"maxiter": MOST_STEPS, "ftol": problem.objective.precision},
        )  # fmt: skip
        point, steps, message = result.x, int(result.nit), str(result.message)
    except _StalledError:
        point, steps, message = best_yet.point, best_yet.steps, "no more progress"
    point = np.clip(point, *box.T)
    least = float(problem.margins(point).min()) if limited else np.inf
    return Solution(point, problem.cost(point), least, steps, message)


class _StalledError(Exception):
    """The solver makes no more progress."""


class _Best:
    """Keeps the best point within all limits, and stops the solver when it makes no progress."""

    def __init__(self) -> None:
        self.point, self.cost, self.steps, self._idle = np.empty(0), np.inf, 0, 0
        self._merit = dict.fromkeys(PENALTIES, np.inf)

    def record(self, point: Floats, cost: float, broken: float, precision: float) -> None:
        """Record the point and limit violation of a solver step; raise an error if there is no progress.

        Steps along a curved limit violate it slightly while they make progress, so penalised costs count as progress.
        """
        self.steps += 1
        self._idle += 1
        for penalty, merit in self._merit.items():
            if cost + penalty * broken < merit - precision:
                self._merit[penalty], self._idle = cost + penalty * broken, 0
        if broken <= 0.5 * SLACK and cost < self.cost:
            self._idle = 0 if cost < self.cost - precision else self._idle
            self.point, self.cost = np.array(point), cost
        within_limits = np.isfinite(self.cost)
        if not within_limits:
            self.point = np.array(point)  # still outside the limits
        if self._idle > (PATIENCE if within_limits else 8 * PATIENCE):
            raise _StalledError


def best(solutions: Sequence[Solution]) -> Solution | None:
    """Return the best solution within all limits; None if there is none."""
    allowed = [each for each in solutions if each.allowed and np.isfinite(each.cost)]
    return min(allowed, key=lambda each: each.cost) if allowed else None


def refused(problem: Problem, solutions: Sequence[Solution]) -> InputError:
    """Return the error that no start reached a club within all limits, naming the nearest club's worst violation."""
    known = [each for each in solutions if np.isfinite(each.cost)]
    if not known:
        return InputError("a club within [variables]", Wording("impossible to compute"), "give other bounds")
    nearest = max(known, key=lambda each: each.least_margin)
    state = problem.values(nearest.point)
    worst = min(problem.limits, key=lambda each: float(each.margins(state).min()))
    value, allowed = worst.describe(state)
    return InputError(
        worst.name,
        Wording(f"{value} in the nearest club"),
        f"{allowed}, and no start reached a club within all limits",
    )


def agreeing(solutions: Sequence[Solution], chosen: Solution) -> int:
    """Return the number of solutions as good as the chosen one."""
    near = ALIKE * max(abs(chosen.cost), 1e-12)
    return sum(each.allowed and each.cost <= chosen.cost + near for each in solutions)
