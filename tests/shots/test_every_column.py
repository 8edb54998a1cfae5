"""No measured column is left out without a word: other names of what is known, and lists of what is not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from attached_notes import codes, noted
from clubface import shots as launch_monitor
from clubface.errors import FileError
from clubface.shots.monitors import FORMATS
from clubface.units import to_si

DATA = Path(__file__).parents[1] / "data" / "launch_monitors"


def assert_si(shots, **expected):
    """Quantities in the unit that each is given with; a conversion costs a rounding or two."""
    result = shots.deliveries | shots.launches
    for name, (values, unit) in expected.items():
        np.testing.assert_allclose(result[name], to_si(np.array(values, float), unit), rtol=1e-13, err_msg=name)


@pytest.mark.parametrize(
    ("heading", "quantity"),
    [
        ("Club head Speed (mph)", "speed"), ("Clubhead Speed [mph]", "speed"), ("Swing Speed (mph)", "speed"),
        ("Azimuth (deg)", "azimuth"), ("HLA (deg)", "azimuth"), ("Launch H (deg)", "azimuth"),
        ("Push/Pull (deg)", "azimuth"), ("VLA (deg)", "launch"), ("Launch Angle V (deg)", "launch"),
        ("Vert Path (deg)", "attack"), ("Angle of Attack (deg)", "attack"), ("Club AoA (deg)", "attack"),
        ("Horiz Path (deg)", "path"), ("Face to Target (deg)", "face"), ("FTT (°)", "face"),
        ("Horiz Impact (mm)", "toe"), ("Horizontal Impact (mm)", "toe"), ("Lateral Impact (in)", "toe"),
        ("Vert Impact (mm)", "high"), ("Face Impact Vertical (mm)", "high"), ("Flat Carry (yd)", "carry"),
        ("Carry Dist (yd)", "carry"), ("Total Dist (yd)", "total"), ("Desc Angle (deg)", "landing_angle"),
        ("Landing Angle (º)", "landing_angle"), ("Peak Height (ft)", "apex"), ("Hang Time (s)", "flight_time"),
        ("Tilt Angle (deg)", "spin_axis"), ("Side Carry (yd)", "side"), ("Launch Direction (Grad)", "azimuth"),
        ("ヘッドスピード (m/s)", "speed"), ("Attack Ang. (deg)", "attack"), ("Spin Rate (U/min)", "total_spin"),
    ],
)  # fmt: skip
def test_a_quantity_is_known_by_the_names_that_programs_give_it(write, heading, quantity):
    value = 45 if "m/s" in heading else 100 if quantity == "speed" else 3
    unit = heading.replace("[", "(").partition("(")[2].rstrip(")]")
    unit = {"°": "deg", "º": "deg", "Grad": "deg", "U/min": "rpm"}.get(unit, unit)
    for maker in ("", "Swing Direction (deg),Dyn. Loft (deg),"):
        if maker and "Push/Pull" in heading:
            continue  # the mark of another maker
        content = f"Club,Ball Speed (mph),{maker}{heading}\nDriver,147,{'1,12,' * bool(maker)}{value}\n"
        assert_si(launch_monitor.read(write(content)), **{quantity: ([value], unit)})


def test_the_shot_of_fsx_has_its_club_speed_and_its_club_path_but_not_what_it_did_not_measure():
    shots = launch_monitor.read(DATA / "foresight-last-shot.csv")
    assert_si(
        shots, speed=([36.311745], "m/s"), ball_speed=([49.575752], "m/s"), azimuth=([-4.488229], "deg"),
        attack=([-3.472091], "deg"), path=([2.906673], "deg"), total=([150.396927], "m"),
    )  # fmt: skip
    for name in {"face", "loft", "lie", "closure", "toe", "high"} & set(shots.deliveries):
        assert np.isnan(shots.deliveries[name]).all()
    notes = " ".join(map(str, shots.notes))
    for name in ("Face to Path", "Distance to Pin", "16777215"):
        assert name in notes


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        (
            "gspro",
            {"path": ([1.2, -0.4, -1.1], "deg"), "face": ([2.6, -1.3, -0.6], "deg")}
            | {"azimuth": ([1.9, -1.1, -0.4], "deg"), "attack": ([2.6, 1.8, -3.1], "deg")}
            | {"total_side": ([11.4, -8.2, -3.1], "yd"), "spin_axis": ([4.1, -3.0, -1.0], "deg")}
            | {"backspin": ([2650, 2810, 6210], "rpm"), "landing_angle": ([37.2, 36.0, 45.1], "deg")},
        ),
        (
            "square",
            {"path": ([-2.1, 0.3, -4.2, -1.1, 0.0], "deg"), "sidespin": ([283, -104, 506, -283, 144], "rpm")}
            | {"azimuth": ([-1.2, 0.5, -2.8, -0.6, 0.0], "deg"), "carry": ([152.2, 158.1, 146.9, 108.2, 110.9], "yd")},
        ),
    ],
)
def test_sides_are_written_as_letters_behind_or_before_the_number(name, expected):
    shots = launch_monitor.read(DATA / f"{name}.csv")
    assert (shots.format, shots.rejected) == (name, ())
    assert_si(shots, **expected)


def test_the_direction_of_the_swing_is_no_path_and_the_roll_of_a_ball_no_roll_of_a_face(write):
    head = "Club Speed (mph),Ball Speed (mph),Swing Direction (deg),Dyn. Loft (deg),Roll (yd)"
    shots = launch_monitor.read(write(f"{head}\n100,147,3,12,20\n"))
    assert set(shots.deliveries) == {"speed", "loft"}
    assert noted(shots, "columns-not-read") == [{"columns": ["Swing Direction (deg)", "Roll (yd)"]}]


def test_9999_rpm_of_backspin_is_a_lob_wedge(write):
    assert_si(launch_monitor.read(write("Ball Speed (mph),Back Spin (rpm)\n60,9999\n")), backspin=([9999], "rpm"))


@pytest.mark.parametrize(
    ("columns", "cells", "expected"),
    [
        ("Club Path (deg),Face to Path (deg)", "2,-0.5", {"path": 2.0, "face": 1.5}),
        ("Face to Target (deg),Face to Path (deg)", "1,0.2", {"face": 1.0, "path": 0.8}),
        ("Club Path (deg),Face Angle (deg),FTP (deg)", "2,1.5,-0.5", {"path": 2.0, "face": 1.5}),
        ("Club Path (deg),Face to Path (deg)", "2,16777215", {"path": 2.0}),
    ],
)
def test_face_path_and_the_angle_between_them_complete_each_other(write, columns, cells, expected):
    shots = launch_monitor.read(write(f"Ball Speed (mph),{columns}\n147,{cells}\n"))
    measured = {name: values[0] for name, values in shots.deliveries.items()}
    assert measured == pytest.approx({name: to_si(value, "deg") for name, value in expected.items()})


def test_a_face_to_path_that_contradicts_face_and_path_is_not_used_and_named(write):
    shots = launch_monitor.read(write("Ball Speed (mph),Club Path (deg),Face Angle (deg),FTP (deg)\n147,2,1.5,4\n"))
    assert_si(shots, face=([1.5], "deg"))
    assert [each["line"] for each in noted(shots, "face-and-path-contradict")] == [2]


def test_unread_number_columns_are_listed_and_names_and_dates_are_not(write):
    content = (
        "Shot,Date,Club,Ball Speed (mph),Swing Direction (deg),Wobble,Roll (yd),Remark,Next,Distance to Pin (m)\n"
        "1,2026-05-01,Driver,147,0.1,12.5,22,7 iron next,7 iron,198.2\n"
        "2,2026-05-01,Driver,146,0.2,12.7,21,good,8 iron,190.1 m\n"
    )
    (unread,) = noted(launch_monitor.read(write(content)), "columns-not-read")
    assert unread["columns"] == ["Swing Direction (deg)", "Wobble", "Roll (yd)", "Distance to Pin (m)"]


def test_an_impact_point_without_a_side_is_noted_as_towards_the_toe(write):
    for heading, is_stated in (("Horiz Impact (mm)", True), ("Impact Toe (mm)", False)):
        shots = launch_monitor.read(write(f"Ball Speed (mph),{heading}\n147,4\n"))
        assert ("toe-unsigned" in codes(shots)) == is_stated
        assert_si(shots, toe=([4], "mm"))


def test_a_column_called_speed_is_neither_guessed_to_be_the_clubs_nor_the_balls(write):
    shots = launch_monitor.read(write("Club,Speed (mph),Launch Angle (deg)\nDriver,100,12\n"))
    assert "speed" not in shots.deliveries
    assert "ball_speed" not in shots.launches
    assert noted(shots, "speed-of-club-or-ball") == [{"column": "Speed (mph)"}]
    with pytest.raises(FileError, match=r"csv:1: .*Speed \(mph\) may be the speed of the club or of the ball"):
        launch_monitor.read(write("Club,Speed (mph)\nDriver,100\n"))
    assert "speed" in launch_monitor.read(write("club,speed_mph\nDriver,100\n")).deliveries


def test_carry_on_level_ground_is_read_only_where_there_is_no_carry(write):
    shots = launch_monitor.read(write("Ball Speed (mph),Carry Dist (yd),Flat Carry (yd)\n147,240,231\n"))
    assert_si(shots, carry=([240], "yd"))
    assert noted(shots, "columns-not-read") == [{"columns": ["Flat Carry (yd)"]}]
    assert_si(launch_monitor.read(write("Ball Speed (mph),Flat Carry (yd)\n147,231\n")), carry=([231], "yd"))


@pytest.mark.parametrize(
    ("heading", "value"),
    [
        ("Side Spin (rpm)", "-9999"), ("Face Angle (deg)", "16777215.000000"), ("Dynamic Loft (deg)", "65535"),
        ("Carry (yd)", "9999"), ("Carry (yd)", "-9999"), ("Back Spin (rpm)", "-32768"), ("Launch Angle (deg)", "999.9"),
        ("Closure Rate (deg/s)", "32767"), ("Attack Angle (deg)", "---"), ("Side Spin (rpm)", "32767"),
    ],
)  # fmt: skip
def test_placeholder_numbers_are_no_measurements_and_prove_no_unit(write, heading, value):
    rows = f"147,{value}\n" * 3
    shots = launch_monitor.read(write(f"Ball Speed (mph),{heading}\n{rows}"))
    assert set(shots.deliveries | shots.launches) == {"ball_speed"} or all(
        np.isnan(values).all() for name, values in (shots.deliveries | shots.launches).items() if name != "ball_speed"
    )
    assert value == "---" or {"placeholders-for-nothing", "impossible-values"} & codes(shots)


@pytest.mark.parametrize("name", sorted(FORMATS))
def test_no_two_quantities_of_a_layout_have_the_same_heading(name):
    headings = [each for field in FORMATS[name].fields.values() for each in field.headings]
    assert len(headings) == len(set(headings))
