"""Mishits: one topped drive is named and moves nothing, and neither wide scatter nor two kinds of swings make one."""

import numpy as np
import pytest

from clubface import shots as launch_monitor
from clubface.shots.mishits import FARTHEST, find_mishits, is_mishit, statistic
from clubface.shots.session_summary import session_picture, session_result, summarize_clubs

YD, MPH, DEG = 0.9144, 0.44704, np.pi / 180
CARRIES = [228, 231, 224, 235, 229, 226, 233, 230, 227]
"""Of nine drives [yd]."""


def drives(topped, club="Driver"):
    """Drives as a file has them; a topped one carries 38 yd."""
    rows = [f"{club},{150 + 0.1 * (carry - 229):.2f},12,{carry},{place}" for place, carry in enumerate(CARRIES)]
    return [*rows, f"{club},71,1.5,38,-5"] if topped else rows


@pytest.fixture
def read(write):
    def shots(*lines):
        return launch_monitor.read(write("\n".join(["club,ball_speed_mph,launch_deg,carry_yd,side_yd", *lines]) + "\n"))

    return shots


def test_a_topped_drive_is_named_with_its_line_and_reasons(read):
    (driver,) = summarize_clubs(read(*drives(topped=True)))
    assert driver.mishit_places == [9]
    reasons = {each.quantity: (each.value, each.median) for each in driver.mishits}
    assert set(reasons) == {"ball_speed", "carry", "launch"}
    assert reasons["carry"] == pytest.approx((38 * YD, 228.5 * YD), rel=1e-14)
    rows = session_result(read(*drives(topped=True))).table("mishits").records()
    assert {(row["line"], row["club"]) for row in rows} == {(11, "Driver")}


def test_a_topped_drive_changes_no_median_spread_or_gap(read):
    """All figures but those of all shots are bit for bit those of the file without it."""
    irons = [f"7i,118,18,{carry},0" for carry in (150, 152, 155, 149, 151)]
    clean, topped = (summarize_clubs(read(*drives(each), *irons))[0] for each in (False, True))
    assert topped.gap == clean.gap
    for name, each in clean.spreads.items():
        assert topped.spreads[name][:5] == each[:5], name
    assert topped.spreads["carry"].measured == 10
    assert topped.spreads["carry"].mean == pytest.approx((sum(CARRIES) + 38) / 10 * YD, rel=1e-14)


def test_the_limit_is_that_of_normally_distributed_shots():
    """1.4826 n / (n - 0.8) times the median absolute deviation is their standard deviation, to 3% from five shots on.

    Of 2000 normal samples its mean is known to a half per cent; the correction itself leaves 2 to 3% at five and six.
    """
    random = np.random.default_rng(2)
    for count in (5, 6, 10, 40):
        values = random.standard_normal((2000, count))
        off = np.median(np.abs(values - np.median(values, axis=1)[:, None]), axis=1)
        assert 1.4826 * count / (count - 0.8) * off.mean() == pytest.approx(1.0, abs=0.045)
        # A shot just outside of the limit of its own sample is one, and one just inside is none.
    carries = np.array([200.0, 180.0, 220.0, 190.0, 210.0, 200.0, 200.0])
    robust = 1.4826 * 7 / 6.2 * 10.0  # the median of 0, 20, 20, 10, 10, 0, x is 10 for any far x
    for inside, x in ((True, 200.0 - 0.99 * FARTHEST * robust), (False, 200.0 - 1.01 * FARTHEST * robust)):
        carries[-1] = x
        assert (find_mishits({"carry": carries}) == []) == inside


def test_shots_that_scatter_as_a_golfer_does_are_hardly_ever_mishits():
    """Normal shots lie beyond 3.5 standard deviations once in two thousand; robust ones of ten shots scatter more."""
    random = np.random.default_rng(3)
    values = [{"carry": random.normal(200, 9, 10), "launch": random.normal(0.2, 0.035, 10)} for _ in range(500)]
    assert sum(len({mishit.place for mishit in find_mishits(each)}) for each in values) < 0.01 * 5000


@pytest.mark.parametrize(
    "values",
    [
        {"carry": [200.0, 200.0, 200.0, 200.0, 199.0, 200.0]},
        {"launch": [0.2, 0.2, 0.2, 0.2, 0.2, 0.2 + 5 * DEG]},
        {"carry": [200.0, 201.0, 199.0, 202.0, 198.0, 260.0]},
        {"carry": [100.0, 101.0, 99.0, 102.0, 98.0, 100.5, 50.0, 51.0, 49.0, 52.0]},
        {"carry": [200.0, 201.0, 199.0, 38.0]},
    ],
    ids=["alike but for a yard", "alike but for 5 degrees", "a long drive", "full and half swings", "too few shots"],
)
def test_these_shots_have_no_mishit(values):
    assert find_mishits({name: np.array(each) for name, each in values.items()}) == []


def test_one_half_swing_or_skied_shot_among_full_swings_is_a_mishit():
    assert len(find_mishits({"carry": np.array([100.0, 101.0, 99.0, 102.0, 98.0, 100.5, 50.0])})) == 1
    (skied,) = find_mishits({"launch": np.full(6, 0.2) + np.array([0, 0, 0, 0, 0, 20 * DEG])})
    assert (skied.place, skied.quantity) == (5, "launch")


def test_a_quantity_only_the_mishit_has_is_taken_from_the_mishit():
    values = np.array([200.0, 201.0, 199.0, 202.0, 38.0])
    mask = is_mishit(find_mishits({"carry": values}), 5)
    assert mask.tolist() == [False] * 4 + [True]
    only = statistic(np.array([np.nan] * 4 + [7.0]), mask)
    assert only is not None
    assert (only.shots, only.median) == (1, 7.0)


def test_two_of_three_shots_lie_between_low_and_high():
    result = statistic(np.arange(13.0))
    assert result is not None
    assert (result.low, result.high, result.shots) == (2.0, 10.0, 13)
    assert statistic(np.array([np.nan])) is None


def test_the_error_of_a_median_is_that_of_normal_shots():
    """Of 25 normal shots: sampled 4000 times, its standard deviation is known to 1%; the law of many shots to 2%."""
    medians = np.median(np.random.default_rng(4).standard_normal((4000, 25)), axis=1)
    expected = np.sqrt(np.pi / 2 / 25)
    assert medians.std() == pytest.approx(expected, rel=0.04)
    spread_one = statistic(np.concatenate([np.linspace(-2, 2, 25)]))
    assert spread_one is not None
    assert spread_one.error == pytest.approx(expected * spread_one.spread, rel=1e-14)


def test_mishits_are_grey_in_the_picture_and_outside_of_the_ellipse(read):
    shots = read(*drives(topped=True))
    landings, carries = session_picture(shots, summarize_clubs(shots)).panels()
    for panel in (landings, carries):
        (grey,) = (mark for mark in panel.marks if mark.kind == "points" and mark.style == -1)
        np.testing.assert_allclose(grey.y, [38 * YD], rtol=1e-14)
    (ellipse,) = (mark for mark in landings.marks if mark.kind == "outline")
    assert min(ellipse.y) > 220 * YD
    assert carries.marks[0].y == pytest.approx([229 * YD], rel=1e-14)
