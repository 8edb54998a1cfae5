"""The displaced mass centre of the model ``adjusted``, from the forces on a ball of finite elements."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface.errors import InputError
from clubface.fem.result import Impact


class Displacement(NamedTuple):
    """Where the mass centre of a deformed ball is, as an impulse at one point sees it.

    The impulse acts at the distance R from an undeformed ball's centre. With a mass centre displaced by (``normal``,
    ``up``, ``toe``) it has the moments that the forces of the contact had about the ball's mass centre.

    Attributes
    ----------
    normal
        Displacement away from the face [m], averaged with the force along the face; negative is nearer the face.
    up, toe
        Displacement up the face and towards the toe from the centre of pressure [m], averaged with the normal force.
    moment
        The moment about the toe direction over the normal impulse, less that of a ball that stays round [m]: the
        displacement up the face that would do all by itself. Positive adds backspin.
    """

    normal: float
    up: float
    toe: float
    moment: float


def displaced_centre(found: Impact) -> Displacement:
    """Return the displacement of the mass centre that the model ``adjusted`` calls dCG, from a finished impact.

    The directions are those of first touch, as in the model. With a head, ``up`` and ``toe`` thus include what the head
    turns and the face curves while the ball is on it.
    """
    if found.stopped is not None:
        raise InputError("impact", found, "a complete one")
    patch, motion = found.patch, found.motion
    times, record = np.unique(patch["time"], return_inverse=True)
    keys = ("normal", "tangential")
    normal, tangential = (np.bincount(record, weights=patch[key]) for key in keys)
    up, toe = (np.bincount(record, weights=patch["normal"] * patch[key]) for key in ("up", "toe"))
    lever = np.interp(times, motion["time"], motion["radius"])
    along, across = np.trapezoid(tangential, times), np.trapezoid(normal, times)
    nearer = np.trapezoid(tangential * lever, times) / along - 0.5 * found.ball.diameter
    shift_up, shift_toe = (-np.trapezoid(each, times) / across for each in (up, toe))
    return Displacement(float(nearer), float(shift_up), float(shift_toe), float(shift_up + nearer * along / across))
