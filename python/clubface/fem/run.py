"""Finite element impacts: a ball thrown at a rigid plane or struck by a club, and exact derivatives of the launch.

Derivatives come from the same code, run on dual numbers.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.balls import FRICTION_LIMITS, Ball as RigidBall
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.models import Parameter
from clubface.errors import EdgeWarning, InputError, ShotError
from clubface.fem.balls import FRICTION as FRICTION_OF_A_BALL, Ball, ball as ball_of, friction_of
from clubface.fem.core import THE_RUN, Progress, core_call
from clubface.fem.heads import head_names
from clubface.fem.heads.meshed import MeshedHead, ShellHead, mesh_of
from clubface.fem.result import Impact
from clubface.fem.settings import Settings, settings_of
from clubface.schema import PhysicalValue, Place
from clubface.simulation.inputs import DeliveryLike, as_values, equipment, shots
from clubface.simulation.results import input_columns, outputs
from clubface.support.checks import check_choice, check_names, warn_once
from clubface.support.files import builtin_names, is_path
from clubface.support.renamed import renamed_arguments

if TYPE_CHECKING:
    from clubface._core import FemImpact
    from clubface.simulation.inputs import Shots

__all__ = ["Derivatives", "sensitivity", "strike", "throw", "variables"]

AnyBall = str | os.PathLike[str] | Ball | RigidBall | None

FRICTION = Parameter(
    "friction", "1", "Coulomb's coefficient between ball and face", FRICTION_OF_A_BALL, *FRICTION_LIMITS,
    "default: the ball's; measured values are 0.3 to 0.4",
)  # fmt: skip

THROW_SPEED = PhysicalValue("m/s", 0.01, 150)
THROW_ANGLE = PhysicalValue("deg", 0, 80, allowed="0 to 80 deg from the normal")


def simulate(
    ball: Ball, face: Mapping[str, Any], friction: float, *, how: Settings, progress: Progress | None = None
) -> tuple[FemImpact, Settings]:
    """Run an impact; if elements fail and the settings leave the step open, repeat it with shorter steps.

    ``face`` is what the ball strikes, in the core's format. Returns the record and the settings that produced it.
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
    speed: float | str,
    angle: float | str = 0.0,
    friction: float | str | None = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
) -> Impact:
    """Throw a ball at a rigid plane.

    Parameters
    ----------
    ball
        A built-in ball of pieces, the path of a TOML file, or a :class:`Ball`; default ``modern``.
    speed
        Speed [m/s], or text with a unit.
    angle
        Angle between the velocity and the normal of the plane [rad], or text with a unit.
    friction
        Coefficient of Coulomb friction; default: the ball's.
    settings
        Settings of the run.
    progress
        Called with simulated time and duration [s].
    """
    made, (v, incidence) = ball_of(ball), throw_values(speed, angle)
    mu, how = friction_of(friction, made), settings_of(settings)
    plane = {"speed": v, "angle": incidence}
    record, used = simulate(made, {"plane": plane}, mu, how=how, progress=progress)
    return Impact(record, made, plane, mu, used)


def case(ball: Ball, face: Mapping[str, Any], friction: float, how: Settings) -> dict[str, Any]:
    """Return a case in the core's format."""
    return {"ball": ball.values(), "face": face, "friction": friction, "run": how.values()}


def throw_values(speed: float | str, angle: float | str) -> tuple[float, float]:
    """Check speed and angle of a throw and return them [m/s, rad]."""
    return THROW_SPEED.read(speed, Place(name="speed")), THROW_ANGLE.read(angle, Place(name="angle"))


@renamed_arguments(which="ball")
def strike(
    club: str | os.PathLike[str] | Club | MeshedHead,
    delivery: DeliveryLike | None = None,
    *,
    ball: AnyBall = None,
    friction: float | str | None = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
    **values: float | str | None,
) -> Impact:
    """Strike a ball with a head: the rigid head of a club, or a meshed head.

    Parameters
    ----------
    club
        A club as for :func:`clubface.impact`, or a meshed head (:func:`clubface.fem.head`). The path of a meshed head's
        file gives the meshed head.
    delivery, **values
        The delivery of one shot, as for :func:`clubface.impact`.
    ball, friction, settings, progress
        As for :func:`throw`.
    """
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
            f"struck {toe} to the toe and {high} above the centre, the ball reached beyond the edge of the face, where "
            "contact ends, so its launch is uncertain; strike nearer the face centre",
            EdgeWarning,
        )
    return Impact(record, made, given, mu, used, shot, head)


def face_of(head: MeshedHead | None, club: Club, inputs: list[float]) -> dict[str, Any]:
    """Return the head that strikes the ball, in the core's format: a mesh, or else the rigid head of the inputs.

    Raises InputError if an input contradicts the mesh.
    """
    if head is None:
        return {"head": {"inputs": inputs}}
    own = club.inputs()
    for name, value in zip(input_columns(), inputs, strict=True):
        # Left hands are mirrored; the characteristic time is for models with a rigid head.
        if name in own and name not in ("hand", "characteristic_time") and value != own[name]:
            raise InputError(name, value, f"left out; the mesh of {head.name} determines it")
    return {"head": {"inputs": inputs, "mesh": head.values()}}


def one_shot(club: str | os.PathLike[str] | Club, delivery: Mapping[str, Any], made: Ball) -> Shots:
    """Return a single shot for the core."""
    if isinstance(club, str) and club in head_names() and club not in builtin_names("clubs"):
        raise InputError("club", club, f'a club; the meshed head of this name is clubface.fem.head("{club}")')
    for name, value in delivery.items():
        if np.ndim(value):
            raise InputError(name, value, "one value; use a sweep for several")
    return shots(equipment(club, made.rigid), delivery)


def inputs_of(shot: Shots) -> list[float]:
    """Return the inputs of one shot in the core's order."""
    return [float(value) for value in shot.columns]


VARIABLES_A_RUN = 4


class Derivatives(NamedTuple):
    """The launch of one impact and its derivatives.

    Attributes
    ----------
    values
        Launch quantities by name [SI]. Contact time and peak force have no derivatives here and are NaN.
    variables
        Names of the variables.
    jacobian
        Derivatives [SI], shape (number of launch quantities, number of variables).
    """

    values: dict[str, float]
    variables: tuple[str, ...]
    jacobian: NDArray[Any]

    def by(self, quantity: str, variable: str) -> float:
        """Return the derivative of one quantity with respect to one variable [SI]."""
        names = list(self.values)
        check_choice("quantity", quantity, names)
        check_choice("variable", variable, self.variables)
        return float(self.jacobian[names.index(quantity), self.variables.index(variable)])


@renamed_arguments(which="ball")
def variables(club: str | os.PathLike[str] | Club | MeshedHead, *, ball: AnyBall = None) -> list[str]:
    """Return the variables by which a launch can be differentiated: delivery, club, friction and the ball's constants.

    Each piece of the ball has its outer "radius" (a smaller "core.radius" means a thicker cover), the elastic constants
    in its file (at constant Poisson's ratio), "poisson" and "bulk" (at constant elastic constants), "density", and
    "maxwell.0.modulus", "maxwell.0.time" and so on. Each part of a shell head has its mean "thickness", such as
    "head.face.thickness", "youngs", "poisson" and "density". The mesh of such a head is fixed, and the properties of
    its club are not variables.
    """
    made, head, rigid = ball_of(ball), *_head_of(club)
    inputs = inputs_of(one_shot(rigid, {"speed": 1.0}, made))
    names = core.fem_variables(case(made, {"head": {"inputs": inputs, "mesh": head}}, 0.0, Settings()))
    for piece in made.pieces:
        names.insert(names.index(f"{piece.name}.bulk"), f"{piece.name}.poisson")
    return names


def _slopes(made: Ball, name: str) -> dict[str, float]:
    """Return the core variables that a variable changes, with their slopes; the core holds the bulk modulus fixed."""
    for piece in made.pieces:
        bulk, key = f"{piece.name}.bulk", name.removeprefix(f"{piece.name}.")
        material = piece.material
        if name == f"{piece.name}.poisson":
            # K = 2 G (1 + nu) / (3 (1 - 2 nu)).
            return {bulk: 2.0 * material.shear / (1.0 - 2.0 * material.poisson) ** 2}
        if name != key and key in material.constants:
            return {name: 1.0, bulk: material.shear_slope(key) * material.bulk / material.shear}
    return {name: 1.0}


def _head_of(club: str | os.PathLike[str] | Club | MeshedHead) -> tuple[dict[str, Any] | None, Any]:
    """Return the mesh of a shell head in the core's format, or None, and the rigid club."""
    if isinstance(club, MeshedHead) and not isinstance(club, ShellHead):
        raise InputError("club", club.name, "a club (with a rigid head) or a shell head")
    return (club.values(), club.club) if isinstance(club, ShellHead) else (None, club)


@renamed_arguments(which="ball")
def sensitivity(
    club: str | os.PathLike[str] | Club | MeshedHead,
    delivery: DeliveryLike | None = None,
    *,
    by: Iterable[str],
    ball: AnyBall = None,
    friction: float | str | None = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
    **values: float | str | None,
) -> Derivatives:
    """Differentiate the launch of one impact with respect to some variables.

    Parameters
    ----------
    club, delivery, **values, ball, friction, settings
        As for :func:`clubface.fem.strike`. By default the run ends soon after the last touch.
    by
        Names of variables, see :func:`variables`. Each run covers four of them.
    progress
        Called with the number of runs done, fractions included, and the total.
    """
    made = ball_of(ball)
    mu = friction_of(friction, made)
    how = Settings(until_separation=True) if settings is None else settings_of(settings)
    names = (by,) if isinstance(by, str) else tuple(by)
    check_names("variable", names, variables(club, ball=made))
    head, rigid = _head_of(club)
    inputs = inputs_of(one_shot(rigid, dict(as_values(delivery, values)), made))
    directions = [list(_slopes(made, name).items()) for name in names]
    runs = -(-len(directions) // VARIABLES_A_RUN)
    one = case(made, {"head": {"inputs": inputs, "mesh": head}}, mu, replace(how, frames=0))

    def all_runs(watch: Progress) -> tuple[Any, Any]:
        return core.fem_sensitivity(one, directions, lambda number, time, whole: watch(number + time / whole, runs))

    def with_first_of(safeties: Sequence[float | None]) -> tuple[Any, Any]:
        """Return launch and derivatives with the first time step at which no element fails."""
        one["run"]["safety"] = safeties[0]
        try:
            return core_call(all_runs, progress=progress)
        except ShotError as error:
            if error.parameter != THE_RUN or len(safeties) == 1:
                raise
            return with_first_of(safeties[1:])

    launch, jacobian = with_first_of(how.safeties())
    return Derivatives(dict(zip(outputs(), map(float, launch), strict=True)), names, jacobian)
