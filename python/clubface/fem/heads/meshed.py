"""The common interface of all meshed heads: mass, inertia and a face."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import CLUB_PROPERTIES, Club
from clubface.fem import core
from clubface.fem.core import beside


class MeshedHead(ABC):
    """A head of elements, in SI units.

    The axes are those of :class:`clubface.Club`; the origin is the face centre, on the outside.
    """

    name: str
    description: str
    loft: float
    bulge: float
    roll: float
    report: Mapping[str, float]

    @property
    @abstractmethod
    def elements(self) -> int:
        """Number of elements."""

    @abstractmethod
    def values(self) -> dict[str, Any]:
        """Return what the core takes."""

    @abstractmethod
    def face_places(self) -> NDArray[Any]:
        """Return the places of the nodes of the face [m]."""

    @property
    def volume(self) -> float | None:
        """What it displaces [m3]; None where its surface is open, or where it is not known."""
        return None

    @property
    def size(self) -> tuple[float, float, float]:
        """Its size as soled: from face to back, from sole to crown, from heel to toe [m]."""
        depth, height, length = (self.places.max(axis=0) - self.places.min(axis=0)).tolist()
        return depth, height, length

    @property
    @abstractmethod
    def places(self) -> NDArray[Any]:
        """Places of points of its surface [m], shape (n, 3); all of it lies within their convex hull."""

    @cached_property
    def club(self) -> Club:
        """The same head as a rigid club, with mass, CG and inertia of the mesh, for any model."""
        found = beside(core.fem_head_properties, self.values())
        places = self.face_places()
        size = places.max(axis=0) - places.min(axis=0)
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
            # The outline about the face centre that holds the whole face.
            face_width=2.0 * float(np.abs(places[:, 2]).max()),
            face_height=float(np.hypot(size[0], size[1])),
            description=self.description,
        )

    @property
    def cg_above(self) -> float:
        """How far the CG lies above the face normal through the face centre, along the face [m]."""
        return self.club.cg_x * math.sin(self.loft) - self.club.cg_y * math.cos(self.loft)

    def as_club(self, **changes: Any) -> MeshedClub:
        """Return the club that finite elements take as this mesh and every other model as the rigid head.

        ``changes`` are those of :meth:`clubface.Club.replace`, for what a mesh does not say.
        """
        rigid = self.club.replace(**changes) if changes else self.club
        return MeshedClub(**{each.name: getattr(rigid, each.name) for each in fields(Club)}, head=self)

    def __repr__(self) -> str:
        return f"<head {self.name}: {self.elements} elements, {units.fixed(self.club.mass, 'g', 1)}>"


@dataclass(frozen=True, kw_only=True)
class MeshedClub(Club):
    """A club that was read from the file of a meshed head, and keeps the mesh.

    Attributes
    ----------
    head
        The mesh.
    """

    head: MeshedHead = field(repr=False)

    def replace(self, **changes: Any) -> Self:
        """Return it with fields changed; with other mass, inertia or shape it is a rigid club without a mesh."""
        if OF_THE_MESH & set(changes):
            plain = Club(**{each.name: getattr(self, each.name) for each in fields(Club)})
            return plain.replace(**changes)  # pyright: ignore[reportReturnType]
        return super().replace(**changes)


OF_THE_MESH = set(CLUB_PROPERTIES) - {"characteristic_time", "cor"}
"""What a mesh says of a club."""


def mesh_of(club: Any) -> MeshedHead | None:
    """Return the mesh of a head, or of a club that has one; None for a rigid one."""
    return club if isinstance(club, MeshedHead) else club.head if isinstance(club, MeshedClub) else None
