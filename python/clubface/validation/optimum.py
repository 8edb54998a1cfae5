"""The longest carry: the launch with which a model and the flight reach it, beside charts that fitters use."""

from __future__ import annotations

import math

import numpy as np

from clubface import units
from clubface.simulation.flight import fly
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats
from clubface.validation.check import Figure, Judged, figure, rows
from clubface.validation.irons import top

LAUNCH_TOLERANCE, SPIN_TOLERANCE = units.parse("1 deg", "angle"), units.parse("300 rpm", "angular rate")
"""What PING's chart counts as near the optimum."""
SPEEDS, ATTACKS = ("80 mph", "100 mph", "120 mph"), (-5.0, 0.0, 5.0)
BALL_SPEEDS, BALL_ATTACKS = ("100 mph", "130 mph", "160 mph"), (-4.0, 0.0, 4.0)
STEPS = np.radians(np.arange(-6.0, 7.0, 2.0))
MOVES = 3
SMASH = 1.46


def longest(judged: Judged, speed: float, attack: float) -> Launch:
    """Return the drive with the longest carry over all dynamic lofts."""
    lofts, carries = _carries(judged, speed, attack, math.radians(16.0) + 0.6 * attack)
    for _ in range(MOVES):
        if 0 < (best := int(np.argmax(carries))) < len(lofts) - 1:
            break
        lofts, carries = _carries(judged, speed, attack, float(lofts[best]))
    return judged.hit("driver", speed=speed, attack=attack, loft=top(lofts, carries))


def _carries(judged: Judged, speed: float, attack: float, middle: float) -> tuple[Floats, Floats]:
    lofts = middle + STEPS
    shots = [judged.hit("driver", speed=speed, attack=attack, loft=float(loft)) for loft in lofts]
    return lofts, np.array([fly(each).carry for each in shots])


def by_club_speed(judged: Judged) -> list[Figure]:
    """Return the launches of the longest drives by club speed and attack angle."""
    found = []
    wanted = {round(units.parse(each, "speed"), 6) for each in SPEEDS}
    for row in rows("optimum-trackman-2010"):
        if row["optimum_of"] == "carry" and round(row["club_speed"], 6) in wanted:
            shot = longest(judged, row["club_speed"], row["attack"])
            found += _launch(_named("club", row["club_speed"], row["attack"]), row, shot)
    return found


def by_ball_speed(judged: Judged) -> list[Figure]:
    """Return the launches of the longest drives by ball speed and attack angle.

    The club speed is that with which the longest drive has the published ball speed, after one correction.
    """
    found = []
    speeds = {round(units.parse(each, "speed"), 6) for each in BALL_SPEEDS}
    attacks = {round(math.radians(each), 6) for each in BALL_ATTACKS}
    for row in rows("optimum-ping-2019"):
        if round(row["ball_speed"], 6) in speeds and round(row["attack"], 6) in attacks:
            speed = row["ball_speed"] / SMASH
            shot = longest(judged, speed, row["attack"])
            shot = longest(judged, speed * row["ball_speed"] / float(shot.ball_speed), row["attack"])
            found += _launch(_named("ball", row["ball_speed"], row["attack"]), row, shot)
    return found


def _named(what: str, speed: float, attack: float) -> str:
    return f"{what} {units.from_si(speed, 'mph'):.0f} mph, attack {units.from_si(attack, 'deg'):+.0f} deg"


def _launch(what: str, row: dict[str, float], shot: Launch) -> list[Figure]:
    return [
        figure(what, "launch angle", "deg", row["launch"], shot.launch, LAUNCH_TOLERANCE),
        figure(what, "spin", "rpm", row["spin"], shot.total_spin, SPIN_TOLERANCE),
    ]
