"""What the core is told of a club's face beside the parameters of a model: what they include must not count twice."""

import dataclasses
import warnings

import numpy as np
import pytest

import clubface
from clubface import ParameterSet
from clubface.equipment.models import models
from clubface.equipment.parameters import builtin_sets
from clubface.errors import RuleWarning
from clubface.simulation.inputs import equipped
from clubface.simulation.results import input_columns

PLACES = [input_columns()[name] for name in ("characteristic_time", "included_time")]
OWN, IRON = 250e-6, 85e-6
"""Of the built-in driver and 7-iron [s]."""
FAMILIES = {"driver": OWN, "7-iron": IRON}
RULES = (239e-6, 257e-6)
"""The limit of the Equipment Rules, without and with its tolerance [s]."""


def face_times(model, club="driver", **given):
    """Return the characteristic times that the core is given: the club's, and that which the parameters include."""
    launch = clubface.impact(club, speed=50.0, model=model, **given)
    return launch.input("characteristic_time"), launch.input("included_time")


def of_time(time, club="driver"):
    """Return a built-in club with another characteristic time."""
    return clubface.club(club).replace(characteristic_time=time)


def drive(model, time, **given):
    return clubface.impact(of_time(time), speed="100 mph", loft="12 deg", model=model, **given)


@pytest.mark.parametrize("model", models())
def test_a_published_set_and_the_defaults_of_a_model_say_which_face_they_include(model):
    assert clubface.club("driver").characteristic_time == OWN
    included = OWN if model != "response" else 0.0  # Its values belong to the ball.
    for parameters in (None, ParameterSet.defaults(model)):
        assert face_times(model, parameters=parameters) == (OWN, included)
        assert face_times(model, of_time(RULES[0]), parameters=parameters) == (RULES[0], included)


@pytest.mark.parametrize("name", models())
def test_the_published_sets_include_the_faces_of_the_clubs_they_were_found_for(name):
    for each in builtin_sets(name):
        if each.name.startswith("three-dimensional") or each.default:
            assert each.characteristic_time == clubface.club(each.club).characteristic_time == FAMILIES[each.club]
        assert each.characteristic_time is None or each.includes_face


@pytest.mark.parametrize("name", models())
def test_the_included_face_changes_nothing(name):
    if name == "response":
        pytest.skip("it includes none")
    for club in FAMILIES:
        shot = {"speed": 40.0, "toe": "8 mm", "model": name}
        one = clubface.impact(club, **shot)
        # With no characteristic time at all the core has a rigid face.
        other = clubface.impact(club, **shot, characteristic_time=0.0, included_time=0.0)
        for quantity in ("ball_speed", "launch", "total_spin"):
            assert getattr(one, quantity) == getattr(other, quantity)


@pytest.mark.parametrize("name", models())
def test_a_face_that_gives_more_makes_every_model_faster(name):
    times = (200e-6, *RULES, 300e-6)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuleWarning)
        speeds = [drive(name, time).ball_speed for time in times]
    assert speeds == sorted(speeds)
    assert len(set(speeds)) == len(speeds)
    # 0.006 of restitution is about 0.2 m/s of 64; the volumetric set is too stiff, and has twice as much.
    gain = speeds[2] - speeds[1]
    assert 0.1 < gain < (0.6 if name == "volumetric" else 0.3)


@pytest.mark.parametrize("name", models())
def test_the_derivative_by_the_characteristic_time_is_the_slope(name):
    step = 0.2e-6
    for time in (OWN, 230e-6):  # With the included face and with another.
        shot = {"speed": 45.0, "loft": 0.2, "model": name, "accuracy": 1e-10}
        exact = clubface.sensitivity(of_time(time), **shot).value("ball_speed", "characteristic_time")
        low, high = (clubface.impact(of_time(time + d), **shot).ball_speed for d in (-step, step))
        # The differences of the rings are over rings a little larger.
        assert exact == pytest.approx((high - low) / (2.0 * step), rel=5e-3 if name == "rings" else 2e-3)
        assert exact > 0.0


def test_a_club_without_a_characteristic_time_has_the_included_face():
    assert face_times("slip", of_time(0.0)) == (OWN, OWN)
    assert face_times("slip", of_time(0.0, "7-iron")) == (IRON, IRON)
    assert face_times("response", of_time(0.0)) == (0.0, 0.0)


def test_a_set_that_says_nothing_of_the_face_includes_the_face_of_any_club():
    mine = dataclasses.replace(ParameterSet.builtin("slip", "driver"), characteristic_time=None)
    for time in (0.0, 240e-6):
        assert face_times("slip", of_time(time), parameters=mine) == (time, time)


def test_restitution_given_by_the_ball_combines_with_the_face_of_the_club():
    def ball(**values):
        size = {"mass": 0.0459, "radius": 0.02135, "inertia": 8.3e-6}
        return clubface.Ball(name="mine", **size, parameters={"slip": values})

    assert face_times("slip", ball=ball(cor=0.78)) == (OWN, 0.0)
    assert face_times("slip", ball=ball(slip_y=0.05)) == (OWN, OWN)
    assert face_times("standard", ball=ball(cor=0.78)) == (OWN, OWN)


def test_restitution_of_ball_and_face_is_that_of_finite_elements():
    """The driver and `modern` at 160 ft/s, square, from the rigid 0.777: 0.823 and 0.829, met to 0.004."""
    alone = dataclasses.replace(ParameterSet.builtin("standard", "driver").replace(cor=0.777), includes_face=False)
    for time, wanted in zip(RULES, (0.823, 0.829), strict=True):
        speed = 160.0 * 0.3048
        club = of_time(time)
        result = clubface.impact(club, speed=speed, loft=0.0, model="standard", parameters=alone, ball="modern")
        turn = np.array([[np.cos(club.loft), np.sin(club.loft)], [-np.sin(club.loft), np.cos(club.loft)]])
        x, y = turn @ club.cg[:2]
        point = result.club_velocity_x + result.club_spin_y * club.cg_z - result.club_spin_z * y
        assert (result.velocity_x - point) / speed == pytest.approx(wanted, abs=0.004), x


def test_finite_elements_strike_with_the_face_of_the_club():
    assert face_times("fem") == face_times("fem", parameters={"friction": 0.3}) == (OWN, 0.0)


def test_a_time_given_with_the_shot_is_taken_as_it_is():
    launch = clubface.impact("driver", speed=50.0, characteristic_time="240 us")
    assert launch.input("characteristic_time") == 240e-6
    assert launch.provenance["changed"]["values"] == {"characteristic_time": 240e-6}


def test_every_function_applies_the_included_face_and_records_it():
    shot = {"speed": 50.0, "loft": 0.2}
    for result in (
        clubface.impact("driver", shot, model="volumetric"),
        clubface.history("driver", shot, model="volumetric").launch,
        clubface.sensitivity("driver", shot, model="volumetric").launch,
    ):
        assert result.input("characteristic_time") == result.input("included_time") == OWN
        recorded = result.provenance["parameters"]
        assert (recorded["includes_face"], recorded["characteristic_time"]) == (True, OWN)
        assert result.provenance["changed"]["values"] == {}


def test_parameters_change_nothing_of_the_club_but_its_face():
    with_, _ = equipped("standard", "driver", None, None)
    iron, _ = equipped("standard", "driver", None, ParameterSet.builtin("standard", "7-iron"))
    pairs = zip(with_.columns, iron.columns, strict=True)
    assert [place for place, (one, other) in enumerate(pairs) if one != other] == PLACES[1:]


def test_a_history_has_the_motion_of_the_face_and_its_energy():
    ball = dataclasses.replace(ParameterSet.builtin("volumetric", "driver"), includes_face=False)
    contact = clubface.history("driver", speed=45.0, model="volumetric", parameters=ball)
    assert 0.5e-3 < contact.face_depth.max() < 2e-3  # 14 kN on 7.3e-8 m/N, less what a free head does not bear.
    kept = contact.kinetic_energy + contact.face_energy + contact.layer_energy
    whole = kept + contact.normal_work + contact.friction_work + contact.layer_work
    assert np.allclose(whole, whole[0], rtol=1e-4)
    assert contact.face_energy.max() > 2.0
    still = clubface.history("driver", speed=45.0, model="volumetric")
    assert not still.face_depth.any()
    assert not still.face_energy.any()
