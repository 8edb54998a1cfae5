"""Stress at the surface of a body of hexahedra, from that at the centres of its elements.

The stress at the centre of an element is the most exact one that a hexahedron has (it is superconvergent), but a wall
under bending has its largest stress at its surface, half an element away: two layers of elements see half of it at
their centres, three layers two thirds. Patch recovery (Zienkiewicz and Zhu, 1992) fits each component of the stress in
the elements round a node inside the body by a linear function of the place. A node of the surface takes the value of
the function of the nearest node inside, extrapolated.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
"""Corners of the sides of a hexahedron, counterclockwise as seen from outside; its own go round the bottom, then round
the top."""
FLAT = 1e-3
"""Singular values below this share of the largest say that a patch has no extent in a direction."""


@dataclass(frozen=True)
class SurfaceRecovery:
    """How stress at the nodes of a surface follows from that at the centres of elements.

    Attributes
    ----------
    nodes
        Nodes of the surface, in ascending order, shape (n,).
    quads
        The surface as quadrilaterals between nodes of the mesh, shape (m, 4).
    elements, weights
        Elements whose stress makes that of each node, and their shares, shape (n, most); shares of 0 fill up.
    extrapolated
        Whether each node has a node inside to extrapolate from. Others, such as those of a wall of one layer, take the
        mean of the elements round them, which do not see how the wall bends.
    """

    nodes: NDArray[Any]
    quads: NDArray[Any]
    elements: NDArray[Any]
    weights: NDArray[Any]
    extrapolated: NDArray[Any]

    @classmethod
    def of_mesh(cls, nodes: NDArray[Any], hexahedra: NDArray[Any]) -> SurfaceRecovery:
        """Prepare the recovery for a mesh: places of nodes [m], shape (k, 3), and corners of elements, shape (l, 8)."""
        quads = outer_sides(hexahedra)
        on_surface = np.zeros(len(nodes), bool)
        on_surface[quads] = True
        centres = nodes[hexahedra].mean(axis=1)
        order = np.argsort(hexahedra, axis=None, kind="stable")
        ends = np.searchsorted(hexahedra.reshape(-1)[order], np.arange(len(nodes) + 1))
        around = [order[start:end] // 8 for start, end in pairwise(ends)]
        surface = np.flatnonzero(on_surface)
        patches, inside = [], []
        for node in surface:
            corners = np.unique(hexahedra[around[node]])
            near = corners[~on_surface[corners]]
            inside.append(near.size > 0)
            if near.size == 0:
                patches.append((around[node], np.full(len(around[node]), 1.0 / len(around[node]))))
                continue
            middle = near[((nodes[near] - nodes[node]) ** 2).sum(axis=1).argmin()]
            away, there = centres[around[middle]] - nodes[middle], nodes[node] - nodes[middle]
            size = abs(away).max()
            terms = np.column_stack([np.ones(len(away)), away / size])
            patches.append((around[middle], np.array([1.0, *there / size]) @ np.linalg.pinv(terms, rcond=FLAT)))
        most = max(len(shares) for _, shares in patches)
        elements, weights = np.zeros((len(surface), most), int), np.zeros((len(surface), most))
        for row, (patch, shares) in enumerate(patches):
            elements[row, : len(patch)], weights[row, : len(patch)] = patch, shares
        return cls(surface, quads, elements, weights, np.array(inside))

    def at_nodes(self, values: NDArray[Any]) -> NDArray[Any]:
        """Return at the nodes of the surface what is given at elements, shape (..., elements, components)."""
        return np.einsum("np,...npc->...nc", self.weights, np.asarray(values, float)[..., self.elements, :])


def outer_sides(hexahedra: NDArray[Any]) -> NDArray[Any]:
    """Return the sides of elements that belong to no second element, in their own order of corners, shape (m, 4)."""
    sides = hexahedra[:, SIDES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[np.sort(first[count == 1])]
