"""Clubs go by many names; what each means."""

from __future__ import annotations

import pytest

from clubface.recorded.club_names import club_kind, may_be, same_club


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("driver", "driver"), ("Driver 9.5", "driver"), ("1W", "driver"), ("D", "driver"), ("Dr", "driver"),
        ("d", "driver"), ("7-iron", "7-iron"), ("7 Iron", "7-iron"), ("7i", "7-iron"), ("7I", "7-iron"),
        ("Iron 7", "7-iron"), ("i7", "7-iron"), ("7er Eisen", "7-iron"), ("Hierro 7", "7-iron"),
        ("P790 7 Iron", "7-iron"), ("7 Iron (Mizuno JPX 921)", "7-iron"), ("2 Driving Iron", "2-iron"),
        ("3 Wood", "3-wood"), ("3W", "3-wood"), ("FW3", "3-wood"), ("5w", "5-wood"), ("3 Fairway Wood", "3-wood"),
        ("4h", "4-hybrid"), ("5h", "5-hybrid"), ("Hy4", "4-hybrid"), ("Hybrid 4", "4-hybrid"),
        ("Híbrido 4", "4-hybrid"), ("hybrid", "hybrid"), ("PW", "pitching-wedge"), ("P", "pitching-wedge"),
        ("Pitching Wedge", "pitching-wedge"), ("PitchingWedge", "pitching-wedge"), ("Gap Wedge 50", "gap-wedge"),
        ("SW 56", "sand-wedge"), ("56", "56-wedge"), ("56°", "56-wedge"), ("60 deg Wedge", "60-wedge"),
        ("Putter", "putter"), ("G425 Max", None), ("", None), ("Club 3", None), ("12", None), ("TSR 62 X", None),
    ],
)  # fmt: skip
def test_a_club_is_known_by_what_people_call_it(name, kind):
    assert club_kind(name) == kind


def test_two_names_of_one_club_are_the_same():
    assert same_club("7i", "7 Iron")
    assert not same_club("7i", "8 Iron")
    assert same_club(" My Gamer", "my gamer ")
    assert not same_club("My Gamer", "7i")


@pytest.mark.parametrize(
    ("one", "other", "possible"),
    [
        ("sand-wedge", "56-wedge", True), ("46-wedge", "pitching-wedge", True), ("60-wedge", "sand-wedge", False),
        ("56-wedge", "54-wedge", False), ("sand-wedge", "lob-wedge", False), ("hybrid", "4-hybrid", True),
        ("3-hybrid", "4-hybrid", False), ("7-iron", "7-iron", True), ("7-iron", "56-wedge", False),
    ],
)  # fmt: skip
def test_a_wedge_by_its_loft_may_be_one_by_its_name(one, other, possible):
    assert may_be(one, other) == may_be(other, one) == possible
