"""The comparison with the published tour averages."""

import csv
import dataclasses
import io
import json
import math

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.equipment.clubs import CLUB_NAMES
from clubface.errors import InputError, UnknownNameError
from clubface.tour import averages as job, report, tables as tour_tables


@pytest.fixture(scope="module")
def result() -> job.Tour:
    return job.tour(["standard", "volumetric"])


def test_the_published_averages_are_read_with_their_units():
    rows = job.averages()
    driver, wedge = rows[0], rows[-1]
    # The rows of the published table, to the last digit: a conversion is the only arithmetic.
    assert driver.club_speed == pytest.approx(115 * 0.44704, rel=1e-15)
    assert driver.attack == pytest.approx(math.radians(-0.9), rel=1e-15)
    assert driver.spin == pytest.approx(2545 * math.pi / 30, rel=1e-15)
    assert driver.carry == pytest.approx(282 * 0.9144, rel=1e-15)
    assert (wedge.club, wedge.smash) == ("pitching-wedge", 1.24)


def test_every_built_in_club_has_its_row():
    assert tuple(each.club for each in job.averages()) == CLUB_NAMES


def test_the_two_published_lofts_are_used_as_they_are(result):
    lofts = dict(zip(result.clubs, np.degrees(result.lofts), strict=True))
    assert lofts["driver"] == pytest.approx(12.8, rel=1e-14)
    assert lofts["6-iron"] == pytest.approx(20.2, rel=1e-14)
    assert [club for club, given in zip(result.clubs, result.loft_is_published, strict=True) if given] == [
        "driver",
        "6-iron",
    ]


def test_every_other_loft_gives_the_published_launch_angle_with_the_standard_model(result):
    errors = result.errors("standard")["launch"]
    solved = ~np.array(result.loft_is_published)
    # The loft is solved to 1e-10 rad, and the launch angle changes by less than that of the loft.
    assert np.abs(errors[solved]).max() < 1e-9
    assert np.abs(errors[~solved]).min() > math.radians(0.1)


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_another_ball_is_hit_by_every_club_and_told(result):
    light = dataclasses.replace(clubface.Ball.builtin("published"), name="light", mass="44 g")
    other = job.tour(["standard"], ball=light)
    assert "Ball: light." in tour_tables.notes(other)
    assert not any(note.startswith("Ball:") for note in tour_tables.notes(result))
    # Momentum: 1 + m/M with a mass 4.1% less, for heads of 200 to 300 g some 0.6 to 0.8%.
    change = other.values["standard"]["ball_speed"] / result.values["standard"]["ball_speed"] - 1.0
    assert ((change > 0.004) & (change < 0.01)).all()


@pytest.mark.parametrize(("attack", "launch"), [(0.0, 77.0), (0.0, 79.0), (40.0, 10.0)])
def test_a_launch_angle_out_of_reach_is_refused(attack, launch):
    with pytest.raises(InputError, match="launch angle driver can reach"):
        job.solve_loft("driver", 50.0, math.radians(attack), math.radians(launch))


def test_every_model_is_delivered_the_same(result):
    for launches in zip(*result.launches.values(), strict=True):
        first, *others = [(each.club.name, each.delivery) for each in launches]
        assert all(each == first for each in others)


def test_the_values_are_those_of_single_shots(result):
    index = result.clubs.index("7-iron")
    average = result.averages[index]
    shot = clubface.impact(
        "7-iron", speed=average.club_speed, attack=average.attack, loft=float(result.lofts[index]), model="volumetric"
    )
    values = {name: each[index] for name, each in result.values["volumetric"].items()}
    assert values == {
        "ball_speed": shot.ball_speed,
        "launch": shot.launch,
        "spin": shot.total_spin,
        "carry": clubface.fly(shot).carry,
    }


def test_errors_are_model_less_published(result):
    error = result.errors("volumetric")["spin"]
    published = units.parse("7124 rpm", "angular rate")
    index = result.clubs.index("7-iron")
    assert error[index] == result.values["volumetric"]["spin"][index] - published
    assert result.mean_absolute_error("volumetric")["spin"] == pytest.approx(np.mean(np.abs(error)), rel=1e-14)
    assert error[index] < 0.0, "the models spin irons too little here; the sign must show it"


def test_the_driver_carries_what_is_published_from_its_published_launch(result):
    # 6 %: the mean error of the aerodynamic fit is 2.5 m, and the published averages are of many different launches.
    carry = result.carry_of_published[0]
    assert carry == pytest.approx(units.parse("282 yd", "length"), rel=0.06)


def test_an_unknown_model_is_an_error_that_names_the_nearest():
    with pytest.raises(UnknownNameError, match="did you mean standard"):
        job.tour(["standart"])
    with pytest.raises(InputError):
        job.tour([])


def test_tables_do_not_show_a_fitted_value_as_an_error(result):
    _, rows = tour_tables.comparison(result, "launch", signed=True)
    by_club = {row[0]: row[2:] for row in rows}
    assert by_club["5-iron"][0] == tour_tables.FITTED
    assert by_club["driver"][0].startswith("+")
    assert by_club[tour_tables.MEAN][0] == tour_tables.FITTED
    assert tour_tables.FITTED not in by_club["5-iron"][1:]


def test_signed_errors_in_tables_have_their_sign_and_no_negative_zero():
    assert tour_tables._signed(0.04, 1) == "0.0"
    assert tour_tables._signed(-0.04, 1) == "0.0"
    assert tour_tables._signed(-0.06, 1) == "-0.1"
    assert tour_tables._signed(12.3, 0) == "+12"


def test_csv_and_json_hold_the_same_records(result):
    rows = list(csv.DictReader(io.StringIO(tour_tables.as_csv(result))))
    document = json.loads(tour_tables.as_json(result))
    assert len(rows) == len(CLUB_NAMES) * 2 == len(document["rows"])
    for row, record in zip(rows, document["rows"], strict=True):
        assert row["club"] == record["club"]
        assert float(row["spin_error_rpm"]) == record["spin_error_rpm"]
        difference = record["spin_rpm"] - record["published_spin_rpm"]
        # Each number is rounded to 1e-6.
        assert record["spin_error_rpm"] == pytest.approx(difference, abs=2e-6)
    assert set(document["mean_absolute_error"]) == {"standard", "volumetric"}


def test_the_markdown_says_where_lofts_come_from_and_has_a_table_a_quantity(result):
    text = tour_tables.as_markdown(result)
    assert "solved from the published launch angle with the standard model" in text
    assert "older tables" in text
    assert text.count("model less published") == len(job.QUANTITIES)
    widths = {line.count("|") for line in text.split("## Spin (rpm)")[1].split("##")[0].splitlines() if line}
    assert len(widths) == 1


def test_tables_and_pictures_are_written(result, tmp_path):
    pytest.importorskip("matplotlib")
    files = report.write(result, tmp_path / "new" / "out")
    assert [each.name for each in files] == [
        "tour.csv", "tour.md", "tour.json", "tour-launch.png", "tour-launch.svg", "tour-errors.png", "tour-errors.svg",
    ]  # fmt: skip
    assert all(each.stat().st_size > 1000 for each in files)
