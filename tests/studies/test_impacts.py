"""What a study of impacts finds is what single shots give, to the last bit."""

import numpy as np
import pytest

import clubface
from clubface import studies
from clubface.equipment.models import OWN
from clubface.errors import FileError
from clubface.studies.study import read_study
from study_files import shots

pytest.importorskip("pyarrow")


def computed(path):
    study = read_study(path)
    return study, study.task.run(range(study.design.count))


def test_tasks_are_single_shots_and_their_flights(tmp_path):
    study, result = computed(shots(tmp_path))
    inputs = study.design.values(range(study.design.count))
    for task in (0, 7, 23):
        delivery = {name: float(each[task]) for name, each in inputs.items()}
        launch = clubface.impact("driver", delivery, speed="105 mph")
        flight = clubface.fly(launch)
        assert result.columns["ball_speed"][task] == launch.ball_speed
        assert result.columns["backspin"][task] == launch.backspin
        assert result.columns["carry"][task] == flight.carry
        assert result.columns["side"][task] == flight.side


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
    study, result = computed(shots(tmp_path, text=text))
    inputs = study.design.values(range(16))
    axes = {each.name: each for each in study.design.axes}
    for task in range(16):
        named = {name: axes[name].choices[each[task]] for name, each in inputs.items()}
        launch = clubface.impact(named.pop("club"), speed="105 mph", toe="8 mm", **named)
        assert result.columns["sidespin"][task] == launch.sidespin


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
    _, result = computed(shots(tmp_path, text=text))
    launch = clubface.impact(
        "driver", model="area", speed="105 mph", club_mass="204 g", bulge="flat", parameters={"friction": 0.1}
    )
    assert result.columns["backspin"][6] == launch.backspin
    assert len(set(result.columns["ball_speed"].tolist())) > 1


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
    _, result = computed(shots(tmp_path, text=text.replace("{", "{{").replace("}", "}}")))
    changed = {"friction": 0.1, "stiffness": "6e9 N/m3"}
    one = clubface.impact("driver", model="area", speed="110 mph").backspin
    other = clubface.impact("driver", model="volumetric", speed="110 mph", parameters=changed).backspin
    assert result.columns["backspin"].tolist() == [one, other]
    text = text.replace("volumetric = { ", "").replace(' }\n[sweep]\nmodel = ["area", "volumetric"]', "\n[sweep]")
    text = text.replace(", stiffness", "\nstiffness").replace("[impact]", '[impact]\nmodel = "volumetric"')
    path = shots(tmp_path, text=text)
    assert computed(path)[1].columns["backspin"].tolist() == [other]
    assert read_study(path).files() == {}


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
    _, result = computed(shots(tmp_path, text=text))
    launch = clubface.impact("driver", speed="100 mph", loft="12 deg")
    assert result.columns["carry"][0] == clubface.fly(launch, wind=("-10 mph", 0, 0)).carry


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
    _, result = computed(shots(tmp_path, text=text))
    launch = clubface.impact(tmp_path / "mine.toml", model="area", parameters=tmp_path / "soft.toml", speed="110 mph")
    assert result.columns["backspin"][1] == launch.backspin


def test_shots_without_a_result_are_nan_and_reported_with_their_task(tmp_path, in_this_process):
    path = shots(tmp_path, text=shots_of_speeds('["105 mph", "-5 mph", "100 mph"]'))
    done = studies.run(path, workers=1)
    assert done.failed[0] == 1
    assert done.failed[1].startswith("task 1: speed")
    table = studies.summary(path)
    assert table.overall.count.tolist() == [2]
    assert np.isfinite(table.overall.mean).all()


def test_shots_outside_the_range_of_a_model_are_reported(tmp_path, in_this_process):
    done = studies.run(shots(tmp_path, text=shots_of_speeds('["90 mph", "105 mph"]', 'model = "adjusted"')), workers=1)
    assert done.remark == "outside the range of adjusted: clubhead speed in 1 of 2 shots (valid: 101 to 118 mph)"


def test_finite_elements_are_swept_as_every_other_model(tmp_path):
    text = shots_of_speeds('["45 mph"]', 'model = "fem"\nball = "reference"')
    study, result = computed(shots(tmp_path, text=text))
    launch = clubface.impact("driver", model="fem", ball="reference", speed="45 mph")
    assert result.columns["ball_speed"][0] == launch.ball_speed  # on one thread as on all
    assert "processor" in study.task.depends_on


def shots_of_speeds(speeds, more=""):
    return f"""
[impact]
club = "driver"
outputs = ["ball_speed"]
{more}
[sweep]
speed = {speeds}
""".replace("{", "{{").replace("}", "}}")


CONDITIONS = """
[impact]
club = "driver"
held = {{ loft = "12 deg", speed = "100 mph" }}
outputs = ["carry", "side", "total"]
{held}
[sweep]
{sweep}
"""


def flown(**conditions):
    return clubface.fly(clubface.impact("driver", speed="100 mph", loft="12 deg"), **conditions)


@pytest.mark.parametrize(
    ("swept", "values", "conditions"),
    [
        ("air.temperature", ("0 degC", "30 degC"), lambda each: {"air": {"temperature": each}}),
        ("temperature", ("0 degC", "30 degC"), lambda each: {"air": {"temperature": each}}),
        ("air.pressure", ("900 hPa", "1013 hPa"), lambda each: {"air": {"pressure": each}}),
        ("air.altitude", ("0 m", "2000 m"), lambda each: {"air": {"altitude": each}}),
        ("air.humidity", ("10 %", "90 %"), lambda each: {"air": {"humidity": each}}),
        ("wind.wind_x", ("-5 m/s", "5 m/s"), lambda each: {"wind": (each, 0, 0)}),
        ("wind_z", ("-5 m/s", "5 m/s"), lambda each: {"wind": (0, 0, each)}),
        ("wind.speed", ("1 m/s", "5 m/s"), lambda each: {"wind": (each, 0, 0)}),
        ("ground.restitution_factor", (0.5, 1.2), lambda each: {"ground": {"restitution_factor": each}}),
        ("ground.tilt", ("5 deg", "15 deg"), lambda each: {"ground": {"ground_tilt": each}}),
        ("ground.friction", (0.2, 0.6), lambda each: {"ground": {"ground_friction": each}}),
        ("ground.rolling_friction", (0.1, 0.3), lambda each: {"ground": {"rolling_friction": each}}),
        ("ground.grass_length", ("10 m", "60 m"), lambda each: {"ground": {"grass_length": each}}),
    ],
)  # fmt: skip
def test_every_number_of_air_wind_and_ground_is_swept(tmp_path, swept, values, conditions):
    sweep = f"{swept} = {list(values)}".replace("'", '"')
    _, result = computed(shots(tmp_path, text=CONDITIONS.replace("{held}", "").replace("{sweep}", sweep)))
    for task, each in enumerate(values):
        assert result.columns["total"][task] == flown(**conditions(each)).total
    assert result.columns["total"][0] != result.columns["total"][1]


def test_conditions_are_held_and_swept_together_in_a_design_of_samples(tmp_path):
    text = CONDITIONS.replace("{held}", 'wind = {{ wind_speed = "6 m/s" }}\nair = {{ altitude = "1600 m" }}')
    sweep = 'wind.direction = {{ from = "0 deg", to = "180 deg" }}\nair.humidity = {{ from = 0, to = 1 }}'
    text = text.replace("{sweep}", sweep).replace("[impact]", '[study]\ndesign = "sobol"\nsamples = 4\n[impact]', 1)
    study, result = computed(shots(tmp_path, text=text))
    inputs = study.design.values(range(4))
    for task in range(4):
        angle, humidity = inputs["wind_direction"][task], inputs["humidity"][task]
        wind = (6.0 * np.cos(angle), 0.0, 6.0 * np.sin(angle))
        assert result.columns["side"][task] == flown(wind=wind, air={"altitude": "1600 m", "humidity": humidity}).side
    assert (result.columns["side"] > flown(air={"altitude": "1600 m"}).side).all()  # it blows to the right


@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_conditions_are_columns_of_a_table(tmp_path, in_this_process):
    heads = "temperature_degC,air.altitude [m],wind.speed [mph],wind_direction_deg,friction"
    (tmp_path / "days.csv").write_text(f"{heads}\n5,0,10,180,0.4\n30,1500,0,0,0.4\n")
    text = CONDITIONS.replace("{sweep}", 'table = "days.csv"').replace("{held}", "")
    text = text.replace("[impact]", '[study]\ndesign = "table"\n[impact]\nmodel = "area"', 1)
    path = shots(tmp_path, text=text)
    _, result = computed(path)
    launch = clubface.impact("driver", speed="100 mph", loft="12 deg", model="area", parameters={"friction": 0.4})
    cold = clubface.fly(launch, air={"temperature": "5 degC", "altitude": "0 m"}, wind=("-10 mph", 0, 0))
    assert result.columns["carry"][0] == pytest.approx(float(cold.carry), rel=1e-12)  # cos 180 deg, sin 180 deg round
    studies.run(path, workers=1)
    studies.join(path, tmp_path / "all.csv")
    heads = (tmp_path / "all.csv").read_text().splitlines()[0].split(",")
    assert heads[:5] == ["temperature_degC", "altitude_m", "wind_speed_mph", "wind_direction_deg", "friction"]


@pytest.mark.parametrize(
    ("held", "sweep", "words"),
    [
        ("", "air.temprature = [1]", "did you mean temperature"),
        ("", "wind.size = [1]", "unknown input 'size'"),
        ("", "wind.direction = [1]", "wind_speed is missing"),
        ('wind = ["1 m/s", 0, 0]', "wind.speed = [1]", "a table of wind_x"),
        ("wind = {{ wind_x = 1 }}", "wind.speed = [1]", "wind_x is 1"),
        ("wind = {{ wind_speed = 1 }}", "wind.speed = [1]", "held and swept"),
        ("air = {{ pressure = 90000 }}", "altitude = [1]", "since the pressure is given"),
        ("", "altitude = [1]\nair.altitude = [2]", "swept twice"),
    ],
)
def test_conditions_that_do_not_go_together_are_reported_with_their_line(tmp_path, held, sweep, words):
    path = shots(tmp_path, text=CONDITIONS.replace("{held}", held).replace("{sweep}", sweep))
    with pytest.raises(FileError, match=words):
        computed(path)


def test_a_custom_law_is_refused_before_the_study_begins(tmp_path):
    """Workers are other processes, which do not know it."""
    clubface.register_law("mine", lambda touch, values: (0.0, 0.0, 0.0))
    try:
        path = shots(tmp_path)
        path.write_text(path.read_text().replace("[impact]", '[impact]\nmodel = "mine"'))
        with pytest.raises(FileError, match="model is 'mine'"):
            read_study(path)
    finally:
        OWN.clear()
