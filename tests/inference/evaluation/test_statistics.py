"""Sizes of errors, their intervals and the comparison of models, against hand-worked figures and known rates."""

import math

import numpy as np
import pytest

from clubface.inference.evaluation.statistics import (
    Resamples,
    _students_t,
    best_of,
    error_sizes,
    holm,
    interval,
    trends,
)


def test_sizes_of_errors_are_those_worked_by_hand():
    # Errors -1, 2, 0, 4, -5: mean 0, mean magnitude 12/5, squares 46: STD sqrt(46/4), rms sqrt(46/5).
    error = np.array([-1.0, 2.0, 0.0, 4.0, -5.0])
    sizes, best = error_sizes({"one": error, "two": 3 * error}, Resamples(500, 5, 0, None))
    one = sizes["one"]
    assert (one.shots, one.bias, one.mae, one.worst) == (5, 0.0, pytest.approx(2.4), 5.0)
    assert one.std == pytest.approx(math.sqrt(11.5), rel=1e-14)
    assert one.rms == pytest.approx(math.sqrt(9.2), rel=1e-14)
    assert best.model == "one"
    assert best.rivals[0].difference == pytest.approx(4.8)
    # Every resample has its errors three times over: the lead over a resample is twice its own mean error.
    assert best.rivals[0].interval == pytest.approx([2 * each for each in one.mae_interval])


def test_an_interval_is_as_wide_as_the_normal_one():
    values = np.random.default_rng(1).normal(0.0, 2.0, 400)
    low, high = interval(Resamples(4000, 400, 0, None).means(values[None])[:, 0], 400)
    half = 1.96 * values.std() / math.sqrt(values.size)
    # 4000 resamples know a 2.5 % quantile to some 3 % of the half-width.
    assert (low, high) == pytest.approx((values.mean() - half, values.mean() + half), abs=0.1 * half)


@pytest.mark.parametrize("degrees", [2, 4, 11, 23, 400])
def test_the_quantile_of_students_t_is_the_tabulated_one(degrees):
    stats = pytest.importorskip("scipy.stats")
    exact = float(stats.t.ppf(0.975, degrees))
    # Four terms of a series in 1 / degrees: the next one is some 1 / degrees^4 of the whole.
    assert _students_t(float(stats.norm.ppf(0.975)), degrees) == pytest.approx(exact, rel=1.0 / degrees**4)


def test_intervals_of_few_shots_hold_the_mean_nearly_as_often_as_stated():
    random, hold = np.random.default_rng(8), 0
    for seed in range(400):
        values = random.standard_normal((1, 8))
        low, high = interval(Resamples(400, 8, seed, None).means(values)[:, 0], 8)
        hold += low < 0.0 < high
    # Percentiles alone hold it 88 % of the time, these 94 %, with a standard deviation of 1.2 %.
    assert hold / 400 == pytest.approx(0.94, abs=0.036)


@pytest.mark.parametrize(("shots", "significant"), [(1, False), (2, False), (5, False), (6, True), (20, True)])
def test_few_shots_are_no_evidence_however_clear_they_look(shots, significant):
    error = 1.0 + 1e-3 * np.arange(shots)
    _, best = error_sizes({"one": error, "two": 3.0 * error}, Resamples(1000, shots, 0, None))
    # All of n shots favour one of two models in 2 of 2^n changes of sign: 0.0625 for five, 0.031 for six.
    assert best.rivals[0].is_worse is significant
    assert best.rivals[0].p == pytest.approx(max(2.0 ** (1 - shots), 2 / 1001))


def test_copies_of_a_shot_tell_no_more_than_the_shot():
    error = np.full(30, 2.0)
    sizes, best = error_sizes({"one": error, "two": 3.0 * error}, Resamples(300, 30, 0, None))
    assert np.isnan([*sizes["one"].mae_interval, *sizes["one"].bias_interval, *best.rivals[0].interval]).all()
    assert best.equals == ("two",)


def test_shots_of_one_player_count_once_where_they_are_groups():
    values = np.random.default_rng(2).standard_normal((1, 60))
    alone = interval(Resamples(4000, 60, 0, None).means(values)[:, 0], 60)
    copied, players = np.repeat(values, 5, axis=1), np.repeat(np.arange(60), 5)
    together = interval(Resamples(4000, 300, 0, players).means(copied)[:, 0], 60)
    assert together == pytest.approx(alone, rel=1e-12)
    narrow = interval(Resamples(4000, 300, 0, None).means(copied)[:, 0], 60)
    # Taken as 300 shots they would seem sqrt(5) times as sure; 10 % for the scatter of quantiles.
    assert (alone.high - alone.low) / (narrow.high - narrow.low) == pytest.approx(math.sqrt(5), rel=0.1)


def test_resamples_that_are_too_many_to_be_kept_are_the_same_when_drawn_again(monkeypatch):
    values = np.random.default_rng(0).standard_normal((2, 50))
    kept = Resamples(300, 50, 7, None).means(values)
    monkeypatch.setattr("clubface.inference.evaluation.statistics._KEPT", 0)
    assert np.array_equal(Resamples(300, 50, 7, None).means(values), kept)


def test_probabilities_are_corrected_as_holm_did():
    # Smallest times 3, next times 2, largest times 1, never falling: 0.01, 0.03, 0.04.
    assert holm([0.01, 0.04, 0.03]) == pytest.approx([0.03, 0.06, 0.06])
    assert holm([0.6, 0.7]) == [1.0, 1.0]
    assert holm([]) == []


def test_equal_models_are_distinguished_as_rarely_as_stated():
    random = np.random.default_rng(4)
    result = 0
    for seed in range(200):
        errors = {"one": random.standard_normal(80), "two": random.standard_normal(80)}
        resampled = Resamples(400, 80, seed, None).means(np.abs(np.stack(list(errors.values()))))
        best = best_of({name: float(np.abs(each).mean()) for name, each in errors.items()},
                       dict(zip(errors, resampled.T, strict=True)), 80)  # fmt: skip
        result += best.rivals[0].is_worse
    # 5 % of 200 are 10, with a standard deviation of 3.1; the bootstrap of 80 shots is a little too sure of itself.
    assert 2 <= result <= 21


def test_a_model_is_not_worse_than_its_twin():
    error = np.random.default_rng(5).standard_normal(50)
    _, best = error_sizes({"one": error, "two": error.copy()}, Resamples(500, 50, 0, None))
    assert best.rivals[0].p == 1.0
    assert best.equals == ("two",)


def test_a_trend_is_the_least_squares_line_of_the_errors():
    random = np.random.default_rng(6)
    delivery = {"speed": random.normal(50, 2, 300), "toe": random.normal(0, 5e-3, 300), "path": np.full(300, 0.1)}
    lines = trends({"one": 3.0 + 0.25 * delivery["speed"]}, delivery, Resamples(500, 300, 0, None))["one"]
    by_name = {each.covariate: each for each in lines}
    assert set(by_name) == {"speed", "toe"}, "what does not vary has no line"
    assert by_name["speed"].slope == pytest.approx(0.25, rel=1e-12)
    assert by_name["speed"].interval == pytest.approx((0.25, 0.25), rel=1e-9)
    assert by_name["speed"].explained == pytest.approx(1.0, rel=1e-12)
    assert by_name["speed"].is_clear
    assert not by_name["toe"].is_clear
    assert by_name["toe"].explained < 0.05
