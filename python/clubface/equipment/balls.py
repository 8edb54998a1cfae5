"""Golf balls: built in, from TOML or from code, with checks.

One file describes a ball for every model: mass, radius and inertia; for finite elements, the pieces it is made of,
which remain plain data here; and parameter values for models. If mass and inertia are not given, they follow from the
pieces, whose materials are not needed for this.
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
    """The part of a ball's file that only finite elements use."""

    KEYS: ClassVar = ("cube", "element", "pieces")

    data: Mapping[str, Any]  # mesh and pieces, as read
    document: Document = field(compare=False, repr=False)  # the whole file, for finite elements

    @classmethod
    def of(cls, document: Document) -> Construction:
        """Return the mesh and pieces of a document."""
        return cls({key: value for key, value in document.data.items() if key in cls.KEYS}, document)


class Body(NamedTuple):
    """Rigid-body properties of a ball: mass [kg] and moment of inertia about the centre [kg m2]."""

    mass: float
    inertia: float


def body(document: Document, radius: float, mass: Any) -> Body:
    """Return mass and inertia of the concentric pieces in a file.

    If ``mass`` is given, the density of the core follows from it; if None, the core has its own density.
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
                raise InputError("thickness", units.show(thickness, "mm"), "small enough to leave room for a core")
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
                raise InputError("mass", units.show(mass, "g"), "more; the layers leave no mass for the core")
    return Body(total + density * _volume(0.0, outer), inertia + density * _second_moment(0.0, outer))


def pieces_lines(data: Mapping[str, Any]) -> list[str]:
    """Return the TOML lines of the pieces, as read."""
    lines = []
    for piece in data["pieces"]:
        lines += ["[[pieces]]", *toml_lines({key: value for key, value in piece.items() if key != "maxwell"})]
        for branch in piece.get("maxwell", []):
            lines += ["[[pieces.maxwell]]", *toml_lines(branch)]
        lines.append("")
    return lines[:-1]


def toml_lines(values: Mapping[str, Any]) -> list[str]:
    """Return one TOML line per key."""
    return [f"{key} = {quoted(value) if isinstance(value, str) else repr(value)}" for key, value in values.items()]


def _volume(inner: float, outer: float) -> float:
    return 4.0 / 3.0 * math.pi * (outer**3 - inner**3)


def _second_moment(inner: float, outer: float) -> float:
    """Return the moment of inertia of a spherical shell divided by its density [m5]."""
    return 8.0 / 15.0 * math.pi * (outer**5 - inner**5)


FOLDER = "balls"
DEFAULT_BALL = "modern"
"""Name of the default ball."""
PUBLISHED_BALL = "published"
"""Name of the ball used to find the published parameters; its diameter is 0.07 mm below the rule limit."""
BALL_MASS_LIMIT = 45.93e-3
"""Maximum mass [kg] (1.620 oz); The Equipment Rules."""
BALL_DIAMETER_LIMIT = 42.67e-3
"""Minimum diameter [m] (1.680 in); The Equipment Rules."""

RIGID = ("mass", "radius", "inertia")
"""Properties used by every model."""


FRICTION_LIMITS = (0.0, 10.0)
COVER_FRICTION = PhysicalValue("1", *FRICTION_LIMITS)


def _check_parameters(given: dict[str, Any], place: Place) -> Mapping[str, Mapping[str, float]]:
    """Return parameter values [SI] by model, checked against the model's bounds."""
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
    """A golf ball, in SI units.

    ``parameters`` replace the defaults of a model, unless a parameter set or the value itself is given.
    ``construction`` is what finite elements mesh: the pieces as in the file, or a :class:`clubface.fem.Ball`; or None.
    ``sources`` gives the source of each value, by field name.
    """

    OTHER_KEYS: ClassVar = dict.fromkeys(Construction.KEYS, Simple())

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence for lists", default="")
    mass: float = file_key(PhysicalValue("g"), "mass", example="45.93 g")
    radius: float = file_key(PhysicalValue("mm"), "radius", example="21.335 mm", multiples={"diameter": 0.5})
    inertia: float = file_key(PhysicalValue("g cm2"), "moment of inertia about the centre", example="83.6 g cm2")
    friction: float | None = file_key(
        COVER_FRICTION, "coefficient between cover and clubface", example="0.35", default=None
    )
    parameters: Mapping[str, Mapping[str, float]] = file_key(
        Record(Record(Simple()), make=_check_parameters),
        "parameter values, one table per model",
        default_factory=dict,
        hash=False,
    )
    sources: Mapping[str, str] = file_key(
        sources_of(lambda: Ball, "diameter", "pieces"), "source of each value", default_factory=dict, hash=False
    )
    construction: Any = field(default=None, hash=False, repr=False)

    def __post_init__(self) -> None:
        set_si(self)
        check_body("ball", self.inputs())
        if self.mass > BALL_MASS_LIMIT * (1.0 + 1e-9):
            shown = units.fixed(self.mass, "g", 2)
            warn_once(f"{self.name}: ball mass {shown} is above the rule limit of 45.93 g", RuleWarning)
        if 2.0 * self.radius < BALL_DIAMETER_LIMIT * (1.0 - 1e-9):
            shown = units.fixed(2.0 * self.radius, "mm", 2)
            warn_once(f"{self.name}: ball diameter {shown} is below the rule limit of 42.67 mm", RuleWarning)

    def inputs(self) -> dict[str, float]:
        """Return the values [SI] used by the models, under the core's names and in its order."""
        return {f"ball_{key}": getattr(self, key) for key in RIGID}

    def to_toml(self) -> str:
        """Return the ball as TOML text that :meth:`from_text` reads back exactly."""
        text = to_toml(self)
        if not isinstance(self.construction, Construction):
            return text
        # Top-level keys cannot follow a table.
        first, *rest = text.split("\n\n", 1)
        mesh = {key: value for key, value in self.construction.data.items() if key != "pieces"}
        top = [first, *toml_lines(mesh)]
        return "\n".join(["\n".join(top), "", *rest]) + "\n".join(["", *pieces_lines(self.construction.data), ""])

    @classmethod
    def from_document(cls, document: Document) -> Self:
        """Read the ball described by a TOML document, from its pieces if it has any."""
        if "pieces" not in document.data:
            return decode(cls, document)
        made = body(document, _read_radius(document), document.data.get("mass"))
        return decode(
            cls, document, others=cls.OTHER_KEYS, usual=made._asdict(), construction=Construction.of(document)
        )

    @classmethod
    def builtin(cls, name: str) -> Self:
        """Return a built-in ball, such as ``"conforming"``."""
        return cls.from_toml(builtin_path("ball", name, FOLDER))

    @staticmethod
    def template(name: str = "my-ball") -> str:
        """Return a commented TOML template for your own ball."""
        check_name(name)
        lines = template_lines(Ball, {"name": quoted(name), "description": '""'})
        return "\n".join(["# A ball. A value is text with a unit; a bare number is SI (kg, m, kg m2).", *lines])


BALL_PROPERTIES = quantities(Ball)
"""Numeric properties of a ball, by field."""


def ball(name: str | os.PathLike[str] | Ball | None = None) -> Ball:
    """Return a ball: a built-in one by name, one from a TOML file, or ``name`` itself; default ``DEFAULT_BALL``.

    A finite element ball made in code gives the equivalent rigid ball.
    """
    name = getattr(name, "rigid", name)
    if isinstance(name, Ball):
        return name
    if name is None:
        return _default()
    return Ball.from_toml(name) if is_path(name) else Ball.builtin(str(name))


def published_ball() -> Ball:
    """Return the ball of the published parameters, without the warning about its size."""
    with without_warnings():
        return Ball.builtin(PUBLISHED_BALL)


@cache
def _default() -> Ball:
    return Ball.builtin(DEFAULT_BALL)


def ball_names() -> tuple[str, ...]:
    """Return the names of the built-in balls."""
    return builtin_names(FOLDER)


def _read_radius(document: Document) -> float:
    """Return the radius in a document [m], after checking that the ball is complete."""
    place = Place(document)
    radius = entries(Ball)["radius"]
    given = [key for key in (radius.key, *radius.multiples) if key in document.data]
    place.require_keys(document.data, ("name", *(given or [radius.key]), "pieces"))
    with (at := place.key(given[0])).errors():
        return radius.multiples.get(given[0], 1.0) * radius.value.read(document.data[given[0]], at)
