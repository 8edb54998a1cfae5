"""From the path of the clubhead and the place of the ball to the delivery at first touch, with its covariance."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.equipment.clubs import Club
from clubface.equipment.face import nearest
from clubface.motion_capture.attitude import angles, face_axes
from clubface.motion_capture.estimators import TIME, Path
from clubface.motion_capture.rotations import Array, exponential, left_jacobian
from clubface.simulation.delivery import OF_CLUB

QUANTITIES = tuple(OF_CLUB)
"""Order of rows and columns of a covariance."""
STEP = 1e-5
"""Of the central differences: metres, radians, and their rates a TIME; their error is of its square, 1e-10."""


class Inputs(NamedTuple):
    """What a delivery is made of, for many variations at once.

    Attributes
    ----------
    position, rate
        Coefficients as of :class:`Path`, shape (..., m, 6) and (..., n, 6).
    ball
        Centre of the ball at rest [m], shape (..., 3).
    club
        Place and turn of the club against its markers [m, rad], in club axes about the CG, shape (..., 6).
    """

    position: Array
    rate: Array
    ball: Array
    club: Array


def deliver(given: Inputs, attitude: Array, club: Club, radius: float) -> tuple[Array, Array]:
    """Return the delivery at first touch, in the order of ``QUANTITIES``, shape (..., 11), and its time [s], (...).

    First touch is when the ball's centre is its radius in front of the face, found by Newton's method from time zero.
    All is as of a right-hander; path and face angle of a left-hander change their signs later.

    Parameters
    ----------
    given
        Path, ball and club.
    attitude
        From club axes to the world where the rotation vector is zero, shape (3, 3).
    club
        Its CG, loft and face.
    radius
        Of the ball [m].
    """
    time = np.zeros(given.ball.shape[:-1])
    turned = exponential(given.club[..., 3:])
    for _ in range(4):
        _, velocity, rotation, spin, centre, offset = _pose(given, attitude, club, turned, time)
        face = rotation @ face_axes(club.loft)
        local = np.einsum("...ji,...j->...i", face, given.ball - centre)
        distance, normal = nearest(local, club.bulge, club.roll)
        outward = np.einsum("...ij,...j->...i", face, normal)
        at_face = velocity + np.cross(spin, given.ball - radius * outward - offset)
        time = time + (distance - radius) / np.einsum("...i,...i->...", outward, at_face)
    _, velocity, rotation, spin, centre, _ = _pose(given, attitude, club, turned, time)
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


def with_covariance(
    path: Path,
    ball: Array,
    attitude: Array,
    club: Club,
    radius: float,
    *,
    ball_covariance: Array,
    club_covariance: Array,
) -> tuple[Array, float, Array]:
    """Return the delivery, the time of first touch [s] and the covariance of the delivery, to first order.

    Markers before impact, the ball's rest and the club on its markers are independent of each other; the derivatives
    are central differences of :func:`deliver`.
    """
    base = Inputs(path.position, path.rate, ball, np.zeros(6))
    flat = np.concatenate([np.ravel(each) for each in base])
    varied = flat + STEP * np.concatenate([np.eye(flat.size), -np.eye(flat.size)])
    sizes = np.cumsum([each.size for each in base])[:-1]
    parts = np.split(varied, sizes, axis=1)
    many = Inputs(*(part.reshape(-1, *each.shape) for part, each in zip(parts, base, strict=True)))
    values, _ = deliver(many, attitude, club, radius)
    jacobian = (values[: flat.size] - values[flat.size :]).T / (2.0 * STEP)
    spread = np.zeros((flat.size, flat.size))
    at = 0
    for block in (path.covariance, ball_covariance, club_covariance):
        spread[at : at + len(block), at : at + len(block)] = block
        at += len(block)
    delivery, time = deliver(base, attitude, club, radius)
    return delivery, float(time), jacobian @ spread @ jacobian.T


def gap(position: Array, rotation: Array, ball: Array, club: Club, radius: float) -> tuple[Array, Array]:
    """Return how far the ball is in front of the face [m], and its centre in face axes [m], frame by frame."""
    face = rotation @ face_axes(club.loft)
    centre = position + np.einsum("...ij,j->...i", rotation, np.array(club.cg))
    local = np.einsum("...ji,...j->...i", face, ball - centre)
    return nearest(local, club.bulge, club.roll)[0] - radius, local


def _pose(given: Inputs, attitude: Array, club: Club, turned: Array, time: Array) -> tuple[Array, ...]:
    """Return position, velocity, rotation, angular velocity, face centre and CG of the club at ``time``."""
    place = _series(given.position, time)
    rate = _series(given.rate, time) / TIME
    rotation = exponential(place[..., 3:]) @ attitude
    spin = np.einsum("...ij,...j->...i", left_jacobian(place[..., 3:]), rate[..., 3:])
    arm = np.einsum("...ij,...j->...i", rotation, given.club[..., :3])
    cg = place[..., :3] + arm
    velocity = rate[..., :3] + np.cross(spin, arm)
    rotation = rotation @ turned
    return place[..., :3], velocity, rotation, spin, cg + np.einsum("...ij,j->...i", rotation, np.array(club.cg)), cg


def _series(coefficients: Array, time: Array) -> Array:
    powers = [(time / TIME) ** j / math.factorial(j) for j in range(coefficients.shape[-2])]
    return np.einsum("...j,...ji->...i", np.stack(powers, -1), coefficients)
