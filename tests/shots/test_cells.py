"""What stands in the cells of exports: numbers with sides and units of their own, in any order."""

from __future__ import annotations

import numpy as np
import pytest

from attached_notes import codes, noted
from clubface import read_shots, shots as launch_monitor
from clubface.errors import FileError
from clubface.shots.tables.cells import CellError, reading, unit_in
from clubface.shots.tables.headings import heading
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
def test_number_side_and_unit_may_stand_in_any_order(cell, quantity, value, unit):
    result = reading(cell, quantity, decimal_comma=False)
    assert (result.value, result.unit) == (value, unit)
    assert unit_in(cell, quantity) == unit


@pytest.mark.parametrize(
    ("cell", "quantity", "value"),
    [
        ("2.6 O", "face", 2.6), ("1.3 C", "face", -1.3), ("1.4 c", "face_to_path", -1.4), ("1.3C", "face", -1.3),
        ("1.2 I-O", "path", 1.2), ("0.4 O-I", "path", -0.4), ("1.1 i/o", "path", 1.1), ("O-I 0.4", "path", -0.4),
        ("In-Out 1.2", "path", 1.2), ("3.1° D", "attack", -3.1), ("1.8 U", "attack", 1.8), ("U1.8°", "attack", 1.8),
        ("L1.2", "azimuth", -1.2), ("1.2 L", "azimuth", -1.2), ("1.2L", "azimuth", -1.2), ("1.2° L", "azimuth", -1.2),
        ("1.2°L", "azimuth", -1.2), ("L 1.2º", "azimuth", -1.2), ("Left 1.2", "azimuth", -1.2),
        ("1,2 links", "azimuth", -1.2), ("1.2 gauche", "azimuth", -1.2), ("1.2 D", "azimuth", 1.2),
        ("droite 1.2", "side", 1.2), ("1.2 izquierda", "side", -1.2), ("右1.2", "side", 1.2), ("7 T", "toe", 7.0),
        ("7 H", "toe", -7.0), ("mm 7 heel", "toe", -7.0), ("4 H", "high", 4.0), ("4 L", "high", -4.0),
        ("R 422 rpm", "sidespin", 422.0), ("3.0 draw", "spin_axis", -3.0), ("2 toe down", "lie", -2.0),
        ("-1.2 L", "azimuth", -1.2), ("+1.2 R", "azimuth", 1.2), ("-1.2 C", "face", -1.2), ("0.0 R", "path", 0.0),
        ("0.0 N", "path", 0.0), ("0 S", "azimuth", 0.0), ("−1.5°", "attack", -1.5), ("- 1.5", "attack", -1.5),
        ("–1.5 deg.", "attack", -1.5), ("1.5 Grad", "attack", 1.5), ("3 045", "total_spin", 3045.0),
        ("3\u202f045 rpm", "total_spin", 3045.0), ("3\xa0045", "total_spin", 3045.0), ("3'045", "total_spin", 3045.0),
        ("3’045 L", "sidespin", -3045.0), ("1 003 045", "total_spin", 1003045.0),
    ],
)  # fmt: skip
def test_many_spellings_of_sides_units_and_thousands_are_read(cell, quantity, value):
    result = reading(cell, quantity, decimal_comma="," in cell)
    assert result.value == value
    assert result.side is None or abs(result.side.sign) == 1


def test_a_sign_beside_a_letter_must_agree_with_it():
    """Garmin's sidespin is positive to the left: minus there is to the right."""
    assert reading("-300 R", "sidespin", False, positive=-1.0).value == 300.0
    with pytest.raises(CellError, match="contradict"):
        reading("-300 L", "sidespin", False, positive=-1.0)


def test_a_letter_says_the_side_whichever_side_of_its_column_is_positive(write):
    shots = launch_monitor.read(write("Ball Speed (mph),Launch Direction (deg L+/R-)\n147,1.2 L\n147,1.2\n147,1.2 R\n"))
    np.testing.assert_allclose(shots.launches["azimuth"], np.array([-1.2, -1.2, 1.2]) * DEG, rtol=1e-14)


@pytest.mark.parametrize("cell", ["", "---", "--.-", "–", "n/a", "#N/A", "Not measured", "?", " . "])
def test_many_spellings_of_not_measured_are_read(cell):
    assert reading(cell, "face", decimal_comma=False) is None


@pytest.mark.parametrize(
    ("content", "spins"),
    [
        ("Spin Rate [rpm];Launch Angle [deg]\n2.845;12\n980;13\n", [2845, 980]),
        ("Spin Rate [rpm];Launch Angle [deg]\n2,845;12\n980;13\n", [2845, 980]),
        ("Spin Rate [rpm];Launch [deg];Smash\n2845;12;1,386\n3102;13;1,400\n", [2845, 3102]),
        ("Spin Rate [rpm];Launch Angle [deg]\n2.845;12,5\n3.102;13,0\n", [2845, 3102]),
        ("Spin Rate [rpm];Launch Angle [deg]\n2,845;12.5\n3,102;13.0\n", [2845, 3102]),
        ("Spin Rate [rpm];Launch Angle [deg]\n2845,123;12\n3102,5;13\n", [2845.123, 3102.5]),
    ],
)
def test_a_mark_before_three_digits_of_a_spin_separates_thousands(write, content, spins):
    shots = launch_monitor.read(write(content))
    np.testing.assert_allclose(shots.launches["total_spin"], np.array(spins) * RPM, rtol=1e-14)


@pytest.mark.parametrize(
    "content",
    [
        # Three decimals, as a rounded data frame has them: 120.500 is no thousand beside 2845.312.
        "150,12,2845.312,-71.333\n151,13,2945.312,120.500\n",
        "150;12;2845,4;-71,333\n151;13;2945,6;120,500\n",
    ],
)
def test_other_spins_of_the_file_show_that_a_mark_is_of_decimals(write, content):
    head = "ball_speed [mph];launch [deg];backspin [rpm];sidespin [rpm]\n".replace(";", content[3])
    shots = launch_monitor.read(write(head + content))
    assert not shots.rejected
    np.testing.assert_allclose(shots.launches["sidespin"], np.array([-71.333, 120.5]) * RPM, rtol=1e-14)


@pytest.mark.parametrize(("unit", "written"), [(" [rpm]", ""), ("", " rpm")])
def test_a_spin_that_may_be_two_or_two_thousand_is_refused(write, unit, written):
    rows = f"2.845{written};12.5\n3102{written};13.5\n4100{written};14.5\n"
    shots = launch_monitor.read(write(f"Spin Rate{unit};Launch Angle [deg]\n{rows}"))
    assert [(each.line, "2.845" in each.reason) for each in shots.rejected] == [(2, True)]


def test_an_undecidable_number_is_noted(write):
    shots = launch_monitor.read(write("Spin Rate [rpm];Launch [deg];Altitude\n2845;12;1.200\n3102;13;1.300\n"))
    assert noted(shots, "decimals-or-thousands") == [{"mark": "point", "example": "'1.200'"}]


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
     ("+1.2 L", "azimuth"),
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
    assert "units-assumed" not in codes(shots)


def test_the_column_that_names_the_club_is_no_speed_whatever_unit_is_given_for_speeds(tmp_path):
    """FS Golf calls the club and its speed by the same word."""
    path = tmp_path / "flightscope.csv"
    path.write_text("Club,Ball (mph),Club (mph),Smash,Launch V,Launch H\nDriver,148,100,1.48,12,1 R\n")
    shots = launch_monitor.read(path, units={"speed": "km/h"})
    assert shots.clubs is not None
    assert shots.clubs.tolist() == ["Driver"]
    np.testing.assert_allclose(shots.deliveries["speed"], [100 * MPH], rtol=1e-14)


def test_each_row_is_read_in_its_own_units(tmp_path):
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
