"""Swing from the top to the ball, impact with the shaft attached, and flight, as one differentiable function."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.core import Tracer
from jax.typing import ArrayLike

import clubface.jax
from clubface.chain.flexible import attached_inputs, flexible_shaft
from clubface.chain.golfer import BY_JOINT, GolferBody
from clubface.chain.mechanics import (
    GRAVITY,
    HeadMotion,
    accelerations,
    head_motion,
    kinetic_energy,
    mechanism_of,
    pose,
    potential_energy,
    torques,
)
from clubface.chain.mjcf import mjcf
from clubface.equipment.attachment import added_inputs
from clubface.equipment.balls import ball as ball_named
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.equipment.shafts import Shaft, shaft as shaft_named
from clubface.errors import InputError, Wording
from clubface.support.checks import check_names

__all__ = ["Motion", "Shot", "Swing"]

BY_STATION = ("bending_stiffness", "torsional_stiffness")
PLACES = ("toe", "high", "ball_forward")
TOWARDS_BALL = 0.5
"""Minimum cosine of the angle between face normal and target at which the face may meet the ball."""
REACHED = 1e-9
"""Tolerance for the position [m] or face angle [rad] at the end of a swing."""


class Motion(NamedTuple):
    """History of a swing; constant after impact.

    Attributes
    ----------
    time
        Time after the start from rest [s], shape (steps,).
    coordinates, rates
        Joint angles from the reference pose [rad] and shaft coordinates, and their rates, shape (steps, n).
    work
        Work of each generator with its stop [J], shape (steps, joints).
    heat
        Heat dissipated in the shaft [J], shape (steps,).
    torque
        Torque of each generator with its stop [N m], shape (steps, joints).
    """

    time: Any
    coordinates: Any
    rates: Any
    work: Any
    heat: Any
    torque: Any


class Shot(NamedTuple):
    """A swing at first touch, with launch and flight.

    Attributes
    ----------
    time
        Time of first touch after the start from rest [s].
    coordinates, rates
        As in :class:`Motion`, shape (n,).
    ball
        Centre of the ball relative to the middle of the hands in the reference pose [m], shape (3,).
    delivery, launch, flight
        Quantities by name [SI], as in :func:`clubface.jax.impact` and :func:`clubface.jax.fly`.
    """

    time: Any
    coordinates: Any
    rates: Any
    ball: Any
    delivery: dict[str, Any]
    launch: dict[str, Any]
    flight: dict[str, Any]


class _State(NamedTuple):
    time: Any
    coordinates: Any
    rates: Any
    work: Any
    heat: Any


class Swing:
    """A golfer with a club, as a function of torques, their timing, and the stiffness of the shaft.

    >>> import jax, jax.numpy as jnp
    >>> from clubface import chain
    >>> swing = chain.Swing("driver", "graphite")
    >>> def carry(onset):
    ...     return swing.shot(onset=onset).flight["carry"]
    >>> slope = jax.grad(carry)(jnp.array(swing.golfer.onset))

    The golfer is assumed to know where the club comes down: the ball lies where the face turns square and meets the
    given point of the face, unless ``ball_forward`` gives its position. Standing elsewhere would not change the swing.

    Parameters
    ----------
    club
        A built-in name, the path of a TOML file, or a :class:`clubface.Club`; right-handed.
    shaft
        A built-in name, the path of a TOML file, or a :class:`clubface.Shaft`; the hands hold its grip.
    golfer
        Default: :meth:`GolferBody.three_segments`, swinging in the plane of the shaft's lie.
    ball
        A built-in name, the path of a TOML file, or a :class:`clubface.Ball`.
    model
        Impact model, as for :func:`clubface.impact`.
    hands
        Distance from the butt to the middle of the hands, where the shaft is clamped [m].
    modes
        Number of shaft coordinates: 0 is rigid; 2 bend it in two planes; 5 also twist it and reproduce bending under
        any force and moment of the head; more add vibrations.
    links
        Number of pieces into which the shaft is divided.
    damping
        Time constant of shaft damping in the hands [s]: elastic forces also act on this multiple of the rates. The
        default is assumed: 5% of critical for bending at 4 Hz, a third for twisting. With a tenth of it, twisting
        still vibrates at impact and determines where the face turns square. More than 7 modes need less damping or
        shorter steps.
    attached
        Whether the shaft, free at the butt except for the grip, adds to the inertia of the head at impact.
    step, duration
        Fixed time step of the fourth-order Runge-Kutta method, and time by which the ball must be reached [s].
    """

    def __init__(
        self,
        club: str | os.PathLike[str] | Club = "driver",
        shaft: str | os.PathLike[str] | Shaft = "graphite",
        golfer: GolferBody | None = None,
        *,
        ball: str | os.PathLike[str] | clubface.Ball | None = None,
        model: str = DEFAULT_MODEL,
        hands: float = 0.12,
        modes: int = 5,
        links: int = 20,
        damping: float = 4e-3,
        attached: bool = True,
        step: float = 5e-4,
        duration: float = 0.4,
    ) -> None:
        if not jax.config.read("jax_enable_x64"):
            raise InputError("precision of JAX", "single", 'double: jax.config.update("jax_enable_x64", True)')
        self.club, self.shaft, self.ball = club_named(club), shaft_named(shaft), ball_named(ball)
        if self.club.hand != 1:
            raise InputError("hand of the club", "left", "right; a left-hander is the mirror image")
        self.golfer = GolferBody.three_segments(lie=self.shaft.lie) if golfer is None else golfer
        self.model, self.hands, self.links, self.attached = model, hands, links, attached
        self.step, self.steps = step, round(duration / step)
        self.flexible = flexible_shaft(self.shaft, self.club, hands, links, modes)
        self.mechanism = mechanism_of(self.golfer, self.club, self.shaft, self.flexible, hands, damping)
        self._attached = added_inputs(self.shaft.added_inertia(self.club))
        self._added = attached_inputs(self.club, self.shaft)
        self._defaults = self.values()
        self._compiled_motion = jax.jit(self._motion)
        self._compiled_end = jax.jit(self._end)
        self._compiled_torques = jax.jit(torques)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of values that may be given: per joint, per station of the shaft, and of the ball."""
        return (*BY_JOINT, *BY_STATION, *PLACES)

    def values(self, **given: ArrayLike) -> dict[str, Array]:
        """Return all values of a swing: the given ones, and those of golfer and shaft."""
        check_names("value of a swing", given, self.names)
        values: dict[str, Any] = {name: getattr(self.golfer, name) for name in BY_JOINT}
        values |= {name: getattr(self.shaft, name) for name in BY_STATION}
        values |= {"toe": 0.0, "high": 0.0}
        shapes = {name: np.shape(value) for name, value in values.items()} | {"ball_forward": ()}
        for name, value in given.items():
            if np.shape(value) != shapes[name]:
                raise InputError(name, Wording(f"of shape {np.shape(value)}"), f"of shape {shapes[name]}")
        return {name: jnp.asarray(value, float) for name, value in (values | given).items()}

    def motion(self, **given: ArrayLike) -> Motion:
        """Return the history of the swing up to first touch; the values are those of :meth:`shot`."""
        return self._compiled_motion(self.values(**given))

    def shot(self, **given: ArrayLike) -> Shot:
        """Compute the swing up to first touch, the launch of the ball, and its flight.

        Parameters
        ----------
        **given
            Values of the golfer per joint (``start``, ``onset``, ``rise_time``, ``maximum_torque``,
            ``maximum_speed``), of the shaft per station (``bending_stiffness``, ``torsional_stiffness``), and of the
            ball: ``toe`` and ``high``, the impact point on the face [m], and ``ball_forward``, the position of its
            centre ahead of the middle of the hands in the reference pose [m]; default: where the face turns square.

        Raises
        ------
        InputError
            The club does not reach the ball in time. Within a function compiled by JAX, results that depend on the shot
            are NaN or raise an error of JAX instead.
        """
        values = self.values(**given)
        end, missed, delivery, place = self._compiled_end(values)
        if not isinstance(missed, Tracer) and missed:
            allowed = "torques and timing that bring the face to the ball, or a longer duration"
            raise InputError("swing", Wording(f"without impact in {self.step * self.steps:g} s"), allowed)
        added = self._attached if not set(BY_STATION) & set(given) else self._added(*(values[n] for n in BY_STATION))
        launch = clubface.jax.impact(
            self.club, {**delivery, **(added if self.attached else {})}, model=self.model, ball=self.ball
        )  # fmt: skip
        flight = clubface.jax.fly(launch, ball=self.ball)
        return Shot(end.time, end.coordinates, end.rates, place, delivery, launch, flight)

    def mjcf(self, *, links: int | None = None) -> str:
        """Return the golfer and club as MuJoCo XML, with a joint for each segment and springs along the shaft.

        In the reference pose all angles are 0 and all bodies have world axes. The body "head" has its origin at the CG
        of the head, and the head's axes. ``links`` is the number of shaft pieces that bend and twist; 0 is a rigid
        shaft. Default: as in the swing, or 0 if the swing has no modes.
        """
        if links is None:
            links = self.links if self.mechanism.size > self.mechanism.joints else 0
        damping = self.mechanism.damping
        return mjcf(self.golfer, self.club, self.shaft, hands=self.hands, damping=damping, links=links)

    def torques(self, time: ArrayLike, angles: ArrayLike, speeds: ArrayLike, **given: ArrayLike) -> Array:
        """Return the torques of generators and stops [N m] at time [s], joint angles [rad] and speeds [rad/s]."""
        return self._compiled_torques(time, angles, speeds, self.values(**given) if given else self._defaults)

    def head(self, coordinates: ArrayLike, rates: ArrayLike) -> HeadMotion:
        """Return pose and motion of the head for coordinates and rates as in :class:`Shot`."""
        return head_motion(self.mechanism, coordinates, rates)

    def energy(self, coordinates: ArrayLike, rates: ArrayLike, **given: ArrayLike) -> tuple[Array, Array]:
        """Return kinetic energy, and potential energy of gravity and shaft relative to the reference pose [J]."""
        potential = potential_energy(self.mechanism, coordinates, self._stiffness(self.values(**given)))
        return kinetic_energy(self.mechanism, coordinates, rates), potential

    def _stiffness(self, values: dict[str, Any]) -> Any:
        bending = jnp.einsum("s,sij->ij", values["bending_stiffness"], self.flexible.bending)
        return bending + jnp.einsum("s,sij->ij", values["torsional_stiffness"], self.flexible.torsion)

    def _start(self, values: dict[str, Any], stiffness: Any) -> _State:
        """Return the state of rest at the top, with the shaft in equilibrium under gravity."""
        joints, size = self.mechanism.joints, self.mechanism.size
        start = values["start"]

        def weight(bend: Any) -> Any:
            place, _ = pose(self.mechanism, jnp.concatenate([start, bend]))
            return GRAVITY * self.mechanism.mass @ place[:, 1]

        none = jnp.zeros(size - joints)
        bend = none if size == joints else -jnp.linalg.solve(stiffness, jax.grad(weight)(none))
        return _State(jnp.zeros(()), jnp.concatenate([start, bend]), jnp.zeros(size), jnp.zeros(joints), jnp.zeros(()))

    def _torques(self, values: dict[str, Any], state: _State) -> Any:
        joints = self.mechanism.joints
        return torques(state.time, state.coordinates[:joints], state.rates[:joints], values)

    def _rates(self, values: dict[str, Any], stiffness: Any, state: _State) -> _State:
        joints, damping = self.mechanism.joints, self.mechanism.damping
        driven = self._torques(values, state)
        bend, bending = state.coordinates[joints:], state.rates[joints:]
        lost = damping * stiffness @ bending
        forces = jnp.concatenate([driven, -stiffness @ bend - lost])
        change = accelerations(self.mechanism, state.coordinates, state.rates, forces)
        return _State(jnp.ones(()), state.rates, change, driven * state.rates[:joints], lost @ bending)

    def _advance(self, values: dict[str, Any], stiffness: Any, state: _State, step: Any) -> _State:
        """Advance the state by one classical Runge-Kutta step; a loop over the four stages keeps compilation short."""

        def stage(carry: tuple[_State, _State], each: Any) -> tuple[tuple[_State, _State], None]:
            slope, total = carry
            at, weight = each
            slope = self._rates(values, stiffness, jax.tree.map(lambda x, k: x + at * step * k, state, slope))
            return (slope, jax.tree.map(lambda x, k: x + weight * step * k, total, slope)), None

        none = jax.tree.map(jnp.zeros_like, state)
        stages = jnp.array([0.0, 0.5, 0.5, 1.0]), jnp.array([1.0, 2.0, 2.0, 1.0]) / 6.0
        return jax.lax.scan(stage, (none, state), stages)[0][1]

    def _to_ball(self, values: dict[str, Any]) -> Any:
        """Return the vector from the head's CG to the ball at first touch, in the head's axes [m]."""
        at = {"toe": values["toe"], "high": values["high"]}
        return -clubface.jax.pose(at, self.club, ball=self.ball).position

    def _gap(self, values: dict[str, Any], to_ball: Any, coordinates: Any, rates: Any) -> tuple[Any, Any, Any, Any]:
        """Return the gap (0 at first touch, negative before), whether the face may meet the ball, ball, and head."""
        head = head_motion(self.mechanism, coordinates, rates)
        place = head.position + head.rotation @ to_ball
        loft = self.club.loft
        normal = head.rotation @ np.array([np.cos(loft), np.sin(loft), 0.0])
        gap = place[0] - values["ball_forward"] if "ball_forward" in values else -normal[2]
        return gap, normal[0] > TOWARDS_BALL, place, head

    def _next(self, values: dict[str, Any], to_ball: Any, stiffness: Any, state: _State) -> _State:
        """Return the state one step later, or at first touch, to which Newton steps converge."""

        def gap(coordinates: Any) -> tuple[Any, Any]:
            result, near, _, _ = self._gap(values, to_ball, coordinates, state.rates)
            return result, near

        (distance, near), (approach, _) = jax.jvp(gap, (state.coordinates,), (state.rates,))
        ends = near & (approach > 0.0)
        remaining = -distance / jnp.where(ends, approach, 1.0)
        step = jnp.where(ends, jnp.clip(remaining, -self.step, self.step), self.step)
        return self._advance(values, stiffness, state, step)

    def _run(self, values: dict[str, Any]) -> tuple[_State, _State]:
        stiffness = self._stiffness(values)
        start, to_ball = self._start(values, stiffness), self._to_ball(values)

        def advance(state: _State, _: Any) -> tuple[_State, _State]:
            return self._next(values, to_ball, stiffness, state), state

        return jax.lax.scan(jax.checkpoint(advance), start, length=self.steps)

    def _motion(self, values: dict[str, Any]) -> Motion:
        _, states = self._run(values)
        return Motion(*states, jax.vmap(lambda each: self._torques(values, each))(states))

    def _end(self, values: dict[str, Any]) -> tuple[_State, Any, dict[str, Any], Any]:
        end, _ = self._run(values)
        gap, near, place, head = self._gap(values, self._to_ball(values), end.coordinates, end.rates)
        missed = ~near | (jnp.abs(gap) > REACHED)
        delivery = clubface.jax.delivery_from_pose(*head, club=self.club, ball=self.ball, ball_position=place)
        return end, missed, {**delivery, "toe": values["toe"], "high": values["high"]}, place
