"""Finite element balls: made of pieces, built in or defined in TOML or code."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.balls import (
    COVER_FRICTION,
    DEFAULT_BALL,
    FOLDER,
    Ball as RigidBall,
    Construction,
    ball_names as all_names,
)
from clubface.errors import InputError
from clubface.fem.geometry import element_masses, sums_at_nodes
from clubface.fem.materials import ENERGY, NOT_CONSTANTS, REGISTERED, Energy, Material, Maxwell, builtin_laws, laws
from clubface.results.result import Described, Result
from clubface.schema.document import Document, Place
from clubface.schema.tables import Table, check_values, entries, file_key
from clubface.schema.values import NAME, TEXT, Choice, PhysicalValue, Record, Simple, Tables, Value, count
from clubface.support.checks import check_count, check_name, is_count, without_warnings
from clubface.support.files import builtin_path, is_path, path_of

__all__ = ["Ball", "Piece", "ball", "ball_names"]

LAYERS = count(1, 48)
CONSTANT = Simple("a stress with its unit, or a number", schema={"type": ["string", "number"]})
THICKNESS = PhysicalValue("mm", 0.01, 20)


@dataclass(frozen=True, kw_only=True)
class Piece:
    """The core of a ball, or one layer around it.

    Attributes
    ----------
    name
        Name shown in tables and messages.
    material
        Its material.
    layers
        Number of element layers through the thickness; for the core, between its inner cube and its surface.
    thickness
        Thickness [m]; None for the core, which fills the rest of the ball.
    """

    name: str
    material: Material
    layers: int
    thickness: float | None = None

    def __post_init__(self) -> None:
        check_name(self.name)
        if not isinstance(self.material, Material):
            raise InputError(f"material of {self.name}", self.material, "a Material")
        LAYERS.read(self.layers, Place(name="layers", label=self.name))
        if self.thickness is not None:
            value = THICKNESS.read(self.thickness, Place(name="thickness", label=self.name))
            object.__setattr__(self, "thickness", value)


def _make_piece(values: dict[str, Any], place: Place) -> Piece:
    """Return the piece of a table [[pieces]]; its constants are those of its law or energy."""
    names = {name for law in laws().values() for name in law.constants}
    if "energy" in values:
        names = {*names, *Energy.read(values["energy"]).constants}
    constants = {name: values.pop(name) for name in [*values] if name in names}
    piece = {name: values.pop(name) for name in ("name", "layers", "thickness") if name in values}
    if "law" not in values and "energy" not in values:
        raise place.key("law").invalid(None, f"give a law ({', '.join(laws())}), or an energy in its place")
    if "youngs" not in values:
        return Piece(material=Material(constants=constants, **values), **piece)
    law, youngs = values.pop("law", ENERGY), values["youngs"]
    if law != "linear":
        raise place.key("youngs").invalid(youngs, f"leave it out: {law} has constants of its own")
    for name, value in constants.items():
        raise place.key(name).invalid(value, "leave it out, since youngs is given")
    return Piece(material=Material.linear(**values), **piece)


def _piece_keys() -> Mapping[str, Value]:
    """Return the keys of [[pieces]] and their types."""
    constants = {name: each for law in builtin_laws().values() for name, each in law.constants.items()}
    return {
        "name": NAME, "layers": LAYERS, "thickness": THICKNESS, "law": Choice(lambda: tuple(laws())),
        "youngs": PhysicalValue("MPa"), "energy": TEXT, "volumetric": TEXT, "poisson": PhysicalValue("1"),
        "density": PhysicalValue("kg/m3"), "maxwell": Tables(Table(Maxwell)),
        **{name: PhysicalValue(units.SI_UNITS[each]) for name, each in sorted(constants.items())},
    }  # fmt: skip


@dataclass(repr=False, eq=False)
class PieceRecord(Record):
    """Type of a table in [[pieces]]; the names of constants depend on its energy or user-defined law."""

    def read(self, given: Any, place: Place) -> Any:
        if not isinstance(given, Mapping):
            return super().read(given, place)
        text = given.get("energy")
        if isinstance(text, str):
            with (at := place.key("energy")).errors():
                taken = [name for name in Energy.read(text).constants if name in NOT_CONSTANTS]
                if taken:
                    raise at.invalid(text, f"one whose constants have names of their own; {taken[0]} is another key")
        return Record(self.key_types(given), self.required, make=self.make).read(given, place)

    def key_types(self, given: Mapping[str, Any]) -> Mapping[str, Value]:
        """Return the types of a piece's keys, including the constants of its energy or law."""
        law = given.get("law")
        if isinstance(given.get("energy"), str):
            dimensions = Energy.read(given["energy"]).dimensions
        elif isinstance(law, str) and law in REGISTERED:
            dimensions = REGISTERED[law].constants
        else:
            return self.keys()
        kinds = {
            name: CONSTANT if dimension is None else PhysicalValue(units.SI_UNITS[dimension])
            for name, dimension in dimensions.items()
        }
        # The constants of other laws are not allowed here.
        return {name: kind for name, kind in self.keys().items() if name in NOT_CONSTANTS} | kinds

    def json(self) -> dict[str, Any]:
        # An energy may use any names for its constants.
        return super().json() | {"additionalProperties": CONSTANT.json()}


PIECE = PieceRecord(_piece_keys, ("name", "layers", "poisson"), make=_make_piece)
"""Type of a table in [[pieces]]."""


FRICTION = 0.35
"""Default friction coefficient of a ball; measured values are 0.3 to 0.4."""
MAX_PIECES = 5
ELEMENTS = ("one-point", "full")


@dataclass(frozen=True, kw_only=True)
class Ball(Described):
    """A ball for finite elements, in SI units.

    If ``mass`` is given, the density of the core follows from it; otherwise the core has the density of its material.
    Elements are "one-point" (with hourglass control) or "full" (eight integration points, one pressure).
    """

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence, or more if the ball was fitted to something", default="")
    diameter: float = file_key(PhysicalValue("mm", 10, 200), "diameter", multiples={"radius": 2.0}, example="42.67 mm")
    mass: float | None = file_key(PhysicalValue("g", 1, 1000), "mass, which sets the density of the core", default=None)
    cube: int = file_key(
        Simple("an even whole number from 2 to 96, so that a node lies at the point of first touch",
               lambda value: is_count(value, 2, 96) and value % 2 == 0, {"type": "integer", "multipleOf": 2}),
        "elements along an edge of the cube inside the core; the sphere has 6 cube^2 elements around it", default=12,
    )  # fmt: skip
    element: str = file_key(Choice(ELEMENTS), "kind of elements", default="one-point")
    friction: float = file_key(
        COVER_FRICTION, "coefficient between cover and face, unless the run gives its own", default=FRICTION
    )
    pieces: tuple[Piece, ...] = file_key(
        Tables(PIECE, least=1, most=MAX_PIECES), "core and layers, from the inside out"
    )

    def __post_init__(self) -> None:
        if isinstance(self.pieces, str) or not all(isinstance(piece, Piece) for piece in self.pieces):
            raise InputError("pieces", self.pieces, "a sequence of Pieces, from the inside out")
        object.__setattr__(self, "pieces", tuple(self.pieces))
        check_values(self)
        names = [piece.name for piece in self.pieces]
        if len(set(names)) < len(names):
            raise InputError("pieces", names, "each with a name of its own")
        if not 1 <= len(self.pieces) <= MAX_PIECES:
            raise InputError("pieces", len(self.pieces), f"1 to {MAX_PIECES}")
        core, *around = self.pieces
        if core.thickness is not None:
            allowed = "leave it out; the core fills the space inside the other pieces"
            raise InputError("thickness of the core", units.show(core.thickness, "mm"), allowed)
        if core.material.density is None and self.mass is None:
            raise InputError("mass", None, "give it, or the density of the core")
        for piece in around:
            if piece.thickness is None or piece.material.density is None:
                missing = "thickness" if piece.thickness is None else "density"
                raise InputError(f"{missing} of {piece.name}", None, "give it; only the core may omit it")
        volumes = [4.0 / 3.0 * math.pi * radius**3 for radius in self.radii()]
        if self.mass is None:
            return
        around = sum(
            (piece.material.density or 0.0) * (outer - inner)
            for piece, inner, outer in zip(self.pieces[1:], volumes, volumes[1:], strict=False)
        )
        density = (self.mass - around) / volumes[0]
        if not 10.0 <= density <= 30e3:
            allowed = f"such that the core has 10 to 30000 kg/m3; with these layers it would have {density:.0f} kg/m3"
            raise InputError("mass", units.show(self.mass, "g"), allowed)

    def radii(self) -> list[float]:
        """Return the outer radius of each piece [m]."""
        radii = [self.diameter / 2.0]
        for piece in reversed(self.pieces[1:]):
            radii.append(radii[-1] - (piece.thickness or 0.0))
        if radii[-1] < 0.1 * self.diameter:
            total = sum(piece.thickness or 0.0 for piece in self.pieces[1:])
            raise InputError("thickness of the layers", units.show(total, "mm"), "less than 80% of the radius in all")
        return radii[::-1]

    @property
    def elements(self) -> int:
        """Number of hexahedra."""
        return self.cube**3 + 6 * self.cube**2 * sum(piece.layers for piece in self.pieces)

    def refined(self, times: int) -> Ball:
        """Return the ball with ``times`` as many elements along every edge, 1 to 8."""
        check_count("refine", times, 1, 8)
        pieces = tuple(replace(piece, layers=piece.layers * times) for piece in self.pieces)
        return replace(self, cube=self.cube * times, pieces=pieces)

    def properties(self) -> Mapping[str, float]:
        """Return mesh properties: mass [kg], inertia [kg m2], core density [kg/m3], radius [m], nodes, elements."""
        return dict(self._meshed)

    @cached_property
    def _meshed(self) -> Mapping[str, float]:
        return core.fem_ball(self.values())

    @cached_property
    def mesh(self) -> Mapping[str, Any]:
        """The mesh: nodes [m], elements, piece of each element, density of each piece [kg/m3]."""
        return core.fem_mesh(self.values())

    def to_result(self) -> Result:
        """Return the meshed ball, compared with its specification and the rules, as a result."""
        from clubface.fem.impact_result import ball_result

        return ball_result(self)

    def values(self) -> dict[str, Any]:
        """Return the ball in the core's format."""
        pieces = []
        for piece, radius in zip(self.pieces, self.radii(), strict=True):
            made = piece.material
            own = {"energy": made.energy, "volumetric": made.volumetric}
            pieces.append({
                "name": piece.name, "radius": radius, "layers": piece.layers, "law": made.law,
                "constants": list(made.constants.values()),
                **{key: text for key, text in own.items() if text is not None}, "bulk": made.bulk,
                "maxwell": [(branch.modulus, branch.time) for branch in made.maxwell], "density": made.density or 0.0,
            })  # fmt: skip
        return {"pieces": pieces, "cube": self.cube, "element": self.element, "mass": self.mass}

    @cached_property
    def rigid(self) -> RigidBall:
        """The equivalent rigid ball for the other models: mass, radius and inertia of the mesh."""
        meshed = self.properties()
        with without_warnings():
            return RigidBall(
                name=self.name, mass=meshed["mass"], radius=meshed["radius"], inertia=meshed["inertia"],
                friction=self.friction, parameters={"fem": {"friction": self.friction}}, construction=self,
            )  # fmt: skip

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Ball:
        """Read a ball from a TOML file; errors name the file and line."""
        return from_document(Document.read(path))


def friction_of(given: Any, ball: Ball) -> float:
    """Return the given coefficient of friction, checked, or the ball's if None."""
    return ball.friction if given is None else COVER_FRICTION.read(given, Place(name="friction"))


def ball_names() -> tuple[str, ...]:
    """Return the names of the built-in balls that are made of pieces."""
    return tuple(name for name in all_names() if "pieces" in Document.read(builtin_path("ball", name, FOLDER)).data)


def ball(source: str | os.PathLike[str] | Ball | RigidBall | None = None) -> Ball:
    """Return a ball for finite elements: a built-in one by name, or one from a TOML file; default ``DEFAULT_BALL``.

    A :class:`clubface.Ball` made of pieces is meshed with its own mass and radius.
    """
    if isinstance(source, Ball):
        return source
    if isinstance(source, RigidBall):
        return _from_rigid(source)
    path = path_of("ball", DEFAULT_BALL if source is None else source, FOLDER)
    document = Document.read(path)
    if "pieces" not in document.data and not is_path(source):
        raise _no_pieces_error(source)
    return from_document(document)


def _from_rigid(given: RigidBall) -> Ball:
    made = given.construction
    if isinstance(made, Construction):
        with without_warnings():
            read = RigidBall.from_document(made.document)
        made = from_document(made.document)
    elif isinstance(made, Ball):
        read = made.rigid
    else:
        raise _no_pieces_error(given.name)
    changes: dict[str, Any] = {} if given.mass == read.mass else {"mass": given.mass}
    if given.radius != read.radius:
        changes["diameter"] = 2.0 * given.radius
    if given.friction not in (None, made.friction):
        changes["friction"] = given.friction
    return replace(made, **changes) if changes else made


def _no_pieces_error(name: object) -> InputError:
    allowed = f"for fem, one made of pieces ({', '.join(ball_names())}); or leave fem out of the models"
    return InputError("ball", name, allowed)


# Finite elements take the inertia from the pieces; the other keys are for the other models.
PIECES_FILE = Table(Ball, {name: entries(RigidBall)[name].value for name in ("inertia", "parameters", "sources")})
"""File format of a ball made of pieces."""


def from_document(document: Document) -> Ball:
    """Read the ball described by a TOML document."""
    return PIECES_FILE.read(document.data, Place(document))


def node_masses(mesh: Mapping[str, Any]) -> NDArray[Any]:
    """Return each node's fraction of the ball's mass, with elements treated as parallelepipeds."""
    nodes, elements = mesh["nodes"], mesh["elements"].astype(int)
    mass = element_masses(nodes, elements, np.asarray(mesh["density"])[mesh["piece"]])
    shares = sums_at_nodes(elements, mass / 8.0, len(nodes))
    return shares / shares.sum()
