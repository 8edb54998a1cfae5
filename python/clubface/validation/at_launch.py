"""Spin and ball speed at the measured launch: the loft is solved, so that no loft that a monitor derives is used.

Radar monitors compute the dynamic loft from the ball by a model of their own. A model that is given such a loft and
judged by its spin is judged by the monitor's model. At the measured launch angle it is judged by what was measured.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from clubface import units
from clubface.tour.averages import averages
from clubface.validation.average import CENTRE, DRIVER, HEIGHTS, WOODS, Scatter, ratios, scatter
from clubface.validation.check import Figure, Judged, figure, rows

SPEED, SPIN, DRIVE_SPIN = 0.025, 0.15, 0.09
"""Tolerances: of ball speed; of the spin of irons, between which sources differ by 26% at one launch and speed; and of
the spin of drivers and woods, whose heads are unknown."""
SEASONS = {"pga-2019": "PGA Tour 2019", "lpga-2019": "LPGA Tour 2019"}
"""The tour averages, and what they are called here."""
TOUR_SPEED = units.parse("113 mph", "speed")
"""Golfers on tour, whose scatter is not published, are taken to scatter no more than others who drive as fast."""
ROBOT = {"club_speed": units.parse("80 mph", "speed"), "attack": units.parse("-2 deg", "angle")}
"""The swing of the robot of Cool Clubs."""
BLADES = ("Staff MB", "Staff CB")
"""The irons of the robot whose mass centre is as near the face as that of the 7-iron here."""


def tour(wanted: Callable[[str], bool]) -> Callable[[Judged], list[Figure]]:
    """Return the comparison with the tour averages of the clubs that are ``wanted``."""

    def compute(judged: Judged) -> list[Figure]:
        return [
            one
            for name, season in SEASONS.items()
            for each in averages(name)
            if wanted(each.club)
            for one in judged_at_launch(
                judged, f"{season}, {each.club}", each._asdict(), scatter=scatter(each.club, TOUR_SPEED)
            )
        ]  # fmt: skip

    return compute


def amateurs(judged: Judged) -> list[Figure]:
    """Return ball speed and spin of the drives of golfers by handicap."""
    return [
        one
        for row in rows("drives-by-handicap")
        for one in judged_at_launch(
            judged, row["group"], {"club": DRIVER, **row}, scatter=scatter(DRIVER, row["club_speed"])
        )
    ]  # fmt: skip


def irons(judged: Judged) -> list[Figure]:
    """Return ball speed and spin of irons of single golfers and of a robot, which does not scatter."""
    blades = [row for row in rows("robot-7-irons-launch-2026") if row["model"] in BLADES]
    robot = {name: sum(row[name] for row in blades) / len(blades) for name in ("launch", "spin")}
    shots = [
        *(("one golfer, TrackMan 4", row, True) for row in rows("shots-bliss-2026") if row["club"] != DRIVER),
        *(("one golfer, Garmin R50", row, True) for row in rows("shots-r50-2026")),
        ("robot, two blades", {"club": "7-iron", **ROBOT, **robot}, False),
    ]
    return [
        one
        for who, row, golfer in shots
        for one in judged_at_launch(
            judged, f"{who}, {row['club']}", row, scatter=scatter(row["club"], TOUR_SPEED) if golfer else None
        )
    ]  # fmt: skip


def drives(judged: Judged) -> list[Figure]:
    """Return ball speed and spin of drives of many golfers, chosen to start near their path, and of a single one."""
    return [
        one
        for table, who, scattered in (
            ("drives-blackmore", "many golfers", False), ("shots-bliss-2026", "one golfer, TrackMan 4", True),
        )
        for row in rows(table)
        if row["club"] == DRIVER
        for one in judged_at_launch(
            judged, f"{who}, {units.show(row['club_speed'], 'mph', 4)}", row,
            scatter=scatter(DRIVER, row["club_speed"]) if scattered else None,
        )
    ]  # fmt: skip


def judged_at_launch(judged: Judged, what: str, row: Mapping[str, Any], *, scatter: Scatter | None) -> Iterator[Figure]:
    """Return ball speed, if it is published, and spin of a published row whose launch angle is as measured.

    A driver is struck at the middle of ``HEIGHTS``, other clubs at the face centre.
    """
    club = row["club"]
    heights = HEIGHTS if club == DRIVER else CENTRE
    middle = heights[len(heights) // 2]
    shot = judged.at_launch(club, row["launch"], speed=row["club_speed"], attack=row["attack"], high=middle)
    possible = ratios(club, row["club_speed"], row["attack"], row["launch"], scatter, heights)
    allowed = DRIVE_SPIN if club in (DRIVER, *WOODS) else SPIN
    for name, quantity, unit, column, tolerance in (
        ("ball_speed", "ball speed", "mph", "ball_speed", SPEED), ("total_spin", "spin", "rpm", "spin", allowed),
    ):  # fmt: skip
        if column in row:
            low, high = (row[column] * ratio for ratio in possible[name])
            yield figure(what, quantity, unit, (low, high), getattr(shot, name), tolerance, relative=True)
