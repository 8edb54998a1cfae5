"""Studies of heads of shells: what may change, what is best, within which limits; and their TOML files.

A study of a head of shells: what may change, what is best, and within which limits.

The TOML file of a study of a head of shells, read strictly: every error names the file, the line and the key.

A study::

    title = "A face within the rules"
    head = "driver.toml"                 # a driver of walls, beside this file
    objective = "ball_speed"             # or carry, characteristic_time, wall_mass (the least)
    safety = 1.1                         # by what the yield stress is divided

    [variables.thickness]
    face_centre = ["2.4 mm", "4.2 mm"]

    [delivery]                           # or golfer = "average-driver" and points alone
    speed = "100 mph"
    loft = "12 deg"
    points = [["0 mm", "0 mm"], ["12 mm", "4 mm"]]   # to the toe, above the face centre

    [hardest]                            # what the delivery has, unless it is given
    speed = "120 mph"

    [limits]
    wall_mass = ["none", "195 g"]

    [[metals]]                           # left out: that of the head
    name = "Ti-6Al-4V"
    youngs = "114 GPa"
    poisson = 0.34
    density = "4430 kg/m3"
    yield = "880 MPa"
    source = "where the figures are from"
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.golfer import golfer as golfer_of
from clubface.design.rules import rules_of
from clubface.design.shells.goal import Goal
from clubface.errors import ClubfaceError, FileError, InputError, ShotError, UnknownNameError
from clubface.fem.balls import Ball, ball as ball_of
from clubface.fem.heads.driver import SHAPE, WALLS, DriverHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.read import FOLDER, from_toml
from clubface.simulation.impact import impact
from clubface.simulation.inputs import DIMENSIONS, Delivery
from clubface.support.checks import check_choice, check_count, check_names, without_warnings
from clubface.support.files import beside, path_of
from clubface.support.strict_toml import Document

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


OPEN = "none"
"""The word for a limit that is not there."""
KEYS = ("title", "head", "objective", "golfer", "ball", "safety", "rules", "designs", "radius", "neighbours",
        "variables", "delivery", "hardest", "limits", "metals")  # fmt: skip
TABLES = ("variables", "delivery", "hardest", "limits")
METAL = ("name", "source", "youngs", "poisson", "density", "yield")
MOST_POINTS = 100


def read(path: str | os.PathLike[str]) -> ShellStudy:
    """Read a study; files that it names are looked for beside it."""
    return from_document(Document.read(path), Path(os.fspath(path)).parent)


def from_document(document: Document, folder: Path) -> ShellStudy:
    """Read a study from a document."""
    data = document.data
    document.check_keys(data, KEYS, ("title", "head", "objective", "variables"))
    document.check_text(data, ("title", "head", "objective", "golfer", "ball"))
    for name in TABLES:
        if not isinstance(data.get(name, {}), dict):
            raise document.error(f"{name} must be a table", name)
    for name in ("rules", "neighbours"):
        if not isinstance(data.get(name, True), bool):
            raise document.error(f"{name} must be true or false, not {data[name]!r:.40}", name)
    try:
        delivery = _delivery(document, folder)
        found: dict[str, Any] = {name: data[name] for name in ("rules", "neighbours", "designs") if name in data}
        for name in ("safety", "radius"):
            if name in data:
                found[name] = units.parse(data[name], units.DIMENSIONLESS, name=name)
        if "ball" in data:
            found["ball"] = ball_of(beside(data["ball"], folder))
        return ShellStudy(
            title=data["title"], head=_head(document, folder), objective=data["objective"], bounds=_variables(document),
            delivery=delivery, hardest=_hardest(document, delivery) if "hardest" in data else None,
            limits=_limits(document),
            metals=_metals(document), **found,
        )  # fmt: skip
    except FileError:
        raise
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _head(document: Document, folder: Path) -> DriverHead:
    try:
        head = from_toml(path_of("head of finite elements", beside(document.data["head"], folder), FOLDER))
    except ClubfaceError as error:
        raise document.error(f"head: {error}", "head") from error
    if not isinstance(head, DriverHead):
        raise document.error(f'head must be of the kind "driver", whose walls can vary; {head.name} is another', "head")
    return head


def _variables(document: Document) -> dict[str, tuple[float, float]]:
    given = document.data["variables"]
    for name in given:
        if name not in ("thickness", "shape"):
            told = UnknownNameError("table of variables", name, ("thickness", "shape"))
            raise document.error(str(told), "", f"variables.{name}")
    found = {}
    for table, known in (("thickness", WALLS), ("shape", SHAPE)):
        values = given.get(table, {})
        if not isinstance(values, dict):
            raise document.error(f"variables.{table} must be a table: [variables.{table}]", table, "variables")
        document.check_keys(values, known, (), f"variables.{table}")
        for name, each in values.items():
            place, dimension = f"variables.{table}.{name}", "angle" if name == "loft" else "length"
            if not (isinstance(each, list) and len(each) == 2):
                raise InputError(place, each, 'two values, least and greatest, as in ["2.4 mm", "4.2 mm"]')
            low, high = (units.parse(side, dimension, name=place) for side in each)
            found[f"{table}.{name}"] = (low, high)
    return found


def _limits(document: Document) -> dict[str, tuple[float, float]]:
    given = document.data.get("limits", {})
    document.check_keys(given, [each for each in QUANTITIES if each != "stress"], (), "limits")
    return {name: _limit(name, each) for name, each in given.items()}


def _limit(name: str, given: Any) -> tuple[float, float]:
    place, dimension = f"limits.{name}", QUANTITIES[name][1]
    if not (isinstance(given, list) and len(given) == 2):
        raise InputError(place, given, f'two values, least and greatest, as in ["{OPEN}", "..."]; "{OPEN}" is no limit')
    low, high = (
        side if each == OPEN else units.parse(each, dimension, name=place)
        for each, side in zip(given, (0.0, math.inf), strict=True)
    )
    if not 0.0 <= low < high or (low, high) == (0.0, math.inf):
        raise InputError(place, given, f'the least value, then a greater one; "{OPEN}" is no limit')
    return low, high


def _delivery(document: Document, folder: Path) -> Blow:
    data = document.data
    given = dict(data.get("delivery", {}))
    points = _points("delivery", given.pop("points", None)) or ((0.0, 0.0),)
    if "golfer" not in data:
        return Blow(delivery=_values(document, given, "delivery", ("speed",)), points=points)
    if given:
        raise InputError(f"delivery.{next(iter(given))}", next(iter(given.values())),
                         "left out: the golfer delivers; give points alone")  # fmt: skip
    mean = golfer_of(beside(data["golfer"], folder)).for_hand(1.0).delivery()
    values = {name: getattr(mean, name) for name in DIMENSIONS if name not in ("toe", "high")}
    return Blow(delivery={name: float(value) for name, value in values.items() if value is not None}, points=points)


def _hardest(document: Document, usual: Blow) -> Blow:
    given = dict(document.data["hardest"])
    points = _points("hardest", given.pop("points", None)) or usual.points
    return Blow(delivery={**usual.delivery, **_values(document, given, "hardest", ())}, points=points)


def _values(document: Document, given: Mapping[str, Any], table: str, required: tuple[str, ...]) -> dict[str, float]:
    """Return the values of a delivery [SI]; where it strikes is told by points."""
    known = [name for name in DIMENSIONS if name not in ("toe", "high")]
    document.check_keys(dict(given), known, required, table)
    values = {name: units.parse(each, DIMENSIONS[name], name=f"{table}.{name}") for name, each in given.items()}
    if values:
        try:
            Delivery(**{"speed": "40 m/s", **values})
        except InputError as error:
            raise document.wrap(error, table) from error
    return values


def _points(table: str, given: Any) -> tuple[tuple[float, float], ...] | None:
    if given is None:
        return None
    wanted = f'1 to {MOST_POINTS} points, each to the toe and above the face centre, as in [["0 mm", "0 mm"]]'
    if not (isinstance(given, list) and 1 <= len(given) <= MOST_POINTS):
        raise InputError(f"{table}.points", given, wanted)
    found = []
    for each in given:
        if not (isinstance(each, list) and len(each) == 2):
            raise InputError(f"{table}.points", given, wanted)
        toe, high = (units.parse(value, "length", name=f"{table}.points") for value in each)
        if max(abs(toe), abs(high)) > 0.06:
            raise InputError(f"{table}.points", each, "within 60 mm of the face centre")
        found.append((toe, high))
    return tuple(found)


def _metals(document: Document) -> tuple[NamedMetal, ...]:
    given = document.data.get("metals", [])
    if not (isinstance(given, list) and all(isinstance(each, dict) for each in given)):
        raise document.error("metals must be tables, each under [[metals]]", "metals")
    found: list[NamedMetal] = []
    for place, each in enumerate(given):
        document.check_keys(each, METAL, ("name", "youngs", "poisson", "density"), "metals", place)
        document.check_text(each, ("name", "source"), "metals", place)
        if each["name"] in [other.name for other in found]:
            raise document.error(f"name: {each['name']!r} is taken; every metal needs its own", "name", "metals", place)
        values = {name: each[name] for name in ("youngs", "poisson", "density") if name in each}
        try:
            metal = Metal(**values, yield_stress=each.get("yield"))
        except InputError as error:
            raise document.wrap(error, "metals", place) from error
        found.append(NamedMetal(name=each["name"], metal=metal, source=each.get("source", "")))
    return tuple(found)
