"""Huber's cost and the scatter of deviations, against values worked by hand and a search that knows no weights."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from clubface.inference.identification.intervals import scatter
from clubface.inference.identification.search import best_step, linear_cost
from clubface.inference.identification.simulator import HUBER, cost_of


def test_hubers_loss_is_square_to_the_knee_and_then_a_line_of_the_same_slope():
    """Huber (1964): rho(t) = t^2 / 2 for |t| <= k, else k |t| - k^2 / 2; the cost is twice its mean."""
    measured = np.zeros((1, 4))
    cost = cost_of("robust", measured, ("ball_speed",), noise={"ball_speed": 0.5})
    inside, outside = 0.5 * HUBER * 0.99, 0.5 * HUBER * 4.0  # of the knee, which lies at HUBER deviations
    result = cost.value(np.array([[inside, -inside, outside, -outside]]))
    t, k = np.array([inside, outside]) / 0.5, HUBER
    by_hand = 2.0 * np.array([0.5 * t[0] ** 2, k * t[1] - 0.5 * k**2])
    assert result == pytest.approx(by_hand.mean(), rel=1e-12)
    # 95% efficient for normal noise: the tuning constant of the literature, to its four digits.
    assert pytest.approx(1.345, abs=5e-4) == HUBER


def test_the_robust_step_is_the_minimum_of_the_linear_cost():
    """The weights of the step only stand for Huber's loss if a plain search over that loss ends in the same place."""
    rng = np.random.default_rng(4)
    shots = 200
    slopes = np.stack([rng.uniform(0.5, 1.5, shots), rng.uniform(-400.0, 400.0, shots)])
    noise = np.array([0.3, 30.0])
    measured = 0.2 * slopes + noise[:, None] * rng.normal(size=(2, shots))
    measured[:, ::7] += 12.0 * noise[:, None]  # a seventh of the shots is far off
    names = ("ball_speed", "backspin")
    cost = cost_of("robust", measured, names, noise=dict(zip(names, noise, strict=True)))
    simulated, derivatives = np.zeros((2, shots)), slopes[:, None, :]
    step = best_step(cost, simulated, derivatives, np.array([-1.0]), np.array([1.0]))

    def value(x):
        return linear_cost(cost, simulated, derivatives, np.array([x]))

    plain = minimize_scalar(value, bounds=(-1.0, 1.0), method="bounded", options={"xatol": 1e-10})
    # Reweighting ends where a round moves the step by less than a thousandth.
    assert step[0] == pytest.approx(plain.x, rel=1e-3)
    # And it is not the step of least squares, which the shots far off pull away.
    pulled = best_step(
        cost_of("least-squares", measured, names, noise=dict(zip(names, noise, strict=True))),
        simulated, derivatives, np.array([-1.0]), np.array([1.0]),
    )  # fmt: skip
    assert abs(pulled[0] - step[0]) > 0.2 * abs(step[0])


def test_the_scatter_of_normal_deviations_is_their_standard_deviation():
    """The median magnitude of a standard normal is the 0.75 quantile, 0.67449 (tabulated): 1 over it is 1.4826."""
    rng = np.random.default_rng(1)
    deviations = np.stack([rng.normal(0.0, 0.8, 40_001), rng.normal(0.0, 0.8, 40_001)])
    deviations[1, ::5] = math.nan
    # The median of 40,000 magnitudes is known to 0.6% of the deviation.
    assert scatter(deviations, np.array([0.1, 0.1])) == pytest.approx([0.8, 0.8], rel=0.02)
    exact = scatter(np.array([[0.67449, -0.67449, 0.67449]]), np.array([0.1]))
    assert exact == pytest.approx([1.0], abs=1e-4)
    # A scatter below the noise of the measurement is that noise.
    assert scatter(deviations, np.array([2.0, 0.1]))[0] == 2.0
