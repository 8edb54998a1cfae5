"""The path of one ball through the air."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from numpy.typing import NDArray

from clubface.errors import InputError, Told
from clubface.simulation import core
from clubface.simulation.air import Air
from clubface.simulation.flight_inputs import flight_columns, flight_error
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import Quantity
from clubface.simulation.results import Series


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
    """

    quantities = {  # noqa: RUF012
        "time": Quantity("time", "s", "time since launch"),
        "position": Quantity("position", "m", "from the start"),
        "velocity": Quantity("velocity", "m/s", "velocity"),
        "spin": Quantity("spin", "rad/s", "angular velocity"),
    }

    def __init__(self, arrays: Mapping[str, NDArray[Any]], provenance: dict[str, Any]) -> None:
        self._arrays = arrays
        self.time, self.position, self.velocity, self.spin = (arrays[name] for name in self.quantities)
        self.provenance = provenance

    def __repr__(self) -> str:
        carry = math.hypot(self.position[-1, 0], self.position[-1, 2])
        apex = self.position[:, 1].max()
        return f"trajectory of {len(self)} points: carry {carry:.5g} m, apex {apex:.4g} m, {self.time[-1]:.3g} s"


def trajectory(
    launch: Launch | Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
) -> Trajectory:
    """Compute the path of one ball, at times at most 0.02 s apart; the arguments are those of :func:`fly`."""
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    if shape or varied:
        raise InputError("launch", Told(f"a batch of shape {shape}"), "a single shot: a trajectory is of one ball")
    try:
        arrays = core.trajectory(list(columns.values()))
    except ValueError as error:
        raise flight_error(error, columns) from None
    began = {"impact": launch.provenance} if isinstance(launch, Launch) else {}
    return Trajectory(arrays, {**began, "inputs": {"values": columns}})
