"""How the errors of a model depend on the delivery: on speed, place on the face, path and attack."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from clubface.evaluation.statistics import Interval, Resamples, interval
from clubface.support.arrays import Floats

COVARIATES = {"speed": "mph", "path": "deg", "toe": "mm", "high": "mm", "attack": "deg", "loft": "deg", "face": "deg"}
"""The delivery quantities that errors are set against, and the unit each is read in."""
FEWEST_SHOTS = 3
LEAST_SPREAD = 1e-9
"""A covariate that spreads less than this, relative to its size, is constant."""


class Trend(NamedTuple):
    """A straight line through the errors of one model in one quantity over one value of the delivery, in SI units.

    Attributes
    ----------
    covariate
        The value of the delivery over which the line is drawn.
    slope
        Change of the error for a unit of the covariate, with its interval.
    explained
        Fraction of the variance of the error that the line explains, 0 to 1.
    """

    covariate: str
    slope: float
    interval: Interval
    explained: float

    @property
    def is_clear(self) -> bool:
        """Whether the interval excludes zero."""
        return self.interval.low > 0.0 or self.interval.high < 0.0


def trends(
    errors: Mapping[str, Floats], delivery: Mapping[str, Floats], resamples: Resamples
) -> dict[str, list[Trend]]:
    """Return the lines of each model over the covariates that were measured and vary.

    Parameters
    ----------
    errors
        Model less measured in one quantity, by the name of the model.
    delivery
        The deliveries of the same shots.
    resamples
        Of these shots.
    """
    covariates = {
        name: values
        for name in COVARIATES
        if (values := delivery.get(name)) is not None and np.ptp(values) > LEAST_SPREAD * np.abs(values).max()
    }
    found: dict[str, list[Trend]] = {name: [] for name in errors}
    centred = np.stack([each - each.mean() for each in errors.values()])
    if centred.shape[1] < FEWEST_SHOTS:
        return found
    mean_errors = resamples.means(centred)
    for name, values in covariates.items():
        deviation = float(values.std())
        x = (values - values.mean()) / deviation
        means = resamples.means(np.concatenate([[x, x * x], x * centred]))
        spread = means[:, 1] - means[:, 0] ** 2
        usable = spread > LEAST_SPREAD
        resampled = (means[:, 2:] - means[:, :1] * mean_errors)[usable] / spread[usable, None]
        for place, model in enumerate(errors):
            slope, variance = float(np.mean(x * centred[place])), float(np.mean(centred[place] ** 2))
            ends = interval(resampled[:, place] / deviation, resamples.groups)
            explained = slope**2 / variance if variance > 0.0 else 0.0
            found[model].append(Trend(name, slope / deviation, ends, explained))
    return found
