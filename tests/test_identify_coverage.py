"""How often the intervals of identified parameters hold the true ones, over many data sets with a monitor's noise."""

from __future__ import annotations

import numpy as np
import pytest

from clubface.identify.cost import noise_of
from clubface.identify.identifiability import identifiability, scatter
from clubface.identify.refine import refine
from clubface.identify.resampling import Refits, bootstrap, interval_of
from synthetic_shots import fitted, recorded


def coverage(model, cost, *, shots, samples, repeats, free=None):
    """Return, for each free parameter, the part of the repeats whose 95% interval holds the truth.

    The search is left out: every fit begins at the truth, from which the refinement finds the minimum nearby.
    """
    held = []
    for repeat in range(repeats):
        simulator, judged, truth = fitted(recorded(shots, model, noise=1.0, seed=repeat), model, cost=cost, free=free)
        fit = refine(simulator, judged, truth).point
        off = scatter(simulator.launch(fit) - simulator.shots.launches, noise_of(simulator.shots.quantities))
        refits = Refits(simulator, judged, fit, identifiability(simulator, fit, off).errors)
        found = bootstrap(refits, samples, repeat, lambda name, compute: compute())
        low, high = interval_of(found, 0.95, shots)
        held.append((low <= truth) & (truth <= high))
    return dict(zip(simulator.free.names, np.mean(held, axis=0).tolist(), strict=True))


@pytest.mark.parametrize("cost", ["least-squares", "published"])
def test_intervals_hold_the_truth_about_as_often_as_they_say(cost):
    found = coverage("slip", cost, shots=40, samples=50, repeats=40)
    # 0.95 has a standard error of 0.034 over 40 repeats; three of them, and 50 samples make the ends rough.
    assert all(part >= 0.84 for part in found.values()), found


# Model, cost, shots, samples, free parameters. A volumetric shot takes a hundred times as long as one in closed form.
STUDIES = [
    ("standard", "published", 60, 200, ["cor"]),
    ("adjusted", "published", 60, 200, None),
    ("adjusted", "least-squares", 60, 200, None),
    ("adjusted", "robust", 60, 200, None),
    ("slip", "published", 60, 200, None),
    ("volumetric", "published", 50, 100, ["damping", "friction", "layer_damping"]),
]


@pytest.mark.study
@pytest.mark.parametrize(("model", "cost", "shots", "samples", "free"), STUDIES)
def test_intervals_hold_the_truth_at_the_nominal_rate(model, cost, shots, samples, free):
    found = coverage(model, cost, shots=shots, samples=samples, repeats=400, free=free)
    told = ", ".join(f"{name} {part:.4f}" for name, part in found.items())
    print(f"\n{model}, {cost} cost, {shots} shots: {told}")
    # 95%: a standard error of 1.1% over 400 repeats.
    assert all(0.915 <= part <= 0.98 for part in found.values()), found
