"""One's own session beside the model, and which camp of published irons it resembles."""

import json
from dataclasses import replace

import numpy as np
import pytest

from clubface.errors import InputError
from clubface.shots.recorded import join_sessions
from clubface.validation import own_monitor as own
from monitor_sessions import session


def spinning(shots, factor):
    """The same shots with more spin."""
    launches = {
        name: values * (factor if name in ("backspin", "sidespin", "total_spin") else 1.0)
        for name, values in shots.launches.items()
    }
    return replace(shots, launches=launches, derived={})


@pytest.fixture(scope="module")
def iron():
    return session("7-iron", 60, strikes=False, noise=0.3)


@pytest.fixture(scope="module")
def camps():
    return own.camps_of("7-iron", "response")


def verdict(shots):
    (club,) = own.own_monitor(shots).clubs
    return club


def test_shots_of_the_model_have_its_spin_and_ball_speed(iron):
    club = verdict(iron)
    assert club.shots == 60
    # 0.06 degrees of launch are 1% of the spin of a shot, and a seventh of that of the median of 60.
    assert club.spin_share.middle == pytest.approx(1.0, abs=0.004)
    assert club.spin_share.low < club.spin_share.middle < club.spin_share.high
    assert club.speed_share.middle == pytest.approx(1.0, abs=0.001)


def test_a_monitor_resembles_the_camp_in_which_its_spin_lies(iron, camps):
    for name, (low, high) in camps.items():
        assert verdict(spinning(iron, 0.5 * (low + high))).resembles == name


def test_a_spin_between_the_camps_is_undecided_and_one_beyond_both_is_neither(iron, camps):
    middle = 0.5 * (camps[own.TOURS][0] + camps[own.SINGLE][1])
    assert camps[own.SINGLE][1] < camps[own.TOURS][0]
    assert verdict(spinning(iron, middle)).resembles == own.UNDECIDED
    assert verdict(spinning(iron, 2.0 * camps[own.TOURS][1])).resembles == own.NEITHER
    assert verdict(spinning(iron, 0.5 * camps[own.SINGLE][0])).resembles == own.NEITHER


def test_lofts_of_the_file_change_nothing(iron):
    bare = {name: values for name, values in iron.deliveries.items() if name not in ("loft", "face")}
    assert verdict(replace(iron, deliveries=bare))._replace(camps={}) == verdict(iron)._replace(camps={})


def test_without_the_path_the_start_direction_opens_no_face(iron):
    bare = {name: values for name, values in iron.deliveries.items() if name != "path"}
    azimuths = replace(iron, deliveries=bare, launches=iron.launches | {"azimuth": np.full(60, 0.2)})
    assert verdict(azimuths).spin_share.middle == pytest.approx(1.0, abs=0.03)


def test_the_indices_of_both_camps_follow_from_the_published_tables():
    (row,) = [each for each in own.camp_table().records() if each["club"] == "7-iron"]
    # By hand: 7097 rpm at 90 mph, 16.3 + 4.3 deg (PGA Tour 2019); 4195 rpm at 80 mph, 20.4 + 2 deg (Quantum Max OS);
    # 6390 rpm at 86.49 mph, 21.37 + 2.58 deg (Bliss and Langdown).
    assert row["tours_least_index_rpm_per_mph"] == pytest.approx(224.1, abs=0.1)
    assert row["single_least_index_rpm_per_mph"] == pytest.approx(137.6, abs=0.1)
    assert row["single_most_index_rpm_per_mph"] == pytest.approx(182.0, abs=0.1)


def test_clubs_are_taken_one_by_one_and_what_cannot_be_compared_is_named():
    driver = session("driver", 20)
    drives = replace(driver, deliveries={name: each for name, each in driver.deliveries.items() if name != "high"})
    few = session("pitching-wedge", 3)
    result = own.own_monitor(join_sessions([drives, session("7-iron", 20, file_club="7i", seed=2), few]))
    assert [(each.club, each.head, bool(each.camps)) for each in result.clubs] == [
        ("driver", "driver", False), ("7i", "7-iron", True),
    ]  # fmt: skip
    notes = {each.code: each.data for each in result.notes}
    assert notes["own-monitor-left-out"]["club"] == "pitching-wedge"
    assert notes["own-monitor-strike"] == {"high": 0.003}
    json.dumps(result.to_result().to_dict(), allow_nan=False)
    with pytest.raises(InputError, match="shots"):
        own.own_monitor(few)


def test_an_iron_without_an_attack_angle_is_left_out_rather_than_taken_as_level(iron):
    level = {name: values for name, values in iron.deliveries.items() if name != "attack"}
    with pytest.raises(InputError, match="attack"):
        own.own_monitor(replace(iron, deliveries=level))


def test_validate_puts_a_session_beside_the_published_figures(iron, tmp_path, clubface_):
    iron.write(tmp_path / "session.csv")
    command = ["validate", "--check", "plates", "--with", str(tmp_path / "session.csv")]
    (club,) = clubface_(*command, "--json").json["tables"]["own_monitor"]["rows"]
    assert club["shots"] == 60
    shown = clubface_(*command).out
    assert "at its own measured launch" in " ".join(shown.split())
    assert "undecided" in shown
