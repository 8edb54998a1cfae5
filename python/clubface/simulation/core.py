"""Impacts and flights of the compiled core; the only module of this package that imports it."""

from clubface._core import (
    BallHandle as BallHandle,
    ContactHandle as ContactHandle,
    LawHandle as LawHandle,
    curves as curves,
    flight_inputs as flight_inputs,
    flight_outputs as flight_outputs,
    fly as fly,
    fly_sensitivities as fly_sensitivities,
    fly_sensitivity as fly_sensitivity,
    history as history,
    impact as impact,
    inputs as inputs,
    outputs as outputs,
    pressure_at_altitude as pressure_at_altitude,
    sensitivities as sensitivities,
    shot_shape_names as shot_shape_names,
    shot_shapes as shot_shapes,
    trajectory as trajectory,
)
