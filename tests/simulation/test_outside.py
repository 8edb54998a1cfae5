"""Shots outside the range of a model: found where they are, told once, with their number."""

import math
import warnings

import numpy as np
import pytest
from response_fit import heads

import clubface
from clubface import Prior
from clubface.capture.rotations import delivered, face_axes
from clubface.equipment.models import DEFAULT_MODEL
from clubface.equipment.parameters import RANGES, ParameterSet
from clubface.errors import FileError, RangeWarning
from clubface.simulation.impact import Tally
from clubface.support.checks import without_warnings
from clubface.validation import validate
from clubface.validation.tour import tour
from deliveries import table

RANGE = RANGES[DEFAULT_MODEL]
pytestmark = pytest.mark.usefixtures("new_process")


def remark(*launches):
    return Tally().add_all(launches).remark()


def quietly(*arguments, **values):
    with without_warnings(RangeWarning):
        return clubface.impact(*arguments, **values)


def test_the_strikes_of_the_fit_fill_the_range_and_none_is_outside():
    result = {name: [] for name in ("speed", "club_mass", "characteristic_time", "friction", "incidence")}
    with without_warnings():
        for head, delivery, friction in heads(256, 7):
            launch = quietly(head, delivery, parameters={"friction": friction})
            assert remark(launch) == ""
            for name in ("speed", "club_mass", "characteristic_time"):
                result[name].append(launch.input(name))
            result["friction"].append(friction)
            result["incidence"].append(delivery["loft"] - delivery["attack"])
    for name, values in result.items():
        least, most = RANGE[name]
        assert max(values) > most - 0.05 * (most - least), name
        assert min(values) < least + 0.05 * (most - least), name


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"speed": 66.0}, "clubhead speed 147.6 mph"),
        ({"speed": 9.0}, "clubhead speed 20.13 mph"),
        ({"club_mass": 0.15}, "mass of the head 150 g"),
        ({"characteristic_time": 360e-6}, "characteristic time 360 us"),
        ({"parameters": {"friction": 0.61}}, "friction 0.61"),
        ({"loft": "60 deg", "attack": "-13 deg"}, "angle between path and face normal 73 deg"),
        ({"loft": "68 deg", "attack": "-3 deg", "face": "20 deg"}, "angle between path and face normal 72.36 deg"),
    ],
)
def test_each_quantity_is_reported_beyond_its_range_and_not_within(values, words):
    assert remark(quietly("driver", **{"speed": 50.0, **values})).startswith(
        f"outside the range of response: {words} ("
    )
    assert remark(quietly("driver", speed=50.0)) == ""


def test_the_angle_is_that_between_path_and_normal_whatever_they_are():
    angles = np.random.default_rng(3).uniform(-1.0, 1.0, (4, 500)) * np.array([[0.3], [0.6], [1.3], [0.6]])
    attack, path, loft, face = angles
    launch = quietly("driver", speed=50.0, attack=attack, path=path, loft=loft, face=face, on_error="nan")
    normal = (delivered(loft, face, 0.0, 0.0) @ face_axes(0.0))[..., :, 0]
    along = np.stack([np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)], axis=-1)
    apart = np.degrees(np.arccos(np.sum(normal * along, axis=-1)))
    there = launch.ball_speed > 0.0  # no miss
    expected = int((apart[there] > 72.0).sum())
    assert expected > 5
    assert f"in {expected} of 500 shots (valid: 0 to 72 deg)" in remark(launch)


def test_a_value_at_the_end_of_a_range_in_another_unit_is_inside():
    for speed in ("101 mph", "118 mph", "189.901 km/h"):
        assert remark(quietly("driver", speed=speed, model="slip")) == "", speed


def test_python_warns_once_with_the_number_of_shots():
    with pytest.warns(RangeWarning, match=r"clubhead speed in 3 of 5 shots \(valid: 22.37 to 145.4 mph\)"):
        clubface.impact("driver", speed=[5.0, 6.0, 7.0, 50.0, 51.0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        clubface.impact("driver", speed=[5.0, 50.0])
        clubface.impact("driver", speed=4.0)


def test_several_models_warn_in_one_line():
    with pytest.warns(RangeWarning) as caught:
        clubface.impact("driver", speed="90 mph", toe="3 mm", model="all")
    assert len(caught) == 1
    assert "adjusted, slip, volumetric, rings, area" in str(caught[0].message)
    assert "jorgensen has no gear effect" in str(caught[0].message)


def test_derivatives_and_histories_warn_too():
    with pytest.warns(RangeWarning, match="outside the range of response"):
        clubface.sensitivity("driver", speed=70.0)
    with pytest.warns(RangeWarning, match="outside the range of volumetric"):
        clubface.history("driver", speed=40.0)


def test_jorgensen_speaks_of_gear_effect_off_centre_alone():
    assert remark(quietly("driver", speed=50.0, model="jorgensen")) == ""
    for where in ({"toe": 1e-3}, {"high": -1e-3}, {"toe": np.array([0.0, 1e-3])}):
        message = remark(quietly("driver", speed=50.0, model="jorgensen", **where))
        assert message == "jorgensen has no gear effect off centre"


def test_a_shot_that_cannot_be_computed_is_not_counted():
    shots = quietly("driver", speed=[70.0, 71.0, 50.0], toe=[0.0, 0.2, 0.0], on_error="nan")
    assert "in 1 of 3 shots" in remark(shots)


def test_a_file_of_deliveries_has_one_note_with_the_number(write, tmp_path):
    source = write("club_speed_mps\n" + "50\n" * 30 + "70\n" * 12)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        report = clubface.predict(source, club="driver", output=tmp_path / "out.csv", chunk_rows=5)
    (note,) = [str(each) for each in report.notes if "outside" in str(each)]
    assert note == "outside the range of response: clubhead speed in 12 of 42 shots (valid: 22.37 to 145.4 mph)"
    assert len(table(tmp_path / "out.csv")) == 42


def test_a_custom_set_may_have_a_range(write):
    text = ParameterSet.builtin("slip", "driver").to_toml()
    assert "[set.range]\nspeed = [" in text
    again = ParameterSet.from_toml(write(text, "own.toml"))
    assert again.range == ParameterSet.builtin("slip", "driver").range
    assert again.range["speed"] == pytest.approx((101 * 0.44704, 118 * 0.44704), rel=1e-12)
    own = write(text.replace("[set.range]", '[set.range]\nattack = ["1 deg", "2 deg"]'), "bad.toml")
    with pytest.raises(FileError, match=r"bad\.toml:\d+: unknown key 'attack'.* speed, incidence"):
        ParameterSet.from_toml(own)
    for wrong, message in (("[52.0, 40.0]", "least and greatest"), ('["1 kg", "2 kg"]', "speed is"), ("3", "two")):
        line = next(each for each in text.splitlines() if each.startswith("speed = "))
        with pytest.raises(FileError, match=message):
            ParameterSet.from_toml(write(text.replace(line, f"speed = {wrong}"), "bad.toml"))


def test_the_range_of_a_model_is_that_of_every_set_without_its_own():
    assert ParameterSet.defaults(DEFAULT_MODEL).range == RANGE
    assert ParameterSet.builtin("standard", "driver").range == {}
    assert RANGE["incidence"][1] == pytest.approx(math.radians(72.0))


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_a_ball_without_coefficients_of_its_own_is_reported():
    message = "response has no coefficients of the ball paper and takes those of modern"
    paper = clubface.ball("paper")
    assert remark(quietly("driver", speed=50.0, ball=paper)) == message
    assert remark(quietly("driver", speed=50.0, ball=paper, model="standard")) == ""
    # Pieces and coefficients, neither, and coefficients that somebody chose.
    for ball in ("distance", "published", paper.replace(parameters={"response": {"sharpness": 10.0}})):
        assert remark(quietly("driver", speed=50.0, ball=ball)) == ""
    chosen = ParameterSet.defaults(DEFAULT_MODEL).replace(**ParameterSet.defaults(DEFAULT_MODEL).values)
    assert remark(quietly("driver", speed=50.0, ball=paper, parameters=chosen)) == ""


def test_an_inferred_delivery_outside_the_range_is_warned_of_and_remarked_in_files(tmp_path):
    from clubface.inference.file import infer_shots
    from clubface.shots.recorded import RecordedShots

    slow = Prior(name="slow", mean={"speed": 40.0, "loft": 0.25}, deviation={"speed": 2.0, "loft": 0.03})
    with pytest.warns(RangeWarning, match=r"of slip: clubhead speed 8\d\.\d+ mph \(valid: 101 to 118 mph\)") as caught:
        result = clubface.infer({"ball_speed": 56.0}, club="driver", model="slip", prior=slow, samples=20)
    assert len(caught) == 1
    assert result.outside in str(caught[0].message)
    shots = RecordedShots(deliveries={}, launches={"ball_speed": np.array([56.0, 74.0])}, rows=np.array([1, 2]),
                          source="a.csv", format="clubface")  # fmt: skip
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        wide = Prior(name="any", mean={"speed": 46.0, "loft": 0.25}, deviation={"speed": 5.0, "loft": 0.03})
        infer_shots(shots, tmp_path / "out.csv", club="driver", model="slip", prior=wide, samples=20)
    remarks = [row["remark"] for row in table(tmp_path / "out.csv")]
    assert ["outside the range of slip" in each for each in remarks] == [True, False]


def test_what_compares_models_warns_once_in_all():
    with pytest.warns(RangeWarning) as caught:
        tour(["slip", "adjusted", DEFAULT_MODEL], table="lpga-2019")
    (message,) = [str(each.message) for each in caught]
    assert message == "outside the range of slip, adjusted: clubhead speed in 3 of 10 shots (valid: 101 to 118 mph)"
    with pytest.warns(RangeWarning, match=r"of adjusted: clubhead speed in \d+ of \d+ shots") as caught:
        validate("adjusted", checks=["amateur-drives", "tour-driver"])
    assert len(caught) == 1
