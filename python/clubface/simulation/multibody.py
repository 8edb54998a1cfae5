"""Impact in multibody programs: contact forces from the motion of the bodies, or a ball moved through the contact.

World axes: x to the target, y up, z to the right of the target line, also for a left-hander. Head axes coincide with
world axes while the club stands at its static loft with a square face, as for :meth:`clubface.Delivery.from_pose`.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

import numpy as np

from clubface import _core as core, units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Wording
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import HandLike, prepare
from clubface.simulation.pose import rotation_rows
from clubface.simulation.results import outputs
from clubface.support.arrays import Floats, NumberOrArray

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from clubface.simulation.pose import Pose

    PoseLike: TypeAlias = Pose | tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike]
    BallMotionLike: TypeAlias = "BallMotion | tuple[ArrayLike, ArrayLike, ArrayLike]"

DEFAULT_MODEL = "volumetric"
"""Default contact model."""
SPEED = 1.0
"""Clubhead speed [m/s]; the inputs require one, but nothing here depends on it."""
PHASES = ("waiting", "contact", "launched")


class BallMotion(NamedTuple):
    """Position and motion of a ball in world axes.

    Attributes
    ----------
    position, velocity
        Position [m] and velocity [m/s] of the centre, shape (3,).
    angular_velocity
        Angular velocity [rad/s], shape (3,); of a layered ball, its total angular momentum over its inertia.
    """

    position: Any
    velocity: Any = (0.0, 0.0, 0.0)
    angular_velocity: Any = (0.0, 0.0, 0.0)


class Wrench(NamedTuple):
    """Force and moments between head and ball at one instant, in world axes; vectors have shape (3,).

    Attributes
    ----------
    force
        Force on the ball [N]; the opposite force acts on the head.
    ball_torque, head_torque
        Moments on the ball about its centre, and on the head about its CG [N m].
    point
        Point of application of the force [m].
    normal_force
        Normal force [N].
    penetration, penetration_rate
        Penetration of ball and face [m], negative when they are apart and no force acts, and its rate [m/s].
    """

    force: Floats
    ball_torque: Floats
    head_torque: Floats
    point: Floats
    normal_force: NumberOrArray
    penetration: NumberOrArray
    penetration_rate: NumberOrArray

    @classmethod
    def from_values(cls, v: Floats) -> Wrench:
        """Build a wrench from the 15 numbers of the core, or from their derivatives along further axes."""
        return cls(v[0:3], v[3:6], v[6:9], v[9:12], v[12], v[13], v[14])


class StepLoads(NamedTuple):
    """Mean loads over one step of a struck ball, in world axes.

    Attributes
    ----------
    force
        Mean force on the head [N], shape (3,); the opposite force acts on the ball.
    torque
        Mean torque on the head about its CG [N m], shape (3,).
    normal_force, penetration
        Normal force [N] and penetration [m] at the end of the step, the latter negative when apart.
    """

    force: Floats
    torque: Floats
    normal_force: float
    penetration: float


class WrenchDerivatives(NamedTuple):
    """Derivatives of a wrench and of the rates of the internal states.

    Attributes
    ----------
    wrench, rates
        The wrench, and the rates of the internal states [unit of the state per s], shape (internal states,).
    wrench_derivatives
        A :class:`Wrench` whose values have one more axis, the last: the 21 coordinates of motion, then the internal
        states. The coordinates are position, small rotation about the world axes [rad], velocity and angular velocity
        of the head, and position, velocity and angular velocity of the ball.
    rate_derivatives
        Derivatives of the rates, shape (internal states, 21 + internal states).
    """

    wrench: Wrench
    rates: Floats
    wrench_derivatives: Wrench
    rate_derivatives: Floats


class SteppedContact:
    """A contact for the integrator of another program: state of head and ball in, forces out.

    A contact law has internal states besides the motion of the bodies: twist and spin of the core of a layered ball,
    sliding distance, displacement of a flexible face. The caller integrates them with the bodies: ``initial`` holds
    their values at first touch, and :meth:`evaluate` returns their rates. The rings of the model ``rings`` also depend
    on the last step; call :meth:`commit` after every accepted step. :func:`clubface.impact` is this contact with an
    integrator of its own.

    Parameters
    ----------
    head
        Pose and motion of the head at first touch: a :class:`clubface.simulation.pose.Pose` from
        :meth:`clubface.Delivery.pose`, or (rotation, position, velocity, angular velocity) with the rotation as a
        matrix or a quaternion, real part first. Position and velocity are those of the CG.
    ball_motion
        A :class:`BallMotion`.
    club, ball, model, parameters, hand
        As for :func:`clubface.impact`; the model must follow the contact in time.

    Attributes
    ----------
    names
        Names of the internal states. Components refer to face axes: x along the normal at the face centre, y up, z
        towards the toe.
    initial
        Internal states at first touch [SI], shape (internal states,).

    Raises
    ------
    InputError
        A vector or a rotation has the wrong shape, or a value is not a number.
    ShotError
        The model has no contact law, a value of club, ball or parameters is out of range, a matrix is not a rotation, a
        number is not finite, or the face moves away from the ball.
    """

    def __init__(
        self,
        head: PoseLike,
        ball_motion: BallMotionLike,
        *,
        club: str | os.PathLike[str] | Club,
        ball: str | os.PathLike[str] | Ball | None = None,
        model: str = DEFAULT_MODEL,
        parameters: Parameters | None = None,
        hand: HandLike | None = None,
    ) -> None:
        given, self._error = _prepare_shot(model, club, ball, parameters, hand)
        self._held = _call(core.ContactHandle, self._error, *given, head_values(head), ball_values(ball_motion))
        self.names = tuple(self._held.names)
        self.initial = self._held.initial

    def _call(self, computation: Callable[..., Any], head: Any, ball_motion: Any, internal: ArrayLike) -> Floats:
        states = _array(internal, "internal", units.DIMENSIONLESS).tolist()
        return _call(computation, self._error, head_values(head), ball_values(ball_motion), states)

    def evaluate(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> tuple[Wrench, Floats]:
        """Return the wrench, and the rates of the internal states [SI], shape (internal states,).

        The result depends on the arguments only, which have the same form as at first touch.
        """
        wrench, rates = self._call(self._held.evaluate, head, ball_motion, internal)
        return Wrench.from_values(wrench), rates

    def jacobian(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> WrenchDerivatives:
        """Return the wrench and the rates of the internal states with their exact derivatives."""
        rows = self._call(self._held.jacobian, head, ball_motion, internal)
        wrench, rates = rows[:15], rows[15:]
        return WrenchDerivatives(
            Wrench.from_values(wrench[:, 0]), rates[:, 0], Wrench.from_values(wrench[:, 1:]), rates[:, 1:]
        )

    def commit(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> Floats:
        """Accept a step: update the memory of the contact law and return the internal states."""
        return self._call(self._held.commit, head, ball_motion, internal)


class StruckBall:
    """A ball moved from rest through the contact into flight while another program moves the head.

    For programs with time steps of their own. Within a step the head moves on with its velocities and reacts to the
    ball with its own inertia, and with that of its mechanism if the club has one (:meth:`clubface.Club.on_mechanism`,
    :meth:`clubface.Club.on_shaft`). The program applies the mean force and torque to its head over the step, so that
    momentum is conserved and the step length is limited only by the other loads on the head.

    Parameters
    ----------
    club, ball, model, parameters, hand
        As for :class:`SteppedContact`.
    position, velocity, angular_velocity
        Initial position and motion of the ball [m, m/s, rad/s], shape (3,).
    head_gives_way
        False for a head with prescribed motion, which does not react to the ball.

    Raises
    ------
    InputError, ShotError
        As for :class:`SteppedContact`.
    """

    def __init__(
        self,
        *,
        club: str | os.PathLike[str] | Club,
        ball: str | os.PathLike[str] | Ball | None = None,
        model: str = DEFAULT_MODEL,
        parameters: Parameters | None = None,
        hand: HandLike | None = None,
        position: ArrayLike = (0.0, 0.0, 0.0),
        velocity: ArrayLike = (0.0, 0.0, 0.0),
        angular_velocity: ArrayLike = (0.0, 0.0, 0.0),
        head_gives_way: bool = True,
    ) -> None:
        given, self._error = _prepare_shot(model, club, ball, parameters, hand)
        start = ball_values(BallMotion(position, velocity, angular_velocity))
        self._held = _call(core.BallHandle, self._error, *given, start, bool(head_gives_way))

    def advance(self, head: PoseLike, duration: float | str) -> StepLoads:
        """Advance the ball by a duration [s], at most 0.1 s, with the head starting from the given state."""
        step = float(units.parse(duration, "time", name="duration"))
        v = _call(self._held.advance, self._error, head_values(head), step)
        return StepLoads(v[0:3], v[3:6], float(v[6]), float(v[7]))

    @property
    def motion(self) -> BallMotion:
        """Position and motion of the ball."""
        v = self._held.motion
        return BallMotion(v[0:3], v[3:6], v[6:9])

    @property
    def phase(self) -> Literal["waiting", "contact", "launched"]:
        """Phase of the ball: "waiting" before the contact, "contact", or "launched"."""
        return PHASES[self._held.phase]

    @property
    def launch(self) -> dict[str, float] | None:
        """Outputs of the impact by name [SI], as for :class:`Launch`, or None until the ball has left the face."""
        values = self._held.launch
        return None if values is None else dict(zip(outputs(), values, strict=True))


def _prepare_shot(
    model: str, club: Any, ball: Any, parameters: Any, hand: Any
) -> tuple[tuple[str, list[float], list[float]], Callable[[ValueError], Exception]]:
    """Return model, inputs and parameters for the core, and the function that translates its errors."""
    shot = prepare(model, club, {"speed": SPEED}, ball, parameters, hand, single="a stepped contact")
    return (model, shot.shots.columns, shot.parameters), shot.error


def _call(computation: Callable[..., Any], translated: Callable[[ValueError], Exception], *given: Any) -> Any:
    """Call the core and translate its errors."""
    try:
        return computation(*given)
    except ValueError as error:
        raise translated(error) from None


def head_values(head: PoseLike) -> list[float]:
    """Return the 18 numbers of a head for the core: rotation row by row, position, velocity, angular velocity."""
    rotation, position, velocity, angular_velocity = head
    turn = _array(rotation, "rotation", units.DIMENSIONLESS)
    if turn.shape == (4,):
        if not turn.any():
            raise InputError("rotation", Wording("a quaternion of length 0"), "one of any other length")
        turn = np.array(rotation_rows(turn))
    if turn.shape != (3, 3):
        raise InputError("rotation", Wording(f"of shape {turn.shape}"), "of shape (3, 3), or a quaternion")
    return [*turn.ravel().tolist(), *_body(position, velocity, angular_velocity)]


def ball_values(motion: BallMotion | Any) -> list[float]:
    """Return the 9 numbers of a ball for the core: position, velocity, angular velocity."""
    return _body(*BallMotion(*motion))


def _body(position: Any, velocity: Any, angular_velocity: Any) -> list[float]:
    numbers: list[float] = []
    for name, dimension, given in (("position", "length", position), ("velocity", "speed", velocity),
                                   ("angular_velocity", "angular rate", angular_velocity)):  # fmt: skip
        value = _array(given, name, dimension)
        if value.shape != (3,):
            raise InputError(name, Wording(f"of shape {value.shape}"), "of shape (3,)")
        numbers += value.tolist()
    return numbers


def _array(value: Any, name: str, dimension: str) -> NDArray[Any]:
    if isinstance(value, np.ndarray) and value.dtype == np.float64:
        return value
    return np.asarray(units.parse_values(value, dimension, name=name))
