"""Pairs of published models that their published errors do not allow: the known ones, and no others."""

from __future__ import annotations

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.inference.evaluation import contradictions, pairs, published
from clubface.shots.measured import QUANTITIES
from clubface.validation import benchmark_data

pytest.importorskip("pyarrow")

KNOWN = {
    ("driver", "backspin"): {
        "standard adjusted", "standard volumetric", "adjusted slip", "adjusted volumetric", "adjusted rings",
        "slip volumetric", "volumetric rings",
    },
    ("driver", "launch"): {
        "standard volumetric", "adjusted volumetric", "adjusted area", "slip volumetric", "volumetric rings",
    },
    ("7-iron", "backspin"): {
        "standard rings", "adjusted rings", "slip rings", "volumetric rings", "rings area",
    },
    ("7-iron", "launch"): {
        "standard rings", "adjusted rings", "slip rings", "volumetric rings", "rings area",
    },
}  # fmt: skip
"""What fails with the default sets. A new failure is a mistake, or a set that has changed; so is one that is gone."""


def by_club_and_quantity(result):
    """The pairs by club and quantity."""
    by: dict[tuple[str, str], set[str]] = {}
    for each in result:
        by.setdefault((each.club, each.quantity), set()).add(f"{each.first} {each.second}")
    return by


def test_the_published_sets_contradict_each_other_where_it_is_known_and_the_clearest_stands_first():
    result = contradictions()
    assert by_club_and_quantity(result) == KNOWN
    ratios = [abs(each.difference) / each.allowed for each in result]
    assert ratios == sorted(ratios, reverse=True)
    assert ratios[-1] > 1.0


def test_every_pair_of_models_is_compared_with_both_clubs_in_every_quantity():
    result = pairs()
    assert {(each.club, each.quantity) for each in result} == {(c, q) for c in benchmark_data.CLUBS for q in QUANTITIES}
    assert len(result) == len({each[:4] for each in result}) == 2 * 5 * 15
    assert {each.first for each in result} | {each.second for each in result} == {name for name, _ in published()}


def test_the_rings_of_the_7_iron_differ_from_slip_by_more_than_both_errors():
    spin, launch = (
        next(each for each in pairs() if each[:4] == ("7-iron", name, "slip", "rings"))
        for name in ("backspin", "launch")
    )
    # Table 4 and Table 5: 583 + 653 rpm and 1.06 + 1.52 degrees.
    assert units.from_si(spin.allowed, "rpm") == pytest.approx(1236, rel=1e-12)
    assert units.from_si(launch.allowed, "deg") == pytest.approx(2.58, rel=1e-12)
    shots = benchmark_data.load("7-iron").measured.deliveries
    means = [
        np.mean(clubface.impact("7-iron", shots, model=name, ball=published_ball()).backspin)
        for name in ("slip", "rings")
    ]
    assert spin.difference == pytest.approx(means[0] - means[1], rel=1e-12)
    # That is what makes it a contradiction, whichever way it goes: rings spin more and launch lower.
    assert spin.difference < -spin.allowed
    assert launch.difference > launch.allowed


def test_stiffer_rings_agree_with_slip():
    stiffer = ParameterSet.builtin("rings", "7-iron").replace(ring_modulus="7.4e7 Pa")
    left = by_club_and_quantity(contradictions({("rings", "7-iron"): stiffer}))
    assert not any("slip rings" in each for each in left.values())
    assert left["driver", "backspin"] == KNOWN["driver", "backspin"]


def test_a_wrong_parameter_set_is_detected():
    """Planted: a restitution of 0.7 for the driver of `slip`, which costs some 7% of ball speed."""
    planted = ParameterSet.builtin("slip", "driver").replace(cor=0.7)
    result = by_club_and_quantity(contradictions({("slip", "driver"): planted}))
    assert result["driver", "ball_speed"] == {f"{name} slip" for name in ("standard", "adjusted")} | {
        f"slip {name}" for name in ("volumetric", "rings", "area")
    }


def test_the_least_errors_of_the_printed_tables_are_those_that_their_text_names():
    """Section 4 of Caldwell and McPhee, table by table: where a model is the best, and where it is not."""

    def least(club, *models):
        return {model: {name for name in QUANTITIES if published()[model, club].is_least(name)} for model in models}

    every = set(QUANTITIES)
    # "less ball speed error ... similar accuracy": Table 2. "All ... except for the vertical launch angle": Table 3.
    assert least("driver", "adjusted", "slip") == {"adjusted": every - {"sidespin"}, "slip": {"sidespin"}}
    contact = {"volumetric": every - {"launch"}, "rings": {"launch"}, "area": set()}
    assert least("driver", "volumetric", "rings", "area") == contact
    # "Vertical launch angle is improved with the variable slip model": Table 4.
    assert least("7-iron", "adjusted", "slip") == {"adjusted": every - {"launch"}, "slip": {"launch"}}
    # "the best accuracy for ball speed and sidespin": Table 5.
    iron = {"volumetric": every - {"ball_speed", "sidespin"}, "rings": {"ball_speed", "sidespin"}, "area": set()}
    assert least("7-iron", "volumetric", "rings", "area") == iron
    assert least("driver", "standard") == {"standard": set()}  # of the thesis
