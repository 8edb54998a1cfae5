"""What the core is told of a club's face beside the parameters of a model: what they include must not count twice."""

import pytest

import clubface
from clubface import ParameterSet
from clubface.equipment.models import models
from clubface.simulation.inputs import equipped
from clubface.simulation.quantities import input_columns

PLACE = input_columns()["characteristic_time"]
OWN = 250e-6
"""Of the built-in driver [s]."""


def told(model, **given):
    """Return the characteristic time that the core is given."""
    return clubface.impact("driver", speed=50.0, model=model, **given).input("characteristic_time")


@pytest.mark.parametrize("model", models())
def test_a_published_set_has_the_face_in_it_and_the_defaults_of_a_model_have_not(model):
    assert clubface.club("driver").characteristic_time == OWN
    if model != "response":  # It has no published set: its values belong to the ball.
        assert told(model, parameters=ParameterSet.builtin(model, "driver")) == 0.0
    assert told(model, parameters=ParameterSet.defaults(model)) == OWN


def test_values_of_a_ball_go_with_the_face_of_the_club():
    ball = clubface.ball("modern").__class__(
        name="mine", mass=0.0459, radius=0.02135, inertia=8.3e-6, parameters={"slip": {"cor": 0.78}}
    )
    assert told("slip", ball=ball) == OWN
    assert told("slip") == 0.0
    assert told("standard", ball=ball) == 0.0


def test_finite_elements_strike_with_the_face_of_the_club():
    assert told("fem") == told("fem", parameters={"friction": 0.3}) == OWN


def test_a_time_given_with_the_shot_is_taken_as_it_is():
    launch = clubface.impact("driver", speed=50.0, characteristic_time="240 us")
    assert launch.input("characteristic_time") == 240e-6
    assert launch.provenance["changed"]["values"] == {"characteristic_time": 240e-6}


def test_every_way_to_a_model_keeps_the_rule_and_tells_of_it():
    shot = {"speed": 50.0, "loft": 0.2}
    for found in (
        clubface.impact("driver", shot, model="volumetric"),
        clubface.history("driver", shot, model="volumetric").launch,
        clubface.sensitivity("driver", shot, model="volumetric").launch,
    ):
        assert found.input("characteristic_time") == 0.0
        assert found.provenance["parameters"]["includes_face"] is True
        assert found.provenance["changed"]["values"] == {}


def test_only_the_face_is_left_out():
    with_, _ = equipped("standard", "driver", None, None)
    without, _ = equipped("standard", clubface.club("driver").replace(characteristic_time=0.0), None, None)
    assert with_.columns == without.columns
    free, _ = equipped("standard", "driver", None, ParameterSet.defaults("standard"))
    pairs = zip(with_.columns, free.columns, strict=True)
    assert [place for place, (one, other) in enumerate(pairs) if one != other] == [PLACE]
