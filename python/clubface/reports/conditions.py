"""Air, wind and ground of a flight in words, whether given or not: what another run needs to fly the same ball."""

from __future__ import annotations

from typing import Any

from clubface.simulation.air import air_of
from clubface.simulation.flight_inputs import conditions
from clubface.simulation.quantities import flight_inputs
from clubface.units import from_si, show


def flight_conditions(air: Any = None, wind: Any = None, ground: Any = None) -> dict[str, str]:
    """Return the conditions of a flight by name, those that were not given among them.

    Parameters
    ----------
    air, wind, ground
        As for :func:`clubface.fly`; single values.
    """
    known = flight_inputs()
    values = {name: each.default for name, each in known.items()} | conditions(air, wind, ground)
    altitude = air_of(air).altitude
    told = [show(values["temperature"], "degC"), show(values["pressure"], "hPa", 5)]
    told.append(f"{100.0 * values['humidity']:g} % humidity")
    if altitude is not None:
        told.append(f"the pressure being that at an altitude of {show(altitude, 'm')}")
    turf = (
        f"level turf after Penner (2002): tilt of the dent {show(values['ground_tilt'], 'deg', 3)}, friction "
        f"{values['ground_friction']:g} sliding and {values['rolling_friction']:g} rolling, restitution times "
        f"{values['restitution_factor']:g}, a fast ball slowed to 1/e in {show(values['grass_length'], 'm', 3)}"
    )
    return {"air": ", ".join(told), "wind": _wind(values), "ground": turf}


def _wind(values: dict[str, Any]) -> str:
    words = {"wind_x": ("with the shot", "against the shot"), "wind_y": ("upwards", "downwards"),
             "wind_z": ("to the right", "to the left")}  # fmt: skip
    told = [
        f"{show(abs(values[name]), 'm/s', 3)} ({from_si(abs(values[name]), 'mph'):.0f} mph) {sides[values[name] < 0.0]}"
        for name, sides in words.items()
        if values[name]
    ]
    return ", ".join(told) or "none"
