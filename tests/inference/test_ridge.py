"""Coordinates that bend with a posterior: their peak, their volume and how normal the posterior is in them."""

import numpy as np
import pytest

from clubface.inference.importance import Sheet, attempt, peak, standard_normal, standard_t

NOISE = 0.05


def residuals(x):
    """Two measurements of four quantities, which bend: a parabola and a product."""
    seen = np.stack([x[:, 0] + 0.4 * x[:, 1] ** 2, x[:, 2] * (1.0 + 0.3 * x[:, 1]) + 0.2 * x[:, 3]], axis=1)
    return (seen - np.array([0.5, -0.3])) / NOISE


def slopes(x):
    _, b, c, _ = x
    table = [[1.0, 0.8 * b, 0.0, 0.0], [0.0, 0.3 * c, 1.0 + 0.3 * b, 0.2]]
    return residuals(x[None, :])[0], np.array(table) / NOISE


def test_the_volume_is_the_determinant_of_the_map():
    top = peak(residuals, slopes, np.zeros(4))
    assert top is not None
    sheet, h = Sheet(top, residuals), 1e-5
    for place in np.random.default_rng(0).standard_normal((5, 4)):
        steps = np.vstack([place + h * np.eye(4), place - h * np.eye(4)])
        ahead, behind = np.split(sheet.points(steps)[0], 2)
        determinant = np.linalg.det((ahead - behind).T / (2.0 * h))
        # Central differences of a step of 1e-5: 1e-8 or so.
        assert np.exp(sheet.points(place[None, :])[1][0]) == pytest.approx(abs(determinant), rel=1e-5)


def test_most_draws_are_effective_where_a_normal_distribution_would_not_do():
    top = peak(residuals, slopes, np.zeros(4))
    assert top is not None
    sheet, prior = Sheet(top, residuals), standard_normal(4)

    def density(x):
        return prior.log_density(x) - 0.5 * np.sum(residuals(x) ** 2, axis=1)

    def bent(coordinates):
        points, log_volume = sheet.points(coordinates)
        return density(points) + log_volume

    result = attempt(bent, standard_t(4), size=1000, seed=0)
    assert result.effective > 0.5 * result.draws
    # The integral on a fine grid of what is not measured; the measured two are narrow enough to be integrated by hand:
    # the density of (0.5 - 0.4 b^2) and of ((-0.3 - 0.2 d) / (1 + 0.3 b)), each times the noise's own integral.
    b, d = np.meshgrid(*[np.linspace(-6.0, 6.0, 1201)] * 2)
    first, second = 0.5 - 0.4 * b**2, (-0.3 - 0.2 * d) / (1.0 + 0.3 * b)
    phi = np.exp(-0.5 * (b**2 + d**2 + first**2 + second**2)) / (2.0 * np.pi) ** 2
    mass = np.sum(phi / np.abs(1.0 + 0.3 * b)) * 0.01**2 * 2.0 * np.pi * NOISE**2
    # The noise's width, 0.05, changes the prior across it by some 0.1 %; the mean of 2000 effective weights is known to
    # 2 %: four of these.
    assert result.log_evidence == pytest.approx(np.log(mass), abs=0.09)
