"""Impacts, flights and poses for array libraries: the part that JAX and PyTorch have in common."""

from __future__ import annotations

import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Generic, Literal, TypeVar

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball, ball as ball_named
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, Wording
from clubface.simulation.differentiable import Differentiable, FlightFunction, LaunchFunction
from clubface.simulation.flight import AXES, BALL, AirLike, GroundLike, WindLike, conditions, parse_input
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import (
    OF_CLUB,
    Delivery,
    DeliveryLike,
    HandLike,
    as_values,
    equipment,
    head_of,
    point_of,
)
from clubface.simulation.launch import MONITOR, components, vectors
from clubface.simulation.pose import Head, Pose, delivery_of_pose, pose_of_delivery, repeated
from clubface.simulation.results import flight_inputs, outputs as launch_outputs
from clubface.simulation.spin import SPINS
from clubface.support.checks import check_names

Array = TypeVar("Array")


class ArrayFunctions(ABC, Generic[Array]):
    """The functions of a module such as :mod:`clubface.jax`; a subclass adds what is specific to its library."""

    xp: Any  # namespace of the library: ``sin``, ``stack`` and the other functions that all array libraries have

    def impact(
        self,
        club: str | os.PathLike[str] | Club,
        delivery: DeliveryLike | None = None,
        *,
        model: str = DEFAULT_MODEL,
        parameters: Parameters | None = None,
        ball: str | os.PathLike[str] | Ball | None = None,
        accuracy: float | None = None,
        hand: HandLike | None = None,
        outputs: Iterable[str] | None = None,
        threads: int | None = None,
        on_error: Literal["raise", "nan"] = "raise",
        **values: Any,
    ) -> dict[str, Array]:
        """Compute the launch of a ball hit by a club, as :func:`clubface.impact` does.

        Parameters
        ----------
        club, delivery, model, parameters, ball, accuracy, hand, threads, **values
            As for :func:`clubface.impact`. Values and parameters may be arrays of the library [SI], which broadcast;
            the launch is differentiable with respect to them.
        outputs
            Names of launch quantities. Default: all that the model computes.
        on_error
            "raise" raises an error for a shot that cannot be computed, "nan" returns NaN for it.

        Returns
        -------
        dict
            The quantities by name [SI].

        Raises
        ------
        ShotError
            A shot cannot be computed and ``on_error`` is "raise". A function compiled by JAX raises an error of JAX
            that quotes the reason.
        InputError
            A name or value is not allowed, or the second derivatives requested do not exist.
        """
        function, arrays = self._launch_function(
            club, delivery, values, parameters, model=model, ball=ball, accuracy=accuracy, hand=hand, outputs=outputs,
            threads=threads, on_error=on_error,
        )  # fmt: skip
        return self._call(function, arrays)

    def fly(
        self,
        launch: Mapping[str, Any],
        *,
        air: AirLike | None = None,
        wind: WindLike | None = None,
        ground: GroundLike | None = None,
        ball: str | os.PathLike[str] | Ball | None = None,
        outputs: Iterable[str] | None = None,
        threads: int | None = None,
        on_error: Literal["raise", "nan"] = "raise",
    ) -> dict[str, Array]:
        """Compute the flight of a launched ball, as :func:`clubface.fly` does.

        Parameters
        ----------
        launch
            The result of ``impact`` of the same module with all outputs, or values as for :func:`clubface.fly`:
            velocity and spin as vectors, or ``ball_speed``, ``launch``, ``azimuth`` with backspin and sidespin or total
            spin and spin axis.
        air, wind, ground, threads
            As for :func:`clubface.fly`. ``temperature``, ``pressure``, ``humidity``, the wind and the values of the
            ground may be arrays of the library [SI].
        ball
            As for :func:`clubface.ball`. Required if the ball of the impact was not the default one.
        outputs
            Names of flight quantities. Default: all. For second derivatives leave out ``total``, ``total_side`` and
            ``outside_fit``, which jump with the number of bounces.
        on_error
            As for ``impact``.

        Returns
        -------
        dict
            The quantities by name [SI].

        Raises
        ------
        ShotError, InputError
            As for ``impact``.
        """
        function, arrays = self._flight_function(
            launch, air, wind, ground, ball, outputs=outputs, threads=threads, on_error=on_error
        )
        return self._call(function, arrays)

    def delivery_from_pose(
        self,
        rotation: Any,
        position: Any,
        velocity: Any,
        angular_velocity: Any,
        *,
        club: str | os.PathLike[str] | Club,
        ball: str | os.PathLike[str] | Ball | None = None,
        ball_position: Any = (0.0, 0.0, 0.0),
        point: Any = "cg",
        hand: HandLike | None = None,
    ) -> dict[str, Array]:
        """Compute a delivery from the pose and motion of the head, as :meth:`clubface.Delivery.from_pose` does.

        Parameters, shapes and units are those of that method; all but ``club``, ``ball`` and ``hand`` may be arrays of
        the library. The ball does not spin. Poses are not checked: the values are meaningless unless the head touches
        the ball within about a millisecond.

        Returns
        -------
        dict
            The values by name [SI], as ``impact`` takes them.
        """
        given = Pose(rotation, position, velocity, angular_velocity)
        head, offset = self._geometry(club, ball, point, hand)
        touch = delivery_of_pose(
            self.xp, Pose(*map(self._as_array, given)), self._as_array(ball_position), head, offset, self._repeated
        )
        dtype = self._common_dtype([*given, ball_position, point])
        return {name: self._cast(each, dtype) for name, each in touch.values.items()}

    def pose(
        self,
        delivery: Delivery | Mapping[str, Any],
        club: str | os.PathLike[str] | Club,
        *,
        ball: str | os.PathLike[str] | Ball | None = None,
        ball_position: Any = (0.0, 0.0, 0.0),
        point: Any = "cg",
        hand: HandLike | None = None,
    ) -> Pose:
        """Compute the pose and motion of the head at first touch, as :meth:`clubface.Delivery.pose` does.

        Parameters are those of that method; all but ``club``, ``ball`` and ``hand`` may be arrays of the library.
        """
        head, offset = self._geometry(club, ball, point, hand)
        given = as_values(delivery, {})
        check_names("delivery value", given, Delivery.__dataclass_fields__)
        values = {name: given.get(name, head.static_loft if name == "loft" else 0.0) for name in OF_CLUB}
        arrays = {name: self._as_array(value) for name, value in values.items()}
        pose = pose_of_delivery(self.xp, arrays, self._as_array(ball_position), head, offset)
        dtype = self._common_dtype([*given.values(), ball_position, point])
        return Pose(*(self._cast(each, dtype) for each in pose))

    @abstractmethod
    def _is_array(self, value: Any) -> bool:
        """Return whether a value is an array of the library."""

    @abstractmethod
    def _as_array(self, value: Any) -> Array:
        """Convert a value to an array of the library, numbers in double precision where the library allows it."""

    @abstractmethod
    def _cast(self, array: Array, dtype: Any) -> Array:
        """Convert an array to another precision."""

    @abstractmethod
    def _precision(self, arrays: Sequence[Array]) -> Any:
        """Return the dtype to which the floating-point arrays promote; the default dtype if there are none."""

    @abstractmethod
    def _evaluate(self, function: Differentiable, x: Array) -> Sequence[Array]:
        """Evaluate a function of the last axis of ``x``; return each output, differentiable by the library."""

    def _repeated(self, step: Callable[[Any], Any], count: int) -> Any:
        """Apply a step ``count`` times, starting from 0; overridden for a library that compiles loops."""
        return repeated(step, count)

    def _common_dtype(self, values: Iterable[Any]) -> Any:
        """Return the dtype of results computed from these values."""
        return self._precision([each for each in values if self._is_array(each)])

    def _call(self, function: Differentiable, arrays: Sequence[Any]) -> dict[str, Array]:
        dtype = self._precision(arrays)
        shape = np.broadcast_shapes(function.shape, *(each.shape for each in arrays))
        columns = [self.xp.broadcast_to(self._cast(each, dtype), shape) for each in arrays]
        x = self.xp.stack(columns, -1) if columns else self.xp.zeros((*shape, 0), dtype=dtype)
        return dict(zip(function.outputs, self._evaluate(function, x), strict=True))

    def _geometry(self, club: Any, ball: Any, point: Any, hand: Any) -> tuple[Head, Any]:
        head = head_of(equipment(club, ball), hand)
        offset = self._as_array(point_of(head, point) if isinstance(point, str) else point)
        x, y, z = map(self._as_array, head.cg_to_face)
        return Head((x, y, z), *map(self._as_array, head[1:])), offset

    def _select_arrays(self, values: Mapping[str, Any]) -> dict[str, Any]:
        return {name: value for name, value in values.items() if self._is_array(value)}

    def _launch_function(
        self,
        club: str | os.PathLike[str] | Club,
        delivery: DeliveryLike | None,
        values: Mapping[str, Any],
        parameters: Any,
        **options: Any,
    ) -> tuple[LaunchFunction, list[Any]]:
        """Return the launch as a function of the inputs and parameters that are arrays, and those arrays."""
        given = {name: value for name, value in as_values(delivery, values).items() if value is not None}
        if "loft" not in given and self._is_array(given.get("static_loft")):
            given["loft"] = given["static_loft"]
        arrays = self._select_arrays(given)
        if isinstance(parameters, Mapping):
            of_model = self._select_arrays(parameters)
            parameters = {name: value for name, value in parameters.items() if name not in of_model} or None
            arrays |= of_model
        rest = {name: value for name, value in given.items() if name not in arrays}
        function = LaunchFunction(club, rest, arrays, parameters=parameters, **options)
        return function, list(arrays.values())

    def _flight_function(
        self,
        launch: Mapping[str, Any],
        air: AirLike | None,
        wind: Any,
        ground: str | Mapping[str, Any] | None,
        ball: str | os.PathLike[str] | Ball | None,
        **options: Any,
    ) -> tuple[FlightFunction, list[Any]]:
        """Return the flight as a function of the inputs that are arrays of the library, and those arrays."""
        if not isinstance(launch, Mapping):
            raise InputError("launch", launch, "a mapping of values, such as the result of impact of this module")
        given = {name: value for name, value in launch.items() if value is not None}
        if "velocity_x" in given:  # launch of an impact: its vectors are complete
            given = {
                name: value for name, value in given.items() if name in flight_inputs() or name not in launch_outputs()
            }
        elif self._select_arrays(given):
            given = self._vectors(given)
        if wind is not None and not isinstance(wind, Mapping) and len(wind) == len(AXES):
            wind = {f"wind_{axis}": wind[place] for place, axis in enumerate(AXES)}
        groups = {"wind": wind, "air": air, "ground": ground}
        surroundings: dict[str, Any] = {}
        for group, values in groups.items():
            if isinstance(values, Mapping):
                arrays = self._select_arrays(values)
                check_names(f"array of the {group}", arrays, flight_inputs())
                surroundings |= arrays
                groups[group] = {name: value for name, value in values.items() if name not in arrays}
        arrays = self._select_arrays(given) | surroundings
        rest = {name: 0.0 if name in arrays else value for name, value in given.items()}
        inputs_of_flight = {name: each.default for name, each in flight_inputs().items()} | ball_named(ball).inputs()
        inputs_of_flight |= vectors(rest) | conditions(groups["air"], groups["wind"], groups["ground"])
        columns = {name: parse_input(value, name) for name, value in inputs_of_flight.items()}
        return FlightFunction(columns, arrays, **options), list(arrays.values())

    def _vectors(self, terms: Mapping[str, Any]) -> dict[str, Any]:
        """Convert launch monitor values to velocity and spin vectors, as :func:`vectors` does for numbers."""
        xp = self.xp
        check_names("launch value", terms, (*MONITOR, *BALL))
        spins = [name for name in SPINS if name in terms]
        if spins and not set(spins) <= {"backspin", "sidespin"} and spins != ["total_spin", "spin_axis"]:
            raise InputError("spin", Wording(", ".join(spins)), "backspin and sidespin, or total_spin and spin_axis")
        given = {name: value for name, value in terms.items() if name in BALL}
        parsed = {
            name: xp.asarray(units.parse_values(value, launch_outputs()[name].dimension, name=name))
            if isinstance(value, str | float | int)
            else value
            for name, value in terms.items()
            if name not in given
        }
        for name in ("ball_speed", "launch"):
            if name not in parsed:
                raise InputError(name, None, "give it: a flight cannot start without it")
        zero = xp.zeros_like(xp.asarray(parsed["ball_speed"]))
        speed, launch, azimuth = parsed["ball_speed"], parsed["launch"], parsed.get("azimuth", zero)
        if "total_spin" in parsed:
            axis = parsed["spin_axis"]
            parsed |= {"backspin": parsed["total_spin"] * xp.cos(axis), "sidespin": parsed["total_spin"] * xp.sin(axis)}
        backspin, sidespin = parsed.get("backspin", zero), parsed.get("sidespin", zero)
        return given | components(xp, speed, launch, azimuth, backspin, sidespin)
