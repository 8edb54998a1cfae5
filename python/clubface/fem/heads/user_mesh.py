"""A head from your own mesh of quadrilaterals, read through meshio: thickness and metal by group."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from clubface import units
from clubface.equipment.described import FLAT
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.fem.heads.mesh_file import group_names, read_mesh
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.places import Place, parsed_places, spread
from clubface.fem.heads.shells import Part, ShellHead
from clubface.support.checks import check_name, check_text

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIZES = (0.02, 0.4)
"""Least and largest size of a head along an axis [m]."""


@dataclass(frozen=True, kw_only=True)
class Group:
    """The shells of one group of the mesh.

    Attributes
    ----------
    name
        Its name in the file: a physical group or cell set, or the number of a group.
    thickness
        Thickness [m].
    metal
        The metal.
    face
        Whether the ball may touch them.
    """

    name: str
    thickness: Any
    metal: Metal = field(default_factory=Metal)
    face: bool = False

    def __post_init__(self) -> None:
        check_name(self.name)
        object.__setattr__(self, "thickness", units.parse(self.thickness, "length", name="thickness"))
        if not 2e-4 <= self.thickness <= 0.02:
            raise InputError(f"thickness of {self.name}", units.show(self.thickness, "mm"), "0.2 to 20 mm")
        if not isinstance(self.face, bool):
            raise InputError(f"face of {self.name}", self.face, "true or false")


@dataclass(frozen=True, kw_only=True)
class MeshHead:
    """A head whose middle surface is a mesh in a file.

    The axes of the file are x towards the target, y up and z towards the toe, with the club soled.

    Attributes
    ----------
    name, description
        Name and description for tables.
    file
        A file with quadrilaterals in any format of meshio.
    groups
        The groups; every quadrilateral belongs to one of them.
    loft
        Elevation of the face normal at the face centre [rad].
    unit
        Unit of the lengths in the file, such as "mm".
    face_centre
        Place of the face centre in the file, on the outer side of the face: numbers in that unit, or text with units.
    bulge, roll
        Radii of the face [m], or "flat".
    masses
        Added masses by name: (x, y, z, mass), the place counted from the face centre.
    """

    name: str
    file: str | os.PathLike[str]
    groups: tuple[Group, ...]
    loft: Any
    unit: str = "mm"
    face_centre: tuple[Any, Any, Any] = (0.0, 0.0, 0.0)
    bulge: Any = FLAT
    roll: Any = FLAT
    masses: Mapping[str, Place] = field(default_factory=dict)
    description: str = ""

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("description", self.description)
        check_text("unit", self.unit)
        units.unit(self.unit, name="unit", dimension="length")
        object.__setattr__(self, "loft", units.parse(self.loft, "angle", name="loft"))
        for key in ("bulge", "roll"):
            value = getattr(self, key)
            flat = value in (FLAT, math.inf)
            object.__setattr__(self, key, math.inf if flat else units.parse(value, "length", name=key))
            if not getattr(self, key) > 0.0:
                raise InputError(key, value, f'above 0 mm, or "{FLAT}"')
        if not 0.0 <= self.loft <= units.parse("75 deg", "angle"):
            raise InputError("loft", units.show(self.loft, "deg"), "0 to 75 deg")
        object.__setattr__(self, "masses", parsed_places(self.masses, "mass"))
        _check_place("face_centre", self.face_centre)
        if not any(group.face for group in self.groups):
            raise InputError("groups", [group.name for group in self.groups], "groups, at least one with face = true")

    def mesh(self) -> ShellHead:
        """Read the file and return the head.

        Raises
        ------
        FileError
            The file cannot be read, has no quadrilaterals, or has some that belong to no group.
        InputError
            The mesh is no head in the given unit, or the face centre is not on the face.
        """
        import numpy as np

        points, quads, of_group = self._read()
        size = units.parse(f"1 {self.unit}", "length")
        order = np.argsort(of_group, kind="stable")
        quads, of_group = quads[order], of_group[order]
        used, quads = np.unique(quads, return_inverse=True)
        self._check_unit(float(np.ptp(points[used], axis=0).max()))
        centre = [units.parse(x, "length") if isinstance(x, str) else x * size for x in self.face_centre]
        nodes = points[used] * size - np.asarray(centre, float)
        counts = np.bincount(of_group, minlength=len(self.groups))
        if not counts.all():
            empty = self.groups[int(np.argmin(counts))].name
            raise FileError(os.fspath(self.file), None, f"no element belongs to the group {empty!r}")
        self._check_centre(nodes, quads.reshape(-1, 4), np.array([group.face for group in self.groups])[of_group])
        parts = tuple(
            Part(group.name, int(count), group.metal, group.face)
            for group, count in zip(self.groups, counts, strict=True)
        )
        return ShellHead(
            name=self.name,
            description=self.description,
            nodes=nodes,
            quads=quads.reshape(-1, 4),
            thickness=np.array([group.thickness for group in self.groups])[of_group],
            added=spread(self.masses, nodes),
            parts=parts,
            loft=self.loft,
            bulge=self.bulge,
            roll=self.roll,
        )

    def _check_unit(self, across: float) -> None:
        """Refuse a unit in which a head that measures ``across`` in the file would be too large or too small."""

        def size(unit: str) -> float:
            return units.parse(f"1 {unit}", "length") * across

        def fits(unit: str) -> bool:
            return SIZES[0] <= size(unit) <= SIZES[1]

        if fits(self.unit):
            return
        least, most = (units.show(each, "mm") for each in SIZES)
        found = f"with it the size of the head is {units.show(size(self.unit), 'mm')}, {least} to {most} is allowed"
        better = " or ".join(f'unit = "{unit}"' for unit in ("mm", "cm", "in", "m") if fits(unit))
        hint = f"try {better}" if better else "no unit makes a head of this mesh"
        allowed = f'the unit of lengths in {os.fspath(self.file)}, "mm" where left out: {found}; {hint}'
        raise InputError("unit", self.unit, allowed)

    def _check_centre(self, nodes: NDArray[Any], quads: NDArray[Any], face: NDArray[Any]) -> None:
        """Refuse a face centre that is not on the face; nodes [m] count from it."""
        import numpy as np

        corners = nodes[quads[face]]
        near = float(np.linalg.norm(corners, axis=-1).min())
        side = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).max())
        if near > side + max(group.thickness for group in self.groups):
            shown = ", ".join(str(x) for x in self.face_centre)
            away = f"the nearest node of the face is {units.show(near, 'mm')} away"
            raise InputError("face_centre", shown, f"a place on the face, in {self.unit} as the file: {away}")

    def _read(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Return points in the unit of the file, quadrilaterals, and the number of the group of each."""
        import numpy as np

        path = os.fspath(self.file)
        mesh = read_mesh(path)
        blocks = [(number, data) for number, (kind, data) in enumerate(mesh.cells) if kind == "quad"]
        others = sorted({kind for kind, _ in mesh.cells if kind not in ("quad", "line", "vertex")})
        if not blocks or others:
            found = ", ".join(others) or "none"
            raise FileError(
                path, None, f"the head must be all quadrilaterals; there are elements of other kinds: {found}"
            )
        names = group_names(mesh, path)
        known = {group.name: place for place, group in enumerate(self.groups)}
        quads, of_group = [], []
        for number, data in blocks:
            for name in names[number]:
                if name not in known:
                    raise FileError(path, None, str(UnknownNameError("group of the mesh", name, tuple(known))))
            quads.append(np.asarray(data))
            of_group.append(np.array([known[name] for name in names[number]], dtype=np.int64))
        points = np.zeros((len(mesh.points), 3))
        points[:, : mesh.points.shape[1]] = mesh.points
        if not np.isfinite(points).all():
            raise FileError(path, None, f"node {int(np.argmin(np.isfinite(points).all(axis=1)))} has no place")
        return points, np.concatenate(quads), np.concatenate(of_group)


def _check_place(name: str, given: Any) -> None:
    """Refuse what is not three lengths."""
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 3:
        raise InputError(name, given, "three lengths")
    for each in given:
        if isinstance(each, str):
            units.parse(each, "length", name=name)
        elif isinstance(each, bool) or not isinstance(each, int | float) or not math.isfinite(each):
            raise InputError(name, each, "three lengths")
