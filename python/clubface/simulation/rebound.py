"""Rebound of a ball from a plate and a free head by a model: normal and tangential restitution, friction lever.

These three quantities determine a launch (Roh and Lee; Cross), whatever the equations of the model. The heads are
struck through their CG and cannot turn, so that the numbers do not depend on a club.
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

SPEED = 40.0
"""Head speed for the table over the angle of incidence [m/s]."""
SPEEDS = (10.0, 20.0, 30.0, 40.0, 50.0, 60.0)
"""Head speeds for the table of the normal restitution [m/s]."""
ANGLES = tuple(math.radians(angle) for angle in (10, 20, 30, 40, 50, 60, 70))
"""Angles of incidence, between the relative velocity of the ball and the face normal [rad]."""
MASSES = {"plate": 5.0, "head of 200 g": 0.2}
"""Mass by kind of head [kg]: a plate, as heavy as the heads to which `response` was fitted, and a driver."""
RIGID = 1e3
"""Moment of inertia that keeps a head from turning [kg m2]."""


class Rebound(NamedTuple):
    """Three dimensionless numbers for the rebound of a ball from a head that cannot turn.

    The friction lever is the angular momentum of the ball over the product of its mass, its radius and the change of
    its velocity along the face.
    """

    restitution: float  # relative normal speed after impact over that before impact
    tangential_restitution: float  # minus the same of the relative velocity of the ball's surface along the face
    friction_lever: float


def rebound(model: str, *, speed: float, incidence: float, mass: float) -> Rebound:
    """Compute the rebound of a ball at rest from the flat rigid face of a head that moves freely but cannot turn.

    ``model`` is in closed form or has a contact law. The head has a ``speed`` [m/s] at an angle ``incidence`` between
    its path and the face normal [rad], and a ``mass`` [kg].
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
    # Velocities relative to the head, which has lost the momentum gained by the ball.
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
    """Return tables of a model's normal restitution over speed, and of all three numbers over the angle."""
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
    """Return the description of a model: its parameters, and rebound from a plate and a free head."""
    result = model_result(name)
    if name not in models():
        return result
    return result.replace(
        tables=(*rebound_tables(name), *result.tables), notes=(note("rebound-of-model", speed=SPEED), *result.notes)
    )
