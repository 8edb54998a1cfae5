"""Studies of optima: what may change, what is best, for whom, within which limits; and their TOML files.

A study: what may change, what is best, for whom, and within which limits.

The TOML file of a study or a fitting, read strictly: every error names the file, the line and the key.

A study::

    title = "A driver for bogey golf"
    club = "driver"
    golfer = "bogey-driver"
    objective = "strokes"                # or two of them, for the front between both

    [hole]
    length = "400 yd"

    [variables]
    loft = ["8 deg", "14 deg"]
    bulge = ["200 mm", "500 mm"]
    mass_distribution = "free"           # or bounds of single mass properties

    [head]                               # where its mass may be, seen from the face centre
    size = ["115 mm", "62 mm", "124 mm"] # face to back, sole to crown, heel to toe
    centre = ["-55 mm", "2 mm", "3 mm"]
    volume = "460 cm3"
    discretionary_mass = "30 g"

    [limits]
    side_spread = ["none", "25 yd"]
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, SHAPES, Envelope, Volume, of_club, pseudo_inertia, room_inside
from clubface.design.golfer import golfer as golfer_of
from clubface.design.optimisation.fitting import SETTINGS, Fitting
from clubface.design.optimisation.landings import (
    DEFAULT_SETTING,
    FREE,
    OBJECTIVES,
    SPEED_EXPONENT,
    Landings,
    Objective,
    Setting,
    objective,
    objectives,
    own_value,
)
from clubface.design.optimisation.limits import Buildable, FieldLimit, ShotLimit
from clubface.design.optimisation.solve import Limit, Problem
from clubface.design.optimisation.variables import Variables, check_bounds
from clubface.design.rules import check_rules, rules_of
from clubface.design.strokes import Hole
from clubface.equipment.balls import ball as ball_of
from clubface.equipment.clubs import CLUB_PROPERTIES, Club, club as club_of
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError, Told
from clubface.fem.heads.meshed import mesh_of
from clubface.simulation.flight import check_conditions
from clubface.support.checks import check_choice, check_count, check_names
from clubface.support.files import beside
from clubface.support.strict_toml import Document

if TYPE_CHECKING:
    from clubface.design.golfer import Golfer


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


OPEN = "none"
"""The word for a limit that is not there."""
COUNTS = {"shots": (1, MOST_SHOTS), "seed": (0, 2**31), "starts": (1, 1000), "points": (3, 200)}
"""Least and greatest value of what is counted."""
JUDGED = {**{name: each.dimension for name, each in OBJECTIVES.items()}, "strokes": units.DIMENSIONLESS}
_COMMON = ("title", "golfer", "objective", "model", "shots", "seed", "hole", "air", "wind", "ground")
_STUDY = (*_COMMON, "club", "ball", "starts", "points", "variables", "head", "limits", "rules", "mass")
_FIT = (*_COMMON, "fit")


OTHERS = {
    "cg_x": ("a club", 'a study of its own names it, as in club = "my-driver.toml"'),
    "study": ("a study of many runs", "clubface study run reads it"),
    "metals": ("a study of a head of shells", "clubface fem design reads it"),
}
"""What other files are, by a key that only they have, and what to do with them."""


def read(path: str | os.PathLike[str]) -> DesignStudy | Fitting:
    """Read a study, or a fitting if the file has a table ``[fit]``; files that it names are looked for beside it."""
    return from_document(Document.read(path), Path(path).parent)


def design_study(given: DesignStudy | str | os.PathLike[str]) -> DesignStudy:
    """Return a study, or that of a file; the file of a fitting is an :class:`InputError`."""
    if isinstance(given, DesignStudy):
        return given
    found = read(given)
    if isinstance(found, Fitting):
        raise InputError("study", given, "a study with variables; fit takes a fitting, which has a table [fit]")
    return found


def fitting(given: Fitting | str | os.PathLike[str]) -> Fitting:
    """Return a fitting, or that of a file; the file of a study is an :class:`InputError`."""
    if isinstance(given, Fitting):
        return given
    found = read(given)
    if isinstance(found, DesignStudy):
        raise InputError("fitting", given, "one with a table [fit]; optimise takes a study, which has variables")
    return found


def from_text(text: str) -> DesignStudy | Fitting:
    """Read the same from text; files that it names are looked for in the current folder."""
    return from_document(Document(text), Path())


def from_document(document: Document, folder: Path) -> DesignStudy | Fitting:
    """Read the same from a document, whose files are looked for in a folder."""
    data = document.data
    for key, (what, advice) in OTHERS.items():
        if key in data:
            raise document.error(f"this is {what}; {advice}", key)
    fits = "fit" in data
    required = ("title", "golfer", "objective", *(() if fits else ("club", "variables")))
    document.check_keys(data, _FIT if fits else _STUDY, required)
    document.check_text(data, ("title", "club", "ball", "model"))
    for name in ("hole", "air", "variables", "head", "limits", "rules", "mass", "fit"):
        if name in data and not isinstance(data[name], dict):
            raise document.error(f"{name} must be a table", name)
    try:
        common = _common(document, folder)
        return _fitting(document, common, folder) if fits else _study(document, common, folder)
    except InputError as error:
        raise document.wrap(error) from error


def _common(document: Document, folder: Path) -> dict[str, Any]:
    data = document.data
    found: dict[str, Any] = {"title": data["title"], "golfers": golfers_of(_golfers(document, folder))}
    if "hole" in data:
        document.check_keys(data["hole"], tuple(Hole.__dataclass_fields__), ("length",), "hole")
        found["hole"] = Hole(**data["hole"])
    for name, limits in COUNTS.items():
        if name in data:
            found[name] = check_count(name, data[name], *limits)
    model = data.get("model", DEFAULT_MODEL)
    reduced_model(model, "one with derivatives")
    flown: dict[str, Any] = {name: data.get(name) for name in ("air", "wind", "ground")}
    check_conditions(**flown)
    mass = data.get("mass", {})
    document.check_keys(mass, ("speed_exponent",), (), "mass")
    exponent = mass.get("speed_exponent", SPEED_EXPONENT)
    if isinstance(exponent, bool) or not isinstance(exponent, int | float) or not 0.0 <= exponent <= 1.0:
        raise InputError("mass.speed_exponent", exponent, "a number from 0 to 1")
    ball = ball_of(beside(data["ball"], folder)) if "ball" in data else None
    found["setting"] = Setting(model=model, ball=ball, speed_exponent=float(exponent), **flown)
    return found


def _golfers(document: Document, folder: Path) -> Any:
    given = document.data["golfer"]
    if isinstance(given, str):
        return beside(given, folder)
    if not (isinstance(given, list) and given and all(isinstance(each, dict) for each in given)):
        raise document.error("golfer must be a name, a file, or tables [[golfer]] with name and weight", "golfer")
    for place, each in enumerate(given):
        document.check_keys(each, ("name", "weight"), ("name",), "golfer", place)
        document.check_text(each, ("name",), "golfer", place)
        weight = each.get("weight", 1.0)
        if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0.0 < weight < math.inf:
            raise document.error(f"weight must be a positive number, not {weight!r:.40}", "weight", "golfer", place)
    return [{**each, "name": beside(each["name"], folder)} for each in given]


def _study(document: Document, common: dict[str, Any], folder: Path) -> DesignStudy:
    data = document.data
    given = data["objective"]
    objectives = tuple(given) if isinstance(given, list) else (given,)
    if not 1 <= len(objectives) <= 2 or len(set(map(str, objectives))) < len(objectives):
        raise InputError("objective", given, "one objective, or a list of two different ones")
    for name in objectives:
        check_choice("objective", name, JUDGED)
    if len(objectives) == 1 and "points" in data:
        raise InputError("points", data["points"], "leave it out; it is for the front between two objectives")
    variables = dict(data["variables"])
    distributed = _is_distributed(variables)
    bounds = {
        name: _bounds(f"variables.{name}", each, DIMENSIONS, name, open_=False) for name, each in variables.items()
    }
    if distributed:
        own = [name for name in bounds if name in MASS_PROPERTIES and name != "mass"]
        if own:
            raise InputError(f"variables.{own[0]}", variables[own[0]], f"under [limits], since {DISTRIBUTION} is free")
    known = {**DIMENSIONS, **JUDGED}
    limits = {}
    for name, each in data.get("limits", {}).items():
        check_choice("limit", name, (*FREE, *JUDGED))
        limits[name] = _bounds(f"limits.{name}", each, known, name, open_=True)
    rules = data.get("rules", {})
    document.check_keys(rules, ("conform", "tolerance"), (), "rules")
    for name, each in rules.items():
        if not isinstance(each, bool):
            raise InputError(f"rules.{name}", each, "true or false")
    return DesignStudy(
        **common, club=club_of(beside(data["club"], folder)), objectives=objectives, bounds=bounds,
        distributed=distributed, head=_head(document) if "head" in data else None, limits=limits, **rules,
    )  # fmt: skip


def _is_distributed(variables: dict[str, Any]) -> bool:
    """Take the word that frees the whole distribution of mass from the variables."""
    known = (*FREE, DISTRIBUTION)
    check_names("variable", variables, known)
    if DISTRIBUTION not in variables:
        return False
    word = variables.pop(DISTRIBUTION)
    check_choice(f"variables.{DISTRIBUTION}", word, ("free",))
    return True


def _bounds(place: str, given: Any, dimensions: Mapping[str, str], name: str, *, open_: bool) -> tuple[float, float]:
    """Return the least and the greatest of two values with units; with ``open_`` either may be missing."""
    example = 'two values, least and greatest, as in ["8 deg", "14 deg"]' + (f'; "{OPEN}" is no limit' if open_ else "")
    if not (isinstance(given, list) and len(given) == 2):
        raise InputError(place, given, example)
    found = [
        side if open_ and each == OPEN else units.parse(each, dimensions[name], name=place)
        for each, side in zip(given, (-math.inf, math.inf), strict=True)
    ]
    if not found[0] < found[1] or found == [-math.inf, math.inf]:
        raise InputError(place, given, example)
    if not open_ and name in ("mass", "bulge", "roll", "ixx", "iyy", "izz") and found[0] <= 0.0:
        raise InputError(place, given, "above 0 at both ends")
    return found[0], found[1]


def _vector(place: str, given: Any) -> tuple[float, float, float]:
    if not (isinstance(given, list) and len(given) == 3):
        raise InputError(place, given, 'three lengths, as in ["115 mm", "62 mm", "124 mm"]')
    one, two, three = (units.parse(each, "length", name=place) for each in given)
    return one, two, three


def _head(document: Document) -> Head:
    given = document.data["head"]
    known = ("shape", "size", "centre", "volume", "discretionary_mass", "shell")
    document.check_keys(given, known, ("size", "centre", "discretionary_mass"), "head")
    shape = given.get("shape", "box")
    check_choice("head.shape", shape, SHAPES)
    volume = Volume(
        shape=shape, centre=_vector("head.centre", given["centre"]), size=_vector("head.size", given["size"])
    )
    displaced = units.parse(given["volume"], "volume", name="head.volume") if "volume" in given else None
    if displaced is not None and displaced <= 0.0:
        raise InputError("head.volume", given["volume"], "above 0")
    budget = units.parse(given["discretionary_mass"], "mass", name="head.discretionary_mass")
    if not 0.0 < budget < 1.0:
        raise InputError("head.discretionary_mass", given["discretionary_mass"], "between 0 and 1 kg")
    shell = None
    if "shell" in given:
        document.check_keys(given["shell"], MASS_PROPERTIES, MASS_PROPERTIES, "head.shell")
        shell = tuple(
            units.parse(given["shell"][name], DIMENSIONS[name], name=f"head.shell.{name}") for name in MASS_PROPERTIES
        )
    return Head(volume=volume, discretionary=budget, displaced=displaced, shell=shell)


def _fitting(document: Document, common: dict[str, Any], folder: Path) -> Fitting:
    data, given = document.data, document.data["fit"]
    if not isinstance(data["objective"], str):
        raise InputError("objective", data["objective"], "one objective")
    check_choice("objective", data["objective"], JUDGED)
    document.check_keys(given, ("clubs", "balls", "setting", "loft", "lie"), ("clubs",), "fit")
    bounds = {
        name: _bounds(f"fit.{name}", given[name], DIMENSIONS, name, open_=False)
        for name in ("loft", "lie")
        if name in given
    }
    settings, described = {}, given.get("setting", [])
    for each in described if isinstance(described, list) else [described]:
        if not isinstance(each, dict) or not isinstance(each.get("name"), str):
            raise InputError("fit.setting", str(each)[:60], 'tables [[fit.setting]], each with its name: name = "back"')
        check_names("change of a setting", [name for name in each if name != "name"], SETTINGS)
        if each["name"] in settings:
            raise InputError("fit.setting", each["name"], "a name that no other setting has")
        settings[each["name"]] = {
            name: units.parse(value, DIMENSIONS[name], name=f"setting.{name}")
            for name, value in each.items()
            if name != "name"
        }
    clubs = tuple(club_of(beside(each, folder)) for each in _texts("fit.clubs", given["clubs"]))
    balls: tuple[Any, ...] = (None,)
    if "balls" in given:
        balls = tuple(ball_of(beside(each, folder)) for each in _texts("fit.balls", given["balls"]))
    kept = {name: each for name, each in common.items() if name not in ("starts", "points")}
    return Fitting(**kept, objective=data["objective"], clubs=clubs, balls=balls, settings=settings, bounds=bounds)


def _texts(place: str, given: Any) -> list[str]:
    if not (isinstance(given, list) and given and all(isinstance(each, str) for each in given)):
        raise InputError(place, given, "a list of names or files")
    return given
