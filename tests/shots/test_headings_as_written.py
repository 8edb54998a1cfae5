"""Headings are known however they are spelled, in the languages of golfers, with the unit wherever it stands."""

import numpy as np
import pytest

import clubface
from attached_notes import codes, noted
from clubface import shots as launch_monitor
from clubface.errors import FileError
from clubface.quantities import quantity
from clubface.shots.formats import MEASURED
from clubface.shots.monitors import FORMATS, TABLE
from clubface.shots.tables.headings import DELIVERY_QUANTITIES, HAND, delivery_words, shot_words, vocabulary
from clubface.units import to_si


def assert_si(shots, **expected):
    measured = shots.deliveries | shots.launches
    for name, (values, symbol) in expected.items():
        np.testing.assert_allclose(measured[name], to_si(np.array(values), symbol), rtol=1e-12, err_msg=name)


@pytest.mark.parametrize(
    "headings",
    [
        "BallSpeed (mph),LaunchAngle (deg),SpinRate (rpm)", "ballSpeedMph,launchAngleDeg,spinRateRpm",
        "BALLSPEED_MPH,LAUNCHANGLE_DEG,SPINRATE_RPM", "Ball Speed in mph,Launch Angle in degrees,Spin in rpm",
        "Ball Speed/mph,Launch Angle/deg,Spin/rpm", "Ball Speed - mph,Launch Angle - deg,Spin - rpm",
        "BALL MPH,LAUNCH DEG,SPIN RPM", "Ballgeschwindigkeit (mph),Abflugwinkel (°),Spinrate (U/min)",
        "Vitesse de balle (mph),Angle de lancement (°),Taux de rotation (tr/min)",
        "Velocidad de bola (mph),Ángulo de lanzamiento (°),Giro (rpm)",
        "Bollhastighet (mph),Utgångsvinkel (grader),Spinn (varv/min)",
        "ボールスピード（mph）,打出角（度）,スピン量（rpm）", "球速(英里/小时),起飞角(度),总旋转(转/分)",
        "볼 스피드(mph),발사각(도),스핀량(rpm)",
    ],
)  # fmt: skip
def test_a_drive_is_the_same_drive_in_every_spelling(write, headings):
    shots = launch_monitor.read(write(headings + "\n147,12.5,2600\n"))
    assert_si(shots, ball_speed=([147], "mph"), launch=([12.5], "deg"), total_spin=([2600], "rpm"))


def test_a_heading_of_another_language_means_one_quantity():
    words = [name for names in vocabulary()["headings"].values() for name in names]
    assert len(words) == len(set(words))
    assert set(vocabulary()["headings"]) <= set(shot_words().dimensions)


def test_tables_of_deliveries_and_files_of_monitors_know_every_synonym_of_the_registry():
    """One vocabulary: what a table of deliveries calls a quantity, a file of shots calls it too, however spelled."""
    for name in (each for each in DELIVERY_QUANTITIES if each != HAND):
        for synonym in quantity(name).synonyms:
            for spelled in (synonym, synonym.replace("_", " ").title(), synonym.replace("_", "").upper()):
                assert delivery_words().quantity(spelled) == name, spelled
                for reader in (TABLE, FORMATS["trackman"]) if name in MEASURED else (TABLE,):
                    assert reader.names[reader.heading(spelled).name][0] == name, (reader.name, spelled)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Shot,Club,Ball Speed,Carry,Hang Time\n#,-,mph,yards,seconds\n1,Driver,147,230,6.1\n",
            {"ball_speed": ([147], "mph"), "carry": ([230], "yd"), "flight_time": ([6.1], "s")},
        ),
        (
            "HAND,BALL,LAUNCH,BACK,SIDE,SIDE,CLUB\n,MPH,DEG,RPM,RPM,DEG,MPH\nR,150,11.2,2500,210,1.1,102\n",
            {"ball_speed": ([150], "mph"), "speed": ([102], "mph"), "backspin": ([2500], "rpm")}
            | {"sidespin": ([210], "rpm"), "azimuth": ([1.1], "deg")},
        ),
        (
            "Time,Club,Ball,Ball Speed (mph),Smash,Flight Time (s)\n10:15,Driver,Pro,147,1.47,6.1\n",
            {"ball_speed": ([147], "mph"), "flight_time": ([6.1], "s")},
        ),
        (
            "Ball Speed (mph),Launch Direction (deg)\n１４７．５,1.1 H\n147.5,1.1 V\n147.5,1.1 i\n147.5,右1.1\n",
            {"ball_speed": ([147.5] * 4, "mph"), "azimuth": ([1.1, -1.1, -1.1, 1.1], "deg")},
        ),
        ("Club,Club (mph),Ball (mph)\nDriver,100,147\n", {"speed": ([100], "mph"), "ball_speed": ([147], "mph")}),
    ],
    ids=["signs in a row of units", "side and back by their unit", "of two columns the one with a unit",
         "wide digits and sides of other languages", "club and ball as speeds"],
)  # fmt: skip
def test_headings_units_and_cells_are_understood_together(write, text, expected):
    shots = launch_monitor.read(write(text))
    assert_si(shots, **expected)
    assert shots.clubs is None or shots.clubs.tolist() == ["Driver"]


def test_a_file_in_kmh_of_a_program_that_names_no_units_is_not_read_in_mph(write):
    text = "Club Speed,Ball Speed,Launch Direction,Dyn. Loft\n161,237,0.1,13\n160,235,0.2,13\n"
    with pytest.raises(FileError, match="km/h"):
        launch_monitor.read(write(text))
    shots = launch_monitor.read(write(text), units={"speed": "km/h"})
    assert_si(shots, ball_speed=([237, 235], "km/h"))


def test_a_word_alone_below_the_header_begins_no_table(write):
    shots = launch_monitor.read(write("Club,Ball Speed (mph),Total (yd)\nDriver,147,250\nTotal,,\nDriver,146,249\n"))
    assert len(shots) == 2


def test_a_table_of_deliveries_knows_the_same_spellings(tmp_path):
    (tmp_path / "swings.csv").write_text("ClubSpeedMph,AttackAngleDeg,Schlägerpfad in deg,FaceAngle/deg\n100,1,2,3\n")
    launches = clubface.predict(tmp_path / "swings.csv", club="driver", model="standard")
    assert "column-misspelled" not in codes(launches)


def test_a_backspin_and_a_sidespin_of_minus_one_are_no_measurements(write):
    shots = launch_monitor.read(write("Ball Speed (mph),Back Spin (rpm),Side Spin (rpm)\n147,-1,-1\n147,2500,0\n"))
    assert np.isnan(shots.launches["total_spin"]).tolist() == [True, False]


def test_a_row_of_units_among_the_shots_changes_the_units_of_those_below(write):
    text = "Club,Ball Speed,Carry\n,(mph),(yd)\nDriver,147,230\n,(m/s),(m)\nDriver,65.7,210\n"
    shots = launch_monitor.read(write(text))
    assert not shots.rejected
    assert_si(shots.select([0]), ball_speed=([147], "mph"), carry=([230], "yd"))
    assert_si(shots.select([1]), ball_speed=([65.7], "m/s"), carry=([210], "m"))


def test_a_number_that_is_marked_as_estimated_is_read_and_noted(write):
    shots = launch_monitor.read(write("Ball Speed (mph),Spin Rate (rpm)\n147,2509.1*\n146,2600\n"))
    assert_si(shots, total_spin=([2509.1, 2600], "rpm"))
    assert noted(shots, "marks-read") == [{"column": "Spin Rate (rpm)"}]
