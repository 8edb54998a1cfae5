"""A swing whose delivery is known: a clubhead on its path, a ball at rest, the blow, and what follows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from clubface.equipment.balls import Ball, ball
from clubface.equipment.clubs import Club
from clubface.equipment.face import face_point, nearest
from clubface.equipment.models import DEFAULT_MODEL
from clubface.motion_capture.attitude import delivered, face_axes
from clubface.motion_capture.ball_flight import GRAVITY
from clubface.motion_capture.rotations import Array, exponential
from clubface.motion_capture.synthetic.path import Chain, motion
from clubface.simulation.impact import impact

CONTACT_TIME = 0.45e-3
"""Seconds; measured impacts of golf balls last 0.4 to 0.5 ms at a driver's speed."""
RESTRAINT = 250.0
"""1/s; the shaft turns a head back that the blow has twisted: as at 40 Hz, critically damped. A shaft of a torque of 4
degrees at 1 ft lb lets a driver's head swing at 31 Hz about it, and bends less than it twists."""
TEE = 0.03
"""Metres under a ball that lies on a tee."""
MIRROR = np.array([1.0, 1.0, -1.0])
LAUNCH = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


@dataclass(frozen=True, kw_only=True, eq=False)
class SyntheticSwing:
    """One swing. First touch is at time zero; the ball lies over the origin of the world.

    Attributes
    ----------
    club, ball
        The club and the ball.
    truth
        The exact delivery by name [SI], with the signs of :class:`Delivery`.
    launch
        The launch by the model of the blow [SI].
    chain
        The motion of a right-hander before impact, before it is turned into place.
    fixed
        Rotation from club axes to the axes of the chain's end, shape (3, 3).
    turned, moved
        From the world of the chain to this one: rotation, shape (3, 3), and shift [m].
    rest
        Centre of the ball before impact [m], as for a right-hander.
    slowed
        Changes of the head's velocity [m/s] and angular velocity [rad/s] by the blow, as for a right-hander.
    struck
        Velocity of the ball after the blow [m/s], as for a right-hander.
    """

    club: Club
    ball: Ball
    truth: Mapping[str, float]
    launch: Mapping[str, float]
    chain: Chain
    fixed: Array
    turned: Array
    moved: Array
    rest: Array
    slowed: tuple[Array, Array]
    struck: Array

    def head(self, time: Any) -> tuple[Array, Array]:
        """Return position of the CG [m] and attitude (club axes to world) at times [s], as for a right-hander."""
        time = np.asarray(time, dtype=np.float64)
        position, rotation = self.chain.pose(time)
        gained = _gained(time)[..., None]
        back = np.exp(-RESTRAINT * np.maximum(time, 0.0))[..., None]
        attitude = exponential(gained * back * self.slowed[1]) @ self.turned @ rotation @ self.fixed
        return position @ self.turned.T + self.moved + gained * self.slowed[0], attitude

    def points(self, local: Any, time: Any) -> Array:
        """Return the positions of points of the head in the world [m], shape (times, points, 3).

        Parameters
        ----------
        local
            Points from the face centre [m], in club axes at the static loft with z towards the toe, shape (points, 3).
        time
            Times from first touch [s], shape (times,).
        """
        position, attitude = self.head(time)
        from_cg = np.asarray(local, dtype=np.float64) + np.array(self.club.cg)
        return (position[:, None] + np.einsum("kij,mj->kmi", attitude, from_cg)) * self.mirror

    def ball_centre(self, time: Any) -> Array:
        """Return the centre of the ball in the world [m] at times [s], shape (times, 3)."""
        time = np.asarray(time, dtype=np.float64)
        fallen = 0.5 * GRAVITY * np.maximum(time, 0.0)[..., None] ** 2 * np.array([0.0, 1.0, 0.0])
        return (self.rest + _gained(time)[..., None] * self.struck - fallen) * self.mirror

    @property
    def mirror(self) -> Array:
        """What takes the world of a right-hander to that of the club's hand, shape (3,)."""
        return MIRROR if self.club.hand < 0 else np.ones(3)


def swing(club: Club, chain: Chain, asked: Mapping[str, float], model: str = DEFAULT_MODEL) -> SyntheticSwing:
    """Place a chain so that it delivers ``club`` as ``asked``.

    The chain runs faster or slower to meet the speed, and is turned as a whole to meet the direction. The head is set
    on its end to meet the attitude, and the ball is placed where the face touches it first. The rates are those of the
    chain.

    Parameters
    ----------
    club
        The club.
    chain
        The motion before impact.
    asked
        ``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``, ``toe``, ``high`` [SI], as for a right-hander.
    model
        The model of the impact, with its published parameters.
    """
    chain = chain.faster(asked["speed"] / float(np.linalg.norm(motion(chain)[2])))
    position, rotation, velocity, spin = motion(chain)
    attack, path = asked["attack"], asked["path"]
    aim = np.array([math.cos(attack) * math.cos(path), math.sin(attack), math.cos(attack) * math.sin(path)])
    turned = _between(velocity / np.linalg.norm(velocity), aim)
    attitude = delivered(asked["loft"], asked["face"], asked["lie"], club.loft)
    velocity, spin = turned @ velocity, turned @ spin
    # As of a right-hander all through; the launch of a left-hander is its mirror image.
    as_right = {**asked, "closure": float(spin[1]), "pitch_rate": float(spin[2]), "lie_rate": float(-spin[0])}
    struck = ball()
    launched = impact(club.replace(hand="right"), as_right, ball=struck, model=model)
    after = {
        name: np.array([float(getattr(launched, f"{name}_{axis}")) for axis in "xyz"])
        for name in ("velocity", "club_velocity", "club_spin")
    }
    touched = face_point(asked["toe"], asked["high"], club.bulge, club.roll)
    normal = nearest(touched, club.bulge, club.roll)[1]
    from_cg = attitude @ (np.array(club.cg) + face_axes(club.loft) @ (touched + struck.radius * normal))
    rest = np.array([0.0, struck.radius + (0.0 if club.kind == "iron" else TEE), 0.0])
    signs = {name: club.hand if name in ("path", "face", "azimuth", "sidespin") else 1 for name in (*as_right, *LAUNCH)}
    return SyntheticSwing(
        club=club,
        ball=struck,
        truth={name: value * signs[name] for name, value in as_right.items()},
        launch={name: float(getattr(launched, name)) * signs[name] for name in LAUNCH},
        chain=chain,
        fixed=(turned @ rotation).T @ attitude,
        turned=turned,
        moved=rest - from_cg - turned @ position,
        rest=rest,
        slowed=(after["club_velocity"] - velocity, after["club_spin"] - spin),
        struck=after["velocity"],
    )


def _between(start: Array, end: Array) -> Array:
    """Return the smallest rotation that takes one unit vector to another."""
    axis = np.cross(start, end)
    sine = float(np.linalg.norm(axis))
    return exponential(axis * (math.atan2(sine, float(start @ end)) / sine)) if sine > 0.0 else np.eye(3)


def _gained(time: Array) -> Array:
    """Return how far [m] a body goes by a blow that gives it 1 m/s: a half sine of force over the contact."""
    part = np.clip(time / CONTACT_TIME, 0.0, 1.0)
    return 0.5 * CONTACT_TIME * (part - np.sin(np.pi * part) / np.pi) + np.maximum(time - CONTACT_TIME, 0.0)
