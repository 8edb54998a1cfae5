"""Areas of quadrilaterals, volumes of hexahedra, and sums over the elements round a node."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["area_vectors", "element_masses", "sums_at_nodes"]


def area_vectors(nodes: NDArray[Any], quads: NDArray[Any]) -> NDArray[Any]:
    """Return the areas of quadrilaterals as vectors along their normals, shape (elements, 3)."""
    a, b, c, d = (nodes[quads[:, corner]] for corner in range(4))
    return 0.5 * np.cross(c - a, d - b)


def element_masses(nodes: NDArray[Any], elements: NDArray[Any], density: Any) -> NDArray[Any]:
    """Return the mass of each hexahedron, taken as a parallelepiped [kg]."""
    corner = nodes[elements]
    edges = [corner[:, [1, 2, 5, 6]].mean(axis=1) - corner[:, [0, 3, 4, 7]].mean(axis=1),
             corner[:, [2, 3, 6, 7]].mean(axis=1) - corner[:, [0, 1, 4, 5]].mean(axis=1),
             corner[:, 4:].mean(axis=1) - corner[:, :4].mean(axis=1)]  # fmt: skip
    return abs(np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])) * density


def sums_at_nodes(elements: NDArray[Any], values: NDArray[Any], count: int) -> NDArray[Any]:
    """Return the sum over the elements round each of ``count`` nodes of a value for each element."""
    return np.bincount(elements.ravel(), np.repeat(values, elements.shape[1]), count)
