"""From the clubhead's path and the ball's position to the delivery at first touch, with its covariance."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.capture.estimators import TIME, Path
from clubface.capture.rotations import Array, angles, exponential, face_axes, left_jacobian
from clubface.equipment.clubs import Club
from clubface.equipment.face import nearest
from clubface.simulation.inputs import OF_CLUB

QUANTITIES = tuple(OF_CLUB)
"""Order of rows and columns in a covariance."""
STEP = 1e-5
"""Step of central differences [m, rad, and their rates per TIME]; the error is of the order of its square, 1e-10."""


SEEN = [-1, QUANTITIES.index("toe"), QUANTITIES.index("high")]
"""Indices of time, toe and high in the outcome, for which there may be evidence."""
UPDATES = 3
"""Number of updates of path, ball and club by evidence; where the first moved a ball by 50 mm, the second moves it by
less than a micrometre."""


class Inputs(NamedTuple):
    """Inputs of a delivery, for many variations at once."""

    position: Array  # coefficients as of :class:`Path`, shape (..., m, 6)
    rate: Array  # coefficients as of :class:`Path`, shape (..., n, 6)
    ball: Array  # centre of the ball at rest [m], shape (..., 3)
    club: Array  # its position and rotation relative to its markers [m, rad], in club axes about the CG, shape (..., 6)


def deliver(given: Inputs, attitude: Array, club: Club, radius: float) -> tuple[Array, Array]:
    """Return deliveries at first touch in the order of ``QUANTITIES``, shape (..., 11), and times [s], shape (...).

    First touch, when the ball's centre is one radius in front of the face, is found by Newton's method from time zero.
    Everything is for a right-hander; for a left-hander, path and face angle change sign later. ``attitude`` is the
    rotation from club to world axes where the rotation vector is zero, shape (3, 3), and ``radius`` the ball's [m].
    """
    time = np.zeros(given.ball.shape[:-1])
    turned = exponential(given.club[..., 3:])
    for _ in range(4):
        velocity, rotation, spin, centre, offset = _pose(given, attitude, club, turned, time)
        face = rotation @ face_axes(club.loft)
        local = np.einsum("...ji,...j->...i", face, given.ball - centre)
        distance, normal = nearest(local, club.bulge, club.roll)
        outward = np.einsum("...ij,...j->...i", face, normal)
        at_face = velocity + np.cross(spin, given.ball - radius * outward - offset)
        time = time + (distance - radius) / np.einsum("...i,...i->...", outward, at_face)
    velocity, rotation, spin, centre, _ = _pose(given, attitude, club, turned, time)
    face = rotation @ face_axes(club.loft)
    local = np.einsum("...ji,...j->...i", face, given.ball - centre)
    distance, normal = nearest(local, club.bulge, club.roll)
    touched = local - distance[..., None] * normal
    loft, yaw, lie = angles(rotation, club.loft)
    level = np.hypot(velocity[..., 0], velocity[..., 2])
    columns = {
        "speed": np.linalg.norm(velocity, axis=-1),
        "attack": np.arctan2(velocity[..., 1], level),
        "path": np.arctan2(velocity[..., 2], velocity[..., 0]),
        "loft": loft, "face": yaw, "lie": lie, "toe": touched[..., 2], "high": touched[..., 1],
        "closure": spin[..., 1], "pitch_rate": spin[..., 2], "lie_rate": -spin[..., 0],
    }  # fmt: skip
    return np.stack([columns[name] for name in QUANTITIES], -1), time


class Evidence(NamedTuple):
    """Further evidence on an impact: time of first touch on the path's clock [s], and impact point, toe and high [m].

    ``deviations`` are the standard deviations of the values.
    """

    values: Array
    deviations: Array


class Reduced(NamedTuple):
    """A delivery with its uncertainty."""

    values: Array  # in the order of ``QUANTITIES``, shape (11,)
    time: float  # of first touch [s]
    covariance: Array  # of the values, shape (11, 11)
    inputs: Inputs  # as corrected by evidence
    surprise: float = 0.0  # root mean square deviation of the evidence from its expectation, in standard deviations


def with_covariance(
    path: Path,
    ball: Array,
    attitude: Array,
    club: Club,
    radius: float,
    *,
    ball_covariance: Array,
    club_covariance: Array,
    evidence: Evidence | None = None,
) -> Reduced:
    """Return the delivery with its covariance, to first order.

    The path, the ball's position and the club's position on its markers are independent. Derivatives are central
    differences of :func:`deliver`. Evidence corrects path, ball and club together according to their uncertainties, by
    an iterated Kalman update.
    """
    base = Inputs(path.position, path.rate, ball, np.zeros(6))
    start = np.concatenate([np.ravel(each) for each in base])
    spread = np.zeros((start.size, start.size))
    at = 0
    for block in (path.covariance, ball_covariance, club_covariance):
        spread[at : at + len(block), at : at + len(block)] = block
        at += len(block)
    sizes = np.cumsum([each.size for each in base])[:-1]

    def inputs(flat: Array) -> Inputs:
        parts = np.split(flat, sizes, axis=-1)
        return Inputs(*(part.reshape(*flat.shape[:-1], *each.shape) for part, each in zip(parts, base, strict=True)))

    def outcome(flat: Array) -> Array:
        """Return the delivery and the time of first touch, shape (..., 12)."""
        values, time = deliver(inputs(flat), attitude, club, radius)
        return np.concatenate([values, time[..., None]], -1)

    def derivatives(flat: Array) -> Array:
        varied = outcome(flat + STEP * np.concatenate([np.eye(flat.size), -np.eye(flat.size)]))
        return (varied[: flat.size] - varied[flat.size :]).T / (2.0 * STEP)

    flat, jacobian, surprise = start, derivatives(start), 0.0
    if evidence is not None:
        noise = np.diag(evidence.deviations**2)
        for turn in range(UPDATES):
            rows = jacobian[SEEN]
            crossed = spread @ rows.T
            expected = outcome(flat)[SEEN] + rows @ (start - flat)
            total = rows @ crossed + noise
            gain = np.linalg.solve(total, crossed.T).T
            off = evidence.values - expected
            if turn == 0:
                surprise = float(np.sqrt(off @ np.linalg.solve(total, off) / len(off)))
            flat = start + gain @ off
            jacobian = derivatives(flat)
        rows = jacobian[SEEN]
        crossed = spread @ rows.T
        spread = spread - crossed @ np.linalg.solve(rows @ crossed + noise, crossed.T)
    result = outcome(flat)
    covariance = jacobian[:-1] @ spread @ jacobian[:-1].T
    return Reduced(result[:-1], float(result[-1]), 0.5 * (covariance + covariance.T), inputs(flat), surprise)


def gap(position: Array, rotation: Array, ball: Array, club: Club, radius: float) -> tuple[Array, Array]:
    """Return the ball's distance in front of the face [m] and its centre in face axes [m], for each frame."""
    face = rotation @ face_axes(club.loft)
    centre = position + np.einsum("...ij,j->...i", rotation, np.array(club.cg))
    local = np.einsum("...ji,...j->...i", face, ball - centre)
    return nearest(local, club.bulge, club.roll)[0] - radius, local


def _pose(given: Inputs, attitude: Array, club: Club, turned: Array, time: Array) -> tuple[Array, ...]:
    """Return velocity, rotation, angular velocity, face centre and CG of the club at ``time``."""
    place = series(given.position, time)
    rate = series(given.rate, time) / TIME
    rotation = exponential(place[..., 3:]) @ attitude
    spin = np.einsum("...ij,...j->...i", left_jacobian(place[..., 3:]), rate[..., 3:])
    arm = np.einsum("...ij,...j->...i", rotation, given.club[..., :3])
    cg = place[..., :3] + arm
    velocity = rate[..., :3] + np.cross(spin, arm)
    rotation = rotation @ turned
    return velocity, rotation, spin, cg + np.einsum("...ij,j->...i", rotation, np.array(club.cg)), cg


def series(coefficients: Array, time: Array) -> Array:
    """Evaluate coefficients like those in :class:`Path`, shape (..., n, 6), at ``time`` [s]; returns shape (..., 6)."""
    powers = [(time / TIME) ** j / math.factorial(j) for j in range(coefficients.shape[-2])]
    return np.einsum("...j,...ji->...i", np.stack(powers, -1), coefficients)
