"""Draws from the posterior of one shot: coordinates that bend with it, and importance sampling in them."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from clubface.inference.importance import Sample, attempt, sample, standard_normal, standard_t
from clubface.inference.ridge import Peak, Residuals, Sheet, Slopes, peak
from clubface.support.arrays import Floats

MOST_CENTRES = 4
"""Places from which a posterior is sampled without adaptation, before its proposals are adapted."""


def drawn(
    residuals: Residuals,
    slopes: Slopes,
    dimensions: int,
    *,
    size: int,
    seed: int,
    progress: Callable[[float], object] | None,
) -> tuple[Sample, float]:
    """Sample a posterior whose prior is standard normal, and return with it the misfit of its peak.

    The peak may stand in a corner, off the bulk of the posterior. Then the coordinates begin in the bulk. Without a
    peak, the draws begin with the prior, and the misfit is NaN.

    Parameters
    ----------
    residuals, slopes
        Of the measurement.
    dimensions
        Of the prior.
    size, seed, progress
        As for :func:`clubface.inference.importance.sample`.
    """
    before, after = standard_normal(dimensions), standard_t(dimensions)

    def density(points: Floats) -> Floats:
        return before.log_density(points) - 0.5 * np.sum(residuals(points) ** 2, axis=1)

    def bent(sheet: Sheet) -> Callable[[Floats], Floats]:
        def of(coordinates: Floats) -> Floats:
            points, log_volume = sheet.points(coordinates)
            return density(points) + log_volume

        return of

    top = peak(residuals, slopes, np.zeros(dimensions))
    if top is None:
        return sample(density, before, size=size, seed=seed, progress=progress), math.nan
    centre: Peak | None = top
    tried: list[tuple[Sample, Sheet]] = []
    while centre is not None and len(tried) < MOST_CENTRES:
        sheet = Sheet(centre, residuals)
        found = attempt(bent(sheet), after, size=size, seed=seed)
        found = found._replace(points=sheet.points(found.points)[0])
        if found.effective >= 2 * size:
            return found, top.misfit
        tried.append((found, sheet))
        centre = _bulk(found, slopes)
    sheet = max(tried, key=lambda each: each[0].effective)[1]
    found = sample(bent(sheet), after, size=size, seed=seed, progress=progress)
    return found._replace(points=sheet.points(found.points)[0]), top.misfit


def _bulk(of: Sample, slopes: Slopes) -> Peak | None:
    """Return the mean of a sample as the place from which coordinates begin; None if nothing can be computed there."""
    middle = of.points.mean(axis=0)
    off, table = slopes(middle)
    possible = np.isfinite(off).all() and np.isfinite(table).all()
    return Peak(middle, table, math.nan) if possible else None
