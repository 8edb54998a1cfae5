"""Exact derivatives of a flight against differences."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, UnknownNameError
from clubface.simulation.flight import flight_columns
from clubface.simulation.results import flight_inputs
from clubface.simulation.sensitivity import differentiated, flight_derivatives

DRIVE = {"ball_speed": "160 mph", "launch": "12 deg", "azimuth": "2 deg", "backspin": "2600 rpm", "sidespin": "300 rpm"}
AIR = {"air": {"temperature": "15 degC", "altitude": "300 m"}, "wind": ("3 m/s", 0.0, "-2 m/s")}
STEPS = {"velocity_x": 1e-3, "velocity_y": 1e-3, "velocity_z": 1e-3, "spin_x": 1e-2, "spin_y": 1e-2, "spin_z": 1e-2,
         "ball_mass": 1e-6, "ball_radius": 1e-6, "temperature": 1e-2, "pressure": 1.0, "wind_x": 1e-3}  # fmt: skip
"""SI."""


@pytest.mark.parametrize("name", STEPS)
def test_the_derivatives_of_a_flight_are_those_of_central_differences(name):
    """The flight is integrated to 1e-9 or so, so that a difference over these steps is good to some 1e-5 of it."""
    columns = flight_columns(DRIVE, **AIR, ground=None).columns
    sides = []
    for side in (1.0, -1.0):
        moved = {**columns, name: columns[name] + side * STEPS[name]}
        sides.append(differentiated(moved).values)
    result = flight_derivatives(DRIVE, **AIR)
    for quantity in ("carry", "side", "apex", "landing_angle", "flight_time", "total", "total_side"):
        difference = (sides[0][quantity] - sides[1][quantity]) / (2.0 * STEPS[name])
        scale = abs(difference) + 1e-6 * abs(result.values[quantity]) / STEPS[name]
        assert result.by(quantity, name) == pytest.approx(difference, abs=1e-4 * scale), quantity


def test_its_values_are_those_of_the_flight_itself():
    launch = clubface.impact("driver", speed="105 mph", toe="9 mm")
    flown, result = clubface.fly(launch, **AIR), flight_derivatives(launch, **AIR)
    assert result.values == {name: float(getattr(flown, name)) for name in result.values}
    assert result.jacobian.shape == (len(result.values), len(flight_inputs()))


def test_it_is_of_one_launch_and_of_known_names():
    with pytest.raises(InputError, match="a single launch"):
        flight_derivatives(clubface.impact("driver", speed=[45.0, 50.0]))
    with pytest.raises(UnknownNameError, match="carry"):
        flight_derivatives(DRIVE).by("carrry", "spin_z")
    assert np.isfinite(flight_derivatives(DRIVE).jacobian).all()
