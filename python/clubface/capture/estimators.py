"""Estimators of the clubhead's position and velocity at impact from the frames before it, with one interface.

A frame's coordinates are the CG position and the rotation vector relative to the attitude in the last frame. Frames
after first touch are not used, since within half a millisecond impact takes away a third of the head's speed.
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
"""Unit of time of the fits [s], which gives coefficients of similar size."""
JITTER = 1e-11
"""Fraction added to each frame's variance from the random walk, to keep the covariance positive definite in rounding
even with exact markers; 3e-6 of the standard deviation."""
TURN = 2.0
"""Maximum rotation of the head within the frames used [rad]: enough for the smoother, well below a half turn."""
STEADY = 0.25
"""Reduction of the rotation's random walk from its natural size: a turn at constant rate about a constant axis has no
higher derivatives, whereas position on a circle has all of them."""
ROUGHNESS = 0.6
"""Default roughness of the smoother; the study shows its effect."""


class Path(NamedTuple):
    """The clubhead's path about one instant, for extrapolation.

    Attributes
    ----------
    position
        Coefficients of (position [m], rotation vector [rad]) in powers of time; the j-th is multiplied by
        (t / TIME)^j / j!, shape (m, 6).
    rate
        Coefficients of their rates [1/TIME], shape (n, 6).
    covariance
        Covariance of both stacked, shape (6 (m + n), 6 (m + n)).
    misfit
        Sum of squared residuals over its expectation, per degree of freedom; NaN without degrees of freedom.
    """

    position: Array
    rate: Array
    covariance: Array
    misfit: float


class Estimator(NamedTuple):
    """A method of extrapolating a path.

    Attributes
    ----------
    extend
        A function with the interface of :func:`linear`.
    fewest, most
        Minimum number of frames needed, and maximum number used.
    """

    extend: Callable[..., Path]
    fewest: int
    most: int


def linear(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Extrapolate position and velocity along straight lines, after Caldwell and McPhee (2023), section 2.3.

    They do not specify the frames. Here position continues from the last frame with the slope from the frame before.
    Velocities are central differences, which do not exist for the last frame, and are extrapolated from the last two
    that do.

    Parameters
    ----------
    times
        Times of the last four frames before impact [s], relative to the instant of interest.
    coordinates
        Position [m] and rotation vector [rad], shape (frames, 6).
    covariances
        Covariances of the coordinates, shape (frames, 6, 6).
    roughness
        Not used.
    """
    t = times
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
    result = weights @ coordinates
    covariance = np.einsum("ik,jk,kab->iajb", weights, weights, covariances).reshape(24, 24)
    return Path(result[:2], result[2:], covariance, math.nan)


def polynomial(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Fit a quartic to the last twenty frames by weighted least squares; parameters as for :func:`linear`."""
    return fit(times, coordinates, covariances, 4, 0.0)


def smoother(times: Array, coordinates: Array, covariances: Array, *, roughness: float = ROUGHNESS) -> Path:
    """Smooth the approach as a path whose fourth derivative is a random walk, and extrapolate from its end.

    The fourth derivatives of position and rotation are random walks driven by white noise. The best estimate of such a
    path at its last frame is that of a Kalman filter, and equals a smoothing spline of degree nine (Wahba 1978). It is
    computed in one step, as a generalised least-squares fit of a quartic about the instant of interest, whose errors
    are those of the markers plus those of the random walk, which grow backwards in time. Frames near impact therefore
    have the largest weight, and the noise determines how far back others matter. The uncertainty includes possible
    deviations of the path between the last frame and impact.

    The spectral density of the driving noise scales naturally for a club with rotation rate w and speed v: roughness
    times (v w^4)^2/w for position, and a quarter of (w^5)^2/w for rotation.

    Parameters
    ----------
    times, coordinates, covariances
        As for :func:`linear`.
    roughness
        How far the path may depart from a quartic; 0 gives a quartic.
    """
    return fit(times, coordinates, covariances, 4, wandering(times, coordinates, roughness))


def wandering(times: Array, coordinates: Array, roughness: float) -> Array:
    """Return the spectral density of the :func:`smoother`'s random walks in position and rotation, shape (6,)."""
    turning = float(np.linalg.norm(coordinates[-1, 3:] - coordinates[-4, 3:]) / (times[-1] - times[-4])) * TIME
    speed = float(np.linalg.norm(coordinates[-1, :3] - coordinates[-4, :3]) / (times[-1] - times[-4])) * TIME
    return np.repeat([(speed * turning**4) ** 2, STEADY * turning**10], 3) / turning * roughness


ESTIMATORS = {
    "smoother": Estimator(smoother, 8, 120),
    "polynomial": Estimator(polynomial, 8, 20),
    "linear": Estimator(linear, 4, 4),
}
"""Estimators by name, the default first."""


def estimator(name: str) -> Estimator:
    """Return an estimator by name; raise UnknownNameError, with all names, if there is none."""
    check_choice("estimator", name, ESTIMATORS)
    return ESTIMATORS[name]


def check_roughness(value: object) -> float:
    """Return the roughness; raise InputError unless it is positive and finite."""
    if isinstance(value, (int, float)) and not isinstance(value, bool) and 0.0 < value < math.inf:
        return float(value)
    raise InputError("roughness", value, f"a number above 0 (default {ROUGHNESS:g})")


def fit(
    times: Array, z: Array, covariances: Array, degree: int, density: Array | float, common: Array | None = None
) -> Path:
    """Fit a polynomial about time zero with errors from the frames and from a random walk of its highest derivative.

    ``times`` [s] ascend, relative to the instant of interest; ``z`` are the coordinates of the frames, shape (frames,
    n), and ``covariances`` theirs, shape (frames, n, n). ``density`` is the spectral density of the random walk, for
    times in ``TIME``, a number or shape (n,). ``common`` are errors common to all frames: the change of the coordinates
    per standard deviation of each, shape (frames, n, m).
    """
    tau, (count, width) = times / TIME, z.shape
    powers = np.stack([tau**j / math.factorial(j) for j in range(degree + 1)], 1)
    wandering = _wandering(-tau, degree)
    wandering[np.diag_indices(count)] *= 1.0 + JITTER
    errors = np.kron(wandering, np.diag(np.broadcast_to(density, width)))
    errors.reshape(count, width, count, width)[range(count), :, range(count)] += covariances
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
    # The rates have the same coefficients, from the second on.
    pick = np.concatenate([np.arange(width * (degree + 1)), np.arange(width, width * (degree + 1))])
    coefficients = result.reshape(degree + 1, width)
    covariance = (inverse @ inverse.T)[np.ix_(pick, pick)]
    return Path(coefficients, coefficients[1:], covariance, float(left @ left) / freedom if freedom > 0 else math.nan)


def _wandering(back: Array, degree: int) -> Array:
    """Return the covariance of a ``degree``-fold integrated random walk of unit density, at times back from zero.

    The integral of ((s - u)(r - u))^degree / degree!^2 over u from 0 to min(s, r), exact by Gauss quadrature.
    """
    nodes, weights = np.polynomial.legendre.leggauss(degree + 1)
    s, r = back[:, None], back[None, :]
    least = np.maximum(np.minimum(s, r), 0.0)
    u = 0.5 * (nodes + 1.0) * least[..., None]
    inside = ((s[..., None] - u) * (r[..., None] - u)) ** degree
    return 0.5 * least * (inside @ weights) / math.factorial(degree) ** 2
