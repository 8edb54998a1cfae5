"""The three ways to extend a path to impact, on paths and noise whose answer is known."""

import math

import numpy as np
import pytest

from clubface.capture.estimators import TIME, _wandering, check_roughness, estimator, linear, polynomial, smoother
from clubface.errors import InputError, UnknownNameError

TIMES = (np.arange(-30, 0) + 0.4) / 720.0
NOISE = np.diag([1e-4, 1e-4, 1e-4, 3e-3, 3e-3, 3e-3]) ** 2


def same_noise(count):
    return np.repeat(NOISE[None], count, axis=0)


def path_of(degree, seed=1):
    """Coefficients in powers of t/TIME over j!, a path of a clubhead's size, shape (degree + 1, 6)."""
    size = np.array([[0.1], [0.5], [0.15], [0.05], [0.02]])[: degree + 1]
    return size * (1.0 + np.random.default_rng(seed).uniform(-0.5, 0.5, (degree + 1, 6)))


def at(coefficients, times):
    tau = times / TIME
    return np.stack([tau**j / math.factorial(j) for j in range(len(coefficients))], 1) @ coefficients


@pytest.mark.parametrize(("estimate", "degree", "frames"), [(linear, 1, 4), (polynomial, 4, 20), (smoother, 4, 30)])
def test_a_path_of_its_own_family_is_continued_exactly(estimate, degree, frames):
    coefficients = path_of(degree)
    times = TIMES[-frames:]
    result = estimate(times, at(coefficients, times), same_noise(frames))
    # Rounding 1e-16, grown by the derivatives of a quartic over 30 frames of 1/720 s.
    assert result.position[0] == pytest.approx(coefficients[0], abs=1e-9)
    assert result.rate[0] == pytest.approx(coefficients[1], abs=1e-8)


def test_linear_extrapolation_is_that_worked_by_hand():
    """Positions t^2 at -4, -3, -2, -1 frames: 16, 9, 4, 1; central velocities -6 at -3 and -4 at -2."""
    times = np.array([-4.0, -3.0, -2.0, -1.0]) * TIME
    coordinates = np.repeat(np.array([16.0, 9.0, 4.0, 1.0])[:, None], 6, axis=1)
    result = linear(times, coordinates, same_noise(4))
    assert result.position[:, 0] == pytest.approx([1.0 - 3.0, -3.0])  # goes on from 1 with the slope 1 - 4
    assert result.rate[:, 0] == pytest.approx([0.0, 2.0])  # -6, -4, so 0 at time zero


def test_the_stated_covariance_of_the_linear_estimate_is_that_of_its_scatter():
    random = np.random.default_rng(5)
    times = TIMES[-4:]
    drawn = []
    for _ in range(4000):
        result = linear(times, random.normal(size=(4, 6)) @ np.sqrt(NOISE), same_noise(4))
        drawn.append(np.concatenate([result.position.ravel(), result.rate.ravel()]))
    stated = linear(times, np.zeros((4, 6)), same_noise(4)).covariance
    # 4000 draws give a standard deviation to 1.1%; four times that.
    assert np.std(drawn, axis=0) == pytest.approx(np.sqrt(np.diag(stated)), rel=0.045)
    correlation = np.corrcoef(np.array(drawn).T)[0, 12]
    assert correlation == pytest.approx(stated[0, 12] / math.sqrt(stated[0, 0] * stated[12, 12]), abs=0.06)


def test_wandering_is_the_covariance_of_an_integrated_random_walk():
    back = np.array([0.3, 0.8, 2.0])
    assert _wandering(back, 0) == pytest.approx(np.minimum.outer(back, back))  # Wiener
    s, r = np.minimum.outer(back, back), np.maximum.outer(back, back)
    assert _wandering(back, 1) == pytest.approx(s**2 * (3 * r - s) / 6)  # once integrated: s^2 (3 r - s)/6
    # At equal times the n-fold integral has the variance t^(2n+1)/((2n+1) n!^2).
    assert np.diag(_wandering(back, 4)) == pytest.approx(back**9 / (9 * math.factorial(4) ** 2))


def kalman(times, coordinates, noise, density, degree):
    """Filter one coordinate forwards by the textbook, start with no knowledge, predict time zero."""
    tau = times / TIME
    size = degree + 1
    state, spread = np.zeros(size), np.eye(size) * 1e2
    for place, now in enumerate(tau):
        if place:
            state, spread = predict(state, spread, now - tau[place - 1], density, size)
        gain = spread[:, 0] / (spread[0, 0] + noise)
        state = state + gain * (coordinates[place] - state[0])
        keep = np.eye(size)
        keep[:, 0] -= gain
        spread = keep @ spread @ keep.T + noise * np.outer(gain, gain)
    return predict(state, spread, -tau[-1], density, size)


def predict(state, spread, step, density, size):
    powers = [[step ** (j - i) / math.factorial(j - i) if j >= i else 0.0 for j in range(size)] for i in range(size)]
    forward = np.array(powers)
    added = np.zeros((size, size))
    for i in range(size):
        for j in range(size):
            a, b = size - 1 - i, size - 1 - j
            added[i, j] = step ** (a + b + 1) / ((a + b + 1) * math.factorial(a) * math.factorial(b))
    return forward @ state, forward @ spread @ forward.T + density * added


def test_the_smoother_is_the_kalman_filter_of_its_model():
    random = np.random.default_rng(2)
    coordinates = at(path_of(4), TIMES) + random.normal(size=(30, 6)) @ np.sqrt(NOISE)
    result = smoother(TIMES, coordinates, same_noise(30), roughness=0.5)
    step = (TIMES[-1] - TIMES[-4]) / TIME
    speed = np.linalg.norm(coordinates[-1, :3] - coordinates[-4, :3]) / step
    turning = np.linalg.norm(coordinates[-1, 3:] - coordinates[-4, 3:]) / step
    densities = [0.5 * (speed * turning**4) ** 2 / turning, 0.25 * 0.5 * turning**9]
    for column, density in ((0, densities[0]), (4, densities[1])):
        state, spread = kalman(TIMES, coordinates[:, column], NOISE[column, column], density, 4)
        rows = np.arange(5) * 6 + column
        stated = np.sqrt(np.diag(result.covariance[np.ix_(rows, rows)]))
        # The filter starts with a variance of 100 in place of none at all: against that of 1e-2 or less it ends with
        # that shifts it by 1e-4 of its standard deviation; more would drown the noise of 1e-8 in rounding.
        assert stated == pytest.approx(np.sqrt(np.diag(spread)), rel=1e-3)
        assert (result.position[:, column] - state) / stated == pytest.approx(np.zeros(5), abs=1e-3)


def test_the_smoother_holds_what_its_path_may_do_after_the_last_frame():
    exact = np.repeat(np.eye(6)[None] * 1e-18, 30, axis=0)
    coordinates = at(path_of(4), TIMES)
    near = smoother(TIMES, coordinates, exact)
    far = smoother(TIMES - 1 / 720, coordinates, exact)
    # The last frame is 0.6 or 1.6 frames before impact, and an integrated walk's variance grows with up to t^9.
    assert far.covariance[0, 0] > 30 * near.covariance[0, 0]
    rougher = smoother(TIMES, coordinates, exact, roughness=60.0)
    # Without noise the deviation goes with the root of the roughness, here of a hundredfold.
    assert math.sqrt(rougher.covariance[0, 0] / near.covariance[0, 0]) == pytest.approx(10.0, rel=0.05)


def test_the_misfit_is_one_where_the_model_is_true_and_grows_where_the_noise_is_understated():
    random = np.random.default_rng(8)
    coordinates = at(path_of(4), TIMES[-20:])
    result = [
        polynomial(TIMES[-20:], coordinates + random.normal(size=(20, 6)) @ np.sqrt(NOISE), same_noise(20)).misfit
        for _ in range(50)
    ]
    # 50 times 90 degrees of freedom: known to sqrt(2/4500) = 2.1%.
    assert np.mean(result) == pytest.approx(1.0, abs=0.07)
    doubled = polynomial(TIMES[-20:], coordinates + 2 * random.normal(size=(20, 6)) @ np.sqrt(NOISE), same_noise(20))
    assert 2.5 < doubled.misfit < 5.5


def test_unknown_estimators_and_roughness_are_refused():
    with pytest.raises(UnknownNameError, match=r"did you mean smoother"):
        estimator("smother")
    for wrong in (0.0, -1.0, math.inf, math.nan, "much", True):
        with pytest.raises(InputError, match="roughness"):
            check_roughness(wrong)
