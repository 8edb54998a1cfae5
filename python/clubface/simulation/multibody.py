"""Impact in a program that moves the bodies: forces from motion, or a ball that is moved through the contact.

World axes: x to the target, y up, z to the right of the target line, also for a left-hander. The axes of a head are
those of the world while the club stands at its static loft with a square face, as for
:meth:`clubface.Delivery.from_pose`.
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

__all__ = ["BallMotion", "StepLoads", "SteppedContact", "StruckBall", "Wrench"]

DEFAULT_MODEL = "volumetric"
"""The contact model that is taken where none is named."""
SPEED = 1.0
"""A clubhead speed [m/s], which inputs must have and nothing here depends on."""
PHASES = ("waiting", "contact", "launched")


class BallMotion(NamedTuple):
    """Where a ball is and how it moves, world axes.

    Attributes
    ----------
    position
        Of its centre [m], shape (3,).
    velocity
        [m/s], shape (3,).
    angular_velocity
        [rad/s], shape (3,): all its angular momentum over its inertia, if its cover turns on its core.
    """

    position: Any
    velocity: Any = (0.0, 0.0, 0.0)
    angular_velocity: Any = (0.0, 0.0, 0.0)


class Wrench(NamedTuple):
    """What acts between head and ball at one instant, world axes; vectors have the shape (3,).

    Attributes
    ----------
    force
        On the ball [N]; its opposite acts on the head.
    ball_torque
        On the ball about its centre [N m].
    head_torque
        On the head about its CG [N m].
    point
        At which the force acts [m].
    normal_force
        [N].
    penetration
        [m], negative when apart; nothing acts then.
    penetration_rate
        [m/s].
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
        """Return the wrench of the 15 numbers of the core, or of their derivatives along further axes."""
        return cls(v[0:3], v[3:6], v[6:9], v[9:12], v[12], v[13], v[14])


class StepLoads(NamedTuple):
    """What acts over one step of a struck ball, world axes.

    Attributes
    ----------
    force
        Mean force on the head [N], shape (3,); its opposite acts on the ball.
    torque
        Mean torque on the head about its CG [N m], shape (3,).
    normal_force
        At the end of the step [N].
    penetration
        At the end of the step [m], negative when apart.
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
        Their values; the rates [1/s of each state], shape (internal states,).
    wrench_derivatives
        A :class:`Wrench` whose values have a last axis more: the 21 numbers of motion and the internal states. Motion
        is position, small turn about the axes of the world [rad], velocity and angular velocity of the head, and
        position, velocity and angular velocity of the ball.
    rate_derivatives
        Shape (internal states, 21 + internal states).
    """

    wrench: Wrench
    rates: Floats
    wrench_derivatives: Wrench
    rate_derivatives: Floats


class SteppedContact:
    """A contact that the integrator of another program steps through: state of head and ball in, forces out.

    The law of a contact has states besides the motion of the bodies: twist and spin of the core of a layered ball, the
    distance slid, a face that gives. They are the caller's to integrate with the bodies: ``initial`` are their values
    at first touch, and :meth:`evaluate` returns their rates. The rings of the model ``rings`` also remember the last
    step; call :meth:`commit` after every step that is accepted. :func:`clubface.impact` is this contact with an
    integrator of its own.

    Parameters
    ----------
    head
        Pose and motion of the head at first touch: a :class:`clubface.simulation.pose.Pose`, as of
        :meth:`clubface.Delivery.pose`, or (rotation, position, velocity, angular velocity), the rotation as a matrix or
        a quaternion, real part first, all of the CG.
    ball_motion
        A :class:`BallMotion`.
    club, ball, model, parameters, hand
        As for :func:`clubface.impact`; the model must be one that follows the contact in time.

    Attributes
    ----------
    names
        Of the internal states. States with an axis are in those of the face: x along its normal at the centre, y up, z
        towards the toe.
    initial
        The internal states at first touch [SI], shape (internal states,).

    Raises
    ------
    InputError
        A vector or a rotation of another shape, or no number.
    ShotError
        A model without a contact, a club, ball or parameter that cannot be, a matrix that is no rotation, numbers that
        are not finite, or a face that moves away from the ball.
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
        given, self._error = _prepared(model, club, ball, parameters, hand)
        self._held = _call(core.ContactHandle, self._error, *given, head_values(head), ball_values(ball_motion))
        self.names = tuple(self._held.names)
        self.initial = self._held.initial

    def _call(self, computation: Callable[..., Any], head: Any, ball_motion: Any, internal: ArrayLike) -> Floats:
        states = _array(internal, "internal", units.DIMENSIONLESS).tolist()
        return _call(computation, self._error, head_values(head), ball_values(ball_motion), states)

    def evaluate(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> tuple[Wrench, Floats]:
        """Return what acts now, and the rates of the internal states [SI], shape (internal states,).

        A function of the arguments alone: head, ball and states as at the beginning, at any other instant.
        """
        wrench, rates = self._call(self._held.evaluate, head, ball_motion, internal)
        return Wrench.from_values(wrench), rates

    def jacobian(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> WrenchDerivatives:
        """Return what acts and the rates of the internal states with their exact derivatives."""
        rows = self._call(self._held.jacobian, head, ball_motion, internal)
        wrench, rates = rows[:15], rows[15:]
        return WrenchDerivatives(
            Wrench.from_values(wrench[:, 0]), rates[:, 0], Wrench.from_values(wrench[:, 1:]), rates[:, 1:]
        )

    def commit(self, head: PoseLike, ball_motion: BallMotionLike, internal: ArrayLike) -> Floats:
        """Return the internal states with what the law remembers brought up to date: a step ends here."""
        return self._call(self._held.commit, head, ball_motion, internal)


class StruckBall:
    """A ball that is moved from rest through the contact into flight while another program moves the head.

    For programs with steps of their own. Within a step the head goes on as it came and gives way to the ball by its own
    inertia, and by that of its mechanism if the club has one (:meth:`clubface.Club.on_mechanism`,
    :meth:`clubface.Club.on_shaft`). What the program applies to its head over the step is the mean force and torque, so
    that momentum is kept, and a step may be as long as what else acts on the head allows.

    Parameters
    ----------
    club, ball, model, parameters, hand
        As for :class:`SteppedContact`.
    position, velocity, angular_velocity
        Of the ball [m, m/s, rad/s], shape (3,).
    head_gives_way
        False for a head that moves as prescribed whatever the ball does.

    Attributes
    ----------
    motion
        A :class:`BallMotion`.
    phase
        "waiting" before the contact, "contact", or "launched".
    launch
        The outputs of the impact by name [SI], as of :class:`clubface.Launch`, or None before the ball has left the
        face.

    Raises
    ------
    InputError, ShotError
        As of :class:`SteppedContact`.
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
        given, self._error = _prepared(model, club, ball, parameters, hand)
        start = ball_values(BallMotion(position, velocity, angular_velocity))
        self._held = _call(core.BallHandle, self._error, *given, start, bool(head_gives_way))

    def advance(self, head: PoseLike, duration: float | str) -> StepLoads:
        """Move the ball on by a duration [s], at most 0.1 s, while the head moves on from where it is now."""
        step = float(units.parse(duration, "time", name="duration"))
        v = _call(self._held.advance, self._error, head_values(head), step)
        return StepLoads(v[0:3], v[3:6], float(v[6]), float(v[7]))

    @property
    def motion(self) -> BallMotion:
        """Where the ball is and how it moves."""
        v = self._held.motion
        return BallMotion(v[0:3], v[3:6], v[6:9])

    @property
    def phase(self) -> Literal["waiting", "contact", "launched"]:
        """What happens to the ball."""
        return PHASES[self._held.phase]

    @property
    def launch(self) -> dict[str, float] | None:
        """The outputs of the impact, once the ball has left the face."""
        values = self._held.launch
        return None if values is None else dict(zip(outputs(), values, strict=True))


def _prepared(
    model: str, club: Any, ball: Any, parameters: Any, hand: Any
) -> tuple[tuple[str, list[float], list[float]], Callable[[ValueError], Exception]]:
    """Return model, inputs and parameters as the core takes them, and what turns its errors into ours."""
    shot = prepare(model, club, {"speed": SPEED}, ball, parameters, hand, single="a contact that is stepped")
    return (model, shot.shots.columns, shot.parameters), shot.error


def _call(computation: Callable[..., Any], translated: Callable[[ValueError], Exception], *given: Any) -> Any:
    """Call the core, with its errors translated."""
    try:
        return computation(*given)
    except ValueError as error:
        raise translated(error) from None


def head_values(head: PoseLike) -> list[float]:
    """Return the 18 numbers by which the core knows a head: rotation row by row, place, velocity, angular velocity."""
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
    """Return the 9 numbers by which the core knows a ball."""
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
