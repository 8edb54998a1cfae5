"""Adaptive importance sampling against posteriors that are known in closed form."""

import math

import numpy as np
import pytest

from clubface.inference import importance
from clubface.inference.importance import (  # fmt: skip
    Proposal,
    attempt,
    effective,
    normalised,
    sample,
    standard_normal,
    systematic,
)


def drawn(likelihood, dimensions, **options):
    """A sample from a standard normal prior."""
    prior = standard_normal(dimensions)
    return sample(lambda x: prior.log_density(x) + likelihood(x), prior, **options)


def linear(dimensions=6, measured=3, noise=0.05, seed=0):
    """A linear measurement with normal noise: its posterior is normal, and its evidence known."""
    random = np.random.default_rng(seed)
    matrix = random.standard_normal((measured, dimensions))
    seen = matrix @ random.standard_normal(dimensions)
    covariance = np.linalg.inv(np.eye(dimensions) + matrix.T @ matrix / noise**2)
    mean = covariance @ matrix.T @ seen / noise**2
    total = matrix @ matrix.T + noise**2 * np.eye(measured)
    evidence = -0.5 * seen @ np.linalg.solve(total, seen) - 0.5 * np.linalg.slogdet(total / noise**2)[1]
    return lambda x: -0.5 * np.sum(((x @ matrix.T - seen) / noise) ** 2, axis=1), mean, covariance, evidence


@pytest.mark.parametrize("noise", [1.0, 0.05, 0.002])
def test_a_linear_measurement_gives_its_normal_posterior(noise):
    likelihood, mean, covariance, evidence = linear(noise=noise)
    result = drawn(likelihood, 6, size=4000, seed=1)
    assert result.effective >= 8000
    # Means of 4000 draws: five standard errors; covariances to 5 % of the largest of their row and column.
    deviation = np.sqrt(np.diag(covariance))
    assert np.abs(result.points.mean(axis=0) - mean).max() < (5 * deviation / math.sqrt(4000)).max()
    assert np.abs(np.cov(result.points.T) - covariance).max() < 0.08 * covariance.max()
    # The mean of at least 8000 effective weights: relative error 1/sqrt(8000), five of these.
    assert result.log_evidence == pytest.approx(evidence, abs=0.06)


def test_a_posterior_of_two_places_is_drawn_from_both():
    # The square of the first coordinate is measured as 4: half the posterior is near -2 and half near 2.
    result = drawn(lambda x: -0.5 * ((x[:, 0] ** 2 - 4.0) / 0.3) ** 2, 3, size=4000, seed=2)
    positive = np.mean(result.points[:, 0] > 0.0)
    # Of 4000 draws, five standard deviations of a fair coin.
    assert positive == pytest.approx(0.5, abs=0.04)
    assert np.abs(np.abs(result.points[:, 0]) - 2.0).max() < 0.5


def test_impossible_points_are_never_returned():
    def likelihood(x):
        return np.where(x[:, 0] > 1.0, -0.5 * x[:, 1] ** 2, np.nan)

    result = drawn(likelihood, 2, size=1000, seed=3)
    assert (result.points[:, 0] > 1.0).all()
    # A standard normal beyond 1 has the mean phi(1)/Q(1) = 1.5251; its deviation there is 0.45.
    assert result.points[:, 0].mean() == pytest.approx(1.5251, abs=5 * 0.45 / math.sqrt(1000))


def test_one_proposal_that_is_good_enough_is_one_stage_of_draws():
    prior = standard_normal(2)
    result = attempt(lambda x: prior.log_density(x) - 0.02 * x[:, 0] ** 2, prior, size=400, seed=1)
    assert result.stages == 1
    assert result.effective >= 800
    # A posterior narrower than the proposal gets no more than the draws of that one stage.
    poor = attempt(lambda x: -0.5 * np.sum((x - 1.0) ** 2, axis=1) / 0.04, prior, size=400, seed=1)
    assert poor.stages == 1
    assert poor.draws == 4 * 400
    assert poor.effective < 800


def test_nothing_possible_is_an_error():
    with pytest.raises(FloatingPointError):
        drawn(lambda x: np.full(len(x), np.nan), 2, size=100, seed=0)


def test_the_same_seed_gives_the_same_draws():
    likelihood = linear()[0]
    one, two, other = (drawn(likelihood, 6, size=200, seed=seed).points for seed in (5, 5, 6))
    assert np.array_equal(one, two)
    assert not np.array_equal(one, other)


def test_a_t_density_adds_up_to_one():
    root = np.array([[1.3, 0.0], [0.4, 0.6]])
    proposal = Proposal(np.array([0.2, -0.1]), root, 7.0)
    edges = np.linspace(-40.0, 40.0, 1601)
    x, y = np.meshgrid(edges, edges)
    density = np.exp(proposal.log_density(np.column_stack([x.ravel(), y.ravel()])))
    # A sum over a grid of 0.05; beyond 40 the tails hold 1e-9.
    assert density.sum() * (edges[1] - edges[0]) ** 2 == pytest.approx(1.0, rel=1e-6)
    # Covariance of a t: scale times nu / (nu - 2).
    drawn = proposal.draw(np.random.default_rng(0), 200_000)
    assert np.cov(drawn.T) == pytest.approx(root @ root.T * 7 / 5, rel=0.04)


def test_the_prior_is_standard_normal():
    # log phi(0) in three dimensions, and one at distance 1 is a half less.
    peak = -1.5 * math.log(2 * math.pi)
    values = standard_normal(3).log_density(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]))
    assert values == pytest.approx([peak, peak - 0.5], rel=1e-14)


def test_effective_size_and_resampling_follow_the_weights():
    weights = normalised(np.log([1.0, 1.0, 2.0]))
    assert weights == pytest.approx([0.25, 0.25, 0.5])
    # (sum of w)^2 over sum of w^2: 1 / (2/16 + 1/4) = 8/3.
    assert effective(weights) == pytest.approx(8 / 3)
    places = systematic(weights, 400, np.random.default_rng(0))
    assert np.bincount(places).tolist() == [100, 100, 200]


def test_the_draws_come_from_the_best_of_the_proposals_that_were_tried(monkeypatch):
    """Each that reaches the posterior is tried; the last one fitted never is, so that nothing speaks for it."""
    fitted, last = [], []
    fit, collect = importance._fit_proposal, importance._collect_draws

    def fitting(*given):
        fitted.append(fit(*given))
        return fitted[-1]

    def collecting(density, proposal, *given):
        last.append(proposal)
        return collect(density, proposal, *given)

    monkeypatch.setattr(importance, "_fit_proposal", fitting)
    monkeypatch.setattr(importance, "_collect_draws", collecting)
    likelihood, *_ = linear()
    drawn(likelihood, 6, size=400, seed=1)
    (chosen,) = last
    assert any(chosen is each for each in fitted[:-1])
    # By fresh draws it is as good as any other that was tried, to the tenth that 4000 draws leave open.
    prior, random = standard_normal(6), np.random.default_rng(0)

    def quality(proposal):
        points = proposal.draw(random, 4000)
        return effective(normalised(prior.log_density(points) + likelihood(points) - proposal.log_density(points)))

    assert quality(chosen) > 0.8 * max(quality(each) for each in fitted[:-1])
