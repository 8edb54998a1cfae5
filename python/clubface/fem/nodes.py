"""What the nodes of a ball weigh."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


def node_masses(mesh: Mapping[str, Any]) -> NDArray[Any]:
    """Return each node's share of the mass of a ball's mesh, from elements taken as parallelepipeds."""
    nodes, elements = mesh["nodes"], mesh["elements"].astype(int)
    mass = element_masses(nodes, elements, np.asarray(mesh["density"])[mesh["piece"]])
    shares = np.zeros(len(nodes))
    np.add.at(shares, elements, mass[:, None] / 8.0)
    return shares / shares.sum()


def element_masses(nodes: NDArray[Any], elements: NDArray[Any], density: Any) -> NDArray[Any]:
    """Return the mass of each hexahedron, taken as a parallelepiped [kg]."""
    corner = nodes[elements]
    edges = [corner[:, [1, 2, 5, 6]].mean(axis=1) - corner[:, [0, 3, 4, 7]].mean(axis=1),
             corner[:, [2, 3, 6, 7]].mean(axis=1) - corner[:, [0, 1, 4, 5]].mean(axis=1),
             corner[:, 4:].mean(axis=1) - corner[:, :4].mean(axis=1)]  # fmt: skip
    return abs(np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2])) * density
