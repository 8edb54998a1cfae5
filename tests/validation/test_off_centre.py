"""What parts models and published strikes off the centre: each cause does what mechanics says it does."""

import math

import numpy as np
import pytest

import clubface
from clubface.validation import off_centre, strikes
from clubface.validation.check import ModelUnderTest

DEG = math.pi / 180
BY_NAME = {each.name: each for each in off_centre.CHANGES}


def fastest(change):
    judged = off_centre.Changed(BY_NAME[change], "standard")
    (best,) = [each.computed for each in strikes.best_strike(judged) if each.quantity == "fastest strike, toe"]
    return best


def test_a_closing_face_is_fastest_towards_the_toe_by_its_rate_over_the_bend_of_the_ball_speed():
    still, closes = fastest("as judged"), fastest("closing, path of the CG 0")
    places = np.array([-0.01, 0.0, 0.01])
    speeds = ModelUnderTest("standard").at_launch("driver", 12 * DEG, speed=strikes.TOE_SPEED, toe=places).ball_speed
    bend = -np.polyfit(places, speeds, 2)[0] / speeds[1]
    # Speed of the place struck grows with rate times distance; gear effect and the turned loft change it a little.
    assert closes - still == pytest.approx(off_centre.CLOSURE / strikes.TOE_SPEED / (2.0 * bend), rel=0.2)


def test_the_path_of_the_face_is_that_of_the_cg_less_what_closure_turns_the_face_by():
    """TrackMan: the path of the face centre of a driver is some 3 degrees further outside-in than that of the CG."""
    head = clubface.club("driver")
    path = off_centre.closing_on_path(head, strikes.TOE_SPEED)["path"]
    assert 2.0 * DEG < path < 3.5 * DEG
    shot = {"speed": strikes.TOE_SPEED, "loft": 15 * DEG, "model": "standard"}
    left, straight = (clubface.impact("driver", closure=off_centre.CLOSURE, path=each, **shot) for each in (0.0, path))
    still = clubface.impact("driver", **shot)
    # With the path of the mass centre at 0 the ball starts left and fades; with that of the face it flies as if still.
    assert left.azimuth < -0.2 * DEG
    assert left.spin_axis > still.spin_axis + 2 * DEG
    assert straight.azimuth == pytest.approx(still.azimuth, abs=0.2 * DEG)
    assert straight.spin_axis == pytest.approx(still.spin_axis, abs=1.0 * DEG)


def test_a_deeper_mass_centre_is_deeper_along_the_normal_alone():
    head = clubface.club("driver")
    deeper = off_centre.deeper(head)
    assert deeper.cg_depth - head.cg_depth == pytest.approx(0.01)
    along = [-math.sin(head.loft), math.cos(head.loft)]
    assert np.dot([deeper.cg_x - head.cg_x, deeper.cg_y - head.cg_y], along) == pytest.approx(0.0, abs=1e-12)


def test_less_inertia_and_a_deeper_mass_centre_give_more_gear_effect_and_closure_gives_none():
    rows = off_centre.causes(["standard"]).records()
    (axis,) = [row for row in rows if row["figure"].startswith("driver, 13 mm towards the heel")]
    assert axis["less_inertia"] > 1.1 * axis["as_judged"]
    assert axis["cg_10_mm_deeper"] > 1.1 * axis["as_judged"]
    assert axis["closing_path_of_the_cg_0"] == pytest.approx(axis["as_judged"], rel=0.1)


def test_a_loft_that_increases_makes_the_low_part_of_the_face_the_faster_one():
    still, rises = (
        next(
            each.computed
            for each in strikes.best_strike(off_centre.Changed(BY_NAME[name], "standard"))
            if each.quantity == "fastest strike, high"
        )
        for name in ("as judged", "loft increasing")
    )
    assert -4e-3 < rises - still < -1e-3


def test_the_command_shows_what_every_cause_changes(clubface_):
    options = ("validate", "--check", "toe-hits", "--model", "standard", "--causes")
    first, *_ = clubface_(*options, "--json").json["tables"]["off_centre"]["rows"]
    assert first["figure"] == "driver, 19.1 mm towards the toe: ball speed, share"
    # A toe that closes is faster than the mass centre, so that it loses less.
    assert first["closing_path_of_the_cg_0"] > first["as_judged"]
