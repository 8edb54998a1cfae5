"""What the compiled core computes of impacts and flights; the one place where this room names it."""

from clubface._core import (
    flight_inputs as flight_inputs,
    flight_outputs as flight_outputs,
    fly as fly,
    fly_sensitivity as fly_sensitivity,
    history as history,
    impact as impact,
    inputs as inputs,
    outputs as outputs,
    pressure_at_altitude as pressure_at_altitude,
    sensitivities as sensitivities,
    sensitivity as sensitivity,
    trajectory as trajectory,
)
