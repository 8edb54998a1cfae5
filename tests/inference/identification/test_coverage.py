"""How often the intervals that an identification reports hold the true parameters, over data sets with its noise."""

from __future__ import annotations

import numpy as np
import pytest
from identification_coverage import LONGER, REPEATS, STUDIES, coverage

from clubface.inference.identification.intervals import interval_of


@pytest.mark.parametrize(
    ("model", "cost", "samples", "repeats", "least"),
    # 0.95 has a standard error of 0.034 over 40 repeats, 0.022 over 100: less three of them. 50 samples end roughly.
    [
        pytest.param("slip", "least-squares", 50, 40, 0.84, marks=pytest.mark.study),
        pytest.param("slip", "published", 50, 40, 0.84, marks=pytest.mark.study),
        ("adjusted", "published", 0, 100, 0.885),
    ],
)  # fmt: skip
def test_intervals_hold_the_truth_about_as_often_as_they_say(model, cost, samples, repeats, least):
    held, wide = coverage(model, cost, shots=40, samples=samples, repeats=repeats)
    assert all(part >= least for part in held.values()), held
    # An interval of any width would hold the truth. 40 repeats know a standard deviation to 11%, four times that is
    # allowed; few shots and the larger of noise and scatter widen an interval by up to 20%.
    assert all(0.65 < width < 1.65 for width in wide.values()), wide


def test_an_interval_ends_at_median_unbiased_quantiles_widened_for_few_groups():
    # Of 99 sorted fits the k-th stands for (k - 1/3) / (99 + 1/3): the parts 2.5% and 97.5% are k = 2.817 and 97.183.
    fits = np.arange(1.0, 100.0)[:, None]
    # So many groups that Student's t is the normal distribution to four digits.
    assert interval_of(fits, 0.95, groups=100_000)[:, 0] == pytest.approx([2.817, 97.183], abs=0.01)
    # Ten groups and one parameter: t(9) at 97.5% is 2.262, times sqrt(10/9) 2.384, which the normal distribution
    # exceeds with 0.855% on either side: k = 0.00855 (999 + 1/3) + 1/3.
    fits = np.arange(1.0, 1000.0)[:, None]
    assert interval_of(fits, 0.95, groups=10)[:, 0] == pytest.approx([8.88, 991.12], abs=0.02)


@pytest.mark.study
@pytest.mark.parametrize(("model", "club", "cost", "shots", "samples", "free"), [*STUDIES, *LONGER])
def test_intervals_hold_the_truth_at_the_nominal_rate(model, club, cost, shots, samples, free):
    held, _ = coverage(model, cost, club=club, shots=shots, samples=samples, repeats=REPEATS, free=free)
    shares = ", ".join(f"{name} {part:.4f}" for name, part in held.items())
    print(f"\n{model}, {club}, {cost} cost, {shots} shots, {samples} samples: {shares}")
    # 95%: a standard error of 1.1% over 400 repeats.
    assert all(0.915 <= part <= 0.98 for part in held.values()), held
