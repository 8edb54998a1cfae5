"""Where to put the discretionary mass: a few point masses that have its moments, found by linear programming.

Places lie on a grid, and the best head often needs mass at a place between, exactly on the surface. So the grid is made
finer again and again about the places that are taken.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from clubface.design.feasibility import Envelope, Volume

STEPS = 13
"""Places along each axis of the volume, both ends among them."""
ROUNDS = 20
"""How often the grid is made finer by half, at most: places are then told apart by a millionth of the volume's size."""
NEAR = 1e-6
"""Greatest error of a moment, in parts of mass and half size, with which masses count as a solution."""
NEGLIGIBLE = 1e-9
"""Part of the discretionary mass below which a point mass is left out."""


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

    There are at most ten, as there are ten moments. The list is empty where none were found.

    Parameters
    ----------
    envelope
        Volume, shell and budget.
    pseudo
        Pseudo-inertia of the head about the face centre, shape (4, 4).
    """
    volume, placed = envelope.volume, envelope.placed(pseudo)
    frame = np.eye(4)
    frame[:3, :3] = np.diag(0.5 * np.array(volume.size))
    frame[:3, 3] = volume.centre
    inverse = np.linalg.inv(frame)
    own = inverse @ placed @ inverse.T / placed[3, 3]
    step = 2.0 / (STEPS - 1)
    parts = _inside(volume, _lattice(STEPS) * step)
    masses, missed = _least_missed(parts, own)
    for _ in range(ROUNDS):
        if not 1e-3 * NEAR < missed < np.inf:
            break
        step *= 0.5
        parts = parts[masses > NEGLIGIBLE]
        parts = np.vstack([parts, _inside(volume, (parts[:, None] + _lattice(3) * step).reshape(-1, 3))])
        masses, missed = _least_missed(parts, own)
    if missed > NEAR:
        return []
    places = np.array(volume.centre) + parts * 0.5 * np.array(volume.size)
    order = [each for each in np.argsort(-masses, kind="stable") if masses[each] > NEGLIGIBLE]
    return [
        PointMass(float(mass), (float(x), float(y), float(z)))
        for mass, (x, y, z) in zip(masses[order] * placed[3, 3], places[order], strict=True)
    ]


def _lattice(count: int) -> NDArray[Any]:
    """Return whole numbers about 0, ``count`` along each axis, shape (count^3, 3)."""
    along = np.arange(count) - (count - 1) // 2
    return np.stack(np.meshgrid(along, along, along, indexing="ij"), axis=-1).reshape(-1, 3)


def _inside(volume: Volume, parts: NDArray[Any]) -> NDArray[Any]:
    """Return places, in parts of the way to the surface, with those beyond it moved onto it."""
    if volume.shape == "box":
        return np.clip(parts, -1.0, 1.0)
    return parts / np.maximum(np.linalg.norm(parts, axis=1), 1.0)[:, None]


def _least_missed(parts: NDArray[Any], own: NDArray[Any]) -> tuple[NDArray[Any], float]:
    """Return the masses at given places, 1 in all, that miss moments the least, and the greatest miss."""
    from scipy.optimize import linprog

    rows = np.hstack([parts, np.ones((len(parts), 1))])
    pairs = [(i, j) for i in range(4) for j in range(i, 4)]
    moments = np.array([rows[:, i] * rows[:, j] for i, j in pairs])
    wanted = np.array([own[pair] for pair in pairs])
    # The mass is exact; of the other moments, the sum of what they miss is made least.
    free = np.eye(len(pairs))[:, :-1]
    equal = np.hstack([moments, free, -free])
    cost = np.concatenate([np.zeros(len(parts)), np.ones(2 * free.shape[1])])
    found = linprog(cost, A_eq=equal, b_eq=wanted, bounds=(0.0, None), method="highs-ds")
    if found.status != 0:
        return np.zeros(len(parts)), np.inf
    masses = found.x[: len(parts)]
    return masses, float(np.abs(moments @ masses - wanted).max())
