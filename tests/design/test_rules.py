"""The rules of golf: the limits as published, and a club beside them."""

import json
from pathlib import Path

import pytest

from clubface import club
from clubface.design.rules import SPRING_ERROR, check_rules, rules, rules_of
from clubface.equipment import clubs

HEAD = {"volume": "460 cm3", "size": ("115 mm", "62 mm", "124 mm")}


def test_the_limits_are_those_of_the_rules():
    """460 + 10 cm3, 5900 + 100 g cm2, 239 + 18 us, 5 in and 2.8 in."""
    result = {name: (each.most, each.tolerance) for name, each in rules().items()}
    assert result["volume"] == pytest.approx((460e-6, 10e-6))
    assert result["moment_of_inertia"] == pytest.approx((5900e-7, 100e-7))
    assert result["characteristic_time"] == pytest.approx((239e-6, 18e-6))
    assert result["heel_to_toe"] == pytest.approx((0.127, 0.0))
    assert result["sole_to_crown"] == pytest.approx((0.07112, 0.0))
    assert all("USGA" in each.source or "R&A" in each.source for each in rules().values())


def test_clubs_are_warned_of_at_the_same_limits():
    """A club itself knows two limits without reading any file; they must be the published ones."""
    result = rules()
    assert result["moment_of_inertia"].most == pytest.approx(clubs.MOI_LIMIT)
    assert result["moment_of_inertia"].tolerance == pytest.approx(clubs.MOI_TOLERANCE)
    assert result["characteristic_time"].most == pytest.approx(clubs.TIME_LIMIT)
    assert result["characteristic_time"].tolerance == pytest.approx(clubs.TIME_TOLERANCE)


def words(head, **size):
    return {each.rule.name: each.words for each in check_rules(head, **size)}


def test_the_published_driver_conforms_and_its_face_only_within_the_tolerance():
    assert words("driver", **HEAD) == {
        "moment_of_inertia": "conforms",
        "characteristic_time": "conforms within the tolerance",
        "volume": "conforms",
        "heel_to_toe": "conforms",
        "sole_to_crown": "conforms",
        "face_to_back": "conforms",
    }


@pytest.mark.parametrize(
    ("limit", "size", "changes"),
    [
        ("moment_of_inertia", HEAD, {"iyy": "6001 g cm2"}),
        ("characteristic_time", HEAD, {"characteristic_time": "257.1 us"}),
        ("volume", {**HEAD, "volume": "471 cc"}, {}),
        ("heel_to_toe", {**HEAD, "size": ("115 mm", "62 mm", "127.1 mm")}, {}),
        ("sole_to_crown", {**HEAD, "size": ("115 mm", "71.2 mm", "124 mm")}, {}),
        ("face_to_back", {**HEAD, "size": ("125 mm", "62 mm", "124 mm")}, {}),
    ],
)
@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_each_broken_limit_is_reported_alone(limit, size, changes):
    result = words(club("driver").replace(**changes), **size)
    assert [name for name, verdict in result.items() if verdict == "does not conform"] == [limit]


def test_unknown_figures_are_not_called_conforming():
    assert words("driver")["volume"] == "not known"


def test_irons_have_no_limit_of_size_and_steep_faces_none_of_spring():
    assert [each.name for each in rules_of("7-iron")] == ["characteristic_time"]
    assert rules_of("pitching-wedge") == ()


def test_the_stated_error_of_a_spring_is_that_of_the_simulated_heads():
    figures = Path(__file__).parents[2] / "docs" / "fem-figures.json"
    heads = json.loads(figures.read_text(encoding="utf-8"))["heads"]["figures"].values()
    # To the three places that the note shows.
    assert max(abs(each["spring"] - each["shells"]) for each in heads) == pytest.approx(SPRING_ERROR, abs=5e-4)
