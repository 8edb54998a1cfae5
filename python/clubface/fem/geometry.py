"""Areas, volumes and outer sides of elements, and sums over the elements round a node."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

HEXAHEDRON_SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
"""Corners of the sides of a hexahedron, counterclockwise as seen from outside; its own go round the bottom, then round
the top."""
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
"""Corners at the ends of the edges of a tetrahedron, in whose order the nodes in their middles follow the corners."""
TETRAHEDRON_SIDES = ((0, 2, 1, 6, 5, 4), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 3, 2, 7, 9, 6))
"""Nodes of the sides of a tetrahedron: corners, counterclockwise as seen from outside, then the middles of their
edges."""
QUARTERS = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
"""The four triangles between the nodes of a side of a tetrahedron."""


def area_vectors(nodes: NDArray[Any], quads: NDArray[Any]) -> NDArray[Any]:
    """Return the areas of quadrilaterals as vectors along their normals, shape (elements, 3)."""
    a, b, c, d = (nodes[quads[:, corner]] for corner in range(4))
    return 0.5 * np.cross(c - a, d - b)


def element_masses(nodes: NDArray[Any], elements: NDArray[Any], density: Any) -> NDArray[Any]:
    """Return the mass of each hexahedron, taken as a parallelepiped [kg]."""
    return abs(hexahedron_volumes(nodes, elements)) * density


def hexahedron_volumes(nodes: NDArray[Any], elements: NDArray[Any]) -> NDArray[Any]:
    """Return the volumes of hexahedra, taken as parallelepipeds [m3]; negative ones are inside out."""
    corner = nodes[elements]
    edges = [corner[:, [1, 2, 5, 6]].mean(axis=1) - corner[:, [0, 3, 4, 7]].mean(axis=1),
             corner[:, [2, 3, 6, 7]].mean(axis=1) - corner[:, [0, 1, 4, 5]].mean(axis=1),
             corner[:, 4:].mean(axis=1) - corner[:, :4].mean(axis=1)]  # fmt: skip
    return np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])


def sums_at_nodes(elements: NDArray[Any], values: NDArray[Any], count: int) -> NDArray[Any]:
    """Return the sum over the elements round each of ``count`` nodes of a value for each element."""
    return np.bincount(elements.ravel(), np.repeat(values, elements.shape[1]), count)


def tetrahedron_volumes(nodes: NDArray[Any], corners: NDArray[Any]) -> NDArray[Any]:
    """Return the volumes of tetrahedra by their corners [m3]; negative ones are inside out."""
    a, b, c, d = (nodes[corners[:, corner]] for corner in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6.0


def outer_quads(*elements: NDArray[Any]) -> NDArray[Any]:
    """Return the sides of hexahedra (m, 8) and ten-node tetrahedra (m, 10) that belong to no second one, shape (n, 4).

    A side of a tetrahedron is four triangles, each with its last corner twice.
    """
    sides = []
    for each in elements:
        if each.shape[1] == 8:
            sides.append(unshared_sides(each[:, HEXAHEDRON_SIDES].reshape(-1, 4), 4))
        else:
            quarters = unshared_sides(each[:, TETRAHEDRON_SIDES].reshape(-1, 6), 3)[:, QUARTERS].reshape(-1, 3)
            sides.append(quarters[:, [0, 1, 2, 2]])
    return np.concatenate(sides)


def unshared_sides(sides: NDArray[Any], corners: int) -> NDArray[Any]:
    """Return the sides of elements whose corners, their first nodes, no other side has."""
    ordered = np.sort(sides[:, :corners], axis=1)
    _, first, count = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    return sides[np.sort(first[count == 1])]


def triangles(quads: NDArray[Any]) -> NDArray[Any]:
    """Return quadrilaterals as two triangles each; one whose last corner is the third again is one triangle."""
    real = quads[:, 2] != quads[:, 3]
    return np.concatenate([quads[:, :3], quads[real][:, [0, 2, 3]]])
