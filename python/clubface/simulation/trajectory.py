"""The path of one ball through the air."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from clubface.errors import InputError, Told
from clubface.simulation import core
from clubface.simulation.air import Air
from clubface.simulation.flight_inputs import AXES, flight_columns, flight_error
from clubface.simulation.launch import Launch
from clubface.simulation.results import attributes, flattened

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray


class Trajectory:
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

    _UNITS = (
        ("position", "m", "from the start"),
        ("velocity", "m/s", "velocity"),
        ("spin", "rad/s", "angular velocity"),
    )

    def __init__(self, arrays: Mapping[str, NDArray[Any]], provenance: dict[str, Any]) -> None:
        self.time = arrays["time"]
        self.position = arrays["position"]
        self.velocity = arrays["velocity"]
        self.spin = arrays["spin"]
        self.provenance = provenance

    def __len__(self) -> int:
        return len(self.time)

    def to_pandas(self) -> pandas.DataFrame:
        """Return one row a point, SI, with columns ``time``, ``position_x`` and so on."""
        import pandas

        columns: dict[str, Any] = {"time": self.time}
        named = {"time": "s"}
        for name, unit, _ in self._UNITS:
            for index, axis in enumerate(AXES):
                columns[f"{name}_{axis}"] = getattr(self, name)[:, index]
                named[f"{name}_{axis}"] = unit
        frame = pandas.DataFrame(columns)
        frame.attrs = {"units": named, "provenance": self.provenance}
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Return a dataset over ``time`` and ``axis`` (x to the target, y up, z right)."""
        import xarray

        variables = {
            name: (("time", "axis"), getattr(self, name), attributes(unit, meaning))
            for name, unit, meaning in self._UNITS
        }
        coordinates = {"time": ("time", self.time, attributes("s", "time since launch")), "axis": list(AXES)}
        return xarray.Dataset(variables, coordinates, attrs=flattened(self.provenance))

    def __repr__(self) -> str:
        carry = math.hypot(self.position[-1, 0], self.position[-1, 2])
        apex = self.position[:, 1].max()
        return f"trajectory of {len(self)} points: carry {carry:.5g} m, apex {apex:.4g} m, {self.time[-1]:.3g} s"


def trajectory(
    launch: Launch | Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: Mapping[str, Any] | None = None,
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
