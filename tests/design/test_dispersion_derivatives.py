"""Spreads by derivatives beside spreads by sampling: they part with the fourth power of the golfer's spreads."""

import numpy as np
import pytest

from clubface.design.dispersion import ImpactSetup
from clubface.design.golfer import golfer
from clubface.design.variance import ByDerivatives, by_derivatives, moments
from clubface.equipment.clubs import club
from clubface.errors import InputError

SETUP = ImpactSetup(club("driver"), "response")
COUNT = 2**14


def narrowed(factor):
    player = golfer("tour-driver")
    return player.replace(covariance=player.covariance * factor**2)


@pytest.mark.parametrize("name", ["ball_speed", "backspin", "carry", "side", "total", "total_side"])
def test_sampling_and_derivatives_agree_to_the_second_order(name):
    """Half the spread leaves a sixteenth of the difference of means, and of variances over the spread's square, a
    quarter. Below the sampling error of some 1e-4 of a spread nothing can be told."""
    means, variances = [], []
    for factor in (1.0, 0.5):
        player = narrowed(factor)
        derived, values = by_derivatives(player, SETUP), SETUP(player.sample(COUNT, seed=7))[name]
        values = values[np.isfinite(values)]
        spread = derived.spread(name)
        means.append(abs(values.mean() - derived.mean(name)) / spread)
        variances.append(abs(values.var() / derived.variance(name) - 1.0))
        # To the first order alone the mean is off by more than to the second.
        assert means[-1] < max(abs(values.mean() - derived.value[name]) / spread, 2e-3)
    # In units of the spread the error of the mean falls eightfold.
    assert means[1] < max(means[0] / 4.0, 1e-3)
    assert variances[1] < max(variances[0] / 2.0, 6e-3)
    assert means[0] < 0.1
    assert variances[0] < 0.13


def test_the_formulas_are_exact_for_a_quadratic():
    """Of f = x'Hx/2 + g'x + 3, by sums over 2^18 shots with mishits: some 3e-3 remains of the fourth moments."""
    player = golfer("tour-driver").replace(
        variables=("speed", "face"), mean=np.array([50.0, 0.1]), covariance=np.array([[1.0, 0.3], [0.3, 0.5]]),
        mishit_share=0.2, mishit_scale=2.0,
    )  # fmt: skip
    slope, second = np.array([1.0, -2.0]), np.array([[0.8, -0.3], [-0.3, 1.1]])
    derived = ByDerivatives(golfer=player, value={"f": 3.0}, gradient={"f": slope}, second={"f": second})
    away = np.array(list(player.sample(2**18, seed=2).values())) - player.mean[:, None]
    values = 3.0 + slope @ away + 0.5 * np.einsum("in,ij,jn->n", away, second, away)
    assert derived.mean("f") == pytest.approx(values.mean(), rel=1e-3)
    assert derived.variance("f") == pytest.approx(values.var(), rel=1e-2)
    assert derived.variance("f", order=1) < derived.variance("f")
    assert moments(player) == pytest.approx((1.6, 4.0))


def test_gradient_and_curvature_are_those_of_differences():
    player = narrowed(1.0)
    derived = by_derivatives(player, SETUP)
    place = player.variables.index("loft")
    step = np.zeros(len(player.mean))
    step[place] = 1e-3

    def carry(at):
        return SETUP({name: np.array([each]) for name, each in zip(player.variables, at, strict=True)})["carry"][0]

    above, middle, below = (carry(player.mean + side * step) for side in (1.0, 0.0, -1.0))
    assert derived.gradient["carry"][place] == pytest.approx((above - below) / 2e-3, rel=1e-3)
    # The differences of differences are right to the square of their steps.
    assert derived.second["carry"][place, place] == pytest.approx((above - 2.0 * middle + below) / 1e-6, rel=0.02)
    assert derived.second["carry"] == pytest.approx(derived.second["carry"].T)


def test_a_model_without_derivatives_is_refused():
    with pytest.raises(InputError, match="derivatives"):
        by_derivatives(narrowed(1.0), ImpactSetup(club("driver"), "fem"))
