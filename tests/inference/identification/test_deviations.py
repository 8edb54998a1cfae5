"""What a fit misses, by hand: three shots, of which one was not measured."""

import numpy as np
import pytest

from clubface.inference.identification.run import _deviation

MEASURED = np.array([10.0, 12.0, np.nan, -6.0])
FITTED = np.array([11.0, 11.5, 99.0, -7.0])
BEFORE = np.array([14.0, 10.0, 99.0, -5.0])
HELD = np.array([12.0, 11.0, 99.0, -9.0])


def test_each_figure_is_that_of_its_definition():
    result = _deviation(MEASURED, FITTED, BEFORE, HELD)
    assert result.mean == pytest.approx(28.0 / 3.0)
    assert result.mae == pytest.approx((1.0 + 0.5 + 1.0) / 3.0)
    assert result.bias == pytest.approx((1.0 - 0.5 - 1.0) / 3.0)
    # Errors 1, -0.5 and -1 about their mean of -1/6, over n - 1.
    assert result.std == pytest.approx(np.sqrt(((7 / 6) ** 2 + (1 / 3) ** 2 + (5 / 6) ** 2) / 2.0))
    assert result.mae_before == pytest.approx((4.0 + 2.0 + 1.0) / 3.0)
    assert result.mae_holdout == pytest.approx((2.0 + 1.0 + 3.0) / 3.0)


def test_figures_that_need_more_shots_or_folds_are_nan():
    result = _deviation(MEASURED[:1], FITTED[:1], BEFORE[:1], None)
    assert (result.mae, result.bias) == (1.0, 1.0)
    assert np.isnan(result.std)
    assert np.isnan(result.mae_holdout)
