"""Named grounds on which balls bounce and roll.

How firm a ground is and how its grass slows a rolling ball are independent here. Firmness is the tilt of the effective
plane of a bounce and a factor on the restitution. The average ground lies between two published readings: runs that a
TrackMan computes today ask for a tilt of 13.3 deg, those of the PGA Tour's drives for at most 12.3. Firm is the ground
of TrackMan's chart of 2010 and of the LPGA Tour's drives; soft differs from the average as much to the other side.

Grass is the rolling friction of a slow ball, for fairways that of Penner's average green, on which a ball runs 6 ft off
a Stimpmeter (0.131), for greens of today that of 10 ft (0.0784), both assumed; and the way over which it slows a fast
ball, for fairways from low shots that a TrackMan computes, for greens, cut to a quarter, four times as long (assumed).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from clubface.errors import InputError
from clubface.simulation.quantities import flight_inputs
from clubface.support.checks import check_choice, check_names

_FIRMNESS = {
    "firm ": {"ground_tilt": 9.5 * math.pi / 180.0, "restitution_factor": 1.3},
    "": {"ground_tilt": 12.3 * math.pi / 180.0, "restitution_factor": 1.0},
    "soft ": {"ground_tilt": 15.1 * math.pi / 180.0, "restitution_factor": 0.7},
}
_GRASS = {
    "fairway": {"rolling_friction": 0.131, "grass_length": 23.0},
    "green": {"rolling_friction": 0.0784, "grass_length": 92.0},
}

GROUNDS: Mapping[str, Mapping[str, float]] = MappingProxyType({
    firmness + surface: MappingProxyType(bounce | grass)
    for surface, grass in _GRASS.items()
    for firmness, bounce in _FIRMNESS.items()
})  # fmt: skip
"""Inputs of a flight [SI] by the name of the ground; what a ground does not name is as on any other."""


MEASURED_DESCENT, MEASURED_SPEED = 25.0 * math.pi / 180.0, 19.0
"""Least angle of descent [rad] and least speed [m/s] at landing of balls whose runs were measured and published."""


def has_measured_run(landing_angle: float, landing_speed: float) -> bool:
    """Return whether runs of balls that land like this are published, and not only computed by a monitor."""
    return landing_angle >= MEASURED_DESCENT and landing_speed >= MEASURED_SPEED


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
