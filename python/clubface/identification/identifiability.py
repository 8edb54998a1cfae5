"""Which parameters the shots determine: Fisher's information from exact derivatives, and its weak directions.

The launches are taken as normally distributed about those of the model, with one standard deviation for each quantity.
A direction of the unit cube along which no launch changes by more than these deviations cannot be identified.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from clubface.identification.simulator import Simulator
from clubface.support.arrays import Floats

NORMAL_95 = 1.959963984540054
NULL = 1e-9
"""A singular value below this part of the largest is zero: derivatives are exact to about 1e-12."""
UNKNOWN = 0.5
"""Half-width of a 95% interval, in parts of the range, at which the data tell no more than the bounds do."""
WEAK = 0.05
"""Half-width from which a direction is called weak."""
SHOWN, SHOWN_WITHOUT_INFORMATION = 0.25, 0.02
"""Parameters with at least this part of the largest share are named in a direction."""


@dataclass(frozen=True, eq=False)
class Direction:
    """One direction of the unit cube of the parameters.

    Attributes
    ----------
    vector
        Unit vector, shape (free,).
    error
        Standard error along the direction, as a fraction of the range of the parameters; infinite if no launch changes
        along it.
    words
        Which parameters change along the direction, and how well it is known.
    """

    vector: Floats
    error: float
    words: str

    @property
    def strength(self) -> str:
        """How well the direction is known: ``"none"``, ``"unknown"``, ``"weak"`` or ``"known"``."""
        width = NORMAL_95 * self.error
        if not np.isfinite(width):
            return "none"
        return "unknown" if width > UNKNOWN else "weak" if width > WEAK else "known"


@dataclass(frozen=True, eq=False)
class Identifiability:
    """Fisher's information about the parameters at one point.

    Attributes
    ----------
    names
        The free parameters.
    noise
        Standard deviation that was assumed for each quantity [SI].
    directions
        Eigenvectors of the information, the weakest first.
    errors
        Standard errors of the coordinates of the unit cube, shape (free,); infinite for a parameter about which the
        shots say nothing.
    correlations
        Correlations of the parameters, shape (free, free); NaN where an error is infinite.
    """

    names: tuple[str, ...]
    noise: Floats
    directions: tuple[Direction, ...]
    errors: Floats
    correlations: Floats

    @property
    def weak(self) -> tuple[Direction, ...]:
        """The directions that are not well known, the weakest first."""
        return tuple(each for each in self.directions if each.strength != "known")

    @property
    def unknown(self) -> tuple[str, ...]:
        """The parameters about which the shots say no more than the bounds do."""
        return tuple(
            name for name, error in zip(self.names, self.errors, strict=True) if not NORMAL_95 * error <= UNKNOWN
        )


def identifiability(simulator: Simulator, point: Floats, noise: Floats) -> Identifiability:
    """Return Fisher's information of the shots near ``point``; ``noise`` [SI] has one value a quantity."""
    _, derivatives = simulator.derivatives(point)
    there = np.isfinite(simulator.shots.launches)
    rows = np.moveaxis(derivatives / noise[:, None, None], 1, 2)[there]
    free = rows.shape[1]
    padded = np.vstack([rows, np.zeros((max(0, free - len(rows)), free))])
    _, values, vectors = np.linalg.svd(padded, full_matrices=False)
    null = values <= NULL * max(values[0], 1e-300)
    inverse = np.where(null, 0.0, 1.0 / np.where(null, 1.0, values))
    errors = np.sqrt(np.sum((vectors * inverse[:, None]) ** 2, axis=0))
    # A parameter that takes part in a direction without information is itself not known.
    touched = np.any(np.abs(vectors[null]) > 1e-6, axis=0) if null.any() else np.zeros(free, dtype=bool)
    errors = np.where(touched, np.inf, errors)
    covariance = (vectors.T * inverse**2) @ vectors
    with np.errstate(invalid="ignore", divide="ignore"):
        correlations = covariance / np.outer(errors, errors)
    correlations[~np.isfinite(correlations) | np.isinf(np.outer(errors, errors))] = np.nan
    names = simulator.free.names
    directions = []
    for vector, value, is_null in zip(vectors[::-1], values[::-1], null[::-1], strict=True):
        error = np.inf if is_null else 1.0 / float(value)
        directions.append(_direction(names, vector, error))
    return Identifiability(names, noise, tuple(directions), errors, correlations)


def scatter(deviations: Floats, noise: Floats) -> Floats:
    """Return the standard deviation to assume for each quantity [SI]: the scatter of its deviations or its noise.

    The larger of the two is taken, because a model whose error exceeds the noise is known less well. ``deviations`` has
    the shape (quantities, shots), with NaN where nothing was measured. The scatter is 1.4826 times the median
    magnitude, which is the standard deviation of a normal distribution.
    """
    with np.errstate(invalid="ignore"):
        return np.maximum(noise, 1.4826 * np.nanmedian(np.abs(deviations), axis=1))


def _direction(names: tuple[str, ...], vector: Floats, error: float) -> Direction:
    """Name what moves along a direction, the strongest first and upwards."""
    order = np.argsort(-np.abs(vector), kind="stable")
    vector = vector * (np.sign(vector[order[0]]) or 1.0)
    least = SHOWN if np.isfinite(error) else SHOWN_WITHOUT_INFORMATION
    main = [place for place in order if abs(vector[place]) >= least * abs(vector[order[0]])]
    moved = [f"{names[place]} {'up' if vector[place] > 0 else 'down'}" for place in main]
    what = moved[0] if len(moved) == 1 else f"{', '.join(moved[:-1])} and {moved[-1]} together"
    if len(moved) > 1:
        shares = " : ".join(f"{abs(vector[place]) / abs(vector[main[0]]):.2g}" for place in main)
        what += f" ({shares} of their ranges)"
    width = NORMAL_95 * error
    if not np.isfinite(width):
        told = "no launch changes at all"
    elif width > UNKNOWN:
        told = "launches change by less than their scatter over the whole range"
    else:
        told = f"known to {100.0 * width:.2g}% of the range (95%)"
    return Direction(vector, error, f"{what}: {told}")
