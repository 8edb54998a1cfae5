"""Limits of the Equipment Rules (R&A and USGA), entered a second time: a club at a limit is none to warn of."""

import re
import warnings

import pytest

import clubface
from clubface.equipment.balls import BALL_DIAMETER_LIMIT, BALL_MASS_LIMIT
from clubface.errors import RuleWarning

OUNCE, INCH = 28.349523125e-3, 25.4e-3
pytestmark = pytest.mark.usefixtures("new_process")


def rule_warnings(**changes):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        clubface.club("driver").replace(**changes)
    return [str(each.message) for each in caught if issubclass(each.category, RuleWarning)]


@pytest.mark.parametrize(
    ("name", "most", "beyond", "words"),
    [
        # 5900 g cm2 with a tolerance of 100.
        ("iyy", "6000 g cm2", "6001 g cm2", "moment of inertia about the vertical axis 6001 g cm2 .* 5900 g cm2"),
        ("cor", 0.83, 0.8301, "COR 0.830 is above the rule limit of 0.83"),
        # 239 us with a tolerance of 18.
        ("characteristic_time", "257 us", "258 us", "characteristic time 258 us is above the rule limit of 239 us"),
    ],
)
def test_a_club_is_warned_of_from_beyond_the_limit_on(name, most, beyond, words):
    assert rule_warnings(**{name: most}) == []
    (text,) = rule_warnings(**{name: beyond})
    assert re.search(words, text)


def test_the_inertia_of_irons_is_free():
    assert rule_warnings(iyy="6500 g cm2", izz="5000 g cm2", kind="iron") == []


def test_the_limits_of_a_ball_are_those_in_ounces_and_inches():
    """1.620 ounces avoirdupois and 1.680 inches, which the rules also give as 45.93 g and 42.67 mm."""
    limits = {"mass": BALL_MASS_LIMIT, "diameter": BALL_DIAMETER_LIMIT}
    assert limits == {"mass": 0.04593, "diameter": 0.04267}
    assert limits == pytest.approx({"mass": 1.620 * OUNCE, "diameter": 1.680 * INCH}, abs=0.5e-5)
