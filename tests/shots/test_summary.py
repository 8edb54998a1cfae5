"""What a session says of each club: only what was measured counts, and clubs are known by all their names."""

from __future__ import annotations

import numpy as np
import pytest

from clubface import shots as launch_monitor
from clubface.errors import InputError
from clubface.shots.session_summary import session_picture, summarize_clubs

YD, MPH = 0.9144, 0.44704
BAG = (
    "club,ball_speed_mph,smash,total_spin_rpm,carry_yd,side_yd\n"
    "7i,120,1.4,6000,160,4\nDr,150,1.45,2500,250,10\n7 Iron,116,-45,-21474836480,156,-2\nDriver,146,1.47,,240,-10\n"
    "PW,104,,9000,120,1\n7-iron,118,1.38,6400,158,1\n"
)


@pytest.fixture
def bag(write):
    return write(BAG, "bag.csv")


def test_means_and_spreads_are_those_of_the_measured_values_of_a_club(bag):
    driver, seven, wedge = summarize_clubs(launch_monitor.read(bag))
    assert [each.club for each in (driver, seven, wedge)] == ["Dr", "7i", "PW"]
    assert seven.places.tolist() == [0, 2, 5]
    assert seven.spreads["total_spin"][:2] == (2, pytest.approx(np.pi / 30 * 6200, rel=1e-14))
    assert seven.mishits == ()
    assert seven.spreads["smash"].mean == pytest.approx(1.39, rel=1e-14)
    assert seven.spreads["carry"][:3] == (3, pytest.approx(158 * YD, rel=1e-14), pytest.approx(2 * YD, rel=1e-14))
    carry = seven.spreads["carry"]
    assert (carry.measured, carry.mean, carry.deviation) == (3, carry.median, carry.spread)
    assert driver.spreads["side"][:3] == (2, 0.0, pytest.approx(np.sqrt(200) * YD, rel=1e-14))
    assert np.isnan(wedge.spreads["carry"].spread)
    assert "speed" not in driver.spreads


def test_gaps_are_differences_of_median_carries_with_their_errors(bag):
    driver, seven, wedge = summarize_clubs(launch_monitor.read(bag))
    assert driver.gap is not None
    assert driver.gap.length == pytest.approx((245 - 158) * YD, rel=1e-13)
    # Standard errors: 5 sqrt(2) / sqrt(2) = 5 yd of two drives, whose median is the mean, and sqrt(pi / 2) 2 / sqrt(3)
    # yd of three irons.
    assert driver.gap.error == pytest.approx(np.sqrt(25 + np.pi / 2 * 4 / 3) * YD, rel=1e-13)
    assert seven.gap is not None
    assert np.isnan(seven.gap.error)
    assert wedge.gap is None


def test_a_session_without_carry_or_clubs_is_summed_up_all_the_same(write):
    (only,) = summarize_clubs(launch_monitor.read(write("ball_speed_mph,launch_deg\n150,12\n148,11\n")))
    assert (only.club, only.gap, only.spreads["ball_speed"].shots) == ("", None, 2)
    fast, slow, none = summarize_clubs(
        launch_monitor.read(write("club,ball_speed_mph,launch_deg\n7i,118,18\nDr,150,12\nPutter,,1\n"))
    )
    assert [each.club for each in (fast, slow, none)] == ["Dr", "7i", "Putter"]


def test_the_command_prints_a_table_and_draws_a_picture(clubface_, bag, tmp_path):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "bag.svg"
    ran = clubface_("monitor", "summary", str(bag), "--plot", str(picture))
    assert ran.status == 0
    rows = [line.split() for line in ran.out.splitlines()]
    assert ["Dr", "2", "148.0", "2.8", "1.460", "0.014", "2500", "245.0", "7.1", "0.0", "14.1", "87.0"] in rows
    message = " ".join(ran.out.split())
    assert "-21474836480 rpm in 1 of 6 shots" in message
    assert "1 of 2 of Dr, 2 of 3 of 7i" in message
    assert "the gap between 7i and PW is uncertain: 38.0 yd with a single shot" in message
    assert "between Dr and 7i" not in message
    assert picture.read_text().count("<svg") == 1


def test_conditions_and_json(clubface_, bag):
    ran = clubface_("monitor", "summary", str(bag), "--where", "club == 'driver' or smash > 1.39", "--json")
    clubs = ran.json["tables"]["clubs"]["rows"]
    assert [(each["club"], each["shots"]) for each in clubs] == [("Dr", 2), ("7i", 1)]
    assert clubs[0]["gap_m"] == pytest.approx((245 - 160) * YD, rel=1e-13)
    assert clubs[0]["gap_error_m"] is None
    assert clubface_("monitor", "summary", str(bag), "--where", "carry > 999 yd").status == 2


def test_a_picture_needs_carries(write):
    shots = launch_monitor.read(write("ball_speed_mph\n150\n"))
    with pytest.raises(InputError, match="no carry"):
        session_picture(shots, summarize_clubs(shots))


def test_the_picture_shows_each_club_where_it_lands(bag):
    shots = launch_monitor.read(bag)
    landings, carries = session_picture(shots, summarize_clubs(shots)).panels()
    points = [mark for mark in landings.marks if mark.kind == "points"]
    assert [len(mark.x) for mark in points] == [2, 3, 1]
    np.testing.assert_allclose(points[1].y, YD * np.array([160, 156, 158]), rtol=1e-14)
    (ellipse,) = (mark for mark in landings.marks if mark.kind == "outline")  # of the only club with three shots
    # Sides of 4, -2 and 1 and carries of 160, 156 and 158 yd lie on a line: the ellipse is a stroke as long as twice
    # the standard deviation along it, sqrt(3**2 + 2**2). A square root of rounding remains of its width.
    around = np.column_stack([ellipse.x, ellipse.y]) / YD - [1.0, 158.0]
    assert 2 * np.hypot(*around.T).max() == pytest.approx(2 * np.sqrt(13), rel=2e-3)  # 72 corners
    np.testing.assert_allclose(around @ [2, -3], 0.0, atol=1e-5)
    assert list(carries.x.names) == ["Dr", "7i", "PW"]
    assert any("gap 87" in text for mark in carries.marks for text in mark.texts)
