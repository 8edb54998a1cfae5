"""How a shaft loads a head during contact: waves run up a steel tube that is welded to the hosel.

A contact lasts half a millisecond, in which bending waves come 9 cm far. So the hands and most of the shaft are not
there yet for the ball, but the first centimetres are, and on a small head they weigh much.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

STEEL = 210e9, 80e9, 7850.0
"""Young's modulus and shear modulus [Pa], density [kg/m3]."""
TUBE = 9.4e-3, 0.6e-3, 1.0
"""Outer diameter of the tip, wall, length [m]. Assumed: a usual parallel tip of 0.370 in, as thick all along."""
LIE = math.radians(62.0)
HOSEL = np.array([0.0, 38e-3, -62e-3])
"""Top of the hosel from the mass centre, axes x, y, z [m]. Assumed: the axis of the shaft passes 37 mm from it."""


def effective_inertia(mass: float, inertia: Any, time: float, elements: int = 50) -> Any:
    """Return the 6 by 6 inertia about the head's mass centre with which a head on a shaft answers to one contact.

    Its inverse gives the velocity and spin that the head has gained when a force of half a sine of ``time`` [s] ends.
    For a free head it holds ``mass`` [kg] and ``inertia`` [kg m2].
    """
    count = 6 * (elements + 1)
    stiffness, masses = np.zeros((count, count)), np.zeros((count, count))
    k, m = beam_element(TUBE[2] / elements)
    for first in range(0, 6 * elements, 6):
        part = slice(first, first + 12)
        stiffness[part, part] += k
        masses[part, part] += m
    # The end of the shaft moves with the head: its freedoms are those of the head's mass centre.
    joined = np.eye(count)
    joined[:6, :6] = hosel_motion()
    stiffness, masses = joined.T @ stiffness @ joined, joined.T @ masses @ joined
    masses[:3, :3] += mass * np.eye(3)
    masses[3:6, 3:6] += inertia
    return np.linalg.inv(gained_velocity(stiffness, masses, time))


def hosel_motion() -> Any:
    """Return the matrix from velocity and spin of the head to those of the hosel in axes along and across the shaft."""
    along = np.array([0.0, math.sin(LIE), -math.cos(LIE)])
    across = np.cross([1.0, 0.0, 0.0], along)
    axes = np.array([along, across, np.cross(along, across)])
    arm = np.cross(np.eye(3), HOSEL).T  # arm @ spin is spin cross HOSEL
    return np.block([[axes, axes @ arm], [np.zeros((3, 3)), axes]])


def beam_element(length: float) -> tuple[Any, Any]:
    """Return stiffness and mass of a tube by Euler and Bernoulli: stretched, twisted, bent in both planes."""
    young, shear, density = STEEL
    outer, wall, _ = TUBE
    area = math.pi / 4.0 * (outer**2 - (outer - 2.0 * wall) ** 2)
    bending = math.pi / 64.0 * (outer**4 - (outer - 2.0 * wall) ** 4)
    k, m = np.zeros((12, 12)), np.zeros((12, 12))
    for first, stiff, heavy in ((0, young * area, area), (3, 2.0 * shear * bending, 2.0 * bending)):
        pair = np.ix_([first, first + 6], [first, first + 6])
        k[pair] = stiff / length * np.array([[1, -1], [-1, 1]])
        m[pair] = density * heavy * length / 6.0 * np.array([[2, 1], [1, 2]])
    a = length
    bent = np.array([[12, 6 * a, -12, 6 * a], [6 * a, 4 * a**2, -6 * a, 2 * a**2],
                     [-12, -6 * a, 12, -6 * a], [6 * a, 2 * a**2, -6 * a, 4 * a**2]])  # fmt: skip
    moved = np.array([[156, 22 * a, 54, -13 * a], [22 * a, 4 * a**2, 13 * a, -3 * a**2],
                      [54, 13 * a, 156, -22 * a], [-13 * a, -3 * a**2, -22 * a, 4 * a**2]])  # fmt: skip
    # The slope is the rotation about z in one plane, and minus that about y in the other.
    for freedoms, sign in (([1, 5, 7, 11], 1.0), ([2, 4, 8, 10], -1.0)):
        signs = np.outer([1.0, sign, 1.0, sign], [1.0, sign, 1.0, sign])
        k[np.ix_(freedoms, freedoms)] = young * bending / a**3 * bent * signs
        m[np.ix_(freedoms, freedoms)] = density * area * a / 420.0 * moved * signs
    return k, m


def gained_velocity(stiffness: Any, masses: Any, time: float, steps: int = 200) -> Any:
    """Return the velocities of the first six freedoms after unit impulses of half a sine, by Newmark's method."""
    dt = time / steps
    solve = np.linalg.inv(masses + 0.25 * dt**2 * stiffness)
    moved = velocity = acceleration = np.zeros((len(masses), 6))
    force = np.eye(len(masses))[:, :6]
    for step in range(1, steps + 1):
        level = 0.5 * math.pi / time * math.sin(math.pi * step / steps)
        moved = moved + dt * velocity + 0.25 * dt**2 * acceleration
        velocity = velocity + 0.5 * dt * acceleration
        acceleration = solve @ (level * force - stiffness @ moved)
        moved, velocity = moved + 0.25 * dt**2 * acceleration, velocity + 0.5 * dt * acceleration
    return velocity[:6]
