"""The strikes that models and parameter sets were made for; outside, nothing tells how near they are."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_choice
from clubface.support.frozen import Frozen

Range = Mapping[str, tuple[float, float]]
"""Least and greatest value [SI] by quantity."""


class Bounded(NamedTuple):
    """A quantity of a strike: in words, and the unit people read it in."""

    words: str
    unit: str


QUANTITIES = {
    "speed": Bounded("clubhead speed", "mph"),
    "incidence": Bounded("angle between path and face normal", "deg"),
    "friction": Bounded("friction", "1"),
    "club_mass": Bounded("mass of the head", "g"),
    "characteristic_time": Bounded("characteristic time", "us"),
    "ball_backspin": Bounded("backspin before impact", "rpm"),
    "ball_sidespin": Bounded("sidespin before impact", "rpm"),
    "ball_riflespin": Bounded("riflespin before impact", "rpm"),
}
"""What a range can be of: inputs of a shot, ``friction`` of the model's parameters, and ``incidence``, the angle
between the velocity of the clubhead and the normal at the face centre."""

RANGES: Mapping[str, Range] = {
    "response": {
        "speed": (10.0, 65.0),
        "incidence": (0.0, math.radians(72.0)),
        "friction": (0.05, 0.6),
        "club_mass": (0.16, 5.0),
        "characteristic_time": (0.0, 350e-6),
        **dict.fromkeys(("ball_backspin", "ball_sidespin", "ball_riflespin"), (-100.0 * math.pi, 100.0 * math.pi)),
    }
}
"""Ranges by model: the strikes from which its parameters come for every ball. The strikes by finite elements to which
``response`` is fitted are made from its range. Places on the face are not bounded: off centre a head gives way more
easily, and the small heads among the strikes do so as much as the built-in clubs 30 mm beside the face centre."""


OF_THE_RANGE = " of the range"
"""How an error about one quantity of a range names it."""


def checked_range(given: Mapping[str, Any]) -> Range:
    """Return a range in SI from pairs of values, each text with a unit or an SI number."""
    found = {}
    for name, ends in given.items():
        check_choice("quantity of a range", name, QUANTITIES)
        if not (isinstance(ends, (list, tuple)) and len(ends) == 2):
            raise InputError(name + OF_THE_RANGE, ends, "two values, the least and the greatest")
        dimension = units.unit(QUANTITIES[name].unit).dimension
        least, most = (units.parse(each, dimension, name=name + OF_THE_RANGE) for each in ends)
        if not least <= most:
            raise InputError(name + OF_THE_RANGE, list(ends), "two values, the least first")
        found[name] = (least, most)
    return Frozen(found)


def in_words(of: Range) -> str:
    """Return a range in words: "clubhead speed 101 to 118 mph"."""
    return ", ".join(f"{QUANTITIES[name].words} {ends_in_words(name, of)}" for name in of)


def ends_in_words(name: str, of: Range) -> str:
    """Return the ends of one quantity of a range: "101 to 118 mph"."""
    least, most = of[name]
    return f"{units.show(least, QUANTITIES[name].unit, 4).split()[0]} to {units.show(most, QUANTITIES[name].unit, 4)}"
