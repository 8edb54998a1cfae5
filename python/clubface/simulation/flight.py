"""The flight of the ball through moist air and wind, its bounces and its roll on grounds that go by name.

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
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import ball
from clubface.errors import InputError, ShotError, Wording
from clubface.results.notes import Note
from clubface.results.result import Result
from clubface.simulation import core
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
from clubface.support.arrays import Floats, NumberOrArray, ValueLike
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
    return _group("ground", ground, [name for name, each in flight_inputs().items() if each.group == "ground"])


@dataclass(frozen=True, kw_only=True)
class Air:
    """The air the ball flies through, each value text with a unit, an SI number, or an array.

    Attributes
    ----------
    temperature
        [K]; 25 degC unless given, to which published carries are normalised.
    pressure
        [Pa]; left out, that of the standard atmosphere at the altitude.
    humidity
        Relative, 0 to 1; 0.5 unless given.
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
            pressure = [core.pressure_at_altitude(each) for each in np.ravel(altitude).tolist()]
            whole = pressure[0] if isinstance(altitude, float) else np.array(pressure).reshape(np.shape(altitude))
            object.__setattr__(self, "pressure", whole)
        allowed = flight_inputs()["pressure"]
        # One of many altitudes whose pressure a flight does not take is reported with its flight.
        if isinstance(self.altitude, float) and not allowed.lower <= self.pressure <= allowed.upper:
            limits = units.show_range(allowed.lower, allowed.upper, "hPa")
            text = f"where the pressure of the standard atmosphere is {limits}, about -1400 to 9100 m"
            raise InputError("altitude", units.show(self.altitude, "m"), text)

    def values(self) -> dict[str, NumberOrArray]:
        """Return the inputs of a flight, SI, by name."""
        return {"temperature": self.temperature, "pressure": self.pressure, "humidity": self.humidity}


AirLike = Air | Mapping[str, ValueLike]
"""Air, or its values by name."""
WindLike = ValueLike | Mapping[str, ValueLike]
"""Three components to the target, up and right; or these by name, or speed and direction of a level wind."""
GroundLike = str | Mapping[str, ValueLike]
"""The name of a ground, or its values by name."""


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


AXES = ("x", "y", "z")
VELOCITY = tuple(f"velocity_{axis}" for axis in AXES)
SPIN = tuple(f"spin_{axis}" for axis in AXES)
BALL = ("ball_mass", "ball_radius", "ball_inertia")
LEVEL = ("wind_speed", "wind_direction")
"""The keys of a level wind, given by its speed and the direction in which it blows, instead of its components."""


class FlightColumns(NamedTuple):
    """Flights as the core takes them."""

    columns: dict[str, Any]  # the inputs by name, in the order of the core: a number, or an array of the flights, flat
    shape: tuple[int, ...]  # to which the inputs broadcast; () for a single flight
    varied: dict[str, NDArray[Any]]  # the inputs given as arrays, not broadcast; those of a launch stay with it


def flight_columns(
    launch: Launch | Mapping[str, ValueLike],
    air: AirLike | None,
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
        value = parse_input(value, name)
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


def conditions(air: AirLike | None, wind: Any, ground: GroundLike | None = None) -> dict[str, Any]:
    """Return the inputs of a flight that air, wind and ground give [SI], by name."""
    blowing = _group("wind", _wind(wind), ("wind_x", "wind_y", "wind_z"))
    given = {**air_of(air).values(), **blowing, **ground_of(ground)}
    return {name: parse_input(value, name) for name, value in given.items()}


def check_conditions(air: AirLike | None, wind: Any, ground: GroundLike | None = None) -> None:
    """Refuse air, wind and ground, single numbers all, that no flight takes."""
    for name, value in conditions(air, wind, ground).items():
        allowed = flight_inputs()[name]
        if not isinstance(value, float):
            raise InputError(name, "an array", "a single number")
        if not allowed.lower <= value <= allowed.upper:
            range_ = units.show_range(allowed.lower, allowed.upper, allowed.unit)
            raise InputError(name, units.show(value, allowed.unit), f"from {range_}")


def parse_input(value: Any, name: str) -> Any:
    """Return an input of a flight [SI], a number or an array; text is converted from its unit."""
    """Return an input of a flight [SI], a number or an array."""
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


class Flight(Batch):
    """Where the ball goes, SI and radians; every quantity is an attribute, of the shape of the batch.

    Attributes
    ----------
    carry
        Straight distance from the start to where the ball comes down to its height [m].
    side
        Distance of the landing from the target line [m], right is positive.
    apex
        Greatest height above the start [m].
    landing_angle
        Angle of descent below the horizontal [rad].
    flight_time
        From launch to landing [s].
    landing_speed
        [m/s].
    landing_spin
        [rad/s].
    total
        Straight distance from the start to rest, after bounces and roll [m].
    total_side
        Distance of the place of rest from the target line [m], right is positive.
    outside_fit
        1 where the spin parameter left the range of the aerodynamic fit, else 0.
    curve
        Distance of the landing from the line on which the ball starts [m], across that line; right is positive.
    launch
        The launch it began with, or None where it was given as numbers.
    shape
        The shape the inputs broadcast to; () for a single flight.
    problems
        The flights without a result (their values are NaN) and why.
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
        columns: Mapping[str, NumberOrArray],
        shape: tuple[int, ...],
        varied: Mapping[str, Floats],
        launch: Launch | None,
        problems: list[tuple[int, str, str]],
    ) -> None:
        self._values = values
        self._columns = columns
        self._varied = varied
        self._failures = problems
        self.shape = shape
        self.launch = launch

    @classmethod
    def quantities(cls) -> Mapping[str, Variable]:
        """Return the quantities by name, with unit and meaning."""
        return flight_outputs()

    @property
    def start(self) -> NumberOrArray:
        """Horizontal direction in which the ball starts [rad], right of the target is positive."""
        return _of_shape(np.arctan2(self._columns["velocity_z"], self._columns["velocity_x"]), self.shape)

    def shot_shape(self, hand: HandLike | None = None) -> Any:
        """Return what golfers call the shot, such as "pull hook", and an array of it for a batch.

        Parameters
        ----------
        hand
            1 or "right", -1 or "left"; that of the club unless given, and right where no club is known.

        See Also
        --------
        clubface.simulation.shot_shape : the limits between the names, and their source.
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
        """The inputs that were given as arrays, by name; those of the impact where there was one."""
        result = dict(self.launch.varied) if self.launch is not None else {}
        for name, values in self._varied.items():
            each = flight_inputs()[name]
            result[name] = Varied(values, each.unit, each.meaning)
        return result

    @property
    def inputs(self) -> Mapping[str, NumberOrArray]:
        """What it was computed from, by name [SI]; an array is flat."""
        return self._columns

    @property
    def provenance(self) -> dict[str, Any]:
        """The launch it began with, air, ground and version."""
        inputs = flight_inputs()
        held = {name: value for name, value in self._columns.items() if isinstance(value, float)}
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
    """Compute where a launched ball goes.

    Parameters
    ----------
    launch
        A :class:`Launch`; a comparison of models, which gives one flight for each; or a mapping of values, in the terms
        of a launch monitor (``ball_speed``, ``launch``, ``azimuth``, ``backspin``, ``sidespin``, or ``total_spin``
        and ``spin_axis``) or as vectors (``velocity_x`` ... ``spin_z``), with ``ball_mass``, ``ball_radius``,
        ``ball_inertia`` where the ball is not the default one. Text with a unit, SI numbers, or arrays.
    air
        An :class:`Air` or a mapping of its values; left out, 25 degC at sea level.
    wind
        Velocity of the wind to the target, up and right, three values (``("-10 mph", 0, 0)`` is a headwind), or a
        mapping of ``wind_x``, ``wind_y``, ``wind_z``, or of ``wind_speed`` and ``wind_direction`` [rad], where a
        level wind blows to: 0 to the target, 90 degrees right, 180 degrees against the ball. No wind if left out.
    ground
        "fairway" (so if left out), "firm fairway", "soft fairway", "green", "firm green", "soft green", or a mapping of
        ``restitution_factor``, ``ground_tilt``, ``ground_friction``, ``rolling_friction``, ``grass_length``.
    threads
        How many threads compute; all cores if left out. The result does not depend on it.
    progress
        Called with the number of flights done.
    on_error
        What happens to a flight that cannot be computed: "raise" raises an error, "nan" gives NaN and an entry in
        ``Flight.problems``. A launch without a result has no flight either, and raises nothing.

    Returns
    -------
    Flight
        Its quantities have the shape to which the inputs broadcast.
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
    """Give flights that have no launch the reason of the impact; return all problems, and those of flights alone."""
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
        Since launch [s], shape (n,).
    position
        From the start, to the target, up, right [m], shape (n, 3).
    velocity
        [m/s], shape (n, 3).
    spin
        Angular velocity [rad/s], shape (n, 3).
    inputs
        Of the flight, by name [SI].
    launch
        The launch it began with; None for one that was given by its values.
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
        """Return where and when it lands, and every point as a row."""
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
    """Compute the path of one ball, at times at most 0.02 s apart; the arguments are those of :func:`fly`."""
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    if shape or varied:
        raise InputError("launch", Wording(f"a batch of shape {shape}"), "a single shot: a trajectory is of one ball")
    try:
        arrays = core.trajectory(list(columns.values()))
    except ValueError as error:
        raise flight_error(error, columns) from None
    return Trajectory(arrays, columns, launch if isinstance(launch, Launch) else None)
