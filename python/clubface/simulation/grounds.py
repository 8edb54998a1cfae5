"""Named grounds on which balls bounce and roll.

How firm a ground is and how its grass slows a rolling ball are independent here. Firmness is the tilt of the effective
plane of a bounce: Penner's (2002) 15.4 deg, from Haake's measurements on greens, for an average ground; 1.5 deg less or
more for firm and soft is assumed, so that the average drive of the PGA Tour runs about 10 yards more or less. Grass is
the rolling friction: for fairways that of Penner's average green, on which a ball runs 6 ft off a Stimpmeter (0.131);
for greens of today that of 10 ft (0.0784). Both are assumed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from clubface.errors import InputError
from clubface.simulation.quantities import flight_inputs
from clubface.support.checks import check_choice, check_names

_TILTS = {"firm ": 13.9 * math.pi / 180.0, "": 15.4 * math.pi / 180.0, "soft ": 16.9 * math.pi / 180.0}
_ROLLING = {"fairway": 0.131, "green": 0.0784}

GROUNDS: Mapping[str, Mapping[str, float]] = MappingProxyType({
    firmness + surface: MappingProxyType({"ground_tilt": tilt, "rolling_friction": friction})
    for surface, friction in _ROLLING.items()
    for firmness, tilt in _TILTS.items()
})  # fmt: skip
"""Inputs of a flight [SI] by the name of the ground; what a ground does not name is as on any other."""


def ground_of(ground: str | Mapping[str, Any] | None) -> dict[str, Any]:
    """Return the inputs of a flight meant by None, the name of a ground, or a mapping of values themselves."""
    if ground is None:
        return {}
    if isinstance(ground, str):
        check_choice("ground", ground, GROUNDS)
        return dict(GROUNDS[ground])
    if not isinstance(ground, Mapping):
        raise InputError("ground", ground, f"{', '.join(GROUNDS)}, or a mapping of values")
    check_names(
        "value of the ground", ground, [name for name, each in flight_inputs().items() if each.group == "ground"]
    )
    return {name: value for name, value in ground.items() if value is not None}
