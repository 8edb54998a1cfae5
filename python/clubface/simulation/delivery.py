"""How the clubhead arrives at the ball."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any, Self

from clubface import units
from clubface.support.checks import check_names


@dataclass(frozen=True, kw_only=True)
class Delivery:
    """A delivery, each value text with a unit (``"113 mph"``), an SI number, or an array of either.

    Velocity and angular velocity are those of the clubhead's CG at first touch. For a left-handed club path and face
    angle stay in world terms, everything else follows the club.

    Attributes
    ----------
    speed
        Speed of the clubhead [m/s]; the one value that cannot be left out.
    attack
        Attack angle [rad], moving up is positive.
    path
        Club path [rad], moving right of the target is positive.
    loft
        Dynamic loft [rad]: face normal at the face centre above horizontal. Left out, it is the club's static loft.
    face
        Face angle [rad], pointing right of the target is positive.
    lie
        Lie tilt [rad], toe up is positive.
    toe, high
        Impact point [m] from the face centre, towards the toe and towards the crown.
    closure
        Rate of the face closing, about the vertical [rad/s].
    pitch_rate
        Rate of the loft increasing [rad/s].
    lie_rate
        Rate of the toe rising [rad/s].
    ball_backspin, ball_sidespin, ball_riflespin
        Spin of the ball before impact [rad/s], about the horizontal to the right of the target, about the downward
        vertical and about the horizontal to the target; zero for the ball at rest of golf.
    """

    speed: Any
    attack: Any = 0.0
    path: Any = 0.0
    loft: Any = None
    face: Any = 0.0
    lie: Any = 0.0
    toe: Any = 0.0
    high: Any = 0.0
    closure: Any = 0.0
    pitch_rate: Any = 0.0
    lie_rate: Any = 0.0
    ball_backspin: Any = 0.0
    ball_sidespin: Any = 0.0
    ball_riflespin: Any = 0.0

    def __post_init__(self) -> None:
        for name, dimension in DIMENSIONS.items():
            value = getattr(self, name)
            if not (name == "loft" and value is None):
                object.__setattr__(self, name, units.parse_values(value, dimension, name=name))

    def values(self) -> dict[str, Any]:
        """Return the values given, SI, by name."""
        given = {name: getattr(self, name) for name in DIMENSIONS}
        return {name: value for name, value in given.items() if value is not None}

    def replace(self, **changes: Any) -> Self:
        """Return the delivery with some values changed."""
        names = [each.name for each in fields(self)]
        check_names("delivery value", changes, names)
        return replace(self, **changes)


OF_CLUB = {
    "speed": "speed", "attack": "angle", "path": "angle", "loft": "angle", "face": "angle", "lie": "angle",
    "toe": "length", "high": "length", "closure": "angular rate", "pitch_rate": "angular rate",
    "lie_rate": "angular rate",
}  # fmt: skip
"""The dimension of each value of a delivery that the club has, in the order of the core."""
DIMENSIONS = {
    **OF_CLUB, "ball_backspin": "angular rate", "ball_sidespin": "angular rate", "ball_riflespin": "angular rate",
}  # fmt: skip
"""The dimension of each value of a delivery, in the order of the core."""
