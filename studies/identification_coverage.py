"""How often the intervals that an identification reports hold the true parameters: 400 data sets with known ones.

Writes studies/identification_coverage.json, which docs/identification.md quotes.
"""

from __future__ import annotations

import json
from pathlib import Path
from unittest import mock

import numpy as np

import clubface
from clubface.inference.identification import run
from clubface.inference.identification.problem import free_parameters
from clubface.inference.identification.search import Population
from clubface.support.checks import without_warnings
from synthetic_shots import published, recorded

STORED = Path(__file__).with_suffix(".json")
REPEATS = 400
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
]
"""Model, club, cost, shots, bootstrap samples (0: intervals without a bootstrap), free parameters."""
LONGER = [
    ("volumetric", "7-iron", "published", 25, 0, ["damping", "friction", "layer_damping"]),
    ("volumetric", "7-iron", "least-squares", 25, 0, ["damping", "friction", "layer_damping"]),
    ("volumetric", "7-iron", "published", 25, 60, ["damping", "friction", "layer_damping"]),
]
"""More of them, for the tests alone: a volumetric shot takes a hundred times as long as one in closed form."""


def reported(model, cost, *, shots, samples, repeat, club="driver", free=None):
    """Return, for each free parameter, value and ends of the interval reported for one data set, less the truth.

    Only the search is left out: the refinement begins at the truth and finds the minimum nearby.
    """
    true = published(model, club)
    chosen = free_parameters(true, free)
    truth = chosen.points(np.array([true.values[name] for name in chosen.names]))

    def search(costs_of, free, *, generations, **options):
        return Population(generations, truth[None, :], costs_of(truth[None, :]))

    with mock.patch.object(run, "search", search):
        result = clubface.identify(
            recorded(shots, model, club=club, noise=1.0, seed=repeat), club=club, model=model, cost=cost, free=free,
            refined=1, folds=0, bootstrap=samples, profiles=(), seed=repeat, threads=1,
        )  # fmt: skip
    return {
        name: np.array([result.parameters.values[name], low, high]) - true.values[name]
        for name, (low, high) in result.intervals.items()
    }


def coverage(model, cost, *, repeats, **options):
    """Return, for each free parameter, the part of the repeats whose 95% interval holds the truth, and how wide it is.

    The width is the mean half-width of the intervals over 1.96 times the standard deviation of the values found: 1 for
    a normal estimate whose interval is neither too narrow nor wider than it need be.
    """
    each = [reported(model, cost, repeat=repeat, **options) for repeat in range(repeats)]
    held, wide = {}, {}
    for name in each[0]:
        value, low, high = np.array([one[name] for one in each]).T
        held[name] = float(np.mean((low <= 0.0) & (high >= 0.0)))
        wide[name] = float(np.mean(high - low) / (2.0 * 1.96 * np.std(value, ddof=1)))
    return held, wide


def main() -> None:
    """Run the studies of models in closed form and keep what they give."""
    rows = []
    for model, club, cost, shots, samples, free in STUDIES:
        with without_warnings():
            held, _ = coverage(model, cost, club=club, shots=shots, samples=samples, repeats=REPEATS, free=free)
        rows.append({"model": model, "club": club, "cost": cost, "shots": shots, "samples": samples, "held": held})
        print(rows[-1], flush=True)
    STORED.write_text(json.dumps({"repeats": REPEATS, "studies": rows}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
