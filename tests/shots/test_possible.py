"""Values that no shot can have are not measured: they are told and counted, and are in no mean."""

from __future__ import annotations

import numpy as np
import pytest

from attached_notes import codes, noted
from clubface import read_shots, shots as launch_monitor
from clubface.errors import FileError
from clubface.shots.plausibility import RANGES, can_be
from clubface.shots.tables.headings import shot_words
from clubface.validation.benchmark_data import load

SENTINELS = {
    "Ball Speed": "-999", "Launch Angle": "999", "Spin Rate": "-21474836480", "Smash Factor": "-45",
    "Carry": "3.402823E+38", "Side": "-2147483648", "Launch Direction": "-9999", "Impact Offset": "32767",
}  # fmt: skip


@pytest.fixture
def trackman(tmp_path):
    def write(**changes):
        path = tmp_path / "session.csv"
        row = {
            "Club": "Driver", "Club Speed": "100", "Dyn. Loft": "13", "Impact Offset": "4", "Ball Speed": "148",
            "Smash Factor": "1.48", "Launch Angle": "11", "Launch Direction": "1", "Spin Rate": "2500", "Carry": "240",
            "Side": "3",
        }  # fmt: skip
        bad = row | {name.replace("_", " "): value for name, value in changes.items()}
        path.write_text("\n".join(",".join(each) for each in (row, row.values(), bad.values())))
        return path

    return write


@pytest.mark.parametrize("heading", SENTINELS)
def test_a_sentinel_is_reported_counted_and_left_out_of_means(trackman, heading):
    whole = launch_monitor.read(trackman())
    assert "impossible-values" not in codes(whole)
    shots = launch_monitor.read(trackman(**{heading.replace(" ", "_"): SENTINELS[heading]}))
    (impossible,) = noted(shots, "impossible-values")
    assert (impossible["wrong"], impossible["shots"]) == (1, 2)
    values, right = (table.deliveries | table.launches for table in (shots, whole))
    for name in right:
        np.testing.assert_array_equal(values[name][~np.isnan(values[name])], right[name][0])
    assert sum(int(np.isnan(each).sum()) for each in values.values()) == 1


def test_the_note_shows_the_number_as_the_file_has_it(trackman):
    last = launch_monitor.read(trackman(Spin_Rate="-21474836480")).notes[-1]
    assert "-21474836480 rpm" in last.sentence


def test_a_club_speed_that_cannot_be_says_that_the_club_was_not_measured(trackman):
    shots = launch_monitor.read(trackman(Club_Speed="-999", Impact_Offset="0"))
    assert np.isnan([shots.deliveries[name][1] for name in ("speed", "toe")]).all()
    assert shots.launches["ball_speed"][1] == shots.launches["ball_speed"][0]


def test_a_table_of_clubface_is_read_with_the_same_care(tmp_path):
    path = tmp_path / "shots.csv"
    path.write_text("club_speed_mph,ball_speed_mph,smash,backspin_rpm,sidespin_rpm\n100,148,-45,0,0\n0,-1,,,\n")
    shots = read_shots(path)
    assert shots.rows.tolist() == [2]
    assert [tuple(each) for each in shots.rejected] == [(3, "nothing was measured that a shot can have")]
    assert np.isnan([shots.launches[name][0] for name in ("smash", "backspin", "sidespin")]).all()
    assert {"example": {"backspin": 0.0}, "wrong": 1, "shots": 2} in noted(shots, "impossible-values")
    path.write_text("ball_speed_mph\n-999\n")
    with pytest.raises(FileError, match="no shot can be used: line 2: nothing was measured that a shot can have"):
        read_shots(path)


def test_the_limits_are_those_of_quantities_and_leave_real_shots_alone():
    assert set(RANGES) <= set(shot_words().dimensions)
    pytest.importorskip("pyarrow")
    for club in ("driver", "7-iron"):
        shots = load(club).measured
        for name, values in (shots.deliveries | shots.launches).items():
            assert can_be(name, values).all(), name


DEG, MPH, RPM, YD = np.pi / 180, 0.44704, np.pi / 30, 0.9144
ENDS = {
    "speed": (None, 200 * MPH), "ball_speed": (None, 400 * MPH), "smash": (None, 2.0), "attack": (-90 * DEG, 90 * DEG),
    "launch": (-90 * DEG, 90 * DEG), "toe": (-0.15, 0.15), "closure": (-36_000 * DEG, 36_000 * DEG),
    "backspin": (-20_000 * RPM, 20_000 * RPM), "total_spin": (None, 20_000 * RPM), "spin_axis": (-180 * DEG, 180 * DEG),
    "landing_angle": (0.0, 90 * DEG), "carry": (0.0, 600 * YD), "side": (-600 * YD, 600 * YD),
    "flight_time": (0.0, 60.0), "landing_speed": (0.0, 400 * MPH),
}  # fmt: skip
"""The ends of what a shot can have, entered a second time; None where anything above zero can be."""


@pytest.mark.parametrize("name", ENDS)
def test_a_value_at_the_end_of_what_can_be_can_be_and_one_beyond_cannot(name):
    low, high = ENDS[name]
    # A conversion rounds once or twice: a part in 1e12 on either side.
    inside, outside = [high * (1.0 - 1e-12)], [high * (1.0 + 1e-12)]
    if low is None:
        inside, outside = [*inside, 1e-5 if name != "smash" else 0.01], [*outside, 0.0, -1e-9]
    elif low == 0.0:
        inside, outside = [*inside, 0.0], [*outside, -1e-12]
    else:
        inside, outside = [*inside, low * (1.0 - 1e-12)], [*outside, low * (1.0 + 1e-12)]
    for single in inside:
        assert can_be(name, single)
    for single in outside:
        assert not can_be(name, single)
    assert can_be(name, np.array([*inside, np.nan])).all()
    assert not can_be(name, np.array(outside)).any()
