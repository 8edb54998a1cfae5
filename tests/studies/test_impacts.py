"""What a study of impacts finds is what single shots give, to the last bit."""

import numpy as np
import pytest

import clubface
from clubface import studies
from clubface.studies.kinds import kind
from clubface.studies.study import read_study
from study_files import shots

pytest.importorskip("pyarrow")


def computed(path):
    study = read_study(path)
    return study, kind("impact").prepare(study).run(range(study.design.count))


def test_tasks_are_single_shots_and_their_flights(tmp_path):
    study, found = computed(shots(tmp_path))
    inputs = study.design.values(range(study.design.count))
    for task in (0, 7, 23):
        delivery = {name: float(each[task]) for name, each in inputs.items()}
        launch = clubface.impact("driver", delivery, speed="105 mph")
        flight = clubface.fly(launch)
        assert found.columns["ball_speed"][task] == launch.ball_speed
        assert found.columns["backspin"][task] == launch.backspin
        assert found.columns["carry"][task] == flight.carry
        assert found.columns["side"][task] == flight.side


def test_models_clubs_balls_and_hands_are_swept_by_name(tmp_path):
    text = """
[impact]
held = {{ speed = "105 mph", toe = "8 mm" }}
outputs = ["ball_speed", "sidespin"]
[sweep]
model = ["response", "area"]
club = ["driver", "7-iron"]
ball = ["modern", "distance"]
hand = ["right", "left"]
"""
    study, found = computed(shots(tmp_path, text=text))
    inputs = study.design.values(range(16))
    axes = {each.name: each for each in study.design.axes}
    for task in range(16):
        named = {name: axes[name].choices[each[task]] for name, each in inputs.items()}
        launch = clubface.impact(named.pop("club"), speed="105 mph", toe="8 mm", **named)
        assert found.columns["sidespin"][task] == launch.sidespin


def test_properties_of_the_club_and_parameters_are_swept(tmp_path):
    text = """
[impact]
club = "driver"
model = "area"
held = {{ speed = "105 mph" }}
outputs = ["ball_speed", "backspin"]
[impact.air]
temperature = "10 degC"
[sweep]
club_mass = ["190 g", "204 g"]
bulge = ["305 mm", "flat"]
friction = [0.1, 0.4]
"""
    _, found = computed(shots(tmp_path, text=text))
    launch = clubface.impact(
        "driver", model="area", speed="105 mph", club_mass="204 g", bulge="flat", parameters={"friction": 0.1}
    )
    assert found.columns["backspin"][6] == launch.backspin
    assert len(set(found.columns["ball_speed"].tolist())) > 1


def test_parameters_are_a_table_of_values_or_one_for_each_model(tmp_path):
    text = """
[impact]
club = "driver"
outputs = ["backspin"]
[impact.parameters]
volumetric = { friction = 0.1, stiffness = "6e9 N/m3" }
[sweep]
model = ["area", "volumetric"]
speed = ["110 mph"]
"""
    _, found = computed(shots(tmp_path, text=text.replace("{", "{{").replace("}", "}}")))
    changed = {"friction": 0.1, "stiffness": "6e9 N/m3"}
    one = clubface.impact("driver", model="area", speed="110 mph").backspin
    other = clubface.impact("driver", model="volumetric", speed="110 mph", parameters=changed).backspin
    assert found.columns["backspin"].tolist() == [one, other]
    text = text.replace("volumetric = { ", "").replace(' }\n[sweep]\nmodel = ["area", "volumetric"]', "\n[sweep]")
    text = text.replace(", stiffness", "\nstiffness").replace("[impact]", '[impact]\nmodel = "volumetric"')
    path = shots(tmp_path, text=text)
    assert computed(path)[1].columns["backspin"].tolist() == [other]
    assert read_study(path).content()["file that it names"] == []


def test_conditions_of_the_flight_count(tmp_path):
    text = """
[impact]
club = "driver"
held = {{ loft = "12 deg" }}
outputs = ["carry", "ball_speed"]
wind = ["-10 mph", 0, 0]
[sweep]
speed = ["100 mph"]
"""
    _, found = computed(shots(tmp_path, text=text))
    launch = clubface.impact("driver", speed="100 mph", loft="12 deg")
    assert found.columns["carry"][0] == clubface.fly(launch, wind=("-10 mph", 0, 0)).carry


def test_a_club_and_parameters_of_files_beside_the_study_are_used(tmp_path):
    (tmp_path / "mine.toml").write_text(clubface.club("driver").replace(name="mine", mass="190 g").to_toml())
    (tmp_path / "soft.toml").write_text(clubface.ParameterSet.builtin("area", "driver").replace(friction=0.1).to_toml())
    text = """
[impact]
club = "mine.toml"
model = "area"
parameters = "soft.toml"
outputs = ["ball_speed", "backspin"]
[sweep]
speed = ["100 mph", "110 mph"]
"""
    _, found = computed(shots(tmp_path, text=text))
    launch = clubface.impact(tmp_path / "mine.toml", model="area", parameters=tmp_path / "soft.toml", speed="110 mph")
    assert found.columns["backspin"][1] == launch.backspin


def test_shots_without_a_result_are_nan_and_told_with_their_task(tmp_path, in_this_process):
    path = shots(tmp_path, text=shots_of_speeds('["105 mph", "-5 mph", "100 mph"]'))
    done = studies.run(path, workers=1)
    assert done.failed[0] == 1
    assert done.failed[1].startswith("task 1: speed")
    table = studies.summary(path)
    assert table.overall.count.tolist() == [2]
    assert np.isfinite(table.overall.mean).all()


def test_shots_outside_the_range_of_a_model_are_told(tmp_path, in_this_process):
    done = studies.run(shots(tmp_path, text=shots_of_speeds('["90 mph", "105 mph"]', 'model = "adjusted"')), workers=1)
    assert done.remark == "outside the range of adjusted: clubhead speed in 1 of 2 shots (101 to 118 mph)"


def test_finite_elements_are_swept_as_every_other_model(tmp_path):
    text = shots_of_speeds('["45 mph"]', 'model = "fem"\nball = "reference"')
    study, found = computed(shots(tmp_path, text=text))
    launch = clubface.impact("driver", model="fem", ball="reference", speed="45 mph")
    assert found.columns["ball_speed"][0] == launch.ball_speed  # on one thread as on all
    assert "processor" in kind("impact").prepare(study).depends_on


def shots_of_speeds(speeds, more=""):
    return f"""
[impact]
club = "driver"
outputs = ["ball_speed"]
{more}
[sweep]
speed = {speeds}
""".replace("{", "{{").replace("}", "}}")
