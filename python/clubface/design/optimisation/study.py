"""Optimisation studies: variables, objective, golfers and limits; and their TOML files.

``examples/better_driver.toml`` is a study; :class:`StudyFile` and :class:`FittingFile` describe every key.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, SHAPES, Envelope, Volume, of_club, pseudo_inertia, room_inside
from clubface.design.golfer import golfer as golfer_of
from clubface.design.optimisation.advice import WORTH, AdvisedStudy
from clubface.design.optimisation.fitting import SETTINGS, Fitting
from clubface.design.optimisation.landings import (
    FREE,
    JUDGED,
    SPEED_EXPONENT,
    Landings,
    Objective,
    Setting,
    own_value,
)
from clubface.design.optimisation.solve import Buildable, Limit, Problem, RangeLimit
from clubface.design.optimisation.variables import Variables, check_bounds
from clubface.design.rules import check_rules
from clubface.design.strokes import Hole
from clubface.equipment.balls import Ball, ball as ball_of
from clubface.equipment.clubs import CLUB_PROPERTIES, Club, club as club_of
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.equipment.rules import Rule, RuleVerdict, rules_of
from clubface.errors import FileError, InputError, Wording
from clubface.fem.heads.meshed import mesh_of
from clubface.quantities import Quantity, Reading, quantity as quantity_named
from clubface.schema.document import Document, Place
from clubface.schema.tables import Table, decode, file_key
from clubface.schema.values import (
    FLAG,
    NAME,
    TEXT,
    Choice,
    Either,
    Interval,
    Items,
    PhysicalValue,
    Record,
    Reference,
    Simple,
    Tables,
    count,
)
from clubface.simulation.flight import check_conditions

__all__ = ["DesignStudy", "FittingFile", "Head", "StudyFile", "from_text", "read"]

MOST_SHOTS = 100_000
DEFAULT_POINTS = 9
DISTRIBUTION = "mass_distribution"
"""The key among the variables that frees the whole mass distribution."""
UNITS = {**{name: each.unit for name, each in CLUB_PROPERTIES.items()}, "lie": "deg"}
RULED = {"iyy": "moment_of_inertia", "characteristic_time": "characteristic_time"}
"""Club fields limited by the rules, with the names of the rules."""


def shown_quantity(name: str, unit: str) -> Quantity:
    """Return a quantity shown in a unit with four significant digits."""
    si = units.SI_UNITS[units.unit(unit).dimension]
    return quantity_named(name, si)._replace(golf=Reading(unit, 4))


def field_quantity(field: str) -> Quantity:
    """Return the quantity of a club field, in the unit used in studies."""
    return shown_quantity({"loft": "static_loft"}.get(field, field), UNITS[field])._replace(label=field)


@dataclass(frozen=True, kw_only=True)
class Head:
    """Limits on the head.

    Attributes
    ----------
    volume
        Where its mass may be.
    discretionary, displaced
        Maximum discretionary mass [kg]; volume of the head as the rules measure it [m3], or None.
    shell
        Mass properties of the fixed part in the order of ``MASS_PROPERTIES`` [SI]; None for the base club made
        uniformly lighter by the discretionary mass.
    """

    volume: Volume
    discretionary: float
    displaced: float | None = None
    shell: tuple[float, ...] | None = None

    def envelope(self, base: Club) -> Envelope:
        """Return volume, shell and budget for a base club; with a mesh, discretionary mass must lie inside it."""
        if self.shell is not None:
            fixed = pseudo_inertia(np.array(self.shell))
        else:
            if not 0.0 < self.discretionary < base.mass:
                problem = units.show(self.discretionary, "g")
                raise InputError("discretionary_mass", problem, f"between 0 and the mass of {base.name}")
            fixed = pseudo_inertia(of_club(base)) * (1.0 - self.discretionary / base.mass)
        mesh = mesh_of(base)
        room = self.volume if mesh is None else room_inside(mesh.places, self.volume)
        return Envelope(volume=room, shell=fixed, budget=self.discretionary, whole=self.volume)


@dataclass(frozen=True, kw_only=True)
class DesignStudy(AdvisedStudy):
    """Variables, objectives, golfers and limits of an optimisation.

    Attributes
    ----------
    title
        Name in reports.
    club
        The starting club, with which the golfers' deliveries were made.
    golfers
        Golfers with weights.
    objectives
        Names of one objective, or of two for a Pareto front.
    bounds, distributed
        Lower and upper bound of every variable field [SI], and whether the whole mass distribution is free.
    head
        Limits on the head; needed if a mass property changes.
    limits
        Lower and upper limit of fields and objectives [SI]; infinite for none.
    conform, tolerance
        Whether the rules of golf are limits, and whether their tolerances may be used.
    hole, setting
        The hole for expected strokes; model, ball and air.
    shots, seed, starts, points
        Shots per golfer, seed of shots and starts, solver starts, points of a front.
    worth
        The smallest difference worth a change, by objective [SI]; default ``WORTH``.
    """

    club: Club
    objectives: tuple[str, ...]
    bounds: Mapping[str, tuple[float, float]]
    distributed: bool = False
    head: Head | None = None
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    conform: bool = True
    tolerance: bool = True
    starts: int = 8
    points: int = DEFAULT_POINTS

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.bounds and not self.distributed:
            raise InputError("variables", None, "at least one of " + ", ".join((*FREE, DISTRIBUTION)))
        for name in (*self.objectives, *(each for each in self.limits if each not in FREE)):
            self.objective(name)
        if self.moves_mass and self.head is None:
            problem = "give [head] with size, centre and discretionary_mass, since mass properties change"
            raise InputError("head", None, problem)
        for name in self.limits:
            if name in FREE and name not in self.variables.fields:
                raise InputError(f"limits.{name}", Wording("given"), f"leave it out, since {name} does not change")
        check_bounds(self.club, self.bounds, "variables")
        self._check_fixed_rules()

    @property
    def moves_mass(self) -> bool:
        """Whether a mass property changes."""
        return self.distributed or any(name in MASS_PROPERTIES for name in self.bounds)

    @property
    def limits_shots(self) -> bool:
        """Whether there are limits on the shots, which the best club for the mean delivery ignores."""
        return any(each not in FREE for each in self.limits)

    @property
    def variables(self) -> Variables:
        """The optimiser's variables."""
        envelope = self.head.envelope(self.club) if self.head is not None and self.moves_mass else None
        return Variables(base=self.club, bounds=self.bounds, envelope=envelope, distributed=self.distributed)

    @property
    def present(self) -> Club:
        """The starting club."""
        return self.club

    @property
    def purpose(self) -> str:
        """The first objective."""
        return self.objectives[0]

    def objective(self, name: str) -> Objective:
        """Return an objective of the study by name."""
        return self.judge(name)

    def landings(self, shots: int, *, seed: int) -> list[tuple[Landings, float]]:
        """Return shots and weight of every golfer."""
        samples = self.samples(shots, seed)
        return [(Landings(self.club, deliveries, self.setting), weight) for deliveries, weight in samples]

    def mean_shots(self) -> list[tuple[Landings, float]]:
        """Return the mean delivery of every golfer as a single shot, and the golfer's weight."""
        result = []
        for each, weight in self.golfers:
            own = each.for_hand(self.club.hand)
            mean = {name: np.array([value]) for name, value in zip(own.variables, own.mean, strict=True)}
            result.append((Landings(self.club, mean, self.setting), weight))
        return result

    def problem(
        self,
        golfers: list[tuple[Landings, float]],
        objective: str,
        *,
        limits: tuple[RangeLimit, ...] = (),
        others: tuple[Objective, ...] = (),
    ) -> Problem:
        """Return the problem for an objective, with extra ``limits``; ``others`` are objectives computed as well."""
        asked = [*(self.shot_limit(name, *each) for name, each in self.limits.items() if name not in FREE), *limits]
        known = [*(self.judge(each.limited) for each in asked), *others]
        return Problem(self.variables, golfers, self.objective(objective), [*self.design_limits(), *asked], known)

    def design_limits(self) -> list[Limit]:
        """Return the limits on the club, without those on the shots."""
        turned, limits = self.variables, []
        if turned.envelope is not None:
            limits.append(
                Buildable(
                    self.club, turned.envelope, turned.fields, distributed=self.distributed,
                    mass_changes="mass" in self.bounds,
                )
            )  # fmt: skip
        ruled = {rule: name for name, rule in RULED.items() if name in turned.fields}
        for rule in rules_of(self.club) if self.conform else ():
            if rule.name in ruled:
                name = ruled[rule.name]
                limits.append(self._field_limit(name, -math.inf, self._rule_limit(rule), f"rules: {rule.title}"))
        limits += [self._field_limit(name, *each, name) for name, each in self.limits.items() if name in FREE]
        return limits

    def shot_limit(self, name: str, least: float, most: float) -> RangeLimit:
        """Return the limits of an objective [SI]."""
        judge = self.judge(name)
        return RangeLimit(name=judge.meaning, limited=name, least=least, most=most, unit=judge.unit)

    def _field_limit(self, name: str, least: float, most: float, called: str) -> RangeLimit:
        finite = [abs(each) for each in (least, most) if math.isfinite(each)]
        size = max([*finite, abs(own_value(self.club, name)), 1e-12])
        return RangeLimit(name=called, limited=name, least=least, most=most, unit=UNITS[name], size=size)

    def _rule_limit(self, rule: Rule) -> float:
        return rule.limit if self.tolerance else rule.most

    def rule_values(self, club: Club) -> list[RuleVerdict]:
        """Return a club's verdicts for every rule, with volume and size of its mesh or of the study's head."""
        volume, size = (None, None) if self.head is None else (self.head.displaced, self.head.volume.size)
        if (mesh := mesh_of(self.club)) is not None:
            volume, size = mesh.volume or volume, mesh.size
        return check_rules(club, volume=volume, size=size)

    def _check_fixed_rules(self) -> None:
        if not self.conform:
            return
        changing = {RULED[name] for name in self.variables.fields if name in RULED}
        for each in self.rule_values(self.club):
            limit = self._rule_limit(each.rule)
            if each.rule.name not in changing and each.value > limit * (1.0 + 1e-9):
                problem = units.show(each.value, each.rule.unit, 4)
                allowed = f"at most {units.show(limit, each.rule.unit, 4)} by the rules, and no variable changes it"
                raise InputError(each.rule.title, problem, f"{allowed}; or give conform = false under [rules]")


COUNTS = {"shots": (1, MOST_SHOTS), "seed": (0, 2**31), "starts": (1, 1000), "points": (3, 200)}
"""Smallest and largest value of each count."""
POSITIVE = ("mass", "bulge", "roll", "ixx", "iyy", "izz")
"""Fields that must be positive."""


def _bounds(name: str) -> Interval:
    """Return the schema of a variable field's bounds."""
    return Interval(PhysicalValue(UNITS[name], above=0 if name in POSITIVE else None))


VARIABLES = Record({**{name: _bounds(name) for name in FREE}, DISTRIBUTION: Choice(("free",))})
LIMITS = Record(
    {
        name: Interval(PhysicalValue(unit), no_limits=(-math.inf, math.inf))
        for name, unit in ({name: UNITS[name] for name in FREE} | JUDGED).items()
    }
)
NAMED_GOLFERS = Either(
    {
        str: Reference(str),
        list: Tables(Record({"name": Reference(str), "weight": PhysicalValue("1", above=0)}, ("name",)), least=1),
    },
    "a name, a file, or tables [[golfer]] with name and weight",
)
VECTOR = Items(PhysicalValue("mm"), 3, 3, 'three lengths, as in ["115 mm", "62 mm", "124 mm"]')
WORTHS = Record({name: PhysicalValue(JUDGED[name], above=0) for name in WORTH}, example='{ carry = "3 yd" }')
RULES = Record({"conform": FLAG, "tolerance": FLAG})
SETTING = Record({"name": NAME, **{name: PhysicalValue(UNITS[name]) for name in SETTINGS}}, ("name",))
_NAMES = "a list of names or files"


@dataclass(frozen=True, kw_only=True)
class HeadTable:
    """Limits on the head, relative to the face centre."""

    shape: str = file_key(Choice(SHAPES), "shape of the space for mass", default="box")
    size: tuple[float, float, float] = file_key(VECTOR, "face to back, sole to crown, heel to toe")
    centre: tuple[float, float, float] = file_key(VECTOR, "centre: towards the target, up, towards the toe")
    volume: float | None = file_key(PhysicalValue("cm3", above=0), "volume as the rules measure it", default=None)
    discretionary_mass: float = file_key(
        PhysicalValue("kg", above=0, below=1, allowed="between 0 and 1 kg"), "maximum discretionary mass"
    )
    shell: Mapping[str, float] | None = file_key(
        Record({name: PhysicalValue(UNITS[name]) for name in MASS_PROPERTIES}, MASS_PROPERTIES),
        "mass properties of the fixed part; default: the club made uniformly lighter", default=None,
    )  # fmt: skip

    def head(self) -> Head:
        """Return the head."""
        volume = Volume(shape=self.shape, centre=self.centre, size=self.size)
        shell = None if self.shell is None else tuple(self.shell.values())
        return Head(volume=volume, discretionary=self.discretionary_mass, displaced=self.volume, shell=shell)


@dataclass(frozen=True, kw_only=True)
class FitTable:
    """The parts of a fitting."""

    clubs: tuple[Club, ...] = file_key(Items(Reference(club_of), 1, allowed=_NAMES), "heads")
    balls: tuple[Ball | None, ...] = file_key(Items(Reference(ball_of), 1, allowed=_NAMES), "balls", default=(None,))
    setting: tuple[Mapping[str, Any], ...] = file_key(
        Tables(SETTING), "settings of the hosel or of weights: name and changes", default=()
    )
    loft: tuple[float, float] | None = file_key(_bounds("loft"), "range of change of loft", default=None)
    lie: tuple[float, float] | None = file_key(_bounds("lie"), "range of change of lie", default=None)


@dataclass(frozen=True, kw_only=True)
class CommonFile:
    """Keys common to study and fitting files."""

    title: str = file_key(TEXT, "name in reports")
    golfer: Any = file_key(NAMED_GOLFERS, "golfers: a name, a file, or tables [[golfer]] with name and weight")
    model: str = file_key(TEXT, "impact model, which must have derivatives", default=DEFAULT_MODEL)
    shots: int = file_key(count(*COUNTS["shots"]), "shots per golfer", default=10_000)
    seed: int = file_key(count(*COUNTS["seed"]), "seed of shots and starts", default=1)
    hole: Hole | None = file_key(Table(Hole), "hole for the objective `strokes`", default=None)
    air: Any = file_key(Record(Simple()), "conditions of the flight", default=None)
    wind: Any = file_key(Simple(), "conditions of the flight", default=None)
    ground: Any = file_key(Simple(), "conditions of the flight", default=None)
    worth: Mapping[str, float] = file_key(
        WORTHS, "the smallest difference worth a change, by objective", default_factory=dict
    )

    def common(self, **setting: Any) -> dict[str, Any]:
        """Return the arguments common to studies and fittings."""
        reduced_model(self.model, "one with derivatives")
        flown = {"air": self.air, "wind": self.wind, "ground": self.ground}
        check_conditions(**flown)
        given = [{"name": self.golfer}] if isinstance(self.golfer, str) else self.golfer
        golfers = tuple((golfer_of(each["name"]), float(each.get("weight", 1.0))) for each in given)
        return {
            "title": self.title, "golfers": golfers, "shots": self.shots, "seed": self.seed,
            "hole": self.hole, "worth": self.worth, "setting": Setting(model=self.model, **setting, **flown),
        }  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class StudyFile(CommonFile):
    """A study file for an optimisation."""

    objective: tuple[str, ...] = file_key(
        Either(
            {str: Choice(tuple(JUDGED)), list: Items(Choice(tuple(JUDGED)), 1, 2)},
            "one objective, or a list of two different ones",
        ),
        "objective, or two objectives for a Pareto front",
    )
    club: Club = file_key(Reference(club_of), "starting club")
    ball: Ball | None = file_key(Reference(ball_of), "the ball", default=None)
    starts: int = file_key(count(*COUNTS["starts"]), "number of solver starts", default=8)
    points: int | None = file_key(count(*COUNTS["points"]), "number of points on a Pareto front", default=None)
    variables: Mapping[str, Any] = file_key(VARIABLES, 'variables with their bounds; `mass_distribution = "free"`')
    head: HeadTable | None = file_key(Table(HeadTable), "limits on the head", default=None)
    limits: Mapping[str, tuple[float, float]] = file_key(
        LIMITS, "limits of fields and objectives", default_factory=dict
    )
    rules: Mapping[str, bool] = file_key(RULES, "whether the rules are limits, with tolerances", default_factory=dict)
    mass: Mapping[str, float] = file_key(
        Record({"speed_exponent": PhysicalValue("1", 0, 1, allowed="a number from 0 to 1")}),
        "speed falls as mass to the power `speed_exponent`", default_factory=dict,
    )  # fmt: skip

    def study(self) -> DesignStudy:
        """Return the study."""
        objectives = (self.objective,) if isinstance(self.objective, str) else self.objective
        if len(set(objectives)) < len(objectives):
            raise InputError("objective", list(objectives), "one objective, or a list of two different ones")
        if len(objectives) == 1 and self.points is not None:
            raise InputError("points", self.points, "leave it out; it is for a front between two objectives")
        bounds = {name: each for name, each in self.variables.items() if name != DISTRIBUTION}
        distributed = DISTRIBUTION in self.variables
        own = [name for name in bounds if distributed and name in MASS_PROPERTIES and name != "mass"]
        if own:
            raise InputError(
                f"variables.{own[0]}", list(bounds[own[0]]), f"given under [limits], since {DISTRIBUTION} is free"
            )
        exponent = self.mass.get("speed_exponent", SPEED_EXPONENT)
        return DesignStudy(
            **self.common(ball=self.ball, speed_exponent=exponent), club=self.club, objectives=objectives,
            bounds=bounds, distributed=distributed, head=None if self.head is None else self.head.head(),
            limits=self.limits, starts=self.starts, points=self.points or DEFAULT_POINTS,
            conform=self.rules.get("conform", True), tolerance=self.rules.get("tolerance", True),
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class FittingFile(CommonFile):
    """A fitting file."""

    objective: str = file_key(Choice(tuple(JUDGED)), "objective")
    fit: FitTable = file_key(Table(FitTable), "parts to choose from")

    def fitting(self) -> Fitting:
        """Return the fitting."""
        settings = {each["name"]: {name: value for name, value in each.items() if name != "name"}
                    for each in self.fit.setting}  # fmt: skip
        bounds = {name: each for name in ("loft", "lie") if (each := getattr(self.fit, name)) is not None}
        return Fitting(
            **self.common(speed_exponent=SPEED_EXPONENT), objective=self.objective, clubs=self.fit.clubs,
            balls=self.fit.balls, settings=settings, bounds=bounds,
        )  # fmt: skip


OTHER_FILES = {
    "cg_x": ("a club", 'name it in a study, as in club = "my-driver.toml"'),
    "study": ("a study of many runs", "run it with clubface study run"),
    "metals": ("a study of a shell head", "run it with clubface fem design"),
}
"""Other kinds of file, by a key that only they have, and how to use them."""


def read(path: str | os.PathLike[str]) -> DesignStudy | Fitting:
    """Read a study, or a fitting if the file has a table ``[fit]``; the files it names are relative to its folder."""
    return from_document(Document.read(path))


def content(study: DesignStudy | Fitting) -> dict[str, Any]:
    """Return everything the result of a study or a fitting depends on, for a fingerprint."""
    values = {name: getattr(study, name) for name in study.__dataclass_fields__ if name not in ("golfers", "worth")}
    return {**values, "golfers": [(each.content(), weight) for each, weight in study.golfers]}


def design_study(given: DesignStudy | str | os.PathLike[str]) -> DesignStudy:
    """Return a study, given as such or as a file; raise an :class:`InputError` for a fitting file."""
    study = given if isinstance(given, (DesignStudy, Fitting)) else read(given)
    if isinstance(study, Fitting):
        raise InputError("study", given, "a study with variables; fit takes a fitting, which has a table [fit]")
    return study


def fitting(given: Fitting | str | os.PathLike[str]) -> Fitting:
    """Return a fitting, given as such or as a file; raise an :class:`InputError` for a study file."""
    subject = given if isinstance(given, (DesignStudy, Fitting)) else read(given)
    if isinstance(subject, DesignStudy):
        raise InputError("fitting", given, "one with a table [fit]; optimise takes a study, which has variables")
    return subject


def from_text(text: str) -> DesignStudy | Fitting:
    """Read a study or a fitting from text; the files it names are relative to the current folder."""
    return from_document(Document(text))


def from_document(document: Document) -> DesignStudy | Fitting:
    """Read a study or a fitting from a document."""
    place = Place(document)
    for key, (what, advice) in OTHER_FILES.items():
        if key in document.data:
            raise FileError(document.path, document.line_of((key,)), f"this is {what}; {advice}", key)
    with place.errors():
        if "fit" in document.data:
            return decode(FittingFile, document).fitting()
        return decode(StudyFile, document).study()
