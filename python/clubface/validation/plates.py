"""Balls against plates and against a head without spring effect: restitution along and across the normal."""

from __future__ import annotations

import math
from typing import Any

from clubface import units
from clubface.equipment.clubs import Club, club
from clubface.simulation.launch import Launch
from clubface.support.warning import without_warnings
from clubface.validation.check import Figure, Judged, figure, rows

RESTITUTION_TOLERANCE, TANGENTIAL_TOLERANCE, SLOW_TOLERANCE = 0.01, 0.1, 0.02
OBLIQUE_SPEED = 20.0
"""Of the balls at 50 degrees, whose speed is not stated [m/s]."""
GRIPPING = units.parse("40 deg", "angle")
DRIVE: dict[str, Any] = {"speed": units.parse("113 mph", "speed"), "attack": units.parse("-1.3 deg", "angle"),
                         "loft": units.parse("12.8 deg", "angle")}  # fmt: skip
TIME_TOLERANCE = units.parse("25 us", "time")


def block(mass: float, inertia: float) -> Club:
    """Return a rigid block with a plane, upright face before its mass centre [kg, kg m2]."""
    with without_warnings():  # no head weighs a ton
        return Club(
            name="block", kind="iron", mass=mass, cg_x=0.03, cg_y=0.0, cg_z=0.0, loft=0.0,
            bulge=math.inf, roll=math.inf, face_width=0.09, face_height=0.07,
            ixx=inertia, iyy=inertia, izz=inertia, ixy=0.0, ixz=0.0, iyz=0.0,
        )  # fmt: skip


PLATE = block(1e3, 1e3)
HEAD = block(units.parse("200 g", "mass"), 0.05)
"""A head that does not turn, which is what a test at the projection of the mass centre comes to."""


def restitutions(shot: Launch, speed: float, angle: float) -> tuple[float, float]:
    """Return normal and tangential restitution of a ball hit by a plate of loft ``angle`` that moves at ``speed``.

    The plate moves towards the target, so that it meets the ball at ``angle`` from its normal.
    """
    x, y = shot.velocity_x - shot.club_velocity_x, shot.velocity_y - shot.club_velocity_y
    normal = x * math.cos(angle) + y * math.sin(angle)
    along = y * math.cos(angle) - x * math.sin(angle)
    slip = along - shot.backspin * shot.ball.radius
    tangential = -slip / (speed * math.sin(angle)) if angle else math.nan
    return float(normal / (speed * math.cos(angle))), float(tangential)


def plates(judged: Judged) -> list[Figure]:
    """Return the restitution of the ball against plates and a head without spring effect."""
    found = []

    def against(of: Club, speed: float, angle: float = 0.0, friction: float | None = None) -> tuple[float, float]:
        parameters = None if friction is None else {"friction": friction}
        return restitutions(judged.hit(of, speed=speed, loft=angle, parameters=parameters), speed, angle)

    (least,) = rows("plate-cor-three-piece")
    (most,) = rows("plate-cor-reduced-distance")
    (head,) = rows("head-without-spring")
    (slow,) = rows("plate-granite-2002")
    (oblique,) = rows("tangential-restitution")
    for what, of, speed, published in (
        ("plate, 143 ft/s", PLATE, least["speed"], (least["restitution_least"], math.inf)),
        ("plate, 125 ft/s", PLATE, most["speed"], (most["restitution_most"], math.inf)),
        ("head without spring, 160 ft/s", HEAD, head["speed"], (head["restitution_least"], head["restitution_most"])),
        ("granite, 4 m/s", PLATE, slow["speed"], slow["restitution"]),
    ):
        allowed = SLOW_TOLERANCE if what.startswith("granite") else RESTITUTION_TOLERANCE
        found.append(figure(what, "restitution", "1", published, against(of, speed)[0], allowed))
    gripping = math.nan
    if judged.has("friction"):
        gripping = against(PLATE, slow["speed"], GRIPPING, slow["friction"])[1]
    published = slow["tangential_restitution_gripping"]
    across = "tangential restitution"
    found.append(figure("granite, 4 m/s, 40 deg", across, "1", published, gripping, TANGENTIAL_TOLERANCE))
    published = (oblique["restitution_least"], oblique["restitution_most"])
    computed = against(PLATE, OBLIQUE_SPEED, oblique["incidence"])[1]
    return [*found, figure("plate, 50 deg", across, "1", published, computed, TANGENTIAL_TOLERANCE)]


def contact_time(judged: Judged) -> list[Figure]:
    """Return the contact time of a drive."""
    (row,) = rows("drive-contact-time")
    published = (row["contact_time_least"], row["contact_time_most"])
    computed = judged.hit(club("driver"), **DRIVE).contact_time
    return [figure("driver, 113 mph", "contact time", "us", published, computed, TIME_TOLERANCE)]
