"""Exact derivatives of a flight by the launch it begins with, the ball, the air and the ground."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from numpy.typing import NDArray

from clubface.errors import InputError, Told
from clubface.simulation import core
from clubface.simulation.air import Air
from clubface.simulation.flight_inputs import flight_columns, flight_error
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import flight_inputs, flight_outputs
from clubface.support.checks import check_choice


class FlightDerivatives(NamedTuple):
    """One flight and its derivatives.

    Attributes
    ----------
    values
        Quantities of the flight by name [SI].
    jacobian
        Derivatives [SI], shape (quantities of a flight, inputs of a flight).
    """

    values: dict[str, float]
    jacobian: NDArray[Any]

    def by(self, quantity: str, name: str) -> float:
        """Return the derivative of one quantity by one input [SI]."""
        rows, columns = list(flight_outputs()), list(flight_inputs())
        check_choice("quantity", quantity, rows)
        check_choice("input of a flight", name, columns)
        return float(self.jacobian[rows.index(quantity), columns.index(name)])


def flight_derivatives(
    launch: Launch | Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
) -> FlightDerivatives:
    """Differentiate one flight; the arguments are those of :func:`fly`, of a single launch."""
    columns, shape, varied = flight_columns(launch, air, wind, ground)
    if shape or varied:
        raise InputError("launch", Told(f"a batch of shape {shape}"), "a single launch")
    return differentiated(columns)


def differentiated(columns: Mapping[str, float]) -> FlightDerivatives:
    """Differentiate the flight of which ``columns`` are the inputs [SI], in the order of the core."""
    try:
        values, jacobian = core.fly_sensitivity(list(columns.values()))
    except ValueError as error:
        raise flight_error(error, columns) from None
    return FlightDerivatives(dict(zip(flight_outputs(), values.tolist(), strict=True)), jacobian)
