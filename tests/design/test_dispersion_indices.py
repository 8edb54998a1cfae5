"""Shares of the variance against functions whose shares are known."""

import numpy as np
import pytest
from scipy.special import ndtr

from clubface.design.dispersion import ImpactSetup
from clubface.design.golfer import golfer
from clubface.design.variance import ByDerivatives, by_derivatives, indices, indices_by_derivatives, shapley, sobol
from clubface.equipment.clubs import club
from clubface.errors import InputError

A, B = 7.0, 0.1
VARIANCE = A**2 / 8.0 + B * np.pi**4 / 5.0 + B**2 * np.pi**8 / 18.0 + 0.5
FIRST = np.array([0.5 * (1.0 + B * np.pi**4 / 5.0) ** 2, A**2 / 8.0, 0.0]) / VARIANCE
TOGETHER = B**2 * np.pi**8 * (1.0 / 18.0 - 1.0 / 50.0) / VARIANCE
"""Ishigami's function: shares of the variables alone, and of the first and third together."""


def ishigami(normal):
    x, y, z = np.pi * (2.0 * ndtr(normal) - 1.0)
    return (np.sin(x) + A * np.sin(y) ** 2 + B * z**4 * np.sin(x))[None]


def test_sobol_indices_of_ishigamis_function():
    """Saltelli's estimate from 2^13 points; its error there is some 0.01."""
    first, total = sobol(ishigami, np.zeros(3), np.ones(3), count=2**13, seed=1)
    assert first[0] == pytest.approx(FIRST, abs=0.02)
    assert total[0] == pytest.approx(FIRST + np.array([TOGETHER, 0.0, TOGETHER]), abs=0.02)


def test_shapley_effects_of_ishigamis_function():
    """What two variables do together is shared out in halves (Owen, 2014)."""
    effects = shapley(ishigami, np.zeros(3), np.eye(3), count=2**13, seed=1)[0]
    assert effects == pytest.approx(FIRST + 0.5 * np.array([TOGETHER, 0.0, TOGETHER]), abs=0.02)
    assert effects.sum() == pytest.approx(1.0, rel=1e-12)


def test_progress_is_reported_for_each_order():
    progress = []
    shapley(ishigami, np.zeros(3), np.eye(3), count=2, seed=1, progress=lambda *each: progress.append(each))
    assert progress == [(place, 6) for place in range(1, 7)]  # 3! orders of three variables


@pytest.mark.parametrize("rho", [0.0, 0.5, -0.8])
def test_shapley_effects_of_a_sum_of_two_correlated_variables(rho):
    """Owen and Prieur (2017): of b1 X1 + b2 X2, the first has (b1^2 (1 - rho^2 / 2) + b1 b2 rho + b2^2 rho^2 / 2)."""
    one, other = 2.0, 1.0
    covariance = np.array([[1.0, rho], [rho, 1.0]])
    variance = one**2 + other**2 + 2.0 * rho * one * other
    half = 0.5 * rho**2
    known = [
        (b**2 * (1.0 - half) + one * other * rho + c**2 * half) / variance for b, c in ((one, other), (other, one))
    ]
    sampled = shapley(lambda x: (one * x[0] + other * x[1])[None], np.zeros(2), covariance, count=2**12, seed=3)[0]
    assert sampled == pytest.approx(known, abs=0.01)
    player = golfer("tour-driver").replace(
        variables=("speed", "face"), mean=np.array([50.0, 0.0]), covariance=covariance
    )
    slopes = ByDerivatives(
        golfer=player, value={"f": 0.0}, gradient={"f": np.array([one, other])}, second={"f": np.zeros((2, 2))}
    )
    assert indices_by_derivatives(slopes, ("f",)).share["f"] == pytest.approx(known, rel=1e-12)


def test_what_spreads_drives_comes_out_alike_by_sampling_and_by_derivatives():
    """1024 shots a set: some 0.02 of the variance; curvature beyond the second order may add as much."""
    player, setup = golfer("tour-driver"), ImpactSetup(club("driver"), "response")
    sampled, derived = indices(player, setup), indices_by_derivatives(by_derivatives(player, setup))
    assert sampled.kind == derived.kind == "shapley"
    for name in ("carry", "side"):
        assert sampled.share[name] == pytest.approx(derived.share[name], abs=0.05)
        assert sampled.share[name].sum() == pytest.approx(1.0)
    face = sampled.variables.index("face")
    assert sampled.share["side"][face] > 0.7


def test_independent_variables_have_sobol_indices_and_those_that_do_not_vary_none():
    player = golfer("tour-driver")
    spread = player.spread.copy()
    spread[player.variables.index("lie")] = 0.0
    result = indices(player.replace(covariance=np.diag(spread**2)), ImpactSetup(club("driver"), "response"), count=256)
    assert result.kind == "sobol"
    assert "lie" not in result.variables
    assert result.share["side"][result.variables.index("face")] > 0.6


def test_one_variable_makes_all_of_the_spread():
    """Of a model that is straight in the speed; 1024 shots tell a share to 0.01."""
    player = golfer("tour-driver")
    alone = player.replace(covariance=np.diag(np.where(np.array(player.variables) == "speed", 1.0, 0.0)))
    result = indices(alone, ImpactSetup(club("driver"), "response"))
    assert result.variables == ("speed",)
    assert result.share["carry"] == pytest.approx([1.0], abs=0.02)
    assert result.total["carry"] == pytest.approx([1.0], abs=0.02)


@pytest.mark.parametrize(
    ("spread", "flight", "outcomes", "message"),
    [(0.0, True, ("carry",), "vary"), (1.0, False, ("carry",), "do not fly"), (1.0, True, ("cary",), "carry")],
)
def test_shares_of_nothing_are_refused(spread, flight, outcomes, message):
    player = golfer("tour-driver")
    player = player.replace(covariance=spread * player.covariance)
    with pytest.raises(InputError, match=message):
        indices(player, ImpactSetup(club("driver"), "response", flight=flight), outcomes)


def test_a_count_that_is_no_power_of_two_is_refused():
    with pytest.raises(InputError, match="power of two"):
        indices(golfer("tour-driver"), ImpactSetup(club("driver"), "response"), count=1000)
