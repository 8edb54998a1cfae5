"""Balls made of pieces, from TOML, from code or built in: checks, masses and nodes.

Balls made of pieces: from TOML, from code or built in, with checks.

The pieces of a ball, core and layers: from TOML or from code, with checks.

What the nodes of a ball weigh.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import (
    DEFAULT_BALL,
    FOLDER,
    KEYS,
    Ball as RigidBall,
    Construction,
    ball_names as all_names,
    check_friction,
    check_parameters,
    check_sources,
)
from clubface.errors import ClubfaceError, InputError
from clubface.fem import core
from clubface.fem.materials import Material, Maxwell, laws
from clubface.support.checks import check_choice, check_count, check_name, check_text, without_warnings
from clubface.support.files import builtin_path, is_path, path_of
from clubface.support.strict_toml import Document

MATERIAL_KEYS = ("law", "youngs", "poisson", "density", "maxwell")


@dataclass(frozen=True, kw_only=True)
class Piece:
    """The core of a ball, or one layer around it.

    Attributes
    ----------
    name
        Its name in tables and messages.
    material
        Its material.
    layers
        Number of element layers through it; for the core, between the inner cube and the surface of the core.
    thickness
        Thickness [m]; None for the core, which fills what the layers leave.
    """

    name: str
    material: Material
    layers: int
    thickness: float | None = None

    def __post_init__(self) -> None:
        check_name(self.name)
        if not isinstance(self.material, Material):
            raise InputError(f"material of {self.name}", self.material, "a Material")
        check_count(f"layers of {self.name}", self.layers, 1, 48)
        if self.thickness is not None:
            value = units.parse(self.thickness, "length", name=f"thickness of {self.name}")
            object.__setattr__(self, "thickness", value)
            if not 1e-5 <= value <= 0.02:
                raise InputError(f"thickness of {self.name}", units.show(value, "mm"), "0.01 to 20 mm")


def read_piece(document: Document, table: dict[str, Any], number: int, branches: int) -> Piece:
    """Read one of [[pieces]]; ``branches`` is how many of [[pieces.maxwell]] stand above it."""
    constants = {name for law in laws().values() for name in law.constants}
    known = ("name", "layers", "thickness", *MATERIAL_KEYS, *sorted(constants))
    document.check_keys(table, known, ("name", "law", "layers", "poisson"), "pieces", number)
    try:
        check_choice("law", table["law"], laws())
        common = {"density": table.get("density"), "maxwell": _branches(document, table, branches)}
        if "youngs" in table:
            if table["law"] != "linear":
                raise InputError("youngs", table["youngs"], f"leave it out: {table['law']} has constants of its own")
            also = [name for name in table if name in constants]
            if also:
                raise InputError(also[0], table[also[0]], "leave it out, since youngs is given")
            material = Material.linear(table["youngs"], table["poisson"], **common)
        else:
            given = {name: table[name] for name in table if name in constants}
            material = Material(law=table["law"], constants=given, poisson=table["poisson"], **common)
        return Piece(name=table["name"], material=material, layers=table["layers"], thickness=table.get("thickness"))
    except InputError as error:
        if " of " not in error.parameter:
            error.parameter += f" of {table['name']}"
        raise document.wrap(error, "pieces", number) from error


def _branches(document: Document, table: dict[str, Any], above: int) -> tuple[Maxwell, ...]:
    tables = table.get("maxwell", [])
    if not (isinstance(tables, list) and all(isinstance(each, dict) for each in tables)):
        raise InputError("maxwell", tables, "tables, each under [[pieces.maxwell]]")
    found = []
    for number, each in enumerate(tables, above):
        document.check_keys(each, ("modulus", "time"), ("modulus", "time"), "pieces.maxwell", number)
        try:
            found.append(Maxwell(**each))
        except InputError as error:
            raise document.wrap(error, "pieces.maxwell", number) from error
    return tuple(found)


FRICTION = 0.35
"""Of a ball whose file gives none: measured are 0.3 to 0.4."""
MODEL_NAME = "fem"
MAX_PIECES = 5
ELEMENTS = ("one-point", "full")


@dataclass(frozen=True, kw_only=True)
class Ball:
    """A ball for finite elements, in SI units.

    Attributes
    ----------
    name
        Its name in tables.
    diameter
        Diameter [m].
    pieces
        The pieces, from the core outwards.
    mass
        Mass [kg]; the core takes the density that gives it. With None the core keeps the density of its material.
    element
        "one-point" (with hourglass control) or "full" (eight integration points, one pressure).
    cube
        Number of elements along an edge of the cube inside the core, even. The sphere has 6 cube^2 elements around it.
    description
        One sentence, or more if the ball was fitted to something.
    friction
        Coefficient of friction between cover and face, where none is given to a run.
    """

    name: str
    diameter: float
    pieces: tuple[Piece, ...]
    mass: float | None = None
    cube: int = 12
    element: str = "one-point"
    description: str = ""
    friction: float = FRICTION

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("description", self.description)
        object.__setattr__(self, "friction", friction_value(self.friction))
        object.__setattr__(self, "diameter", units.parse(self.diameter, "length", name="diameter"))
        if isinstance(self.pieces, str) or not all(isinstance(piece, Piece) for piece in self.pieces):
            raise InputError("pieces", self.pieces, "Pieces, from the inside out")
        object.__setattr__(self, "pieces", tuple(self.pieces))
        names = [piece.name for piece in self.pieces]
        if len(set(names)) < len(names):
            raise InputError("pieces", names, "each with a name of its own")
        if not 0.01 <= self.diameter <= 0.2:
            raise InputError("diameter", units.show(self.diameter, "mm"), "10 to 200 mm")
        if self.mass is not None:
            object.__setattr__(self, "mass", units.parse(self.mass, "mass", name="mass"))
            if not 1e-3 <= self.mass <= 1.0:
                raise InputError("mass", units.show(self.mass, "g"), "1 to 1000 g")
        check_count("cube", self.cube, 1, 96)
        check_choice("element", self.element, ELEMENTS)
        if self.cube % 2:
            raise InputError("cube", self.cube, "even, so that a node stands where ball and face first touch")
        if not 1 <= len(self.pieces) <= MAX_PIECES:
            raise InputError("pieces", len(self.pieces), f"1 to {MAX_PIECES}")
        core, *around = self.pieces
        if core.thickness is not None:
            raise InputError(
                "thickness of the core",
                units.show(core.thickness, "mm"),
                "leave it out: the core fills what the other pieces leave",
            )
        if core.material.density is None and self.mass is None:
            raise InputError("mass", None, "give it, or the density of the core")
        for piece in around:
            if piece.thickness is None or piece.material.density is None:
                missing = "thickness" if piece.thickness is None else "density"
                raise InputError(f"{missing} of {piece.name}", None, "give it; only the core may do without")
        self._check_core()

    def _check_core(self) -> None:
        """Refuse a core that the layers leave no room or no mass."""
        radii = self.radii()
        if self.mass is None:
            return
        volumes = [4.0 / 3.0 * math.pi * radius**3 for radius in radii]
        around = sum(
            (piece.material.density or 0.0) * (outer - inner)
            for piece, inner, outer in zip(self.pieces[1:], volumes, volumes[1:], strict=False)
        )
        density = (self.mass - around) / volumes[0]
        if not 10.0 <= density <= 30e3:
            allowed = f"such that the core has 10 to 30000 kg/m3; the layers around it leave it {density:.0f} kg/m3"
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
        """Return the ball with ``times`` as many elements along every edge."""
        check_count("refine", times, 1, 8)
        pieces = tuple(replace(piece, layers=piece.layers * times) for piece in self.pieces)
        return replace(self, cube=self.cube * times, pieces=pieces)

    def properties(self) -> Mapping[str, float]:
        """Return what was meshed: mass [kg], inertia [kg m2], core density [kg/m3], radius [m], nodes, elements."""
        return dict(self._meshed)

    @cached_property
    def _meshed(self) -> Mapping[str, float]:
        return core.fem_ball(self.values())

    @cached_property
    def mesh(self) -> Mapping[str, Any]:
        """The mesh: nodes [m], elements, the piece of each element, the density of each piece [kg/m3]."""
        return core.fem_mesh(self.values())

    def values(self) -> dict[str, Any]:
        """Return what the core takes."""
        pieces = [
            {
                "name": piece.name,
                "radius": radius,
                "layers": piece.layers,
                "law": piece.material.law,
                "constants": list(piece.material.constants.values()),
                "bulk": piece.material.bulk,
                "maxwell": [(branch.modulus, branch.time) for branch in piece.material.maxwell],
                "density": piece.material.density or 0.0,
            }
            for piece, radius in zip(self.pieces, self.radii(), strict=True)
        ]
        return {"pieces": pieces, "cube": self.cube, "element": self.element, "mass": self.mass}

    @cached_property
    def rigid(self) -> RigidBall:
        """The ball as the other models see it: mass, radius and inertia of the mesh."""
        found = self.properties()
        with without_warnings():
            return RigidBall(
                name=self.name,
                mass=found["mass"],
                radius=found["radius"],
                inertia=found["inertia"],
                friction=self.friction,
                parameters={MODEL_NAME: {"friction": self.friction}},
                construction=self,
            )

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Ball:
        """Read a ball from a TOML file; every error names file and line."""
        return from_document(Document.read(path))


def friction_value(value: Any) -> float:
    """Return a coefficient of friction, checked."""
    mu = units.parse(value, units.DIMENSIONLESS, name="friction")
    check_friction(mu)
    return mu


def ball_names() -> tuple[str, ...]:
    """Return the names of the balls of pieces that come with clubface."""
    return tuple(name for name in all_names() if "pieces" in Document.read(builtin_path("ball", name, FOLDER)).data)


def ball(which: str | os.PathLike[str] | Ball | RigidBall | None = None) -> Ball:
    """Return a built-in ball of pieces by name, or read one from a TOML file; without a name it is ``DEFAULT_BALL``.

    A :class:`clubface.Ball` made of pieces is meshed with its own mass and radius.
    """
    if isinstance(which, Ball):
        return which
    if isinstance(which, RigidBall):
        return _of_rigid(which)
    path = path_of("ball", DEFAULT_BALL if which is None else which, FOLDER)
    document = Document.read(path)
    if "pieces" not in document.data and not is_path(which):
        raise _no_pieces(which)
    return from_document(document)


def _of_rigid(given: RigidBall) -> Ball:
    made = given.construction
    if isinstance(made, Construction):
        with without_warnings():
            read = RigidBall.from_document(made.document)
        made = from_document(made.document)
    elif isinstance(made, Ball):
        read = made.rigid
    else:
        raise _no_pieces(given.name)
    changes: dict[str, Any] = {} if given.mass == read.mass else {"mass": given.mass}
    if given.radius != read.radius:
        changes["diameter"] = 2.0 * given.radius
    if given.friction not in (None, made.friction):
        changes["friction"] = given.friction
    return replace(made, **changes) if changes else made


def _no_pieces(name: object) -> InputError:
    return InputError("ball", name, f"one that is described by its pieces, for fem: {', '.join(ball_names())}")


def from_document(document: Document) -> Ball:
    """Read the ball a TOML document describes."""
    data = dict(document.data)
    size = "radius" if "radius" in data else "diameter"
    document.check_keys(data, KEYS, ("name", size, "pieces"))
    document.check_text(data, ("name", "description"))
    tables = data.pop("pieces")
    # These are of the other models; the inertia here is that of the pieces.
    check_parameters(document)
    check_sources(document)
    data = {key: value for key, value in data.items() if key not in ("inertia", "parameters", "sources")}
    if not (isinstance(tables, list) and all(isinstance(each, dict) for each in tables)):
        raise document.error("pieces must be tables, each under [[pieces]]", "pieces")
    pieces, branches = [], 0
    for number, table in enumerate(tables):
        pieces.append(read_piece(document, table, number, branches))
        branches += len(pieces[-1].material.maxwell)
    try:
        if size == "radius":
            data["diameter"] = 2.0 * units.parse(data.pop("radius"), "length", name="radius")
        return Ball(pieces=tuple(pieces), **data)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def node_masses(mesh: Mapping[str, Any]) -> NDArray[Any]:
    """Return each node's share of the mass of a ball's mesh, from elements taken as parallelepipeds."""
    nodes, elements = mesh["nodes"], mesh["elements"].astype(int)
    mass = element_masses(nodes, elements, np.asarray(mesh["density"])[mesh["piece"]])
    shares = np.zeros(len(nodes))
    np.add.at(shares, elements, mass[:, None] / 8.0)
    return shares / shares.sum()


def element_masses(nodes: NDArray[Any], elements: NDArray[Any], density: Any) -> NDArray[Any]:
    """Return the mass of each hexahedron, taken as a parallelepiped [kg]."""
    corner = nodes[elements]
    edges = [corner[:, [1, 2, 5, 6]].mean(axis=1) - corner[:, [0, 3, 4, 7]].mean(axis=1),
             corner[:, [2, 3, 6, 7]].mean(axis=1) - corner[:, [0, 1, 4, 5]].mean(axis=1),
             corner[:, 4:].mean(axis=1) - corner[:, :4].mean(axis=1)]  # fmt: skip
    return abs(np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])) * density
