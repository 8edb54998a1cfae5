"""What a study holds and what it sweeps: each input once, and what the other shot of a comparison has is its own."""

import pytest

import clubface
from clubface.design.best_loft import best_loft
from clubface.design.dispersion import dispersion
from clubface.design.golfer import golfer
from clubface.errors import FileError
from clubface.simulation.flight import GROUNDS
from clubface.studies.study import read_study

pytest.importorskip("pyarrow")
BASE = 'club = "driver"\nheld = { speed = "105 mph", loft = "12 deg", toe = "5 mm" }\n'


def computed(folder, kind, table, sweep, study=""):
    path = folder / "study.toml"
    path.write_text(f'[study]\nkind = "{kind}"\n{study}\n[{kind}]\n{table}\n[sweep]\n{sweep}\n')
    study = read_study(path)
    result = study.task.run(range(study.design.count))
    assert not result.failed, result.failed
    return result.columns


def flown(club="driver", *, parameters=None, model="area", hand=None, **conditions):
    more = {} if hand is None else {"hand": hand}
    launch = clubface.impact(
        club, model=model, parameters=parameters, speed="105 mph", loft="12 deg", toe="5 mm", **more
    )
    return clubface.fly(launch, **conditions)


@pytest.mark.parametrize(
    ("other", "sweep", "second"),
    [
        ("{ parameters = { friction = 0.1 } }", "friction = [0.2, 0.4]", {"parameters": {"friction": 0.1}}),
        ("{ parameters.area.friction = 0.1 }", "friction = [0.2, 0.4]", None),
        ('{ air.temperature = "0 degC" }', 'temperature = ["10 degC", "30 degC"]', {"air": {"temperature": "0 degC"}}),
        ('{ air.altitude = "2000 m" }', 'air.pressure = ["900 hPa", "1000 hPa"]', {"air": {"altitude": "2000 m"}}),
        ('{ wind = { wind_x = "5 m/s" } }', 'wind.wind_x = ["-5 m/s", "0 m/s"]', {"wind": ("5 m/s", 0, 0)}),
        ('{ wind = { wind_x = "5 m/s" } }', 'wind.speed = ["1 m/s", "9 m/s"]', {"wind": ("5 m/s", 0, 0)}),
        ("{ ground.ground_tilt = 0.2 }", "ground.tilt = [0.1, 0.3]", {"ground": {"ground_tilt": 0.2}}),
        ('{ hand = "left" }', 'hand = ["right", "left"]', {"hand": "left"}),
    ],
)  # fmt: skip
def test_what_the_other_shot_has_is_not_swept_in_it(tmp_path, other, sweep, second):
    table = f'{BASE}model = "area"\noutputs = ["total_side"]\nother = {other}'
    if second is None:
        with pytest.raises(FileError, match=r"friction is in \[sweep\] and for one model as other.parameters"):
            computed(tmp_path, "comparison", table, sweep)
        return
    result = computed(tmp_path, "comparison", table, sweep)
    assert result["total_side_other"].tolist() == [flown(**second).total_side] * 2
    assert result["total_side"][0] != result["total_side"][1]


def test_the_other_shot_keeps_what_it_does_not_change(tmp_path):
    """It says what is different: at altitude, in the cold; on a firm fairway, of another grass."""
    table = BASE + 'model = "area"\noutputs = ["total"]\nair = { altitude = "1600 m" }\nground = "firm fairway"\n'
    table += 'parameters = { friction = 0.2 }\nother.air = { temperature = "0 degC" }\n'
    table += "other.ground = { rolling_friction = 0.3 }\nother.parameters = { friction = 0.4 }"
    result = computed(tmp_path, "comparison", table, 'humidity = ["10 %"]')
    ground = {**GROUNDS["firm fairway"], "rolling_friction": 0.3}
    air = {"altitude": "1600 m", "temperature": "0 degC", "humidity": "10 %"}
    assert result["total_other"][0] == pytest.approx(flown(parameters={"friction": 0.4}, air=air, ground=ground).total)


def test_the_other_shot_keeps_the_crosswind_of_a_wind_that_is_given_as_a_list(tmp_path):
    table = BASE + 'model = "area"\noutputs = ["total"]\nwind = ["1 m/s", "0 m/s", "4 m/s"]\n'
    result = computed(tmp_path, "comparison", table + 'other.wind = { wind_x = "5 m/s" }', 'humidity = ["10 %"]')
    expected = flown(air={"humidity": "10 %"}, wind=("5 m/s", "0 m/s", "4 m/s")).total
    assert result["total_other"][0] == pytest.approx(expected, rel=1e-12)


def test_a_set_of_parameters_beside_a_swept_parameter_is_refused_in_the_other_shot(tmp_path):
    table = BASE + 'model = "area"\noutputs = ["total"]\nother = { parameters = "p1-2021" }'
    with pytest.raises(FileError, match=r"other.parameters is 'p1-2021'; .* friction is swept"):
        computed(tmp_path, "comparison", table, "friction = [0.2, 0.4]")


@pytest.mark.parametrize(
    ("kind", "table", "sweep", "places"),
    [
        ("impact", BASE, "speed = [40]", ("held.speed of [impact] in line 6",)),
        ("impact", BASE + 'model = "area"\nparameters.friction = 0.1', "friction = [0.2]", ("parameters.friction",)),
        ("impact", BASE + 'model = "area"\n[impact.parameters.area]\nfriction = 0.1', "friction = [0.2]",
         ("parameters.area.friction of [impact] in line 9",)),
        ("impact", BASE + "air.humidity = 0.5", "air.humidity = [0.2]", ("air.humidity of [impact] in line 7",)),
        ("impact", BASE + "ground.ground_tilt = 0.2", "ground.tilt = [0.2]", ("ground.ground_tilt",)),
        ("impact", BASE + 'hand = "left"', 'hand = ["right"]', ("hand of [impact]",)),
        ("map", 'club = "driver"\nheld.speed = 45\nwind.wind_x = 1', "wind_x = [2]", ("wind.wind_x of [map]",)),
        ("dispersion", 'golfer = "tour-driver"\nhole = { length = 400, fairway = 30 }', "hole.length = [380]",
         ("hole.length",)),
        ("dispersion", 'golfer = "tour-driver"\nseed = 3', "seed = [1, 2]", ("seed of [dispersion]",)),
        ("best-loft", 'club = "driver"\nheld.speed = 45\nair.temperature = 280', "temperature = [290]",
         ("air.temperature",)),
        ("comparison", BASE + 'other = { club = "3-wood" }', "toe = [0.01]", ("held.toe of [comparison]",)),
        ("head", 'head = "paper"\nfriction = 0.2', "friction = [0.1]", ("friction of [head]",)),
        ("capture", "rate = 720\nswing = 1", "rate = [360]", ("rate of [capture]",)),
    ],
)  # fmt: skip
def test_what_is_held_and_swept_is_refused_with_both_places(tmp_path, kind, table, sweep, places):
    with pytest.raises(FileError, match=r"held and swept.* and in \[sweep\]") as caught:
        computed(tmp_path, kind, table, sweep)
    assert all(each in str(caught.value) for each in places), caught.value
    assert caught.value.line is not None


def test_a_column_of_a_table_is_not_held_as_well(tmp_path):
    (tmp_path / "t.csv").write_text("toe_mm,high_mm\n0,1\n5,2\n")
    with pytest.raises(FileError, match=r"toe is held and swept"):
        computed(tmp_path, "head", 'head = "paper"\ntoe = "3 mm"', 'table = "t.csv"', 'design = "table"')


def test_the_hand_is_swept_in_maps(tmp_path):
    table = 'club = "driver"\nheld = { speed = "105 mph", face = "2 deg" }\ngrid = [9, 7]\noutputs = ["longest_toe"]'
    result = computed(tmp_path, "map", table, 'hand = ["right", "left"]')
    for place, hand in enumerate(("right", "left")):
        one = clubface.map_face(clubface.club("driver").replace(hand=1 - 2 * place), speed="105 mph", face="2 deg",
                                grid=(9, 7))  # fmt: skip
        assert result["longest_toe"][place] == one.best("carry").toe, hand


def test_the_hand_is_swept_in_dispersions_and_mirrors_the_golfer(tmp_path):
    table = 'golfer = "bogey-driver"\nshots = 256\noutputs = ["side_mean", "carry_mean"]'
    result = computed(tmp_path, "dispersion", table, 'hand = ["right", "left"]')
    player = golfer("bogey-driver")
    one = dispersion(player, clubface.club(player.club).replace(hand=-1), count=256)
    assert result["side_mean"][1] == one.mean("side")
    assert result["side_mean"][0] == pytest.approx(-result["side_mean"][1], rel=1e-6)
    assert result["carry_mean"][0] == pytest.approx(result["carry_mean"][1], rel=1e-9)


def test_the_hand_is_swept_in_best_lofts(tmp_path):
    result = computed(tmp_path, "best-loft", 'club = "driver"\nheld = { speed = 45, toe = 0.01 }', 'hand = ["left"]')
    one = best_loft(45, club=clubface.club("driver").replace(hand=-1), toe=0.01)
    assert result["best_loft"][0] == one.loft[0]
