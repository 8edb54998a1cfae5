"""The curve of a flight, and what golfers call a shot that starts and curves so."""

import math

import numpy as np
import pytest

import clubface
from clubface.simulation.shot_shape import BIG_CURVE, STRAIGHT_CURVE, STRAIGHT_START, curve, shot_shape

DEG = math.pi / 180.0
DRIVE = {"speed": "105 mph", "attack": "2 deg", "loft": "13 deg"}
LAUNCHES = {
    "driver": {"ball_speed": "150 mph", "launch": "12 deg", "total_spin": "2600 rpm"},
    "7-iron": {"ball_speed": "118 mph", "launch": "17 deg", "total_spin": "6500 rpm"},
    "wedge": {"ball_speed": "95 mph", "launch": "25 deg", "total_spin": "9500 rpm"},
}


def test_the_curve_is_the_distance_from_the_start_line_to_the_landing():
    """A ball that lands 40 m right after 300 m to the target, and started along the 3-4-5 triangle's 36.87 degrees."""
    landing = np.array([300.0, 40.0])
    along = np.array([4.0, 3.0]) / 5.0
    across = float(along[0] * landing[1] - along[1] * landing[0])
    assert curve(math.atan2(3.0, 4.0), math.hypot(*landing), landing[1]) == pytest.approx(across, rel=1e-12)
    assert across < 0.0  # it landed left of its start line


def test_the_curve_is_that_of_the_computed_path():
    launch = clubface.impact("driver", DRIVE, face="1 deg", path="-3 deg", toe="-6 mm")
    x, _, z = clubface.trajectory(launch).position[-1]
    flight = clubface.fly(launch)
    start = np.array([launch.velocity_x, launch.velocity_z]) / math.hypot(launch.velocity_x, launch.velocity_z)
    # The path ends at the height of the start to the step of its own integration.
    assert flight.curve == pytest.approx(start[0] * z - start[1] * x, abs=1e-3)
    assert flight.start == pytest.approx(launch.azimuth, rel=1e-12)


def test_a_shot_that_is_turned_as_a_whole_curves_as_much():
    turned = np.array([-8.0, 0.0, 5.0]) * DEG
    flights = clubface.fly(clubface.impact("driver", DRIVE, face=turned + 2.0 * DEG, path=turned - 1.0 * DEG))
    # The flights are integrated with steps of their own, to 1e-9 of some 200 m.
    np.testing.assert_allclose(flights.curve, flights.curve[1], rtol=0.0, atol=1e-5)
    assert np.ptp(flights.side) > 30.0


def test_the_curve_of_a_mirrored_shot_is_the_opposite_and_has_the_same_name():
    right = clubface.fly(clubface.impact("driver", DRIVE, face="3 deg", path="-3 deg", toe="5 mm"))
    left = clubface.fly(clubface.impact("driver", DRIVE, face="-3 deg", path="3 deg", toe="5 mm", hand="left"))
    assert left.curve == pytest.approx(-right.curve, rel=1e-6)
    assert left.shot_shape() == right.shot_shape() == "push slice"
    assert left.shot_shape("right") == "pull hook"


@pytest.mark.parametrize("club", LAUNCHES)
def test_the_limits_of_the_curve_are_the_limits_of_the_spin_axis(club):
    """Open Golf Coach: a draw or fade from 3 degrees of spin axis on, a hook or slice from 12 on.

    A degree of axis makes from 0.6 to 1.0% of curve over the carry, so that a limit is met within a third.
    """
    axis = np.array([3.0, 12.0]) * DEG
    flight = clubface.fly({**LAUNCHES[club], "spin_axis": axis})
    np.testing.assert_allclose(flight.curve / flight.carry, [STRAIGHT_CURVE, BIG_CURVE], rtol=0.35)
    assert clubface.fly({**LAUNCHES[club], "spin_axis": 2.0 * DEG}).shot_shape() == "straight shot"
    assert clubface.fly({**LAUNCHES[club], "spin_axis": -8.0 * DEG}).shot_shape() == "draw"
    assert clubface.fly({**LAUNCHES[club], "spin_axis": -15.0 * DEG, "azimuth": "-4 deg"}).shot_shape() == "pull hook"


def test_the_nine_flights_and_their_big_curves_have_their_names():
    starts = np.array([-1.1, 0.0, 1.1])[:, None] * STRAIGHT_START
    curves = np.array([-1.1 * BIG_CURVE, -1.1 * STRAIGHT_CURVE, 0.0, 1.1 * STRAIGHT_CURVE, 1.1 * BIG_CURVE]) * 200.0
    named = [
        ["pull hook", "pull draw", "pull", "pull fade", "pull slice"],
        ["hook", "draw", "straight shot", "fade", "slice"],
        ["push hook", "push draw", "push", "push fade", "push slice"],
    ]
    assert shot_shape(starts, curves, 200.0).tolist() == named
    mirrored = shot_shape(starts, curves, 200.0, hand=-1.0)
    assert mirrored.tolist() == [row[::-1] for row in named[::-1]]


def test_a_ball_that_does_not_fly_has_no_name():
    flight = clubface.fly({"ball_speed": "90 mph", "launch": "-2 deg", "total_spin": "500 rpm", "spin_axis": "0 deg"})
    assert flight.carry == 0.0
    assert flight.shot_shape() == ""
    assert shot_shape(np.array([0.0, np.nan]), 1.0, np.array([0.0, 100.0])).tolist() == ["", ""]


def test_the_start_line_of_a_slice_lies_within_the_picture():
    from clubface.simulation.shot_result import flight_views

    launch = clubface.impact("driver", speed="90 mph", loft="14 deg", path="-8 deg", face="-4 deg", toe="-10 mm")
    _, above = flight_views({"slice": clubface.trajectory(launch).position})[0]
    line = next(each for each in above.marks if each.label == "start line")
    low, high = above.y.limits
    assert low < min(line.y)
    assert max(line.y) < high
    assert max(line.x) < above.x.limits[1]
