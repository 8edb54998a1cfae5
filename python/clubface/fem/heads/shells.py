"""A head of shells as the core takes it: a mesh with thickness and metal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.metal import Metal


@dataclass(frozen=True)
class Part:
    """Consecutive shells with one name.

    Attributes
    ----------
    name
        Its name, such as "crown".
    elements
        Number of shells.
    metal
        The metal.
    face
        Whether the ball may touch them.
    """

    name: str
    elements: int
    metal: Metal
    face: bool = False


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ShellHead(MeshedHead):
    """A head of four-node shells, in SI units.

    The axes are those of :class:`clubface.Club`; the origin is the face centre, on the outside.

    Attributes
    ----------
    name, description
        Name and description for tables.
    nodes
        Nodes of the middle surface [m], shape (n, 3).
    quads
        Nodes of each element, counterclockwise as seen from outside, shape (m, 4).
    thickness
        Thickness of each element [m].
    parts
        The parts, in the order of their elements.
    added
        Mass added to each node [kg].
    loft
        Elevation of the face normal at the face centre [rad].
    bulge, roll
        Radii of the face [m]. They say where the ball is placed; the ball touches the mesh.
    report
        What the head took to meet its targets, such as trim masses [kg] by name.
    asked
        The targets, under the names of :class:`DriverHead`, in SI units. A target that the bounds do not allow is
        missed.
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
    def elements(self) -> int:
        """Number of shells."""
        return len(self.quads)

    @property
    def reached(self) -> dict[str, float]:
        """The values that the head has, under the names of the targets of :class:`DriverHead`, in SI units."""
        names = ("mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz")
        return {**{name: float(getattr(self.club, name)) for name in names}, "cg_above": self.cg_above}

    @property
    def places(self) -> NDArray[Any]:
        """Places of its nodes on the outside of the walls [m]."""
        normals, walls = np.zeros((len(self.nodes), 3)), np.zeros(len(self.nodes))
        np.add.at(normals, self.quads, self._area_vectors[:, None])
        np.maximum.at(walls, self.quads, np.repeat(self.thickness[:, None], 4, axis=1))
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        return self.nodes + 0.5 * walls[:, None] * normals

    @property
    def volume(self) -> float | None:
        """What it displaces [m3], to the outside of its walls; None where the mesh is open, such as at a hosel."""
        sides = np.stack([self.quads, np.roll(self.quads, -1, axis=1)], axis=-1).reshape(-1, 2)
        if (np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)[1] != 2).any():
            return None
        area = self._area_vectors
        middle = self.nodes[self.quads].mean(axis=1)
        walls = np.linalg.norm(area, axis=1) @ self.thickness
        return float(np.einsum("ij,ij->", area, middle) / 3.0 + 0.5 * walls)

    @property
    def _area_vectors(self) -> NDArray[Any]:
        a, b, c, d = (self.nodes[self.quads[:, corner]] for corner in range(4))
        return 0.5 * np.cross(c - a, d - b)

    def part_of_elements(self) -> NDArray[Any]:
        """Return the number of the part of each element."""
        return np.repeat(np.arange(len(self.parts)), [part.elements for part in self.parts])

    def values(self) -> dict[str, Any]:
        """Return what the core takes."""
        parts = [
            {
                "name": part.name,
                "elements": part.elements,
                "youngs": part.metal.youngs,
                "poisson": part.metal.poisson,
                "density": part.metal.density,
                "plastic": part.metal.plastic(),
                "points": part.metal.points,
                "rule": part.metal.rule,
                "face": part.face,
            }
            for part in self.parts
        ]
        return {
            "nodes": np.ascontiguousarray(self.nodes, float).reshape(-1),
            "quads": np.ascontiguousarray(self.quads, np.uint32).reshape(-1),
            "thickness": np.ascontiguousarray(self.thickness, float),
            "added": np.ascontiguousarray(self.added, float),
            "parts": parts,
            "loft": self.loft,
        }

    def face_places(self) -> NDArray[Any]:
        """Return the places of the nodes of the face [m]."""
        chosen = [number for number, part in enumerate(self.parts) if part.face]
        return self.nodes[np.unique(self.quads[np.isin(self.part_of_elements(), chosen)])]
