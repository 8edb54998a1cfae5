"""Where the errors of a model on the benchmark shots come from: the model, motion capture, the monitor.

The truth of the benchmark is known, so that each source can be left alone: the model on true deliveries against true
launches; the same model on measured and on true deliveries; true deliveries extrapolated without any noise.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from clubface.benchmark_data import BenchmarkShots
from clubface.benchmark_data.measured import captured
from clubface.benchmark_data.recipe import recipe
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.measured.shots import QUANTITIES
from clubface.simulation.impact import impact
from clubface.support.arrays import Floats

SOURCES = {
    "all": "as measured",
    "model": "model alone: true delivery, true launch",
    "capture": "motion capture alone",
    "extrapolation": "of it, straight lines through noise-free frames",
    "monitor": "launch monitor alone",
}
"""What the error budget splits, and in words."""


def error_budget(shots: BenchmarkShots, parameters: ParameterSet) -> dict[str, dict[str, float]]:
    """Return the mean absolute error that each of ``SOURCES`` makes alone, by source and launch quantity, SI."""

    def launch(delivery: Mapping[str, Floats]) -> dict[str, Floats]:
        found = impact(
            shots.head, delivery, model=parameters.model, parameters=parameters, ball=published_ball(), on_error="nan"
        )
        return {name: np.asarray(getattr(found, name)) for name in QUANTITIES}

    truth, measured = shots.truth, shots.measured
    from_truth, from_measured = launch(truth.deliveries), launch(measured.deliveries)
    from_lines = launch(extrapolated(shots))
    differences = {
        "all": (from_measured, measured.launches),
        "model": (from_truth, truth.launches),
        "capture": (from_measured, from_truth),
        "extrapolation": (from_lines, from_truth),
        "monitor": (measured.launches, truth.launches),
    }
    return {
        source: {name: float(np.nanmean(np.abs(one[name] - other[name]))) for name in QUANTITIES}
        for source, (one, other) in differences.items()
    }


def extrapolated(shots: BenchmarkShots) -> dict[str, Floats]:
    """Return the true deliveries as straight lines through frames without noise give them."""
    quiet = recipe(shots.club)._replace(position_noise=0.0, attitude_noise=0.0, time_noise=0.0)
    return captured(quiet, shots.truth.deliveries, np.random.default_rng(quiet.seed))
