"""The launch of the ball: the result of an impact; conversion of launch monitor values to vectors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import MODULES, model
from clubface.equipment.parameters import ParameterSet
from clubface.errors import AssumptionWarning, InputError
from clubface.results.notes import Note, note
from clubface.results.result import Presentable, Result
from clubface.simulation.inputs import Shots, common_shape
from clubface.simulation.results import Batch, Variable, Varied, flight_inputs, input_columns, inputs, outputs
from clubface.simulation.spin import SPINS, parts
from clubface.support.arrays import Floats, NumberOrArray
from clubface.support.checks import Frozen, check_names, warn_once
from clubface.support.processes import check_request
from clubface.support.version import __version__

if TYPE_CHECKING:
    import pandas
    import xarray


class Launch(Batch):
    """The launch of the ball in SI and radians; every quantity is an attribute of the shape of the batch.

    Attributes
    ----------
    ball_speed
        Ball speed [m/s].
    smash
        Ball speed over clubhead speed.
    launch
        Launch angle above horizontal [rad].
    azimuth
        Launch direction [rad], right of the target is positive.
    backspin
        Angular velocity about the horizontal axis to the right of the launch direction [rad/s]; positive lifts the
        ball.
    sidespin
        Minus the vertical angular velocity [rad/s]; positive curves the ball to the right.
    total_spin
        Magnitude of the angular velocity [rad/s].
    spin_axis
        Tilt of the spin axis, atan2(sidespin, backspin) [rad].
    velocity_x, velocity_y, velocity_z
        Ball velocity to the target, up and right [m/s].
    spin_x, spin_y, spin_z
        Angular velocity of the ball about these axes [rad/s].
    club_velocity_x, club_velocity_y, club_velocity_z
        Clubhead velocity after impact [m/s].
    club_spin_x, club_spin_y, club_spin_z
        Clubhead angular velocity after impact [rad/s].
    contact_time, peak_force
        Contact time [s] and peak normal force [N]; NaN for a model without a time scale.
    model, parameters
        Name of the model, and the parameters used.
    club, ball
        The club and the ball.
    shape
        Shape to which the inputs broadcast; () for a single shot.
    loft_assumed
        Whether the static loft of the club was used because no dynamic loft was given.
    """

    _kind = "launch"

    ball_speed: NumberOrArray
    smash: NumberOrArray
    launch: NumberOrArray
    azimuth: NumberOrArray
    backspin: NumberOrArray
    sidespin: NumberOrArray
    total_spin: NumberOrArray
    spin_axis: NumberOrArray
    velocity_x: NumberOrArray
    velocity_y: NumberOrArray
    velocity_z: NumberOrArray
    spin_x: NumberOrArray
    spin_y: NumberOrArray
    spin_z: NumberOrArray
    club_velocity_x: NumberOrArray
    club_velocity_y: NumberOrArray
    club_velocity_z: NumberOrArray
    club_spin_x: NumberOrArray
    club_spin_y: NumberOrArray
    club_spin_z: NumberOrArray
    contact_time: NumberOrArray
    peak_force: NumberOrArray

    def __init__(
        self,
        values: Floats,
        shots: Shots,
        model: str,
        parameters: ParameterSet,
        accuracy: float | None = None,
        problems: list[tuple[int, str, str]] | None = None,
    ) -> None:
        self._values = values
        self._shots = shots
        self.club, self.ball, self.shape, self.loft_assumed = shots.club, shots.ball, shots.shape, shots.loft_assumed
        self.model = model
        self.parameters = parameters
        self.accuracy = accuracy
        self._failures = problems or ()

    @classmethod
    def quantities(cls) -> Mapping[str, Variable]:
        """Return the quantities of a launch by name, with unit and meaning."""
        return outputs()

    def _headline(self) -> str:
        return f"launch by {self.model} ({self.parameters.name}): {self.club.name}, ball {self.ball.name}"

    def _assumptions(self) -> tuple[Note, ...]:
        return assumptions_of([self])

    @property
    def varied(self) -> Mapping[str, Varied]:
        """The inputs and parameters given as arrays, by name."""
        result = {}
        for name, values in self._shots.varied.items():
            each = inputs()[name] if name in inputs() else model(self.model).parameter(name)
            result[name] = Varied(values, each.unit, each.meaning)
        return result

    @property
    def delivery(self) -> dict[str, NumberOrArray]:
        """The values of the delivery by name [SI]; arrays are flat."""
        return {name: self.input(name) for name, each in inputs().items() if each.group == "delivery"}

    def input(self, name: str) -> NumberOrArray:
        """Return the value of an input of delivery, club or ball [SI]; arrays are flat."""
        return self._shots.columns[input_columns()[name]]

    @property
    def provenance(self) -> dict[str, Any]:
        """The model, its parameters with source and caveats, club, ball, delivery and version."""
        inputs = {**self.parameters.with_included_face(self.club.inputs()), **self.ball.inputs()}
        varied = self._shots.varied
        changed = {
            name: self.input(name)
            for name, value in inputs.items()
            if self.input(name) is not value and (name in varied or self.input(name) != value)
        }
        delivered = {name: _number(name, value, varied) for name, value in self.delivery.items()}
        return {
            **computed_with(self.model, self.parameters, self.club, self.ball, self.accuracy, varied),
            "changed": {"values": {name: _number(name, value, varied) for name, value in changed.items()}},
            "delivery": {"values": delivered},
        }


def assumptions_of(launches: Iterable[Launch]) -> tuple[Note, ...]:
    """Return the notes on assumptions, which are shown before the numbers.

    They cover the static loft of the club where no dynamic loft was given, and the caveats of a variant of a published
    set, such as the values as printed.
    """
    lofts: dict[str, None] = {}
    sets: dict[Note, None] = {}
    for each in launches:
        sets.update(dict.fromkeys(variant_caveats(each.parameters)))
        if each.loft_assumed:
            values = np.ravel(each.input("loft"))
            low, high = float(values.min(initial=np.inf)), float(values.max(initial=-np.inf))
            loft = units.show(low, "deg", 4) if low >= high else units.show_range(low, high, "deg")
            lofts[f"{each.club.name} {loft}"] = None
    return (*((note("static-loft", clubs=list(lofts)),) if lofts else ()), *sets)


def variant_caveats(parameters: ParameterSet) -> tuple[Note, ...]:
    """Return one note with the caveats of a variant of a published set; empty for other sets."""
    if "/" not in parameters.name or not parameters.caveats:
        return ()
    return (note("variant-caveats", model=parameters.model, set=parameters.name, caveats=list(parameters.caveats)),)


def rigid_faces(launches: Mapping[str, Launch]) -> tuple[Note, ...]:
    """Return the note that names launches with a rigid face, if other launches have a flexible face."""
    # A face is flexible by its characteristic time, or that of the parameters, or as a mesh.
    rigid = [name for name, each in launches.items() if not np.any(each.input("characteristic_time"))
             and not (each.model in MODULES and hasattr(each.club, "head"))]  # fmt: skip
    return (note("rigid-faces", names=rigid),) if 0 < len(rigid) < len(launches) else ()


def computed_with(
    of_model: str,
    parameters: ParameterSet,
    club: Club,
    ball: Ball,
    accuracy: float | None,
    varied: Mapping[str, Any] = Frozen({}),
) -> dict[str, Any]:
    """Return the provenance shared by launches: model, parameters with source and caveats, club, ball, version."""
    declared = model(of_model)
    return {
        "model": {"name": declared.name, "reference": declared.reference},
        "parameters": {
            "name": parameters.name,
            "source": parameters.source,
            "reference": parameters.reference,
            "caveats": [*parameters.caveats, *(f"{key}: {text}" for key, text in parameters.value_caveats.items())],
            "values": {name: _number(name, value, varied) for name, value in parameters.values.items()},
            "includes_face": parameters.includes_face,
            "characteristic_time": parameters.characteristic_time,
        },
        "club": {"name": club.name, "description": club.description},
        "ball": {"name": ball.name, "description": ball.description},
        "accuracy": accuracy or "fast",
        "clubface_version": __version__,
    }


class Comparison(dict[str, Launch], Presentable):
    """Launches of the same shots by model name."""

    def to_pandas(self) -> pandas.DataFrame:
        """Return the rows of all launches, SI, with the model in the first column; ``attrs`` as for a launch."""
        import pandas

        frames = {name: each.to_pandas() for name, each in self.items()}
        table = pandas.concat([frame.assign(model=name) for name, frame in frames.items()], ignore_index=True)
        table.insert(0, "model", table.pop("model"))
        table.attrs = {
            "units": {key: unit for frame in frames.values() for key, unit in frame.attrs["units"].items()},
            "provenance": {name: frame.attrs["provenance"] for name, frame in frames.items()},
        }
        return table

    def to_xarray(self) -> xarray.Dataset:
        """Return one dataset of all launches over ``model`` and the dimensions of the shots."""
        import xarray

        names = xarray.DataArray(list(self), dims="model", name="model")
        datasets = [each.to_xarray() for each in self.values()]
        return xarray.concat(datasets, names, combine_attrs="drop_conflicts")

    def to_result(self) -> Result:
        """Return a table with one row per shot and model."""
        from clubface.simulation.shot_result import comparison_result

        return comparison_result(self)

    def __repr__(self) -> str:
        return "\n".join(map(repr, self.values()))


def _number(name: str, value: Any, varied: Mapping[str, Any]) -> Any:
    """Return a number for provenance, or the shape and range of an array."""
    if name not in varied:
        return value
    values = varied[name]
    return f"array of shape {values.shape}" + (f" from {values.min():.6g} to {values.max():.6g}" if values.size else "")


MONITOR = ("ball_speed", "launch", "azimuth", *SPINS)
"""Quantities reported by a launch monitor, with the names and signs of a launch."""


def vectors(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the flight inputs of a launch given as vectors or as launch monitor values.

    Velocity is v (cos(launch) cos(azimuth), sin(launch), cos(launch) sin(azimuth)). Backspin turns about the
    horizontal axis to the right of the launch direction, (-sin(azimuth), 0, cos(azimuth)), sidespin about the
    vertical pointing down; a launch monitor sees no spin about the launch direction, so it is 0. Any two spins that
    determine the others suffice (:mod:`clubface.simulation.spin`); otherwise a warning states the assumption.
    """
    inputs = flight_inputs()
    known = [*MONITOR, *(name for name, each in inputs.items() if each.group in ("launch", "ball"))]
    check_names("launch value", values, known)
    given = {name: value for name, value in values.items() if name in inputs}
    terms = {
        name: units.parse_values(value, outputs()[name].dimension, name=name)
        for name, value in values.items()
        if name in MONITOR
    }
    mixed = [name for name in given if inputs[name].group == "launch"]
    if terms and mixed:
        raise InputError(mixed[0], values[mixed[0]], "leave it out, since the launch is given as " + ", ".join(terms))
    if not terms:
        for axis in "xyz":
            if f"velocity_{axis}" not in given:
                raise InputError(f"velocity_{axis}", None, "give it, or the launch as ball_speed, launch and so on")
            given.setdefault(f"spin_{axis}", 0.0)
        return given
    return {**given, **_from_terms(terms)}


def _from_terms(terms: dict[str, Any]) -> dict[str, Any]:
    shape = common_shape({name: value for name, value in terms.items() if not isinstance(value, float)})
    check_request(math.prod(shape), 8 * (len(MONITOR) + 6))
    for name in ("ball_speed", "launch"):
        if name not in terms:
            raise InputError(name, None, "give it: a flight cannot start without it")
    speed, launch, azimuth = terms["ball_speed"], terms["launch"], terms.get("azimuth", 0.0)
    backspin, sidespin, assumed = parts({name: terms[name] for name in SPINS if name in terms})
    if assumed:
        warn_once(assumed, AssumptionWarning)
    result = components(np, speed, launch, azimuth, backspin, sidespin)
    return {name: value if getattr(value, "ndim", 0) else float(value) for name, value in result.items()}


def components(xp: Any, speed: Any, launch: Any, azimuth: Any, backspin: Any, sidespin: Any) -> dict[str, Any]:
    """Return velocity and spin of a launch as defined by :func:`vectors`, using the array library ``xp``."""
    level = speed * xp.cos(launch)
    return {
        "velocity_x": level * xp.cos(azimuth), "velocity_y": speed * xp.sin(launch),
        "velocity_z": level * xp.sin(azimuth), "spin_x": -backspin * xp.sin(azimuth), "spin_y": -sidespin,
        "spin_z": backspin * xp.cos(azimuth),
    }  # fmt: skip
