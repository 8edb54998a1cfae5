"""Fitting: parts and settings from lists, every combination judged on the same shots, and what is free adjusted."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface import units
from clubface.design.optimisation.landings import DEFAULT_SETTING, Landings, Setting
from clubface.design.optimisation.objectives import Objective, objective, objectives
from clubface.design.optimisation.problem import Problem
from clubface.design.optimisation.solve import best, solve, starts
from clubface.design.optimisation.variables import Variables
from clubface.design.strokes import Hole
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError

if TYPE_CHECKING:
    from clubface.design.golfer import Golfer

MOST_COMBINATIONS = 10_000
STARTS = 3
"""Starts of a combination's adjustment; it has at most two numbers, loft and lie."""
BLOCKS = 16
"""Parts of the shots whose differences tell how certain a difference is."""
SETTINGS = ("loft", "lie", "cg_x", "cg_y", "cg_z")
"""What a setting of a head may change."""


class Combination(NamedTuple):
    """One club as it can be put together.

    Attributes
    ----------
    club
        Its name.
    ball
        The name of the ball.
    setting
        The name of the setting of the head, "" where there are none.
    changes
        What loft, lie and CG are changed by [SI]; adjusted values among them.
    value
        What it is judged by [SI].
    others
        The other numbers of the shots, by name [SI].
    error
        Standard error of the difference from the best [SI], 0 for the best itself.
    """

    club: str
    ball: str
    setting: str
    changes: Mapping[str, float]
    value: float
    others: Mapping[str, float]
    error: float


@dataclass(frozen=True, kw_only=True)
class Fitting:
    """Parts to choose from and settings to adjust.

    Attributes
    ----------
    title
        Its name in reports.
    golfers
        Each with how much he counts; all deliver as with the first club, and hold every club so.
    objective
        What is judged.
    clubs, balls
        The parts.
    settings
        Named settings of a head: changes of loft, lie, cg_x, cg_y, cg_z [SI].
    bounds
        Least and greatest change of the loft and the lie that can be set freely [SI].
    hole, setting, shots, seed
        As of a study.
    """

    title: str
    golfers: tuple[tuple[Golfer, float], ...]
    objective: str
    clubs: tuple[Club, ...]
    balls: tuple[Ball | None, ...] = (None,)
    settings: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    bounds: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    hole: Hole | None = None
    setting: Setting = DEFAULT_SETTING
    shots: int = 10_000
    seed: int = 1

    def __post_init__(self) -> None:
        self.judge(self.objective)
        count = len(self.clubs) * len(self.balls) * max(len(self.settings), 1)
        if not 1 <= count <= MOST_COMBINATIONS:
            raise InputError("combinations of parts", count, f"from 1 to {MOST_COMBINATIONS}")

    def judge(self, name: str) -> Objective:
        """Return an objective by its name."""
        return objective(name, self.hole)

    def names(self) -> list[tuple[Club, Ball | None, str]]:
        """Return all combinations of club, ball and setting."""
        return list(product(self.clubs, self.balls, self.settings or ("",)))


class _Tried(NamedTuple):
    combination: tuple[Club, Ball | None, str]
    changes: dict[str, float]
    landed: list[Any]
    weights: list[float]
    balls: str


def fit(of: Fitting, *, progress: Callable[[int, int], object] | None = None) -> list[Combination]:
    """Return all combinations, the best first.

    A setting changes the loft of a head, and with it the loft at impact, the lie at impact, and the CG; a loft that is
    set by turning the head is taken to leave the face angle alone, as a golfer does who squares the face again.
    """
    judge, tried = of.judge(of.objective), []
    samples = [(each.for_hand(of.clubs[0].hand).sample(of.shots, seed=of.seed), weight) for each, weight in of.golfers]
    combinations = of.names()
    for done, (head, ball, setting) in enumerate(combinations):
        if progress is not None:
            progress(done, len(combinations))
        tried.append(_tried(of, judge, head, ball, setting, samples))
    values = [_mean(judge, each) for each in tried]
    order = sorted(range(len(tried)), key=lambda place: judge.sign * values[place])
    first = tried[order[0]]
    others = [each for each in of_all(of) if each.name != judge.name]
    return [
        Combination(
            tried[place].combination[0].name, tried[place].balls, tried[place].combination[2], tried[place].changes,
            values[place], {each.name: _mean(each, tried[place]) for each in others},
            0.0 if place == order[0] else _error(judge, tried[place], first),
        )
        for place in order
    ]  # fmt: skip


def of_all(of: Fitting) -> list[Objective]:
    """Return all objectives that a fitting can compute."""
    return list(objectives(of.hole))


def _tried(of: Fitting, judge: Objective, head: Club, ball: Ball | None, setting: str, samples: Any) -> _Tried:
    """Judge one combination, after what can be set freely is set as well as it can be."""
    own = replace(of.setting, ball=ball)
    base_loft = of.clubs[0].loft
    golfers = []
    for sample, weight in samples:
        # The golfer delivers his loft with the first club; another head delivers as much more as it has more of it.
        delivered = {**sample, "loft": sample.get("loft", base_loft) + (head.loft - base_loft)}
        golfers.append((Landings(head, delivered, own), weight))
    changes = dict(of.settings[setting]) if setting else {}
    club = {name: change if name == "lie" else getattr(head, name) + change for name, change in changes.items()}
    if of.bounds:
        middle = {name: club.get(name, 0.0 if name == "lie" else getattr(head, name)) for name in of.bounds}
        bounds = {name: (middle[name] + low, middle[name] + high) for name, (low, high) in of.bounds.items()}
        moved = head.replace(**{name: value for name, value in club.items() if name != "lie"})
        problem = _Adjusted(Variables(base=moved, bounds=bounds), golfers, judge, club)
        found = best([solve(problem, each) for each in starts(problem, STARTS, of.seed)])
        if found is not None:
            club |= problem.variables.club(found.point)
        changes |= {name: club[name] - (0.0 if name == "lie" else getattr(head, name)) for name in of.bounds}
    landed = [each.of(club) for each, _ in golfers]
    total = sum(weight for _, weight in golfers)
    return _Tried(
        (head, ball, setting), changes, landed, [weight / total for _, weight in golfers], golfers[0][0].ball.name
    )


class _Adjusted(Problem):
    """A problem whose club has settings that its variables do not turn."""

    def __init__(self, variables: Variables, golfers: Any, judge: Objective, club: Mapping[str, float]) -> None:
        held = {name: value for name, value in club.items() if name not in variables.fields}
        super().__init__(variables, [(_Held(each, held), weight) for each, weight in golfers], judge, ())


class _Held(Landings):
    """Landings with a club some fields of which are set."""

    def __init__(self, of: Landings, held: Mapping[str, float]) -> None:
        self.__dict__ |= of.__dict__
        self._held = held

    def _inputs(self, club: Mapping[str, float]) -> list[Any]:
        return super()._inputs({**self._held, **club})


def _mean(judge: Objective, tried: _Tried) -> float:
    return sum(weight * judge.judge(one)[0] for weight, one in zip(tried.weights, tried.landed, strict=True))


def _error(judge: Objective, tried: _Tried, first: _Tried) -> float:
    """Return the standard error of a difference on the same shots, from the differences of ``BLOCKS`` parts of them.

    Where other shots miss the face of the other club, the shots do not pair, and it is not known.
    """
    differences = np.zeros(BLOCKS)
    for weight, one, other in zip(tried.weights, tried.landed, first.landed, strict=True):
        if one.shape != other.shape or one.shape[1] < 2 * BLOCKS:
            return float("nan")
        parts = zip(np.array_split(one, BLOCKS, axis=1), np.array_split(other, BLOCKS, axis=1), strict=True)
        differences += [weight * (judge.judge(mine)[0] - judge.judge(best_)[0]) for mine, best_ in parts]
    return float(np.std(differences, ddof=1) / np.sqrt(BLOCKS))


def told(changes: Mapping[str, float]) -> str:
    """Write the changes of a setting: "loft +1 deg, cg_x -3 mm"."""
    parts = []
    for name, change in changes.items():
        unit = "deg" if name in ("loft", "lie") else "mm"
        parts.append(f"{name} {units.from_si(change, unit):+.2f} {unit}")
    return ", ".join(parts)
