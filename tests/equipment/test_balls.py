"""Files of balls: their pieces, what they say to models, and reading back what was written."""

import math

import pytest

import clubface
from clubface.equipment.balls import Ball, ball_names
from clubface.equipment.parameters import ParameterSet
from clubface.errors import ClubfaceError, FileError

SHOT = {"speed": 50.0, "loft": "12 deg"}
SLIP = """\
name = "sticky"
mass = "45.6 g"
diameter = "42.7 mm"
inertia = "81 g cm2"

[parameters.slip]
slip_y = -0.2
"""
PIECES = """\
name = "two"
diameter = "42.7 mm"
mass = "45.6 g"

[[pieces]]
name = "core"
layers = 6

[[pieces]]
name = "cover"
layers = 3
thickness = "1.8 mm"
density = "950 kg/m3"
"""


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
@pytest.mark.parametrize("name", ball_names())
def test_a_ball_reads_back_as_written(name):
    made = Ball.builtin(name)
    assert Ball.from_text(made.to_toml()) == made
    assert Ball.from_text(Ball.from_text(SLIP).to_toml()) == Ball.from_text(SLIP)


def test_mass_and_inertia_are_those_of_spheres_one_around_the_other():
    radius, inner = 0.02135, 0.02135 - 1.8e-3
    cover = 950.0 * 4.0 / 3.0 * math.pi * (radius**3 - inner**3)
    inertia = 0.4 * (0.0456 - cover) * inner**2 + 0.4 * cover * (radius**5 - inner**5) / (radius**3 - inner**3)
    assert Ball.from_text(PIECES).inertia == pytest.approx(inertia, rel=1e-12)
    # One density throughout is a uniform sphere, whose mass follows.
    even = PIECES.replace('mass = "45.6 g"\n', "").replace("layers = 6", 'layers = 6\ndensity = "950 kg/m3"')
    mass = 950.0 * 4.0 / 3.0 * math.pi * radius**3
    assert Ball.from_text(even).mass == pytest.approx(mass, rel=1e-12)
    assert Ball.from_text(even).inertia == pytest.approx(0.4 * mass * radius**2, rel=1e-12)
    assert Ball.from_text('inertia = "84 g cm2"\n' + PIECES).inertia == pytest.approx(84e-7, rel=1e-12)


def test_the_values_of_a_ball_apply_unless_others_are_given():
    sticky = Ball.from_text(SLIP)
    own = clubface.impact("driver", SHOT, model="slip", ball=sticky)
    assert own.parameters.values["slip_y"] == -0.2
    assert "of the ball sticky: slip_y" in own.parameters.source
    assert own.backspin != clubface.impact("driver", SHOT, model="slip", ball=sticky.replace(parameters={})).backspin
    for chosen in ({"slip_y": -0.1}, ParameterSet.builtin("slip", "driver", "three-dimensional-impact-models")):
        result = clubface.impact("driver", SHOT, model="slip", ball=sticky, parameters=chosen)
        assert result.parameters.values["slip_y"] != -0.2
    # A value changed beside it leaves that of the ball.
    other = clubface.impact("driver", SHOT, model="slip", ball=sticky, parameters={"cor": 0.8})
    assert other.parameters.values["slip_y"] == -0.2
    rolling = clubface.impact("driver", SHOT, model="standard", ball=sticky)
    assert rolling.parameters == ParameterSet.builtin("standard", "driver")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (SLIP.replace("slip_y", "slipp_y"), "did you mean slip_y"),
        (SLIP.replace("parameters.slip", "parameters.slep"), "did you mean slip"),
        (SLIP.replace('inertia = "81 g cm2"\n', ""), "missing: inertia"),
        (SLIP.replace('inertia = "81 g cm2"\n', 'inertia = "81 g cm2"\nradius = "21 mm"\n'), "not both"),
        (SLIP.replace('inertia = "81 g cm2"\n', 'inertia = "81 g cm2"\nfriction = -1\n'), "<text>:5: friction is -1"),
        (PIECES.replace('density = "950 kg/m3"', ""), "<text>:9: density of cover is missing"),
        (PIECES.replace("1.8 mm", "1.8 g"), "<text>:12: thickness"),
        (
            PIECES.replace("1.8 mm", "30 mm"),
            "<text>:12: thickness is '30 mm'",
        ),
        (
            PIECES.replace("45.6 g", "4 g"),
            "<text>:3: mass is '4 g'; it must be more",
        ),
    ],
)
def test_a_mistake_in_a_file_is_reported_with_its_line(text, message):
    with pytest.raises(ClubfaceError) as caught:
        Ball.from_text(text)
    assert isinstance(caught.value, FileError)
    assert message in str(caught.value)
