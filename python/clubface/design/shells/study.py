"""Studies of shell heads: variables, objective and limits, and their TOML files.

``examples/faster_face.toml`` varies a driver from dimensions, ``examples/own_walls.toml`` a mesh of shells by group;
:class:`ShellFile` describes every key.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from clubface import units
from clubface.design.golfer import Golfer, golfer as golfer_of
from clubface.design.shells.families import Family, Head, MetalChoice, NamedMetal, face_parts, family_of, metal_choices
from clubface.design.shells.trust_region import Goal
from clubface.equipment.rules import rules_of
from clubface.errors import InputError, ShotError, Wording
from clubface.fem.balls import Ball, ball as ball_of
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.parametric import DRIVER_SHAPES, DriverHead
from clubface.fem.heads.read import FOLDER, from_toml, head as meshed
from clubface.fem.heads.user_mesh import MeshHead
from clubface.quantities import Quantity, Reading
from clubface.schema.document import Document, Place
from clubface.schema.tables import decode, entries, file_key
from clubface.schema.values import (
    FLAG,
    NAME,
    TEXT,
    Choice,
    Interval,
    Items,
    PhysicalValue,
    Record,
    Reference,
    Tables,
    count,
)
from clubface.simulation.impact import impact
from clubface.simulation.inputs import DELIVERY_QUANTITIES as DELIVERED, DIMENSIONS, Delivery
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import check_choice, check_count, check_names, without_warnings
from clubface.support.files import path_of

QUANTITIES = {
    "ball_speed": ("mean ball speed", "mph"),
    "carry": ("mean carry", "yd"),
    "characteristic_time": ("characteristic time", "us"),
    "stress": ("greatest stress in the face", "MPa"),
    "mass": ("mass of the head", "g"),
    "wall_mass": ("mass of its walls", "g"),
    "moment_of_inertia": ("inertia about the vertical", "g cm2"),
    "cg_depth": ("CG behind the face centre", "mm"),
    "cg_height": ("CG above the lowest point", "mm"),
    "cg_from_heel": ("CG from the heel", "mm"),
    "volume": ("volume", "cm3"),
    "heel_to_toe": ("heel to toe", "mm"),
    "sole_to_crown": ("sole to crown", "mm"),
}
"""Quantities of a design: label and unit."""
LIMITED = {name: each for name, each in QUANTITIES.items() if name != "stress"}
"""Quantities that may have limits in a file."""
DIGITS = {"mph": 2, "yd": 1, "us": 1, "MPa": 0, "g": 1, "g cm2": 0, "cm3": 1, "mm": 3, "deg": 2}
"""Decimal places, by unit."""
OBJECTIVES = {"ball_speed": True, "carry": True, "characteristic_time": True, "wall_mass": False}
"""Objectives, and whether each is maximised."""


def unit_of(variable: str) -> str:
    """Return the usual unit of a variable."""
    return "deg" if variable == "shape.loft" else "g" if variable.startswith("masses.") else "mm"


def design_quantity(name: str) -> Quantity:
    """Return one of ``QUANTITIES``, or a variable such as "thickness.crown", for tables and sentences."""
    table, _, key = name.partition(".")
    if table in QUANTITIES:
        label, unit = QUANTITIES[table]
        label = f"greatest stress in {key}" if key else label
    else:
        label = f"{key.replace('_', ' ')}{' wall' if table == 'thickness' and 'face' not in key else ''}"
        unit = unit_of(name)
    reading = Reading(unit, DIGITS[unit])
    metric = Reading({"mph": "m/s", "yd": "m"}.get(unit, unit), reading.digits)
    return Quantity(name, units.SI_UNITS[units.unit(unit).dimension], metric, reading, label)


@dataclass(frozen=True, kw_only=True)
class FaceImpact:
    """A delivery and its impact points on the face: distances towards the toe and above the face centre [m]."""

    delivery: Mapping[str, ValueLike]
    points: tuple[tuple[float, float], ...] = ((0.0, 0.0),)

    def at(self, point: tuple[float, float]) -> dict[str, Any]:
        """Return the delivery with one of the points as its impact point."""
        return {**self.delivery, "toe": point[0], "high": point[1]}


def show(name: str, value: float) -> str:
    """Return a value of a variable as text with its unit."""
    return units.show(value, unit_of(name))


MOST_POINTS = 100
REACH = PhysicalValue("mm", -60, 60, allowed="within 60 mm of the face centre")
POINTS = Items(
    Items(REACH, 2, 2, "a distance to the toe and one above the face centre"), 1, MOST_POINTS,
    f'1 to {MOST_POINTS} points, each to the toe and above the face centre, as in [["0 mm", "0 mm"]]',
)  # fmt: skip
FACE_IMPACT = Record(
    {**{name: each for name, each in DELIVERED.items() if name not in ("toe", "high")}, "points": POINTS}
)
"""A delivery with its impact ``points``."""
VARIABLE_TABLES = {
    "thickness": Record(Interval(PhysicalValue("mm"), '["2.4 mm", "4.2 mm"]')),
    "masses": Record(Interval(PhysicalValue("g", lower=0), '["0 g", "12 g"]')),
    "shape": Record({name: Interval(PhysicalValue("deg" if name == "loft" else "mm")) for name in DRIVER_SHAPES}),
}
LIMITS = Record({
    name: Interval(PhysicalValue(unit, lower=0), f'["none", "... {unit}"]', no_limits=(0.0, math.inf))
    for name, (_, unit) in LIMITED.items()
})  # fmt: skip


def _head(named: Any) -> Head:
    """Return the design of a head from a built-in name or a file."""
    path = path_of("head of finite elements", named, FOLDER)
    head = from_toml(path)
    if not isinstance(head, Head):
        raise InputError("head", head.name, 'of the kind "driver" or "mesh", whose walls can vary')
    if isinstance(head, MeshHead):
        with without_warnings():
            meshed(path)  # reports errors in the mesh under the name of the head's file
    return head


METAL = {key: entries(Metal)[key] for key in ("youngs", "poisson", "density", "yield")}


def _made_metal(values: dict[str, Any], place: Place) -> NamedMetal:
    """Return the metal described by a table [[metals]]."""
    metal = Metal(**{each.attribute: values.pop(key) for key, each in METAL.items() if key in values})
    return NamedMetal(metal=metal, **values)


_GROUPS = Items(NAME, 1, None, 'a list of groups of the mesh, as in ["face"]')
_METAL_KEYS = {"name": NAME, "source": TEXT, "groups": _GROUPS, **{key: each.value for key, each in METAL.items()}}
METALS = Tables(Record(_METAL_KEYS, ("name", "youngs", "poisson", "density"), make=_made_metal))


@dataclass(frozen=True, kw_only=True)
class _Asked:
    """Keys common to a study and its file."""

    title: str = file_key(TEXT, "name in tables")
    head: Head = file_key(Reference(_head), "starting head: a parametric driver, or a mesh of shells")
    objective: str = file_key(Choice(tuple(OBJECTIVES)), "the objective; `wall_mass` is minimised")
    ball: Ball = file_key(Reference(ball_of), "finite element ball", default_factory=ball_of)
    safety: float = file_key(PhysicalValue("1"), "factor by which the yield stress is divided", default=1.0)
    rules: bool = file_key(FLAG, "whether the rules of golf, with their tolerances, are limits", default=True)
    designs: int = file_key(count(2, 500), "maximum number of designs to compute, for each metal", default=20)
    radius: float = file_key(
        PhysicalValue("1"), "half the width of the initial trust region, as a fraction of the bounds", default=0.3
    )
    neighbours: bool = file_key(FLAG, "whether neighbours of the start are computed first", default=True)
    limits: Mapping[str, tuple[float, float]] = file_key(LIMITS, "least and greatest values", default_factory=dict)
    metals: tuple[NamedMetal, ...] = file_key(
        METALS, "metals to choose from, for a mesh by `groups`; default: the head's own", default=()
    )


@dataclass(frozen=True, kw_only=True)
class ShellStudy(_Asked):
    """Variables, objective and limits of a search for the best shell head.

    Attributes
    ----------
    title, head
        Name in tables, and the starting head: a parametric driver, or a mesh of shells.
    bounds
        Lower and upper bound [SI] of each variable, by table and name. For a driver these are walls and dimensions of
        :class:`.DriverHead`, such as "thickness.face_centre"; crown, sole and skirt are not scaled to meet the mass if
        they are variables. For a mesh they are thicknesses of groups, such as "thickness.face", and added masses, such
        as "masses.weight".
    objective
        One of :data:`OBJECTIVES`.
    delivery
        Delivery for ball speed and carry, which are averaged over its points.
    hardest, safety
        The hardest impact the face must withstand (None to ignore stress), and factor that divides the yield stress.
    metals
        Metals to choose from, for a mesh by group; if empty, the head keeps its own.
    limits, rules
        Lower and upper limit [SI] of each of :data:`QUANTITIES`, 0 and infinity for none; whether the limits of the
        rules of golf, with their tolerances, apply as well.
    ball
        The finite element ball.
    designs
        Maximum number of designs evaluated by finite elements, for each choice of metals.
    radius
        Half the width of the initial trust region, as a share of the bounds.
    neighbours
        Whether neighbours of the starting head are evaluated first.
    """

    bounds: Mapping[str, tuple[float, float]]
    delivery: FaceImpact
    hardest: FaceImpact | None = None

    def __post_init__(self) -> None:
        check_choice("objective", self.objective, OBJECTIVES)
        check_names("limit", self.limits, LIMITED)
        check_count("designs", self.designs, 2, 500)
        if not self.bounds:
            raise InputError("variables", None, "give at least one, as in face_centre")
        if not 1.0 <= self.safety <= 10.0:
            raise InputError("safety", self.safety, "1 to 10")
        if not 0.01 <= self.radius <= 1.0:
            raise InputError("radius", self.radius, "0.01 to 1, a share of the bounds")
        choices = self.choices  # checks the metals before heads are made of them
        for name, (least, most) in self.bounds.items():
            own = self.start_value(name)
            if not least < most:
                raise InputError(f"variables.{name}", (least, most), "the least value, then the greatest")
            if not least <= own <= most:
                given = Wording(f"{show(name, least)} to {show(name, most)}")
                allowed = f"bounds that include {show(name, own)}, the value of the head"
                raise InputError(f"variables.{name}", given, allowed)
        self._check_limits()
        for choice in choices if self.hardest is not None else ():
            for part in self.family.start.parts:
                name, metal = self.family.metal(part.name, choice)
                if part.face and metal.yield_stress is None:
                    raise InputError(
                        "yield", None, f"give the yield stress of {name}, the limit of the stress in the hardest impact"
                    )
        self._check_heads()

    def _check_limits(self) -> None:
        """Raise an error for an impossible mass limit, or a volume limit on an open mesh."""
        shown = {name: ["none" if each in (0.0, math.inf) else units.show(each, QUANTITIES[name][1]) for each in ends]
                 for name, ends in self.limits.items()}  # fmt: skip
        if isinstance(self.head, DriverHead):
            made, (least, most) = self.head.target["mass"], self.limits.get("mass", (0.0, math.inf))
            if not least <= made <= most:
                allowed = f"a range that includes {units.show(made, 'g')}, the target mass of the head"
                raise InputError("limits.mass", shown["mass"], allowed)
        if "volume" in self.limits and self.family.start.volume is None:
            raise InputError("limits.volume", shown["volume"], "left out: the mesh is open and has no volume")

    def _check_heads(self) -> None:
        """Raise an error for bounds without a valid head and for impacts that miss the face, before anything runs."""
        with without_warnings():
            for name, bounds in self.bounds.items():
                for value in bounds:
                    try:
                        self.family.check(self.at(self.start(), self.choices[0], {name: value}))
                    except InputError as error:
                        allowed = f"bounds at which the head can be made ({error})"
                        raise InputError(f"variables.{name}", show(name, value), allowed) from error
            club = self.at(self.start(), self.choices[0]).mesh().club
            impacts = {"delivery": self.delivery, **({} if self.hardest is None else {"hardest": self.hardest})}
            for table, struck in impacts.items():
                for point in struck.points:
                    try:
                        impact(club, struck.at(point), ball=self.ball.rigid)
                    except ShotError as error:
                        raise ShotError(f"{table}.{error.parameter}", error.value, error.allowed) from None

    @cached_property
    def family(self) -> Family:
        """The family of heads within the bounds."""
        return family_of(self.head, self.bounds)

    @cached_property
    def choices(self) -> tuple[MetalChoice, ...]:
        """Choices of metals, each of which gets its own search."""
        return metal_choices(self.metals, self.family.groups)

    def start_value(self, name: str) -> float:
        """Return the starting head's value of a variable [SI]."""
        return self.family.value(self.head, name)

    def start(self) -> Floats:
        """Return the starting head's variables as shares of the bounds."""
        return np.array([(self.start_value(name) - low) / (high - low) for name, (low, high) in self.bounds.items()])

    def variables(self, place: Floats) -> dict[str, float]:
        """Return the variables [SI] from shares of the bounds."""
        return {name: low + float(share) * (high - low)
                for share, (name, (low, high)) in zip(place, self.bounds.items(), strict=True)}  # fmt: skip

    def at(self, place: Floats, choice: MetalChoice, own: Mapping[str, float] | None = None) -> Head:
        """Return the head at a place within the bounds, with elastic metals; ``own`` overrides variables [SI]."""
        return self.family.vary({**self.variables(place), **(own or {})}, choice)

    def goal(self, choice: MetalChoice) -> Goal:
        """Return the objective and all limits for a choice of metals."""
        limits, head = dict(self.limits), self.family.start
        if self.rules:
            for rule in rules_of(head.club):
                least, most = limits.get(rule.name, (0.0, math.inf))
                if rule.name != "volume" or head.volume is not None:
                    limits[rule.name] = (least, min(most, rule.limit))
        if self.hardest is not None:
            for name, number in face_parts(head).items():
                _, metal = self.family.metal(head.parts[number].name, choice)
                if metal.yield_stress is not None:
                    limits[name] = (0.0, metal.yield_stress / self.safety)
        return Goal(objective=self.objective, largest=OBJECTIVES[self.objective], limits=limits)


@dataclass(frozen=True, kw_only=True)
class ShellFile(_Asked):
    """A study file for a shell head."""

    golfer: Golfer | None = file_key(Reference(golfer_of), "golfer whose mean delivery is used instead", default=None)
    variables: Mapping[str, Mapping[str, Any]] = file_key(Record(VARIABLE_TABLES), "variables with their bounds")
    delivery: Mapping[str, Any] = file_key(FACE_IMPACT, "delivery, with its impact points", default_factory=dict)
    hardest: Mapping[str, Any] | None = file_key(
        FACE_IMPACT, "what differs in the hardest impact, which the face must withstand", default=None
    )

    def study(self) -> ShellStudy:
        """Return the study."""
        usual = self._delivery()
        hardest = None
        if self.hardest is not None:
            delivery = {**usual.delivery, **_delivered(self.hardest)}
            hardest = FaceImpact(delivery=delivery, points=self.hardest.get("points", usual.points))
        tables = self.variables.items()
        bounds = {f"{table}.{name}": each for table, values in tables for name, each in values.items()}
        asked = {each.name: getattr(self, each.name) for each in fields(_Asked)}
        return ShellStudy(**asked, delivery=usual, hardest=hardest, bounds=bounds)

    def _delivery(self) -> FaceImpact:
        points = self.delivery.get("points", ((0.0, 0.0),))
        values = _delivered(self.delivery)
        if self.golfer is None:
            if "speed" not in values:
                raise InputError("delivery.speed", None, "give it, or a golfer")
            return FaceImpact(delivery=values, points=points)
        for name, value in values.items():
            raise InputError(f"delivery.{name}", value, "left out: the golfer gives the delivery; keep only points")
        mean = self.golfer.for_hand(1.0).delivery()
        values = {name: getattr(mean, name) for name in DIMENSIONS if name not in ("toe", "high")}
        delivery = {name: float(each) for name, each in values.items() if each is not None}
        return FaceImpact(delivery=delivery, points=points)


def _delivered(given: Mapping[str, Any]) -> dict[str, float]:
    """Return the delivery values [SI] without the points."""
    values = {name: each for name, each in given.items() if name != "points"}
    if values:
        Delivery(**{"speed": "40 m/s", **values})
    return values


def read(path: str | os.PathLike[str]) -> ShellStudy:
    """Read a study; the files it names are relative to its folder."""
    return from_document(Document.read(path))


def from_document(document: Document) -> ShellStudy:
    """Read a study from a document."""
    file = decode(ShellFile, document)
    with Place(document).errors():
        return file.study()
