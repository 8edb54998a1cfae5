"""Every kind of study gives what the function of the package gives that it calls, whatever is swept."""

import math

import numpy as np
import pytest

import clubface
from clubface import studies
from clubface.design.best_loft import best_loft
from clubface.design.dispersion import dispersion
from clubface.design.golfer import golfer
from clubface.design.optimisation.run import optimise
from clubface.design.optimisation.study import from_text
from clubface.design.strokes import Hole
from clubface.errors import FileError
from clubface.fem import head_tests
from clubface.fem.case import case
from clubface.studies.study import KINDS, kind, read_study
from clubface.units import to_si

pytest.importorskip("pyarrow")


def computed(folder, name, table, sweep, study=""):
    """A study's design and all of its tasks."""
    path = folder / "study.toml"
    path.write_text(f'[study]\nkind = "{name}"\n{study}\n[{name}]\n{table}\n[sweep]\n{sweep}\n')
    study = read_study(path)
    result = study.task.run(range(study.design.count))
    return study.design.values(range(study.design.count)), result


@pytest.mark.parametrize("name", KINDS)
def test_the_module_of_a_kind_has_a_kind_of_that_name(name):
    assert kind(name).name == name


def test_a_map_is_that_of_the_package(tmp_path):
    table = """
club = "driver"
held = { speed = "105 mph" }
grid = [11, 9]
spread_toe = "10 mm"
spread_high = "6 mm"
"""
    sweep = 'club_mass = ["190 g", "204 g"]\nbulge = ["250 mm", "flat"]\nair.altitude = ["0 m", "1500 m"]'
    _, result = computed(tmp_path, "map", table, sweep)
    assert not result.failed
    club = clubface.club("driver").replace(mass="204 g", bulge="250 mm")
    one = clubface.map_face(club, speed="105 mph", grid=(11, 9), air={"altitude": "1500 m"})
    assert result.columns["area"][5] == one.area()
    assert result.columns["sweet_spot_toe"][5] == one.best().toe
    assert result.columns["longest_carry"][5] == one.best("carry").value
    spread = one.forgiveness(("10 mm", "6 mm"))
    assert result.columns["missed"][5] == spread.missed
    assert result.columns["carry_loss"][5] == spread.loss["carry"]
    assert result.columns["side_deviation"][5] == spread.deviation["side"]
    assert result.columns["longest_carry"][5] > result.columns["longest_carry"][4]  # thin air, far


def test_the_scatter_and_the_share_of_a_map_are_swept(tmp_path):
    table = 'club = "driver"\nheld = { speed = "105 mph" }\ngrid = [11, 9]\noutputs = ["area", "ball_speed_loss"]'
    sweep = 'spread.toe = ["5 mm", "15 mm"]\nspread.high = ["5 mm"]\nshare = [0.95, 0.99]\nmodel = ["standard"]'
    _, result = computed(tmp_path, "map", table, sweep)
    assert result.columns["area"][0] > result.columns["area"][1]
    assert result.columns["ball_speed_loss"][2] > result.columns["ball_speed_loss"][0] > 0.0


def test_a_dispersion_is_that_of_the_package(tmp_path):
    table = 'hole = { length = "420 yd" }\nshots = 512\npercentiles = [10, 90]'
    sweep = 'golfer = ["tour-driver", "bogey-driver"]\nwind.speed = ["5 m/s"]\nwind.direction = ["0 deg", "90 deg"]'
    _, result = computed(tmp_path, "dispersion", table, sweep)
    for task, (who, wind) in enumerate(
        (who, wind) for who in ("tour-driver", "bogey-driver") for wind in ((5.0, 0, 0), (0.0, 0, 5.0))
    ):
        one = dispersion(who, count=512, wind=wind, hole=Hole(length="420 yd"))
        # The cosine of a right angle is not quite 0.
        assert result.columns["strokes"][task] == pytest.approx(one.strokes, rel=1e-6)
        assert result.columns["gained"][task] == pytest.approx(one.gained, rel=1e-5)
        assert result.columns["carry_mean"][task] == pytest.approx(one.mean("carry"), rel=1e-9)
        assert result.columns["fairway"][task] == one.lies["fairway"]
        axes = one.ellipse(0.9).half_axes
        assert result.columns["ellipse_area"][task] == pytest.approx(math.pi * axes[0] * axes[1], rel=1e-6)
    with_percentiles = table + '\noutputs = ["carry_p10", "carry_p90"]'
    _, result = computed(tmp_path, "dispersion", with_percentiles, 'golfer = ["tour-driver"]')
    one = dispersion("tour-driver", count=512)
    assert result.columns["carry_p10"][0] == one.quantile("carry", 0.1)


def test_the_figures_of_a_golfer_a_club_and_a_hole_are_swept(tmp_path):
    sweep = """
mean.speed = ["45 m/s", "50 m/s"]
spread.face = ["1 deg", "3 deg"]
spread_factor = [1, 2]
hole.length = ["350 yd", "450 yd"]
club_mass = ["204 g"]
"""
    _, result = computed(tmp_path, "dispersion", 'golfer = "tour-driver"\nshots = 512', sweep)
    player = golfer("tour-driver")
    mean, spread = np.array(player.mean), np.array(player.spread)
    mean[player.variables.index("speed")], spread[player.variables.index("face")] = 50.0, math.radians(3.0)
    correlation = np.array(player.correlation)
    np.fill_diagonal(correlation, 1.0)
    changed = player.replace(mean=mean, covariance=correlation * np.outer(2 * spread, 2 * spread))
    club = clubface.club("driver").replace(mass="204 g")
    one = dispersion(changed, club, count=512, hole=Hole(length="450 yd"))
    # The covariance is multiplied in another order.
    assert result.columns["carry_mean"][15] == pytest.approx(one.mean("carry"), rel=1e-9)
    assert result.columns["side_deviation"][15] == pytest.approx(one.spread("side"), rel=1e-6)
    side = result.columns["side_deviation"].reshape(2, 2, 2, 2)
    assert (side[:, 1] > side[:, 0]).all()
    assert (result.columns["strokes"].reshape(-1, 2)[:, 1] > result.columns["strokes"].reshape(-1, 2)[:, 0]).all()


def test_a_best_loft_is_that_of_the_package(tmp_path):
    sweep = (
        'attack = ["-5 deg", "5 deg"]\nair.temperature = ["10 degC"]\nhigh = ["5 mm"]\nspeed = ["90 mph", "110 mph"]'
    )
    _, result = computed(tmp_path, "best-loft", 'club = "driver"', sweep)
    one = best_loft("110 mph", "5 deg", high="5 mm", air={"temperature": "10 degC"})
    assert result.columns["best_loft"][3] == one.loft[0]
    assert result.columns["carry"][3] == one.carry[0]
    assert result.columns["within_above"][3] == one.within[0, 1]


def test_a_comparison_is_of_two_shots(tmp_path):
    table = """
club = "driver"
held = { speed = "105 mph", toe = "8 mm" }
outputs = ["ball_speed", "carry"]
[comparison.other]
club = "3-wood"
held = { toe = "0 mm" }
"""
    values, result = computed(
        tmp_path, "comparison", table, 'attack = ["-3 deg", "3 deg"]\nair.altitude = ["0 m", "900 m"]'
    )
    for task in range(4):
        swept = {"speed": "105 mph", "attack": values["attack"][task]}
        air = {"altitude": values["altitude"][task]}
        one, other = (
            clubface.fly(clubface.impact(club, toe=toe, **swept), air=air).carry
            for club, toe in (("driver", "8 mm"), ("3-wood", 0.0))
        )
        assert result.columns["carry"][task] == one
        assert result.columns["carry_other"][task] == other
        assert result.columns["carry_difference"][task] == other - one


def test_what_the_other_shot_holds_is_not_swept_in_it(tmp_path):
    table = 'held = { speed = "105 mph" }\noutputs = ["ball_speed"]\nother = { club = "driver" }'
    _, result = computed(tmp_path, "comparison", table, 'club = ["driver", "3-wood"]')
    assert result.columns["ball_speed_difference"][0] == 0.0
    assert result.columns["ball_speed_difference"][1] > 0.0


BETTER = """
title = "lofts"
club = "driver"
golfer = "bogey-driver"
objective = "carry"
shots = 256
starts = 2
[variables]
loft = ["8 deg", "12 deg"]
[rules]
conform = false
"""


def test_an_optimum_along_a_bound_and_a_speed(tmp_path):
    (tmp_path / "better.toml").write_text(BETTER)
    sweep = 'variables.loft.most = ["9 deg", "12 deg"]\nmean.speed = ["35 m/s", "45 m/s"]'
    _, result = computed(tmp_path, "optimise", 'file = "better.toml"', sweep)
    assert not result.failed
    loft = result.columns["loft"].reshape(2, 2)
    assert loft[0] == pytest.approx(to_si(9.0, "deg"), rel=1e-6)  # a slow swing wants more than it is allowed
    assert (result.columns["carry_optimum"][[1, 3]] > result.columns["carry_optimum"][[0, 2]]).all()
    _, result = computed(tmp_path, "optimise", 'file = "better.toml"', 'variables.loft.most = ["12 deg"]')
    one = optimise(from_text(BETTER))
    assert result.columns["loft"][0] == one.club["loft"]
    assert result.columns["carry_optimum"][0] == one.fresh.value("optimum", "carry")


def test_a_case_of_finite_elements_is_that_of_the_package(tmp_path):
    table = 'case = "paper"\noutputs = ["ball_speed", "peak_force", "contact_time"]'
    sweep = 'speed = ["30 m/s"]\nloft = ["10 deg"]\nfriction = [0.2, 0.4]'
    _, result = computed(tmp_path, "fem", table, sweep)
    one = case("paper").replace(speed=30.0, loft="10 deg", friction=0.4).run()
    assert result.columns["ball_speed"][1] == one.outcome()["ball_speed"]
    assert result.columns["peak_force"][1] == one.peak_force
    assert result.columns["contact_time"][1] == one.contact_time


def test_tests_of_a_head_are_those_of_the_package(tmp_path):
    table = 'head = "paper"\noutputs = ["characteristic_time", "mass"]'
    _, result = computed(tmp_path, "head", table, 'toe = ["0 mm", "10 mm"]\nthickness.face_centre = ["3 mm", "3.4 mm"]')
    assert not result.failed
    assert result.columns["characteristic_time"][0] > result.columns["characteristic_time"][1]  # a thick face is stiff
    own = head_tests.characteristic_time("paper", toe="10 mm")
    _, result = computed(tmp_path, "head", table, 'toe = ["10 mm"]')
    assert result.columns["characteristic_time"][0] == own


def test_a_study_of_motion_capture_is_that_of_the_package(tmp_path):
    pytest.importorskip("scipy")
    from clubface.capture.reduction import QUANTITIES
    from clubface.capture.study import study
    from clubface.capture.synthetic.laboratory import Cameras

    table = 'noise = "0.5 mm"\noutputs = ["speed_error", "face_stated", "touch_error"]'
    sweep = 'estimator = ["linear", "smoother"]\nrate = [360, 720]\nswing = { from = 0, to = 2, step = 1 }'
    _, result = computed(tmp_path, "capture", table, sweep)
    assert not result.failed
    one = study(3, cameras=Cameras(rate=360.0, noise=5e-4), estimators=("smoother",))
    assert result.columns["speed_error"][6:9].tolist() == one.errors["smoother"][:, QUANTITIES.index("speed")].tolist()
    assert (
        result.columns["face_stated"][6:9].tolist() == one.deviations["smoother"][:, QUANTITIES.index("face")].tolist()
    )
    assert result.columns["touch_error"][6:9].tolist() == one.touches["smoother"].tolist()


@pytest.mark.parametrize(
    ("name", "table", "sweep", "words"),
    [
        ("map", 'club = "driver"\nheld = { speed = 45, toe = 0 }', "loft = [0.2]", "a map strikes the whole face"),
        ("map", 'club = "driver"\nheld = { speed = 45 }', "toe = [0.01]", "unknown input 'toe'"),
        (
            "map",
            'club = "driver"\nheld = { speed = 45 }\noutputs = ["missed"]',
            "loft = [0.2]",
            "spread_toe is missing",
        ),
        ("map", 'club = "driver"\nheld = { speed = 45 }\noutputs = ["areas"]', "loft = [0.2]", "did you mean area"),
        ("dispersion", "", "spread_factor = [1]", "golfer is missing"),
        ("dispersion", 'golfer = "tour-driver"\nshots = 0', "spread_factor = [1]", "shots"),
        ("dispersion", 'golfer = "tour-driver"\noutputs = ["strokes"]', "spread_factor = [1]", "hole is missing"),
        ("dispersion", 'golfer = "tour-driver"', "spread.speeds = [1]", "unknown input 'speeds'"),
        (
            "best-loft",
            'club = "driver"\nheld = { loft = 0.2, speed = 45 }',
            "attack = [0]",
            "left out: it is optimised",
        ),
        ("comparison", 'club = "driver"\nheld = { speed = 45 }', "attack = [0]", "other is missing"),
        ("comparison", 'club = "driver"\nother = { clubs = 1 }', "speed = [45]", "did you mean club"),
        ("optimise", "", "spread_factor = [1]", "file is missing"),
        ("fem", "", "speed = [40]", "case is missing"),
        ("head", "", "toe = [0]", "head is missing"),
        ("capture", "", "rate = [720]", "swing is missing"),
        ("head", 'head = "papr"', "toe = [0]", "did you mean paper"),
        ("dispersion", 'golfer = "tour-driver"\nhole = { lie = "tee" }', "spread_factor = [1]", "with the length"),
        ("map", 'club = "driver"\nheld = { speed = 45 }\nabout_toe = 0.01', "loft = [0.2]", "about_toe is given"),
        ("map", 'club = "driver"\nheld = { speed = 45 }\nspread_toe = 0.01', "loft = [0.2]", "spread_toe is given"),
        ("capture", "swing = 1", "swing = [1]", "swing is held and swept"),
    ],
)
def test_mistakes_in_a_study_are_reported_with_their_file(tmp_path, name, table, sweep, words):
    with pytest.raises(FileError, match=words):
        computed(tmp_path, name, table, sweep)


@pytest.mark.parametrize(
    ("name", "table", "sweep", "words"),
    [
        ("dispersion", 'golfer = "tour-driver"\nshots = 64', "seed = { from = 0, to = 3, count = 3 }", "whole numbers"),
        ("capture", "", "swing = { from = 0, to = 5, step = 0.5 }", "swing is .* whole numbers"),
        ("capture", "seed = 1.5", "swing = [1]", "seed is 1.5; it must be a whole number"),
        ("dispersion", 'golfer = "tour-driver"\nshots = 64', "seed = [1.5]", "seed is .*1.5.* a whole number"),
        ("dispersion", 'golfer = "tour-driver"\nshots = 64\nseed = "a"', "spread_factor = [1]", "seed is 'a'"),
        ("capture", "swing = 1", "seed = [0.5]", "seed is .*0.5.* a whole number"),
        ("optimise", 'file = "better.toml"', "starts = [0]", "starts is 0; it must be a whole number from 1"),
    ],
)
def test_counts_are_whole_and_within_limits(tmp_path, name, table, sweep, words):
    (tmp_path / "better.toml").write_text(BETTER)
    with pytest.raises(FileError, match=words):
        computed(tmp_path, name, table, sweep)


def test_a_failing_task_is_reported_and_the_others_have_their_results(tmp_path):
    (tmp_path / "better.toml").write_text(BETTER)
    _, result = computed(tmp_path, "optimise", 'file = "better.toml"', 'variables.loft.most = ["7 deg", "12 deg"]')
    assert [index for index, _ in result.failed] == [0]
    assert "lower bound" in result.failed[0][1]
    assert math.isnan(result.columns["loft"][0])
    assert not math.isnan(result.columns["loft"][1])


def test_kinds_run_in_workers_and_resume_as_all_studies(tmp_path, in_this_process):
    path = tmp_path / "golfers.toml"
    path.write_text(
        '[study]\nkind = "dispersion"\nchunk = 1\n[dispersion]\ngolfer = "tour-driver"\nshots = 64\n'
        '[sweep]\nspread_factor = [1, 2]\nair.altitude = ["0 m", "1000 m"]\n'
    )
    assert studies.run(path, shard="1/2").missing == 2
    assert studies.run(path).computed == 2
    assert studies.join(path, tmp_path / "all.csv").tasks == 4
    heads = (tmp_path / "all.csv").read_text().splitlines()[0]
    assert heads.startswith("spread_factor,altitude_m,carry_mean_m,carry_deviation_m")
