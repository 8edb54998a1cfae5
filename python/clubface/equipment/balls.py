"""Golf balls: from TOML, from code or built in, checked.

One file describes a ball to every model: its mass, radius and inertia; where finite elements are to strike it, the
pieces it is made of, which stay plain data here; and the values that models take for it.

What a ball weighs, and how its mass is spread, from the pieces its file describes; their materials are not read.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any, ClassVar, NamedTuple, Self

from clubface import units
from clubface.equipment.core import check_body
from clubface.equipment.described import Described, Property, set_si, template_lines, to_toml
from clubface.equipment.models import model
from clubface.equipment.parameters import checked, parsed_scalar
from clubface.errors import ClubfaceError, FileError, InputError, RuleWarning
from clubface.support.checks import Frozen, check_name, check_text, warn_once, without_warnings
from clubface.support.files import builtin_names, builtin_path, is_path
from clubface.support.strict_toml import Document, quoted


@dataclass(frozen=True)
class Construction:
    """What the file of a ball says to finite elements alone.

    Attributes
    ----------
    data
        The mesh and the pieces, as they were read.
    document
        The whole file, which finite elements read.
    """

    KEYS: ClassVar = ("cube", "element", "pieces")

    data: Mapping[str, Any]
    document: Document = field(compare=False, repr=False)

    @classmethod
    def of(cls, document: Document) -> Construction:
        """Return what a document says of the pieces."""
        return cls({key: value for key, value in document.data.items() if key in cls.KEYS}, document)


class Body(NamedTuple):
    """A ball as a rigid body: mass [kg], moment of inertia about the centre [kg m2]."""

    mass: float
    inertia: float


def body(document: Document, radius: float, mass: float | None) -> Body:
    """Return mass and inertia of the pieces of a file, spheres one around the other.

    The core has the density that makes up the mass, or with None its own.
    """
    core, *around = _tables(document)
    outer, total, inertia = radius, 0.0, 0.0
    for number, piece in reversed(list(enumerate(around, 1))):
        inner = outer - _number(document, piece, number, "thickness", "length")
        if not 0.0 < inner < outer:
            raise document.error("the layers leave no core", "thickness", "pieces", number)
        density = _number(document, piece, number, "density", "density")
        total += density * _volume(inner, outer)
        inertia += density * _second_moment(inner, outer)
        outer = inner
    left = None if mass is None else (mass - total) / _volume(0.0, outer)
    density = _number(document, core, 0, "density", "density") if left is None else left
    if not density > 0.0:
        raise document.error("the layers around it leave the core no mass", "mass")
    return Body(total + density * _volume(0.0, outer), inertia + density * _second_moment(0.0, outer))


def pieces_lines(data: Mapping[str, Any]) -> list[str]:
    """Return the lines of the pieces, as they were read."""
    lines = []
    for piece in data["pieces"]:
        lines += ["[[pieces]]", *toml_lines({key: value for key, value in piece.items() if key != "maxwell"})]
        for branch in piece.get("maxwell", []):
            lines += ["[[pieces.maxwell]]", *toml_lines(branch)]
        lines.append("")
    return lines[:-1]


def toml_lines(values: Mapping[str, Any]) -> list[str]:
    """Return a line for each key."""
    return [f"{key} = {quoted(value) if isinstance(value, str) else repr(value)}" for key, value in values.items()]


def _tables(document: Document) -> Sequence[Mapping[str, Any]]:
    tables = document.data["pieces"]
    if not (isinstance(tables, list) and tables and all(isinstance(each, dict) for each in tables)):
        raise document.error("pieces must be tables, each under [[pieces]]", "pieces")
    return tables


def _number(document: Document, piece: Mapping[str, Any], number: int, key: str, dimension: str) -> float:
    try:
        if key not in piece:
            told = InputError(f"{key} of {piece.get('name', 'the piece')}", None, "give it")
            raise document.error(str(told), "", "pieces", number)
        return units.parse(piece[key], dimension, name=key)
    except FileError:
        raise
    except ClubfaceError as error:
        raise document.wrap(error, "pieces", number) from error


def _volume(inner: float, outer: float) -> float:
    return 4.0 / 3.0 * math.pi * (outer**3 - inner**3)


def _second_moment(inner: float, outer: float) -> float:
    """Return the moment of inertia of a spherical shell over its density [m5]."""
    return 8.0 / 15.0 * math.pi * (outer**5 - inner**5)


FOLDER = "balls"
DEFAULT_BALL = "modern"
"""The ball where none is named."""
PUBLISHED_BALL = "published"
"""The ball with which the published parameters were found; its diameter is 0.07 mm below the limit of the rules."""
BALL_MASS_LIMIT = 45.93e-3
"""kg, at most (1.620 oz); The Equipment Rules."""
BALL_DIAMETER_LIMIT = 42.67e-3
"""m, at least (1.680 in); The Equipment Rules."""

BALL_PROPERTIES = {
    "mass": Property("mass", "g", "mass", "45.93 g"),
    "radius": Property("length", "mm", "radius", "21.335 mm"),
    "inertia": Property("inertia", "g cm2", "moment of inertia about the centre", "83.6 g cm2"),
    "friction": Property(units.DIMENSIONLESS, "1", "of the cover on a clubface", "0.35", required=False),
}
RIGID = ("mass", "radius", "inertia")
"""What every model takes."""


@dataclass(frozen=True, kw_only=True, repr=False)
class Ball(Described):
    """A golf ball, SI.

    Attributes
    ----------
    name
        What it is called in tables.
    mass
        [kg].
    radius
        [m].
    inertia
        Moment of inertia about the centre [kg m2].
    description
        A sentence for lists.
    friction
        Coefficient of friction between cover and clubface, for the models that take it from the ball; None if unknown.
    parameters
        Values of parameters [SI], by name of model, that stand where nobody chose a set or the value itself.
    construction
        What finite elements mesh: the pieces as their file has them, or a :class:`clubface.fem.Ball`; or None.
    sources
        Where each value comes from, by field name.
    """

    name: str
    mass: float
    radius: float
    inertia: float
    description: str = ""
    friction: float | None = None
    parameters: Mapping[str, Mapping[str, float]] = field(default_factory=dict, hash=False)
    construction: Any = field(default=None, hash=False, repr=False)
    sources: Mapping[str, str] = field(default_factory=dict, hash=False)
    properties: ClassVar = BALL_PROPERTIES

    def __post_init__(self) -> None:
        set_si(self, BALL_PROPERTIES)
        check_name(self.name)
        check_text("description", self.description)
        if self.friction is not None:
            check_friction(self.friction)
        object.__setattr__(self, "parameters", _checked_parameters(self.parameters))
        check_body("ball", self.inputs())
        if self.mass > BALL_MASS_LIMIT * (1.0 + 1e-9):
            warn_once(
                f"{self.name}: ball mass {units.fixed(self.mass, 'g', 2)} is above the rule limit of 45.93 g",
                RuleWarning,
            )
        if 2.0 * self.radius < BALL_DIAMETER_LIMIT * (1.0 - 1e-9):
            warn_once(
                f"{self.name}: ball diameter {self.radius * 2e3:.2f} mm is below the rule limit of 42.67 mm",
                RuleWarning,
            )

    def inputs(self) -> dict[str, float]:
        """Return the values the models take, SI, under the core's names and in its order."""
        return {f"ball_{key}": getattr(self, key) for key in RIGID}

    def to_toml(self) -> str:
        """Write the ball as TOML text, which :meth:`from_text` reads back exactly."""
        text = to_toml(self, BALL_PROPERTIES, {})
        for name, values in self.parameters.items():
            text += "\n".join(
                ["", f"[parameters.{name}]", *(f"{key} = {value!r}" for key, value in values.items()), ""]
            )
        if not isinstance(self.construction, Construction):
            return text
        # Keys of the file itself cannot follow a table.
        first, *rest = text.split("\n\n", 1)
        mesh = {key: value for key, value in self.construction.data.items() if key != "pieces"}
        top = [first, *toml_lines(mesh)]
        return "\n".join(["\n".join(top), "", *rest]) + "\n".join(["", *pieces_lines(self.construction.data), ""])

    @classmethod
    def from_document(cls, document: Document) -> Self:
        """Read the ball a TOML document describes."""
        return cls(**_read(document))

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read what a TOML file describes; see ``template`` for its form."""
        return cls.from_document(Document.read(path))

    @classmethod
    def from_text(cls, text: str, path: str = "<text>") -> Self:
        """Read what TOML text describes; ``path`` names it in errors."""
        return cls.from_document(Document(text, path))

    @classmethod
    def builtin(cls, name: str) -> Self:
        """Return a ball that comes with the package, such as ``"conforming"``."""
        return cls.from_toml(builtin_path("ball", name, FOLDER))

    @staticmethod
    def template(name: str = "my-ball") -> str:
        """Return TOML text to start one's own ball from, every key explained."""
        check_name(name)
        head = [
            "# A ball. A value is text with a unit; a bare number is SI (kg, m, kg m2).",
            f"name = {quoted(name)}",
            'description = ""',
            "",
        ]
        return "\n".join(head + template_lines(BALL_PROPERTIES))


def ball(which: Any = None) -> Ball:
    """Return the ball meant by a built-in name, the path of a TOML file, or a :class:`Ball` itself.

    Without a name it is ``DEFAULT_BALL``. A ball of finite elements made in code is taken as the rigid ball that it is
    to other models.
    """
    which = getattr(which, "rigid", which)
    if isinstance(which, Ball):
        return which
    if which is None:
        return _default()
    return Ball.from_toml(which) if is_path(which) else Ball.builtin(str(which))


def published_ball() -> Ball:
    """Return the ball of the published parameters, without the warning that it is smaller than the rules allow."""
    with without_warnings():
        return Ball.builtin(PUBLISHED_BALL)


@cache
def _default() -> Ball:
    return Ball.builtin(DEFAULT_BALL)


def ball_names() -> tuple[str, ...]:
    """List the built-in balls."""
    return builtin_names(FOLDER)


FRICTION_LIMITS = (0.0, 10.0)


def check_friction(value: float) -> None:
    """Refuse what is no coefficient of friction."""
    if not FRICTION_LIMITS[0] <= value <= FRICTION_LIMITS[1]:
        raise InputError("friction", value, f"{FRICTION_LIMITS[0]:g} to {FRICTION_LIMITS[1]:g}")


def _checked_parameters(given: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Mapping[str, float]]:
    """Return values of parameters [SI] by model, each within the bounds that the model declares."""
    found = {}
    for name, values in given.items():
        if not isinstance(values, Mapping):
            raise InputError(f"parameters.{name}", values, "a table of values")
        declared = {key: model(name).parameter(key) for key in values}
        found[name] = Frozen({key: checked(parsed_scalar(values[key], of), of) for key, of in declared.items()})
    return Frozen(found)


_KEYS = ("name", "description", "mass", "diameter", "radius", "inertia", "friction", "parameters", "sources")
KEYS = (*_KEYS, *Construction.KEYS)


def _read(document: Document) -> dict[str, Any]:
    """Return what a TOML document says of a ball, by field; every error carries file and line."""
    data = dict(document.data)
    meshed = "pieces" in data
    size = "diameter" if "diameter" in data else "radius"
    document.check_keys(data, KEYS if meshed else _KEYS, ("name", size, *(() if meshed else ("mass", "inertia"))))
    document.check_text(data, ("name", "description"))
    if "diameter" in data and "radius" in data:
        raise document.error("give the diameter or the radius, not both", "radius")
    check_parameters(document)
    check_sources(document)
    try:
        radius = units.parse(data.pop(size), "length", name=size) / (2.0 if size == "diameter" else 1.0)
        found = {**{key: value for key, value in data.items() if key not in Construction.KEYS}, "radius": radius}
        if meshed:
            mass = units.parse(data["mass"], "mass", name="mass") if "mass" in data else None
            made = body(document, radius, mass)
            found = {"mass": made.mass, "inertia": made.inertia, **found, "construction": Construction.of(document)}
        Ball(**found)
    except FileError:
        raise
    except ClubfaceError as error:
        raise document.wrap(error) from error
    return found


def check_parameters(document: Document) -> None:
    """Refuse parameters of a ball that are no tables, one a model, of single values within their bounds."""
    given = document.data.get("parameters", {})
    if not isinstance(given, dict):
        raise document.error("parameters must be a table", "parameters")
    try:
        _checked_parameters(given)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def check_sources(document: Document) -> None:
    """Refuse sources of a ball that are no table of texts."""
    sources = document.data.get("sources", {})
    if not isinstance(sources, dict):
        raise document.error("sources must be a table of texts", "sources")
    document.check_keys(sources, (*BALL_PROPERTIES, "diameter", "friction", "pieces"), (), "sources")
    document.check_text(sources, sources, "sources")
