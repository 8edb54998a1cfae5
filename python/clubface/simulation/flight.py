"""The flight of the ball through moist air and wind, its bounces and roll, and the named grounds.

Firmness of a ground and rolling resistance of its grass are independent. Firmness is the tilt of the effective plane of
a bounce and a factor on the restitution. The average ground lies between two published values: runs computed by a
TrackMan today imply a tilt of 13.3 deg, the PGA Tour's drives at most 12.3. Firm is the ground of TrackMan's chart of
2010 and of the LPGA Tour's drives; soft differs from the average by as much in the other direction. Grass has two
parameters. The rolling friction of a slow ball is, for fairways, that of Penner's average green, on which a ball runs 6
ft off a Stimpmeter (0.131), and for today's greens that of 10 ft (0.0784), both assumed. The distance over which grass
slows a fast ball is, for fairways, fitted to low shots computed by a TrackMan, and for greens, cut to a quarter of the
height, four times as long (assumed).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.balls import ball
from clubface.errors import InputError, ShotError, Wording
from clubface.results.notes import Note
from clubface.results.result import Result
from clubface.simulation.inputs import HandLike, check_on_error, common_shape, hand_value, thread_count
from clubface.simulation.launch import Comparison, Launch, assumptions_of, vectors
from clubface.simulation.results import (
    Batch,
    Series,
    Variable,
    Varied,
    first_error,
    flight_inputs,
    flight_outputs,
    index_of,
    translate_core_error,
)
from clubface.simulation.shot_shape import shot_shape
from clubface.support.arrays import Floats, NumberOrArray, ValueLike, flat
from clubface.support.checks import check_choice, check_names
from clubface.support.processes import FAILED, check_request
from clubface.support.version import __version__

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
"""Inputs of a flight [SI] by name of the ground; values that are not listed keep their defaults."""


MEASURED_DESCENT, MEASURED_SPEED = 25.0 * math.pi / 180.0, 19.0
"""Minimum descent angle [rad] and landing speed [m/s] of the balls whose runs were measured and published."""


def has_measured_run(landing_angle: float, landing_speed: float) -> bool:
    """Return whether measured runs are published for balls that land like this, not only runs computed by monitors."""
    return landing_angle >= MEASURED_DESCENT and landing_speed >= MEASURED_SPEED


def ground_of(ground: str | Mapping[str, Any] | None) -> dict[str, Any]:
    """Return the flight inputs of a ground given as None, a name, or a mapping of values."""
    if ground is None:
        return {}
    if isinstance(ground, str):
        check_choice("ground", ground, GROUNDS)
        return dict(GROUNDS[ground])
    if not isinstance(ground, Mapping):
        raise InputError("ground", ground, f"{', '.join(GROUNDS)}, or a mapping of values")
    return _group("ground", ground, [name for name, each in flight_inputs().items() if each.group == "ground"])


@dataclass(frozen=True, kw_only=True)
class Air:
    """The air that the ball flies through. A value is text with a unit, an SI number, or an array.

    Attributes
    ----------
    temperature
        Air temperature [K]. Default: 25 degC, to which published carries are normalised.
    pressure
        Air pressure [Pa]. Default: the standard atmosphere at the altitude.
    humidity
        Relative humidity, 0 to 1. Default: 0.5.
    altitude
        Altitude above sea level [m]; it sets the pressure, not the temperature.
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
            pressure = np.vectorize(core.pressure_at_altitude, otypes=[float])(altitude)
            object.__setattr__(self, "pressure", float(pressure) if isinstance(altitude, float) else pressure)
        allowed = flight_inputs()["pressure"]
        # In an array, an altitude whose pressure is out of range is reported with its flight.
        if isinstance(self.altitude, float) and not allowed.lower <= self.pressure <= allowed.upper:
            limits = units.show_range(allowed.lower, allowed.upper, "hPa")
            text = f"one at which the pressure of the standard atmosphere is {limits}, about -1400 to 9100 m"
            raise InputError("altitude", units.show(self.altitude, "m"), text)

    def values(self) -> dict[str, NumberOrArray]:
        """Return the inputs of a flight by name [SI]."""
        return {"temperature": self.temperature, "pressure": self.pressure, "humidity": self.humidity}


AirLike = Air | Mapping[str, ValueLike]
"""Air, or its values by name."""
WindLike = ValueLike | Mapping[str, ValueLike]
"""Components to the target, up and right, as a sequence or by name; or speed and direction of a level wind."""
GroundLike = str | Mapping[str, ValueLike]
"""The name of a ground, or its values by name."""


def air_of(values: Air | Mapping[str, Any] | None) -> Air:
    """Return the :class:`Air` for None, a mapping of its values, or an :class:`Air`."""
    if values is None:
        return Air()
    if isinstance(values, Air):
        return values
    if not isinstance(values, Mapping):
        raise InputError("air", values, "an Air or a mapping of its values")
    check_names("value of the air", values, Air.__dataclass_fields__)
    return Air(**values)


AXES = ("x", "y", "z")
VELOCITY = tuple(f"velocity_{axis}" for axis in AXES)
SPIN = tuple(f"spin_{axis}" for axis in AXES)
BALL = ("ball_mass", "ball_radius", "ball_inertia")
LEVEL = ("wind_speed", "wind_direction")
"""Keys of a level wind given by its speed and the direction it blows towards, instead of components."""


class FlightColumns(NamedTuple):
    """Inputs of flights in the form that the core takes."""

    columns: dict[str, Any]  # the inputs by name, in the order of the core: a number, or an array of the flights, flat
    shape: tuple[int, ...]  # shape to which the inputs broadcast; () for a single flight
    varied: dict[str, NDArray[Any]]  # the inputs given as arrays, not broadcast; those of a launch stay with it


def flight_columns(
    launch: Launch | Mapping[str, ValueLike],
    air: AirLike | None,
    wind: Any,
    ground: str | Mapping[str, Any] | None,
) -> FlightColumns:
    """Lay out flights for the core; arguments as for :func:`clubface.fly`."""
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
        value = parse_input(value, name)
        if not isinstance(value, float):
            value = varied[name] = np.asarray(value, dtype=np.float64)
        parsed[name] = value
    shape = common_shape(varied)
    copies = sum(each.shape != shape for each in varied.values())
    check_request(math.prod(shape), 8 * (len(flight_outputs()) + copies) + 2 * FAILED)  # once more, sorted
    columns = {name: flat(value, shape) for name, value in parsed.items()}
    if isinstance(launch, Launch):
        varied = {name: value for name, value in varied.items() if name not in (*VELOCITY, *SPIN, *BALL)}
    return FlightColumns(columns, shape, varied)


def conditions(air: AirLike | None, wind: Any, ground: GroundLike | None = None) -> dict[str, Any]:
    """Return the inputs of a flight given by air, wind and ground [SI], by name."""
    blowing = _group("wind", _wind(wind), ("wind_x", "wind_y", "wind_z"))
    given = {**air_of(air).values(), **blowing, **ground_of(ground)}
    return {name: parse_input(value, name) for name, value in given.items()}


def check_conditions(air: AirLike | None, wind: Any, ground: GroundLike | None = None) -> None:
    """Raise InputError if a value of air, wind or ground is not a single number or out of range."""
    for name, value in conditions(air, wind, ground).items():
        allowed = flight_inputs()[name]
        if not isinstance(value, float):
            raise InputError(name, "an array", "a single number")
        if not allowed.lower <= value <= allowed.upper:
            range_ = units.show_range(allowed.lower, allowed.upper, allowed.unit)
            raise InputError(name, units.show(value, allowed.unit), f"from {range_}")


def parse_input(value: Any, name: str) -> Any:
    """Return an input of a flight [SI], a number or an array; text is converted from its unit."""
    return value if type(value) is float else units.parse_values(value, flight_inputs()[name].dimension, name=name)


def flight_error(error: ValueError, columns: Mapping[str, Any]) -> ShotError:
    """Turn the core's ``ValueError(name, message)`` about one flight into an error of the package."""
    return translate_core_error(error, lambda name: value if isinstance(value := columns.get(name), float) else None)


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
    """Convert a wind given by speed and direction to components; return any other wind unchanged."""
    rest = {name: value for name, value in wind.items() if name not in LEVEL}
    if len(rest) == len(wind):
        return wind
    for name in ("wind_x", "wind_z"):
        if name in rest:
            raise InputError(name, rest[name], "left out if wind speed and direction are given")
    if wind.get("wind_speed") is None:
        raise InputError("wind_speed", None, "give it along with the wind direction")
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


class Flight(Batch):
    """The flight of the ball in SI and radians; every quantity is an attribute of the shape of the batch.

    Attributes
    ----------
    carry
        Straight distance from the start to the landing at the same height [m].
    side
        Distance of the landing from the target line [m], right is positive.
    apex
        Maximum height above the start [m].
    flight_time
        Time from launch to landing [s].
    landing_angle, landing_speed, landing_spin
        Angle of descent below the horizontal [rad], ball speed [m/s] and total spin [rad/s] at landing.
    total
        Straight distance from the start to where the ball comes to rest after bounces and roll [m].
    total_side
        Distance of the resting point from the target line [m], right is positive.
    outside_fit
        1 if the spin parameter left the range of the aerodynamic fit, else 0.
    curve
        Distance of the landing from the start line of the ball, across that line [m]; right is positive.
    launch
        The launch of the ball, or None if it was given as numbers.
    inputs
        The inputs of the flight by name [SI]; arrays are flat.
    shape
        Shape to which the inputs broadcast; () for a single flight.
    """

    _kind = "flight"

    carry: NumberOrArray
    side: NumberOrArray
    apex: NumberOrArray
    landing_angle: NumberOrArray
    flight_time: NumberOrArray
    landing_speed: NumberOrArray
    landing_spin: NumberOrArray
    total: NumberOrArray
    total_side: NumberOrArray
    outside_fit: NumberOrArray
    curve: NumberOrArray

    def __init__(
        self,
        values: Floats,
        inputs: Mapping[str, NumberOrArray],
        shape: tuple[int, ...],
        varied: Mapping[str, Floats],
        launch: Launch | None,
        problems: list[tuple[int, str, str]],
    ) -> None:
        self._values = values
        self.inputs = inputs
        self._varied = varied
        self._failures = problems
        self.shape = shape
        self.launch = launch

    @classmethod
    def quantities(cls) -> Mapping[str, Variable]:
        """Return the quantities of a flight by name, with unit and meaning."""
        return flight_outputs()

    @property
    def start(self) -> NumberOrArray:
        """Start direction of the ball in the horizontal plane [rad], right of the target is positive."""
        return _of_shape(np.arctan2(self.inputs["velocity_z"], self.inputs["velocity_x"]), self.shape)

    def shot_shape(self, hand: HandLike | None = None) -> Any:
        """Return the golfer's name of the shot, such as "pull hook"; an array for a batch.

        Parameters
        ----------
        hand
            1 or "right", -1 or "left". Default: the hand of the club, or right if no club is known.

        See Also
        --------
        clubface.simulation.shot_shape : the limits between the names and their source.
        """
        if hand is None:
            hand = 1.0 if self.launch is None else _of_shape(np.asarray(self.launch.input("hand")), self.launch.shape)
        return shot_shape(self.start, self.curve, self.carry, hand=hand_value(hand))

    def _headline(self) -> str:
        return f"flight after launch by {self.launch.model}" if self.launch is not None else "flight"

    def _assumptions(self) -> tuple[Note, ...]:
        return () if self.launch is None else assumptions_of([self.launch])

    @property
    def varied(self) -> Mapping[str, Varied]:
        """The inputs given as arrays, by name, including those of the impact if there was one."""
        result = dict(self.launch.varied) if self.launch is not None else {}
        for name, values in self._varied.items():
            each = flight_inputs()[name]
            result[name] = Varied(values, each.unit, each.meaning)
        return result

    @property
    def provenance(self) -> dict[str, Any]:
        """Launch, air, ground and version that the flight was computed with."""
        inputs = flight_inputs()
        held = {name: value for name, value in self.inputs.items() if isinstance(value, float)}
        groups = {
            group: {"values": {name: value for name, value in held.items() if inputs[name].group == group}}
            for group in ("ball", "launch", "air", "ground")
        }
        began = {"impact": self.launch.provenance} if self.launch is not None else {}
        return {**began, **groups, "clubface_version": __version__}


@overload
def fly(  # pyright: ignore[reportOverlappingOverload]
    launch: Comparison,
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> dict[str, Flight]: ...
@overload
def fly(
    launch: Launch | Mapping[str, ValueLike],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> Flight: ...
def fly(
    launch: Launch | Comparison | Mapping[str, ValueLike],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> Flight | dict[str, Flight]:
    """Compute the flight, bounces and roll of a launched ball.

    Parameters
    ----------
    launch
        A :class:`Launch`; a comparison of models, which gives one flight for each; or a mapping of launch monitor
        values (``ball_speed``, ``launch``, ``azimuth``, ``backspin``, ``sidespin``, or ``total_spin`` and
        ``spin_axis``) or of vector components (``velocity_x`` ... ``spin_z``), with ``ball_mass``, ``ball_radius``,
        ``ball_inertia`` if the ball is not the default one. Values are text with a unit, SI numbers, or arrays.
    air
        An :class:`Air` or a mapping of its values. Default: 25 degC at sea level.
    wind
        Wind velocity: three components to the target, up and right (``("-10 mph", 0, 0)`` is a headwind), a mapping of
        ``wind_x``, ``wind_y``, ``wind_z``, or a mapping of ``wind_speed`` and ``wind_direction``, the direction a level
        wind blows towards [rad]: 0 to the target, 90 degrees right, 180 degrees against the ball. Default: no wind.
    ground
        "fairway" (default), "firm fairway", "soft fairway", "green", "firm green", "soft green", or a mapping of
        ``restitution_factor``, ``ground_tilt``, ``ground_friction``, ``rolling_friction``, ``grass_length``.
    threads
        Number of threads. Default: all cores. The result does not depend on it.
    progress
        Function called with the number of flights done.
    on_error
        "raise" raises an error for a flight that cannot be computed, "nan" gives NaN and an entry in
        ``Flight.problems``. A launch without a result never raises an error; its flight is NaN.

    Returns
    -------
    Flight
        The flights; quantities have the shape to which the inputs broadcast.
    """
    if isinstance(launch, Comparison):
        return {
            name: fly(each, air=air, wind=wind, ground=ground, threads=threads, progress=progress, on_error=on_error)
            for name, each in launch.items()
        }
    check_on_error(on_error)
    cores = thread_count(threads)
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    count = math.prod(shape)
    try:
        values, problems = core.fly(list(columns.values()), count, cores, progress)
    except ValueError as error:
        raise flight_error(error, columns) from None
    if problems:
        problems, new = _sorted_problems(problems, columns, launch, shape)
        if new and on_error == "raise":
            value = columns.get(new[0][1])
            raise first_error(new, value if isinstance(value, float | None) else float(value[new[0][0]]), shape)
    return Flight(values, columns, shape, varied, launch if isinstance(launch, Launch) else None, problems)


def _sorted_problems(
    problems: list[tuple[int, str, str]], columns: Mapping[str, Any], launch: Any, shape: tuple[int, ...]
) -> tuple[list[tuple[int, str, str]], list[tuple[int, str, str]]]:
    """Replace the reasons of flights without a launch by the impact's; return all problems and the flights' own."""
    if not isinstance(launch, Launch) or not launch.problems:
        return problems, problems
    reasons = {each.row: each for each in launch.problems}
    speeds = columns["velocity_x"]
    every, new = [], []
    for row, name, message in problems:
        lost = math.isnan(speeds if isinstance(speeds, float) else speeds[row])
        if not lost:
            new.append((row, name, message))
        reason = reasons.get(index_of(row, shape)) if shape == launch.shape else None
        if lost and reason is not None:
            name, message = reason.parameter, reason.reason
        every.append((row, name, "there is no launch to fly" if lost and reason is None else message))
    return every, new


class Trajectory(Series):
    """The path of one ball from launch to landing.

    Attributes
    ----------
    time
        Time since launch [s], shape (n,).
    position, velocity, spin
        Position from the start, velocity and angular velocity [m, m/s, rad/s], to the target, up, right, shape (n, 3).
    inputs
        Inputs of the flight by name [SI].
    launch
        The launch of the ball, or None if it was given as numbers.
    """

    quantities = {  # noqa: RUF012
        "time": Variable("time", "s", "time since launch"),
        "position": Variable("position", "m", "from the start"),
        "velocity": Variable("velocity", "m/s", "velocity"),
        "spin": Variable("spin", "rad/s", "angular velocity"),
    }

    def __init__(self, arrays: Mapping[str, Floats], inputs: Mapping[str, float], launch: Launch | None = None) -> None:
        self._arrays = arrays
        self.time, self.position, self.velocity, self.spin = (arrays[name] for name in self.quantities)
        self.inputs = inputs
        self.launch = launch
        began = {} if launch is None else {"impact": launch.provenance}
        self.provenance = {**began, "inputs": {"values": dict(inputs)}}

    def to_result(self) -> Result:
        """Return place and time of the landing, and a table of all points."""
        from clubface.simulation.shot_result import trajectory_result

        return trajectory_result(self)

    def __repr__(self) -> str:
        carry = math.hypot(self.position[-1, 0], self.position[-1, 2])
        apex = self.position[:, 1].max()
        return f"trajectory of {len(self)} points: carry {carry:.5g} m, apex {apex:.4g} m, {self.time[-1]:.3g} s"


def trajectory(
    launch: Launch | Mapping[str, ValueLike],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
) -> Trajectory:
    """Compute the path of one ball at times at most 0.02 s apart; arguments as for :func:`fly`."""
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    if shape or varied:
        raise InputError("launch", Wording(f"a batch of shape {shape}"), "a single shot: a trajectory follows one ball")
    try:
        arrays = core.trajectory(list(columns.values()))
    except ValueError as error:
        raise flight_error(error, columns) from None
    return Trajectory(arrays, columns, launch if isinstance(launch, Launch) else None)
