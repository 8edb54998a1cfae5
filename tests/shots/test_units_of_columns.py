"""A number without a unit is never taken for SI, and a unit that no shot can have been written in is refused."""

import re
import shlex

import numpy as np
import pytest

import clubface
from attached_notes import noted
from clubface import shots as launch_monitor
from clubface.errors import FileError, UnitError

MPH, DEG, RPM, YD = 0.44704, np.pi / 180, np.pi / 30, 0.9144
SOME = (
    "Club,Carry (yd),Club Speed (mph),Ball Speed (mph),Smash Factor,Launch Angle,Launch Direction,Spin Rate,Club Path\n"
    "7-iron,160,85,112,1.32,18,0.4,6500,0.5\n7-iron,158,84.5,111,1.31,18.5,-0.9,6450,-1.1\n"
)
NONE = "Club,Ball Speed,Club Speed,Launch Angle,Spin Rate,Impact Toe,Carry\nDriver,147.0,100.1,12.5,2600,5,232\n"


def options_in(message):
    """Return the options that an error gives, as the command line splits them."""
    pairs = re.findall(r"--unit (\S+)", message)
    assert shlex.split(" ".join(pairs)) == pairs
    return dict(each.split("=") for each in pairs)


@pytest.mark.parametrize(("content", "lacking"), [(SOME, 4), (NONE, 6)])
def test_every_column_without_a_unit_is_named_and_what_the_error_gives_settles_it(write, content, lacking):
    path = write(content)
    with pytest.raises(FileError) as refused:
        launch_monitor.read(path)
    assert refused.value.line == 1
    message = str(refused.value)
    assert len(re.findall(r"'[A-Z]\w+( \w+)*'[ ,]", message)) == lacking
    units = options_in(message)
    shots = launch_monitor.read(path, units=units)
    assert str(units) in message
    assert shots.launches["ball_speed"][0] == pytest.approx((112 if content == SOME else 147) * MPH)
    assert shots.launches["launch"][0] == pytest.approx((18 if content == SOME else 12.5) * DEG)


def test_a_table_by_rows_of_arrow_needs_units_too(tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "shots.parquet"
    parquet.write_table(pyarrow.table({"ball_speed": [147.0], "smash": [1.47]}), path)
    with pytest.raises(FileError, match="'ball_speed' names no unit"):
        clubface.read_shots(path)
    assert clubface.read_shots(path, units={"speed": "mph"}).launches["ball_speed"][0] == pytest.approx(147 * MPH)


def test_spin_is_one_word_for_the_spins_of_a_ball(write):
    path = write("ball_speed_mph,backspin,sidespin,closure\n147,2600,-200,2000\n")
    units = {"spin": "rpm", "closure": "deg/s"}
    shots = launch_monitor.read(path, units=units)
    assert shots.launches["sidespin"][0] == pytest.approx(-200 * RPM)
    assert shots.deliveries["closure"][0] == pytest.approx(2000 * DEG)
    with pytest.raises(UnitError, match="unit of spin"):
        launch_monitor.read(path, units={"spin": "mph"})


def test_a_row_of_units_serves_a_table_of_no_maker(write):
    shots = launch_monitor.read(
        write("Club,Club Speed,Ball Speed,Attack Angle\n,[mph],[mph],[deg]\nDriver,100,147,-1\n")
    )
    assert shots.deliveries["attack"][0] == pytest.approx(-1 * DEG)


@pytest.mark.parametrize(
    ("content", "unit"),
    [
        ("Club,Club Speed (m/s),Ball Speed (mph)\n" + "Driver,105,152\n" * 3, "mph"),
        ("Club,Ball Speed (m/s)\n" + "Driver,212\n" * 3, "mph or km/h"),
        ("ball_speed_mph,launch_rad\n" + "147,12.5\n" * 3, "deg"),
        ("ball_speed_mph,toe [m]\n" + "147,4\n147,-3\n147,6\n", "mm"),
        ("ball_speed_mph,smash\n" + "147,147\n" * 3, "%"),
        # Each alone could be; together they cannot.
        ("Club,Club Speed (km/h),Ball Speed (mph)\n" + "Driver,100,147\n" * 3, "mph"),
        ("Club,Club Speed (mph),Ball Speed (km/h),Smash Factor\n" + "Driver,100,147,1.47\n" * 3, "mph"),
        ("Club,Ball Speed (km/h),Carry (yd)\n" + "Driver,65,230\n" * 3, "m/s"),
        # Longer than any flight at this speed lasts, though not longer than without air; and the other way about.
        ("Club,Ball Speed (mph),Carry (yd)\n" + "Driver,150,590\n" * 3, "ft"),
        ("Club,Ball Speed (mph),Carry (yd)\n" + "LW,20,30\n" * 3, "m/s"),
    ],
)
def test_values_that_only_another_unit_explains_name_that_unit(write, content, unit):
    with pytest.raises(FileError, match=f"most likely in {unit}"):
        launch_monitor.read(write(content))


def test_a_value_that_no_unit_explains_is_noted_and_dropped(write):
    """16777215 stands for nothing in Foresight's files: no unit makes it an angle of golf."""
    shots = launch_monitor.read(write("Club,Ball Speed (mph),Face Angle (deg)\n" + "Driver,147,16777215\n" * 3))
    assert np.isnan(shots.deliveries["face"]).all()
    assert [(each["wrong"], each["shots"]) for each in noted(shots, "impossible-values")] == [(3, 3)]


def test_a_unit_that_was_given_with_the_command_is_corrected_there_and_not_in_the_file(write):
    path = write("Club,Ball Speed\n" + "Driver,212\n" * 3)
    with pytest.raises(FileError, match=r"most likely in mph or km/h .*--unit ball_speed=mph"):
        launch_monitor.read(path, units={"ball_speed": "m/s"})


@pytest.mark.parametrize(
    ("text", "lost"),
    [
        ("Ball Speed (m/s),Launch Angle (deg)\n66,12\n65,13\n700,12\n64,11\n", [False, False, True, False]),
        ("Club Speed (m/s),Ball Speed (m/s),Launch Angle (deg)\n20,66,12\n21,65,13\n", [True, True]),
    ],
    ids=["one that no shot has", "two that contradict their club speeds"],
)
def test_a_few_impossible_speeds_are_lost_and_do_not_condemn_the_unit(write, text, lost):
    """The others would be slow balls if they were in mph, too."""
    shots = launch_monitor.read(write(text))
    assert np.isnan(shots.launches["ball_speed"]).tolist() == lost
    assert shots.launches["launch"][:2] == pytest.approx([12 * DEG, 13 * DEG])


def test_slow_and_odd_shots_are_no_sign_of_a_wrong_unit(write):
    """Chips, putts, topped balls and tailwinds of a real session."""
    head = "Club,Club Speed (mph),Ball Speed (mph),Launch Angle (deg),Carry (yd)\n"
    rows = "Putter,5,8.4,2,0.5\nMallet,5,8.4,2,0.5\nLW,20,15,40,8\nSW,25,30,35,20\n"
    rows += "Driver,110,90,2,60\nDriver,115,170,13,300\n"
    shots = launch_monitor.read(write(head + rows))
    assert len(shots) == 6
    assert shots.notes == ()


def test_a_ball_faster_than_its_club_can_send_it_is_in_no_mean(write):
    head = "Club,Club Speed (mph),Ball Speed (mph),Launch Angle (deg)\n"
    shots = launch_monitor.read(
        write(head + "PW,18,193,30\nPW,70,88,32\nSW,60,90,33\nDriver,100,157,12\nLW,50,30,45\n")
    )
    assert np.isnan(shots.deliveries["speed"]).tolist() == [True, False, True, False, False]
    assert np.isnan(shots.launches["ball_speed"]).tolist() == [True, False, True, False, False]
    assert not np.isnan(shots.launches["launch"]).any()
    (faster,) = noted(shots, "faster-than-club")
    assert (faster["lines"], faster["wrong"], faster["shots"]) == ([2, 4], 2, 5)
    assert faster["example"] == pytest.approx({"ball_speed": 193 * 0.44704, "speed": 18 * 0.44704})


@pytest.mark.parametrize("cell", ["inf", "nan?", "n.a.", "#DIV/0!", "1e999"])
def test_a_computed_cell_that_holds_no_number_costs_itself_and_not_the_shot(write, cell):
    shots = launch_monitor.read(write(f"Club Speed (mph),Ball Speed (mph),Smash Factor\n100,147,{cell}\n99,145,1.46\n"))
    assert np.isnan(shots.launches["smash"]).tolist() == [True, False]
    assert shots.rejected == ()
    assert [(each["column"], each["cells"]) for each in noted(shots, "cells-without-number")] == [("Smash Factor", 1)]
    shots = launch_monitor.read(write(f"Club Speed (mph),Ball Speed (mph)\n100,{cell}\n99,145\n"))
    assert [each.line for each in shots.rejected] == [2]


@pytest.mark.parametrize(
    ("heads", "cells", "speed"),
    [
        ("Ball Speed (mph),Ball Speed (m/s)", "147.0,65.7", 147 * MPH),
        ("Ball Speed (mph),Ball Speed (m/s)", "147.0,65.9", None),
        ("Ball Speed (mph),Ball Speed (km/h)", "147,237", 237 / 3.6),
        ("ball_speed_mph,Ball Speed [mph]", "147,146.8", 146.8 * MPH),
        ("ball_speed_mph,Ball Speed [mph]", "147,146", None),
        ("ball_speed_mph;Ball Speed [m/s]", '147,0;65,7', 147 * MPH),
    ],
)  # fmt: skip
def test_a_quantity_that_stands_twice_is_the_finer_one_if_they_agree_within_their_rounding(write, heads, cells, speed):
    delimiter = ";" if ";" in heads else ","
    row = delimiter.join(["Driver", cells, "12"])
    path = write(f"{delimiter.join(['club', heads, 'launch_deg'])}\n{row}\n")
    if speed is not None:
        assert launch_monitor.read(path).launches["ball_speed"][0] == pytest.approx(speed, rel=1e-14)
    else:
        with pytest.raises(FileError, match=r"line 2: .*differ"):
            launch_monitor.read(path)
