"""Knowledge about the geometry of a swing: measured, given or assumed, and how accurately.

A marker map may leave out things that a delivery depends on, such as the marker positions on the head or the position
of the ball. They are then assumed; the standard deviation of the assumption enters the delivery's, and the result lists
it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.capture.rotations import Array, face_axes
from clubface.equipment.clubs import Club
from clubface.equipment.face import face_point, nearest
from clubface.schema import PhysicalValue, check_values, file_key, quantities

_DEGREE, _MM = units.size("deg"), units.size("mm")
GIVEN = 1.0 * _MM
"""Default standard deviation of a given position [m]: a calliper measurement on a rounded head."""
GUESSED = 10.0 * _MM
"""Default standard deviation of a given ball position [m]: the ball is replaced for every shot."""


class Known(NamedTuple):
    """A known part of the geometry.

    Attributes
    ----------
    name
        Description, such as "face angle at address".
    how
        "measured", "given" or "assumed".
    quantity
        Name of the quantity of its values; "" if it has none.
    values, deviations
        Values and their standard deviations [SI]; empty if there are none.
    """

    name: str
    how: str
    quantity: str = ""
    values: Sequence[float] = ()
    deviations: Sequence[float] = ()

    def pairs(self) -> list[tuple[float | None, float | None]]:
        """Return each value with its standard deviation, with None for missing ones."""
        return list(zip_longest(self.values, self.deviations)) or [(None, None)]


ANGLE, LENGTH = PhysicalValue("deg", above=0), PhysicalValue("mm", above=0)


@dataclass(frozen=True, kw_only=True)
class Assumed:
    """Standard deviations [rad, m] of assumptions that replace measurements.

    Golfers who intend to aim square miss by about 2 degrees, and their hands lean the shaft. Published impact models
    differ by 1.2 degrees in the direction of the impulse, and the shaft restrains the head slightly. The usual delivery
    has a square face, the club's lie, and the club's loft plus 3 degrees for a wood or minus 7 degrees for an iron.
    """

    face: float = file_key(ANGLE, "face angle at address, about square", default=2.0 * _DEGREE)
    loft: float = file_key(ANGLE, "loft at address, about the club's", default=2.0 * _DEGREE)
    lie: float = file_key(ANGLE, "lie at address, about the club's", default=2.0 * _DEGREE)
    delivered_loft: float = file_key(ANGLE, "loft at impact, about the usual value", default=6.0 * _DEGREE)
    delivered_face: float = file_key(ANGLE, "face angle at impact, about square", default=4.0 * _DEGREE)
    delivered_lie: float = file_key(ANGLE, "lie at impact, about the club's", default=3.0 * _DEGREE)
    impulse: float = file_key(
        ANGLE, "direction of the impulse in the impact model", old_name="blow", default=2.0 * _DEGREE
    )
    sole: float = file_key(LENGTH, "height of the face centre above the ground at address", default=5.0 * _MM)
    place: float | None = file_key(
        LENGTH,
        "mean marker position from the face centre along each axis of the club; "
        "default 20, 10 and 15 mm (wood) or 10, 20 and 20 mm (iron)",
        default=None,
    )
    toe: float = file_key(LENGTH, "impact point towards the toe, about the face centre", default=12.0 * _MM)
    high: float = file_key(LENGTH, "impact point up the face, about the face centre", default=10.0 * _MM)

    def __post_init__(self) -> None:
        check_values(self)

    def stated(self) -> dict[str, float]:
        """Return the values that differ from their defaults."""
        usual = Assumed()
        return {
            name: getattr(self, name) for name in quantities(Assumed) if getattr(self, name) != getattr(usual, name)
        }


USUAL_PLACE: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]] = {
    "wood": ((-0.045, 0.030, 0.0), (0.020, 0.010, 0.015)),
    "iron": ((-0.010, 0.015, -0.010), (0.010, 0.020, 0.020)),
}
"""Mean marker position from the face centre [m] in club axes, and its standard deviation, for markers on the crown of a
wood, or on back, hosel and top line of an iron. Wide enough for any place where markers can be attached."""


def usual_place(kind: str, assumed: Assumed) -> tuple[Array, Array]:
    """Return the assumed mean marker position from the face centre [m], and its standard deviations."""
    place, deviations = USUAL_PLACE["iron" if kind == "iron" else "wood"]
    spread = np.array(deviations) if assumed.place is None else np.full(3, assumed.place)
    return np.array(place), spread


def off_face(club: Club, toe: float, high: float, distance: float) -> Array:
    """Return the point at a distance in front of a face point [m], from the face centre, in club axes [m]."""
    touched = face_point(toe, high, club.bulge, club.roll)
    return face_axes(club.loft) @ (touched + distance * nearest(touched, club.bulge, club.roll)[1])
