"""Runs of impacts by finite elements: a ball thrown at a rigid plane, or struck by a club."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.equipment.balls import FRICTION_LIMITS, Ball as RigidBall
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.models import Parameter
from clubface.errors import EdgeWarning, InputError
from clubface.fem import core
from clubface.fem.balls import FRICTION as FRICTION_OF_A_BALL, Ball, ball as ball_of, friction_value
from clubface.fem.core import Progress, core_call
from clubface.fem.heads import head_names
from clubface.fem.heads.meshed import MeshedHead, mesh_of
from clubface.fem.result import Impact
from clubface.fem.settings import Settings, settings_of
from clubface.simulation.inputs import Delivery
from clubface.simulation.results import input_columns
from clubface.support.checks import warn_once
from clubface.support.files import builtin_names, is_path
from clubface.support.renamed import renamed_arguments

if TYPE_CHECKING:
    from clubface.fem.core import FemImpact
    from clubface.simulation.inputs import Shots

__all__ = ["strike", "throw"]

AnyBall = str | os.PathLike[str] | Ball | RigidBall | None

FRICTION = Parameter(
    "friction",
    "1",
    "Coulomb's coefficient between ball and face",
    FRICTION_OF_A_BALL,
    *FRICTION_LIMITS,
    "that of the ball, unless it is given; 0.3 to 0.4 are measured",
)

THROW_SPEEDS = (0.01, 150.0)
"""Speeds at which a ball may be thrown [m/s]."""
THROW_ANGLES = (0.0, units.parse("80 deg", "angle"))
"""Angles between its velocity and the normal of the plane [rad]."""


def simulate(
    ball: Ball, face: Mapping[str, Any], friction: float, *, how: Settings, progress: Progress | None = None
) -> tuple[FemImpact, Settings]:
    """Run an impact; if elements fail and the settings leave the step open, run it again with shorter steps.

    ``face`` is what the ball meets, as the core takes it. Returns the record, and the settings that led to it.
    """

    def run(safety: float | None) -> FemImpact:
        return core_call(core.fem_impact, case(ball, face, friction, replace(how, safety=safety)), progress=progress)

    first, *shorter = how.safeties()
    record = run(first)
    for safety in shorter:
        if not record.failed:
            break
        record = run(safety)
    return record, replace(how, safety=record.safety)


@renamed_arguments(which="ball")
def throw(
    ball: AnyBall = None,
    *,
    speed: Any,
    angle: Any = 0.0,
    friction: Any = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
) -> Impact:
    """Throw a ball at a rigid plane.

    Parameters
    ----------
    ball
        A built-in ball of pieces, the path of a TOML file, or a :class:`Ball`; ``modern`` unless given.
    speed
        Speed [m/s], or text with a unit.
    angle
        Angle between the velocity and the normal of the plane [rad], or text with a unit.
    friction
        Coefficient of Coulomb friction; that of the ball unless given.
    settings
        How to run the impact.
    progress
        Called with simulated time and duration [s].
    """
    made, (v, incidence) = ball_of(ball), throw_values(speed, angle)
    mu, how = friction_of(friction, made), settings_of(settings)
    plane = {"speed": v, "angle": incidence}
    record, used = simulate(made, {"plane": plane}, mu, how=how, progress=progress)
    return Impact(record, made, plane, mu, used)


def case(ball: Ball, face: Mapping[str, Any], friction: float, how: Settings) -> dict[str, Any]:
    """Return a case as the core takes it."""
    return {"ball": ball.values(), "face": face, "friction": friction, "run": how.values()}


def throw_values(speed: Any, angle: Any) -> tuple[float, float]:
    """Return speed [m/s] and angle [rad] of a throw, checked."""
    v = units.parse(speed, "speed", name="speed")
    if not THROW_SPEEDS[0] <= v <= THROW_SPEEDS[1]:
        raise InputError("speed", units.show(v, "m/s"), "{:g} to {:g} m/s".format(*THROW_SPEEDS))
    incidence = units.parse(angle, "angle", name="angle")
    if not THROW_ANGLES[0] <= incidence <= THROW_ANGLES[1]:
        least, most = (units.from_si(each, "deg") for each in THROW_ANGLES)
        raise InputError("angle", units.show(incidence, "deg"), f"{least:g} to {most:g} deg from the normal")
    return v, incidence


@renamed_arguments(which="ball")
def strike(
    club: str | os.PathLike[str] | Club | MeshedHead,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    ball: AnyBall = None,
    friction: Any = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
    **values: Any,
) -> Impact:
    """Hit a ball with a head: the rigid head of a club, or a meshed head.

    Parameters
    ----------
    club
        A club as for :func:`clubface.impact`, or a meshed head (:func:`clubface.fem.head`). The file of a meshed head
        is that head.
    delivery, **values
        The delivery, as for :func:`clubface.impact`, for one shot.
    ball, friction, settings, progress
        As for :func:`throw`.
    """
    from clubface.simulation.inputs import as_values

    made, how = ball_of(ball), settings_of(settings)
    mu = friction_of(friction, made)
    given = dict(as_values(delivery, values))
    if is_path(club):
        club = club_of(club)  # pyright: ignore[reportArgumentType]
    head = mesh_of(club)
    shot = one_shot(club.club if isinstance(club, MeshedHead) else club, given, made)
    record, used = simulate(made, face_of(head, shot.club, inputs_of(shot)), mu, how=how, progress=progress)
    if record.over_edge and not record.failed:
        toe, high = (units.show(units.parse(given.get(name, 0.0), "length"), "mm") for name in ("toe", "high"))
        warn_once(
            f"struck {toe} to the toe and {high} above the centre, the ball reached round the edge of the face, where "
            "contact ends, so that its launch is in doubt; strike nearer the face centre",
            EdgeWarning,
        )
    return Impact(record, made, given, mu, used, shot, head)


def face_of(head: MeshedHead | None, club: Club, inputs: list[float]) -> dict[str, Any]:
    """Return the head that hits a ball, as the core takes it: a mesh or, without one, the rigid head of the inputs.

    Raises
    ------
    InputError
        An input would change what the mesh says of the club.
    """
    if head is None:
        return {"head": {"inputs": inputs}}
    own = club.inputs()
    for name, value in zip(input_columns(), inputs, strict=True):
        # Left hands are mirrored; the time of the face is for models that take the head as rigid.
        if name in own and name not in ("hand", "characteristic_time") and value != own[name]:
            raise InputError(name, value, f"left out: the mesh of {head.name} says it")
    return {"head": {"inputs": inputs, "mesh": head.values()}}


def one_shot(club: str | os.PathLike[str] | Club, delivery: Mapping[str, Any], made: Ball) -> Shots:
    """Return the shot as the core takes it."""
    from clubface.simulation.inputs import equipment, shots

    if isinstance(club, str) and club in head_names() and club not in builtin_names("clubs"):
        raise InputError("club", club, f'a club; the meshed head of this name is clubface.fem.head("{club}")')
    for name, value in delivery.items():
        if np.ndim(value):
            raise InputError(name, value, "one value; use a sweep for several")
    return shots(equipment(club, made.rigid), delivery)


def inputs_of(shot: Shots) -> list[float]:
    """Return the inputs of one shot in the order of the core."""
    return [float(value) for value in shot.columns]


def friction_of(given: Any, made: Ball) -> float:
    """Return the coefficient of friction that was given, checked, or that of the ball."""
    return made.friction if given is None else friction_value(given)
