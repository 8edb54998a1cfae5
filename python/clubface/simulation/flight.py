"""Where the ball goes after launch: flight through moist air and wind, bounces and roll."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, Literal, overload

from numpy.typing import NDArray

from clubface.simulation import core
from clubface.simulation.air import Air
from clubface.simulation.flight_inputs import flight_columns, flight_error
from clubface.simulation.launch import Comparison, Launch
from clubface.simulation.quantities import Quantity, flight_inputs, flight_outputs
from clubface.simulation.results import Result, Varied, first_error, index_of
from clubface.simulation.run_options import check_on_error, thread_count
from clubface.support.version import __version__


class Flight(Result):
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
    launch
        The launch it began with, or None where it was given as numbers.
    shape
        The shape the inputs broadcast to; () for a single flight.
    problems
        The flights without a result (their values are NaN) and why.
    """

    _kind = "flight"

    carry: Any
    side: Any
    apex: Any
    landing_angle: Any
    flight_time: Any
    landing_speed: Any
    landing_spin: Any
    total: Any
    total_side: Any
    outside_fit: Any

    def __init__(
        self,
        values: NDArray[Any],
        columns: Mapping[str, Any],
        shape: tuple[int, ...],
        varied: Mapping[str, NDArray[Any]],
        launch: Launch | None,
        problems: list[tuple[int, str, str]],
    ) -> None:
        self._values = values
        self._columns = columns
        self._varied = varied
        self._found = problems
        self.shape = shape
        self.launch = launch

    @classmethod
    def quantities(cls) -> Mapping[str, Quantity]:
        """Return the quantities by name, with unit and meaning."""
        return flight_outputs()

    def _headline(self) -> str:
        return f"flight after launch by {self.launch.model}" if self.launch is not None else "flight"

    @property
    def varied(self) -> Mapping[str, Varied]:
        """The inputs that were given as arrays, by name; those of the impact where there was one."""
        found = dict(self.launch.varied) if self.launch is not None else {}
        for name, values in self._varied.items():
            each = flight_inputs()[name]
            found[name] = Varied(values, each.unit, each.meaning)
        return found

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
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> dict[str, Flight]: ...
@overload
def fly(
    launch: Launch | Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> Flight: ...
def fly(
    launch: Launch | Comparison | Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
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
        mapping of ``wind_x``, ``wind_y``, ``wind_z``, or of ``wind_speed`` and ``wind_direction`` [rad], whereto a
        level wind blows: 0 to the target, 90 degrees to the right, 180 degrees against the ball. No wind if left out.
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
