"""The noise floor: the error of a perfect model when launch and delivery are measured with noise."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.inference.evaluation.published_accuracy import monitor_errors
from clubface.shots.measured import QUANTITIES
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

TO_MEAN_ABSOLUTE = math.sqrt(2.0 / math.pi)
"""Mean absolute value of a standard normal deviate."""
MONITOR = {name: error / TO_MEAN_ABSOLUTE for name, error in monitor_errors().items()}
"""Standard deviations [SI] of a monitor with the mean errors that Caldwell and McPhee (2023) quote for theirs, 0.2 deg
and 50 rpm."""
DRAWS = 8
"""Number of perturbed copies per shot for estimating the effect of noise in the delivery."""

_LAUNCH_DIMENSIONS = {name: units.unit(unit).dimension for name, unit in QUANTITIES.items()}


def standard_deviations(given: Mapping[str, Any] | None, dimensions: Mapping[str, str], what: str) -> dict[str, float]:
    """Return standard deviations in SI from text with units or SI numbers; ``what`` names them in errors."""
    deviations = {}
    for name, value in (given or {}).items():
        check_choice(f"quantity of {what}", name, dimensions)
        deviations[name] = units.parse(value, dimensions[name], name=f"{what} {name}")
        if deviations[name] < 0.0:
            raise InputError(f"{what} {name}", value, "a standard deviation, not negative")
    return deviations


def monitor_noise(given: Mapping[str, Any] | None) -> dict[str, float]:
    """Return the standard deviations of the monitor: ``MONITOR``, updated with the ``given`` values."""
    return {**MONITOR, **standard_deviations(given, _LAUNCH_DIMENSIONS, "noise")}


def floor(
    predict: Callable[[Mapping[str, Floats]], Mapping[str, Floats]] | None,
    delivery: Mapping[str, Floats],
    monitor: Mapping[str, float],
    disturbance: Mapping[str, float],
    seed: int,
) -> dict[str, float]:
    """Return the mean absolute error of a perfect model [SI] in each quantity whose noise is known.

    ``predict`` computes launches from deliveries with the model that stands for the truth; it is not needed without
    ``disturbance``. ``monitor`` and ``disturbance`` are the standard deviations of measured quantities of launch and
    delivery, whose errors are independent and normally distributed.
    """
    if not disturbance or predict is None:
        return {name: TO_MEAN_ABSOLUTE * monitor[name] for name in QUANTITIES if name in monitor}
    random = np.random.default_rng(seed)
    undisturbed = predict(delivery)
    squares = dict.fromkeys(QUANTITIES, 0.0)
    for _ in range(DRAWS):
        moved = dict(delivery)
        for name, deviation in disturbance.items():
            centre = moved.get(name, 0.0)
            moved[name] = centre + deviation * random.standard_normal(len(delivery["speed"]))
        launch = predict(moved)
        for name in QUANTITIES:
            squares[name] += float(np.nanmean((launch[name] - undisturbed[name]) ** 2)) / DRAWS
    return {
        name: TO_MEAN_ABSOLUTE * math.hypot(math.sqrt(squares[name]), monitor.get(name, 0.0)) for name in QUANTITIES
    }
