"""Synthetic swings whose delivery is known: a clubhead on its path, a ball at rest, the impact, and what follows.

The clubhead is the end of a chain of rigid links, in closed form, so that its velocities are known exactly. An arm and
a club turn in an inclined plane about a moving hub, the club rolls about the shaft, and the shaft bends and vibrates.
The angles are hyperbolic tangents and sines of time, and they enter through sines and cosines. No polynomial and no
smoother has such a path in its family. Random swings are of the size of elite golfers' swings.
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
from clubface.capture.rotations import Array, delivered, exponential, face_axes, mirror
from clubface.equipment.balls import Ball, ball
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.face import face_point, nearest
from clubface.equipment.models import DEFAULT_MODEL
from clubface.simulation.impact import impact

STEP = 1e-25
"""Seconds; of the derivative through the complex plane, which loses no digits however small the step."""


@dataclass(frozen=True, kw_only=True)
class Turn:
    """An angle that grows like a hyperbolic tangent, and a vibration on it; zero at time zero but for the vibration.

    Attributes
    ----------
    rate
        Peak of the rate [rad/s].
    width
        Time [s] from the peak in which the rate falls to 0.42 of it.
    peak
        When [s] the rate peaks.
    amplitude, frequency, phase
        Of the vibration [rad, Hz, rad].
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
        """Return the same angle run through ``factor`` times as fast."""
        changed = {"rate": self.rate * factor, "frequency": self.frequency * factor}
        return replace(self, width=self.width / factor, peak=self.peak / factor, **changed)


@dataclass(frozen=True, kw_only=True)
class Chain:
    """Hub, arm, club and roll: the motion of a right-hander's clubhead before impact.

    Attributes
    ----------
    plane
        Inclination [rad] of the plane of the swing, from the horizontal.
    arm, club
        Angles in the plane, from straight down towards the target.
    roll
        Angle about the shaft, closing the face.
    arm_length, club_length
        [m].
    arm_start
        Angle [rad] of the arm at time zero.
    hub
        Amplitudes [m] of the hub's sways, shape (3,), in world axes.
    hub_frequency, hub_phase
        [Hz], [rad], shape (3,).
    bend
        Amplitudes [m] of the head's vibration on the shaft, shape (3,).
    bend_frequency, bend_phase
        [Hz], [rad], shape (3,).
    cg
        From the end of the shaft to the CG [m], turning with the head, shape (3,).
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
        """Return position of the CG [m] and orientation at times [s]; shapes (..., 3) and (..., 3, 3).

        Works for complex times, which is how :func:`motion` differentiates it.
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
        """Return the same path run through ``factor`` times as fast."""
        turns = {name: getattr(self, name).faster(factor) for name in ("arm", "club", "roll")}
        quick = {name: getattr(self, name) * factor for name in ("hub_frequency", "bend_frequency")}
        return replace(self, **turns, **quick)


def turn(axis: int, angle: Any) -> Any:
    """Return rotations about one axis, of angles that may be complex; shape (..., 3, 3)."""
    angle = np.asarray(angle)
    out = np.zeros((*angle.shape, 3, 3), dtype=angle.dtype)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    out[..., axis, axis] = 1.0
    out[..., i, i] = out[..., j, j] = np.cos(angle)
    out[..., j, i] = np.sin(angle)
    out[..., i, j] = -np.sin(angle)
    return out


def motion(chain: Chain, time: float = 0.0) -> tuple[Array, Array, Array, Array]:
    """Return position [m], orientation, velocity [m/s] and angular velocity [rad/s] of a chain at one time [s]."""
    position, rotation = chain.pose(np.asarray(time + 1j * STEP))
    rate = (rotation.imag / STEP) @ rotation.real.T
    spin = 0.5 * np.array([rate[2, 1] - rate[1, 2], rate[0, 2] - rate[2, 0], rate[1, 0] - rate[0, 1]])
    return position.real, rotation.real, position.imag / STEP, spin


def _sway(amplitude: Array, frequency: Array, phase: Array, time: Any) -> Any:
    return amplitude * np.sin(2.0 * np.pi * frequency * time[..., None] + phase)


CONTACT_TIME = 0.45e-3
"""Seconds; measured impacts of golf balls last 0.4 to 0.5 ms at a driver's speed."""
RESTRAINT = 250.0
"""1/s; the shaft turns a head back that impact has twisted: as at 40 Hz, critically damped. A shaft of a torque of 4
degrees at 1 ft lb lets a driver's head swing at 31 Hz about it, and bends less than it twists."""
TEE = 0.03
"""Metres; height of a tee."""
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
        The launch by the impact model [SI].
    chain
        The motion of a right-hander before impact, before it is turned into place.
    fixed
        Rotation from club axes to the axes of the chain's end, shape (3, 3).
    turned, moved
        From the world of the chain to this one: rotation, shape (3, 3), and shift [m].
    rest
        Centre of the ball before impact [m], as for a right-hander.
    slowed
        Changes of the head's velocity [m/s] and angular velocity [rad/s] by the impact, as for a right-hander.
    struck
        Velocity of the ball after the impact [m/s], as for a right-hander.
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
        """Return position of the CG [m] and attitude (club axes to world) at times [s], as for a right-hander."""
        time = np.asarray(time, dtype=np.float64)
        position, rotation = self.chain.pose(time)
        gained = _gained(time)[..., None]
        back = np.exp(-RESTRAINT * np.maximum(time, 0.0))[..., None]
        attitude = exponential(gained * back * self.slowed[1]) @ self.turned @ rotation @ self.fixed
        return position @ self.turned.T + self.moved + gained * self.slowed[0], attitude

    def points(self, local: ArrayLike, time: ArrayLike) -> Array:
        """Return the positions of points of the head in the world [m], shape (times, points, 3).

        ``local`` are points from the face centre [m], in club axes at the static loft with z towards the toe, shape
        (points, 3); ``time`` is from first touch [s], shape (times,).
        """
        position, attitude = self.head(time)
        from_cg = np.asarray(local, dtype=np.float64) + np.array(self.club.cg)
        return (position[:, None] + np.einsum("kij,mj->kmi", attitude, from_cg)) * self.mirror

    def ball_centre(self, time: ArrayLike) -> Array:
        """Return the centre of the ball in the world [m] at times [s], shape (times, 3)."""
        time = np.asarray(time, dtype=np.float64)
        fallen = 0.5 * GRAVITY * np.maximum(time, 0.0)[..., None] ** 2 * np.array([0.0, 1.0, 0.0])
        return (self.rest + _gained(time)[..., None] * self.struck - fallen) * self.mirror

    @property
    def mirror(self) -> Array:
        """What takes the world of a right-hander to that of the club's hand, shape (3,)."""
        return mirror(self.club.hand)


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
    """Return how far [m] a body goes by an impact that gives it 1 m/s: a half sine of force over the contact."""
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
"""Mean and standard deviation of deliveries [m/s, deg, mm]: of the size of elite golfers' swings (those of Caldwell and
McPhee (2023) hit drives at 101 to 118 mph). Chosen and not measured: no test of an estimator depends on them."""

_TO_SI = {"speed": 1.0, "toe": 1e-3, "high": 1e-3}
FARTHEST = 2.5
"""Standard deviations to which draws are cut, so that every impact is on the face."""


def random_swing(
    seed: int | np.random.Generator,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    model: str = DEFAULT_MODEL,
    **wanted: float,
) -> SyntheticSwing:
    """Return a random swing of the size of an elite golfer's.

    Its face closes by 3 to 4 degrees a frame at 720 Hz, as Caldwell and McPhee (2023) report.

    Parameters
    ----------
    seed
        The same seed gives the same swing.
    club
        The club.
    hand
        "right" or "left"; that of the club if left out.
    model
        The model of the impact, with its published parameters.
    **wanted
        Values to use instead of random ones [SI]: ``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``,
        ``toe``, ``high``; path and face as for a right-hander.
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
    """Return a club, as it is or for another hand."""
    head = club_of(club)
    return head if hand is None else head.replace(hand=hand)


def random_chain(random: np.random.Generator, *, iron: bool) -> Chain:
    """Return a chain with the lengths, rates and vibrations of a golfer."""

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
