"""A clubhead on its shaft: a Rayleigh beam of finite elements, its modes, and how the head moves under a short impulse.

Bending has Hermite cubics with rotary inertia, stretch and twist have linear shapes (O. C. Zienkiewicz, R. L. Taylor,
The Finite Element Method). Properties are linear between stations. The head is rigid and rigidly on the tip, so that
its six velocities, those of its CG first, take the place of those of the first node. Over half a millisecond all is
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

__all__ = ["Beam", "Modes", "added_inertia", "beam_axes", "cross_matrix", "head_on_beam", "modes", "natural_modes"]

ELEMENTS = 60
"""Twice as many change what the shaft adds to a head by less than 1e-4 of it."""
GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(4)
GRIPS = ("free", "pinned", "clamped")
MATCHINGS = ("motion", "work")
ROUNDING = 1e-9
"""Part of the mass of the head by which rounding may make what is added negative, and up to which it is set to 0."""


@dataclass(frozen=True, eq=False)
class Beam:
    """A straight beam from its tip, where the head is, to its butt; properties are linear between stations.

    Attributes
    ----------
    position
        Of the stations from the tip [m], from 0 to the length, shape (n,).
    mass
        Per length [kg/m], shape (n,).
    bending, torsion, axial
        EI [N m2], GJ [N m2] and EA [N], shape (n,).
    gyration
        Radius of gyration of the section about a diameter [m], shape (n,).
    grip
        How the butt is held, one of ``GRIPS``.
    grip_stiffness
        Of a pinned butt against rotation [N m/rad].
    grip_mass
        At the butt [kg].
    """

    position: NDArray[Any]
    mass: NDArray[Any]
    bending: NDArray[Any]
    torsion: NDArray[Any]
    axial: NDArray[Any]
    gyration: NDArray[Any]
    grip: str = "free"
    grip_stiffness: float = 0.0
    grip_mass: float = 0.0

    def nodes(self, elements: int) -> NDArray[Any]:
        """Return the places of about ``elements`` + 1 nodes [m], with one at each station."""
        length = self.position[-1]
        pieces = [
            np.linspace(start, end, max(1, round(elements * (end - start) / length)), endpoint=False)
            for start, end in pairwise(self.position)
        ]
        return np.append(np.concatenate(pieces), length)

    def matrices(self, elements: int = ELEMENTS) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return stiffness and mass, shape (6 n, 6 n), of a beam that nothing holds.

        A node has displacements along the beam, then along two directions across it, which make a right-handed
        system, then the rotations about these.
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
    """Return the matrix of the cross product with a vector on its left."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


class Modes(NamedTuple):
    """Modes of a head on its shaft, each of unit modal mass.

    Attributes
    ----------
    frequency
        Angular frequencies, ascending; those of a motion as a rigid body are 0 but for rounding [rad/s], shape (n,).
    head
        Velocity of the CG and angular velocity of the head, in its axes, in each mode, shape (6, n).
    """

    frequency: NDArray[Any]
    head: NDArray[Any]

    def mobility(self, time: float, matching: str = MATCHINGS[0]) -> NDArray[Any]:
        """Return a matrix by which impulses on the head (6), half sines of the given length [s], move it (6).

        With x = w T / pi and s = cos(w T / 2)^2, a mode of frequency w has in the end s / (1 - x^2) of the velocity by
        an instantaneous impulse, and has taken s / (1 - x^2)^2 of the work.

        Parameters
        ----------
        time
            Length of the pulse [s].
        matching
            "motion" for the velocity of the head at the end of the pulse, "work" for the work that it does. They differ
            by what stays behind as vibration.
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
        """Return the velocities of the head by forces and moments on it, linear between points in time.

        Parameters
        ----------
        time
            Ascending [s], shape (n,).
        wrench
            Force and moment about the CG, in the axes of the head [N, N m], shape (n, 6).

        Returns
        -------
        numpy.ndarray
            Velocity of the CG and angular velocity [m/s, rad/s], from rest, shape (n, 6).
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
        """Return modal displacements and velocities after a step [s] in which modal forces change linearly; exact."""
        phase = self.frequency * step
        slow = phase < 1e-3
        w = np.where(slow, 1.0, self.frequency)
        cosine, sine = np.cos(phase), np.sin(phase)
        # Integrals of sin(w t)/w and of its integrals; slow modes by their series.
        s = np.where(slow, step * (1.0 - phase**2 / 6.0), sine / w)
        first = np.where(slow, step**2 * (0.5 - phase**2 / 24.0), (1.0 - cosine) / w**2)
        second = np.where(slow, step**3 * (1.0 / 6.0 - phase**2 / 120.0), (phase - sine) / w**3)
        rise = (end - start) / step
        return (
            cosine * displacement + s * velocity + first * start + second * rise,
            -(self.frequency**2) * s * displacement + cosine * velocity + s * start + first * rise,
        )


def modes(beam: Beam, head: NDArray[Any], tip: NDArray[Any], axis: NDArray[Any], *, elements: int = ELEMENTS) -> Modes:
    """Return the modes of a head on a beam of about so many ``elements``.

    In the axes of the head ``head`` is its free spatial inertia about its CG, shape (6, 6), ``tip`` the vector from the
    CG to the tip of the beam [m], and ``axis`` the direction of the beam from tip to butt.
    """
    squares, vectors = natural_modes(*head_on_beam(beam, head, tip, axis, elements=elements))
    return Modes(np.sqrt(np.maximum(squares, 0.0)), vectors[:6])


def head_on_beam(
    beam: Beam, head: NDArray[Any], tip: NDArray[Any], axis: NDArray[Any], *, elements: int = ELEMENTS
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return stiffness and mass of a head on a beam, without what the grip holds; the parameters are those of modes.

    First come velocity of the CG and angular velocity of the head, in its axes, then the nodes from the second one on,
    in the axes of ``beam_axes``.
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
    """Return the directions of a beam's displacements, along and twice across it, as the rows of a rotation."""
    along = axis / np.linalg.norm(axis)
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    across /= np.linalg.norm(across)
    return np.stack([along, across, np.cross(along, across)])


def natural_modes(stiffness: NDArray[Any], mass: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return squares of the angular frequencies, ascending, and modes of unit modal mass as columns."""
    inverse = np.linalg.inv(np.linalg.cholesky(mass))
    symmetric = inverse @ stiffness @ inverse.T
    squares, vectors = np.linalg.eigh(0.5 * (symmetric + symmetric.T))
    return squares, inverse.T @ vectors


def added_inertia(total: NDArray[Any], head: NDArray[Any]) -> NDArray[Any]:
    """Return what a mechanism adds to a head: total less own spatial inertia, with rounding below 0 set to 0.

    Raises
    ------
    ValueError
        The total is less than the head's own in some motion, beyond rounding.
    """
    # A length that makes all elements masses.
    length = math.sqrt(np.trace(head[3:, 3:]) / head[0, 0])
    scale = np.repeat([1.0, 1.0 / length], 3)
    added = (total - head) * np.outer(scale, scale)
    values, vectors = np.linalg.eigh(0.5 * (added + added.T))
    if values[0] < -ROUNDING * max(head[0, 0], values[-1]):
        raise ValueError(f"{values[0]:.3g} kg")
    made = (vectors * np.maximum(values, 0.0)) @ vectors.T / np.outer(scale, scale)
    return 0.5 * (made + made.T)
