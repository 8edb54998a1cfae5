"""What the study of the benchmark shots is made of: implied biases, error budgets, one set for all clubs, resuming."""

import math

import benchmark_findings as findings
import numpy as np
import pytest
from benchmark_findings import (
    bias_of,
    bias_of_magnitudes,
    effect_sizes,
    error_budget,
    extrapolated,
    mean_magnitude,
)

import clubface
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.errors import FileError
from clubface.inference.evaluation import published
from clubface.shots.measured import QUANTITIES
from clubface.validation import benchmark_data, tour
from clubface.validation.benchmark_data import recipe

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

DEG = math.pi / 180


def test_the_mean_magnitude_of_a_normal_error_is_that_of_a_sample():
    errors = np.random.default_rng(0).normal(0.7, 0.5, 1_000_000)
    # A million draws: the standard error of the mean magnitude is 0.0005; five of these.
    assert mean_magnitude(0.7, 0.5) == pytest.approx(np.abs(errors).mean(), abs=0.0025)
    assert mean_magnitude(0.0, 2.0) == pytest.approx(2.0 * math.sqrt(2 / math.pi), rel=1e-14)


@pytest.mark.parametrize("bias", [0.2, 0.7, 3.0])
def test_a_bias_is_recovered_from_its_published_error_and_deviation(bias):
    errors = np.random.default_rng(1).normal(bias, 0.5, 1_000_000)
    # Small biases hardly change the mean magnitude: 0.0005 of it are some 0.003 of a bias of 0.2.
    assert bias_of(mean_magnitude(bias, 0.5), 0.5) == pytest.approx(bias, rel=1e-9)
    magnitudes = np.abs(errors)
    assert bias_of_magnitudes(magnitudes.mean(), magnitudes.std()) == pytest.approx(bias, abs=0.02)


def test_no_bias_is_implied_where_tails_are_heavy():
    assert bias_of(0.5, 1.0) == 0.0
    assert bias_of_magnitudes(0.5, 1.0) == 0.0


def test_the_published_azimuth_errors_are_nearly_all_bias_however_their_spread_is_read():
    for (model, _), given in published().items():
        if given.std:
            pair = (given.mae["azimuth"], given.std["azimuth"])
            for read in (bias_of, bias_of_magnitudes):
                assert read(*pair) > 0.85 * given.mae["azimuth"], model


def test_parts_of_the_error_are_what_they_are_called():
    shots = benchmark_data.load("7-iron")
    parameters = ParameterSet.builtin("slip", "7-iron")
    budget = error_budget(shots, parameters)
    monitor = np.abs(shots.measured.launches["backspin"] - shots.truth.launches["backspin"]).mean()
    assert budget["monitor"]["backspin"] == pytest.approx(monitor, rel=1e-14)
    everything = clubface.evaluate(shots.measured, models="slip", ball=published_ball()).sizes
    for name in QUANTITIES:
        assert budget["all"][name] == pytest.approx(everything[name]["slip"].mae, rel=1e-14)
        # Independent parts add up in squares, at most in magnitudes.
        assert budget["all"][name] < sum(budget[part][name] for part in ("model", "capture", "monitor"))
        assert budget["extrapolation"][name] < budget["capture"][name]


@pytest.mark.parametrize("club", benchmark_data.CLUBS)
def test_the_sizes_of_the_effects_are_those_the_recipe_gives_them(club):
    shots, mixture = benchmark_data.load(club), recipe(club)
    sizes = effect_sizes(shots)
    # Ball speed changes with restitution e as v M / (M + m) with the effective masses; at the centre of these heads
    # M / (M + m) is 0.8, and off it less. Mean magnitude of a normal scatter: 0.8 of its deviation.
    speed = np.mean(shots.truth.deliveries["speed"])
    scatter = math.sqrt(2 / math.pi) * mixture.ball_scatter * speed * np.cos(np.mean(shots.truth.deliveries["loft"]))
    assert sizes["ball"]["ball_speed"] == pytest.approx(0.8 * scatter, rel=0.1)
    distance = np.hypot(shots.truth.deliveries["toe"], shots.truth.deliveries["high"]) / mixture.flex_radius
    ratio = mixture.flex_drop * np.mean(distance**2) / (math.sqrt(2 / math.pi) * mixture.ball_scatter)
    assert sizes["face"]["ball_speed"] / sizes["ball"]["ball_speed"] == pytest.approx(ratio, rel=0.1)
    # Five grams at the hosel move the CG towards the heel, which with a driver turns the axis of its gear effect.
    assert sizes["shaft"]["sidespin"] > 10 * sizes["ball"]["sidespin"]


def test_lines_through_frames_without_noise_miss_only_by_the_arc():
    shots = benchmark_data.load("driver")
    lines = extrapolated(shots)
    face = lines["face"] - shots.truth.deliveries["face"]
    # Half of 1000 rad/s2 over at most 1.4 and 2.8 ms: 0.11 degrees; the growth scatters as much.
    assert np.abs(face).max() < 0.5 * DEG
    assert 0.02 * DEG < face.mean() < 0.08 * DEG


def test_one_set_for_all_clubs_is_better_than_the_published_ones_and_launches_as_published():
    result = findings.fit("slip")
    before = findings.Bag(tour.averages(findings.SEASON))
    published_set = ParameterSet(
        model="slip", club="any", name="x", values=ParameterSet.builtin("slip", "7-iron").values
    )
    assert before.misfit(result.parameters) < 0.5 * before.misfit(published_set)
    solved = np.isnan(result.errors["launch"])
    assert solved.sum() == 10
    launch = before.strike(result.lofts, result.parameters).launch
    # Eight steps, each of which leaves less than a quarter of the 0.1 rad that were missing: 1.5e-6.
    assert np.abs(launch - before.launch)[solved].max() < 2e-6
    # A club alone, with its own values, is launched as in the batch.
    place = result.clubs.index("9-iron")
    average = tour.averages(findings.SEASON)[place]
    alone = clubface.impact(
        "9-iron", speed=average.club_speed, attack=average.attack, loft=float(result.lofts[place]), model="slip",
        parameters=result.parameters, ball=published_ball(),
    )  # fmt: skip
    assert alone.total_spin - average.spin == pytest.approx(result.errors["spin"][place], rel=1e-9)
    assert clubface.fly(alone).carry - average.carry == pytest.approx(result.carry[place], rel=1e-9)


def test_a_club_left_out_has_no_part_in_its_own_prediction():
    result = findings.fit("standard")
    # One parameter, restitution: without the driver, which is the livest, the others ask for less of it.
    driver = result.clubs.index("driver")
    assert result.left_out["ball_speed"][driver] < result.errors["ball_speed"][driver]
    assert result.mean_absolute_error("ball_speed", left_out=True) > result.mean_absolute_error("ball_speed")


def test_a_study_is_resumed_and_keeps_what_was_finished(tmp_path, monkeypatch):
    calls = []

    def quick(shots, *, model, checkpoint, resume, **options):
        calls.append((options["club"], model))
        if calls[-1] == ("7-iron", "slip") and calls.count(("7-iron", "slip")) == 1:
            raise KeyboardInterrupt
        small = {"population": 8, "generations": 2, "refined": 1, "bootstrap": 4, "profiles": ()}
        return clubface.identify(shots, model=model, **{**options, **small})

    monkeypatch.setattr(findings, "identify", quick)
    monkeypatch.setattr(findings, "MODELS", ("adjusted", "slip"))
    monkeypatch.setattr(findings, "FREE", {"standard": findings.FREE["standard"]})
    monkeypatch.setattr(findings, "RESAMPLES", 200)
    evaluate = findings.evaluate
    monkeypatch.setattr(findings, "evaluate", lambda *a, **o: evaluate(*a, **{**o, "resamples": 200}))
    with pytest.raises(KeyboardInterrupt):
        findings.run(tmp_path)
    result = findings.run(tmp_path)
    # Only what was interrupted was computed twice.
    driver = "driver-as-printed"
    assert calls == [
        (driver, "adjusted"), ("7-iron", "adjusted"), (driver, "slip"), ("7-iron", "slip"), ("7-iron", "slip"),
        # On the shots that they made themselves.
        (driver, "adjusted"), (driver, "slip"), ("7-iron", "adjusted"), ("7-iron", "slip"),
    ]  # fmt: skip
    assert findings.run(tmp_path) == result
    monkeypatch.setattr(findings, "BOOTSTRAP", {"rings": 7})
    with pytest.raises(FileError, match="begun with another bootstrap"):
        findings.run(tmp_path)
    fits = result["clubs"]["7-iron"]["fits"]
    assert set(fits) == {"adjusted", "slip"}
    own = result["clubs"]["driver"]["own"]["slip"]
    assert own["shots"] == (benchmark_data.load("driver").model == "slip").sum()
    assert own["true"]["slip_y"] == ParameterSet.builtin("slip", "driver").values["slip_y"]
    held = result["clubs"]["7-iron"]["held_out"]
    costs = {name: each["cost_holdout"] for name, each in fits.items()}
    best = min(costs, key=lambda name: costs[name])
    assert held[best]["more"] == 0.0
    (other,) = set(costs) - {best}
    # The mean of the shares of the shots is the published cost.
    assert held[other]["more"] == pytest.approx(costs[other] - costs[best], abs=1e-7)
    assert held[other]["interval"][0] <= held[other]["more"] <= held[other]["interval"][1]


@pytest.mark.parametrize(
    ("model", "speed", "spin"), [("slip", 2.4, 610), ("volumetric", 2.2, 640), ("rings", 1.6, 300)]
)
def test_the_sets_for_all_clubs_that_are_shipped_have_the_errors_they_state(model, speed, spin):
    shipped = ParameterSet.builtin(model, "any", "tour-averages")
    errors, _ = findings.Bag(tour.averages(findings.SEASON)).errors(shipped)
    # Half of the last digit stated.
    assert np.abs(errors["ball_speed"]).mean() / 0.44704 == pytest.approx(speed, abs=0.051)
    assert np.abs(errors["spin"]).mean() * 30 / math.pi == pytest.approx(spin, abs=10)
    assert f"{speed} mph and spin to {spin} rpm" in shipped.caveats[0]
