"""Published deliveries with their launches: averages of tours and of amateurs, and TrackMan's own model of drives."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from clubface import measurements, units
from clubface.tour.averages import averages, published_lofts
from clubface.validation.check import Figure, Judged, figure

SEASONS = {"pga-2019": "PGA Tour 2019", "lpga-2019": "LPGA Tour 2019"}
"""The averages with which dynamic lofts are published. Those of 2023 have none."""
WOODS = ("3-wood", "5-wood", "hybrid")


class Tolerances(NamedTuple):
    """How far off a launch may be: ball speed and spin as shares, launch angle in rad."""

    ball_speed: float
    launch: float
    spin: float


IRON = Tolerances(0.02, units.parse("1.5 deg", "angle"), 0.05)
DRIVER = Tolerances(0.025, units.parse("1 deg", "angle"), 0.08)


def tour(wanted: Callable[[str], bool], allowed: Tolerances) -> Callable[[Judged], list[Figure]]:
    """Return the comparison with the averages of the clubs that are ``wanted``.

    Where no dynamic loft is published, the model gets the loft with which it launches as published, and its launch
    angle is no prediction.
    """

    def compute(judged: Judged) -> list[Figure]:
        found: list[Figure] = []
        for name, season in SEASONS.items():
            lofts = published_lofts(name)
            for each in averages(name):
                if not wanted(each.club):
                    continue
                loft = lofts.get(each.club)
                solved = loft is None
                if loft is None:
                    loft = judged.loft(each.club, each.club_speed, each.attack, each.launch)
                shot = judged.hit(each.club, speed=each.club_speed, attack=each.attack, loft=loft)
                published = (each.ball_speed, math.nan if solved else each.launch, each.spin)
                found += launched(f"{season}, {each.club}", published, shot, allowed)
        return found

    return compute


def launched(what: str, published: tuple[float, float, float], shot: Any, allowed: Tolerances) -> Iterator[Figure]:
    """Return ball speed, launch angle and spin of a shot; what is not published is left out."""
    names = ("ball speed", "launch angle", "spin")
    computed = (shot.ball_speed, shot.launch, shot.total_spin)
    for name, unit, value, given, tolerance in zip(
        names, ("mph", "deg", "rpm"), computed, published, allowed, strict=True
    ):
        if not math.isnan(given):
            yield figure(what, name, unit, given, value, tolerance, relative=unit != "deg")


def complete(
    table: str, label: Callable[[Any], str], allowed: Callable[[str], Tolerances]
) -> Callable[[Judged], list[Figure]]:
    """Return the comparison with a table of complete deliveries and launches; without a column of clubs all drive."""

    def compute(judged: Judged) -> list[Figure]:
        found: list[Figure] = []
        for row in rows(table):
            club = row.get("club", "driver")
            shot = judged.hit(club, speed=row["club_speed"], attack=row["attack"], loft=row["dynamic_loft"])
            found += launched(label(row), (row["ball_speed"], row["launch"], row["spin"]), shot, allowed(club))
        return found

    return compute


def rows(table: str) -> Iterable[dict[str, Any]]:
    """Return the rows of a published table, numbers in SI."""
    columns = {name: values.tolist() for name, values in measurements.table(table).columns.items()}
    return [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]


def of_drive(row: dict[str, Any]) -> str:
    """Name a drive of TrackMan's chart by club speed and attack angle."""
    speed, attack = units.from_si(row["club_speed"], "mph"), units.from_si(row["attack"], "deg")
    return f"{speed:.0f} mph, {attack:+.0f} deg, for {row['optimum_of']}"
