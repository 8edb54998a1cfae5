"""How far an optimum is from each of its limits, and which of them it breaks."""

import math
from types import SimpleNamespace

import pytest

from clubface.design.optimisation.result import Verdict, _margin_verdicts, _range_verdict, _rule_verdict
from clubface.design.rules import Rule, RuleVerdict
from clubface.design.shells.run import broken
from clubface.quantities import quantity

INF = math.inf


@pytest.mark.parametrize(
    ("value", "low", "high", "margin"),
    [
        # A part of the range where there are two ends, of the limit where there is one.
        (0.012, 0.010, 0.020, 0.2), (0.018, 0.010, 0.020, 0.2),
        (0.010, 0.010, 0.020, 0.0), (0.025, 0.010, 0.020, -0.5),
        (0.012, 0.010, INF, 0.2), (0.008, -INF, 0.010, 0.2),
        (0.009, 0.010, INF, -0.1), (-0.012, -INF, -0.010, 0.2),
    ],
)  # fmt: skip
def test_a_margin_is_a_share_of_the_width_of_its_range_or_of_its_only_end(value, low, high, margin):
    verdict = _range_verdict("x", value, low, high, quantity("toe"))
    assert (verdict.least, verdict.value, verdict.most) == (low, value, high)
    assert verdict.margin == pytest.approx(margin, abs=1e-12)


@pytest.mark.parametrize(
    ("margin", "state"),
    [(0.2, "kept"), (1.01e-4, "kept"), (0.99e-4, "kept, at the limit"), (0.0, "kept, at the limit"),
     (-1e-3, "broken"), (math.nan, "not known")],
)  # fmt: skip
def test_a_limit_is_met_at_the_limit_or_broken_by_its_margin(margin, state):
    assert Verdict("x", quantity("toe"), 0.0, 0.0, 1.0, margin).state == state


RULE = Rule("characteristic_time", "characteristic time of the face", 239e-6, 18e-6, "us", "The Equipment Rules")


def test_the_tolerance_of_a_rule_widens_its_limit_where_it_is_granted():
    rule = RuleVerdict(RULE, 250e-6)
    with_tolerance, without = _rule_verdict(rule, True), _rule_verdict(rule, False)
    assert (with_tolerance.most, without.most) == pytest.approx((257e-6, 239e-6))
    assert with_tolerance.value == without.value == 250e-6
    assert with_tolerance.margin == pytest.approx(7 / 257)
    assert without.margin == pytest.approx(-11 / 239)
    unknown = _rule_verdict(RuleVerdict(RULE, math.nan), True)
    assert unknown.state == "not known"


@pytest.mark.parametrize(
    ("value", "conforms", "words"),
    [
        (239e-6, True, "conforms"), (240e-6, True, "conforms within the tolerance"),
        (257e-6, True, "conforms within the tolerance"), (257.01e-6, False, "does not conform"),
        (math.nan, None, "not known"),
    ],
)  # fmt: skip
def test_a_club_conforms_up_to_the_limit_and_its_tolerance_inclusive(value, conforms, words):
    verdict = RuleVerdict(RULE, value)
    assert (verdict.conforms, verdict.words) == (conforms, words)


def test_of_several_margins_of_a_name_the_smallest_counts():
    margins = [SimpleNamespace(name="a", value=0.5), SimpleNamespace(name="b", value=-0.1),
               SimpleNamespace(name="a", value=0.25), SimpleNamespace(name="b", value=2.0)]  # fmt: skip
    assert {each.limit: each.margin for each in _margin_verdicts(margins)} == {"a": 0.25, "b": -0.1}


def test_a_head_at_a_limit_keeps_it_and_one_beyond_breaks_it():
    limits = {"volume": (4.0e-4, 4.7e-4)}
    assert [broken(limits, {"volume": each}) for each in (4.0e-4, 4.5e-4, 4.7e-4)] == ["", "", ""]
    assert broken(limits, {"volume": 4.8e-4}) == "volume 480.0 cm3 above 470.0 cm3"
    assert broken(limits, {"volume": 3.9e-4}) == "volume 390.0 cm3 below 400.0 cm3"
