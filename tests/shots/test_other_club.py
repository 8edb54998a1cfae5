"""Shots of another club than the one given are known by their names and by their dynamic loft."""

from __future__ import annotations

import numpy as np
import pytest

import clubface
from clubface.equipment.clubs import TOUR_CLUBS
from clubface.errors import InputError, UnknownNameError
from clubface.inference.prior import prior_of
from clubface.shots.measured import check_club


@pytest.mark.parametrize("name", TOUR_CLUBS)
def test_a_tour_players_own_club_is_never_taken_for_another(name):
    """The loft that gives the published launch angle: up to 13 degrees less than the static one (9-iron)."""
    club = clubface.club(name)
    loft = prior_of("tour", club).mean["loft"]
    assert check_club(club, [name], np.full(5, loft)) == []


@pytest.mark.parametrize("name", TOUR_CLUBS)
def test_benchmark_drives_and_7_irons_are_distinguished(name):
    """Their median dynamic lofts are 17.4 and 25.2 degrees."""
    pytest.importorskip("pyarrow")
    club = clubface.club(name)
    for used, others in (
        ("driver", {"7-iron", "8-iron", "9-iron", "pitching-wedge"}),
        ("7-iron", {"driver", "pitching-wedge"}),
    ):
        lofts = clubface.validation.benchmark_data.load(used).measured.deliveries["loft"]
        suspected = bool(check_club(club, None, lofts, "note"))
        assert suspected == (name in others), used


def test_a_mismatch_is_refused_or_noted_and_nothing_else():
    driver, lofts = clubface.club("driver"), np.radians([28.0, 28.92])
    with pytest.raises(InputError, match=r"club is 'driver'.*median dynamic loft is 28.5 deg.*--mismatch note"):
        check_club(driver, None, lofts)
    with pytest.raises(InputError, match="the shots name 7 Iron, PW, not driver"):
        check_club(driver, ["7 Iron", "", "PW", "7 Iron", "Driver"], np.empty(0))
    assert check_club(driver, ["Driver", "G430", ""], np.empty(0)) == []
    assert check_club(driver.replace(name="prototype"), ["7 Iron"], np.empty(0)) == []
    loft = float(np.median(lofts))
    other = {"delivered_loft": loft, "static_loft": driver.loft, "club": "driver"}
    assert check_club(driver, None, lofts, "note") == [("median-loft-of-other-club", other)]
    with pytest.raises(UnknownNameError, match="refuse, note"):
        check_club(driver, None, lofts, "ignore")
