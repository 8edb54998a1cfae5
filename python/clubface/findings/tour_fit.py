"""One parameter set for all twelve clubs of the published tour averages, and how well it does on clubs left out.

The averages are those of 2019, with which the dynamic loft of two clubs is published. For the others it is, for every
candidate set anew, the loft with which the model gives the published launch angle: their launch angle is then no
prediction, but ball speed and spin are, and the loft carries no other model's errors.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.balls import published_ball
from clubface.equipment.clubs import club
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import input_dimensions
from clubface.support.arrays import Floats
from clubface.tour.averages import Average, averages, published_lofts

SEASON = "pga-2019"
"""The averages, the latest with which dynamic lofts are published."""
FREE = {
    "standard": ("cor",),
    "adjusted": ("cor", "extra_mass", "dcg_y"),
    "slip": ("cor", "slip_y"),
    "jorgensen": ("cor", "compression_factor"),
    "volumetric": ("damping", "friction", "layer_stiffness", "layer_damping", "transition_speed"),
    "rings": ("damping", "friction", "ring_modulus"),
    "area": ("damping", "friction", "area_damping"),
}
"""The parameters solved for. What shows only off the centre or in time stays as published, and restitution without a
slope: woods, the faster clubs, have the livelier faces, so that a free slope ends at its bound, zero."""
SCALES = {
    "ball_speed": units.parse("1 mph", "speed"), "spin": units.parse("150 rpm", "angular rate"),
    "launch": units.parse("0.5 deg", "angle"),
}  # fmt: skip
"""What counts as an error of one, in each quantity: roundings and spreads of averages; assumed."""
SLOPE = 0.85
"""Change of the launch angle with the loft, for the steps by which the loft is solved."""
STEPS = 8
FAR = 1e3
"""The residual of a shot that cannot be computed."""
FAMILIES = ("driver", "7-iron")
"""Whose published sets the search starts from."""


class TourFit(NamedTuple):
    """One model with one parameter set for every club.

    Attributes
    ----------
    parameters
        The set.
    free
        The parameters that were solved for.
    clubs
        Names of the clubs.
    lofts
        Dynamic loft of each club [rad], published or solved with this set.
    errors
        Model less published by quantity, one a club, SI; the launch angle only where the loft is published, else NaN.
    left_out
        The same with parameters solved without the club in question.
    carry
        Carry [m] of the flights of the model's launches less published, which nothing was fitted to.
    """

    parameters: ParameterSet
    free: tuple[str, ...]
    clubs: tuple[str, ...]
    lofts: Floats
    errors: dict[str, Floats]
    left_out: dict[str, Floats]
    carry: Floats

    def mean_absolute_error(self, quantity: str, *, left_out: bool = False) -> float:
        """Return the mean over the clubs of the absolute error, SI."""
        return float(np.nanmean(np.abs((self.left_out if left_out else self.errors)[quantity])))


class Bag:
    """All clubs of the averages as one batch."""

    def __init__(self, rows: Sequence[Average]) -> None:
        self.rows = tuple(rows)
        heads = [club(each.club) for each in rows]
        self.inputs = {
            name: np.array([head.inputs()[name] for head in heads], dtype=np.float64)
            for name in heads[0].inputs()
            if name in input_dimensions()
        }
        self.speed = np.array([each.club_speed for each in rows])
        self.attack = np.array([each.attack for each in rows])
        self.launch = np.array([each.launch for each in rows])
        lofts = published_lofts(SEASON)
        self.loft = np.array([lofts.get(each.club, np.nan) for each in rows])

    def errors(self, parameters: ParameterSet) -> tuple[dict[str, Floats], Floats]:
        """Return model less published, and the lofts; the launch angle is NaN where the loft was solved."""
        solved = np.isnan(self.loft)
        loft = np.where(solved, self.launch, self.loft)
        for _ in range(STEPS):
            found = self.hit(loft, parameters)
            loft = np.where(solved, loft + (self.launch - found.launch) / SLOPE, loft)
        found = self.hit(loft, parameters)
        published = {name: np.array([getattr(each, name) for each in self.rows]) for name in ("ball_speed", "spin")}
        return {
            "ball_speed": found.ball_speed - published["ball_speed"],
            "spin": found.total_spin - published["spin"],
            "launch": np.where(solved, np.nan, found.launch - self.launch),
        }, loft

    def residuals(self, parameters: ParameterSet) -> Floats:
        """Return the errors in units of ``SCALES``, those of solved lofts left out; an impossible shot is far off."""
        errors, _ = self.errors(parameters)
        known = ~np.isnan(self.loft)
        parts = [errors["ball_speed"], errors["spin"], errors["launch"][known]]
        scaled = [part / SCALES[name] for part, name in zip(parts, ("ball_speed", "spin", "launch"), strict=True)]
        return np.nan_to_num(np.concatenate(scaled), nan=FAR)

    def misfit(self, parameters: ParameterSet) -> float:
        """Return the sum of squared residuals."""
        return float(np.sum(self.residuals(parameters) ** 2))

    def hit(self, loft: Floats, parameters: ParameterSet) -> Launch:
        """Return the launches of all clubs, delivered at their published speeds and attack angles."""
        return impact(
            "driver", {**parameters.beside(self.inputs), "speed": self.speed, "attack": self.attack, "loft": loft},
            model=parameters.model, parameters=parameters, ball=published_ball(), on_error="nan",
        )  # fmt: skip


def fit(model: str) -> TourFit:
    """Solve for the parameters of ``FREE`` that all clubs agree with best, and again without each club."""
    rows, names = averages(SEASON), FREE[model]
    every = Bag(rows)
    best = min((_solved(every, _start(model, family), names) for family in FAMILIES), key=every.misfit)
    errors, lofts = every.errors(best)
    left_out = {name: np.full(len(rows), np.nan) for name in errors}
    for place in range(len(rows)):
        others = [each for index, each in enumerate(rows) if index != place]
        without = _solved(Bag(others), best, names)
        found, _ = Bag([rows[place]]).errors(without)
        for name, values in found.items():
            left_out[name][place] = values[0]
    carry = fly(every.hit(lofts, best)).carry - np.array([each.carry for each in rows])
    return TourFit(best, names, tuple(each.club for each in rows), lofts, errors, left_out, carry)


def _start(model: str, family: str) -> ParameterSet:
    """Return the set published for a family of clubs, for every club."""
    of = ParameterSet.builtin(model, family)
    return ParameterSet(model=model, club="any", name="tour-averages", values=of.values)


def _solved(bag: Bag, start: ParameterSet, names: Sequence[str]) -> ParameterSet:
    """Return the set with the least sum of squared errors, in units of ``SCALES``, by bounded least squares."""
    from scipy.optimize import least_squares

    declared = [model_named(start.model).parameter(name) for name in names]
    sizes = np.array([max(abs(float(start.values[each.name])), 0.01 * (each.upper - each.lower)) for each in declared])
    lower, upper = (np.array([getattr(each, end) for each in declared]) / sizes for end in ("lower", "upper"))

    def at(point: Floats) -> ParameterSet:
        values = {name: float(value) for name, value in zip(names, np.clip(point, lower, upper) * sizes, strict=True)}
        return ParameterSet(model=start.model, club="any", name=start.name, values={**start.values, **values})

    def residuals(point: Floats) -> Floats:
        return bag.residuals(at(point))

    first = np.clip(np.array([float(start.values[name]) for name in names]) / sizes, lower + 1e-6, upper - 1e-6)
    found = least_squares(residuals, first, bounds=(lower, upper), diff_step=1e-4, xtol=1e-8, ftol=1e-8)
    return at(found.x)
