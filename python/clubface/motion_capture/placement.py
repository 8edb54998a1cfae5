"""Where a cluster sits on the club, from an attitude that is known roughly and whatever else is known of its place.

The attitude of the club is assumed at one instant: at address, or at the blow. The rest is a small problem of least
squares in the six coordinates of the club against its markers. Each thing known, with its standard deviation, is a row.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.motion_capture.attitude import angles, delivered
from clubface.motion_capture.geometry import Known, usual_place
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.registration import Registration
from clubface.motion_capture.rigid_body import FEWEST
from clubface.motion_capture.rotations import Array, exponential

ROUNDS = 8
"""Of Gauss and Newton; two suffice where the positions given agree with the attitude to a few degrees."""
STEP = 1e-6
"""Metres and radians; of the central differences, and the least standard deviation of a given position."""
ODD = 4.0
"""Sum of squares for each row beyond which what is known contradicts itself."""


class Attitude(NamedTuple):
    """Attitude of the club at one instant.

    Attributes
    ----------
    values
        Loft, face angle and lie [rad], as for a right-hander.
    covariance
        Of them, shape (3, 3).
    """

    values: Array
    covariance: Array


def placed(markers: Array, attitude: Attitude, mapping: MarkerMap, club: Club, height: float | None) -> Registration:
    """Return the cluster on the club.

    Parameters
    ----------
    markers
        The markers of the cluster at that instant [m], in world axes as a right-hander sees them, shape (markers, 3).
    attitude
        That of the club.
    mapping, club
        Gives the markers their names, and some of them their positions; the club with its CG and face.
    height
        Height of the ground if the sole rests on it, up in world axes [m], or None.
    """
    names = tuple(mapping.cluster)
    cg = np.array(club.cg)
    assumed = delivered(attitude.values[0], attitude.values[1], attitude.values[2], club.loft)
    mean, spread = usual_place(club.kind, mapping.assumed)
    known = [place for place, name in enumerate(names) if mapping.cluster[name] is not None]
    given = np.array([mapping.cluster[names[place]] for place in known]).reshape(-1, 3)
    root = np.linalg.inv(np.linalg.cholesky(attitude.covariance))
    seen = (markers - markers.mean(0)) @ assumed
    start = seen + (mean if not known else given.mean(0) - seen[known].mean(0)) + cg
    origin = markers.mean(0) - assumed @ start.mean(0)
    nominal = 0.5 * club.face_height * np.cos(club.loft)

    def moved(x: Array) -> Array:
        """Return the markers in club axes, if the club stands ``x`` from where it was taken to be."""
        return (start - x[:3]) @ exponential(x[3:])

    def rows(x: Array) -> Array:
        """Return how far each known thing is off, in its standard deviations."""
        turned = assumed @ exponential(x[3:])
        off = [root @ (np.array(angles(turned, club.loft)) - attitude.values)]
        shape = moved(x) - cg
        if known:
            off.append(np.ravel(shape[known] - given) / max(mapping.position_deviation, STEP))
        else:
            off.append((shape.mean(0) - mean) / spread)
        if height is not None:
            centre = origin + assumed @ x[:3] + turned @ cg
            off.append(np.array([(centre[1] - height - nominal) / mapping.assumed.sole]))
        return np.concatenate(off)

    x, covariance = least_squares(rows, np.zeros(6))
    degrees = np.sqrt(np.diag(attitude.covariance))
    told = []
    if known:
        words = f"{len(known)} marker{'s' * (len(known) > 1)} from the face centre"
        told.append(Known.of(words, "given", "mm", deviations=[mapping.position_deviation]))
    else:
        told.append(Known.of("mean of the markers from the face centre", "assumed", "mm", mean, spread))
    if height is not None:
        told.append(
            Known.of("height of the face centre over the ground", "assumed", "mm", [nominal], [mapping.assumed.sole])
        )
    shape = moved(x)
    notes = _disagreement(
        rows(x), len(known), np.array(angles(assumed @ exponential(x[3:]), club.loft)), attitude, degrees
    )
    return Registration(names, shape, covariance, float("nan"), notes, tuple(told))


def least_squares(rows: Callable[[Array], Array], start: Array) -> tuple[Array, Array]:
    """Return where the sum of squares of ``rows`` is least, by Gauss and Newton, and the inverse of its information."""
    x = start
    inverse = np.eye(len(x))
    for _ in range(ROUNDS):
        steps = STEP * np.eye(len(x))
        jacobian = np.stack([(rows(x + step) - rows(x - step)) / (2.0 * STEP) for step in steps], 1)
        inverse = np.linalg.inv(jacobian.T @ jacobian)
        x = x - inverse @ jacobian.T @ rows(x)
    return x, inverse


def _disagreement(off: Array, known: int, values: Array, attitude: Attitude, deviations: Array) -> tuple[str, ...]:
    """Return a note where given positions contradict the assumed attitude."""
    if known < FEWEST or float(off @ off) <= ODD * len(off):
        return ()
    worst = int(np.argmax(np.abs(values - attitude.values) / deviations))
    angle = ("loft", "face angle", "lie")[worst]
    return (
        f"the positions of the markers contradict the attitude of the club that is assumed, most of all its {angle}"
        f" ({units.fixed(values[worst], 'deg', 1)}, not {units.fixed(attitude.values[worst], 'deg', 1)}): check them,"
        " or allow for more under [assumed]",
    )
