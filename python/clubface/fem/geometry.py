"""Geometry of elements: areas, volumes, outer sides, and sums over the elements around a node."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

HEXAHEDRON_SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
"""Corners of the sides of a hexahedron, counterclockwise seen from outside; its nodes go around the bottom, then around
the top."""
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
"""End corners of a tetrahedron's edges, in the order of the mid-edge nodes, which follow the corners."""
TETRAHEDRON_SIDES = ((0, 2, 1, 6, 5, 4), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 3, 2, 7, 9, 6))
"""Nodes of the sides of a tetrahedron: corners, counterclockwise seen from outside, then mid-edge nodes."""
QUARTERS = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
"""The four triangles between the six nodes of a tetrahedron's side."""


def area_vectors(nodes: NDArray[Any], quads: NDArray[Any]) -> NDArray[Any]:
    """Return the area vectors of quadrilaterals, along their normals, shape (elements, 3)."""
    a, b, c, d = (nodes[quads[:, corner]] for corner in range(4))
    return 0.5 * np.cross(c - a, d - b)


def element_masses(nodes: NDArray[Any], elements: NDArray[Any], density: Any) -> NDArray[Any]:
    """Return the masses of hexahedra [kg], treated as parallelepipeds."""
    return abs(hexahedron_volumes(nodes, elements)) * density


def hexahedron_volumes(nodes: NDArray[Any], elements: NDArray[Any]) -> NDArray[Any]:
    """Return the volumes of hexahedra [m3], treated as parallelepipeds; negative if inside out."""
    corner = nodes[elements]
    edges = [corner[:, [1, 2, 5, 6]].mean(axis=1) - corner[:, [0, 3, 4, 7]].mean(axis=1),
             corner[:, [2, 3, 6, 7]].mean(axis=1) - corner[:, [0, 1, 4, 5]].mean(axis=1),
             corner[:, 4:].mean(axis=1) - corner[:, :4].mean(axis=1)]  # fmt: skip
    return np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])


def sums_at_nodes(elements: NDArray[Any], values: NDArray[Any], count: int) -> NDArray[Any]:
    """Sum a value per element over the elements around each of ``count`` nodes."""
    return np.bincount(elements.ravel(), np.repeat(values, elements.shape[1]), count)


def tetrahedron_volumes(nodes: NDArray[Any], corners: NDArray[Any]) -> NDArray[Any]:
    """Return the volumes of tetrahedra [m3] from their corners; negative if inside out."""
    a, b, c, d = (nodes[corners[:, corner]] for corner in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6.0


def outer_quads(*elements: NDArray[Any]) -> NDArray[Any]:
    """Return the outer sides, shared by no second element, of hexahedra (m, 8) and ten-node tetrahedra (m, 10).

    The result has shape (n, 4). A tetrahedron's side gives four triangles, each with its last corner repeated.
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
    """Return the sides that no other side duplicates, compared by their first ``corners`` nodes."""
    ordered = np.sort(sides[:, :corners], axis=1)
    _, first, count = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    return sides[np.sort(first[count == 1])]


def triangles(quads: NDArray[Any]) -> NDArray[Any]:
    """Split quadrilaterals into two triangles each; one whose last two corners coincide gives one triangle."""
    real = quads[:, 2] != quads[:, 3]
    return np.concatenate([quads[:, :3], quads[real][:, [0, 2, 3]]])
