"""How large what no fitted model has is in the launches of the benchmark shots: each effect left out alone."""

from __future__ import annotations

import numpy as np

from clubface.benchmark_data import BenchmarkShots
from clubface.benchmark_data.impacts import LAUNCH, launches, restitution_offsets
from clubface.benchmark_data.recipe import Recipe, recipe
from clubface.support.arrays import Floats

EFFECTS = ("ball", "face", "shaft", "all")
"""Restitution scatters from ball to ball; it falls off the centre of the face; the tip of the shaft; all three."""


def effect_sizes(shots: BenchmarkShots) -> dict[str, dict[str, float]]:
    """Return the mean absolute change of the launch by effect of ``EFFECTS`` and quantity, SI.

    Each is left out of the model that made the shot, with the true delivery and all else as it was.
    """
    of = recipe(shots.club)
    delivery = shots.truth.deliveries
    off_centre = restitution_offsets(of, delivery, 0.0)
    without = {
        "ball": (of, off_centre),
        "face": (of, shots.restitution_offset - off_centre),
        "shaft": (of._replace(shaft_mass=0.0), shots.restitution_offset),
        "all": (of._replace(shaft_mass=0.0), np.zeros(len(shots))),
    }
    found = {}
    for effect, (part, offsets) in without.items():
        launch = _launches(part, shots, offsets)
        found[effect] = {name: float(np.abs(launch[name] - shots.truth.launches[name]).mean()) for name in LAUNCH}
    return found


def _launches(of: Recipe, shots: BenchmarkShots, offsets: Floats) -> dict[str, Floats]:
    """Return the launch of every shot by the model that made it."""
    launch = {name: np.empty(len(shots)) for name in LAUNCH}
    for model in of.mixture:
        own = shots.model == model
        delivery = {name: values[own] for name, values in shots.truth.deliveries.items()}
        for name, values in launches(of, model, delivery, offsets[own]).items():
            launch[name][own] = values
    return launch
