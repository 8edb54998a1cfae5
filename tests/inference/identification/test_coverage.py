"""How often the intervals that an identification reports hold the true parameters, over data sets with its noise."""

from __future__ import annotations

import numpy as np
import pytest

import clubface
from clubface.inference.identification import run
from clubface.inference.identification.intervals import interval_of
from clubface.inference.identification.problem import free_parameters
from clubface.inference.identification.search import Population
from synthetic_shots import published, recorded


def reported(monkeypatch, model, cost, *, shots, samples, repeat, club="driver", free=None):
    """Return, for each free parameter, value and ends of the interval reported for one data set, less the truth.

    Only the search is left out: the refinement begins at the truth and finds the minimum nearby.
    """
    true = published(model, club)
    chosen = free_parameters(true, free)
    truth = chosen.points(np.array([true.values[name] for name in chosen.names]))

    def search(costs_of, free, *, generations, **options):
        return Population(generations, truth[None, :], costs_of(truth[None, :]))

    monkeypatch.setattr(run, "search", search)
    result = clubface.identify(
        recorded(shots, model, club=club, noise=1.0, seed=repeat), club=club, model=model, cost=cost, free=free,
        refined=1, folds=0, bootstrap=samples, profiles=(), seed=repeat, threads=1,
    )  # fmt: skip
    return {
        name: np.array([result.parameters.values[name], low, high]) - true.values[name]
        for name, (low, high) in result.intervals.items()
    }


def coverage(monkeypatch, model, cost, *, repeats, **options):
    """Return, for each free parameter, the part of the repeats whose 95% interval holds the truth, and how wide it is.

    The width is the mean half-width of the intervals over 1.96 times the standard deviation of the values found: 1 for
    a normal estimate whose interval is neither too narrow nor wider than it need be.
    """
    each = [reported(monkeypatch, model, cost, repeat=repeat, **options) for repeat in range(repeats)]
    held, wide = {}, {}
    for name in each[0]:
        value, low, high = np.array([one[name] for one in each]).T
        held[name] = float(np.mean((low <= 0.0) & (high >= 0.0)))
        wide[name] = float(np.mean(high - low) / (2.0 * 1.96 * np.std(value, ddof=1)))
    return held, wide


@pytest.mark.parametrize(
    ("model", "cost", "samples", "repeats", "least"),
    # 0.95 has a standard error of 0.034 over 40 repeats, 0.022 over 100: less three of them. 50 samples end roughly.
    [
        ("slip", "least-squares", 50, 40, 0.84), ("slip", "published", 50, 40, 0.84),
        ("adjusted", "published", 0, 100, 0.885),
    ],
)  # fmt: skip
def test_intervals_hold_the_truth_about_as_often_as_they_say(monkeypatch, model, cost, samples, repeats, least):
    held, wide = coverage(monkeypatch, model, cost, shots=40, samples=samples, repeats=repeats)
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


# Model, club, cost, shots, bootstrap samples (0: intervals without a bootstrap), free parameters. A volumetric shot
# takes a hundred times as long as one in closed form.
STUDIES = [
    ("standard", "driver", "published", 40, 100, ["cor"]),
    ("adjusted", "driver", "published", 40, 100, None),
    ("adjusted", "driver", "least-squares", 40, 100, None),
    ("adjusted", "driver", "robust", 40, 100, None),
    ("slip", "driver", "published", 40, 100, None),
    ("adjusted", "driver", "published", 60, 0, None),
    ("adjusted", "driver", "least-squares", 60, 0, None),
    ("adjusted", "driver", "robust", 60, 0, None),
    ("slip", "driver", "published", 60, 0, None),
    ("volumetric", "7-iron", "published", 25, 0, ["damping", "friction", "layer_damping"]),
    ("volumetric", "7-iron", "least-squares", 25, 0, ["damping", "friction", "layer_damping"]),
    ("volumetric", "7-iron", "published", 25, 60, ["damping", "friction", "layer_damping"]),
]


@pytest.mark.study
@pytest.mark.parametrize(("model", "club", "cost", "shots", "samples", "free"), STUDIES)
def test_intervals_hold_the_truth_at_the_nominal_rate(monkeypatch, model, club, cost, shots, samples, free):
    held, _ = coverage(monkeypatch, model, cost, club=club, shots=shots, samples=samples, repeats=400, free=free)
    shares = ", ".join(f"{name} {part:.4f}" for name, part in held.items())
    print(f"\n{model}, {club}, {cost} cost, {shots} shots, {samples} samples: {shares}")
    # 95%: a standard error of 1.1% over 400 repeats.
    assert all(0.915 <= part <= 0.98 for part in held.values()), held
