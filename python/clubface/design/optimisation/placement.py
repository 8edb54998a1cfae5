"""Where to put the discretionary mass: a few point masses that have its moments, found by linear programming."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from clubface.design.feasibility import Envelope

STEPS = 13
"""Places along each axis of the volume, both ends among them."""
NEGLIGIBLE = 1e-4
"""Part of the discretionary mass below which a point mass is left out."""
NEAR = 0.02
"""Greatest error of a moment, in parts of mass and half size, with which masses still count as a solution: places lie
on a grid, and the best head often needs mass exactly on the surface between two of them."""


class PointMass(NamedTuple):
    """A mass at a place.

    Attributes
    ----------
    mass
        [kg].
    place
        Seen from the face centre: to the target, up, to the toe [m].
    """

    mass: float
    place: tuple[float, float, float]


def placement(envelope: Envelope, pseudo: NDArray[Any]) -> list[PointMass]:
    """Return point masses that have the moments of the discretionary mass of a head, the heaviest first.

    There are at most ten, as there are ten moments. The list is empty where none on a grid of places come near.

    Parameters
    ----------
    envelope
        Volume, shell and budget.
    pseudo
        Pseudo-inertia of the head about the face centre, shape (4, 4).
    """
    from scipy.optimize import linprog

    volume, placed = envelope.volume, envelope.placed(pseudo)
    parts = np.linspace(-1.0, 1.0, STEPS)
    grid = np.stack(np.meshgrid(parts, parts, parts, indexing="ij"), axis=-1).reshape(-1, 3)
    if volume.shape == "ellipsoid":
        grid = grid[np.linalg.norm(grid, axis=1) <= 1.0 + 1e-12]
    places = np.array(volume.centre) + grid * 0.5 * np.array(volume.size)
    frame = np.eye(4)
    frame[:3, :3] = np.diag(0.5 * np.array(volume.size))
    frame[:3, 3] = volume.centre
    inverse = np.linalg.inv(frame)
    own = inverse @ placed @ inverse.T / placed[3, 3]
    rows = np.hstack([grid, np.ones((len(grid), 1))])
    pairs = [(i, j) for i in range(4) for j in range(i, 4)]
    moments = np.array([rows[:, i] * rows[:, j] for i, j in pairs])
    wanted = np.array([own[pair] for pair in pairs])
    # The mass is exact; of the other moments, the sum of what they miss is made least.
    free = np.eye(len(pairs))[:, :-1]
    equal = np.hstack([moments, free, -free])
    cost = np.concatenate([np.zeros(len(grid)), np.ones(2 * free.shape[1])])
    found = linprog(cost, A_eq=equal, b_eq=wanted, bounds=(0.0, None), method="highs-ds")
    if found.status != 0 or np.abs(moments @ found.x[: len(grid)] - wanted).max() > NEAR:
        return []
    masses = found.x[: len(grid)]
    order = [place for place in np.argsort(-masses, kind="stable") if masses[place] > NEGLIGIBLE]
    return [
        PointMass(
            float(masses[each] * placed[3, 3]), (float(places[each][0]), float(places[each][1]), float(places[each][2]))
        )
        for each in order
    ]
