"""The swing of a clubhead as a chain of rigid links, in closed form, so that its velocities are known exactly.

An arm and a club turn in an inclined plane about a moving hub, the club rolls about the shaft, and the shaft bends and
vibrates. The angles are hyperbolic tangents and sines of time, and they enter through sines and cosines. No polynomial
and no smoother has such a path in its family.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
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
