"""The air a ball flies through."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.simulation import core
from clubface.simulation.quantities import flight_inputs
from clubface.support.checks import check_names


@dataclass(frozen=True, kw_only=True)
class Air:
    """The air the ball flies through, each value text with a unit, an SI number, or an array.

    Attributes
    ----------
    temperature
        [K]; 25 degC where nothing is said, to which published carries are normalised.
    pressure
        [Pa]; left out, that of the standard atmosphere at the altitude.
    humidity
        Relative, 0 to 1; 0.5 where nothing is said.
    altitude
        Above the sea [m]; it sets the pressure, not the temperature.
    """

    temperature: Any = None
    pressure: Any = None
    humidity: Any = None
    altitude: Any = None

    def __post_init__(self) -> None:
        for name in ("temperature", "pressure", "humidity"):
            if getattr(self, name) is None:
                object.__setattr__(self, name, flight_inputs()[name].default)
            elif name == "pressure" and self.altitude is not None:
                raise InputError("altitude", self.altitude, "leave it out, since the pressure is given")
            else:
                value = units.parse_values(getattr(self, name), flight_inputs()[name].dimension, name=name)
                object.__setattr__(self, name, value)
        if self.altitude is not None:
            altitude = units.parse_values(self.altitude, "length", name="altitude")
            object.__setattr__(self, "altitude", altitude)
            object.__setattr__(self, "pressure", _pressure(altitude))
            self._check_altitude()

    def _check_altitude(self) -> None:
        """Refuse one altitude whose pressure a flight does not take; a bad one of many is reported with its flight."""
        allowed = flight_inputs()["pressure"]
        if isinstance(self.altitude, float) and not allowed.lower <= self.pressure <= allowed.upper:
            limits = units.show_range(allowed.lower, allowed.upper, "hPa")
            text = f"where the pressure of the standard atmosphere is {limits}, about -1400 to 9100 m"
            raise InputError("altitude", units.show(self.altitude, "m"), text)

    def values(self) -> dict[str, Any]:
        """Return the inputs of a flight, SI, by name."""
        return {"temperature": self.temperature, "pressure": self.pressure, "humidity": self.humidity}


def air_of(values: Air | Mapping[str, Any] | None) -> Air:
    """Return the air meant by None, a mapping of its values, or an :class:`Air` itself."""
    if values is None:
        return Air()
    if isinstance(values, Air):
        return values
    if not isinstance(values, Mapping):
        raise InputError("air", values, "an Air or a mapping of its values")
    check_names("value of the air", values, Air.__dataclass_fields__)
    return Air(**values)


def _pressure(altitude: Any) -> Any:
    if isinstance(altitude, float):
        return core.pressure_at_altitude(altitude)
    flat = [core.pressure_at_altitude(each) for each in altitude.ravel().tolist()]
    return np.array(flat, dtype=np.float64).reshape(altitude.shape)
