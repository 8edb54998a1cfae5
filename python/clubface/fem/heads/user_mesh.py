"""A head from a user's mesh of shells or solid elements, with thickness and metal by group."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.described import FLAT
from clubface.errors import InputError, MeshWarning, UnknownNameError
from clubface.fem.balls import ELEMENTS
from clubface.fem.geometry import area_vectors, sums_at_nodes, unshared_sides
from clubface.fem.heads.added_mass import MASSES, Place, spread, spread_note
from clubface.fem.heads.mesh_frame import check_frame
from clubface.fem.heads.mesh_groups import (
    GROUP_TABLE,
    Group,
    assign,
    group_values,
    metals_of,
    names_solids,
    point_masses,
    walls,
)  # fmt: skip
from clubface.fem.heads.mesh_repair import Shells, repaired
from clubface.fem.heads.meshed import Bond, MeshedHead, Part, ShellHead, SolidHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.solid_mesh import facing_sides, solids_of_mesh
from clubface.fem.mesh_files import Mesh, read_mesh
from clubface.schema import (
    NAME,
    TEXT,
    Choice,
    FilePath,
    PhysicalValue,
    Record,
    Simple,
    Tables,
    check_values,
    file_key,
)  # fmt: skip
from clubface.support.checks import warn_once

SIZES = (0.06, 0.2)
"""Smallest and largest size of a head along an axis [m]; narrow enough to detect a wrong unit, even inches for
centimetres."""
AT_NODE = 2e-5
"""Distance within which a point mass of a mesh file is placed on a node [m]."""
REACHED = 0.012
"""Radius about the face centre that a ball covers in a fast drive [m]."""
FLUSH_COSINE = math.cos(math.radians(20.0))
"""Cosine of the angle to the face normal up to which elements of another group continue the face."""
FACE_COSINE = math.cos(math.radians(45.0))
"""Cosine of the angle to the face normal up to which the ball may touch an element of a face group."""


BOND_TABLE = Record(
    {"part": NAME, "to": NAME, "within": PhysicalValue("mm", 0, 2)},
    ("part", "to"),
    make=lambda values, _: Bond(**values),
)
RADIUS = PhysicalValue("mm", above=0, allowed=f'above 0 mm, or "{FLAT}"', special={FLAT: math.inf})


@dataclass(frozen=True, kw_only=True)
class MeshHead:
    """A head defined by a mesh file: shells on its middle surfaces, or solid elements.

    The axes of the file are x towards the target, y up and z towards the toe, with the club soled.

    Every element of the mesh must belong to one of the groups; if the groups are solid elements, surface elements are
    left out. Solid parts that share no nodes are joined by bonds.
    """

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence", default="")
    file: str | os.PathLike[str] = file_key(
        FilePath("a path"), "mesh file: Gmsh, Abaqus, Nastran, LS-DYNA, STL, or a format of meshlane"
    )
    unit: str = file_key(TEXT, "unit of the lengths in the mesh", default="mm")
    loft: float = file_key(PhysicalValue("deg", 0, 75), "elevation of the face normal at the face centre")
    bulge: float = file_key(RADIUS, "radius of the face from heel to toe", default=math.inf)
    roll: float = file_key(RADIUS, "radius of the face from sole to crown", default=math.inf)
    face_centre: tuple[Any, Any, Any] = file_key(
        Simple("three lengths"),
        "face centre in the mesh, on the outer side; numbers in the mesh's unit, or text with units",
        default=(0.0, 0.0, 0.0),
    )
    groups: tuple[Group, ...] = file_key(Tables(GROUP_TABLE), "thickness and metal of the parts of the mesh")
    element: str = file_key(Choice(ELEMENTS), "kind of hexahedra", default="one-point")
    bonds: tuple[Bond, ...] = file_key(Tables(BOND_TABLE, "bond"), "solid parts that are bonded to others", default=())
    masses: Mapping[str, Place] = file_key(
        MASSES, "added masses, at places relative to the face centre", default_factory=dict
    )

    def __post_init__(self) -> None:
        check_values(self)
        units.unit(self.unit, name="unit", dimension="length")
        _check_place("face_centre", self.face_centre)
        if not any(group.face for group in self.groups):
            raise InputError("groups", [group.name for group in self.groups], "groups, at least one with face = true")
        names = tuple(group.name for group in self.groups)
        for bond in self.bonds:
            for name in (bond.part, bond.to):
                if name not in names:
                    raise UnknownNameError("group of a bond", name, names)
            if bond.part == bond.to:
                raise InputError("bond", f"{bond.part} to itself", "two different groups")

    def mesh(self) -> ShellHead | SolidHead:
        """Read the file and return the head; warn about everything changed or left out.

        Raises
        ------
        FileError
            The file cannot be read, has elements unsuitable for a head, or has elements that belong to no group.
        InputError
            The mesh is not a head in the given unit, or disagrees with the given loft, radii or face centre.
        """
        path = os.fspath(self.file)
        mesh = read_mesh(path)
        solid = names_solids(mesh, self.groups)
        head = self._solid(mesh.solids) if solid and mesh.solids is not None else self._shells(mesh)
        for note in mesh.notes:
            warn_once(f"{path}: {note}", MeshWarning)
        return head

    def in_folder(self, folder: str | os.PathLike[str] | None) -> dict[str, Any]:
        """Return the values to write for a file in ``folder``, with the mesh's path relative to it."""
        path = os.fspath(self.file)
        if folder is not None:
            with suppress(ValueError):  # on another drive, keep the full path
                path = os.path.relpath(path, folder)
        return {
            "file": path.replace(os.sep, "/"), "groups": [group_values(group) for group in self.groups],
            "face_centre": [each if isinstance(each, str) else float(each) for each in self.face_centre],
            "bonds": [asdict(bond) for bond in self.bonds],
        }  # fmt: skip

    def _shells(self, mesh: Mesh) -> ShellHead:
        """Return a shell head of the mesh."""
        if self.bonds:
            raise InputError("bonds", [bond.part for bond in self.bonds], "none: shells are joined by shared nodes")
        of_group, is_face = assign(mesh, self.groups), np.array([group.face for group in self.groups])
        mesh.thickness, metals = walls(mesh, self.groups, of_group, self.unit)
        shells = repaired(mesh, of_group, is_face)
        nodes = self._from_face_centre(shells.points)
        masses, at_nodes = self._masses(mesh, nodes)
        face = is_face[shells.group]
        groups = [np.unique(shells.corners[shells.group == place]) for place in range(len(self.groups))]
        wall = float(shells.thickness[face].max())
        self._check_frame(mesh, nodes, shells.corners[face], wall, shells.node_ids != 0, groups, masses)
        self._note_rest_of_face(nodes, shells, face)
        parts = self._parts(nodes, shells, metals)
        face = np.unique(shells.corners[np.repeat([part.face for part in parts], [part.elements for part in parts])])
        area = np.linalg.norm(area_vectors(nodes, shells.corners), axis=1)
        weights = area * np.array([metal.density for metal in metals])[shells.group] * shells.thickness
        metal = sums_at_nodes(shells.corners, 0.25 * weights, len(nodes))
        head = ShellHead(
            quads=shells.corners, thickness=shells.thickness, parts=parts,
            **self._common_fields(mesh, nodes, metal + at_nodes, at_nodes, face, masses),
        )  # fmt: skip
        _weigh(head, shells.ids, shells.node_ids)
        return head

    def _solid(self, mesh: Mesh) -> SolidHead:
        """Return a solid head of the mesh."""
        of_group = assign(mesh, self.groups)
        metals = metals_of(mesh, self.groups, of_group, self.unit)
        names = [group.name for group in self.groups]
        solids = solids_of_mesh(mesh, of_group, names, metals, self.bonds)
        nodes = self._from_face_centre(solids.points)
        masses, at_nodes = self._masses(mesh, nodes)
        of_face = [part for group, part in zip(self.groups, solids.parts, strict=True) if group.face]
        # Interfaces between two parts of the face are not outer sides.
        outside = unshared_sides(np.concatenate([part.outside() for part in of_face]), 4)
        normal = np.array([math.cos(self.loft), math.sin(self.loft), 0.0])
        face = facing_sides(nodes, outside, normal, FACE_COSINE)
        if not len(face):
            allowed = "a group with outer sides that face the ball, within 45 deg of the face normal"
            raise InputError("face", ", ".join(part.name for part in of_face), allowed)
        groups = [np.unique(np.concatenate([part.hexahedra.ravel(), part.tetrahedra.ravel()])) for part in solids.parts]
        self._check_frame(mesh, nodes, face, 0.0, solids.node_ids != 0, groups, masses)
        metal = solids.metal_at_nodes(units.parse(f"1 {self.unit}", "length"))
        head = SolidHead(
            parts=solids.parts, face=face, bonds=self.bonds, element=self.element,
            **self._common_fields(mesh, nodes, metal + at_nodes, at_nodes, np.unique(face), masses, negligible=1e-2),
        )  # fmt: skip
        _weigh(head, solids.ids, solids.node_ids)
        return head

    def _common_fields(self, mesh: Mesh, nodes: NDArray[Any], metal: NDArray[Any], at_nodes: NDArray[Any],
                  face: NDArray[Any], masses: Mapping[str, Place], **negligible: float) -> dict[str, Any]:  # fmt: skip
        """Return the fields common to both kinds of head: name, shape, nodes, and added masses at nodes."""
        carried = spread(masses, nodes, metal, face)
        if (note := spread_note(carried, **negligible)) is not None:
            mesh.notes.append(note)
        own = {name: getattr(self, name) for name in ("name", "description", "loft", "bulge", "roll")}
        return own | {"nodes": nodes, "added": carried.added + at_nodes}

    def _from_face_centre(self, points: NDArray[Any]) -> NDArray[Any]:
        """Return points of the file relative to the face centre [m]."""
        self._check_unit(float(np.ptp(points, axis=0).max()))
        size = units.parse(f"1 {self.unit}", "length")
        return points * size - self._centre(size)

    def _centre(self, size: float) -> NDArray[Any]:
        return np.array([units.parse(x, "length") if isinstance(x, str) else x * size for x in self.face_centre])

    def _masses(self, mesh: Mesh, nodes: NDArray[Any]) -> tuple[dict[str, Place], NDArray[Any]]:
        """Return all added masses by place, including those of the mesh, and point masses at nodes of the mesh [kg]."""
        size = units.parse(f"1 {self.unit}", "length")
        masses, at_nodes = dict(self.masses), np.zeros(len(nodes))
        for number, (x, y, z, mass) in enumerate(point_masses(mesh, self.unit), 1):
            place = np.array([x, y, z]) * size - self._centre(size)
            away = np.linalg.norm(nodes - place, axis=1)
            if away.min() <= AT_NODE:
                at_nodes[np.argmin(away)] += mass
            else:
                masses[f"point mass {number} of the mesh"] = (float(place[0]), float(place[1]), float(place[2]), mass)
        return masses, at_nodes

    def _parts(self, nodes: NDArray[Any], shells: Shells, metals: Sequence[Metal]) -> tuple[Part, ...]:
        """Sort the shells by part and return the parts; elements of a face group that face away become a separate part.

        A face group may wrap around the edge, as in a cup face, or contain the whole head if the file has no sets.
        """
        toward = self._facing(nodes, shells)
        away = np.array([group.face for group in self.groups])[shells.group] & (toward < FACE_COSINE)
        order = np.lexsort((away, shells.group))
        shells.keep(order)
        away = away[order]
        parts = []
        for place, (group, metal) in enumerate(zip(self.groups, metals, strict=True)):
            own = shells.group == place
            for name, face, count in (
                (group.name, group.face, int((own & ~away).sum())),
                (beyond(group.name), False, int(away[own].sum())),
            ):  # fmt: skip
                if count:
                    parts.append(Part(name, count, metal, face))
                if count and name != group.name:
                    shells.mesh.notes.append(
                        f"{count} elements of {group.name} face away from the ball by more than 45 deg and do not"
                        " belong to the face that it may touch"
                    )
        return tuple(parts)

    def _check_unit(self, across: float) -> None:
        """Raise InputError if a head of extent ``across`` in the file is too large or too small in its unit."""
        sizes = {unit: units.parse(f"1 {unit}", "length") * across for unit in (self.unit, "mm", "cm", "in", "m")}
        fitting = [unit for unit, size in sizes.items() if SIZES[0] <= size <= SIZES[1]]
        if self.unit in fitting:
            return
        least, most = (units.show(each, "mm") for each in SIZES)
        shown = f"with this unit the head measures {units.show(sizes[self.unit], 'mm')}; {least} to {most} is allowed"
        better = " or ".join(f'unit = "{unit}"' for unit in fitting)
        hint = f"try {better}" if better else "no unit gives a plausible size"
        allowed = f'the length unit of {os.fspath(self.file)} (default "mm"): {shown}; {hint}'
        raise InputError("unit", self.unit, allowed)

    def _check_frame(
        self, mesh: Mesh, nodes: NDArray[Any], sides: NDArray[Any], wall: float, drawn: NDArray[Any],
        groups: Sequence[NDArray[Any]], masses: Mapping[str, Place],
    ) -> None:  # fmt: skip
        """Raise InputError if the face centre is not on the face, or the mesh disagrees with this head.

        ``sides`` are the elements of the face, ``wall`` [m] its thickness, and ``groups`` the nodes of each group.
        """
        corners = nodes[sides]
        near = float(np.linalg.norm(corners, axis=-1).min())
        side = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).max())
        shown = ", ".join(str(x) for x in self.face_centre)
        if near > side + wall:
            away = f"the nearest node of the face is {units.show(near, 'mm')} away"
            raise InputError("face_centre", shown, f"a point on the face, in {self.unit} as in the file; {away}")
        parts = {group.name: nodes[own] for group, own in zip(self.groups, groups, strict=True)}
        parts |= {name: np.array([place[:3]]) for name, place in masses.items()}
        check_frame(
            mesh, nodes, sides, drawn=drawn, loft=self.loft, bulge=self.bulge, roll=self.roll, wall=wall, centre=shown,
            parts=parts,
        )  # fmt: skip

    def _facing(self, nodes: NDArray[Any], shells: Shells) -> NDArray[Any]:
        """Return the cosine of the angle between each element's normal and the face normal."""
        normal = area_vectors(nodes, shells.corners)
        return normal @ [math.cos(self.loft), math.sin(self.loft), 0.0] / np.linalg.norm(normal, axis=1)

    def _note_rest_of_face(self, nodes: NDArray[Any], shells: Shells, face: NDArray[Any]) -> None:
        """Note groups outside the face that the ball reaches when struck at the face centre."""
        away = np.linalg.norm(nodes[shells.corners].mean(axis=1), axis=1)
        rest = ~face & (self._facing(nodes, shells) > FLUSH_COSINE) & (away < REACHED)
        for place in np.unique(shells.group[rest]):
            own = rest & (shells.group == place)
            shells.mesh.notes.append(
                f"{int(own.sum())} elements of {self.groups[place].name} continue the face within"
                f" {units.show(REACHED, 'mm')} of the face centre, the nearest"
                f" {units.fixed(float(away[own].min()), 'mm', 1)} from it, but do not belong to the face, and contact"
                " ends at its edge; assign them to a group with face = true"
            )


def beyond(group: str) -> str:
    """Return the name of the part with those elements of a face group that face away from the ball."""
    return f"{group}, beyond"


def _weigh(head: MeshedHead, ids: NDArray[Any], node_ids: NDArray[Any]) -> None:
    """Compute mass properties, so that the core checks the mesh; errors give element and node numbers of the file."""
    try:
        _ = head.club
    except InputError as error:

        def renumbered(pattern: str, numbers: NDArray[Any], text: str) -> str:
            return re.sub(pattern, lambda match: re.sub(r"\d+", lambda n: str(numbers[int(n[0])]), match[0]), text)

        error.parameter = renumbered(r"^element \d+(?= of )|elements \d+ and \d+", ids, error.parameter)
        if isinstance(error.value, str):
            error.value = type(error.value)(renumbered(r"^node \d+", node_ids, error.value))
        raise


def _check_place(name: str, given: Any) -> None:
    """Raise InputError unless the value is three lengths."""
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 3:
        raise InputError(name, given, "three lengths")
    for each in given:
        if isinstance(each, str):
            units.parse(each, "length", name=name)
        elif isinstance(each, bool) or not isinstance(each, int | float) or not math.isfinite(each):
            raise InputError(name, each, "three lengths")
