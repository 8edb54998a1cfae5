"""What is known of the geometry of a swing: measured, given or assumed, and how well.

A marker map may leave things open that a delivery depends on: how the markers sit on the head, where the ball lies.
Something is then assumed in their place. Its standard deviation goes into that of the delivery, and the result tells
what it was.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.capture.rotations import Array
from clubface.schema import PhysicalValue, check_values, file_key, quantities

_DEGREE, _MM = units.size("deg"), units.size("mm")
GIVEN = 1.0 * _MM
"""Accuracy of a given position unless given [m]: that of a calliper on a rounded head."""
GUESSED = 10.0 * _MM
"""Accuracy of a given place of the ball unless given [m]: a ball is put down there again and again."""


class Known(NamedTuple):
    """One part of the geometry.

    Attributes
    ----------
    name
        In words, such as "face angle at address".
    how
        "measured", "given" or "assumed".
    quantity
        The quantity of its values, by name; "" where there are none.
    values, deviations
        Its values and their standard deviations [SI]; empty where there is nothing to state.
    """

    name: str
    how: str
    quantity: str = ""
    values: Sequence[float] = ()
    deviations: Sequence[float] = ()

    def pairs(self) -> list[tuple[float | None, float | None]]:
        """Return each value with its standard deviation, None for one that is not stated."""
        return list(zip_longest(self.values, self.deviations)) or [(None, None)]


ANGLE, LENGTH = PhysicalValue("deg", above=0), PhysicalValue("mm", above=0)


@dataclass(frozen=True, kw_only=True)
class Assumed:
    """Standard deviations [rad, m] of what is assumed where it is not measured.

    Golfers who mean to aim square are some 2 degrees off, and the hands lean the shaft. Published models of impact
    differ in the direction of the impulse by 1.2 degrees, and the shaft holds the head a little. The usual delivery has
    a square face, the lie of the club, and its loft and 3 degrees for a wood, less 7 degrees for an iron.
    """

    face: float = file_key(ANGLE, "of the face angle at address about square", default=2.0 * _DEGREE)
    loft: float = file_key(ANGLE, "of the loft at address about that of the club", default=2.0 * _DEGREE)
    lie: float = file_key(ANGLE, "of the lie at address about that of the club", default=2.0 * _DEGREE)
    delivered_loft: float = file_key(ANGLE, "of the loft at impact about the usual", default=6.0 * _DEGREE)
    delivered_face: float = file_key(ANGLE, "of the face angle at impact, likewise", default=4.0 * _DEGREE)
    delivered_lie: float = file_key(ANGLE, "of the lie at impact, likewise", default=3.0 * _DEGREE)
    impulse: float = file_key(
        ANGLE, "of the direction of the impulse by the impact model", old_name="blow", default=2.0 * _DEGREE
    )
    sole: float = file_key(LENGTH, "of the height of the face centre over the ground at address", default=5.0 * _MM)
    place: float | None = file_key(
        LENGTH,
        "of the mean of the markers from the face centre along each axis of the club; "
        "20, 10 and 15 mm (wood) or 10, 20 and 20 mm (iron) unless given",
        default=None,
    )
    toe: float = file_key(LENGTH, "of the impact point about the face centre", default=12.0 * _MM)
    high: float = file_key(LENGTH, "the same, upwards", default=10.0 * _MM)

    def __post_init__(self) -> None:
        check_values(self)

    def stated(self) -> dict[str, float]:
        """Return those that differ from their defaults."""
        usual = Assumed()
        return {name: getattr(self, name) for name in DIMENSIONS if getattr(self, name) != getattr(usual, name)}


DIMENSIONS: Mapping[str, str] = {name: each.dimension for name, each in quantities(Assumed).items()}
USUAL_PLACE: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]] = {
    "wood": ((-0.045, 0.030, 0.0), (0.020, 0.010, 0.015)),
    "iron": ((-0.010, 0.015, -0.010), (0.010, 0.020, 0.020)),
}
"""Where the mean of the markers on a head lies from its face centre [m], club axes, and its standard deviation: on the
crown of a wood; on back, hosel and top line of an iron. Wide enough for wherever they can be stuck."""


def usual_place(kind: str, assumed: Assumed) -> tuple[Array, Array]:
    """Return where the mean of the markers lies from the face centre [m], and its standard deviations, if untold."""
    place, deviations = USUAL_PLACE["iron" if kind == "iron" else "wood"]
    spread = np.array(deviations) if assumed.place is None else np.full(3, assumed.place)
    return np.array(place), spread
