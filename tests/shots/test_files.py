"""Files of launch monitors, written by hand after their layouts, read and compared value by value with SI by hand."""

import math
from pathlib import Path

import numpy as np
import pytest

from attached_notes import codes, noted
from clubface import shots as launch_monitor
from clubface.errors import FileError, InputError, UnitError, UnknownNameError
from clubface.shots.reading import read_shots

DATA = Path(__file__).parents[1] / "data" / "launch_monitors"
MPH, KMH, DEG, RPM = 0.44704, 1 / 3.6, math.pi / 180, math.pi / 30
YD, FT, IN, MM = 0.9144, 0.3048, 0.0254, 0.001
NAN = math.nan


def assert_values(shots, **expected):
    """Every quantity there is, and no other; a unit conversion costs a rounding or two: 1e-14."""
    result = shots.deliveries | shots.launches
    for name, values in expected.items():
        np.testing.assert_allclose(result[name], values, rtol=1e-14, atol=0, err_msg=name)
    derived = {"backspin", "sidespin", "total_spin", "spin_axis"}
    assert set(result) - set(expected) <= derived


def test_trackman_is_read_with_its_units_row_its_signs_and_its_empty_cells():
    shots = launch_monitor.read(DATA / "trackman.csv")
    assert (shots.format, shots.rows.tolist()) == ("trackman", [4, 5, 6])
    assert shots.clubs.tolist() == ["Driver", "7 Iron", "7 Iron"]
    assert shots.hand is None
    assert_values(
        shots,
        speed=[100 * MPH, 84.5 * MPH, NAN],
        attack=[-1.5 * DEG, -4.25 * DEG, NAN],
        path=[2 * DEG, -1.5 * DEG, NAN],
        loft=[12 * DEG, NAN, NAN],
        face=[-3 * DEG, NAN, NAN],
        toe=[0.010, NAN, NAN],
        high=[-0.004, NAN, NAN],
        ball_speed=[147.5 * MPH, 118 * MPH, 117 * MPH],
        smash=[1.475, 1.396, NAN],
        launch=[10.5 * DEG, 17.5 * DEG, 18 * DEG],
        azimuth=[-1.25 * DEG, 0.5 * DEG, NAN],
        total_spin=[2500 * RPM, 6800.5 * RPM, NAN],
        spin_axis=[-8 * DEG, 2.5 * DEG, NAN],
        backspin=[2500 * RPM * math.cos(8 * DEG), 6800.5 * RPM * math.cos(2.5 * DEG), NAN],
        sidespin=[-2500 * RPM * math.sin(8 * DEG), 6800.5 * RPM * math.sin(2.5 * DEG), NAN],
        apex=[90 * FT, 85 * FT, NAN],
        carry=[250 * YD, 165 * YD, NAN],
        side=[-12 * YD, 3 * YD, NAN],
        landing_angle=[38 * DEG, 47 * DEG, NAN],
        flight_time=[6.25, 6, NAN],
        total=[270 * YD, 170 * YD, NAN],
        total_side=[-15 * YD, 3.5 * YD, NAN],
    )
    assert [tuple(each) for each in shots.rejected] == [
        (7, "Club Path: 'x' is not a number"),
        (8, "6 cells where there are 33 columns"),
        (9, "the ball speed is 0: no ball was measured"),
    ]
    assert ("column-values", {"column": "Spin Rate Type", "counts": {"Measured": 1, "Estimated": 1}}) in shots.notes


def test_trackman_without_a_row_of_units_is_in_mph_degrees_millimetres_rpm_feet_and_yards(write):
    names = (
        "Club Speed,Attack Angle,Club Path,Dyn. Loft,Face Angle,Swing Direction,Impact Offset,Impact Height,Ball Speed,"
        "Smash Factor,Launch Angle,Launch Direction,Spin Rate,Spin Axis,Max Height - Height,Carry Flat - Length,"
        "Carry Flat - Side,Carry Flat - Land. Angle,Carry Flat - Time,Est. Total Flat - Length,Est. Total Flat - Side"
    )
    shots = launch_monitor.read(
        write(f"{names}\n100,-1.5,2,12,-3,1,10,-4,147.5,1.475,10.5,-1,2500,-8,90,250,-12,38,6,270,-15\n")
    )
    assert shots.format == "trackman"
    assert_values(
        shots,
        speed=[100 * MPH],
        attack=[-1.5 * DEG],
        path=[2 * DEG],
        loft=[12 * DEG],
        face=[-3 * DEG],
        toe=[10 * MM],
        high=[-4 * MM],
        ball_speed=[147.5 * MPH],
        smash=[1.475],
        launch=[10.5 * DEG],
        azimuth=[-1 * DEG],
        total_spin=[2500 * RPM],
        spin_axis=[-8 * DEG],
        apex=[90 * FT],
        carry=[250 * YD],
        side=[-12 * YD],
        landing_angle=[38 * DEG],
        flight_time=[6.0],
        total=[270 * YD],
        total_side=[-15 * YD],
    )


def test_all_zero_club_data_are_no_measurement_even_without_a_speed(write):
    text = "Swing Direction,Dyn. Loft,Club Path,Attack Angle,Ball Speed,Launch Angle\n"
    shots = launch_monitor.read(write(text + "0,0,0,0,150,12\n1,13,0,2,150,12\n"))
    assert_values(
        shots,
        loft=[NAN, 13 * DEG],
        path=[NAN, 0.0],
        attack=[NAN, 2 * DEG],
        ball_speed=[150 * MPH] * 2,
        launch=[12 * DEG] * 2,
    )


def test_trackman_with_semicolons_decimal_commas_and_metric_units():
    shots = launch_monitor.read(DATA / "trackman-semicolon.csv", hand="left")
    assert shots.hand.tolist() == ["left", "left"]
    assert_values(
        shots,
        speed=[180.5 * KMH, NAN],
        loft=[12.25 * DEG, NAN],
        ball_speed=[70.5, 70],
        carry=[240.5, NAN],
        side=[-3.5, NAN],
        azimuth=[-0.5 * DEG, NAN],
        toe=[0.0125, NAN],
    )
    (impossible,) = noted(shots, "impossible-values")
    assert impossible["example"]["speed"] == pytest.approx(1080 / 3.6)


@pytest.mark.parametrize(
    ("content", "spin", "smash"),
    [
        ('Side Angle,Tilt Angle,Total Spin,Efficiency\n1,2,"2,650",1\n', 2650, 1),
        ('Side Angle,Tilt Angle,Total Spin,Efficiency\n1,2,"2,650",1.386\n', 2650, 1.386),
        ('Side Angle,Tilt Angle,Total Spin,Efficiency\n"1,5",2,2650,"1,386"\n', 2650, 1.386),
        ("Side Angle;Tilt Angle;Total Spin;Efficiency\n1;2;2650;1,386\n", 2650, 1.386),
        ("Side Angle;Tilt Angle;Total Spin;Efficiency\n1,5;2;2.650;1,386\n", 2650, 1.386),
        ("Side Angle\tTilt Angle\tTotal Spin\tEfficiency\n1.5\t2\t2,650\t1.386\n", 2650, 1.386),
    ],
)
def test_decimal_commas_are_distinguished_from_thousands_separators(write, content, spin, smash):
    launches = launch_monitor.read(write(content)).launches
    assert launches["total_spin"] == pytest.approx([spin * RPM], rel=1e-14)
    assert launches["smash"] == pytest.approx([smash], rel=1e-14)


@pytest.mark.parametrize(("hand", "mirror"), [("right", 1), ("left", -1), (None, 1)])
def test_foresight_signs_are_in_out_and_open_so_left_handers_are_mirrored(hand, mirror):
    shots = launch_monitor.read(DATA / "foresight-play.csv", hand=hand)
    assert shots.format == "foresight"
    assert_values(
        shots,
        speed=[102.5 * MPH, NAN, NAN, 82 * MPH],
        attack=[1.5 * DEG, NAN, NAN, -4 * DEG],
        path=[mirror * 3.5 * DEG, NAN, NAN, mirror * -2.5 * DEG],
        face=[mirror * 1 * DEG, NAN, NAN, mirror * -1 * DEG],
        lie=[-1.5 * DEG, NAN, NAN, 2 * DEG],
        loft=[14 * DEG, NAN, NAN, 25 * DEG],
        toe=[0.0085, NAN, NAN, -0.005],
        high=[0.004, NAN, NAN, -0.006],
        closure=[2600 * DEG, NAN, NAN, 1800 * DEG],
        ball_speed=[150 * MPH, 151 * MPH, 118 * MPH, NAN],
        smash=[1.46, NAN, NAN, NAN],
        launch=[12.5 * DEG, 11 * DEG, 17 * DEG, NAN],
        azimuth=[-2 * DEG, 1 * DEG, 0.5 * DEG, NAN],
        backspin=[2400 * RPM, 2200 * RPM, 6500 * RPM, NAN],
        sidespin=[-350 * RPM, 100 * RPM, 0, NAN],
        total_spin=[2425.4 * RPM, 2202.3 * RPM, 6500 * RPM, NAN],
        carry=[240 * YD, 245 * YD, 165 * YD, NAN],
        total=[262 * YD, 268 * YD, 172 * YD, NAN],
        total_side=[-14 * YD, 5 * YD, 1 * YD, NAN],
        apex=[30 * YD, 29 * YD, 31 * YD, NAN],
        landing_angle=[38 * DEG, 37 * DEG, 47 * DEG, NAN],
    )
    assert noted(shots, "without-club-data") == [{"without": 2, "shots": len(shots)}]
    assert ("hand-assumed" in codes(shots)) == (hand is None)


@pytest.mark.parametrize(
    ("content", "toe"),
    [
        ("Push/Pull,Face Impact Horizontal\n1,8.5\n", -0.0085),
        ("Push/Pull,Face Impact Horizontal (mm heel-/toe+)\n1,8.5\n", 0.0085),
        ("Side Angle,Tilt Angle,Face Impact Lateral\n1,2,8.5\n", -0.0085),
        ("Side Angle,Tilt Angle,Face Impact Lateral\n1,2,8.5 Toe\n", 0.0085),
    ],
)
def test_foresights_bare_offsets_are_positive_to_the_heel_unless_something_says_otherwise(write, content, toe):
    assert launch_monitor.read(write(content)).deliveries["toe"] == pytest.approx([toe], rel=1e-14)


@pytest.mark.parametrize(("hand", "mirror"), [("right", 1), ("left", -1)])
def test_foresight_2020_has_sides_after_numbers_and_face_to_path(hand, mirror):
    shots = launch_monitor.read(DATA / "foresight-2020.csv", hand=hand)
    assert (shots.format, shots.rows.tolist()) == ("foresight-2020", [4, 5])
    path, to_path = np.array([3.4, -1.6]), np.array([-2.4, 1.1])
    assert_values(
        shots,
        speed=[102 * MPH, 101 * MPH],
        attack=[1.5 * DEG, -2.1 * DEG],
        path=mirror * path * DEG,
        face=mirror * (path + to_path) * DEG,
        lie=[-1.5 * DEG, 2 * DEG],
        loft=[14 * DEG, 14.5 * DEG],
        toe=[0.0085, -0.003],
        high=[-0.004, 0.0025],
        closure=[2600 * DEG, 2500 * DEG],
        ball_speed=[150.5 * MPH, 149 * MPH],
        smash=[1.475, 1.475],
        launch=[12.1 * DEG, 12.4 * DEG],
        azimuth=[2.1 * DEG, -0.5 * DEG],
        backspin=[2400 * RPM, 2500 * RPM],
        sidespin=[-350 * RPM, 0],
        spin_axis=[-8.3 * DEG, 0],
        total_spin=[2425 * RPM, 2500 * RPM],
        carry=[240 * YD, 238 * YD],
        total=[262 * YD, 259 * YD],
        total_side=[-14.5 * YD, 0],
        apex=[30 * YD, 31 * YD],
        landing_angle=[38 * DEG, 39 * DEG],
    )
    assert shots.rejected == ()
    assert ("summary-rows", {"rows": 2}) in shots.notes


def test_garmin_is_read_behind_its_byte_order_mark_and_its_sidespin_is_turned():
    shots = launch_monitor.read(DATA / "garmin-en.csv")
    assert shots.format == "garmin"
    assert shots.clubs.tolist() == ["7 Iron", "7 Iron"]
    assert_values(
        shots,
        speed=[81.5 * MPH, NAN],
        attack=[-3.5 * DEG, NAN],
        path=[1.25 * DEG, NAN],
        face=[4.5 * DEG, NAN],
        ball_speed=[114.5 * MPH, 111.5 * MPH],
        smash=[1.405, NAN],
        launch=[19.5 * DEG, 19 * DEG],
        azimuth=[4 * DEG, -1.5 * DEG],
        backspin=[5000 * RPM, 5300 * RPM],
        sidespin=[800 * RPM, -140 * RPM],
        total_spin=[5063.6 * RPM, 5301.8 * RPM],
        spin_axis=[9.09 * DEG, -1.51 * DEG],
        apex=[96.5 * FT, 90 * FT],
        carry=[164.5 * YD, 159 * YD],
        side=[23.1 * YD, -6.5 * YD],
        total=[171 * YD, 159 * YD],
        total_side=[23 * YD, -6.5 * YD],
    )
    # The two ways the file tells the spin agree, which they would not with the sign as printed.
    np.testing.assert_allclose(
        np.arctan2(shots.launches["sidespin"], shots.launches["backspin"]), shots.launches["spin_axis"], atol=2e-4
    )


def test_garmin_in_german_with_semicolons_and_decimal_commas():
    shots = launch_monitor.read(DATA / "garmin-de.csv")
    assert shots.clubs.tolist() == ["Eisen 7", "Driver"]
    assert_values(
        shots,
        speed=[130.5 * KMH, 160.2 * KMH],
        attack=[-3.25 * DEG, NAN],
        path=[-2.5 * DEG, NAN],
        face=[-6.75 * DEG, NAN],
        ball_speed=[180.9 * KMH, 225.36 * KMH],
        smash=[1.386, 1.407],
        launch=[19.5 * DEG, 12 * DEG],
        azimuth=[-5.25 * DEG, 1 * DEG],
        backspin=[5000.5 * RPM, 2600 * RPM],
        sidespin=[-650.25 * RPM, 0],
        total_spin=[5042.6 * RPM, 2600 * RPM],
        spin_axis=[-7.41 * DEG, 0],
        apex=[28.5, 25],
        carry=[150.5, 195.5],
        side=[-21.2, 3.5],
        total=[156, 215],
        total_side=[-21.7, 3.75],
    )
    assert ("column-values", {"column": "Drehratentyp", "counts": {"Gemessen": 1, "Berechnet": 1}}) in shots.notes


def test_garmin_without_a_units_row_asks_for_the_units(write):
    lines = (DATA / "garmin-en.csv").read_text(encoding="utf-8-sig").splitlines()
    path = write("\n".join([lines[0], *lines[2:]]))
    with pytest.raises(FileError, match=r"csv:1: the columns 'Club Speed', 'Ball.*name no unit.*--unit speed=mph"):
        launch_monitor.read(path)
    shots = launch_monitor.read(path, units={"speed": "km/h", "length": "m", "apex": "ft"})
    assert shots.launches["ball_speed"][0] == pytest.approx(114.5 * KMH, rel=1e-14)
    assert (shots.launches["carry"][0], shots.launches["apex"][0]) == (164.5, pytest.approx(96.5 * FT, rel=1e-14))


def test_rapsodo_is_a_table_a_club_with_rows_of_averages():
    shots = launch_monitor.read(DATA / "rapsodo.csv")
    assert (shots.format, shots.rows.tolist()) == ("rapsodo", [4, 5, 10])
    assert shots.clubs.tolist() == ["d", "d", "7i"]
    assert_values(
        shots,
        speed=[98 * MPH, NAN, 82.5 * MPH],
        attack=[-1.2 * DEG, NAN, -5.1 * DEG],
        path=[2.1 * DEG, NAN, -3.8 * DEG],
        ball_speed=[142.4 * MPH, 141 * MPH, 111.5 * MPH],
        smash=[1.453, NAN, 1.352],
        launch=[13.2 * DEG, 12 * DEG, 18.5 * DEG],
        azimuth=[1.5 * DEG, 0.5 * DEG, -2.25 * DEG],
        total_spin=[2650 * RPM, NAN, 6250 * RPM],
        spin_axis=[-4.5 * DEG, NAN, 3.25 * DEG],
        apex=[101.5 * FT, NAN, 85 * FT],
        carry=[224.5 * YD, NAN, 155.5 * YD],
        side=[-8.75 * YD, NAN, -4.5 * YD],
        landing_angle=[38 * DEG, NAN, 45 * DEG],
        total=[246 * YD, NAN, 161 * YD],
    )
    assert [tuple(each) for each in shots.rejected] == [(11, "7 cells where there are 18 columns")]
    assert ("summary-rows", {"rows": 4}) in shots.notes
    assert noted(shots, "units-assumed")[0]["columns"]["Carry Distance"] == "yd"
    metric = launch_monitor.read(DATA / "rapsodo.csv", units={"apex": "m", "carry": "m"})
    assert (metric.launches["apex"][0], metric.launches["carry"][0]) == (101.5, 224.5)


def test_flightscope_has_left_and_right_after_the_number():
    shots = launch_monitor.read(DATA / "flightscope.csv")
    assert (shots.format, shots.rows.tolist()) == ("flightscope", [2, 3])
    assert_values(
        shots,
        speed=[76.5 * MPH, 75 * MPH],
        attack=[-6.1 * DEG, NAN],
        path=[1.25 * DEG, -0.5 * DEG],
        loft=[29.5 * DEG, 29 * DEG],
        face=[-7.5 * DEG, 1.0 * DEG],
        toe=[0.25 * IN, NAN],
        high=[-0.5 * IN, NAN],
        ball_speed=[93.5 * MPH, 92 * MPH],
        smash=[1.222, 1.227],
        launch=[19 * DEG, 19.5 * DEG],
        azimuth=[-5 * DEG, 0.5 * DEG],
        total_spin=[5990 * RPM, NAN],
        spin_axis=[-13.75 * DEG, NAN],
        apex=[56.5 * FT, 55 * FT],
        flight_time=[4.75, 4.5],
        carry=[120.5 * YD, 118 * YD],
        side=[-16 * YD, 2.5 * YD],
        landing_angle=[40.25 * DEG, 40 * DEG],
        total=[122 * YD, 119 * YD],
    )
    assert shots.rejected == ()


@pytest.mark.parametrize(("hand", "mirror"), [("right", 1), ("left", -1)])
def test_any_file_is_read_through_a_mapping(hand, mirror):
    shots = launch_monitor.read(DATA / "other.csv", mapping=DATA / "other.toml", hand=hand)
    assert (shots.format, shots.clubs.tolist()) == ("range-radar", ["7er Eisen", "7er Eisen"])
    assert_values(
        shots,
        speed=[130.5 * KMH, 131 * KMH],
        path=[mirror * 2.5 * DEG, mirror * -1 * DEG],
        face=[mirror * 1.5 * DEG, mirror * 0.5 * DEG],
        toe=[-0.0045, NAN],
        ball_speed=[50, 181 * KMH],
        launch=[17.5 * DEG, 18 * DEG],
    )
    assert [tuple(each) for each in shots.rejected] == [(5, "Bahn: 'abc' is not a number")]
    assert ("not-utf-8", {"encoding": "Windows-1252"}) in shots.notes


def test_clubfaces_own_tables_are_recognised(write, tmp_path):
    first = launch_monitor.read(DATA / "trackman.csv")
    first.write(tmp_path / "own.csv")
    result = launch_monitor.read(tmp_path / "own.csv", hand="left")
    assert (result.format, result.hand.tolist()) == ("clubface", ["left"] * 3)
    np.testing.assert_allclose(result.launches["spin_axis"], first.launches["spin_axis"], rtol=1e-14)
    assert len(read_shots(tmp_path / "own.csv")) == 3


def test_a_heading_that_is_there_twice_must_say_the_same_twice(write):
    head = "Club,Club Speed,Swing Direction,Dyn. Loft,Ball Speed,Ball Speed\n,[mph],[deg],[deg],[mph],[mph]\n"
    shots = launch_monitor.read(write(head + "D,100,1,12,150,150.0\nD,100,1,12,,149\nD,100,1,12,150,149\n"))
    np.testing.assert_allclose(shots.launches["ball_speed"], [150 * MPH, 149 * MPH], rtol=1e-14)
    assert [tuple(each) for each in shots.rejected] == [
        (5, "Ball Speed: the column is there twice, and columns 5 and 6 differ: '150' and '149'"),
    ]


def test_the_preferred_of_two_columns_for_a_quantity_is_taken(write):
    head = "Carry,Swing Direction,Carry Flat - Length,Club Speed,Spin Axis (Sim),Dyn. Loft\n"
    shots = launch_monitor.read(write(head + "[yds],[deg],[yds],[mph],[deg],[deg]\n200,1,210,100,3,12\n"))
    assert shots.launches["carry"].tolist() == [pytest.approx(210 * YD, rel=1e-14)]
    assert "spin_axis" not in shots.launches
    assert ("brackets-without-unit", {"columns": ["Spin Axis (Sim)"]}) in shots.notes


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "the file is empty"),
        (b"\n\n", "the file is empty"),
        (b"a,b\n1,2\n", "the layout is not one of trackman, foresight.*there are: a, b"),
        (b"\x1b[31ma,b\n1,2\n", r"there are: \?\[31ma, b"),
        (
            b"Side Angle,Tilt Angle,Ball Speed\n,[deg],[furlongs]\n1,2,3\n",
            "'Ball Speed' is 'furlongs'; it must be in",
        ),
        (b"Side Angle,Tilt Angle,Ball Speed [deg]\n1,2,3\n", "is 'deg'; it must be in m/s"),
        (b"Side Angle,Tilt Angle,Ball Speed\n", "there are no shots"),
        (b"Side Angle,Tilt Angle,Ball Speed\n1,2\n", "line 2: 2 cells where there are 3 columns"),
        (b"Side Angle,Tilt Angle,Ball Speed\n3 Q,2,100\n", "'3 Q' is not a number, or one with its side .l, left"),
        (b"Side Angle,Tilt Angle,Ball Speed\n-3 R,2,100\n", "'-3 R' is a number whose sign and side contradict"),
        (b"Side Angle,Tilt Angle,Ball Speed\n,,-\n", "nothing was measured"),
        (b"Side Angle,Tilt Angle,Ball Speed\n1,2,1_0\n", "'1_0' is not a number"),
        (b'Side Angle,Tilt Angle,Ball Speed\n1,2,"10', "does not end"),
        (b"\xff\xfea\x00b", "this UTF-16 text is damaged"),
        (b"Side Angle,Tilt Angle,Handed\n1,2,up\n", "Handed: 'up' is not a hand"),
    ],
)
def test_a_file_that_cannot_be_used_is_refused_with_the_reason(write, content, message):
    with pytest.raises(FileError, match=message):
        launch_monitor.read(write(content))


FEW = "Club,Club Speed,Ball Speed,Launch Angle,Spin Axis\n,[mph],[mph],[deg],[deg]\nDriver,100,147.5,10.5,-8\n"


@pytest.mark.parametrize("first", ["", "sep=,\n"])
def test_a_file_of_few_columns_is_read_as_the_format_that_is_asked_for(write, first):
    path = write(first + FEW)
    for format, name in ((None, "clubface"), ("trackman", "trackman")):
        shots = launch_monitor.read(path, format)
        assert_values(shots, speed=[100 * MPH], ball_speed=[147.5 * MPH], launch=[10.5 * DEG], spin_axis=[-8 * DEG])
        assert (shots.format, shots.rejected, shots.clubs.tolist()) == (name, (), ["Driver"])
        assert "read-as-asked" not in codes(shots)


def test_a_format_that_is_asked_for_wins_over_the_one_the_columns_tell():
    shots = launch_monitor.read(DATA / "trackman.csv", "rapsodo")
    assert shots.format == "rapsodo"
    assert shots.notes[0] == ("read-as-asked", {"format": "rapsodo", "formats": ["trackman"]})
    assert shots.deliveries["speed"][0] == pytest.approx(100 * MPH, rel=1e-14)


def test_the_hand_of_each_shot_is_read_where_the_file_tells_it(write):
    content = "Push/Pull (deg L-/R+),Handed,Club Speed (mph),Club Path (deg out-in-/in-out+)\n1,RH,100,2\n1,lh,100,2\n"
    shots = launch_monitor.read(write(content))
    assert shots.hand.tolist() == ["right", "left"]
    np.testing.assert_allclose(shots.deliveries["path"], [2 * DEG, -2 * DEG], rtol=1e-14)
    np.testing.assert_allclose(shots.launches["azimuth"], [1 * DEG, 1 * DEG], rtol=1e-14)


def test_unknown_formats_hands_units_and_files_are_refused():
    path = DATA / "trackman.csv"
    with pytest.raises(UnknownNameError, match="did you mean trackman"):
        launch_monitor.read(path, format="trackmann")
    with pytest.raises(UnknownNameError, match="right, left"):
        launch_monitor.read(path, hand="Left")
    with pytest.raises(FileError, match=r"this is not a Garmin.*no row names the columns Carry Deviation Distance"):
        launch_monitor.read(DATA / "other.csv", format="garmin")
    with pytest.raises(InputError, match="leave it out, since the mapping"):
        launch_monitor.read(path, format="garmin", mapping=DATA / "other.toml")
    with pytest.raises(FileError, match="no row names the columns Tempo, Bahn"):
        launch_monitor.read(path, mapping=DATA / "other.toml")
    with pytest.raises(UnknownNameError, match="did you mean carry"):
        launch_monitor.read(path, units={"cary": "m"})
    with pytest.raises(UnitError, match="unit of carry"):
        launch_monitor.read(path, units={"carry": "mph"})
    with pytest.raises(FileError, match="cannot be read"):
        launch_monitor.read(DATA)
