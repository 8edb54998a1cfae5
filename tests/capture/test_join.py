"""Captured deliveries and a monitor's launches of the same shots, paired although each lacks some."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import clubface
from attached_notes import noted
from clubface.capture.swing import ALONE, _aligned, join
from clubface.errors import InputError
from clubface.shots.recorded import RecordedShots, RejectedRow
from command_line import assert_mistake
from synthetic_shots import recorded


def both(count=30, seed=0):
    """Return what capture and what a monitor makes of the same shots: it errs by 0.3 m/s and 0.3 degrees."""
    whole = recorded(count, "slip", seed=seed)
    rng = np.random.default_rng(seed)
    launch = whole.launches
    seen = {"ball_speed": launch["ball_speed"], "launch": launch["launch"], "azimuth": launch["azimuth"]}
    captured = RecordedShots(
        deliveries=whole.deliveries,
        launches=seen,
        rows=np.arange(2, count + 2),
        source="captured.csv",
        format="clubface",
    )
    errors = {"ball_speed": 0.3, "launch": 0.005, "azimuth": 0.005, "backspin": 5.0, "sidespin": 5.0}
    launches = {name: launch[name] + error * rng.standard_normal(count) for name, error in errors.items()}
    launches["azimuth"] = launches["azimuth"] + np.radians(1.0)
    names = np.array(["Driver"] * count, dtype=object)
    measured = RecordedShots(
        deliveries={}, launches=launches, clubs=names, rows=np.arange(101, count + 101), source="session.csv",
        format="trackman", rejected=(RejectedRow(99, "the ball speed is 0"),),
    )  # fmt: skip
    return captured, measured


def test_shots_that_both_have_are_paired_and_the_others_named():
    captured, measured = both()
    kept_one = np.setdiff1d(np.arange(30), [0, 7, 8, 20])
    kept_other = np.setdiff1d(np.arange(30), [3, 8, 29])
    shots = join(captured.select(kept_one), measured.select(kept_other))
    common = np.intersect1d(kept_one, kept_other)
    assert (shots.rows - 2).tolist() == common.tolist()
    assert np.array_equal(shots.deliveries["loft"], captured.deliveries["loft"][common])
    assert np.array_equal(shots.launches["backspin"], measured.launches["backspin"][common])
    assert shots.clubs is not None
    assert shots.clubs.tolist() == ["Driver"] * len(shots)
    assert [each.line for each in shots.rejected] == [5, 31, 99, 101, 108, 121]
    assert shots.rejected[0].reason == "captured.csv: not in session.csv"
    assert shots.rejected[2].reason == "session.csv: the ball speed is 0"
    assert ("paired-by-values", {"quantities": ["ball_speed", "launch"]}) in shots.notes
    # 1 degree, to the error of the median of 26.
    (turned,) = noted(shots, "target-lines-differ")
    assert turned["azimuth"] == pytest.approx(np.radians(1.0), abs=np.radians(0.2))


def test_a_launch_quantity_that_the_monitor_lacks_is_that_of_the_cameras():
    captured, measured = both()
    del measured.launches["azimuth"]
    measured.launches["launch"][:] = np.nan  # a column without a value
    shots = join(captured, measured)
    assert np.array_equal(shots.launches["azimuth"], captured.launches["azimuth"])
    assert np.array_equal(shots.launches["launch"], captured.launches["launch"])
    assert np.array_equal(shots.launches["ball_speed"], measured.launches["ball_speed"])
    assert noted(shots, "launches-of-captured") == [{"quantities": ["launch", "azimuth"], "captured": "captured.csv"}]
    # One that the monitor lacks for a single shot stays unknown: the lines to the target differ.
    captured, measured = both()
    measured.launches["azimuth"][3] = np.nan
    shots = join(captured, measured)
    assert np.flatnonzero(np.isnan(shots.launches["azimuth"])).tolist() == [3]
    assert not noted(shots, "launches-of-captured")


def test_joined_shots_identify_what_made_them():
    captured, measured = both(40)
    shots = join(captured.select(np.arange(1, 40)), measured.select(np.arange(39)))
    result = clubface.identify(
        shots,
        club="driver",
        model="slip",
        free=["slip_y", "slip_z"],
        population=10,
        generations=3,
        folds=0,
        bootstrap=0,
    )
    assert result.shots == 38
    for name in result.free:
        low, high = result.profiles[name].interval
        # Three times the 95% interval about the truth: the azimuth is turned by a degree.
        truth = clubface.ParameterSet.builtin("slip", "driver").values[name]
        assert abs(result.parameters.values[name] - truth) < 1.5 * (high - low)


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1), st.integers(1, 6), st.integers(1, 6))
def test_the_alignment_costs_no_more_than_any_other(seed, rows, columns):
    rng = np.random.default_rng(seed)
    costs = np.where(rng.random((rows, columns)) < 0.3, np.inf, rng.random((rows, columns)))

    def least(row, column):
        if row == rows or column == columns:
            return ALONE * (rows - row + columns - column)
        paired = costs[row, column] + least(row + 1, column + 1)
        return min(paired, ALONE + least(row + 1, column), ALONE + least(row, column + 1))

    pairs = _aligned(costs)
    assert (np.diff(pairs, axis=0) > 0).all()
    total = costs[pairs[:, 0], pairs[:, 1]].sum() + ALONE * (rows + columns - 2 * len(pairs))
    assert total == pytest.approx(least(0, 0), abs=1e-9)


def test_swings_that_cannot_be_paired_are_reported():
    captured, measured = both(5)
    bare = RecordedShots(
        deliveries={"loft": captured.deliveries["loft"]},
        launches={},
        rows=captured.rows,
        source="a.csv",
        format="clubface",
    )
    shots = join(bare, measured)
    assert len(shots) == 5
    assert ("paired-by-order", {}) in shots.notes
    with pytest.raises(InputError, match="as many as captured, 5"):
        join(bare, measured.select(np.arange(4)))
    faster = RecordedShots(
        deliveries={}, launches={"ball_speed": measured.launches["ball_speed"] + 20.0}, rows=measured.rows,
        source="b.csv", format="trackman",
    )  # fmt: skip
    with pytest.raises(InputError, match="not one pair is alike"):
        join(captured, faster)
    with pytest.raises(InputError, match="shots with deliveries"):
        join(measured, captured)


def test_a_value_that_one_did_not_measure_does_not_part_a_pair():
    captured, measured = both(6)
    measured.launches["ball_speed"][2] = measured.launches["launch"][2] = np.nan
    assert join(captured, measured).rows.tolist() == captured.rows.tolist()


def test_two_files_become_one(clubface_, tmp_path):
    captured, measured = both(12)
    one, other, target = (tmp_path / f"{name}.csv" for name in ("captured", "session", "shots"))
    captured.select(np.arange(1, 12)).write(one)
    measured.write(other)
    ran = clubface_("capture", "join", str(one), str(other), "-o", str(target))
    assert ran.status == 0
    assert "1 row rejected" in ran.out
    assert len(clubface.read_shots(target)) == 11
    assert (
        clubface_("capture", "join", str(one), str(other), "-o", str(target), "--json").json["tables"]["session"][
            "rows"
        ][0]["shots"]
        == 11
    )
    assert_mistake(clubface_("capture", "join", str(one), str(other), "-o", str(one)), "a file other than the inputs")


@pytest.mark.parametrize(
    ("off", "same"),
    [
        ({"ball_speed": 1.2}, True),  # m/s: 0.8 of 1.5, a third of 0.64
        ({"ball_speed": 1.8}, False),  # 1.2 of it, although a third of 1.44 is as much as two rows alone cost
        ({"ball_speed": 1.35, "launch": 0.0314, "speed": 2.25}, False),  # 0.9 of each, more than two rows alone
    ],
)
def test_a_pair_may_differ_by_so_much(off, same):
    whole = recorded(5, "slip")
    launches = {name: whole.launches[name] for name in ("ball_speed", "launch")}
    one = RecordedShots(
        deliveries=whole.deliveries, launches=launches, rows=whole.rows, source="a.csv", format="clubface"
    )
    moved = {"speed": whole.deliveries["speed"], **launches}
    moved = {name: values + off.get(name, 0.0) * (np.arange(5) == 2) for name, values in moved.items()}
    other = RecordedShots(
        deliveries={"speed": moved.pop("speed")}, launches=moved, rows=whole.rows, source="b.csv", format="trackman"
    )
    assert len(join(one, other)) == (5 if same else 4)
