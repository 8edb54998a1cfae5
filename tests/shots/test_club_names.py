"""Clubs go by many names; what each means."""

from __future__ import annotations

import pytest

from clubface.shots.club_names import club_kind, may_be, same_club


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
        ("9" * 5000 + " iron", None),
        # In the languages of golf.
        ("P-Wedge", "pitching-wedge"), ("P.W.", "pitching-wedge"), ("PWedge", "pitching-wedge"),
        ("S Wedge", "sand-wedge"), ("A-Wedge", "gap-wedge"), ("Sandwedge", "sand-wedge"),
        ("サンドウェッジ", "sand-wedge"), ("샌드 웨지", "sand-wedge"), ("沙坑杆", "sand-wedge"),
        ("56 Wedge", "56-wedge"), ("56º", "56-wedge"), ("56 Grad", "56-wedge"), ("56S", "56-wedge"),
        ("56度", "56-wedge"), ("Vokey SM9 56.10S", "56-wedge"),
        ("Fer 7", "7-iron"), ("F7", "7-iron"), ("Eisen 7", "7-iron"), ("E7", "7-iron"), ("Järn 7", "7-iron"),
        ("Jarn 7", "7-iron"), ("7:an järn", "7-iron"), ("Jern 7", "7-iron"), ("Ferro 7", "7-iron"),
        ("IJzer 7", "7-iron"), ("Rauta 7", "7-iron"), ("7番アイアン", "7-iron"), ("７番ｱｲｱﾝ", "7-iron"),
        ("7号铁", "7-iron"), ("七號鐵桿", "7-iron"), ("7번 아이언", "7-iron"), ("No. 7 Iron", "7-iron"),
        ("ドライバー", "driver"), ("ﾄﾞﾗｲﾊﾞｰ", "driver"), ("드라이버", "driver"), ("1号木", "driver"), ("1w", "driver"),
        ("Bois 3", "3-wood"), ("Holz 3", "3-wood"), ("Hölzer 3", "3-wood"), ("Fairwayholz 3", "3-wood"),
        ("Trä 3", "3-wood"), ("Træ 3", "3-wood"), ("スプーン", "3-wood"), ("11W", "11-wood"),
        ("UT4", "4-hybrid"), ("4U", "4-hybrid"), ("4 Utility", "4-hybrid"), ("Hybride 4", "4-hybrid"),
        ("5番ユーティリティ", "5-hybrid"),
        # The number of a model is not that of a club.
        ("TaylorMade P790 7i", "7-iron"), ("Srixon ZX5 7 Iron", "7-iron"), ("Ping i230 7 Iron", "7-iron"),
        ("King F9 5W", "5-wood"), ("Stealth2 HD 4H", "4-hybrid"), ("Ping S Wedge", "sand-wedge"),
        ("Callaway Apex 21 PW", "pitching-wedge"), ("Cleveland RTX6 56 SW", "sand-wedge"),
        ("Ping G430 10K", None), ("Titleist 716 AP2", None), ("Srixon ZX5 Iron", None), ("Ping i5", None),
        ("Cobra F9", None), ("Rogue ST 10.5 w", None), ("B21", None), ("G425 7", None), ("SIM2 Max D", None),
    ],
)  # fmt: skip
def test_a_club_is_known_by_what_people_and_makers_call_it(name, kind):
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
