"""What the mesh of a head tells without a run: masses, inertia, volume and size."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from clubface.fem.heads.shells import ShellHead


def normals(head: ShellHead) -> NDArray[Any]:
    """Return the outward normal of every shell, as long as its area [m2], shape (shells, 3)."""
    corners = head.nodes[head.quads]
    # A quadrilateral is two triangles; outside, its nodes run counterclockwise.
    return 0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])


def on_face(head: ShellHead) -> NDArray[Any]:
    """Tell which shells are of the face, shape (shells,)."""
    return np.array([part.face for part in head.parts])[head.part_of_elements()]


def rigid_values(head: ShellHead) -> dict[str, float]:
    """Return mass, mass of the walls, inertia about the vertical, volume and size of a closed head [SI].

    The nodes lie on the middle of the walls; volume and size are those of the outside, half a wall farther out.
    """
    outwards = normals(head)
    area = np.linalg.norm(outwards, axis=1)
    inner = float((head.nodes[head.quads].mean(axis=1) * outwards).sum()) / 3.0
    size = np.ptp(head.nodes, axis=0) + float(np.average(head.thickness, weights=area))
    return {
        "mass": head.club.mass,
        "wall_mass": head.club.mass - float(head.added.sum()),
        "moment_of_inertia": head.club.iyy,
        "volume": inner + 0.5 * float(head.thickness @ area),
        "heel_to_toe": float(size[2]),
        "sole_to_crown": float(size[1]),
    }
