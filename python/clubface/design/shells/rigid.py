"""What the mesh of a head tells without a run: masses, inertia, volume and size."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from clubface.fem.heads.shells import ShellHead


def rigid_values(head: ShellHead) -> dict[str, float]:
    """Return mass, mass of the walls, inertia about the vertical, volume and size of a closed head [SI].

    The nodes lie on the middle of the walls; volume and size are those of the outside, half a wall farther out.
    """
    corners = head.nodes[head.quads]
    # A quadrilateral is two triangles; outside, its nodes run counterclockwise.
    diagonals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    area = 0.5 * np.linalg.norm(diagonals, axis=1)
    inner = float((corners.mean(axis=1) * diagonals).sum()) / 6.0
    size = np.ptp(head.nodes, axis=0) + float(np.average(head.thickness, weights=area))
    return {
        "mass": head.club.mass,
        "wall_mass": head.club.mass - float(head.added.sum()),
        "moment_of_inertia": head.club.iyy,
        "volume": inner + 0.5 * float(head.thickness @ area),
        "heel_to_toe": float(size[2]),
        "sole_to_crown": float(size[1]),
    }
