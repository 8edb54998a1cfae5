"""A clubhead on its shaft: a Rayleigh beam of finite elements, its modes, and the head's response to a short impulse.

Bending uses Hermite cubics with rotary inertia, stretch and twist linear shape functions (O. C. Zienkiewicz, R. L.
Taylor, The Finite Element Method). Properties are linear between stations. The head is rigid and rigidly joined to the
tip: its six velocities, those of the CG first, replace those of the first node. Over half a millisecond the motion is
linear, and modal superposition is exact.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

ELEMENTS = 60
"""Number of elements of a shaft; doubling it changes the inertia added to the head by less than 1e-4, relative."""
GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(4)
GRIPS = ("free", "pinned", "clamped")
MATCHINGS = ("motion", "work")
ROUNDING = 1e-9
"""Added inertia that is negative by less than this share of the head's mass is rounding, and set to 0."""


@dataclass(frozen=True, eq=False)
class Beam:
    """A straight beam from the tip, where the head is, to the butt; properties are linear between stations.

    All arrays have shape (n,).
    """

    position: NDArray[Any]  # distances of the stations from the tip [m], from 0 to the length
    mass: NDArray[Any]  # per length [kg/m]
    bending: NDArray[Any]  # EI [N m2]
    torsion: NDArray[Any]  # GJ [N m2]
    axial: NDArray[Any]  # EA [N]
    gyration: NDArray[Any]  # radius of gyration of the cross-section about a diameter [m]
    grip: str = "free"  # boundary condition at the butt, one of ``GRIPS``
    grip_stiffness: float = 0.0  # rotational stiffness of a pinned butt [N m/rad]
    grip_mass: float = 0.0  # at the butt [kg]

    def nodes(self, elements: int) -> NDArray[Any]:
        """Return the positions of about ``elements`` + 1 nodes [m], one of them at each station."""
        length = self.position[-1]
        pieces = [
            np.linspace(start, end, max(1, round(elements * (end - start) / length)), endpoint=False)
            for start, end in pairwise(self.position)
        ]
        return np.append(np.concatenate(pieces), length)

    def matrices(self, elements: int = ELEMENTS) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the stiffness and mass matrices of the free beam, shape (6 n, 6 n).

        The degrees of freedom of a node are its displacements along the beam and in two directions across it, which
        form a right-handed system, then the rotations about the same axes.
        """
        nodes = self.nodes(elements)
        stiffness, mass = np.zeros((2, 6 * len(nodes), 6 * len(nodes)))
        for place, (start, end) in enumerate(pairwise(nodes)):
            own = slice(6 * place, 6 * place + 12)
            element_stiffness, element_mass = self._element(start, end)
            stiffness[own, own] += element_stiffness
            mass[own, own] += element_mass
        return stiffness, mass

    def _element(self, start: float, end: float) -> tuple[NDArray[Any], NDArray[Any]]:
        length = end - start
        x = 0.5 * (1.0 + GAUSS_POINTS)
        weights = 0.5 * length * GAUSS_WEIGHTS
        at = start + length * x
        mass, bending, torsion, axial, gyration = (
            np.interp(at, self.position, each)
            for each in (self.mass, self.bending, self.torsion, self.axial, self.gyration)
        )
        rotary = mass * gyration**2
        one = np.ones_like(x)
        linear = np.stack([1.0 - x, x])
        linear_slope = np.stack([-one, one]) / length
        cubic = np.stack([
            1.0 - 3.0 * x**2 + 2.0 * x**3, length * (x - 2.0 * x**2 + x**3),
            3.0 * x**2 - 2.0 * x**3, length * (x**3 - x**2),
        ])  # fmt: skip
        slope = np.stack([
            6.0 * (x**2 - x) / length, 1.0 - 4.0 * x + 3.0 * x**2, 6.0 * (x - x**2) / length, 3.0 * x**2 - 2.0 * x,
        ])  # fmt: skip
        curvature = np.stack([
            (12.0 * x - 6.0) / length**2, (6.0 * x - 4.0) / length,
            (6.0 - 12.0 * x) / length**2, (6.0 * x - 2.0) / length,
        ])  # fmt: skip

        def integral(shape: NDArray[Any], density: NDArray[Any]) -> NDArray[Any]:
            return (shape * (weights * density)) @ shape.T

        bent = integral(curvature, bending)
        moved = integral(cubic, mass) + integral(slope, rotary)
        element_stiffness, element_mass = np.zeros((2, 12, 12))
        for places, signs, k, m in (
            ([0, 6], (1.0, 1.0), integral(linear_slope, axial), integral(linear, mass)),
            ([3, 9], (1.0, 1.0), integral(linear_slope, torsion), integral(linear, 2.0 * rotary)),
            ([1, 5, 7, 11], (1.0, 1.0, 1.0, 1.0), bent, moved),
            # A positive rotation about the second direction moves the third one down along the beam.
            ([2, 4, 8, 10], (1.0, -1.0, 1.0, -1.0), bent, moved),
        ):
            sign = np.outer(signs, signs)
            element_stiffness[np.ix_(places, places)] += sign * k
            element_mass[np.ix_(places, places)] += sign * m
        return element_stiffness, element_mass


def cross_matrix(vector: NDArray[Any]) -> NDArray[Any]:
    """Return the matrix [v]x, for which [v]x u = v x u."""
    return np.cross(vector, np.eye(3)).T


class Modes(NamedTuple):
    """Vibration modes of a head on its shaft, with unit modal mass.

    The angular frequencies [rad/s] ascend, shape (n,); those of rigid-body motions are 0 up to rounding.
    """

    frequency: NDArray[Any]
    head: NDArray[Any]  # velocity of the CG and angular velocity in each mode, in the axes of the head, shape (6, n)

    def mobility(self, time: float, matching: str = MATCHINGS[0]) -> NDArray[Any]:
        """Return the mobility matrix of the head under a half-sine pulse, shape (6, 6): its velocities per impulse.

        With x = w T / pi and s = cos(w T / 2)^2, a mode of frequency w ends with s / (1 - x^2) of the velocity that an
        instantaneous impulse would give it, and has absorbed s / (1 - x^2)^2 of the work. ``time`` is the duration T
        [s]. ``matching`` "motion" matches the velocity of the head at the end of the pulse, "work" the work done by it;
        they differ by the energy left as vibration.
        """
        ratio = self.frequency * time / math.pi
        # Both shares are smooth where the ratio is 1: 0 and (pi / 4)^2.
        resonant = np.abs(ratio - 1.0) < 1e-6
        over = np.where(resonant, 1.0, 1.0 - ratio**2)
        pulse = np.cos(0.5 * math.pi * ratio) ** 2
        share = (
            np.where(resonant, (math.pi / 4.0) ** 2, pulse / over**2)
            if matching == "work"
            else np.where(resonant, 0.0, pulse / over)
        )
        return (self.head * share) @ self.head.T

    def velocities(self, time: NDArray[Any], wrench: NDArray[Any]) -> NDArray[Any]:
        """Return the velocity of the CG and the angular velocity [m/s, rad/s], starting from rest, shape (n, 6).

        ``wrench`` holds force and moment about the CG, in the axes of the head [N, N m], shape (n, 6); they are linear
        between the ascending points in ``time`` [s], shape (n,).
        """
        steps = np.diff(time)
        load = wrench @ self.head
        displacement, velocity = np.zeros((2, len(self.frequency)))
        motion = np.zeros((len(time), 6))
        for place, step in enumerate(steps):
            displacement, velocity = self.advance(displacement, velocity, load[place], load[place + 1], float(step))
            motion[place + 1] = self.head @ velocity
        return motion

    def advance(
        self, displacement: NDArray[Any], velocity: NDArray[Any], start: NDArray[Any], end: NDArray[Any], step: float
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return modal displacements and velocities after a step [s] with linearly changing modal forces; exact."""
        phase = self.frequency * step
        slow = phase < 1e-3
        w = np.where(slow, 1.0, self.frequency)
        cosine, sine = np.cos(phase), np.sin(phase)
        # Repeated integrals of sin(w t)/w; series for slow modes.
        s = np.where(slow, step * (1.0 - phase**2 / 6.0), sine / w)
        first = np.where(slow, step**2 * (0.5 - phase**2 / 24.0), (1.0 - cosine) / w**2)
        second = np.where(slow, step**3 * (1.0 / 6.0 - phase**2 / 120.0), (phase - sine) / w**3)
        rise = (end - start) / step
        return (
            cosine * displacement + s * velocity + first * start + second * rise,
            -(self.frequency**2) * s * displacement + cosine * velocity + s * start + first * rise,
        )


def modes(beam: Beam, head: NDArray[Any], tip: NDArray[Any], axis: NDArray[Any], *, elements: int = ELEMENTS) -> Modes:
    """Return the modes of a head on a beam of about ``elements`` elements.

    In the axes of the head, ``head`` is the spatial inertia of the free head about its CG, shape (6, 6), ``tip`` the
    vector from the CG to the tip of the beam [m], and ``axis`` the direction of the beam from tip to butt.
    """
    squares, vectors = natural_modes(*head_on_beam(beam, head, tip, axis, elements=elements))
    return Modes(np.sqrt(np.maximum(squares, 0.0)), vectors[:6])


def head_on_beam(
    beam: Beam, head: NDArray[Any], tip: NDArray[Any], axis: NDArray[Any], *, elements: int = ELEMENTS
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the stiffness and mass matrices of a head on a beam with a free butt; parameters as for :func:`modes`.

    The first six degrees of freedom are the velocity of the CG and the angular velocity of the head, in its axes; then
    come the nodes from the second on, in the axes of ``beam_axes``.
    """
    stiffness, mass = beam.matrices(elements)
    turn = beam_axes(axis)
    onto = np.zeros((6, 6))
    onto[:3, :3] = onto[3:, 3:] = turn
    onto[:3, 3:] = -turn @ cross_matrix(tip)
    for matrix in (stiffness, mass):
        matrix[:6] = onto.T @ matrix[:6]
        matrix[:, :6] = matrix[:, :6] @ onto
    mass[:6, :6] += head
    butt = len(mass) - 6
    mass[range(butt, butt + 3), range(butt, butt + 3)] += beam.grip_mass
    if beam.grip == "pinned":
        stiffness[range(butt + 3, butt + 6), range(butt + 3, butt + 6)] += beam.grip_stiffness
    held = {"free": 0, "pinned": 3, "clamped": 6}[beam.grip]
    kept = np.r_[:butt, butt + held : butt + 6]
    return stiffness[np.ix_(kept, kept)], mass[np.ix_(kept, kept)]


def beam_axes(axis: NDArray[Any]) -> NDArray[Any]:
    """Return the axes of a beam, one along it and two across it, as the rows of a rotation matrix."""
    along = axis / np.linalg.norm(axis)
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    across /= np.linalg.norm(across)
    return np.stack([along, across, np.cross(along, across)])


def natural_modes(stiffness: NDArray[Any], mass: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the squared angular frequencies, ascending, and the mode shapes of unit modal mass as columns."""
    inverse = np.linalg.inv(np.linalg.cholesky(mass))
    symmetric = inverse @ stiffness @ inverse.T
    squares, vectors = np.linalg.eigh(0.5 * (symmetric + symmetric.T))
    return squares, inverse.T @ vectors


def added_inertia(total: NDArray[Any], head: NDArray[Any]) -> NDArray[Any]:
    """Return the spatial inertia that a mechanism adds to a head: total minus own, negative rounding set to 0.

    Raises ValueError if in some motion the total is less than the head's own inertia, by more than rounding.
    """
    # Scaled by a length, all elements are masses.
    length = math.sqrt(np.trace(head[3:, 3:]) / head[0, 0])
    scale = np.repeat([1.0, 1.0 / length], 3)
    added = (total - head) * np.outer(scale, scale)
    values, vectors = np.linalg.eigh(0.5 * (added + added.T))
    if values[0] < -ROUNDING * max(head[0, 0], values[-1]):
        raise ValueError(f"{values[0]:.3g} kg")
    made = (vectors * np.maximum(values, 0.0)) @ vectors.T / np.outer(scale, scale)
    return 0.5 * (made + made.T)
