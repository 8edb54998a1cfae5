"""Golf balls: from TOML, from code or built in, checked.

One file describes a ball to every model: its mass, radius and inertia; where finite elements are to strike it, the
pieces it is made of, which stay plain data here; and the values that models take for it. Mass and inertia follow from
the pieces where the file does not give them; the materials of the pieces are not read.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, ClassVar, NamedTuple, Self

from clubface import units
from clubface.equipment.described import EquipmentItem, check_body, set_si, sources_of, template_lines, to_toml
from clubface.equipment.models import model
from clubface.equipment.parameters import ParameterValue
from clubface.errors import InputError, RuleWarning
from clubface.schema.document import Document, Place, quoted
from clubface.schema.tables import decode, entries, file_key, quantities
from clubface.schema.values import NAME, TEXT, PhysicalValue, Record, Simple, Tables
from clubface.support.checks import Frozen, check_name, warn_once, without_warnings
from clubface.support.files import builtin_names, builtin_path, is_path


@dataclass(frozen=True)
class Construction:
    """The part of a ball's file that only finite elements use.

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
        """Return the mesh and the pieces of a document."""
        return cls({key: value for key, value in document.data.items() if key in cls.KEYS}, document)


class Body(NamedTuple):
    """A ball as a rigid body: mass [kg], moment of inertia about the centre [kg m2]."""

    mass: float
    inertia: float


def body(document: Document, radius: float, mass: Any) -> Body:
    """Return mass and inertia of the pieces of a file, spheres one around the other.

    The core has the density that makes up the mass, or with None its own.
    """
    top = Place(document)
    with (place := top.key("pieces")).errors():
        pieces = Tables(Record(Simple()), least=1).read(document.data["pieces"], place)

    def read(index: int, key: str, unit: str) -> float:
        piece = place.item(index, str(pieces[index].get("name", "the piece"))).key(key)
        with piece.errors():
            if key not in pieces[index]:
                raise piece.invalid(None, "give it")
            return PhysicalValue(unit).read(pieces[index][key], piece)

    outer, total, inertia = radius, 0.0, 0.0
    for index in range(len(pieces) - 1, 0, -1):
        thickness, density = read(index, "thickness", "mm"), read(index, "density", "kg/m3")
        inner = outer - thickness
        with place.item(index).errors():
            if not 0.0 < inner < outer:
                raise InputError("thickness", units.show(thickness, "mm"), "such that the layers leave a core")
        total += density * _volume(inner, outer)
        inertia += density * _second_moment(inner, outer)
        outer = inner
    if mass is None:
        density = read(0, "density", "kg/m3")
    else:
        with top.key("mass").errors():
            mass = PhysicalValue("g").read(mass, top.key("mass"))
            density = (mass - total) / _volume(0.0, outer)
            if not density > 0.0:
                raise InputError("mass", units.show(mass, "g"), "more: the layers around it leave the core no mass")
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

RIGID = ("mass", "radius", "inertia")
"""What every model takes."""


FRICTION_LIMITS = (0.0, 10.0)
COVER_FRICTION = PhysicalValue("1", *FRICTION_LIMITS)


def _checked_parameters(given: dict[str, Any], place: Place) -> Mapping[str, Mapping[str, float]]:
    """Return values of parameters [SI] by model, each within the bounds that the model declares."""
    result: dict[str, Frozen[str, float]] = {}
    for name, values in given.items():
        checked = {}
        for key, value in values.items():
            with (at := place.key(name).key(key)).errors():
                checked[key] = ParameterValue(model(name).parameter(key)).read(value, at)
        result[name] = Frozen(checked)
    return Frozen(result)


@dataclass(frozen=True, kw_only=True, repr=False)
class Ball(EquipmentItem):
    """A golf ball, SI.

    ``parameters`` replace the defaults of a model, unless a set or the value itself is given. ``construction`` is what
    finite elements mesh: the pieces as their file has them, or a :class:`clubface.fem.Ball`; or None. ``sources`` say
    where each value comes from, by field name.
    """

    OTHER_KEYS: ClassVar = dict.fromkeys(Construction.KEYS, Simple())

    name: str = file_key(NAME, "name in tables")
    description: str = file_key(TEXT, "a sentence for lists", default="")
    mass: float = file_key(PhysicalValue("g"), "mass", example="45.93 g")
    radius: float = file_key(PhysicalValue("mm"), "radius", example="21.335 mm", multiples={"diameter": 0.5})
    inertia: float = file_key(PhysicalValue("g cm2"), "moment of inertia about the centre", example="83.6 g cm2")
    friction: float | None = file_key(COVER_FRICTION, "of the cover on a clubface", example="0.35", default=None)
    parameters: Mapping[str, Mapping[str, float]] = file_key(
        Record(Record(Simple()), make=_checked_parameters),
        "parameter values, one table per model",
        default_factory=dict,
        hash=False,
    )
    sources: Mapping[str, str] = file_key(
        sources_of(lambda: Ball, "diameter", "pieces"), "where each value comes from", default_factory=dict, hash=False
    )
    construction: Any = field(default=None, hash=False, repr=False)

    def __post_init__(self) -> None:
        set_si(self)
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
        text = to_toml(self)
        if not isinstance(self.construction, Construction):
            return text
        # Keys of the file itself cannot follow a table.
        first, *rest = text.split("\n\n", 1)
        mesh = {key: value for key, value in self.construction.data.items() if key != "pieces"}
        top = [first, *toml_lines(mesh)]
        return "\n".join(["\n".join(top), "", *rest]) + "\n".join(["", *pieces_lines(self.construction.data), ""])

    @classmethod
    def from_document(cls, document: Document) -> Self:
        """Read the ball a TOML document describes, from its pieces where it has such."""
        if "pieces" not in document.data:
            return decode(cls, document)
        made = body(document, _read_radius(document), document.data.get("mass"))
        return decode(
            cls, document, others=cls.OTHER_KEYS, usual=made._asdict(), construction=Construction.of(document)
        )

    @classmethod
    def builtin(cls, name: str) -> Self:
        """Return a ball that comes with the package, such as ``"conforming"``."""
        return cls.from_toml(builtin_path("ball", name, FOLDER))

    @staticmethod
    def template(name: str = "my-ball") -> str:
        """Return TOML text to start your own ball from, every key explained."""
        check_name(name)
        head = [
            "# A ball. A value is text with a unit; a bare number is SI (kg, m, kg m2).",
        ]
        return "\n".join(head + template_lines(Ball, {"name": quoted(name), "description": '""'}))


BALL_PROPERTIES = quantities(Ball)
"""The numbers that describe a ball, by field."""


def ball(name: str | os.PathLike[str] | Ball | None = None) -> Ball:
    """Return the ball meant by a built-in name, the path of a TOML file, or a :class:`Ball` itself.

    Without a name it is ``DEFAULT_BALL``. A ball of finite elements made in code is taken as the rigid ball that it is
    to other models.
    """
    name = getattr(name, "rigid", name)
    if isinstance(name, Ball):
        return name
    if name is None:
        return _default()
    return Ball.from_toml(name) if is_path(name) else Ball.builtin(str(name))


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


def _read_radius(document: Document) -> float:
    """Return the radius of a document [m], and refuse what is not a whole ball."""
    place = Place(document)
    radius = entries(Ball)["radius"]
    given = [key for key in (radius.key, *radius.multiples) if key in document.data]
    place.require_keys(document.data, ("name", *(given or [radius.key]), "pieces"))
    with (at := place.key(given[0])).errors():
        return radius.multiples.get(given[0], 1.0) * radius.value.read(document.data[given[0]], at)
