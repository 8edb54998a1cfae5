"""A study: what may change, what is best, for whom, and within which limits."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, Envelope, Volume, of_club, pseudo_inertia, room_inside
from clubface.design.golfer.golfers import golfer as golfer_of
from clubface.design.optimisation.landings import DEFAULT_SETTING, FREE, Landings, Setting, own_value
from clubface.design.optimisation.limits import Buildable, FieldLimit, ShotLimit
from clubface.design.optimisation.objectives import Objective, objective, objectives
from clubface.design.optimisation.problem import Limit, Problem
from clubface.design.optimisation.variables import Variables, check_bounds
from clubface.design.rules import check_rules, rules_of
from clubface.design.strokes import Hole
from clubface.equipment.clubs import CLUB_PROPERTIES, Club
from clubface.errors import InputError, Told
from clubface.fem.heads.meshed import mesh_of

if TYPE_CHECKING:
    from clubface.design.golfer.golfer import Golfer

MOST_SHOTS = 100_000
DISTRIBUTION = "mass_distribution"
"""The word among the variables that sets the whole distribution of mass free."""
DIMENSIONS = {**{name: each.dimension for name, each in CLUB_PROPERTIES.items()}, "lie": "angle"}
UNITS = {**{name: each.unit for name, each in CLUB_PROPERTIES.items()}, "lie": "deg"}
RULED = {"iyy": "moment_of_inertia", "characteristic_time": "characteristic_time"}
"""The fields of a club that rules limit."""


@dataclass(frozen=True, kw_only=True)
class Head:
    """What the head may be.

    Attributes
    ----------
    volume
        Where its mass may be.
    discretionary
        The most mass that may be placed freely [kg].
    displaced
        Its volume as the rules measure it [m3], or None.
    shell
        Mass properties of what cannot be moved in the order of ``MASS_PROPERTIES`` [SI]; None for the base club made
        lighter evenly, by the discretionary mass.
    """

    volume: Volume
    discretionary: float
    displaced: float | None = None
    shell: tuple[float, ...] | None = None

    def envelope(self, base: Club) -> Envelope:
        """Return the volume with its shell, that of a base club unless it is given; mass goes inside a base's mesh."""
        if self.shell is not None:
            fixed = pseudo_inertia(np.array(self.shell))
        else:
            if not 0.0 < self.discretionary < base.mass:
                told = units.show(self.discretionary, "g")
                raise InputError("discretionary_mass", told, f"between 0 and the mass of {base.name}")
            fixed = pseudo_inertia(of_club(base)) * (1.0 - self.discretionary / base.mass)
        mesh = mesh_of(base)
        room = self.volume if mesh is None else room_inside(mesh.places, self.volume)
        return Envelope(volume=room, shell=fixed, budget=self.discretionary, whole=self.volume)


@dataclass(frozen=True, kw_only=True)
class DesignStudy:
    """What may change, what is best, for whom, and within which limits.

    Attributes
    ----------
    title
        Its name in reports.
    club
        The club to start from, with which the golfers deliver as they do.
    golfers
        Each with how much he counts.
    objectives
        One, or two for a front.
    bounds
        Least and greatest value of every field that changes [SI].
    distributed
        Whether the whole distribution of mass is free.
    head
        What the head may be; needed where a mass property changes.
    limits
        Least and greatest value of fields and of numbers of the shots [SI], infinite where there is none.
    conform
        Whether the rules are limits.
    tolerance
        Whether their tolerances may be used.
    hole
        For the expected strokes.
    setting
        Model, ball and air.
    shots, seed, starts, points
        Shots of a golfer, the seed of shots and starts, starts of the solver, points of a front.
    """

    title: str
    club: Club
    golfers: tuple[tuple[Golfer, float], ...]
    objectives: tuple[str, ...]
    bounds: Mapping[str, tuple[float, float]]
    distributed: bool = False
    head: Head | None = None
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    conform: bool = True
    tolerance: bool = True
    hole: Hole | None = None
    setting: Setting = DEFAULT_SETTING
    shots: int = 10_000
    seed: int = 1
    starts: int = 8
    points: int = 9

    def __post_init__(self) -> None:
        if not self.bounds and not self.distributed:
            raise InputError("variables", None, "at least one of " + ", ".join((*FREE, DISTRIBUTION)))
        for name in (*self.objectives, *(each for each in self.limits if each not in FREE)):
            self.objective(name)
        if self.moves_mass and self.head is None:
            told = "give [head] with size, centre and discretionary_mass, since mass properties change"
            raise InputError("head", None, told)
        for name in self.limits:
            if name in FREE and name not in self.variables.fields:
                raise InputError(f"limits.{name}", Told("given"), f"leave it out, since {name} does not change")
        check_bounds(self.club, self.bounds, "variables")
        self._refuse_rules_that_are_broken_for_good()

    @property
    def moves_mass(self) -> bool:
        """Whether a mass property changes."""
        return self.distributed or any(name in MASS_PROPERTIES for name in self.bounds)

    @property
    def variables(self) -> Variables:
        """What the optimiser turns."""
        envelope = self.head.envelope(self.club) if self.head is not None and self.moves_mass else None
        return Variables(base=self.club, bounds=self.bounds, envelope=envelope, distributed=self.distributed)

    def objective(self, name: str) -> Objective:
        """Return an objective of the study by its name."""
        return objective(name, self.hole)

    def known(self) -> tuple[Objective, ...]:
        """Return all objectives that the study can compute."""
        return objectives(self.hole)

    def landings(self, shots: int, *, seed: int) -> list[tuple[Landings, float]]:
        """Return the shots of the golfers, and how much each golfer counts."""
        return [
            (Landings(self.club, each.for_hand(self.club.hand).sample(shots, seed=seed), self.setting), weight)
            for each, weight in self.golfers
        ]

    def mean_shots(self) -> list[tuple[Landings, float]]:
        """Return the mean delivery of every golfer, as one shot each."""
        found = []
        for each, weight in self.golfers:
            own = each.for_hand(self.club.hand)
            mean = {name: np.array([value]) for name, value in zip(own.variables, own.mean, strict=True)}
            found.append((Landings(self.club, mean, self.setting), weight))
        return found

    def problem(
        self,
        golfers: list[tuple[Landings, float]],
        objective: str,
        *,
        limits: tuple[ShotLimit, ...] = (),
        others: tuple[Objective, ...] = (),
    ) -> Problem:
        """Return the problem for an objective; ``limits`` stand beside those of the study; ``others`` are known."""
        own = tuple(
            ShotLimit(objective=self.objective(name), least=low, most=high)
            for name, (low, high) in self.limits.items()
            if name not in FREE
        )
        asked = [*own, *limits]
        known = [*(each.objective for each in asked), *others]
        return Problem(self.variables, golfers, self.objective(objective), [*self.design_limits(), *asked], known)

    def design_limits(self) -> list[Limit]:
        """Return the limits that are of the club and not of its shots."""
        turned, found = self.variables, []
        if turned.envelope is not None:
            found.append(
                Buildable(
                    self.club, turned.envelope, turned.fields, distributed=self.distributed,
                    mass_changes="mass" in self.bounds,
                )
            )  # fmt: skip
        if self.conform:
            for rule in rules_of(self.club):
                for name, of in RULED.items():
                    if of == rule.name and name in turned.fields:
                        most = rule.limit if self.tolerance else rule.most
                        found.append(self._field_limit(name, -math.inf, most, f"rules: {rule.title}"))
        for name, (low, high) in self.limits.items():
            if name in FREE:
                found.append(self._field_limit(name, low, high, name))
        return found

    def _field_limit(self, name: str, low: float, high: float, called: str) -> FieldLimit:
        finite = [abs(each) for each in (low, high) if math.isfinite(each)]
        scale = max([*finite, abs(own_value(self.club, name)), 1e-12])
        return FieldLimit(
            name=called, field=name, least=low, most=high, unit=UNITS[name], scale=scale,
            fields=self.variables.fields,
        )  # fmt: skip

    def rule_values(self, club: Club) -> Any:
        """Return what a club with the head of the study has of every rule; a mesh says its own volume and size."""
        volume, size = (None, None) if self.head is None else (self.head.displaced, self.head.volume.size)
        if (mesh := mesh_of(self.club)) is not None:
            volume, size = mesh.volume or volume, mesh.size
        return check_rules(club, volume=volume, size=size)

    def _refuse_rules_that_are_broken_for_good(self) -> None:
        if not self.conform:
            return
        changing = {RULED[name] for name in self.variables.fields if name in RULED}
        for each in self.rule_values(self.club):
            limit = each.rule.limit if self.tolerance else each.rule.most
            if each.rule.name not in changing and each.value > limit * (1.0 + 1e-9):
                told = units.show(each.value, each.rule.unit, 4)
                allowed = f"at most {units.show(limit, each.rule.unit, 4)} by the rules, and nothing changes it"
                raise InputError(each.rule.title, told, f"{allowed}; or give conform = false under [rules]")


def golfers_of(given: Any) -> tuple[tuple[Golfer, float], ...]:
    """Return golfers with their weights, from a name or path, or from tables of ``name`` and ``weight``."""
    if isinstance(given, str | os.PathLike):
        return ((golfer_of(given), 1.0),)
    return tuple((golfer_of(each["name"]), float(each.get("weight", 1.0))) for each in given)
