"""The published cost (equation 22) and its alternatives, against values worked by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st

from clubface.errors import InputError, UnknownNameError
from clubface.inference.identification.simulator import HUBER, NOISE, cost_of, noise_of
from clubface.shots.measured import QUANTITIES

NAMES = tuple(QUANTITIES)
# Five shots by hand [SI]. Means of |measured|: 65, 0.2, 0.03, 300, 50; mean deviations: 1, 0.01, 0.003, 15, 5.
MEASURED = np.array(
    [
        [60.0, 70.0, 65.0, 62.0, 68.0],
        [0.20, 0.25, 0.15, 0.30, 0.10],
        [0.02, -0.03, 0.01, -0.04, 0.05],
        [300.0, 280.0, 320.0, 250.0, 350.0],
        [40.0, -60.0, 80.0, -20.0, 50.0],
    ]
)
DEVIATIONS = np.array(
    [
        [1.0, -2.0, 0.5, 0.0, -1.5],
        [0.01, -0.01, 0.02, 0.0, -0.01],
        [0.003, 0.0, -0.003, 0.006, -0.003],
        [15.0, -15.0, 30.0, -10.0, 5.0],
        [5.0, -5.0, 10.0, 0.0, -5.0],
    ]
)
SIMULATED = MEASURED + DEVIATIONS


def test_the_published_cost_of_five_shots_is_the_one_worked_by_hand():
    # 1/65 + 0.01/0.2 + 0.003/0.03 + 15/300 + 5/50; sums of 25 numbers of order 1 round to about 1e-15.
    assert cost_of("published", MEASURED, NAMES).value(SIMULATED) == pytest.approx(0.3 + 1.0 / 65.0, abs=1e-12)


def test_the_signed_normaliser_is_the_size_of_the_mean_as_printed():
    # The mean of sidespin is 18 = (40 - 60 + 80 - 20 + 50) / 5; azimuth, of mean 0.002, is left out.
    rows = [0, 1, 3, 4]
    names = tuple(NAMES[row] for row in rows)
    cost = cost_of("published", MEASURED[rows], names, normaliser="signed")
    expected = 1.0 / 65.0 + 0.05 + 0.05 + 5.0 / 18.0
    assert cost.value(SIMULATED[rows]) == pytest.approx(expected, abs=1e-12)
    mirrored = cost_of("published", -MEASURED[rows], names, normaliser="signed")
    assert mirrored.value(-SIMULATED[rows]) == pytest.approx(expected, abs=1e-12)


def test_a_normaliser_below_the_noise_is_refused():
    # The mean azimuth of the five shots is 0.002 rad = 0.115 deg, its noise 0.2 deg sqrt(pi / 2) = 0.251 deg.
    with pytest.raises(InputError, match=r"mean of measured values of azimuth is '0.115 deg'.*0.251 deg.*absolute"):
        cost_of("published", MEASURED, NAMES, normaliser="signed")
    cost_of("published", MEASURED, NAMES, normaliser="signed", noise={"azimuth": "0.1 deg"})
    with pytest.raises(InputError, match=r"\|measured\| of azimuth"):
        cost_of("published", MEASURED * 0.01, NAMES, noise={"launch": "1e-4 rad", "ball_speed": "1e-3 m/s"})


def test_least_squares_are_the_mean_square_of_deviation_over_noise():
    noise = {"ball_speed": 1.0, "launch": 0.01, "azimuth": 0.003, "backspin": 5.0, "sidespin": 5.0}
    # Squares of deviation over noise: 7.5, 7, 7, 9+9+36+4+1 = 59, 1+1+4+0+1 = 7; sum 87.5 over 25 values.
    cost = cost_of("least-squares", MEASURED, NAMES, noise=noise)
    assert cost.value(SIMULATED) == pytest.approx(87.5 / 25.0, abs=1e-12)
    # Huber: sizes above k = 1.345 count 2 k size - k^2: 2, 1.5; 2; 2; 3, 3, 6, 2; 2.
    k = HUBER
    small = (1.0 + 0.25) + 3.0 + 3.0 + 1.0 + 3.0
    large = sum(2.0 * k * size - k * k for size in (2.0, 1.5, 2.0, 2.0, 3.0, 3.0, 6.0, 2.0, 2.0))
    robust = cost_of("robust", MEASURED, NAMES, noise=noise)
    assert robust.value(SIMULATED) == pytest.approx((small + large) / 25.0, abs=1e-12)


def test_a_value_that_was_not_measured_does_not_count():
    measured = MEASURED.copy()
    measured[3, 2] = np.nan
    # Backspin then has the mean 295 and the mean deviation 45/4.
    expected = 0.25 + 1.0 / 65.0 + 45.0 / 4.0 / 295.0
    assert cost_of("published", measured, NAMES).value(SIMULATED) == pytest.approx(expected, abs=1e-12)
    simulated = SIMULATED.copy()
    simulated[3, 2] = 1e9
    assert cost_of("published", measured, NAMES).value(simulated) == pytest.approx(expected, abs=1e-12)


def test_a_launch_that_cannot_be_computed_costs_infinitely_much():
    simulated = SIMULATED.copy()
    simulated[0, 0] = np.nan
    for kind in ("published", "least-squares", "robust"):
        assert cost_of(kind, MEASURED, NAMES).value(simulated) == np.inf


@given(st.integers(1, 7), st.integers(0, 2**32 - 1))
def test_a_population_costs_what_its_members_cost_alone(count, seed):
    rng = np.random.default_rng(seed)
    population = MEASURED[:, None, :] * rng.uniform(0.8, 1.2, (5, count, 5))
    for kind in ("published", "least-squares", "robust"):
        cost = cost_of(kind, MEASURED, NAMES)
        alone = [cost.value(population[:, place, :]) for place in range(count)]
        assert cost.of(population).tolist() == alone


def test_shots_that_count_twice_cost_what_two_shots_do():
    which, counts = np.array([0, 2, 4]), np.array([2, 1, 3])
    listed = np.repeat(which, counts)
    cost = cost_of("published", MEASURED, NAMES)
    assert cost.select(which, counts).value(SIMULATED[:, which]) == pytest.approx(
        sum(cost.select(np.array([row]), np.array([1])).value(SIMULATED[:, [row]]) for row in listed), rel=1e-14
    )


def test_impossible_costs_are_refused_by_name():
    with pytest.raises(UnknownNameError, match="publshed"):
        cost_of("publshed", MEASURED, NAMES)
    with pytest.raises(UnknownNameError, match="median"):
        cost_of("published", MEASURED, NAMES, normaliser="median")
    with pytest.raises(InputError, match="noise of backspin"):
        noise_of(NAMES, {"backspin": "0 rpm"})
    with pytest.raises(UnknownNameError, match="carry"):
        noise_of(NAMES, {"carry": "1 m"})
    assert noise_of(("backspin",), {"backspin": "60 rpm"}) == pytest.approx([2.0 * np.pi])


def test_the_noise_is_that_of_the_monitor_that_was_quoted():
    """Caldwell and McPhee (2023), section 4, quote mean errors of 0.2 deg and 50 rpm; 0.5 mph is assumed for speed."""
    degree, rpm, of_mean = np.pi / 180, np.pi / 30, np.sqrt(np.pi / 2)  # deviation over mean magnitude of a normal
    expected = {
        "ball_speed": 0.5 * 0.44704, "launch": 0.2 * degree * of_mean, "azimuth": 0.2 * degree * of_mean,
        "backspin": 50 * rpm * of_mean, "sidespin": 50 * rpm * of_mean,
    }  # fmt: skip
    assert expected == pytest.approx({name: NOISE[name] for name in expected}, rel=1e-12)
