"""Off-centre strikes, and restitution against plates and a head without spring effect."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club, club
from clubface.simulation.flight import fly
from clubface.simulation.launch import Launch
from clubface.support.checks import without_warnings
from clubface.validation.check import Figure, ModelUnderTest, figure, rows

TOE_SPEED, TOE_LOFT = units.parse("95 mph", "speed"), units.parse("15 deg", "angle")
"""Speed and loft of the robot; the unpublished loft is TrackMan's optimum for this speed."""
SPEED_TOLERANCE = 0.01
LAUNCH_TOLERANCE = units.parse("1 deg", "angle")
SPIN_TOLERANCE = units.parse("200 rpm", "angular rate")
OFFLINE_TOLERANCE = units.parse("5 yd", "length")
HEIGHT_SPIN_TOLERANCE = units.parse("300 rpm", "angular rate")
AXIS_TOLERANCE = 0.3
MODEL_TOLERANCE = 0.15
IRON: dict[str, Any] = {"speed": units.parse("80 mph", "speed"), "attack": units.parse("-3.2 deg", "angle"),
                        "loft": units.parse("22.4 deg", "angle")}  # fmt: skip
"""TrackMan's standard 6-iron shot."""
DEPTHS = (28.0, 42.0)
"""Depths of the CG behind the face [mm]."""
BEST_LAUNCHES = {
    way: [units.parse(each, "angle") for each in launches]
    for way, launches in (("high", ("10 deg", "12 deg", "14 deg")), ("toe", ("12 deg",)))
}
BEST_STEP = units.parse("10 mm", "length")
BEST_TOLERANCES = {"high": units.parse("1.5 mm", "length"), "toe": units.parse("2 mm", "length")}
LOSS_TOLERANCE = 0.002


def toe_hits(judged: ModelUnderTest) -> list[Figure]:
    """Return ball speed, launch and offline distance of a driver struck towards the toe."""
    (row,) = rows("driver-toe-hits-2011")
    centre, toe = (judged.strike("driver", speed=TOE_SPEED, loft=TOE_LOFT, toe=each) for each in (0.0, row["toe"]))
    what = f"driver, {units.show(row['toe'], 'mm', 3)} towards the toe"
    share = row["ball_speed_share"]
    return [
        figure(what, "ball speed, share", "1", share, toe.ball_speed / centre.ball_speed, SPEED_TOLERANCE),
        figure(what, "change of launch angle", "deg", row["launch_change"], toe.launch - centre.launch,
               LAUNCH_TOLERANCE),
        figure(what, "change of spin", "rpm", row["spin_change"], toe.total_spin - centre.total_spin, SPIN_TOLERANCE),
        figure(what, "offline", "yd", row["offline"], abs(fly(toe).side), OFFLINE_TOLERANCE),
    ]  # fmt: skip


def height(judged: ModelUnderTest) -> list[Figure]:
    """Return the effect of striking a driver 15 mm higher, from 7.5 mm below the centre to 7.5 mm above."""
    (row,) = rows("driver-height-2014")
    half = row["higher"] / 2.0
    low, high = (judged.strike("driver", speed=TOE_SPEED, loft=TOE_LOFT, high=each) for each in (-half, half))
    what = f"driver, {units.show(row['higher'], 'mm')} higher"
    spin = high.total_spin - low.total_spin
    return [
        figure(what, "change of launch angle", "deg", row["launch_change"], high.launch - low.launch, LAUNCH_TOLERANCE),
        figure(what, "change of spin", "rpm", row["spin_change"], spin, HEIGHT_SPIN_TOLERANCE),
    ]


def best_strike(judged: ModelUnderTest) -> list[Figure]:
    """Return the fastest impact point on a driver's face at one launch angle, and the loss 10 mm away from it.

    The loft is solved at every impact point. Ball speed is a parabola over the face, so three points determine it.
    """
    places = np.array([-BEST_STEP, 0.0, BEST_STEP])
    result = []
    for row in rows("best-strike-blackmore"):
        way = row["direction"]
        for launch in BEST_LAUNCHES[way]:
            speeds = judged.at_launch("driver", launch, speed=TOE_SPEED, **{way: places}).ball_speed
            bend, slope, _ = np.polyfit(places, speeds, 2)
            what = f"driver, launch {units.show(launch, 'deg')}"
            best = figure(what, f"fastest strike, {way}", "mm", (row["best_least"], row["best_most"]),
                          -slope / (2.0 * bend), BEST_TOLERANCES[way])  # fmt: skip
            loss = figure(what, f"speed lost 10 mm away, {way}", "%", (row["loss_least"], row["loss_most"]),
                          -bend * BEST_STEP**2 / speeds[1], LOSS_TOLERANCE)  # fmt: skip
            result += [best, loss]
    return result


def gear_effect(judged: ModelUnderTest) -> list[Figure]:
    """Return the spin axis of off-centre strikes, and the part of it due to CG depth.

    The face angle refers to the impact point: the club is turned back by the effect of bulge there.
    """
    result = []
    drive: dict[str, Any] = {"speed": TOE_SPEED, "loft": TOE_LOFT}
    for row in rows("strike-offsets-trackman"):
        bulge, delivery = club(row["club"]).bulge, drive if row["club"] == "driver" else IRON
        turned = -math.asin(row["toe"] / bulge) if math.isfinite(bulge) else 0.0
        centre, shot = (
            judged.strike(row["club"], toe=toe, face=face, **delivery)
            for toe, face in ((0.0, 0.0), (row["toe"], turned))
        )
        side = "toe" if row["toe"] > 0.0 else "heel"
        what = f"{row['club']}, {units.show(abs(row['toe']), 'mm', 2)} towards the {side}"
        axis = shot.spin_axis - centre.spin_axis
        result.append(figure(what, "spin axis", "deg", row["spin_axis"], axis, AXIS_TOLERANCE, relative=True))
    (row,) = rows("gear-effect-2016")
    spins = [judged.strike(nominal(depth), speed=50.0, toe=row["toe"]).sidespin for depth in DEPTHS]
    growth = row["depth_added"] * abs(spins[1] - spins[0]) / units.parse(f"{DEPTHS[1] - DEPTHS[0]} mm", "length")
    given = row["sidespin_added"]
    return [*result, figure("driver, 25 mm towards the toe", "sidespin by a mm of depth", "rpm", given, growth,
                           MODEL_TOLERANCE, relative=True)]  # fmt: skip


def nominal(depth: float) -> Club:
    """Return the driver of McNally, Balzerson, Wilson and McPhee (2016) with a CG depth of ``depth`` [mm]."""
    loft, below = math.radians(10.0), 4.0
    return club("driver").replace(
        name="nominal driver", mass="200 g", loft=loft, bulge="400 mm", roll="350 mm",
        cg_x=f"{depth * math.cos(loft) - below * math.sin(loft)} mm",
        cg_y=f"{depth * math.sin(loft) + below * math.cos(loft)} mm", cg_z=0.0,
        ixx="3000 g cm2", iyy="4500 g cm2", izz="2000 g cm2", ixy=0.0, ixz=0.0, iyz=0.0,
    )  # fmt: skip


RESTITUTION_TOLERANCE, TANGENTIAL_TOLERANCE, SLOW_TOLERANCE = 0.01, 0.1, 0.02
OBLIQUE_SPEED = 20.0
"""Assumed speed of the balls at 50 degrees, which is not stated [m/s]."""
GRIPPING = units.parse("40 deg", "angle")
DRIVE: dict[str, Any] = {"speed": units.parse("113 mph", "speed"), "attack": units.parse("-1.3 deg", "angle"),
                         "loft": units.parse("12.8 deg", "angle")}  # fmt: skip
TIME_TOLERANCE = units.parse("25 us", "time")


def block(mass: float, inertia: float) -> Club:
    """Return a rigid block with a plane, vertical face in front of its CG [kg, kg m2]."""
    with without_warnings():  # no head weighs a ton
        return Club(
            name="block", kind="iron", mass=mass, cg_x=0.03, cg_y=0.0, cg_z=0.0, loft=0.0,
            bulge=math.inf, roll=math.inf, face_width=0.09, face_height=0.07,
            ixx=inertia, iyy=inertia, izz=inertia, ixy=0.0, ixz=0.0, iyz=0.0,
        )  # fmt: skip


PLATE = block(1e3, 1e3)
HEAD = block(units.parse("200 g", "mass"), 0.05)
"""A head that does not rotate, which is equivalent to a test at the projection of the CG."""


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


def plates(judged: ModelUnderTest) -> list[Figure]:
    """Return the restitution of the ball against plates and a head without spring effect."""
    result = []

    def against(club: Club, speed: float, angle: float = 0.0, friction: float | None = None) -> tuple[float, float]:
        parameters = None if friction is None else {"friction": friction}
        return restitutions(judged.strike(club, speed=speed, loft=angle, parameters=parameters), speed, angle)

    (least,) = rows("plate-cor-three-piece")
    (most,) = rows("plate-cor-reduced-distance")
    (head,) = rows("head-without-spring")
    (slow,) = rows("plate-granite-2002")
    (oblique,) = rows("tangential-restitution")
    for what, struck, speed, published in (
        ("plate, 143 ft/s", PLATE, least["speed"], (least["restitution_least"], math.inf)),
        ("plate, 125 ft/s", PLATE, most["speed"], (most["restitution_most"], math.inf)),
        ("head without spring, 160 ft/s", HEAD, head["speed"], (head["restitution_least"], head["restitution_most"])),
        ("granite, 4 m/s", PLATE, slow["speed"], slow["restitution"]),
    ):
        allowed = SLOW_TOLERANCE if what.startswith("granite") else RESTITUTION_TOLERANCE
        result.append(figure(what, "restitution", "1", published, against(struck, speed)[0], allowed))
    gripping = math.nan
    if judged.has("friction"):
        gripping = against(PLATE, slow["speed"], GRIPPING, slow["friction"])[1]
    published = slow["tangential_restitution_gripping"]
    across = "tangential restitution"
    result.append(figure("granite, 4 m/s, 40 deg", across, "1", published, gripping, TANGENTIAL_TOLERANCE))
    published = (oblique["restitution_least"], oblique["restitution_most"])
    computed = against(PLATE, OBLIQUE_SPEED, oblique["incidence"])[1]
    return [*result, figure("plate, 50 deg", across, "1", published, computed, TANGENTIAL_TOLERANCE)]


def contact_time(judged: ModelUnderTest) -> list[Figure]:
    """Return the contact time of a drive."""
    (row,) = rows("drive-contact-time")
    published = (row["contact_time_least"], row["contact_time_most"])
    computed = judged.strike(club("driver"), **DRIVE).contact_time
    return [figure("driver, 113 mph", "contact time", "us", published, computed, TIME_TOLERANCE)]
