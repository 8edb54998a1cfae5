"""How a ball leaves a plate and a free head by a model: restitution along the normal and the face, lever of friction.

These three quantities determine a launch (Roh and Lee; Cross), whatever the equations of a model are. The heads are
struck through their CG and cannot turn, so that the figures do not depend on a club.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from clubface.equipment.clubs import Club
from clubface.equipment.listings import model_result
from clubface.equipment.models import models
from clubface.results.notes import note
from clubface.results.result import Result
from clubface.results.table import Table, column, table
from clubface.simulation.impact import impact
from clubface.support.checks import without_warnings

__all__ = ["Rebound", "model_in_full", "rebound", "rebound_tables"]


SPEED = 40.0
"""Speed of the heads for which angles are compared [m/s]."""
SPEEDS = (10.0, 20.0, 30.0, 40.0, 50.0, 60.0)
"""Speeds of the heads over which the normal restitution is shown [m/s]."""
ANGLES = tuple(math.radians(angle) for angle in (10, 20, 30, 40, 50, 60, 70))
"""Angles between the path of the ball, as the face sees it, and the face normal [rad]."""
MASSES = {"plate": 5.0, "head of 200 g": 0.2}
"""Mass by kind of head [kg]: a plate, as heavy as the heads to which `response` was fitted, and a driver."""
RIGID = 1e3
"""Inertia of a head that cannot turn [kg m2]."""


class Rebound(NamedTuple):
    """Three dimensionless figures of how a ball leaves a head that cannot turn.

    Attributes
    ----------
    restitution
        Normal speed at which ball and head part over that at which they met.
    tangential_restitution
        Minus the velocity of the ball's surface along the face after impact over that before.
    friction_lever
        Angular momentum of the ball over mass, radius and change of its velocity along the face.
    """

    restitution: float
    tangential_restitution: float
    friction_lever: float


def rebound(model: str, *, speed: float, incidence: float, mass: float) -> Rebound:
    """Return how a ball at rest leaves a flat rigid face that meets it.

    Parameters
    ----------
    model
        A model that computes launches in closed form or by contact laws, with its own parameters and ball.
    speed, incidence
        Speed of the head [m/s], and the angle between its path and the face normal [rad].
    mass
        Mass of the head [kg], which moves freely and cannot turn.
    """
    with without_warnings():  # such a head is implausible
        head = Club(
            name="plate", kind="iron", mass=mass, cg_x=0.0, cg_y=0.0, cg_z=0.0, ixx=RIGID, iyy=RIGID, izz=RIGID,
            ixy=0.0, ixz=0.0, iyz=0.0, loft=incidence, bulge=math.inf, roll=math.inf, face_width=0.5, face_height=0.5,
            characteristic_time=0.0,
        )  # fmt: skip
        launch = impact(head, speed=speed, loft=incidence, model=model)
    speed_after, up, spin = (float(value) for value in (launch.ball_speed, launch.launch, launch.backspin))
    ball = launch.ball
    # Velocities relative to the head, which has lost the momentum that the ball gained.
    share = 1.0 + ball.mass / mass
    along_normal = share * speed_after * math.cos(incidence - up) - speed * math.cos(incidence)
    before = speed * math.sin(incidence)
    along_face = before - share * speed_after * math.sin(incidence - up)
    return Rebound(
        along_normal / (speed * math.cos(incidence)),
        -(along_face - spin * ball.radius) / before if before else math.nan,
        ball.inertia * spin / (ball.mass * ball.radius * (before - along_face) / share) if before else math.nan,
    )


def rebound_tables(model: str) -> tuple[Table, Table]:
    """Return a model's normal restitution over speed, and all three figures over the angle."""
    by_speed = [
        column("speed", SPEEDS, unit="m/s", digits=0, label="speed"),
        *(
            column(f"restitution_{_key(name)}",
                   [rebound(model, speed=speed, incidence=0.0, mass=mass).restitution for speed in SPEEDS],
                   "restitution", digits=3, label=name)
            for name, mass in MASSES.items()
        ),
    ]  # fmt: skip
    by_angle = [column("incidence", ANGLES)]
    for name, mass in MASSES.items():
        figures = [rebound(model, speed=SPEED, incidence=angle, mass=mass) for angle in ANGLES]
        for quantity, values in zip(Rebound._fields, zip(*figures, strict=True), strict=True):
            label = f"{_SHORT[quantity]}, {name}"
            by_angle.append(column(f"{quantity}_{_key(name)}", list(values), quantity, digits=3, label=label))
    return (
        table("restitution_over_speed", *by_speed, title="Normal restitution over speed, rigid faces"),
        table("rebound_over_angle", *by_angle, title=f"Over the angle, at {SPEED:.0f} m/s"),
    )


_SHORT = {"restitution": "normal", "tangential_restitution": "along face", "friction_lever": "lever"}


def _key(name: str) -> str:
    return name.split(" ")[0]


def model_in_full(name: str) -> Result:
    """Return a model with its parameters, and how a ball leaves a plate and a free head by it."""
    result = model_result(name)
    if name not in models():
        return result
    return result.replace(
        tables=(*rebound_tables(name), *result.tables), notes=(note("rebound-of-model", speed=SPEED), *result.notes)
    )
