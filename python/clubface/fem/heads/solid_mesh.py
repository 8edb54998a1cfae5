"""Preparation of solid elements from mesh files for the core: ten-node tetrahedra, and hexahedra.

Tetrahedra get nodes at the middle of straight edges, whatever mid-edge nodes the file has: four-node tetrahedra hardly
bend.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.geometry import (
    EDGES,
    HEXAHEDRON_SIDES,
    TETRAHEDRON_SIDES,
    area_vectors,
    element_masses,
    hexahedron_volumes,
    sums_at_nodes,
    tetrahedron_volumes,
)  # fmt: skip
from clubface.fem.heads.mesh_repair import merged
from clubface.fem.heads.meshed import Bond, SolidPart
from clubface.fem.heads.metal import Metal
from clubface.fem.mesh_files import SOLIDS, Mesh

MASS_SHARES = np.array([1.0 / 36.0] * 4 + [4.0 / 27.0] * 6)
"""Fractions of a tetrahedron's mass at its nodes, as in the core."""
SLIVER = 5.0
"""Ratio of median to smallest tetrahedron height above which a note is made."""
TOP_FIRST = [4, 5, 6, 7, 0, 1, 2, 3]
"""Corners of a hexahedron with top and bottom exchanged, which turns it inside out."""


@dataclass(frozen=True, kw_only=True)
class Solids:
    """Solid elements of a head."""

    points: NDArray[Any]  # positions of nodes in the file's unit, shape (n, 3)
    node_ids: NDArray[Any]  # node numbers in the file; 0 for added nodes
    parts: tuple[SolidPart, ...]  # one per group
    ids: NDArray[Any]  # element numbers in the file, in the order of results

    def metal_at_nodes(self, size: float) -> NDArray[Any]:
        """Return the metal mass at each node [kg]; ``size`` is the length of the points' unit [m]."""
        nodes, masses = self.points * size, np.zeros(len(self.points))
        for part in self.parts:
            each = element_masses(nodes, part.hexahedra, part.metal.density)
            masses += sums_at_nodes(part.hexahedra, each / 8.0, len(nodes))
            each = part.metal.density * tetrahedron_volumes(nodes, part.tetrahedra)
            masses += np.bincount(part.tetrahedra.ravel(), np.outer(each, MASS_SHARES).ravel(), len(nodes))
        return masses


def solids_of_mesh(
    mesh: Mesh, of_group: NDArray[Any], names: Sequence[str], metals: Sequence[Metal], bonds: Sequence[Bond]
) -> Solids:
    """Return the solid elements of a mesh, oriented, with closed seams except at bonds.

    ``of_group`` is the group index of each element; ``names`` and ``metals`` are those of the groups. Raises FileError
    for wedges or pyramids, a degenerate element, or tetrahedra and hexahedra that share a side.
    """
    counts = (mesh.corners >= 0).sum(axis=1)
    _check_kinds(mesh, counts)
    corners = mesh.corners.copy()
    apart = np.isin(of_group, [names.index(bond.part) for bond in bonds]) * (1 + of_group)
    _merge_nodes(mesh, corners, np.stack([counts, apart], axis=1))
    tetrahedra, hexahedra, ids = corners[counts == 4, :4], corners[counts == 8], mesh.ids[counts == 4]
    _turn_outward(mesh, tetrahedra, ids, hexahedra, mesh.ids[counts == 8])
    _note_sliver(mesh, tetrahedra, ids)
    _check_shared(mesh, tetrahedra, ids, hexahedra)
    # Add nodes at the middle of tetrahedron edges.
    edges, places = np.unique(np.sort(tetrahedra[:, EDGES].reshape(-1, 2), axis=1), axis=0, return_inverse=True)
    tetrahedra = np.concatenate([tetrahedra, len(mesh.points) + places.reshape(-1, len(EDGES))], axis=1)
    points = np.concatenate([mesh.points, mesh.points[edges].mean(axis=1)])
    node_ids = np.concatenate([mesh.node_ids, np.zeros(len(points) - len(mesh.points), np.int64)])
    used, places = np.unique(np.concatenate([hexahedra.ravel(), tetrahedra.ravel()]), return_inverse=True)
    hexahedra, tetrahedra = (
        each.reshape(-1, width) for each, width in zip(np.split(places.ravel(), [hexahedra.size]), (8, 10), strict=True)
    )
    parts = tuple(
        SolidPart(name=name, metal=metal, hexahedra=hexahedra[of_group[counts == 8] == number],
                  tetrahedra=tetrahedra[of_group[counts == 4] == number])
        for number, (name, metal) in enumerate(zip(names, metals, strict=True))
    )  # fmt: skip
    # Hexahedra of all parts first, then tetrahedra.
    order = np.lexsort((of_group, counts == 4))
    return Solids(points=points[used], node_ids=node_ids[used], parts=parts, ids=mesh.ids[order])


def _check_kinds(mesh: Mesh, counts: NDArray[Any]) -> None:
    """Raise FileError for elements other than tetrahedra and hexahedra."""
    others = Counter(SOLIDS[int(count)] for count in counts if count not in (4, 8))
    if others:
        listed = " and ".join(f"{count} {kind}" for kind, count in others.items())
        first = int(mesh.ids[np.flatnonzero((counts != 4) & (counts != 8))[0]])
        raise mesh.error(
            f"{listed}, such as element {first}, are not supported; mesh a solid head with tetrahedra or hexahedra"
        )


def _merge_nodes(mesh: Mesh, corners: NDArray[Any], kinds: NDArray[Any]) -> None:
    """Merge coincident nodes of elements of the same kind; raise FileError for elements that lose an edge."""
    gone = 0
    for kind in np.unique(kinds, axis=0):
        rows = (kinds == kind).all(axis=1)
        corners[rows], count, _ = merged(mesh.points, corners[rows])
        gone += count
    if gone:
        mesh.notes.append(f"{gone} coincident nodes are merged")
    ordered = np.sort(corners, axis=1)
    doubled = ((ordered[:, 1:] == ordered[:, :-1]) & (ordered[:, 1:] >= 0)).any(axis=1)
    if doubled.any():
        element = mesh.ids[int(np.argmax(doubled))]
        raise mesh.error(f"element {element} is degenerate: two of its nodes coincide")


def _turn_outward(mesh: Mesh, tetrahedra: NDArray[Any], tetrahedron_ids: NDArray[Any], hexahedra: NDArray[Any],
                  hexahedron_ids: NDArray[Any]) -> None:  # fmt: skip
    """Reorder inside-out elements; raise FileError for flat ones."""
    volumes = tetrahedron_volumes(mesh.points, tetrahedra)
    inside = volumes < 0.0
    tetrahedra[inside] = tetrahedra[inside][:, [0, 2, 1, 3]]
    size = hexahedron_volumes(mesh.points, hexahedra)
    hexahedra[size < 0.0] = hexahedra[size < 0.0][:, TOP_FIRST]
    turned = int(inside.sum()) + int((size < 0.0).sum())
    if turned:
        mesh.notes.append(f"{turned} elements were inside out; the order of their nodes was corrected")
    for value, ids in ((volumes, tetrahedron_ids), (size, hexahedron_ids)):
        if len(value) and np.abs(value).min() <= 1e-9 * np.median(np.abs(value)):
            flattest = ids[int(np.abs(value).argmin())]
            raise mesh.error(f"element {flattest} is flat: it has no volume")


def _note_sliver(mesh: Mesh, tetrahedra: NDArray[Any], ids: NDArray[Any]) -> None:
    """Note the flattest tetrahedron if it makes a run much slower."""
    if not len(tetrahedra):
        return
    corners = mesh.points[tetrahedra]
    sides = [np.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a])
             for a, b, c in ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))]  # fmt: skip
    largest = 0.5 * np.linalg.norm(sides, axis=2).max(axis=0)
    height = 3.0 * np.abs(tetrahedron_volumes(mesh.points, tetrahedra)) / largest
    flattest = int(height.argmin())
    slower = float(np.median(height) / height[flattest])
    if slower > SLIVER:
        mesh.notes.append(
            f"element {ids[flattest]} is {slower:.0f} times flatter than most, which makes a run about as many times"
            " longer; mesh the head without slivers"
        )


def _check_shared(mesh: Mesh, tetrahedra: NDArray[Any], ids: NDArray[Any], hexahedra: NDArray[Any]) -> None:
    """Raise FileError if a tetrahedron shares a side with a hexahedron, where mid-edge nodes would be hanging."""
    if not len(tetrahedra) or not len(hexahedra):
        return
    sides = hexahedra[:, HEXAHEDRON_SIDES].reshape(-1, 4)
    of_hexahedra = {
        tuple(each) for left in range(4) for each in np.sort(np.delete(sides, left, axis=1), axis=1).tolist()
    }
    of_tetrahedra = np.sort(tetrahedra[:, [list(side[:3]) for side in TETRAHEDRON_SIDES]], axis=2)
    for element, own in zip(ids.tolist(), of_tetrahedra.tolist(), strict=True):
        if any(tuple(side) in of_hexahedra for side in own):
            raise mesh.error(
                f"element {element}, a tetrahedron, shares a side with a hexahedron; mesh both parts with one kind, or"
                " give each part its own nodes and join them under [[bonds]]"
            )


def facing_sides(nodes: NDArray[Any], sides: NDArray[Any], normal: NDArray[Any], cosine: float) -> NDArray[Any]:
    """Return the sides that face along a normal and are connected to the one nearest to the origin.

    ``sides`` are quadrilaterals, shape (m, 4); a triangle repeats its last corner. ``cosine`` is the minimum cosine of
    the angle between a side's normal and ``normal``, a unit vector.
    """
    area = area_vectors(nodes, sides)
    facing = sides[area @ normal >= cosine * np.linalg.norm(area, axis=1)]
    if not len(facing):
        return facing
    # Each node takes the smallest label among the nodes it is connected to.
    label = np.arange(len(nodes))
    while True:
        least = label[facing].min(axis=1)
        before = label.copy()
        np.minimum.at(label, facing, least[:, None])
        if (label == before).all():
            break
    nearest = int(np.linalg.norm(nodes[facing].mean(axis=1), axis=1).argmin())
    return facing[label[facing[:, 0]] == label[facing[nearest, 0]]]
