"""Families of heads: the variables a study may change in its starting head, and the resulting heads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError, TargetWarning, Wording
from clubface.fem.geometry import area_vectors, sums_at_nodes
from clubface.fem.heads.added_mass import spread
from clubface.fem.heads.mesh_groups import Group
from clubface.fem.heads.meshed import ShellHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.parametric import DRIVER_SHAPES, WALLS, DriverHead
from clubface.fem.heads.user_mesh import MeshHead, beyond
from clubface.support.checks import check_choice, check_names, without_warnings
from clubface.support.files import input_file

MOST_CHOICES = 50
"""Maximum number of metal choices in a study; each takes a separate search."""
SCALED = ("crown", "sole", "skirt")
"""Walls scaled to meet the target mass, unless they are variables."""
ELEMENTS = (12, 6, 8)
"""Maximum numbers of elements of a driver's coarse mesh: its mass is within 0.1%, in a third of the usual time."""
Head = DriverHead | MeshHead


@dataclass(frozen=True, kw_only=True)
class NamedMetal:
    """A named metal and the source of its properties.

    It may be assigned to ``groups`` of a mesh, all together; empty for all groups that no other metal names.
    """

    name: str
    metal: Metal
    source: str = ""
    groups: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class MetalChoice:
    """One assignment of metals to the groups of a head; the key "" stands for all groups that are not named."""

    name: str
    metals: Mapping[str, NamedMetal]

    def of_group(self, group: str) -> NamedMetal | None:
        """Return the metal of a group; None if the head keeps its own."""
        return self.metals.get(group, self.metals.get(""))


def elastic(metal: Metal) -> Metal:
    """Return the metal without yielding."""
    return replace(metal, yield_stress=None, hardening=None, points=None)


def metal_choices(metals: Sequence[NamedMetal], groups: Sequence[str]) -> tuple[MetalChoice, ...]:
    """Return all combinations of metals for a head; without ``metals``, only the head's own.

    Metals with the same ``groups`` are alternatives for them; metals without groups are alternatives for all others. A
    head of one metal has no groups. An unknown group, or one with two lists of metals, raises an ``InputError``.
    """
    if not metals:
        return (MetalChoice(name="that of the head", metals={}),)
    alternatives: dict[tuple[str, ...], list[NamedMetal]] = {}
    for each in metals:
        if each.groups and not groups:
            raise InputError(f"groups of {each.name}", list(each.groups), "left out: this head has one metal")
        check_names(f"groups of {each.name}", each.groups, groups)
        named = tuple(group for group in groups if group in each.groups)
        for others in alternatives:
            if others != named and (both := set(others) & set(named)):
                first = alternatives[others][0].name
                message = f"either the groups of {first} or other groups: {min(both)} would have two lists of metals"
                raise InputError(f"groups of {each.name}", list(each.groups), message)
        alternatives.setdefault(named, []).append(each)
    choices = []
    for chosen in product(*alternatives.values()):
        names, by_group = [], {}
        for named, metal in zip(alternatives, chosen, strict=True):
            names.append(f"{' and '.join(named)} of {metal.name}" if named else metal.name)
            by_group |= dict.fromkeys(named or ("",), metal)
        choices.append(MetalChoice(name=", ".join(names), metals=by_group))
    if len(choices) > MOST_CHOICES:
        raise InputError("metals", f"{len(choices)} choices of one for each list of groups", f"at most {MOST_CHOICES}")
    return tuple(choices)


def mesh_shells(head: Head) -> ShellHead:
    """Return the shell mesh of a head; raise an error if its elements are solids."""
    made = head.mesh()
    if not isinstance(made, ShellHead):
        raise InputError("head", head.name, "a head of shells: the walls of a mesh of solids cannot vary")
    return made


class FaceWall(NamedTuple):
    """A part of the face as a plate: metal, mean thickness, and thickness at the face centre [m]."""

    metal: Metal
    mean: float
    centre: float


class DriverFamily:
    """The heads a study can choose from: parametric drivers that keep their mass targets.

    A variable is named after its table and key in the head's file, such as "thickness.crown".
    """

    start: ShellHead
    variables: Mapping[str, tuple[str, tuple[str, ...]]]  # by table: the word for one variable, and their names
    groups: tuple[str, ...] = ()  # may have different metals; empty for a head of one metal

    def __init__(self, head: DriverHead, varied: Mapping[str, Any]) -> None:
        self._head = head
        self._free = any(f"thickness.{wall}" in varied for wall in SCALED)
        self.variables = {"thickness": ("wall", WALLS), "shape": ("dimension", tuple(DRIVER_SHAPES))}
        with without_warnings(TargetWarning):
            self.start = head.mesh()

    def value(self, head: Any, name: str) -> float:
        """Return a head's value of a variable [SI]."""
        table, _, key = name.partition(".")
        return getattr(head, table)[key]

    def vary(self, values: Mapping[str, float], choice: MetalChoice) -> DriverHead:
        """Return the head with new values of variables [SI] and elastic metals."""
        tables = {"shape": dict(self._head.shape), "thickness": dict(self._head.thickness)}
        for name, value in values.items():
            table, _, key = name.partition(".")
            tables[table][key] = value
        return replace(
            self._head, **tables, scales=(1.0, 1.0) if self._free else self._head.scales,
            metal=elastic(self.metal("", choice)[1]),
        )  # fmt: skip

    def finish(self, judged: Any, choice: MetalChoice) -> DriverHead:
        """Return an evaluated head as it goes into a file, with metals that yield."""
        return replace(judged, metal=self.metal("", choice)[1])

    def check(self, head: Any) -> None:
        """Raise an ``InputError`` for a head that cannot be meshed."""
        _ = head.mesh().club

    def coarse(self, head: Any) -> ShellHead:
        """Return a mesh that is quick to make and gives the mass within 0.1%."""
        elements: Any = tuple(min(own, coarse) for own, coarse in zip(head.elements, ELEMENTS, strict=True))
        return replace(head, elements=elements).mesh()

    def face_wall(self, head: Any, meshed: ShellHead, part: str) -> FaceWall:
        """Return a part of the face as a plate."""
        centre, edge = head.thickness["face_centre"], head.thickness["face_edge"]
        return FaceWall(head.metal, 0.5 * (centre + edge), centre)

    def metal(self, part: str, choice: MetalChoice) -> tuple[str, Metal]:
        """Return name and metal, with its yield stress, of a part of the starting head."""
        chosen = choice.of_group(part)
        return (choice.name, self._head.metal) if chosen is None else (chosen.name, chosen.metal)

    def files(self) -> dict[str, str]:
        """Return fingerprints, by name, of the other files that the head's file uses."""
        return {}


class MeshFamily:
    """Heads of one shell mesh with different walls, metals and added masses; otherwise as :class:`DriverFamily`."""

    def __init__(self, head: MeshHead, varied: Mapping[str, Any]) -> None:
        self._head = head
        self.groups = tuple(group.name for group in head.groups)
        self.variables = {"thickness": ("group", self.groups), "masses": ("mass", tuple(head.masses))}
        self.start = mesh_shells(head)
        self._group = {part: name for name in self.groups for part in (name, beyond(name))}
        for name in varied:
            table, _, key = name.partition(".")
            if table == "thickness" and key in self.groups:
                self._check_uniform(key)

    def _group_elements(self, group: str) -> NDArray[Any]:
        return np.array([self._group[part.name] == group for part in self.start.parts])[self.start.part_of_elements()]

    def _check_uniform(self, group: str) -> None:
        """Raise an error if the mesh file sets the group's thickness element by element."""
        walls = self.start.thickness[self._group_elements(group)]
        if np.ptp(walls) > 0.0:
            least, most = (units.show(float(each), "mm") for each in (walls.min(), walls.max()))
            message = f"give the group one thickness in the file of the head: the mesh has {least} to {most}"
            raise InputError(f"variables.thickness.{group}", Wording("set element by element"), message)

    def value(self, head: Any, name: str) -> float:
        table, _, key = name.partition(".")
        if table == "masses":
            return head.masses[key][3]
        given = next(group.thickness for group in head.groups if group.name == key)
        return float(self.start.thickness[self._group_elements(key)][0]) if given is None else given

    def vary(self, values: Mapping[str, float], choice: MetalChoice) -> MeshHead:
        groups = tuple(
            replace(
                group, thickness=values.get(f"thickness.{group.name}", group.thickness),
                metal=self._elastic(group, choice),
            )
            for group in self._head.groups
        )  # fmt: skip
        own = self._head.masses.items()
        masses = {name: (*place, values.get(f"masses.{name}", mass)) for name, (*place, mass) in own}
        return replace(self._head, groups=groups, masses=masses)

    def _elastic(self, group: Group, choice: MetalChoice) -> Metal | Mapping[str, Any]:
        chosen = choice.of_group(group.name)
        if chosen is not None:
            return elastic(chosen.metal)
        if isinstance(group.metal, Metal):
            return elastic(group.metal)
        # Properties left to the mesh file stay there.
        return {key: value for key, value in group.metal.items() if key not in ("yield_stress", "hardening", "points")}

    def finish(self, judged: Any, choice: MetalChoice) -> MeshHead:
        groups = []
        for own, group in zip(self._head.groups, judged.groups, strict=True):
            chosen = choice.of_group(group.name)
            groups.append(replace(group, metal=own.metal if chosen is None else chosen.metal))
        return replace(judged, groups=tuple(groups))

    def check(self, head: Any) -> None:
        _ = self.coarse(head).club

    def coarse(self, head: Any) -> ShellHead:
        # The mesh is read only once; added masses are redistributed to its nodes.
        start = self.start
        thickness, parts, carried = start.thickness.copy(), [], start.added
        for group in head.groups:
            rows = self._group_elements(group.name)
            thickness[rows] = start.thickness[rows] if group.thickness is None else group.thickness
        metals = {group.name: group.metal for group in head.groups}
        for part in start.parts:
            given = metals[self._group[part.name]]
            parts.append(replace(part, metal=given if isinstance(given, Metal) else elastic(part.metal)))
        if head.masses:
            carried = start.added + self._masses_at_nodes(head, thickness, parts) - self._start_masses_at_nodes
        return replace(start, thickness=thickness, parts=tuple(parts), added=carried)

    @cached_property
    def _start_masses_at_nodes(self) -> NDArray[Any]:
        return self._masses_at_nodes(self._head, self.start.thickness, self.start.parts)

    def _masses_at_nodes(self, head: MeshHead, thickness: NDArray[Any], parts: Any) -> NDArray[Any]:
        """Return the share of a head's added masses at each node [kg]."""
        start = self.start
        density = np.array([part.metal.density for part in parts])[start.part_of_elements()]
        walls = np.linalg.norm(area_vectors(start.nodes, start.quads), axis=1) * thickness * density
        face = np.unique(start.quads[np.array([part.face for part in start.parts])[start.part_of_elements()]])
        metal = sums_at_nodes(start.quads, 0.25 * walls, len(start.nodes))
        return spread(head.masses, start.nodes, metal, face).added

    def face_wall(self, head: Any, meshed: ShellHead, part: str) -> FaceWall:
        rows = [each.name == part for each in meshed.parts]
        own = np.array(rows)[meshed.part_of_elements()]
        areas = np.linalg.norm(area_vectors(meshed.nodes, meshed.quads[own]), axis=1)
        away = np.linalg.norm(meshed.nodes[meshed.quads[own]].mean(axis=1), axis=1)
        walls = meshed.thickness[own]
        return FaceWall(meshed.parts[rows.index(True)].metal, float(walls @ areas / areas.sum()),
                        float(walls[np.argmin(away)]))  # fmt: skip

    def metal(self, part: str, choice: MetalChoice) -> tuple[str, Metal]:
        group = self._group[part]
        chosen = choice.of_group(group)
        if chosen is not None:
            return chosen.name, chosen.metal
        return group, next(each.metal for each in self.start.parts if each.name == part)

    def files(self) -> dict[str, str]:
        return {"mesh": input_file(self._head.file).sha256}


Family = DriverFamily | MeshFamily


def face_parts(head: ShellHead) -> dict[str, int]:
    """Return the parts of the face by the name of their peak stress: "stress", or "stress.NAME" if several."""
    faces = {part.name: number for number, part in enumerate(head.parts) if part.face}
    return {"stress" if len(faces) == 1 else f"stress.{name}": number for name, number in faces.items()}


def family_of(head: Head, varied: Mapping[str, Any]) -> Family:
    """Return the family of a head; raise an error if it lacks one of the variables ``varied``."""
    family = DriverFamily(head, varied) if isinstance(head, DriverHead) else MeshFamily(head, varied)
    for name in varied:
        table, _, key = name.partition(".")
        check_choice("table of what varies", table, family.variables)
        what, known = family.variables[table]
        check_choice(f"{what} to vary", key, known)
    return family
