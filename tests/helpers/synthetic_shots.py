"""Shots whose launches are computed by a model, with or without the noise of a monitor."""

from __future__ import annotations

import numpy as np

from clubface.equipment.clubs import club as club_named
from clubface.inference.identification.problem import free_parameters, prepared_shots
from clubface.inference.identification.simulator import Simulator, cost_of, noise_of
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RecordedShots
from clubface.simulation.impact import impact
from clubface.simulation.inputs import parameter_set

# Mean and spread of deliveries, SI: of the size measured of good players.
SPREADS = {
    "driver": {
        "speed": (49.0, 1.8), "attack": (0.03, 0.04), "path": (0.0, 0.05), "loft": (0.23, 0.03), "face": (0.02, 0.03),
        "lie": (0.0, 0.03), "toe": (0.0, 0.009), "high": (0.002, 0.007), "closure": (40.0, 8.0),
    },
    "7-iron": {
        "speed": (39.0, 1.8), "attack": (-0.07, 0.03), "path": (0.0, 0.05), "loft": (0.42, 0.04), "face": (0.02, 0.03),
        "lie": (0.0, 0.03), "toe": (0.0, 0.006), "high": (-0.005, 0.005), "closure": (30.0, 8.0),
    },
}  # fmt: skip


def deliveries(count, club="driver", seed=0):
    rng = np.random.default_rng(seed)
    # Cut at 2.5 spreads, so that every impact is on the face.
    return {
        name: mean + spread * np.clip(rng.standard_normal(count), -2.5, 2.5)
        for name, (mean, spread) in SPREADS[club].items()
    }


def recorded(
    count, model, *, club="driver", noise=0.0, seed=0, parameters=None, accuracy=None, delivery=None, head=None
):
    """Return shots; ``noise`` in units of that of a monitor, ``head`` a club in place of the one called ``club``."""
    delivery = deliveries(count, club, seed) if delivery is None else delivery
    launch = impact(head or club, delivery, model=model, parameters=parameters, accuracy=accuracy)
    rng = np.random.default_rng((seed, 1))
    names = tuple(QUANTITIES)
    scatter = dict(zip(names, noise * noise_of(names), strict=True))
    launches = {name: launch.get(name) + scatter[name] * rng.standard_normal(count) for name in names}
    return RecordedShots(
        deliveries=delivery, launches=launches, rows=np.arange(2, count + 2), source="synthetic.csv", format="clubface"
    )


def published(model, club="driver"):
    return parameter_set(model, club_named(club), None)


def fitted(shots, model, *, club="driver", free=None, cost="published", accuracy=None, **options):
    """Return simulator, cost and the point of the published parameters, for parts of an identification."""
    fixed = published(model, club)
    chosen = free_parameters(fixed, free, **options)
    prepared = prepared_shots(shots, club=club, parameters=fixed)
    simulator = Simulator(prepared, chosen, accuracy=accuracy)
    point = chosen.points(np.array([fixed.values[name] for name in chosen.names]))
    return simulator, cost_of(cost, prepared.launches, prepared.quantities), point


def widths_in_standard_errors(result):
    """Return the width of each interval over that of 95% by Cramer-Rao standard errors.

    Information says how small the error of any estimate can be at the least. That of a mean absolute error is 1.25
    times as large for normal deviations, more with weights that are not those of the noise.
    """
    spans = {name: upper - lower for name, (lower, upper) in result.settings["bounds"].items()}
    errors = dict(zip(result.identifiability.names, result.identifiability.errors, strict=True))
    return {
        name: (high - low) / (2.0 * 1.96 * errors[name] * spans[name]) for name, (low, high) in result.intervals.items()
    }
