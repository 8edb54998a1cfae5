"""Meshed heads of shells or solid elements: common properties, and conversion to the core's format."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.clubs import CLUB_PROPERTIES, Club
from clubface.fem.core import in_thread
from clubface.fem.geometry import area_vectors, outer_quads, triangles
from clubface.fem.heads.metal import Metal
from clubface.fem.materials import Material


class MeshedHead(ABC):
    """A finite element head, in SI units.

    The axes are those of :class:`clubface.Club`; the origin is the face centre on the outside.

    Attributes
    ----------
    name, description
        Name and description shown in tables.
    nodes
        Nodes [m], shape (n, 3); for shells on the middle surface.
    added
        Added mass at each node [kg].
    loft
        Elevation of the face normal at the face centre [rad].
    bulge, roll
        Radii of the face [m]. They position the ball, which then touches the mesh.
    report
        Added masses [kg] by name, and other adjustments made to meet targets.
    """

    name: str
    nodes: NDArray[Any]
    added: NDArray[Any]
    loft: float
    bulge: float
    roll: float
    description: str
    report: Mapping[str, float]

    @abstractmethod
    def values(self) -> dict[str, Any]:
        """Return the head in the core's format."""

    @abstractmethod
    def face_places(self) -> NDArray[Any]:
        """Return the positions of the face's nodes [m]."""

    @abstractmethod
    def part_of_elements(self) -> NDArray[Any]:
        """Return the part number of each element."""

    @property
    def elements(self) -> int:
        """Number of elements."""
        return len(self.part_of_elements())

    @property
    def volume(self) -> float | None:
        """Displaced volume [m3]; None if the surface is open or the volume is unknown."""
        return None

    @property
    def size(self) -> tuple[float, float, float]:
        """Extent of the soled head [m]: face to back, sole to crown, heel to toe."""
        depth, height, length = np.ptp(self.places, axis=0).tolist()
        return depth, height, length

    @property
    def places(self) -> NDArray[Any]:
        """Points [m], shape (n, 3), whose convex hull contains the head."""
        return self.nodes

    @cached_property
    def club(self) -> Club:
        """The equivalent rigid club, with the mesh's mass, CG and inertia, for any model."""
        weighed = in_thread(core.fem_head_properties, self.values())
        places = self.face_places()
        size = np.ptp(places, axis=0)
        tensor = np.asarray(weighed["inertia"], float)
        inertia: dict[str, Any] = {f"i{'xyz'[i]}{'xyz'[j]}": float(tensor[i, j]) for i in range(3) for j in range(i, 3)}
        cg: dict[str, Any] = {f"cg_{axis}": -float(value) for axis, value in zip("xyz", weighed["centre"], strict=True)}
        return Club(
            name=self.name, description=self.description, kind="iron" if np.isinf(self.bulge) else "wood",
            mass=float(weighed["mass"]), loft=self.loft, bulge=self.bulge, roll=self.roll, **cg, **inertia,
            # An outline centred on the face centre that contains the whole face.
            face_width=2.0 * float(np.abs(places[:, 2]).max()), face_height=float(np.hypot(size[0], size[1])),
        )  # fmt: skip

    @property
    def cg_above(self) -> float:
        """Height of the CG above the face normal through the face centre, along the face [m]."""
        return self.club.cg_x * math.sin(self.loft) - self.club.cg_y * math.cos(self.loft)

    def as_club(self, **changes: Any) -> MeshedClub:
        """Return a club with this mesh for finite elements, and the equivalent rigid head for all other models.

        ``changes`` are those of :meth:`clubface.Club.replace`, for properties that a mesh does not have.
        """
        rigid = self.club.replace(**changes) if changes else self.club
        return MeshedClub(**{each.name: getattr(rigid, each.name) for each in fields(Club)}, head=self)

    def __repr__(self) -> str:
        return f"<head {self.name}: {self.elements} elements, {units.fixed(self.club.mass, 'g', 1)}>"


@dataclass(frozen=True, kw_only=True)
class MeshedClub(Club):
    """A club read from a meshed head's file, which keeps the mesh."""

    head: MeshedHead = field(repr=False)

    def replace(self, **changes: Any) -> Self:
        """Return a copy with fields changed; changes of mass, inertia or shape give a rigid club without a mesh."""
        if OF_THE_MESH & set(changes):
            plain = Club(**{each.name: getattr(self, each.name) for each in fields(Club)})
            return plain.replace(**changes)  # pyright: ignore[reportReturnType]
        return super().replace(**changes)


OF_THE_MESH = set(CLUB_PROPERTIES) - {"characteristic_time", "cor"}
"""Club fields that the mesh determines."""


def mesh_of(club: Any) -> MeshedHead | None:
    """Return the mesh of a head or club, or None if it is rigid."""
    return club if isinstance(club, MeshedHead) else club.head if isinstance(club, MeshedClub) else None


ROUND = (0, 1, 3, 2, 4, 5, 7, 6)
"""Permutation of a hexahedron's corners from binary order to around the bottom, then the top, and back."""


@dataclass(frozen=True, kw_only=True, eq=False)
class SolidPart:
    """Solid elements of one part with one metal.

    Attributes
    ----------
    name
        Name of the part, such as "face".
    metal
        The metal.
    hexahedra
        Nodes of hexahedra, around the bottom, then around the top, shape (m, 8).
    tetrahedra
        Nodes of tetrahedra, corners first, then mid-edge nodes in the order of
        :data:`clubface.fem.geometry.EDGES`, shape (k, 10).
    """

    name: str
    metal: Metal
    hexahedra: NDArray[Any] = field(default_factory=lambda: np.zeros((0, 8), np.int64), repr=False)
    tetrahedra: NDArray[Any] = field(default_factory=lambda: np.zeros((0, 10), np.int64), repr=False)

    def outside(self) -> NDArray[Any]:
        """Return the outer sides of the elements as quadrilaterals; a triangle repeats its last corner."""
        return outer_quads(self.hexahedra, self.tetrahedra)


@dataclass(frozen=True, kw_only=True)
class Bond:
    """Bond between the surfaces of two parts, where they lie on each other.

    Attributes
    ----------
    part
        Part whose nodes are tied; preferably the one with smaller elements.
    to
        Part to whose surface they are tied.
    within
        Largest distance between the two surfaces [m]. Nodes are moved by it, onto the other surface.
    """

    part: str
    to: str
    within: float = 1e-4


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SolidHead(MeshedHead):
    """A head of hexahedra and ten-node tetrahedra.

    Attributes
    ----------
    parts
        The parts.
    face
        Quadrilaterals that the ball may touch, counterclockwise as seen from outside, shape (k, 4); a triangle repeats
        its last corner.
    bonds
        Bonds between parts that share no nodes.
    grooves
        "width", "depth", "pitch" and "wall" of the grooves [m]; None for a plain face.
    element
        Kind of hexahedra, "one-point" or "full".
    """

    name: str
    nodes: NDArray[Any]
    parts: tuple[SolidPart, ...]
    face: NDArray[Any]
    added: NDArray[Any]
    loft: float
    bonds: tuple[Bond, ...] = ()
    grooves: Mapping[str, float] | None = None
    element: str = "one-point"
    description: str = ""
    report: Mapping[str, float] = field(default_factory=dict)
    bulge: float = math.inf
    roll: float = math.inf

    @cached_property
    def hexahedra(self) -> NDArray[Any]:
        """Hexahedra of all parts."""
        return np.concatenate([part.hexahedra for part in self.parts])

    @cached_property
    def tetrahedra(self) -> NDArray[Any]:
        """Tetrahedra of all parts; in results they follow the hexahedra."""
        return np.concatenate([part.tetrahedra for part in self.parts])

    def part_of_elements(self) -> NDArray[Any]:
        hexahedra, tetrahedra = ([len(each) for each in kind] for kind in zip(
            *((part.hexahedra, part.tetrahedra) for part in self.parts), strict=True))  # fmt: skip
        numbers = np.arange(len(self.parts))
        return np.concatenate([np.repeat(numbers, hexahedra), np.repeat(numbers, tetrahedra)])

    def face_places(self) -> NDArray[Any]:
        return self.nodes[np.unique(self.face)]

    def values(self) -> dict[str, Any]:
        parts = []
        for part in self.parts:
            material = Material.linear(part.metal.youngs, part.metal.poisson, density=part.metal.density)
            parts.append({
                "name": part.name, "hexahedra": len(part.hexahedra), "tetrahedra": len(part.tetrahedra),
                "element": self.element, "shear": material.shear, "bulk": material.bulk,
                "density": part.metal.density, "plastic": part.metal.plastic(),
            })  # fmt: skip
        names = [part.name for part in self.parts]
        outside = {name: triangles(self.parts[names.index(name)].outside()).ravel().tolist()
                   for bond in self.bonds for name in (bond.part, bond.to)}  # fmt: skip
        bonds = [
            {"name": f"{bond.part} to {bond.to}", "part": names.index(bond.part), "surface": outside[bond.part],
             "other": outside[bond.to], "within": bond.within}
            for bond in self.bonds
        ]  # fmt: skip
        return {"solid": {
            "nodes": self.nodes.ravel().tolist(), "hexahedra": self.hexahedra[:, ROUND].ravel().tolist(),
            "tetrahedra": self.tetrahedra.ravel().tolist(), "parts": parts, "bonds": bonds,
            "face": self.face.ravel().tolist(), "added": self.added.tolist(), "loft": self.loft,
            "grooves": None if self.grooves is None else dict(self.grooves),
        }}  # fmt: skip


@dataclass(frozen=True)
class Part:
    """A named run of ``elements`` consecutive shells, such as "crown"; ``face`` says whether the ball may touch it."""

    name: str
    elements: int
    metal: Metal
    face: bool = False


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ShellHead(MeshedHead):
    """A head of four-node shells.

    Attributes
    ----------
    quads
        Nodes of each element, counterclockwise as seen from outside, shape (m, 4).
    thickness
        Thickness of each element [m].
    parts
        The parts, in the order of their elements.
    asked
        Targets under the names used by :class:`clubface.fem.DriverHead`, in SI units; the head may miss a target that
        its limits do not allow.
    """

    name: str
    nodes: NDArray[Any]
    quads: NDArray[Any]
    thickness: NDArray[Any]
    parts: tuple[Part, ...]
    added: NDArray[Any]
    loft: float
    bulge: float
    roll: float
    description: str = ""
    report: Mapping[str, float] = field(default_factory=dict)
    asked: Mapping[str, float] = field(default_factory=dict)

    @property
    def reached(self) -> dict[str, float]:
        """Actual values of the head [SI], under the names of the targets of :class:`clubface.fem.DriverHead`."""
        names = ("mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz")
        return {**{name: float(getattr(self.club, name)) for name in names}, "cg_above": self.cg_above}

    @property
    def places(self) -> NDArray[Any]:
        """Nodes moved to the outside of the walls [m]."""
        normals, walls = np.zeros((len(self.nodes), 3)), np.zeros(len(self.nodes))
        np.add.at(normals, self.quads, area_vectors(self.nodes, self.quads)[:, None])
        np.maximum.at(walls, self.quads, np.repeat(self.thickness[:, None], 4, axis=1))
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        return self.nodes + 0.5 * walls[:, None] * normals

    @property
    def volume(self) -> float | None:
        """Volume enclosed by the outside of the walls [m3]; None if the mesh is open, such as at a hosel."""
        sides = np.stack([self.quads, np.roll(self.quads, -1, axis=1)], axis=-1).reshape(-1, 2)
        if (np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)[1] != 2).any():
            return None
        area = area_vectors(self.nodes, self.quads)
        middle = self.nodes[self.quads].mean(axis=1)
        walls = np.linalg.norm(area, axis=1) @ self.thickness
        return float(np.einsum("ij,ij->", area, middle) / 3.0 + 0.5 * walls)

    def part_of_elements(self) -> NDArray[Any]:
        return np.repeat(np.arange(len(self.parts)), [part.elements for part in self.parts])

    def values(self) -> dict[str, Any]:
        parts = [
            {key: getattr(part.metal, key) for key in ("youngs", "poisson", "density", "points", "rule")}
            | {"name": part.name, "elements": part.elements, "plastic": part.metal.plastic(), "face": part.face}
            for part in self.parts
        ]
        return {"shells": {
            "nodes": self.nodes.ravel().tolist(), "quads": self.quads.ravel().tolist(),
            "thickness": self.thickness.tolist(), "added": self.added.tolist(), "parts": parts, "loft": self.loft,
        }}  # fmt: skip

    def face_places(self) -> NDArray[Any]:
        chosen = [number for number, part in enumerate(self.parts) if part.face]
        return self.nodes[np.unique(self.quads[np.isin(self.part_of_elements(), chosen)])]
