"""A study of a head of shells: what may change, what is best, and within which limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.rules import rules_of
from clubface.design.shells.goal import Goal
from clubface.errors import InputError, ShotError
from clubface.fem.balls import Ball, ball as ball_of
from clubface.fem.heads.driver import SHAPE, WALLS, DriverHead
from clubface.fem.heads.metal import Metal
from clubface.simulation.impact import impact
from clubface.support.checks import check_choice, check_count, check_names
from clubface.support.warning import without_warnings

SCALED = ("crown", "sole", "skirt")
"""Walls that a head makes thicker or thinner to meet its mass, unless they are variables."""
QUANTITIES = {
    "ball_speed": ("mean ball speed", "speed", "mph"),
    "carry": ("mean carry", "length", "yd"),
    "characteristic_time": ("characteristic time", "time", "us"),
    "stress": ("greatest stress in the face", "pressure", "MPa"),
    "mass": ("mass of the head", "mass", "g"),
    "wall_mass": ("mass of its walls", "mass", "g"),
    "moment_of_inertia": ("inertia about the vertical", "inertia", "g cm2"),
    "volume": ("volume", "volume", "cm3"),
    "heel_to_toe": ("heel to toe", "length", "mm"),
    "sole_to_crown": ("sole to crown", "length", "mm"),
}
"""What a design has: words, dimension and unit."""
OBJECTIVES = {"ball_speed": True, "carry": True, "characteristic_time": True, "wall_mass": False}
"""What may be best, and whether it shall be large."""


@dataclass(frozen=True, kw_only=True)
class NamedMetal:
    """A metal by name, with where its figures are from."""

    name: str
    metal: Metal
    source: str = ""


@dataclass(frozen=True, kw_only=True)
class Blow:
    """A delivery, and where on the face it strikes: distances to the toe and above the face centre [m]."""

    delivery: Mapping[str, Any]
    points: tuple[tuple[float, float], ...] = ((0.0, 0.0),)

    def at(self, point: tuple[float, float]) -> dict[str, Any]:
        """Return the delivery at one of the points."""
        return {**self.delivery, "toe": point[0], "high": point[1]}


@dataclass(frozen=True, kw_only=True)
class ShellStudy:
    """What may change, what is best, and within which limits.

    Attributes
    ----------
    title
        For tables.
    head
        The driver to start from.
    bounds
        The least and the greatest value [SI] of walls and dimensions, under the names of :class:`.DriverHead` with
        their table, such as "thickness.face_centre". Crown, sole and skirt that vary are not scaled to meet the mass.
    objective
        One of :data:`OBJECTIVES`.
    delivery
        With what ball speed and carry are found; their mean over the points counts.
    hardest
        The hardest blow, whose stress the face must stand; None to leave the stress out.
    metals
        The metals to choose from; without any, that of the head.
    safety
        By what the yield stress is divided.
    limits
        The least and the greatest value [SI] of :data:`QUANTITIES`, 0 and infinity where there is none.
    rules
        Whether the limits of the rules of golf, with their tolerances, hold as well.
    ball
        The ball of finite elements.
    designs
        How many designs the engine may judge, for each metal.
    radius
        Half the width of the first region of trust, as a share of the bounds.
    neighbours
        Whether the engine judges neighbours of the start first.
    """

    title: str
    head: DriverHead
    bounds: Mapping[str, tuple[float, float]]
    objective: str
    delivery: Blow
    hardest: Blow | None = None
    metals: tuple[NamedMetal, ...] = ()
    safety: float = 1.0
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    rules: bool = True
    ball: Ball = field(default_factory=ball_of)
    designs: int = 20
    radius: float = 0.3
    neighbours: bool = True

    def __post_init__(self) -> None:
        check_choice("objective", self.objective, OBJECTIVES)
        check_names("variable", self.bounds, VARIABLES)
        check_names("limit", self.limits, [name for name in QUANTITIES if name != "stress"])
        check_count("designs", self.designs, 2, 500)
        if not self.bounds:
            raise InputError("variables", None, "give at least one, as in face_centre")
        if not 1.0 <= self.safety <= 10.0:
            raise InputError("safety", self.safety, "1 to 10")
        if not 0.01 <= self.radius <= 1.0:
            raise InputError("radius", self.radius, "0.01 to 1, a share of the bounds")
        for name, (least, most) in self.bounds.items():
            own = self.start_value(name)
            if not least < most:
                raise InputError(f"variables.{name}", (least, most), "the least value, then the greatest")
            if not least <= own <= most:
                raise InputError(
                    f"variables.{name}", show(name, own),
                    f"bounds that hold what the head has; these go from {show(name, least)} to {show(name, most)}",
                )  # fmt: skip
        made, (least, most) = self.head.target["mass"], self.limits.get("mass", (0.0, math.inf))
        if not least <= made <= most:
            told = f"a range that holds the {units.show(made, 'g')} that the head is made to have, by its target"
            raise InputError(
                "limits.mass",
                ["none" if each in (0.0, math.inf) else units.show(each, "g") for each in (least, most)],
                told,
            )
        if not self.metals:
            own = NamedMetal(name="that of the head", metal=self.head.metal)
            object.__setattr__(self, "metals", (own,))
        for each in self.metals if self.hardest is not None else ():
            if each.metal.yield_stress is None:
                raise InputError(
                    "yield", None, f"the yield stress of {each.name}, which the hardest blow is held against"
                )
        self._check_heads()

    def _check_heads(self) -> None:
        """Refuse bounds at which there is no head, and blows that miss the face, before anything runs."""
        with without_warnings():
            for name, bounds in self.bounds.items():
                for value in bounds:
                    try:
                        _ = self.at(self.start(), self.metals[0], {name: value}).mesh().club
                    except InputError as error:
                        allowed = f"bounds at which there is a head ({error})"
                        raise InputError(f"variables.{name}", show(name, value), allowed) from error
            club = self.at(self.start(), self.metals[0]).mesh().club
            blows = {"delivery": self.delivery, **({} if self.hardest is None else {"hardest": self.hardest})}
            for table, blow in blows.items():
                for point in blow.points:
                    try:
                        impact(club, blow.at(point), ball=self.ball.rigid)
                    except ShotError as error:
                        raise ShotError(f"{table}.{error.parameter}", error.value, error.allowed) from None

    def start_value(self, name: str) -> float:
        """Return what the head to start from has of a variable [SI]."""
        table, key = name.split(".")
        return getattr(self.head, table)[key]

    def start(self) -> NDArray[Any]:
        """Return the head to start from, as shares of the bounds."""
        return np.array([(self.start_value(name) - low) / (high - low) for name, (low, high) in self.bounds.items()])

    def variables(self, place: NDArray[Any]) -> dict[str, float]:
        """Return the variables [SI] of shares of the bounds."""
        return {name: low + float(share) * (high - low)
                for share, (name, (low, high)) in zip(place, self.bounds.items(), strict=True)}  # fmt: skip

    def at(self, place: NDArray[Any], metal: NamedMetal, own: Mapping[str, float] | None = None) -> DriverHead:
        """Return the head at a place within the bounds, of a metal that stays elastic."""
        tables = {"shape": dict(self.head.shape), "thickness": dict(self.head.thickness)}
        for name, value in {**self.variables(place), **(own or {})}.items():
            table, key = name.split(".")
            tables[table][key] = value
        free = any(f"thickness.{wall}" in self.bounds for wall in SCALED)
        return replace(
            self.head, **tables, scales=(1.0, 1.0) if free else self.head.scales,
            metal=replace(metal.metal, yield_stress=None, hardening=None, points=None),
        )  # fmt: skip

    def goal(self, metal: NamedMetal) -> Goal:
        """Return what is best, and all limits that hold for a metal."""
        limits = dict(self.limits)
        if self.rules:
            for rule in rules_of(self.head.mesh().club):
                least, most = limits.get(rule.name, (0.0, math.inf))
                limits[rule.name] = (least, min(most, rule.limit))
        if self.hardest is not None and metal.metal.yield_stress is not None:
            limits["stress"] = (0.0, metal.metal.yield_stress / self.safety)
        return Goal(objective=self.objective, largest=OBJECTIVES[self.objective], limits=limits)


VARIABLES = (*(f"thickness.{wall}" for wall in WALLS), *(f"shape.{name}" for name in SHAPE))


def show(name: str, value: float) -> str:
    """Return a variable in words."""
    return units.show(value, "deg" if name == "shape.loft" else "mm")
