"""Equations of motion, in JAX, of a chain of hinged segments with a club on a flexible shaft.

The coordinates are the hinge angles and those of the shaft. Velocities of all bodies are linear in their rates;
accelerations follow by differentiation, and Kane's equations (T. R. Kane and D. A. Levinson, Dynamics: Theory and
Applications, 1985) sum forces and inertia over the bodies. Nothing is linearised.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from clubface.chain.flexible import FlexibleShaft, links_of
from clubface.chain.golfer import GolferBody, combined
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft

__all__ = [
    "HeadMotion", "Mechanism", "accelerations", "head_motion", "kinetic_energy", "mass_matrix", "mechanism_of", "pose",
    "potential_energy", "torques",
]  # fmt: skip

GRAVITY = 9.81
ECCENTRIC = 1.5
"""Maximum torque of a generator driven backwards, relative to its torque without motion (A. J. van Soest and M. F.
Bobbert, Biological Cybernetics 69, 195-204, 1993)."""
CURVATURE = 3.0
"""Curvature of the torque-speed relation (Sprigings and Neal, 2000)."""
ONSET_SHARPNESS = 4.0
"""Rise time over the duration of a generator's onset: sharp enough for muscles, yet smooth."""
STOP_STIFFNESS, STOP_DAMPING, STOP_WIDTH = 800.0, 4.0, 0.01
"""Stiffness and damping of a joint's stop at its start angle [N m/rad, N m s/rad], and the width of its onset [rad]."""


class Mechanism(NamedTuple):
    """A chain of rigid bodies from the ground to the head, each following the hinge or bend that moves it.

    Vectors are in world axes in the reference pose, with the origin in the middle of the hands. The held piece of shaft
    belongs to the body of the last hinge, and the head to the last link of the shaft.
    """

    names: tuple[str, ...]  # of the bodies
    axis: Any  # of the hinges, shape (joints, 3)
    turn: Any  # rotation at each bend per unit of each shaft coordinate [rad], shape (links, 3, modes)
    joint: Any  # positions of hinges and bends [m], shape (bodies, 3)
    mass: Any  # [kg], shape (bodies,)
    cg: Any  # [m], shape (bodies, 3)
    inertia: Any  # about the CG [kg m2], shape (bodies, 3, 3)
    head: Any  # CG of the head alone [m], shape (3,)
    damping: float  # time constant of shaft damping [s]: elastic forces also act on this multiple of the rates

    @property
    def joints(self) -> int:
        """Number of hinges."""
        return len(self.axis)

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return self.joints + self.turn.shape[-1]


def mechanism_of(
    golfer: GolferBody, club: Club, shaft: Shaft, flexible: FlexibleShaft, hands: float, damping: float
) -> Mechanism:
    """Build the mechanism of a golfer and a club."""
    links = flexible.turn.shape[1]
    pieces = links_of(shaft, hands, links)
    down = -np.array(shaft.axis)
    head = (shaft.length - hands) * down - np.array(shaft.hosel) - np.array(club.cg)
    *others, last = pieces.bodies
    *segments, hand = ((each.mass, each.cg, each.inertia) for each in golfer.segments)
    last = combined(last, (club.mass, head, np.array(club.inertia)))
    bodies = [*segments, combined(hand, pieces.grip), *others, last]
    mass, cg, inertia = (np.array(each) for each in zip(*bodies, strict=True))
    names = (*(each.name for each in golfer.segments), *(f"shaft{link}" for link in range(links - 1)), "head")
    joint = np.concatenate([[each.joint for each in golfer.segments], np.outer(pieces.joint, down)])
    axis = np.array([each.axis for each in golfer.segments])
    return Mechanism(names, axis, flexible.turn.transpose(1, 2, 0), joint, mass, cg, inertia, head, damping)


LEVI_CIVITA = np.array([[np.cross(one, other) for other in np.eye(3)] for one in np.eye(3)]).transpose(2, 0, 1)


class _Frames(NamedTuple):
    """Rotations of the bodies, and for each joint the terms that relate its rates to angular velocity."""

    rotation: Any
    cross: Any
    second: Any
    third: Any


def _frames(mechanism: Mechanism, coordinates: Any) -> _Frames:
    angle = coordinates[: mechanism.joints]
    bend = jnp.einsum("lim,m->li", mechanism.turn, coordinates[mechanism.joints :])
    # For bends of a few degrees, series of sin(a) / a, (1 - cos(a)) / a^2 and (a - sin(a)) / a^3 are exact to rounding.
    square = jnp.sum(bend * bend, -1)
    first = 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0))
    second = 0.5 - square / 24.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0))
    third = 1.0 / 6.0 - square / 120.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))
    cross = jnp.einsum("ijk,nj->nik", LEVI_CIVITA, jnp.concatenate([jnp.asarray(mechanism.axis), bend]))
    sine = jnp.concatenate([jnp.sin(angle), first])[:, None, None]
    versine = jnp.concatenate([1.0 - jnp.cos(angle), second])[:, None, None]
    own = jnp.eye(3) + sine * cross + versine * (cross @ cross)
    # A hinge's angular velocity about its own axis is its rate, whatever its angle.
    none = jnp.zeros_like(angle)

    # A loop compiles in half the time of a tree of products.
    def onward(before: Any, each: Any) -> tuple[Any, Any]:
        turned = before @ each
        return turned, turned

    _, rotation = jax.lax.scan(onward, jnp.eye(3), own)
    return _Frames(rotation, cross, jnp.concatenate([none, second]), jnp.concatenate([none, third]))


def _moved_bodies(mechanism: Mechanism) -> Any:
    """Return which bodies (rows) each joint (columns) moves."""
    return np.tril(np.ones((len(mechanism.mass),) * 2))


def pose(mechanism: Mechanism, coordinates: Any) -> tuple[Any, Any]:
    """Return positions of the CGs [m], shape (bodies, 3), and rotations of the bodies, shape (bodies, 3, 3)."""
    rotation = _frames(mechanism, coordinates).rotation
    joint = _joints(mechanism, rotation)
    return joint + jnp.einsum("bij,bj->bi", rotation, mechanism.cg - mechanism.joint), rotation


def _joints(mechanism: Mechanism, rotation: Any) -> Any:
    """Return the positions of hinges and bends [m], shape (bodies, 3)."""
    step = jnp.einsum("bij,bj->bi", rotation[:-1], np.diff(mechanism.joint, axis=0))
    onward = jnp.asarray(_moved_bodies(mechanism)[:-1, :-1] @ step)
    return jnp.concatenate([jnp.asarray(mechanism.joint[:1]), mechanism.joint[:1] + onward])


class HeadMotion(NamedTuple):
    """Rotation of the head, position of its CG relative to the hands in the reference pose, and their rates."""

    rotation: Any
    position: Any
    velocity: Any
    angular_velocity: Any


def head_motion(mechanism: Mechanism, coordinates: Any, rates: Any) -> HeadMotion:
    """Return pose and motion of the head in world axes [m, m/s, rad/s]."""
    rotation = _frames(mechanism, coordinates).rotation
    position = _joints(mechanism, rotation)[-1] + rotation[-1] @ (mechanism.head - mechanism.joint[-1])
    linear, spin = _velocities(mechanism, coordinates, rates)
    lever = mechanism.head - mechanism.cg[-1]
    return HeadMotion(
        rotation[-1], position, linear[-1] + rotation[-1] @ jnp.cross(spin[-1], lever), rotation[-1] @ spin[-1]
    )


def _velocities(mechanism: Mechanism, coordinates: Any, rates: Any) -> tuple[Any, Any]:
    """Return velocities of the CGs, and angular velocities in body axes, shape (bodies, 3)."""
    rotation, cross, second, third = _frames(mechanism, coordinates)
    joints = mechanism.joints
    own = jnp.concatenate([
        jnp.asarray(mechanism.axis) * rates[:joints, None],
        jnp.einsum("lim,m->li", mechanism.turn, rates[joints:]),
    ])  # fmt: skip
    once = jnp.einsum("bij,bj->bi", cross, own)
    twice = jnp.einsum("bij,bj->bi", cross, once)
    own = own + second[:, None] * once + third[:, None] * twice
    before = jnp.concatenate([jnp.eye(3)[None], rotation[:-1]])
    reached = _moved_bodies(mechanism)
    spin = jnp.einsum("bij,bi->bj", rotation, reached @ jnp.einsum("bij,bj->bi", before, own))
    onward = jnp.cross(spin[:-1], np.diff(mechanism.joint, axis=0))
    onward = reached[:-1, :-1] @ jnp.einsum("bij,bj->bi", rotation[:-1], onward)
    around = jnp.einsum("bij,bj->bi", rotation, jnp.cross(spin, mechanism.cg - mechanism.joint))
    return jnp.concatenate([around[:1], onward + around[1:]]), spin


def _weighted(mechanism: Mechanism, coordinates: Any, rates: Any) -> tuple[Any, Any]:
    """Return velocities weighted by roots of the inertias, whose sum of squares is twice the energy, and spins."""
    linear, spin = _velocities(mechanism, coordinates, rates)
    root = np.sqrt(mechanism.mass)[:, None]
    return jnp.concatenate([root * linear, jnp.einsum("bij,bi->bj", _roots(mechanism), spin)], -1).ravel(), spin


def _roots(mechanism: Mechanism) -> Any:
    """Return Cholesky factors of the inertias, shape (bodies, 3, 3)."""
    return np.linalg.cholesky(mechanism.inertia)


def _jacobian(mechanism: Mechanism, coordinates: Any) -> Any:
    """Return the weighted velocities per unit of each rate, shape (rates, 6 bodies)."""
    return jax.vmap(lambda each: _weighted(mechanism, coordinates, each)[0])(jnp.eye(mechanism.size))


def mass_matrix(mechanism: Mechanism, coordinates: Any) -> Any:
    """Return the mass matrix of the coordinates, shape (n, n)."""
    jacobian = _jacobian(mechanism, coordinates)
    return jacobian @ jacobian.T


def accelerations(mechanism: Mechanism, coordinates: Any, rates: Any, forces: Any) -> Any:
    """Return the accelerations of the coordinates under generalised forces and gravity, shape (n,)."""
    (_, spin), (bias, _) = jax.jvp(lambda each: _weighted(mechanism, each, rates), (coordinates,), (rates,))
    jacobian = _jacobian(mechanism, coordinates)
    inverse = np.linalg.inv(_roots(mechanism))
    turning = jnp.cross(spin, jnp.einsum("bij,bj->bi", mechanism.inertia, spin))
    held = np.sqrt(mechanism.mass)[:, None] * np.array([0.0, GRAVITY, 0.0])
    outer = jnp.concatenate([jnp.asarray(held), jnp.einsum("bij,bj->bi", inverse, turning)], -1).ravel()
    return jax.scipy.linalg.solve(jacobian @ jacobian.T, forces - jacobian @ (bias + outer), assume_a="pos")


def kinetic_energy(mechanism: Mechanism, coordinates: Any, rates: Any) -> Any:
    """Return the kinetic energy [J]."""
    weighted, _ = _weighted(mechanism, coordinates, rates)
    return 0.5 * weighted @ weighted


def potential_energy(mechanism: Mechanism, coordinates: Any, stiffness: Any) -> Any:
    """Return the potential energy of gravity, relative to the reference pose, and of the shaft [J]."""
    place, _ = pose(mechanism, coordinates)
    bending = coordinates[mechanism.joints :]
    return GRAVITY * mechanism.mass @ (place[:, 1] - mechanism.cg[:, 1]) + 0.5 * bending @ stiffness @ bending


def activation(time: Any, onset: Any, rise_time: Any) -> Any:
    """Return the activation of the generators, 0 to 1: an exponential rise after a smooth onset."""
    since = ONSET_SHARPNESS * (time - onset) / rise_time
    return -jnp.expm1(-jax.nn.softplus(since) / ONSET_SHARPNESS)


def share_of_speed(speed: Any, maximum: Any) -> Any:
    """Return the torque at a speed relative to that without motion, by Hill's relation, smooth at 0.

    A generator driven backwards has up to ``ECCENTRIC``; above its maximum speed it has no torque.
    """
    slope = (1.0 + CURVATURE) / maximum
    forward = jnp.maximum(speed, 0.0)
    back = jnp.maximum(-speed, 0.0)
    shortening = jnp.maximum(maximum - forward, 0.0) / (maximum + CURVATURE * forward)
    lengthening = ECCENTRIC - (ECCENTRIC - 1.0) / (1.0 + slope * back / (ECCENTRIC - 1.0))
    return jnp.where(speed < 0.0, lengthening, shortening)


def torques(time: Any, angles: Any, speeds: Any, muscles: Any) -> Any:
    """Return the torques of generators and stops at the joints [N m], shape (joints,)."""
    active = activation(time, muscles["onset"], muscles["rise_time"])
    driven = muscles["maximum_torque"] * active * share_of_speed(speeds, muscles["maximum_speed"])
    behind = (muscles["start"] - angles) / STOP_WIDTH
    stopped = STOP_STIFFNESS * STOP_WIDTH * jax.nn.softplus(behind) - STOP_DAMPING * jax.nn.sigmoid(behind) * speeds
    return driven + stopped
