"""From launch, air, wind and ground to the columns of the core."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import ball
from clubface.errors import InputError, ShotError
from clubface.simulation.air import Air, air_of
from clubface.simulation.grounds import ground_of
from clubface.simulation.inputs import common_shape
from clubface.simulation.launch import Launch
from clubface.simulation.launch_terms import vectors
from clubface.simulation.quantities import flight_inputs, flight_outputs
from clubface.support.checks import check_names
from clubface.support.memory import FAILED, check_request

AXES = ("x", "y", "z")
VELOCITY = tuple(f"velocity_{axis}" for axis in AXES)
SPIN = tuple(f"spin_{axis}" for axis in AXES)
BALL = ("ball_mass", "ball_radius", "ball_inertia")
LEVEL = ("wind_speed", "wind_direction")
"""What says a level wind in place of its components: how fast it blows, and whereto."""


class FlightColumns(NamedTuple):
    """Flights as the core takes them.

    Attributes
    ----------
    columns
        The inputs by name, in the order of the core: a number, or an array of the flights, flat.
    shape
        The shape the inputs broadcast to; () for a single flight.
    varied
        The inputs given as arrays, by name, not broadcast; those of a :class:`Launch` stay with it.
    """

    columns: dict[str, Any]
    shape: tuple[int, ...]
    varied: dict[str, NDArray[Any]]


def flight_columns(
    launch: Launch | Mapping[str, Any],
    air: Air | Mapping[str, Any] | None,
    wind: Any,
    ground: str | Mapping[str, Any] | None,
) -> FlightColumns:
    """Lay out flights; the arguments are those of :func:`clubface.fly`."""
    inputs = flight_inputs()
    given: dict[str, Any] = {}
    if isinstance(launch, Launch):
        rows = {name: getattr(launch, name) for name in (*VELOCITY, *SPIN)}
        rows |= {name: launch.input(name) for name in BALL}
        given |= {name: _of_shape(value, launch.shape) for name, value in rows.items()}
    elif isinstance(launch, Mapping):
        given |= vectors({name: value for name, value in launch.items() if value is not None})
    else:
        raise InputError("launch", launch, "a Launch or a mapping of values")
    given |= conditions(air, wind, ground)
    parsed: dict[str, Any] = {name: each.default for name, each in inputs.items()} | ball().inputs()
    varied: dict[str, NDArray[Any]] = {}
    for name, value in given.items():
        value = _parsed(value, name)
        if not isinstance(value, float):
            value = varied[name] = np.asarray(value, dtype=np.float64)
        parsed[name] = value
    shape = common_shape(varied)
    copies = sum(each.shape != shape for each in varied.values())
    check_request(math.prod(shape), 8 * (len(flight_outputs()) + copies) + 2 * FAILED)  # once more, sorted
    flat = {
        name: value if isinstance(value, float) else np.ascontiguousarray(np.broadcast_to(value, shape)).reshape(-1)
        for name, value in parsed.items()
    }
    if isinstance(launch, Launch):
        varied = {name: value for name, value in varied.items() if name not in (*VELOCITY, *SPIN, *BALL)}
    return FlightColumns(flat, shape, varied)


def conditions(air: Air | Mapping[str, Any] | None, wind: Any, ground: Any = None) -> dict[str, Any]:
    """Return the inputs of a flight that air, wind and ground give [SI], by name."""
    blowing = _group("wind", _wind(wind), ("wind_x", "wind_y", "wind_z"))
    given = {**air_of(air).values(), **blowing, **ground_of(ground)}
    return {name: _parsed(value, name) for name, value in given.items()}


def check_conditions(air: Air | Mapping[str, Any] | None, wind: Any, ground: Any = None) -> None:
    """Refuse air, wind and ground, single numbers all, that no flight takes."""
    for name, given in conditions(air, wind, ground).items():
        value, allowed = _parsed(given, name), flight_inputs()[name]
        if not isinstance(value, float):
            raise InputError(name, "an array", "a single number")
        if not allowed.lower <= value <= allowed.upper:
            range_ = units.show_range(allowed.lower, allowed.upper, allowed.unit)
            raise InputError(name, units.show(value, allowed.unit), f"from {range_}")


def _parsed(value: Any, name: str) -> Any:
    return value if type(value) is float else units.parse_values(value, flight_inputs()[name].dimension, name=name)


def flight_error(error: ValueError, columns: Mapping[str, Any]) -> ShotError:
    """Turn the core's ``ValueError(name, message)`` about one flight into an error of the package."""
    name, message = error.args if len(error.args) == 2 else ("the request", str(error))
    value = columns.get(name)
    return ShotError(name, value if isinstance(value, float) else None, message)


def _of_shape(value: Any, shape: tuple[int, ...]) -> Any:
    return value.reshape(shape) if getattr(value, "ndim", 0) else float(value)


def _wind(wind: Any) -> Mapping[str, Any]:
    if wind is None or isinstance(wind, Mapping):
        return _level_wind(wind or {})
    scalar = isinstance(wind, str) or not hasattr(wind, "__len__") or getattr(wind, "ndim", 1) == 0
    if scalar or len(wind) != 3:
        raise InputError("wind", wind, 'three values: to the target, up and right, as in ("-10 mph", 0, 0)')
    return {f"wind_{axis}": value for axis, value in zip(AXES, wind, strict=True)}


def _level_wind(wind: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the components of a wind that is given by speed and direction; any other as it is."""
    rest = {name: value for name, value in wind.items() if name not in LEVEL}
    if len(rest) == len(wind):
        return wind
    for name in ("wind_x", "wind_z"):
        if name in rest:
            raise InputError(name, rest[name], "left out where the speed of the wind and its direction are given")
    if wind.get("wind_speed") is None:
        raise InputError("wind_speed", None, "give it with the direction of the wind")
    speed = units.parse_values(wind["wind_speed"], "speed", name="wind_speed")
    blows = wind.get("wind_direction")
    angle = units.parse_values(0.0 if blows is None else blows, "angle", name="wind_direction")
    along, across = speed * np.cos(angle), speed * np.sin(angle)
    if isinstance(speed, float) and isinstance(angle, float):
        along, across = float(along), float(across)
    return {**rest, "wind_x": along, "wind_z": across}


def _group(what: str, values: Any, known: Any) -> dict[str, Any]:
    if not isinstance(values, Mapping):
        raise InputError(what, values, f"a mapping of {', '.join(known)}")
    check_names(f"value of the {what}", values, known)
    return {name: value for name, value in values.items() if value is not None}
