"""What stands in the cells of exports: numbers with sides and units of their own, in any order."""

from __future__ import annotations

import numpy as np
import pytest

from clubface import launch_monitor, read_shots
from clubface.errors import FileError
from clubface.launch_monitor.cells import CellError, heading, reading, unit_in
from clubface.units import to_si

MPH, KMH, YD, RPM, DEG = (to_si(1.0, each) for each in ("mph", "km/h", "yd", "rpm", "deg"))


@pytest.mark.parametrize(
    ("cell", "quantity", "value", "unit"),
    [
        ("422 R rpm", "sidespin", 422.0, "rpm"), ("422 rpm L", "sidespin", -422.0, "rpm"),
        ("L 422 rpm", "sidespin", -422.0, "rpm"), ("2.4 deg Closed", "face", -2.4, "deg"),
        ("8.5 mm Toe", "toe", 8.5, "mm"), ("8.5 Heel mm", "toe", -8.5, "mm"), ("3.4 In-to-Out deg", "path", 3.4, "deg"),
        ("150mph", "ball_speed", 150.0, "mph"), ("2,650 rpm", "total_spin", 2650.0, "rpm"),
        ("-1.5°", "attack", -1.5, "deg"), ("245 yards", "carry", 245.0, "yd"), ("12", "launch", 12.0, None),
    ],
)  # fmt: skip
def test_a_number_stands_with_its_side_and_its_unit_in_any_order(cell, quantity, value, unit):
    found = reading(cell, quantity, decimal_comma=False)
    assert (found.value, found.unit) == (value, unit)
    assert unit_in(cell) == unit


@pytest.mark.parametrize(
    ("text", "positive"),
    [("Push/Pull (deg L-/R+)", "r"), ("Push/Pull (deg R+/L-)", "r"), ("Toe (mm toe-/heel+)", "heel"),
     ("Toe (mm toe+/heel-)", "toe"), ("Path (deg)", None)],
)  # fmt: skip
def test_a_heading_names_the_positive_side_first_or_last(text, positive):
    assert heading(text).positive == positive


@pytest.mark.parametrize(
    ("cell", "quantity"),
    [("422 Q rpm", "sidespin"), ("422 R rpm L", "sidespin"), ("L 422 R", "sidespin"), ("-422 R rpm", "sidespin"),
     ("5 furlongs", "carry"), ("3 rpm rpm", "total_spin")],
)  # fmt: skip
def test_words_that_are_neither_side_nor_unit_are_refused(cell, quantity):
    with pytest.raises(CellError):
        reading(cell, quantity, decimal_comma=False)


def test_fsx_2020_writes_side_and_unit_into_every_cell(tmp_path):
    path = tmp_path / "fsx.csv"
    path.write_text(
        "Club,Ball Speed,Side Angle,Sidespin,Tilt Angle,Total Spin,Carry\n"
        "7i,118 mph,2.1 R deg,422 R rpm,4.0 R deg,6050 rpm,165 yd\n"
    )
    shots = launch_monitor.read(path)
    assert shots.format == "foresight-2020"
    np.testing.assert_allclose(shots.launches["sidespin"], [422 * RPM], rtol=1e-14)  # one conversion: a rounding or two
    np.testing.assert_allclose(shots.launches["azimuth"], [2.1 * DEG], rtol=1e-14)
    assert not any("assumed" in note for note in shots.notes)


def test_the_column_that_names_the_club_is_no_speed_whatever_unit_is_given_for_speeds(tmp_path):
    """FS Golf calls the club and its speed by the same word."""
    path = tmp_path / "flightscope.csv"
    path.write_text("Club,Ball (mph),Club (mph),Smash,Launch V,Launch H\nDriver,148,100,1.48,12,1 R\n")
    shots = launch_monitor.read(path, units={"speed": "km/h"})
    assert shots.clubs is not None
    assert shots.clubs.tolist() == ["Driver"]
    np.testing.assert_allclose(shots.deliveries["speed"], [100 * MPH], rtol=1e-14)


def test_rows_in_other_units_each_count_in_their_own(tmp_path):
    path = tmp_path / "garmin.csv"
    path.write_text(
        "Club Type,Ball Speed,Carry Deviation Distance,Launch Direction,Carry Distance\n"
        "Driver,,,1,\nDriver,150 mph,3 yd,1,240 yd\nDriver,241 km/h,2 m R,1,220 m\nDriver,149,-1,1,238\n"
    )
    shots = launch_monitor.read(path)  # Garmin's units must be told: here, the first cell with one tells it
    np.testing.assert_allclose(shots.launches["ball_speed"][1:], [150 * MPH, 241 * KMH, 149 * MPH], rtol=1e-14)
    np.testing.assert_allclose(shots.launches["carry"][1:], [240 * YD, 220.0, 238 * YD], rtol=1e-14)
    np.testing.assert_allclose(shots.launches["side"][1:], [3 * YD, 2.0, -1 * YD], rtol=1e-14)
    path.write_text(path.read_text().replace("220 m", "220 kg"))
    (rejected,) = launch_monitor.read(path).rejected
    assert "'220 kg' is not in yd or another such unit" in rejected.reason


def test_a_table_of_clubface_may_have_units_in_its_cells_too(tmp_path):
    path = tmp_path / "shots.csv"
    path.write_text("club_speed_mph,attack_deg,ball_speed [mph]\n100 mph,-2°,148\n160.9344 km/h,0.1 rad,66 m/s\n")
    shots = read_shots(path)
    # A conversion from km/h to mph and on to m/s costs a few roundings.
    np.testing.assert_allclose(shots.deliveries["speed"], [100 * MPH] * 2, rtol=1e-14)
    np.testing.assert_allclose(shots.deliveries["attack"], [-2 * DEG, 0.1], rtol=1e-14)
    np.testing.assert_allclose(shots.launches["ball_speed"], [148 * MPH, 66.0], rtol=1e-14)
    path.write_text("club_speed_mph\n100 kg\n")
    with pytest.raises(FileError, match="'100 kg' is not in mph"):
        read_shots(path)
