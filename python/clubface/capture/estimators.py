"""Position and velocity of the clubhead at impact from the frames before it: three estimators with one interface.

The coordinates of a frame are the position of the CG and the rotation vector from the attitude of the last frame. No
frame after first touch is used, because impact takes a third of the speed of the head within half a millisecond.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from clubface.capture.rotations import Array
from clubface.errors import InputError
from clubface.support.checks import check_choice

__all__ = ["ESTIMATORS", "Estimator", "Path", "estimator", "linear", "polynomial", "smoother"]

TIME = 0.01
"""Seconds; the unit of time of the fits, so that their coefficients are of one size."""
JITTER = 1e-11
"""Part of its variance added to what a frame wanders by, so that rounding leaves the covariance positive definite even
where markers are exact; 3e-6 of the standard deviation."""
TURN = 2.0
"""Radians the head may turn within the frames that are used: far enough for the smoother, well below a half turn."""
STEADY = 0.25
"""How much less the rotation wanders than its natural size: a turn at a steady rate about a steady axis has no higher
derivatives at all, where the position on a circle has them all."""
ROUGHNESS = 0.6
"""Roughness of the smoother by default; the study shows what it depends on."""


class Path(NamedTuple):
    """The clubhead about one instant, to extrapolate from.

    Attributes
    ----------
    position
        Coefficients of (position [m], rotation vector [rad]) in powers of time, the j-th multiplied by (t / TIME)^j /
        j!, shape (m, 6).
    rate
        The same coefficients for the rates [1/TIME], shape (n, 6).
    covariance
        Covariance of both, one after the other, shape (6 (m + n), 6 (m + n)).
    misfit
        Sum of squared residuals divided by the expected one, for each degree of freedom; NaN if none is left.
    """

    position: Array
    rate: Array
    covariance: Array
    misfit: float


class Estimator(NamedTuple):
    """One way to extend a path.

    Attributes
    ----------
    extend
        A function with the interface of :func:`linear`.
    fewest, most
        The least number of frames it needs, and the largest number it uses.
    """

    extend: Callable[..., Path]
    fewest: int
    most: int


def linear(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Extrapolate position and velocity along straight lines, after Caldwell and McPhee (2023), section 2.3.

    They do not say over which frames. Here the position goes on from the last frame with the slope from the frame
    before it. Velocities are central differences, which the last frame does not have, and are extrapolated from the
    last two that exist.

    Parameters
    ----------
    times
        Times of the last four frames before impact [s], counted from the instant for which the path is wanted.
    coordinates
        Position [m] and rotation vector [rad], shape (frames, 6).
    covariances
        Covariances of the coordinates, shape (frames, 6, 6).
    roughness
        Not used.
    """
    t, z, c = times, coordinates, covariances
    middle = (t[2:] - t[:2], 0.5 * (t[2:] + t[:2]))
    weights = np.zeros((4, len(t)))
    weights[1, 2:] = np.array([-1.0, 1.0]) / (t[3] - t[2]) * TIME
    weights[0] = weights[1] * (-t[3] / TIME)
    weights[0, 3] += 1.0
    slopes = np.zeros((2, 4))
    for row in (0, 1):
        slopes[row, [row, row + 2]] = np.array([-1.0, 1.0]) / middle[0][row] * TIME
    weights[3] = (slopes[1] - slopes[0]) / (middle[1][1] - middle[1][0]) * TIME
    weights[2] = slopes[1] - weights[3] * (middle[1][1] / TIME)
    result = weights @ z
    spread = np.kron(weights, np.eye(6))
    blocks = np.zeros((24, 24))
    for place in range(4):
        blocks[6 * place : 6 * place + 6, 6 * place : 6 * place + 6] = c[place]
    return Path(result[:2], result[2:], spread @ blocks @ spread.T, math.nan)


def polynomial(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Fit a quartic to the last twenty frames by weighted least squares; the parameters are those of :func:`linear`."""
    return fit(times, coordinates, covariances, 4, 0.0)


def smoother(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Smooth the approach as a path whose fourth derivative wanders at random, and extrapolate from its end.

    The fourth derivatives of position and rotation are random walks driven by white noise. The best estimate of such a
    path is that of a Kalman filter at its last frame, and equals a smoothing spline of degree nine (Wahba 1978). It is
    computed in one step, by generalised least squares of a quartic about the instant for which the path is wanted. The
    errors are those of the markers and, growing backwards in time, those of the random walk. The frames near impact
    therefore count most, and the noise decides how far back the others count. The uncertainty contains what the path
    may do between the last frame and impact.

    The spectral density of the driving noise has the natural size of a club that turns at the rate w and moves at the
    speed v: roughness times (v w^4)^2/w in the position, and a quarter of (w^5)^2/w in the rotation.

    Parameters
    ----------
    times, coordinates, covariances
        As for :func:`linear`.
    roughness
        How much the path may depart from a quartic; 0 makes it one.
    """
    return fit(times, coordinates, covariances, 4, wandering(times, coordinates, roughness))


def wandering(times: Array, coordinates: Array, roughness: float) -> Array:
    """Return the spectral density by which the :func:`smoother` lets position and rotation wander, shape (6,)."""
    turning = float(np.linalg.norm(coordinates[-1, 3:] - coordinates[-4, 3:]) / (times[-1] - times[-4])) * TIME
    speed = float(np.linalg.norm(coordinates[-1, :3] - coordinates[-4, :3]) / (times[-1] - times[-4])) * TIME
    return np.repeat([(speed * turning**4) ** 2, STEADY * turning**10], 3) / turning * roughness


ESTIMATORS = {
    "smoother": Estimator(smoother, 8, 120),
    "polynomial": Estimator(polynomial, 8, 20),
    "linear": Estimator(linear, 4, 4),
}
"""By name, the default first."""


def estimator(name: str) -> Estimator:
    """Return an estimator; a :class:`UnknownNameError` lists their names."""
    check_choice("estimator", name, ESTIMATORS)
    return ESTIMATORS[name]


def check_roughness(value: object) -> float:
    """Return the roughness; one that is not positive and finite is an :class:`InputError`."""
    if isinstance(value, (int, float)) and not isinstance(value, bool) and 0.0 < value < math.inf:
        return float(value)
    raise InputError("roughness", value, f"a number above 0 (default {ROUGHNESS:g})")


def fit(
    times: Array, z: Array, covariances: Array, degree: int, density: Array | float, common: Array | None = None
) -> Path:
    """Fit a polynomial about time zero whose errors are those of the frames and of a wandering derivative.

    Parameters
    ----------
    times
        Of the frames [s], ascending, counted from the instant for which the path is wanted.
    z
        Coordinates of the frames, shape (frames, n).
    covariances
        Of them, shape (frames, n, n).
    degree
        Of the polynomial, whose derivative of this degree wanders.
    density
        Spectral density of the wandering, for times in ``TIME``; a number or shape (n,).
    common
        Errors that all frames share: how coordinates change by one standard deviation of each, shape (frames, n, m).
    """
    tau, (count, width) = times / TIME, z.shape
    powers = np.stack([tau**j / math.factorial(j) for j in range(degree + 1)], 1)
    wandering = _wandering(-tau, degree)
    wandering[np.diag_indices(count)] *= 1.0 + JITTER
    errors = np.kron(wandering, np.diag(np.broadcast_to(density, width)))
    for place, each in enumerate(covariances):
        errors[width * place : width * (place + 1), width * place : width * (place + 1)] += each
    if common is not None:
        shared = common.reshape(count * width, -1)
        errors += shared @ shared.T
    root = np.linalg.cholesky(errors)
    design = np.linalg.solve(root, np.kron(powers, np.eye(width)))
    seen = np.linalg.solve(root, z.ravel())
    orthogonal, triangle = np.linalg.qr(design)
    result = np.linalg.solve(triangle, orthogonal.T @ seen)
    inverse = np.linalg.inv(triangle)
    left = seen - design @ result
    freedom = width * (count - degree - 1)
    # The rates are the same coefficients, from the second on.
    pick = np.concatenate([np.arange(width * (degree + 1)), np.arange(width, width * (degree + 1))])
    coefficients = result.reshape(degree + 1, width)
    covariance = (inverse @ inverse.T)[np.ix_(pick, pick)]
    return Path(coefficients, coefficients[1:], covariance, float(left @ left) / freedom if freedom > 0 else math.nan)


def _wandering(back: Array, degree: int) -> Array:
    """Return the covariance of a ``degree``-fold integrated random walk of unit density at times back from zero.

    The integral of ((s - u)(r - u))^degree / degree!^2 over u from 0 to the lesser of s and r, exact by Gauss's rule.
    """
    nodes, weights = np.polynomial.legendre.leggauss(degree + 1)
    s, r = back[:, None], back[None, :]
    least = np.maximum(np.minimum(s, r), 0.0)
    u = 0.5 * (nodes + 1.0) * least[..., None]
    inside = ((s[..., None] - u) * (r[..., None] - u)) ** degree
    return 0.5 * least * (inside @ weights) / math.factorial(degree) ** 2
