"""Expected strokes against the printed tables."""

import numpy as np
import pytest

from clubface import units
from clubface.design.strokes import GREEN, Hole, expected
from clubface.errors import InputError, UnknownNameError

YARD = units.parse("1 yd", "length")


def test_strokes_are_those_printed_at_printed_distances():
    assert expected("tee", np.array([400.0, 420.0]) * YARD) == pytest.approx([3.99, 4.02], rel=1e-12)
    assert expected("rough", np.array([100.0]) * YARD) == pytest.approx([3.02], rel=1e-12)
    assert expected(GREEN, np.array([units.parse("8 ft", "length")])) == pytest.approx([1.5], rel=1e-12)


def test_between_two_distances_they_lie_on_a_line_and_beyond_the_last_on_the_same():
    assert expected("fairway", np.array([110.0, 620.0, 1.0]) * YARD) == pytest.approx([2.825, 4.96, 2.18], rel=1e-12)


def test_lies_follow_from_where_balls_come_to_rest():
    hole = Hole(length="400 yd", fairway="30 yd", rough="20 yd", green="10 yd")
    ahead = np.array([250.0, 250.0, 250.0, 395.0, 250.0]) * YARD
    sideways = np.array([14.0, -16.0, 36.0, 5.0, -34.0]) * YARD
    assert hole.lies(ahead, sideways).tolist() == ["fairway", "rough", "recovery", "green", "rough"]
    left = float(np.hypot(150.0, 14.0))
    known = 2.91 + (left - 140.0) / 20.0 * (2.98 - 2.91)
    assert hole.after(ahead, sideways)[0] == pytest.approx(known, rel=1e-12)


def test_a_shot_of_the_tour_gains_about_nothing():
    """The tour's golfer on a hole of 430 yards: his own average, to the tenth of a stroke that fairway and rough, which
    are assumed, leave open."""
    from clubface.design.dispersion import dispersion

    result = dispersion("tour-driver", count=2**11, hole=Hole(length="430 yd"))
    assert result.gained == pytest.approx(0.0, abs=0.1)
    assert dispersion("bogey-driver", count=2**11, hole=Hole(length="430 yd")).gained < -0.3


def test_an_invalid_hole_is_refused():
    with pytest.raises(InputError, match="length"):
        Hole(length="-3 yd")
    with pytest.raises(InputError, match="at most 2000 m and above 0 m"):
        Hole(length="0 yd")
    assert Hole(length="400 yd", rough="0 yd").rough == 0.0
    with pytest.raises(UnknownNameError, match="fairway"):
        Hole(length="400 yd", lie="fairwy")


@pytest.mark.parametrize("places", [([3.0], [4.0, 5.0]), ("x", "y"), ([1.0, 2.0], 0.0)])
def test_places_that_no_ball_has_are_refused(places):
    with pytest.raises(InputError):
        Hole(length="400 yd").after(*places)
    with pytest.raises(InputError, match="distance"):
        expected("tee", "far")  # pyright: ignore[reportArgumentType]
