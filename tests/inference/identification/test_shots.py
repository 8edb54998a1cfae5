"""Shots that an identification cannot use, or only with a remark: too few, alike, incomplete, of another club."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface.errors import InputError
from clubface.shots.recorded import RecordedShots
from synthetic_shots import deliveries, recorded

QUICK = {"population": 30, "generations": 8, "refined": 3, "folds": 0, "bootstrap": 0, "profiles": ()}
SMALL = {
    "club": "driver", "model": "slip", "free": ["cor", "slip_y", "slip_z"], "population": 10, "generations": 4,
    "refined": 2, "folds": 3, "bootstrap": 6, "seed": 3,
}  # fmt: skip


def edited(shots, **changes):
    deliveries_, launches = dict(shots.deliveries), dict(shots.launches)
    for name, values in changes.items():
        (deliveries_ if name in deliveries_ else launches)[name] = np.asarray(values, dtype=float)
    return RecordedShots(
        deliveries=deliveries_, launches=launches, rows=shots.rows, source=shots.source, format=shots.format
    )


def test_rows_without_a_number_are_left_out_with_their_reason():
    shots = recorded(10, "slip", noise=1.0)
    speed, backspin = shots.deliveries["speed"].copy(), shots.launches["backspin"].copy()
    speed[2] = np.nan
    backspin[4] = np.nan
    toe = shots.deliveries["toe"].copy()
    toe[7] = 0.2
    result = clubface.identify(edited(shots, speed=speed, backspin=backspin, toe=toe), **{**SMALL, "free": "slip_y"})
    assert result.shots == 8
    assert [each.line for each in result.dropped] == [4, 9]
    assert "speed" in result.dropped[0].reason
    assert "face outline" in result.dropped[1].reason
    with pytest.raises(InputError, match="speed"):
        clubface.identify(edited(shots, speed=np.full(10, np.nan)), **SMALL)
    nothing = dict.fromkeys(shots.launches, np.full(10, np.nan))
    with pytest.raises(InputError, match="launch"):
        clubface.identify(edited(shots, **nothing), **SMALL)


def test_the_mirror_image_of_shots_by_a_left_hander_gives_the_same_parameters():
    """Path, face angle, azimuth and sidespin change sign; toe, closure and lie follow the club."""
    right = recorded(15, "adjusted", noise=1.0)
    left = edited(
        right, path=-right.deliveries["path"], face=-right.deliveries["face"], azimuth=-right.launches["azimuth"],
        sidespin=-right.launches["sidespin"], spin_axis=-right.launches["spin_axis"],
    )  # fmt: skip
    left = replace(left, hand=np.array(["left"] * 15, dtype=object))
    one, other = (clubface.identify(each, club="driver", model="adjusted", **QUICK) for each in (right, left))
    # The same sums in another order.
    assert other.cost == pytest.approx(one.cost, rel=1e-9)
    for name in one.free:
        assert other.parameters.values[name] == pytest.approx(one.parameters.values[name], rel=1e-6, abs=1e-10)


def test_a_quantity_that_was_not_measured_is_left_out_with_a_note():
    shots = recorded(10, "slip", noise=1.0)
    result = clubface.identify(edited(shots, azimuth=np.full(10, np.nan)), **SMALL)
    assert list(result.deviations) == ["ball_speed", "launch", "backspin", "sidespin"]
    assert ("not-in-the-cost", {"names": ["azimuth"]}) in result.notes


def test_shots_of_a_player_are_left_out_and_drawn_together():
    """Every shot four times: as independent shots they look twice as certain as they are."""
    one = recorded(12, "slip", noise=1.0)
    four = one.select(np.repeat(np.arange(12), 4))
    options = {**SMALL, "free": ["slip_y", "slip_z"], "bootstrap": 80, "folds": 12, "profiles": ()}
    single, loose = clubface.identify(one, **options), clubface.identify(four, **options)
    grouped = clubface.identify(four, groups=np.repeat(np.arange(12), 4), **options)
    width = {name: np.ptp(result.intervals["slip_y"]) for name, result in
             (("single", single), ("loose", loose), ("grouped", grouped))}  # fmt: skip
    # Half of sqrt(4), up to the scatter of 80 samples.
    assert 0.3 < width["loose"] / width["single"] < 0.75
    assert grouped.intervals["slip_y"] == pytest.approx(single.intervals["slip_y"], rel=1e-3)
    assert grouped.cost_holdout > loose.cost_holdout
    with pytest.raises(InputError, match="one for each shot"):
        clubface.identify(one, groups=[1, 2], **options)


def test_one_shot_is_refused_with_what_it_leaves_undetermined():
    with pytest.raises(InputError, match=r"number of shots is 1;.*two"):
        clubface.identify(recorded(1, "slip"), **SMALL)
    shots = recorded(1, "volumetric")
    with pytest.raises(InputError, match=r"It does not determine: .*transition_speed"):
        clubface.identify(shots, club="driver", model="volumetric", **QUICK)


def test_copies_of_one_shot_are_one_shot():
    """They would give intervals of no width."""
    shots = recorded(1, "slip", noise=1.0).select(np.zeros(20, dtype=int))
    with pytest.raises(InputError, match=r"number of different ones among 20 shots is 1;.*two"):
        clubface.identify(shots, **SMALL)
    single = recorded(1, "volumetric")
    open_ = []
    for shots in (single, single.select(np.zeros(20, dtype=int))):
        with pytest.raises(InputError, match=r"does not determine: .*transition_speed") as refused:
            clubface.identify(shots, club="driver", model="volumetric", **QUICK)
        open_.append(str(refused.value).partition("does not determine")[2])
    assert open_[0] == open_[1]
    doubled = recorded(12, "slip", noise=1.0).select(np.repeat(np.arange(12), 2))
    assert ("fit-copied-shots", {"different": 12, "shots": 24}) in clubface.identify(doubled, **SMALL).notes
    assert "fit-copied-shots" not in {each.code for each in clubface.identify(recorded(12, "slip"), **SMALL).notes}


@pytest.mark.parametrize("count", [2, 4, 9])
def test_intervals_of_few_shots_hold_the_fit_and_what_the_noise_makes_of_it(count):
    """Two shots can be drawn in three ways: samples alone say nothing."""
    shots = recorded(count, "slip", noise=1.0)
    with_samples, without = (clubface.identify(shots, **{**SMALL, "bootstrap": samples}) for samples in (20, 0))
    for name, (low, high) in with_samples.intervals.items():
        least, most = without.intervals[name]
        assert low <= least < with_samples.parameters.values[name] < most <= high


def test_shots_that_are_all_the_same_say_what_they_leave_open():
    one = {name: np.repeat(values[:1], 30) for name, values in deliveries(1).items()}
    one["toe"][:], one["path"][:], one["face"][:] = 0.01, 0.05, 0.0
    shots = recorded(30, "volumetric", noise=1.0, delivery=one)
    with pytest.raises(
        InputError, match=r"at most 5.*all 30 shots have the same delivery.*Not determined: .*stiffness"
    ):
        clubface.identify(shots, club="driver", model="volumetric", **QUICK)
    result = clubface.identify(shots, club="driver", model="volumetric", free=["damping", "friction"], **QUICK)
    assert "fit-same-delivery" in {each.code for each in result.notes}


def test_more_parameters_than_information_are_refused():
    shots = recorded(2, "volumetric")
    with pytest.raises(InputError, match=r"at most 4"):
        clubface.identify(shots, club="driver", model="volumetric", quantities=["ball_speed", "launch"], **QUICK)
