"""Exact derivatives: of a launch, as a table with units, and of a flight by launch, ball, air and ground."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from clubface import _core as core, units
from clubface.equipment.attachment import ADDED_NAMES
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, OWN, differentiable_model, model as model_named
from clubface.errors import InputError, UnitError, Wording
from clubface.quantities import display_unit
from clubface.results.notes import Note, note
from clubface.results.result import Presentable, Result
from clubface.results.table import Table, text
from clubface.simulation.flight import AirLike, GroundLike, WindLike, flight_columns, flight_error
from clubface.simulation.impact import REDUCED, Parameters, Request, impact
from clubface.simulation.inputs import (
    DeliveryLike,
    HandLike,
    as_values,
    check_on_error,
    equipment,
    prepare,
    thread_count,
    tolerance,
)
from clubface.simulation.launch import Launch, assumptions_of
from clubface.simulation.provenance import provenance_of
from clubface.simulation.results import (
    Variable,
    dimension_names,
    flattened,
    flight_inputs,
    flight_outputs,
    inputs,
    outputs as launch_outputs,
)
from clubface.support.arrays import Floats, NumberOrArray, ValueLike
from clubface.support.checks import check_choice, check_names

if TYPE_CHECKING:
    import pandas
    import xarray


_SPEED = "mph"
"""Unit of speeds in a table of derivatives, the one golfers use."""

MAIN = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "spin_axis")
"""The outputs shown when a table is printed."""
FEW = 20
"""Maximum number of model parameters in a printed table; of a model with more, only ``OF_THE_BALL`` is shown, since the
others are coefficients of a fit."""
OF_THE_BALL = ("friction",)
LEAST = 5e-5
"""Derivatives below this, in the units shown, are printed as zero; files keep all digits."""


_SURPRISES = {
    "friction-lowers-spin": ("friction", 0.1, "backspin", "backspin"),
    "high-strike-lowers-spin": ("high", 1e-3, "backspin", "backspin"),
    "toe-strike-curves-back": ("toe", 1e-3, "sidespin", "sidespin"),
    "attack-at-held-loft": ("attack", math.radians(1.0), "backspin", "backspin"),
    "static-loft-at-held-loft": ("static_loft", math.radians(1.0), "launch", "launch"),
}
"""Notes on derivatives that are negative though often expected to be positive: variable, its step [SI], output, and the
name of the output's change in the data of the note."""


class Sensitivity(Presentable):
    """Derivatives of launch quantities with respect to inputs and parameters, exact to rounding.

    Attributes
    ----------
    outputs, variables
        Names of the rows, launch quantities, and of the columns, inputs and parameters of the model.
    si
        The derivatives in SI and radians, shape (outputs, variables, ...) with the shape of the launch last.
    launch
        The launch of one shot or many that is differentiated.
    """

    def __init__(
        self,
        si: Floats,
        rows: Mapping[str, Variable],
        columns: Mapping[str, Variable],
        shown: Mapping[str, str],
        launch: Launch,
    ) -> None:
        self.si = si
        self.outputs = tuple(rows)
        self.variables = tuple(columns)
        self.launch = launch
        self._rows = dict(rows)
        self._columns = dict(columns)
        self._shown = dict(shown)

    @property
    def units(self) -> dict[str, str]:
        """The unit in which each output and variable is shown."""
        return dict(self._shown)

    @property
    def values(self) -> Floats:
        """The derivatives in the units shown, of the shape of ``si``."""
        rows, columns = (
            np.array([units.size(self._shown[name]) for name in names]) for names in (self.outputs, self.variables)
        )
        ones = (1,) * len(self.launch.shape)
        return self.si * columns.reshape(-1, *ones) / rows.reshape(-1, 1, *ones)

    def jvp(self, changes: Mapping[str, ValueLike]) -> dict[str, NumberOrArray]:
        """Return the first-order change of every output for changes of variables [SI]: J times a vector.

        Each of the ``changes``, by name of the variable, is text with a unit, an SI number, or an array over the shots.
        Variables left out do not change.
        """
        check_names("variable", changes, self._columns)
        total: Any = 0.0
        for name, change in changes.items():
            value = units.parse_values(change, self._columns[name].dimension, name=name)
            total = total + self.si[:, self.variables.index(name)] * value
        return self._by_name(self.outputs, total)

    def vjp(self, weights: Mapping[str, ValueLike]) -> dict[str, NumberOrArray]:
        """Return the derivatives of a weighted sum of outputs by every variable [SI]: a vector times J.

        Each of the ``weights``, by name of the output and per SI unit of it, is a number, or an array over the shots.
        Outputs left out have weight 0.
        """
        check_names("output", weights, self._rows)
        total: Any = 0.0
        for name, weight in weights.items():
            value = units.parse_values(weight, units.DIMENSIONLESS, name=name)
            total = total + self.si[self.outputs.index(name)] * value
        return self._by_name(self.variables, total)

    def _by_name(self, names: Sequence[str], total: ValueLike) -> dict[str, NumberOrArray]:
        total = np.broadcast_to(total, (len(names), *self.launch.shape))
        return {name: value if self.launch.shape else float(value) for name, value in zip(names, total, strict=True)}

    @property
    def main_variables(self) -> tuple[str, ...]:
        """The variables of a printed table: all but the coefficients of a model that is a fit."""
        parameters = [name for name in self.variables if name not in inputs()]
        hidden = {name for name in parameters if len(parameters) > FEW and name not in OF_THE_BALL}
        return tuple(name for name in self.variables if name not in hidden)

    @property
    def provenance(self) -> dict[str, Any]:
        """The model, its parameters, club, ball, delivery and version."""
        return self.launch.provenance

    def unit(self, output: str, variable: str) -> str:
        """Return the unit in which a derivative is shown, such as "rpm per mm"."""
        self._place(output, variable)
        return f"{self._shown[output]} per {self._shown[variable]}"

    def value(self, output: str, variable: str, unit: str | None = None) -> NumberOrArray:
        """Return one derivative, an array for many shots, in SI or in a ``unit`` such as "rpm per mm"."""
        derivative = self.si[self._place(output, variable)]
        derivative = derivative if self.launch.shape else float(derivative)
        if unit is None:
            return derivative
        upper, separator, lower = unit.partition(" per ")
        if not separator:
            raise UnitError("unit", unit, 'of the form "rpm per mm"')
        over, under = _check_unit(self._rows[output], upper), _check_unit(self._columns[variable], lower)
        return derivative * units.size(under) / units.size(over)

    def to_result(self, *, every_variable: bool = False) -> Result:
        """Return the derivatives as a result; ``every_variable`` also prints those by the coefficients of a fit."""
        shots = list(np.ndindex(self.launch.shape))
        pairs = [(output, variable) for variable in self.variables for output in self.outputs] * len(shots)
        of_shot = [shot for shot in shots for _ in range(len(self.variables) * len(self.outputs))]
        values = self.values
        shown = [float(values[(*self._place(*pair), *shot)]) for pair, shot in zip(pairs, of_shot, strict=True)]
        printed = self.variables if every_variable else self.main_variables
        table = Table(
            "derivatives",
            (
                *(
                    text(name, [shot[place] for shot in of_shot])
                    for place, name in enumerate(dimension_names(self.launch.shape, {}))
                ),
                text("output", [output for output, _ in pairs], printed=False),
                text("variable", [variable for _, variable in pairs], printed=False),
                text("per", [f"{each}, per {self._shown[each]}" for _, each in pairs], in_files=False),
                text("of", [f"{each} {self._shown[each]}".removesuffix(" 1") for each, _ in pairs], in_files=False),
                text("value", shown, digits=[4 if abs(each) < LEAST else -4 for each in shown]),
                text("unit", [self.unit(*pair) for pair in pairs], printed=False),
            ),
            title=f"{self.launch.club.name}, {self.launch.model}: change of the launch",
            layout="rows" if self.launch.shape else "pivot",
            shown_rows=[place for place, (_, variable) in enumerate(pairs) if variable in printed],
        )  # fmt: skip
        notes = [
            note("caveat-of-model", model=self.launch.model, caveat=each) for each in self.launch.parameters.caveats
        ]
        if any(name.startswith(("cg_", "dcg_")) for name in printed):
            notes.append(note("held-as-delivered"))
        notes += self._sign_notes(printed)
        if hidden := len(self.variables) - len(printed):
            notes.append(note("coefficients-hidden", hidden=hidden, model=self.launch.model))
        return Result(
            "sensitivity", table.title, (table,), notes=tuple(notes), assumptions=assumptions_of([self.launch]),
            provenance=provenance_of([self.launch]),
        )  # fmt: skip

    def _sign_notes(self, printed: Sequence[str]) -> list[Note]:
        """Return notes that explain unexpected signs, for several shots only signs that all of them share."""
        notes = []
        for code, (variable, step, output, data) in _SURPRISES.items():
            if variable in printed and output in self.outputs:
                hand = self.launch.input("hand") if output == "sidespin" else 1.0
                slope = self.value(output, variable)
                if np.all(hand * slope < -LEAST * units.size(self._shown[output]) / units.size(self._shown[variable])):
                    notes.append(note(code, **{data: abs(float(np.mean(slope))) * step}))
        return notes

    def to_pandas(self) -> pandas.DataFrame:
        """Return one row per variable and one column per output, in the units given in the labels.

        The unit of an entry is column per row: rpm per mm in the column ``backspin [rpm]`` and row ``toe [mm]``. For
        many shots there is one row per derivative, in SI, indexed by output, variable and shot.
        """
        import pandas

        if self.launch.shape:
            return self.to_xarray().to_dataframe()
        index = pandas.Index([self._label(name) for name in self.variables], name="variable")
        frame = pandas.DataFrame(self.values.T, index, [self._label(name) for name in self.outputs])
        frame.attrs = {"units": self.units, "provenance": self.provenance}
        return frame

    def to_xarray(self) -> xarray.DataArray:
        """Return an array over ``output``, ``variable`` and the dimensions of the shots, SI, units as coordinates."""
        import xarray

        coordinates: dict[Any, Any] = {
            "output": list(self.outputs),
            "variable": list(self.variables),
            "output_unit": ("output", [self._rows[name].unit for name in self.outputs]),
            "variable_unit": ("variable", [self._columns[name].unit for name in self.variables]),
        }
        if self.launch.shape:
            coordinates |= dict(self.launch.to_xarray().coords)
        dims = ("output", "variable", *dimension_names(self.launch.shape, self.launch.varied))
        return xarray.DataArray(self.si, coordinates, dims, "derivative", flattened(self.provenance))

    def __repr__(self) -> str:
        if self.launch.shape:
            return (
                f"derivatives of launches of shape {self.launch.shape} by {self.launch.model}: {self.launch.club.name},"
                f" ball {self.launch.ball.name}; outputs {', '.join(self.outputs)}; variables"
                f" {', '.join(self.main_variables)}"
            )
        shown = [name for name in MAIN if name in self.outputs] or list(self.outputs)[:6]
        place = [self.outputs.index(name) for name in shown]
        heads = [f"{name} [{self._shown[name]}]" for name in shown]
        widths = [max(len(head), 12) for head in heads]
        variables = self.main_variables
        labels = [f"per {self._shown[name]} of {name}".replace("per 1 of", "of") for name in variables]
        width = max(map(len, labels), default=0)
        lines = [
            *(each.sentence for each in assumptions_of([self.launch])),
            f"derivatives of a launch by {self.launch.model}: {self.launch.club.name}, ball {self.launch.ball.name}",
            " " * width + "".join(f"  {head:>{size}}" for head, size in zip(heads, widths, strict=True)),
        ]
        columns = [self.values.T[self.variables.index(name)] for name in variables]
        for label, column in zip(labels, columns, strict=True):
            numbers = [f"  {column[row]:>{size}.5g}" for row, size in zip(place, widths, strict=True)]
            lines.append(f"{label:<{width}}" + "".join(numbers))
        if len(shown) < len(self.outputs):
            others = [name for name in self.outputs if name not in shown]
            lines.append(f"and of {', '.join(others)}: see to_pandas()")
        if len(variables) < len(self.variables):
            lines.append(f"and by {len(self.variables) - len(variables)} coefficients of the model: see to_pandas()")
        return "\n".join(lines)

    def _label(self, name: str) -> str:
        return f"{name} [{self._shown[name]}]"

    def _place(self, output: str, variable: str) -> tuple[int, int]:
        check_choice("output", output, self.outputs)
        check_choice("variable", variable, self.variables)
        return self.outputs.index(output), self.variables.index(variable)


def sensitivity(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    outputs: Iterable[str] | None = None,
    variables: Iterable[str] | None = None,
    units: Mapping[str, str] | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: ValueLike | None,
) -> Sensitivity:
    """Compute the derivatives of a launch by every input and parameter, by automatic differentiation.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, hand, threads, progress, on_error, **values
        As for :func:`impact`; arrays give the derivatives of many shots at once.
    outputs
        Names of launch quantities. Default: all that the model computes.
    variables
        Names of inputs and parameters. Default: all differentiable ones, without ``added_...`` for a free head.
    units
        Units in which outputs and variables are shown, by name. Default: practical units ("rpm per mm").

    Returns
    -------
    Sensitivity
        A table with labels and units; for many shots an array, shape (outputs, variables, ...).
    """
    check_on_error(on_error)
    accuracy, cores = tolerance(accuracy), thread_count(threads)
    differentiable_model(model)
    values = dict(as_values(delivery, values))
    known_columns = known_variables(model)
    if variables is None:
        is_free = equipment(club, ball).club.added_inertia is None and values.keys().isdisjoint(ADDED_NAMES)
        variables = [name for name in known_columns if not (is_free and name in ADDED_NAMES)]
    across = _select("variable", variables, {name: each for name, (_, each) in known_columns.items()})
    places = [known_columns[name][0] for name in across]
    size = len(launch_outputs()) * (1 + len(across))
    prepared = prepare(model, club, values, ball, parameters, hand, outputs=size)
    shape = prepared.shots.shape
    launch = impact(
        club, values, model=model, parameters=parameters, ball=ball, accuracy=accuracy, hand=hand, threads=threads,
        on_error=on_error if shape else "raise",
    )  # fmt: skip
    # Outputs that the model does not compute are NaN.
    known_rows = {name: (row, each) for row, (name, each) in enumerate(launch_outputs().items())
                  if np.isfinite(getattr(launch, name)).any()}  # fmt: skip
    rows = _select("output", outputs, known_rows)
    batch = Request(
        None, prepared.shots.club, model, prepared.shots.columns, prepared.parameters, math.prod(shape), accuracy,
        cores, progress, on_error,
    )  # fmt: skip
    backend = OWN[model].BACKEND if model in OWN else REDUCED
    computed, _ = backend.sensitivities(batch, [known_rows[name][0] for name in rows], places)
    si = computed.reshape(len(rows), 1 + len(across), *shape)[:, 1:]
    row_quantities = {name: known_rows[name][1] for name in rows}
    column_quantities = {name: known_columns[name][1] for name in across}
    quantities, given = row_quantities | column_quantities, units or {}
    check_names("output or variable", given, quantities)
    shown = {name: _check_unit(each, given[name]) if name in given
             else _SPEED if each.dimension == "speed" else display_unit(name, each.unit)
             for name, each in quantities.items()}  # fmt: skip
    return Sensitivity(si, row_quantities, column_quantities, shown, launch)


def known_variables(model: str) -> dict[str, tuple[int, Variable]]:
    """Return column and quantity of every variable: differentiable inputs, then parameters of the model."""
    known = {name: (column, each) for column, (name, each) in enumerate(inputs().items()) if each.differentiable}
    for column, each in enumerate(model_named(model).parameters, len(inputs())):
        known[each.name] = (column, Variable(each.name, each.unit, each.meaning, "parameter", True))
    return known


def _select(what: str, names: Iterable[str] | None, known: Mapping[str, Any]) -> Sequence[str]:
    if names is None:
        return list(known)
    try:
        names = [names] if isinstance(names, str) else list(names)
    except TypeError:
        raise InputError(f"{what}s", names, "a list of names") from None
    check_names(what, names, known)
    if len(set(names)) < len(names):
        raise InputError(f"{what}s", names, "a list of names without repeats")
    return names


def _check_unit(quantity: Variable, symbol: str) -> str:
    """Return the unit ``symbol``, or raise UnitError if it does not fit ``quantity``."""
    return units.unit(symbol, name=quantity.name, dimension=quantity.dimension).symbol


class FlightDerivatives(NamedTuple):
    """A flight and its derivatives.

    Attributes
    ----------
    values
        Flight quantities by name [SI].
    jacobian
        Derivatives [SI], shape (flight quantities, flight inputs).
    """

    values: dict[str, float]
    jacobian: Floats

    def by(self, quantity: str, name: str) -> float:
        """Return the derivative of a quantity by an input [SI]."""
        rows, columns = list(flight_outputs()), list(flight_inputs())
        check_choice("quantity", quantity, rows)
        check_choice("input of a flight", name, columns)
        return float(self.jacobian[rows.index(quantity), columns.index(name)])


def flight_derivatives(
    launch: Launch | Mapping[str, ValueLike],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
) -> FlightDerivatives:
    """Compute one flight and its derivatives; arguments as for :func:`fly`, for a single launch."""
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    if shape or varied:
        raise InputError("launch", Wording(f"a batch of shape {shape}"), "a single launch")
    return differentiated(columns)


def differentiated(columns: Mapping[str, float]) -> FlightDerivatives:
    """Differentiate the flight with the inputs ``columns`` [SI], in the order of the core."""
    try:
        values, jacobian = core.fly_sensitivity(list(columns.values()))
    except ValueError as error:
        raise flight_error(error, columns) from None
    return FlightDerivatives(dict(zip(flight_outputs(), values.tolist(), strict=True)), jacobian)
