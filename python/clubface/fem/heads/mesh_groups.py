"""The groups of a head, and which elements of a mesh file belong to which."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.fem.heads.metal import Metal
from clubface.fem.mesh_files import Mesh
from clubface.support.checks import check_name

OWN = re.compile(r"gmsh:|Surface\d+$|Volume\d+$|_?(?:PickedSet|All)\d*$|Line\d+$", re.IGNORECASE)
"""Sets that programs make for themselves."""
SHOWN = 12
"""Sets that a message names."""


@dataclass(frozen=True, kw_only=True)
class Group:
    """The shells of one group of the mesh.

    Attributes
    ----------
    name
        Its name in the file: a physical group, a set of elements, a part or a property, or the number of one.
    thickness
        Thickness [m]; None if cards of the mesh give it.
    metal
        The metal; or some of its values by name, where cards of the mesh give the others.
    face
        Whether the ball may touch them.
    sets
        The sets of the file that it is made of, where it is not the one of its name.
    """

    name: str
    thickness: Any = None
    metal: Metal | Mapping[str, Any] = field(default_factory=dict)
    face: bool = False
    sets: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        check_name(self.name)
        if self.thickness is not None:
            object.__setattr__(self, "thickness", units.parse(self.thickness, "length", name="thickness"))
            if not 2e-4 <= self.thickness <= 0.02:
                raise InputError(f"thickness of {self.name}", units.show(self.thickness, "mm"), "0.2 to 20 mm")
        if not isinstance(self.metal, Metal):
            Metal(**self.metal)  # refuses what no metal has
        if not isinstance(self.face, bool):
            raise InputError(f"face of {self.name}", self.face, "true or false")
        if isinstance(self.sets, str) or not all(isinstance(each, str) for each in self.sets):
            raise InputError(f"sets of {self.name}", self.sets, 'a list of names of sets in the mesh, as ["1", "2"]')
        object.__setattr__(self, "sets", tuple(self.sets))


def assign(mesh: Mesh, groups: Sequence[Group], notes: list[str]) -> NDArray[Any]:
    """Return the place among ``groups`` of the group of each element.

    A group takes the set of its name, or the sets that it lists; sets that no group names do not matter. What is
    decided beyond that is added to ``notes``.

    Raises
    ------
    FileError
        An element belongs to no group or to two, or a group has no element.
    """
    _check_solids(mesh, groups)
    if not len(mesh.corners):
        raise FileError(mesh.path, None, "there are no elements of surfaces, triangles or quadrilaterals, in this file")
    places = np.full(len(mesh.corners), -1)
    if not any(len(rows) for rows in mesh.sets.values()) and len(groups) == 1:
        notes.append(f"the file names no sets of elements: all belong to {groups[0].name!r}")
        return np.zeros(len(mesh.corners), dtype=int)
    names = [_sets_of(mesh, group) for group in groups]
    if not any(names) and (numbered := _by_order(mesh, len(groups))):
        order = ", ".join(f"{one} as {group.name}" for one, group in zip(numbered, groups, strict=True))
        notes.append(
            f"its sets have numbers and no names; they are taken in the order of [[groups]]: {order};"
            f' to settle it, write sets = ["{numbered[0]}"] under the group'
        )
        names = [[each] for each in numbered]
    for place, (group, own) in enumerate(zip(groups, names, strict=True)):
        for name in own:
            rows = mesh.sets[name]
            taken = rows[(places[rows] >= 0) & (places[rows] != place)]
            if len(taken):
                other, element = groups[int(places[taken[0]])].name, mesh.ids[taken[0]]
                message = f"element {element} belongs to two groups, {other!r} and {group.name!r}"
                raise FileError(mesh.path, None, message)
            places[rows] = place
    if (places < 0).any():
        _refuse_rest(mesh, groups, places)
    counts = np.bincount(places, minlength=len(groups))
    if not counts.all():
        empty = groups[int(np.argmin(counts))].name
        raise FileError(mesh.path, None, f"no element belongs to the group {empty!r}; {_listed(mesh)}")
    return places


def _sets_of(mesh: Mesh, group: Group) -> list[str]:
    """Return the sets of a group: under the very name, another of its names, or one that differs in capitals alone."""
    names = []
    for name in group.sets or (group.name,):
        if name not in mesh.sets and name in mesh.aliases:
            name = mesh.aliases[name]
        if name not in mesh.sets:
            known = {**{each: each for each in mesh.sets}, **mesh.aliases}
            like = {known[each] for each in known if _plain(each) == _plain(name)}
            name = like.pop() if len(like) == 1 else name
        if name in mesh.sets:
            names.append(name)
        elif group.sets:
            raise FileError(mesh.path, None, str(UnknownNameError("set of the mesh", name, tuple(mesh.sets))))
    return names


def _plain(name: str) -> str:
    return re.sub(r"[\s_-]+", "_", name.strip()).casefold()


def _by_order(mesh: Mesh, count: int) -> list[str]:
    """Return sets with numbers for names, if there are as many as wanted and every element is in one of them."""
    names = [name for name, rows in mesh.sets.items() if len(rows)]
    if len(names) != count or not all(name.isdecimal() and name not in mesh.aliases.values() for name in names):
        return []
    whole = np.concatenate([mesh.sets[name] for name in names])
    return sorted(names, key=int) if len(whole) == len(np.unique(whole)) == len(mesh.corners) else []


def _refuse_rest(mesh: Mesh, groups: Sequence[Group], places: NDArray[Any]) -> None:
    """Say which elements belong to no group, and how to give them one."""
    rest = np.flatnonzero(places < 0)
    holders = {name: int(np.isin(rest, rows).sum()) for name, rows in mesh.sets.items() if not OWN.match(name)}
    holders = {name: count for name, count in holders.items() if count}
    if holders:
        most = max(holders, key=lambda name: holders[name])
        message = str(UnknownNameError("group of the mesh", most, tuple(group.name for group in groups)))
        advice = f"its {holders[most]} elements need a group: name it under [[groups]], or list it there as sets = [..]"
        raise FileError(mesh.path, None, f"{message}; {advice}; {_listed(mesh)}")
    message = f"element {mesh.ids[rest[0]]} belongs to no group"
    if len(rest) > 1:
        message += f", and {len(rest) - 1} more do not"
    raise FileError(
        mesh.path, None, f"{message}; name physical groups or sets of elements in the mesh; {_listed(mesh)}"
    )


def _listed(mesh: Mesh) -> str:
    """Return the sets of a file in words."""
    names = [f"{name} ({len(rows)})" for name, rows in mesh.sets.items() if len(rows) and not OWN.match(name)]
    if not names:
        return "it has none"
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return f"its sets, with their numbers of elements, are {', '.join(names[:SHOWN])}{more}"


def _check_solids(mesh: Mesh, groups: Sequence[Group]) -> None:
    """Refuse solid elements of a group; others, such as those of a ball, are left out and said to be."""
    if not mesh.solids:
        return
    kinds: dict[str, int] = {}
    for (kind, _), count in mesh.solids.items():
        kinds[kind] = kinds.get(kind, 0) + count
    solids = " and ".join(f"{count} {kind}" for kind, count in kinds.items())
    wanted = {_plain(name) for group in groups for name in (group.sets or (group.name,))}
    names = {name for _, name in mesh.solids}
    numbers = {number for number, name in mesh.aliases.items() if name in names}
    if not len(mesh.corners) or any(_plain(each) in wanted for each in names | numbers):
        message = (
            f"{solids}: a head of one's own is a mesh of shells; for a hollow head, mesh its middle surfaces with"
            ' triangles or quadrilaterals; for a solid iron, use kind = "iron" with its dimensions; the boundary faces'
            " of this mesh alone would be a hollow shell, which is another head"
        )
        raise FileError(mesh.path, None, message)
    mesh.notes.append(f"left out, as no group names them: {solids}")
