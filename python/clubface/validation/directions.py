"""Where balls start between the path of the club and the normal of the face, and how they curve."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clubface import units
from clubface.simulation.flight import fly
from clubface.tour.averages import averages, published_lofts
from clubface.validation.check import Figure, Judged, figure, rows

OPEN = units.parse("3 deg", "angle")
"""Face angle to either side, with a club path of zero."""
CURVE_TOLERANCE = 0.25
BETWEEN_SOURCES = 0.06
"""The largest difference between the two published shares of one club."""
STEEPER_TOLERANCE = units.parse("1 deg", "angle")
HEAD_SPEED = units.parse("100 mph", "speed")


def deliveries() -> dict[str, dict[str, Any]]:
    """Return a published delivery of each club for which shares are published: speed, attack angle, dynamic loft."""
    drive = next(row for row in rows("drives-by-handicap") if row["group"] == "male, 10")
    wedge = next(row for row in rows("standard-shots-trackman") if row["club"] == "pitching-wedge")
    lofts = [row["dynamic_loft"] for row in rows("robot-7-irons-2026")]
    iron = {
        "club_speed": units.parse("82 mph", "speed"), "attack": units.parse("-3 deg", "angle"),
        "dynamic_loft": float(np.mean(lofts)),
    }  # fmt: skip
    names = {"speed": "club_speed", "attack": "attack", "loft": "dynamic_loft"}
    found = {"driver": drive, "7-iron": iron, "pitching-wedge": wedge}
    return {club: {name: row[column] for name, column in names.items()} for club, row in found.items()}


def shares(judged: Judged) -> list[Figure]:
    """Return the shares of the way from club to face, of launch angle and of start direction."""
    found = []
    for club, delivery in deliveries().items():
        attack, loft = delivery["attack"], delivery["loft"]
        up = (judged.hit(club, **delivery).launch - attack) / (loft - attack)
        right, left = (judged.hit(club, face=face, **delivery).azimuth for face in (OPEN, -OPEN))
        for table, quantity, computed in (
            ("launch-shares-vertical", "launch angle (PING)", up),
            ("launch-shares-trackman", "launch angle (TrackMan)", up),
            ("launch-shares-horizontal", "start direction (PING)", (right - left) / (2.0 * OPEN)),
        ):
            (row,) = (each for each in rows(table) if each["club"] == club)
            allowed = row.get("spread", BETWEEN_SOURCES)
            found.append(figure(club, f"share of {quantity}", "1", row["share"], computed, allowed))
    return found


def curvature(judged: Judged) -> list[Figure]:
    """Return how far from their first line shots land whose face is open or closed to the path, which opposes it."""
    found = []
    for row in rows("curvature-trackman"):
        table = "pga-2019" if row["group"] == "PGA Tour" else "lpga-2019"
        average = next(each for each in averages(table) if each.club == row["club"])
        half = row["face_to_path"] / 2.0
        shot = judged.hit(
            row["club"], speed=average.club_speed, attack=average.attack, loft=published_lofts(table)[row["club"]],
            face=half, path=-half,
        )  # fmt: skip
        ball = fly(shot)
        curve = ball.carry * math.sin(math.asin(ball.side / ball.carry) - shot.azimuth)
        what = f"{row['group']}, {row['club']}, face to path {units.show(row['face_to_path'], 'deg')}"
        found.append(figure(what, "curve", "yd", row["curve"], curve, CURVE_TOLERANCE, relative=True))
    return found


def head_after_impact(judged: Judged) -> list[Figure]:
    """Return by how much steeper a driver's head goes down when the ball has left."""
    (row,) = rows("head-after-impact")
    found = []
    for loft, steeper in (("spin_loft_least", "steeper_least"), ("spin_loft_most", "steeper_most")):
        shot = judged.hit("driver", speed=HEAD_SPEED, loft=row[loft])
        computed = -math.atan2(shot.club_velocity_y, shot.club_velocity_x)
        what = f"driver, spin loft {units.show(row[loft], 'deg')}"
        found.append(figure(what, "attack angle steeper by", "deg", row[steeper], computed, STEEPER_TOLERANCE))
    return found
