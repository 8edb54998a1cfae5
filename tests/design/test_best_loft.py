"""The best dynamic loft: an optimum of the carry, and the figures of published charts."""

import math

import numpy as np
import pytest

from clubface.design.best_loft import best_loft, compare_with_chart
from clubface.design.dispersion import ImpactSetup
from clubface.design.golfer import golfer
from clubface.design.variance import by_derivatives
from clubface.equipment.clubs import club
from clubface.errors import InputError

MPH, DEG = 0.44704, math.pi / 180.0


def test_within_a_degree_and_a_half_of_trackmans_chart():
    """80, 100 and 120 mph at -5, 0 and +5 degrees among the 30 rows."""
    import clubface

    compared = compare_with_chart("trackman")
    result, published = compared.best, compared.published
    away = (result.loft - published["dynamic_loft"]) / DEG
    assert len(away) == 30
    assert np.abs(away).max() < 1.5
    known = {(80, -5): 16.2, (80, 0): 18.3, (80, 5): 20.3, (100, -5): 12.2, (100, 0): 14.3, (100, 5): 16.7,
             (120, -5): 8.1, (120, 0): 11.0, (120, 5): 14.0}  # fmt: skip
    for (speed, attack), loft in known.items():
        row = np.flatnonzero(np.isclose(result.speed / MPH, speed) & np.isclose(result.attack / DEG, attack))
        assert result.loft[row] / DEG == pytest.approx(loft, abs=1.5)
    # What a fitter loses by the other's advice: a yard at most.
    delivery = {"speed": result.speed, "attack": result.attack, "loft": published["dynamic_loft"]}
    lost = result.carry - clubface.fly(clubface.impact("driver", delivery)).carry
    assert np.all((lost >= -1e-3) & (lost < 0.9144))
    # A free head gives up to 2% less ball speed than the chart has, which makes half of what the fastest drives are
    # short. At the chart's ball speeds they are as near as the flight is to the chart's own launches: -6 to +1 yards.
    assert result.ball_speed == pytest.approx(published["ball_speed"], rel=0.02)
    launch = {"ball_speed": published["ball_speed"], "launch": result.launch, "backspin": result.spin, "sidespin": 0.0}
    assert clubface.fly(launch).carry == pytest.approx(published["carry"], abs=6.0 * 0.9144)


def test_near_pings_chart_in_launch_and_spin():
    """Launches at ball speeds of 120 mph and more, as drives have, of strikes 3 mm above the face centre, which is the
    median of public drives; TrackMan's differ from them by as much. Not those of attack angles beyond 4 degrees: there
    the drag that rises where balls slow takes more from a high ball of little spin than PING has it, see the page."""
    compared = compare_with_chart("ping", high="3 mm")
    result, published = compared.best, compared.published
    drives = (published["ball_speed"] / MPH > 119.0) & (np.abs(published["attack"]) < 4.5 * DEG)
    assert drives.sum() == 35
    assert result.ball_speed[drives] == pytest.approx(published["ball_speed"][drives], rel=2e-3)
    assert (result.launch - published["launch"])[drives] / DEG == pytest.approx(0.0, abs=1.5)


def test_the_gradient_of_the_carry_vanishes_at_the_best_loft():
    """Carry is flat there: its slope changes by some 5 m a radian for 0.1 degrees; the search ends within 0.01."""
    result = best_loft("100 mph", "0 deg")
    player = golfer("tour-driver").replace(
        variables=("speed", "loft"), mean=np.array([100.0 * MPH, result.loft[0]]), covariance=np.diag([0.1, 1e-6])
    )
    derived = by_derivatives(player, ImpactSetup(club("driver"), "response"))
    assert derived.second["carry"][1, 1] < 0.0
    newton = -derived.gradient["carry"][1] / derived.second["carry"][1, 1]
    assert newton / DEG == pytest.approx(0.0, abs=0.02)


@pytest.mark.parametrize(("worth", "lost"), [(None, 2 * 0.9144), ({"carry": "1 yd"}, 0.9144)])
def test_at_the_ends_of_the_flat_range_what_is_worth_a_change_is_lost(worth, lost):
    import clubface

    result = best_loft(45.0, worth=worth)
    for side, away in zip((-1.0, 1.0), result.within[0], strict=True):
        shot = clubface.fly(clubface.impact("driver", speed=45.0, loft=float(result.loft[0] + side * away)))
        assert result.carry[0] - shot.carry == pytest.approx(lost, abs=0.01)


def test_loft_is_what_is_looked_for():
    with pytest.raises(InputError, match="loft is"):
        best_loft(45.0, loft=0.2)
    with pytest.raises(InputError):
        best_loft("nonsense")


@pytest.mark.parametrize(
    ("speed", "attack", "more", "message"),
    [
        ([], 0.0, {}, "at least one"),
        ([45.0, 46.0], [0.0, 0.0, 0.0], {}, "broadcast"),
        ([45.0, 1e9], 0.0, {}, "150 m/s"),
        (45.0, [0.0, 2.0], {}, "90 deg"),
        (45.0, [0.0, np.nan], {}, "attack"),
        (45.0, 0.0, {"air": {"temperature": 1e4}}, "temperature"),
        (45.0, 0.0, {"wind": (1e3, 0.0, 0.0)}, "wind"),
        (45.0, 0.0, {"accuracy": 5.0}, "accuracy"),
    ],
)
def test_a_case_that_no_loft_can_mend_is_an_error(speed, attack, more, message):
    with pytest.raises(InputError, match=message):
        best_loft(speed, attack, **more)


def test_no_loft_is_beyond_those_that_are_tried():
    assert best_loft("100 mph", "89 deg").loft[0] / DEG == pytest.approx(50.0)


@pytest.mark.parametrize("model", ["response", "volumetric", "standard"])
def test_no_other_loft_carries_farther(model):
    """Lofts 0.05 degrees apart; what lies between them is less than a mm of carry."""
    import clubface

    result = best_loft([27.0, 45.0, 54.0], [-0.12, 0.0, 0.1], club="3-wood", model=model)
    lofts = np.arange(0.0, 40.0, 0.05) * DEG
    for speed, attack, carry in zip(result.speed, result.attack, result.carry, strict=True):
        shots = clubface.impact("3-wood", speed=float(speed), attack=float(attack), loft=lofts, model=model)
        assert carry >= clubface.fly(shots, on_error="nan").carry.max() - 1e-3
