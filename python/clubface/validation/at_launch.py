"""Spin and ball speed at the measured launch: the loft is solved, so that no loft that a monitor derives is used.

Radar monitors compute the dynamic loft from the ball by a model of their own. A model that is given such a loft and
judged by its spin is judged by the monitor's model. At the measured launch angle it is judged by what was measured.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from clubface import units
from clubface.simulation.launch import Launch
from clubface.validation.check import Figure, Judged, figure
from clubface.validation.deliveries import rows

SPIN, SPEED = 0.15, 0.025
"""Tolerances: of irons, between which sources differ by 26% at one launch and speed; and of ball speed."""
DRIVE_SPIN = 0.09
"""Of drives, whose heads are unknown."""
STRIKES = tuple(units.parse(each, "length") for each in ("0 mm", "3 mm", "6 mm"))
"""Heights of the strike on a driver above its face centre: the middle, and how far it may be off either way."""
ROBOT = {"club_speed": units.parse("80 mph", "speed"), "attack": units.parse("-2 deg", "angle")}
"""The swing of the robot of Cool Clubs."""
BLADES = ("Staff MB", "Staff CB")
"""The irons of the robot whose mass centre is as near the face as that of the 7-iron here."""


def irons(judged: Judged) -> list[Figure]:
    """Return the spin of irons at their measured launch."""
    blades = [row for row in rows("robot-7-irons-launch-2026") if row["model"] in BLADES]
    robot = {name: sum(row[name] for row in blades) / len(blades) for name in ("launch", "spin")}
    shots = [
        *(("one golfer, TrackMan 4", row) for row in rows("shots-bliss-2026") if row["club"] != "driver"),
        *(("one golfer, Garmin R50", row) for row in rows("shots-r50-2026")),
        ("robot, two blades", {"club": "7-iron", **ROBOT, **robot}),
    ]
    found: list[Figure] = []
    for who, row in shots:
        shot = at_launch(judged, row)
        what = f"{who}, {row['club']}"
        if "ball_speed" in row:
            found.append(figure(what, "ball speed", "mph", row["ball_speed"], shot.ball_speed, SPEED, relative=True))
        found.append(figure(what, "spin", "rpm", row["spin"], shot.total_spin, SPIN, relative=True))
    return found


def drives(judged: Judged) -> list[Figure]:
    """Return the spin of drives at their measured launch, struck 3 mm above the face centre, 3 mm more or less."""
    found: list[Figure] = []
    for table, who in (("drives-blackmore", "many golfers"), ("shots-bliss-2026", "one golfer, TrackMan 4")):
        for row in rows(table):
            if row["club"] != "driver":
                continue
            low, middle, high = (at_launch(judged, row, high=each) for each in STRIKES)
            what = f"{who}, {units.show(row['club_speed'], 'mph', 4)}"
            found.append(figure(what, "ball speed", "mph", row["ball_speed"], middle.ball_speed, SPEED, relative=True))
            published = _interval(
                row["spin"], float(middle.total_spin), [float(low.total_spin), float(high.total_spin)]
            )
            found.append(figure(what, "spin", "rpm", published, middle.total_spin, DRIVE_SPIN, relative=True))
    return found


def at_launch(judged: Judged, row: Mapping[str, Any], **where: float) -> Launch:
    """Return the shot of a published row whose launch angle is as measured; NaN if no loft gives it."""
    delivery = {"speed": row["club_speed"], "attack": row["attack"], **where}
    return judged.hit(row["club"], loft=judged.loft(row["club"], launch=row["launch"], **delivery), **delivery)


def _interval(published: float, middle: float, ends: Iterable[float]) -> tuple[float, float]:
    """Return what the published value may be of the middle strike, if the strike was at one end or the other."""
    possible = [published, *(published * middle / each for each in ends)]
    return (min(possible), max(possible)) if all(map(math.isfinite, possible)) else (published, published)
