"""A head of shells as the core takes it: a mesh with thickness and metal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from clubface.clubs import Club
from clubface.errors import InputError
from clubface.fem.heads.metal import Metal

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Part:
    """Shells of one name, which follow each other.

    Attributes
    ----------
    name
        Such as "crown".
    elements
        How many.
    metal
        What they are made of.
    face
        Whether the ball may touch them.
    """

    name: str
    elements: int
    metal: Metal
    face: bool = False


@dataclass(frozen=True, kw_only=True, eq=False)
class ShellHead:
    """A head of four-node shells, SI. Axes as of :class:`clubface.Club`; the origin is the face centre, on the outside.

    Attributes
    ----------
    name, description
        For tables.
    nodes
        Of the middle surface [m], shape (n, 3).
    quads
        Nodes of each element, counterclockwise seen from outside, shape (m, 4).
    thickness
        Of each element [m].
    parts
        In the order of their elements.
    added
        Mass added to each node [kg].
    loft
        Elevation of the face normal at the face centre [rad].
    bulge, roll
        Radii of the face [m]; they say where the ball is placed, the mesh is what it touches.
    report
        How the head came about, such as trim masses [kg] by name.
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

    @property
    def elements(self) -> int:
        """Number of shells."""
        return len(self.quads)

    def part_of_elements(self) -> NDArray[Any]:
        """Return the number of the part of each element."""
        import numpy as np

        return np.repeat(np.arange(len(self.parts)), [part.elements for part in self.parts])

    def values(self) -> dict[str, Any]:
        """Return what the core takes."""
        import numpy as np

        parts = [
            {
                "name": part.name,
                "elements": part.elements,
                "youngs": part.metal.youngs,
                "poisson": part.metal.poisson,
                "density": part.metal.density,
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

    @cached_property
    def club(self) -> Club:
        """The same head as a rigid one: mass, CG and inertia of the mesh, for any model."""
        import numpy as np

        from clubface import _core
        from clubface.fem.core import told

        with told():
            found = _core.fem_head_properties(self.values())
        part = self.part_of_elements()
        face = np.isin(part, [number for number, each in enumerate(self.parts) if each.face])
        places = self.nodes[np.unique(self.quads[face])]
        size = places.max(axis=0) - places.min(axis=0)
        # The ball's place is taken from the face centre: the outline about it that holds the whole face.
        width, height = 2.0 * float(np.abs(places[:, 2]).max()), float(np.hypot(size[0], size[1]))
        x, y, z = (-float(value) for value in found["centre"])
        tensor = [[float(value) for value in row] for row in found["inertia"]]
        return Club(
            name=self.name,
            kind="iron" if np.isinf(self.bulge) else "wood",
            mass=float(found["mass"]),
            cg_x=x,
            cg_y=y,
            cg_z=z,
            ixx=tensor[0][0],
            iyy=tensor[1][1],
            izz=tensor[2][2],
            ixy=tensor[0][1],
            ixz=tensor[0][2],
            iyz=tensor[1][2],
            loft=self.loft,
            bulge=self.bulge,
            roll=self.roll,
            face_width=width,
            face_height=height,
            description=self.description,
        )

    def __repr__(self) -> str:
        club = self.club
        return f"<head {self.name}: {self.elements} shells, {club.mass * 1e3:.1f} g>"


def check_arrays(head: ShellHead) -> None:
    """Refuse arrays whose shapes do not fit."""
    import numpy as np

    count = len(head.nodes)
    wanted = {"nodes": (count, 3), "quads": (len(head.quads), 4), "thickness": (len(head.quads),), "added": (count,)}
    for name, shape in wanted.items():
        found = np.shape(getattr(head, name))
        if found != shape:
            raise InputError(f"{name} of {head.name}", f"shape {found}", f"shape {shape}")
