"""Synthetic swings with known deliveries: a clubhead on its path, a ball at rest, the impact, and the aftermath.

The clubhead is the end of a chain of rigid links in closed form, so that its velocities are exact. An arm and a club
rotate in an inclined plane about a moving hub, the club rolls about the shaft, and the shaft bends and vibrates. The
angles are hyperbolic tangents and sines of time, and enter through sines and cosines, so the path is outside the family
of any polynomial or smoother. Random swings resemble those of elite golfers.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from clubface import units
from clubface.capture.ball_flight import GRAVITY
from clubface.capture.geometry import off_face
from clubface.capture.rotations import Array, delivered, exponential, mirror
from clubface.equipment.balls import Ball, ball
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.models import DEFAULT_MODEL
from clubface.simulation.impact import impact

STEP = 1e-25
"""Step of the complex-step derivative [s], which has no cancellation however small the step."""


@dataclass(frozen=True, kw_only=True)
class Turn:
    """An angle that rises like a hyperbolic tangent, plus a vibration; zero at time zero except for the vibration.

    Attributes
    ----------
    rate
        Peak rate [rad/s].
    width
        Time from the peak in which the rate falls to 0.42 of its peak [s].
    peak
        Time of the peak rate [s].
    amplitude, frequency, phase
        Amplitude, frequency and phase of the vibration [rad, Hz, rad].
    """

    rate: float
    width: float
    peak: float
    amplitude: float = 0.0
    frequency: float = 0.0
    phase: float = 0.0

    def __call__(self, time: Any) -> Any:
        """Return the angle [rad] at ``time`` [s]."""
        grown = np.tanh((time - self.peak) / self.width) + np.tanh(self.peak / self.width)
        vibration = self.amplitude * np.sin(2.0 * np.pi * self.frequency * time + self.phase)
        return self.rate * self.width * grown + vibration

    def faster(self, factor: float) -> Turn:
        """Return the same rotation, ``factor`` times as fast."""
        changed = {"rate": self.rate * factor, "frequency": self.frequency * factor}
        return replace(self, width=self.width / factor, peak=self.peak / factor, **changed)


@dataclass(frozen=True, kw_only=True)
class Chain:
    """Hub, arm, club and roll: motion of a right-hander's clubhead before impact.

    Attributes
    ----------
    plane
        Inclination of the swing plane from the horizontal [rad].
    arm, club
        Angles in the plane, measured from straight down towards the target.
    roll
        Angle about the shaft that closes the face.
    arm_length, club_length
        Lengths [m].
    arm_start
        Angle of the arm at time zero [rad].
    hub
        Amplitudes of the hub's sway [m], shape (3,), in world axes.
    hub_frequency, hub_phase
        Frequencies [Hz] and phases [rad] of the sway, shape (3,).
    bend
        Amplitudes of the head's vibration on the shaft [m], shape (3,).
    bend_frequency, bend_phase
        Frequencies [Hz] and phases [rad] of the vibration, shape (3,).
    cg
        Vector from the end of the shaft to the CG [m], fixed to the head, shape (3,).
    """

    plane: float
    arm: Turn
    club: Turn
    roll: Turn
    arm_length: float
    club_length: float
    arm_start: float
    hub: Array
    hub_frequency: Array
    hub_phase: Array
    bend: Array
    bend_frequency: Array
    bend_phase: Array
    cg: Array

    def pose(self, time: Any) -> tuple[Any, Any]:
        """Return CG position [m] and orientation at times [s]; shapes (..., 3) and (..., 3, 3).

        Times may be complex, for the derivatives in :func:`motion`.
        """
        time = np.asarray(time)
        sine, cosine = np.sin(self.plane), np.cos(self.plane)
        plane = np.array([[1.0, 0.0, 0.0], [0.0, sine, cosine], [0.0, -cosine, sine]])
        arm, club = self.arm(time) + self.arm_start, self.club(time)
        zero = np.zeros_like(arm)
        link = self.arm_length * np.stack([np.sin(arm), -np.cos(arm), zero], -1)
        link = link + self.club_length * np.stack([np.sin(club), -np.cos(club), zero], -1)
        rotation = plane @ turn(2, club) @ turn(1, self.roll(time))
        sway = _sway(self.hub, self.hub_frequency, self.hub_phase, time)
        bend = _sway(self.bend, self.bend_frequency, self.bend_phase, time)
        return link @ plane.T + sway + bend + rotation @ self.cg, rotation

    def faster(self, factor: float) -> Chain:
        """Return the same path, ``factor`` times as fast."""
        turns = {name: getattr(self, name).faster(factor) for name in ("arm", "club", "roll")}
        quick = {name: getattr(self, name) * factor for name in ("hub_frequency", "bend_frequency")}
        return replace(self, **turns, **quick)


def turn(axis: int, angle: Any) -> Any:
    """Return rotation matrices about one axis for angles that may be complex; shape (..., 3, 3)."""
    angle = np.asarray(angle)
    out = np.zeros((*angle.shape, 3, 3), dtype=angle.dtype)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    out[..., axis, axis] = 1.0
    out[..., i, i] = out[..., j, j] = np.cos(angle)
    out[..., j, i] = np.sin(angle)
    out[..., i, j] = -np.sin(angle)
    return out


def motion(chain: Chain, time: float = 0.0) -> tuple[Array, Array, Array, Array]:
    """Return position [m], orientation, velocity [m/s] and angular velocity [rad/s] of a chain at a time [s]."""
    position, rotation = chain.pose(np.asarray(time + 1j * STEP))
    rate = (rotation.imag / STEP) @ rotation.real.T
    spin = 0.5 * np.array([rate[2, 1] - rate[1, 2], rate[0, 2] - rate[2, 0], rate[1, 0] - rate[0, 1]])
    return position.real, rotation.real, position.imag / STEP, spin


def _sway(amplitude: Array, frequency: Array, phase: Array, time: Any) -> Any:
    return amplitude * np.sin(2.0 * np.pi * frequency * time[..., None] + phase)


CONTACT_TIME = 0.45e-3
"""Duration of contact [s]; measured impacts of golf balls last 0.4 to 0.5 ms at driver speed."""
RESTRAINT = 250.0
"""Rate at which the shaft turns back a head twisted by impact [1/s], like critical damping at 40 Hz. With a torque
rating of 4 degrees at 1 ft lb, a driver head oscillates about the shaft at 31 Hz; bending is stiffer than torsion."""
TEE = 0.03
"""Tee height [m]."""
LAUNCH = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


@dataclass(frozen=True, kw_only=True, eq=False)
class SyntheticSwing:
    """A synthetic swing. First touch is at time zero; the ball is above the world's origin.

    Attributes
    ----------
    club, ball
        The club and the ball.
    truth
        Exact delivery by name [SI], with the signs of :class:`Delivery`.
    launch
        Launch from the impact model [SI].
    chain
        Motion of a right-hander before impact, before it is rotated into place.
    fixed
        Rotation from club axes to the axes at the end of the chain, shape (3, 3).
    turned, moved
        Rotation, shape (3, 3), and translation [m] from the chain's world to this one.
    rest
        Centre of the ball before impact [m], for a right-hander.
    slowed
        Changes of the head's velocity [m/s] and angular velocity [rad/s] at impact, for a right-hander.
    struck
        Velocity of the ball after impact [m/s], for a right-hander.
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

    def head(self, time: ArrayLike) -> tuple[Array, Array]:
        """Return CG position [m] and attitude (club to world axes) at times [s], for a right-hander."""
        time = np.asarray(time, dtype=np.float64)
        position, rotation = self.chain.pose(time)
        gained = _displacement(time)[..., None]
        back = np.exp(-RESTRAINT * np.maximum(time, 0.0))[..., None]
        attitude = exponential(gained * back * self.slowed[1]) @ self.turned @ rotation @ self.fixed
        return position @ self.turned.T + self.moved + gained * self.slowed[0], attitude

    def points(self, local: ArrayLike, time: ArrayLike) -> Array:
        """Return the world positions of points on the head [m], shape (times, points, 3).

        ``local`` are positions from the face centre [m], in club axes at static loft with z towards the toe, shape
        (points, 3); ``time`` counts from first touch [s], shape (times,).
        """
        position, attitude = self.head(time)
        from_cg = np.asarray(local, dtype=np.float64) + np.array(self.club.cg)
        return (position[:, None] + np.einsum("kij,mj->kmi", attitude, from_cg)) * self.mirror

    def ball_centre(self, time: ArrayLike) -> Array:
        """Return the ball's centre in the world [m] at times [s], shape (times, 3)."""
        time = np.asarray(time, dtype=np.float64)
        fallen = 0.5 * GRAVITY * np.maximum(time, 0.0)[..., None] ** 2 * np.array([0.0, 1.0, 0.0])
        return (self.rest + _displacement(time)[..., None] * self.struck - fallen) * self.mirror

    @property
    def mirror(self) -> Array:
        """Factors from the right-hander's world to that of the club's hand, shape (3,)."""
        return mirror(self.club.hand)


def swing(club: Club, chain: Chain, asked: Mapping[str, float], model: str = DEFAULT_MODEL) -> SyntheticSwing:
    """Adapt a chain so that it delivers ``club`` with the requested values.

    The chain is run faster or slower to match the speed, and rotated as a whole to match the direction. The head is
    mounted on its end to match the attitude, and the ball is placed at its first touch. The angular rates are the
    chain's. The requested values are ``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``, ``toe`` and ``high``
    [SI], for a right-hander. The impact model has its published parameters.
    """
    chain = chain.faster(asked["speed"] / float(np.linalg.norm(motion(chain)[2])))
    position, rotation, velocity, spin = motion(chain)
    attack, path = asked["attack"], asked["path"]
    aim = np.array([math.cos(attack) * math.cos(path), math.sin(attack), math.cos(attack) * math.sin(path)])
    turned = _rotation_between(velocity / np.linalg.norm(velocity), aim)
    attitude = delivered(asked["loft"], asked["face"], asked["lie"], club.loft)
    velocity, spin = turned @ velocity, turned @ spin
    # All for a right-hander; the launch of a left-hander is its mirror image.
    as_right = {**asked, "closure": float(spin[1]), "pitch_rate": float(spin[2]), "lie_rate": float(-spin[0])}
    struck = ball()
    launched = impact(club.replace(hand="right"), as_right, ball=struck, model=model)
    after = {
        name: np.array([float(getattr(launched, f"{name}_{axis}")) for axis in "xyz"])
        for name in ("velocity", "club_velocity", "club_spin")
    }
    from_cg = attitude @ (np.array(club.cg) + off_face(club, asked["toe"], asked["high"], struck.radius))
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


def _rotation_between(start: Array, end: Array) -> Array:
    """Return the smallest rotation from one unit vector to another."""
    axis = np.cross(start, end)
    sine = float(np.linalg.norm(axis))
    return exponential(axis * (math.atan2(sine, float(start @ end)) / sine)) if sine > 0.0 else np.eye(3)


def _displacement(time: Array) -> Array:
    """Return the distance [m] moved by a body that impact accelerates by 1 m/s, for a half-sine force over contact."""
    part = np.clip(time / CONTACT_TIME, 0.0, 1.0)
    return 0.5 * CONTACT_TIME * (part - np.sin(np.pi * part) / np.pi) + np.maximum(time - CONTACT_TIME, 0.0)


DELIVERIES: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "wood": {
        "speed": (49.2, 1.8), "attack": (1.0, 2.5), "path": (1.0, 3.0), "loft": (13.0, 1.7), "face": (0.5, 2.0),
        "lie": (1.0, 1.5), "toe": (2.0, 8.0), "high": (2.0, 5.0),
    },
    "iron": {
        "speed": (40.0, 1.5), "attack": (-4.0, 1.5), "path": (0.5, 2.5), "loft": (23.0, 2.0), "face": (0.5, 2.0),
        "lie": (0.0, 1.5), "toe": (2.0, 6.0), "high": (0.0, 4.0),
    },
}  # fmt: skip
"""Mean and standard deviation of deliveries [m/s, deg, mm], typical of elite golfers (those of Caldwell and
McPhee (2023) hit drives at 101 to 118 mph). They are chosen, not measured; no test of an estimator depends on them."""

_TO_SI = {"speed": 1.0, "toe": 1e-3, "high": 1e-3}
FARTHEST = 2.5
"""Standard deviations at which draws are clipped, so that every impact is on the face."""


def random_swing(
    seed: int | np.random.Generator,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    model: str = DEFAULT_MODEL,
    **wanted: float,
) -> SyntheticSwing:
    """Return a random swing typical of an elite golfer.

    Its face closes by 3 to 4 degrees a frame at 720 Hz, as Caldwell and McPhee (2023) report.

    Parameters
    ----------
    seed
        The same seed gives the same swing.
    club
        The club.
    hand
        "right" or "left"; default: the club's.
    model
        Impact model, with its published parameters.
    **wanted
        Values that replace random ones [SI]: ``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``, ``toe``,
        ``high``; path and face for a right-hander.
    """
    random = np.random.default_rng(seed)
    head = club_of_hand(club, hand)
    iron = head.kind == "iron"
    asked = {}
    for name, (mean, deviation) in DELIVERIES["iron" if iron else "wood"].items():
        drawn = mean + deviation * float(np.clip(random.normal(), -FARTHEST, FARTHEST))
        asked[name] = wanted.get(name, drawn * _TO_SI.get(name, units.size("deg")))
    return swing(head, random_chain(random, iron=iron), asked, model)


def club_of_hand(club: str | Club, hand: str | None) -> Club:
    """Return a club, optionally with another hand."""
    head = club_of(club)
    return head if hand is None else head.replace(hand=hand)


def random_chain(random: np.random.Generator, *, iron: bool) -> Chain:
    """Return a random chain with a golfer's lengths, rates and vibrations."""

    def between(low: float, high: float, size: int | None = None) -> Any:
        return random.uniform(low, high, size)

    def vibrating(amplitude: float, slow: float, fast: float) -> dict[str, float]:
        return {"amplitude": between(0.0, amplitude), "frequency": between(slow, fast), "phase": between(0.0, 6.28)}

    return Chain(
        plane=units.to_si(between(54.0, 60.0) if iron else between(45.0, 51.0), "deg"),
        arm=Turn(rate=between(15.0, 18.0), width=between(0.10, 0.14), peak=between(-0.06, -0.03)),
        club=Turn(
            rate=between(36.0, 40.0), width=between(0.060, 0.085), peak=between(-0.010, 0.008),
            **vibrating(0.01, 8.0, 14.0),
        ),
        roll=Turn(
            rate=between(18.0, 32.0), width=between(0.04, 0.06), peak=between(-0.01, 0.02),
            **vibrating(0.01, 10.0, 18.0),
        ),
        arm_length=between(0.60, 0.70),
        club_length=between(0.80, 0.86) if iron else between(1.00, 1.08),
        arm_start=between(0.0, 0.25),
        hub=between(0.01, 0.03, 3),
        hub_frequency=between(1.0, 2.5, 3),
        hub_phase=between(0.0, 6.28, 3),
        bend=between(0.001, 0.004, 3),
        bend_frequency=between(10.0, 18.0, 3),
        bend_phase=between(0.0, 6.28, 3),
        cg=np.array([0.015, -0.02, 0.02]) if iron else np.array([0.0, -0.02, 0.04]),
    )  # fmt: skip
