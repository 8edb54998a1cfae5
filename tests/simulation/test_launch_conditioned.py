"""Shots at a measured launch: loft and face angle solved so that launch angle and start direction agree."""

import math

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, RangeWarning
from clubface.simulation.launch_conditioned import COARSE_RESOLUTION, solve_angles

DELIVERIES = {
    "driver": ({"speed": "50 m/s", "attack": "3 deg", "path": "-2 deg", "toe": "9 mm", "high": "5 mm"}, 12.0),
    "7-iron": ({"speed": "39 m/s", "attack": "-4 deg", "path": "5 deg", "toe": "-6 mm", "closure": "1500 deg/s"}, 24.0),
    "pitching-wedge": ({"speed": "30 m/s", "attack": "-5 deg", "path": "1 deg", "high": "-8 mm"}, 38.0),
}


@pytest.mark.parametrize("model", ["response", "standard", "slip", "volumetric"])
@pytest.mark.parametrize("club", DELIVERIES)
@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_the_launch_of_a_delivery_leads_back_to_its_loft_and_face_angle(club, model):
    delivery, loft = DELIVERIES[club]
    shot = clubface.impact(club, delivery, loft=f"{loft} deg", face="1.5 deg", model=model)
    back = clubface.impact_at_launch(club, delivery, launch=shot.launch, azimuth=shot.azimuth, model=model)
    # Contact models take one integration step more or less, which is some 1e-6 rad.
    assert math.degrees(back.loft) == pytest.approx(loft, abs=1e-3)
    assert math.degrees(back.face) == pytest.approx(1.5, abs=1e-3)
    assert back.launch.total_spin == pytest.approx(shot.total_spin, rel=1e-3)
    assert back.launch.launch == pytest.approx(shot.launch, abs=2e-5)


def test_without_a_start_direction_the_face_stays_as_delivered():
    delivery, _ = DELIVERIES["7-iron"]
    back = clubface.impact_at_launch("7-iron", delivery, face="-2 deg", launch="18 deg")
    assert math.degrees(back.face) == pytest.approx(-2.0)
    assert back.launch.get("launch", "deg") == pytest.approx(18.0, abs=1e-7)
    square = clubface.impact_at_launch("7-iron", delivery, launch="18 deg")
    assert square.face == 0.0


def test_the_lofts_given_count_for_nothing():
    delivery, _ = DELIVERIES["driver"]
    lofts = [
        clubface.impact_at_launch("driver", delivery, loft=f"{each} deg", launch="13 deg").loft for each in (5.0, 18.0)
    ]
    assert lofts[0] == lofts[1]


def test_a_shot_alone_equals_the_shot_in_a_batch():
    speeds, launches = [30.0, 44.0, 52.0], np.radians([[9.0], [16.0]])
    many = clubface.impact_at_launch("driver", speed=speeds, launch=launches, azimuth="1 deg", path="3 deg")
    assert many.loft.shape == many.launch.total_spin.shape == (2, 3)
    alone = clubface.impact_at_launch("driver", speed=44.0, launch=launches[1, 0], azimuth="1 deg", path="3 deg")
    assert isinstance(alone.loft, float)
    assert (alone.loft, alone.face) == (many.loft[1, 1], many.face[1, 1])
    assert alone.launch.total_spin == many.launch.total_spin[1, 1]


@pytest.mark.parametrize("launch", ["77 deg", "-30 deg"])
def test_a_launch_that_no_loft_gives_is_no_number_and_leaves_the_others_alone(launch):
    shots = clubface.impact_at_launch("driver", speed=50.0, launch=[launch, "12 deg"], model="standard")
    assert np.isnan([shots.loft[0], shots.face[0], shots.launch.ball_speed[0]]).all()
    assert shots.launch.get("launch", "deg")[1] == pytest.approx(12.0)


def test_a_launch_without_its_unit_is_refused():
    with pytest.raises(InputError, match="launch"):
        clubface.impact_at_launch("driver", speed=50.0, launch="12")


def test_a_speed_outside_the_range_is_warned_of_once_and_not_for_every_try(monkeypatch):
    monkeypatch.setattr("clubface.support.checks._given", {})
    with pytest.warns(RangeWarning) as caught:
        clubface.impact_at_launch("driver", speed=20.0, launch="12 deg", model="slip")
    assert len(caught) == 1


def test_a_model_that_takes_long_is_asked_a_few_times_only():
    asked = []

    def directions(angles, places):
        asked.append(places)
        return 0.7 * angles - 0.2 * angles**2

    wanted = math.radians(20.0)
    loft = solve_angles(directions, np.array([[wanted / 0.85]]), np.array([[wanted]]), COARSE_RESOLUTION)
    # 0.7 x - 0.2 x^2 = 20 degrees; the resolution over the slope there.
    assert loft.item() == pytest.approx((0.7 - math.sqrt(0.49 - 0.8 * wanted)) / 0.4, abs=4e-5)
    assert len(asked) <= 7


def test_a_shot_that_has_arrived_is_not_computed_again():
    asked = []

    def directions(angles, places):
        asked.append(places.tolist())
        return np.where(places == 0, 0.85 * angles, 0.7 * angles - 0.2 * angles**2)

    solve_angles(directions, np.full((1, 2), 0.4), np.full((1, 2), 0.34))
    assert asked[0] == [0, 1]
    assert asked[1:] == [[1]] * (len(asked) - 1)


def test_loft_and_face_that_act_on_each_other_are_learned_in_a_few_tries():
    asked = []
    acts = np.array([[0.8, 0.3], [-0.2, 0.7]])

    def directions(angles, places):
        asked.append(places)
        return acts @ angles

    wanted = np.array([[0.3], [0.1]])
    angles = solve_angles(directions, np.zeros((2, 1)) + 0.2, wanted)
    assert acts @ angles == pytest.approx(wanted, abs=1e-9)
    # Broyden's method solves linear equations of two unknowns in four steps (Gay 1979).
    assert len(asked) <= 6
