"""From a launch back to its deliveries: coverage of the truth, agreement with the linear answer, priors, mistakes."""

import math

import numpy as np
import pytest

import clubface
from clubface import Prior, infer
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.inference import UnreachableLaunchError, pairs_picture
from clubface.inference.prior import prior_of
from clubface.inference.run import NOISE, Inference
from clubface.shots.measured import QUANTITIES

DEG, RPM, MPH = math.pi / 180, math.pi / 30, 0.44704
DRIVE = {"ball_speed": "159 mph", "launch": "14.5 deg", "azimuth": "1.5 deg", "backspin": "2900 rpm",
         "sidespin": "-300 rpm"}  # fmt: skip


@pytest.fixture(scope="module")
def inferred():
    return infer(DRIVE, club="driver", model="slip")


def synthetic(club, count, seed, model="slip"):
    """True deliveries drawn from the prior, and their launches as a monitor shows them."""
    random = np.random.default_rng(seed)
    prior = prior_of("elite", clubface.club(club))
    truth = prior.deliveries(random.standard_normal((count, len(prior.names))))
    launch = clubface.impact(club, truth, model=model)
    seen = {name: getattr(launch, name) + NOISE[name] * random.standard_normal(count) for name in QUANTITIES}
    return truth, seen


def test_every_draw_makes_the_launch(inferred):
    launch = clubface.impact("driver", inferred.deliveries, model="slip")
    for name, value in inferred.launch.items():
        away = (getattr(launch, name) - value) / inferred.noise[name]
        # The prior is ten times wider than the noise, so that the draws have its spread to a percent or two, and 2000
        # draws show it to some 3 %; three of these.
        assert np.mean(away**2) == pytest.approx(1.0, abs=0.12), name


def test_the_sample_is_that_of_the_linearised_launch_where_it_is_nearly_linear():
    """At the launch of the prior's mean delivery, about which launches bend least."""
    prior = prior_of("elite", clubface.club("driver"))
    launch = clubface.impact("driver", prior.mean, model="slip")
    result = infer({name: float(getattr(launch, name)) for name in QUANTITIES}, club="driver", model="slip")
    mean, names = result.mean, result.names
    table = clubface.sensitivity("driver", mean, model="slip", outputs=list(QUANTITIES), variables=names)
    noise = np.array([result.noise[name] for name in QUANTITIES])
    scaled = prior.deliveries(np.eye(len(names)))
    root = np.array([scaled[name] - prior.mean[name] for name in names])
    jacobian = table.si / noise[:, None]
    covariance = np.linalg.inv(np.linalg.inv(root @ root.T) + jacobian.T @ jacobian)
    expected = dict(zip(names, np.sqrt(np.diag(covariance)), strict=True))
    for name, deviation in result.deviation.items():
        # 6 %: 2000 draws and the curvature of the launch over two or three degrees and five millimetres.
        assert deviation == pytest.approx(expected[name], rel=0.06), name


def test_the_truth_is_inside_as_often_as_stated():
    truth, seen = synthetic("driver", 40, seed=8)
    inside = []
    for shot in range(40):
        one = infer({name: float(each[shot]) for name, each in seen.items()}, club="driver", model="slip", samples=500)
        for name in one.names:
            low, high = one.interval(name, 0.8)
            inside.append(low <= truth[name][shot] <= high)
    # 440 intervals of 40 shots; those of a shot go together, so that the share scatters by some 3 %; four of these.
    assert np.mean(inside) == pytest.approx(0.8, abs=0.1)


@pytest.mark.study
@pytest.mark.parametrize(("club", "model"), [("driver", "slip"), ("7-iron", "slip"), ("driver", "volumetric")])
def test_the_truth_has_any_rank_among_the_draws_with_the_same_probability(club, model):
    # Simulation-based calibration (Talts and others, 2018): ranks of the truth among posterior draws are uniform.
    count, draws, bins = (400 if model == "slip" else 120), 99, 10
    truth, seen = synthetic(club, count, seed=21, model=model)
    ranks = {name: [] for name in truth}
    for shot in range(count):
        launch = {name: float(each[shot]) for name, each in seen.items()}
        one = infer(launch, club=club, model=model, samples=draws, seed=shot)
        for name in one.names:
            ranks[name].append(int(np.sum(one.deliveries[name] < truth[name][shot])))
    for name, each in ranks.items():
        counts = np.bincount(np.array(each) // 10, minlength=bins)
        chi2 = float(np.sum((counts - count / bins) ** 2) / (count / bins))
        print(f"{club}, {model}, {name}: chi2 {chi2:.1f} of {bins - 1} degrees of freedom; {counts.tolist()}")
        # 33.7: the 0.9999 quantile for 9 degrees of freedom; eleven quantities and three cases are tried.
        assert chi2 < 33.7, name


def test_quantities_that_a_launch_ties_together_are_named(inferred):
    tied = [{each.data["first"], each.data["second"]} for each in inferred.ties]
    for pair in ({"attack", "loft"}, {"toe", "face"}, {"path", "face"}):
        assert pair in tied
    assert inferred.not_learned == ["lie", "closure", "pitch_rate", "lie_rate"]
    correlation = dict(zip(inferred.names, inferred.correlation[inferred.names.index("face")], strict=True))
    # Toe side and closed face: the gear effect takes the ball back where an open face would send it.
    assert correlation["toe"] < -0.9
    assert correlation["path"] > 0.9


def test_an_angle_that_is_measured_better_ties_the_delivery_more(inferred):
    sharp = infer(DRIVE, club="driver", model="slip", noise={"launch": "0.05 deg", "backspin": "10 rpm"})
    assert sharp.deviation["loft"] < inferred.deviation["loft"]
    assert abs(sharp.correlation[1, 3]) > abs(inferred.correlation[1, 3])


def test_one_number_alone_is_enough_to_ask():
    one = infer({"ball_speed": "159 mph"}, club="driver")
    # A monitor knows ball speed to 0.25 m/s, a hundredth of the prior; what is not learned is in the impact point.
    assert one.learned["speed"] > 0.25
    # 2000 draws show a deviation to 1.6 %; three of these are less than the 5 % from which something is learned.
    assert "face" in one.not_learned


@pytest.mark.parametrize(
    "names",
    [("total_spin", "spin_axis"), ("backspin", "spin_axis"), ("sidespin", "spin_axis"), ("sidespin", "total_spin")],
)
def test_any_two_spins_stand_for_back_and_sidespin(names):
    total, axis = math.hypot(2900, 300), math.degrees(math.atan2(-300, 2900))
    spins = {"total_spin": f"{total!r} rpm", "spin_axis": f"{360.0 + axis!r} deg", "backspin": "2900 rpm"}
    spins["sidespin"] = "-300 rpm"
    start = {name: value for name, value in DRIVE.items() if name not in spins}
    one = infer({**start, **{name: spins[name] for name in names}}, club="driver", samples=10)
    assert one.launch["backspin"] == pytest.approx(2900 * RPM, rel=1e-12)
    assert one.launch["sidespin"] == pytest.approx(-300 * RPM, rel=1e-12)


def test_a_left_handers_deliveries_are_the_mirror_image():
    mirrored = {**DRIVE, "azimuth": "-1.5 deg", "sidespin": "300 rpm"}
    right = infer(DRIVE, club="driver", model="slip")
    left = infer(mirrored, club=clubface.club("driver").replace(hand="left"), model="slip")
    for name in ("path", "face"):
        assert left.mean[name] == pytest.approx(-right.mean[name], abs=0.2 * right.deviation[name])
    for name in ("toe", "loft", "speed"):
        assert left.mean[name] == pytest.approx(right.mean[name], abs=0.2 * right.deviation[name])


def test_a_launch_that_contradicts_the_prior_is_warned_of(inferred):
    slow = infer({**DRIVE, "ball_speed": "120 mph"}, club="driver", model="slip", samples=300)
    assert slow.warnings[0].code == "contradicts-prior"
    wide = infer({**DRIVE, "ball_speed": "120 mph"}, club="driver", model="slip", samples=300, prior="wide")
    assert not any(each.code.startswith("contradicts") for each in wide.warnings)
    assert inferred.warnings == []


def test_a_launch_out_of_reach_is_refused_with_what_the_prior_expects():
    """All weight would lie on the one draw that is nearest, with deviations of zero."""
    with pytest.raises(
        UnreachableLaunchError, match=r"launch is 'ball_speed 159 mph, launch 80 deg'.*expects ball_speed 15\d mph"
    ):
        infer({"ball_speed": "159 mph", "launch": "80 deg"}, club="driver")


def test_priors_are_elite_tour_or_wide_and_know_their_clubs():
    driver, wedge = clubface.club("driver"), clubface.club("pitching-wedge")
    assert prior_of(None, driver).name == "elite golfers, driver"
    tour = prior_of(None, wedge)
    # PGA Tour of 2019, the season to which the published dynamic lofts belong.
    assert tour.mean["speed"] == pytest.approx(83 * MPH)
    assert tour.mean["attack"] == pytest.approx(-5.0 * DEG)
    assert prior_of("wide", wedge).mean["speed"] < tour.mean["speed"]
    with pytest.raises(InputError, match=r'"tour".* for pitching-wedge'):
        prior_of("elite", wedge)
    with pytest.raises(UnknownNameError, match="did you mean elite"):
        prior_of("elit", driver)
    own = Prior(name="mine", mean={"speed": 40.0}, deviation={"speed": 3.0})
    assert infer({"ball_speed": 60.0}, club="driver", prior=own, samples=50).names == ("speed",)


PRIOR = """title = "club"
[spread]
speed = ["95 mph", "8 mph"]
loft = ["15 deg", "3 deg"]
attack = ["-1 deg", "3 deg"]
[[correlation]]
of = ["loft", "attack"]
value = 0.4
"""


def test_a_prior_is_read_from_a_file(write):
    prior = Prior.from_toml(write(PRIOR, "prior.toml"))
    assert prior.deviation["speed"] == pytest.approx(8 * MPH)
    drawn = prior.deliveries(np.random.default_rng(0).standard_normal((20_000, 3)))
    assert np.corrcoef(drawn["loft"], drawn["attack"])[0, 1] == pytest.approx(0.4, abs=0.03)
    assert drawn["loft"].std() == pytest.approx(3 * DEG, rel=0.03)


@pytest.mark.parametrize(
    ("old", "new", "words_of_error"),
    [
        ('"8 mph"', '"8 deg"', "prior.toml:3: spread.speed"),
        ('"8 mph"', '"0 mph"', "prior.toml:3: .*positive"),
        ('["15 deg", "3 deg"]', '"15 deg"', "prior.toml:4: spread.loft is .* a mean"),
        ("loft = ", "lofft = ", "did you mean loft"),
        ("value = 0.4", "value = 1.4", "between -1 and 1"),
        ("value = 0.4", 'value = "x"', "value is .x.; it must be a finite number"),
        ('of = ["loft", "attack"]', 'of = ["loft", "path"]', "quantity of a correlation"),
        ('speed = ["95 mph", "8 mph"]\n', "", "missing: speed"),
    ],
)
def test_a_bad_file_is_reported_with_its_line(write, old, new, words_of_error):
    assert old in PRIOR
    with pytest.raises(FileError, match=words_of_error):
        Prior.from_toml(write(PRIOR.replace(old, new), "prior.toml"))


@pytest.mark.parametrize(
    ("launch", "options", "words_of_error"),
    [
        ({}, {}, "at least one of ball_speed"),
        (70.0, {}, "launch is 70.0; it must be a mapping"),
        ({"ball_speed": 70.0}, {"delivery": ["speed"]}, "delivery is .* a mapping"),
        ({"ball_speed": 70.0}, {"seed": -1}, "seed is -1; it must be a whole number from 0"),
        ({"ball_sped": 70.0}, {}, "did you mean ball_speed"),
        ({"total_spin": 300.0, "backspin": 299.0}, {}, "give it with spin_axis or sidespin"),
        ({"total_spin": 200.0, "backspin": 299.0}, {}, "spin is backspin.*must be consistent"),
        ({"spin_axis": "5 deg"}, {}, "give it with total_spin or backspin"),
        ({"total_spin": 300.0}, {}, "give it with spin_axis or sidespin"),
        ({"ball_speed": "70 deg"}, {}, "ball_speed"),
        ({"ball_speed": 70.0}, {"noise": {"ball_speed": 0.0}}, "an exact measurement cannot be sampled"),
        ({"ball_speed": 70.0}, {"samples": 0}, "from 1 to"),
        ({"ball_speed": 70.0}, {"model": "slipp"}, "did you mean slip"),
        ({"ball_speed": 70.0}, {"model": "fem"}, "thousands of deliveries a second: response, standard"),
        ({"ball_speed": 70.0}, {"prior": Prior(name="x", mean={"speed": 50.0, "toe": 9.0},
                                               deviation={"speed": 1.0, "toe": 0.001})}, "can compute"),
    ],
)  # fmt: skip
def test_errors_of_users_name_what_is_allowed(launch, options, words_of_error):
    with pytest.raises(InputError, match=words_of_error):
        infer(launch, club="driver", **options)


def test_draws_become_shots_that_can_be_predicted(inferred, tmp_path):
    inferred.shots().write(tmp_path / "draws.csv")
    again = clubface.read_shots(tmp_path / "draws.csv")
    assert len(again) == 2000
    assert again.deliveries["loft"] == pytest.approx(inferred.deliveries["loft"], rel=1e-12)
    assert list(inferred.to_pandas().columns) == list(inferred.names)


def test_the_picture_is_drawn(inferred, tmp_path):
    pytest.importorskip("matplotlib")
    from clubface.present.drawing import draw

    picture = pairs_picture(inferred, truth=inferred.mean)
    drawn = [panel.x.label for panel in picture.rows[-1]]
    assert drawn == ["speed", "attack", "path", "loft", "face", "toe", "high"]
    assert len(draw(picture).axes) == 49


def test_a_posterior_is_a_result_with_all_its_numbers(inferred):
    document = inferred.to_dict()
    rows = {row["quantity"]: row for row in document["tables"]["deliveries"]["rows"]}
    assert rows["loft"]["mean"] == pytest.approx(inferred.mean["loft"] / DEG, rel=1e-14)
    assert (rows["loft"]["low"], rows["loft"]["high"]) == pytest.approx(
        tuple(np.array(inferred.interval("loft")) / DEG)
    )
    measured = {row["quantity"]: row for row in document["tables"]["measured"]["rows"]}
    assert measured["backspin"]["value"] == pytest.approx(2900.0)
    assert document["values"]["effective"] == inferred.effective
    assert inferred.to_pandas("measured")["reproduced"].tolist() == list(inferred.reproduced.values())


def test_samples_and_confidences_are_taken_to_their_ends(inferred):
    for samples in (1, 100_000):
        assert Inference(club="driver", model="slip", samples=samples) is not None
    for samples in (0, 100_001, True, 10.0):
        with pytest.raises(InputError, match=r"samples is .*1 to 100000"):
            Inference(club="driver", model="slip", samples=samples)
    (low, high), (within_low, within_high) = (inferred.interval("speed", each) for each in (0.999, 0.001))
    assert low < within_low < inferred.mean["speed"] + inferred.deviation["speed"]
    assert low < within_low <= within_high < high
    for confidence in (0.0, 1.0):
        with pytest.raises(InputError, match=r"confidence is [01].0.*between 0 and 1"):
            inferred.interval("speed", confidence)
    # Half of the draws of the speed lie in the interval of 0.5, and a quarter on either side of it.
    low, high = inferred.interval("speed", 0.5)
    speeds = inferred.deliveries["speed"]
    assert [np.mean(speeds < low), np.mean(speeds > high)] == pytest.approx([0.25, 0.25], abs=2e-3)
