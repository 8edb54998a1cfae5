"""How a ball leaves a plate by each model: closed forms, the limit of sliding, and the printed response functions."""

import math
import re

import pytest

import clubface
from clubface.equipment.listings import model_result
from clubface.equipment.models import models
from clubface.simulation.rebound import model_in_full, rebound

ANGLE = math.radians(30.0)


@pytest.mark.parametrize("mass", [5.0, 0.2])
def test_the_standard_model_rebounds_by_its_cor_and_rolls(mass):
    # Impulses at one point: restitution as given, no sliding left, and a lever of one radius, all to rounding.
    assert rebound("standard", speed=40.0, incidence=ANGLE, mass=mass) == pytest.approx((0.83, 0.0, 1.0), abs=1e-12)


def test_the_slip_model_gives_back_its_ratio():
    ratio = clubface.impact("7-iron", speed=40.0, model="slip").parameters.values["slip_y"]
    result = rebound("slip", speed=40.0, incidence=ANGLE, mass=0.2)
    assert result.tangential_restitution == pytest.approx(ratio, abs=1e-12)


def test_a_ball_that_slides_throughout_has_the_limit_of_friction():
    # J_t = mu J_n, from which the sliding that is left follows with the mobility along the face and the lever.
    speed, incidence, mass = 40.0, math.radians(75.0), 5.0
    result = rebound("response", speed=speed, incidence=incidence, mass=mass)
    ball = clubface.ball("modern")
    free = 1.0 / ball.mass + 1.0 / mass
    normal = speed * math.cos(incidence) * (1.0 + result.restitution) / free
    friction = clubface.impact("driver", speed=speed, loft="12 deg").parameters.values["friction"]
    turning = free + result.friction_lever * ball.radius**2 / ball.inertia
    kept = 1.0 - friction * normal * turning / (speed * math.sin(incidence))
    # Up to a per cent: the face normal of the contact is that of first touch here.
    assert result.tangential_restitution == pytest.approx(-kept, abs=0.01)


@pytest.mark.parametrize("speed", [20.0, 40.0, 60.0])
def test_the_printed_restitution_of_response_is_what_the_model_computes(speed):
    """The formula as text, with features worked out by hand for a plate struck along its normal."""
    table = next(each for each in model_result("response").tables if each.name == "functions")
    formula = dict(zip(table["function"].values, table["formula"].values, strict=True))["restitution"]
    ball, mass = clubface.ball("modern"), 5.0
    free = 1.0 / ball.mass + 1.0 / mass
    rolling = free + (0.95 * ball.radius) ** 2 / ball.inertia
    features = {
        "speed": speed / 40.0 - 0.75, "friction": 3.0 * (0.35 - 0.3), "slip": -0.5,
        "mobility": 5.0 * (1.0 / (free * ball.mass) - 0.8), "ratio": 5.0 * (rolling / (3.5 * free) - 0.85),
        "coupling": 0.0, "face": 0.0, "bend": 0.0, "offset": 0.0,
    }  # fmt: skip
    total = 0.0
    for sign, term in re.findall(r"(^-?|[+-] )?([\d.]+(?: [a-z]+[²³]?)*)", formula):
        number, *factors = term.split()
        value = float(number) * (-1.0 if "-" in sign else 1.0)
        for each in factors:
            value *= features[each.rstrip("²³")] ** {"²": 2, "³": 3}.get(each[-1], 1)
        total += value
    # Coefficients are printed with three digits: 26 terms, each off by 5e-4 of itself at most.
    assert rebound("response", speed=speed, incidence=0.0, mass=mass).restitution == pytest.approx(total, abs=1e-3)


@pytest.mark.parametrize("name", models())
def test_every_model_shows_what_a_ball_does_on_a_plate(name):
    result = model_in_full(name)
    over_speed, over_angle = (next(each for each in result.tables if each.name == key)
                              for key in ("restitution_over_speed", "rebound_over_angle"))  # fmt: skip
    assert all(0.4 < value < 1.0 for value in over_speed["restitution_plate"].values)
    assert all(-1.0 < value < 0.5 for value in over_angle["tangential_restitution_plate"].values)


def test_coefficients_are_shown_as_functions_and_listed_in_files():
    result = model_result("response")
    tables = {each.name: each for each in result.tables}
    assert len(tables["parameters"].shown_rows) < 25 < len(tables["parameters"]) - 100
    printed = len(tables["parameters"].shown_rows) + sum(tables["functions"]["terms"].values)
    assert printed == len(tables["parameters"])
    # Every feature of a term is explained.
    used = set(re.findall(r"[a-z]+", " ".join(tables["functions"]["formula"].values)))
    assert used == set(tables["features"]["feature"].values)
