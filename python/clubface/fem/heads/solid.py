"""A solid head as the core takes it: hexahedra of one metal."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.metal import Metal
from clubface.fem.materials import Material

ROUND = (0, 1, 3, 2, 4, 5, 7, 6)
"""Corners of an element round the bottom, then round the top, from their binary order, and back."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SolidHead(MeshedHead):
    """A head of eight-node hexahedra with a flat face.

    Attributes
    ----------
    name, description
        Name and description for tables.
    nodes
        Nodes [m], shape (n, 3).
    hexahedra
        Nodes of each element, round the bottom, then round the top, shape (m, 8).
    face
        Quadrilaterals that the ball may touch, counterclockwise as seen from outside, shape (k, 4).
    metal
        The metal.
    added
        Mass added to each node [kg].
    loft
        Elevation of the face normal at the face centre [rad].
    grooves
        "width", "depth", "pitch" and "wall" of the grooves [m], or None.
    element
        "one-point" or "full".
    report
        Added masses [kg] by name.
    """

    name: str
    nodes: NDArray[Any]
    hexahedra: NDArray[Any]
    face: NDArray[Any]
    added: NDArray[Any]
    loft: float
    metal: Metal = field(default_factory=Metal)
    grooves: Mapping[str, float] | None = None
    element: str = "one-point"
    description: str = ""
    report: Mapping[str, float] = field(default_factory=dict)
    bulge: float = math.inf
    roll: float = math.inf

    @property
    def elements(self) -> int:
        """Number of hexahedra."""
        return len(self.hexahedra)

    @property
    def places(self) -> NDArray[Any]:
        """Places of its nodes [m]."""
        return self.nodes

    def face_places(self) -> NDArray[Any]:
        """Return the places of the nodes of the face [m]."""
        return self.nodes[np.unique(self.face)]

    def values(self) -> dict[str, Any]:
        """Return what the core takes."""
        material = Material.linear(self.metal.youngs, self.metal.poisson, density=self.metal.density)
        return {
            "nodes": np.ascontiguousarray(self.nodes, float).reshape(-1),
            "elements": np.ascontiguousarray(self.hexahedra[:, ROUND], np.uint32).reshape(-1),
            "face": np.ascontiguousarray(self.face, np.uint32).reshape(-1),
            "added": np.ascontiguousarray(self.added, float),
            "shear": material.shear,
            "bulk": material.bulk,
            "density": self.metal.density,
            "plastic": self.metal.plastic(),
            "element": self.element,
            "loft": self.loft,
            "grooves": None if self.grooves is None else list(self.grooves.values()),
        }
