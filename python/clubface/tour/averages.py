"""The published averages of the tours, club by club."""

from __future__ import annotations

from typing import NamedTuple

from clubface import measurements
from clubface.equipment.clubs import TOUR_CLUBS
from clubface.measurements import PublishedTable
from clubface.support.checks import check_choice

TABLES = {"pga-2023": None, "pga-2019": "PGA Tour", "lpga-2019": "LPGA Tour"}
"""The published tables that models are compared with, each with the group whose published dynamic lofts belong to it.
The LPGA Tour's of 2023 is not among them, since one of its spins looks misprinted."""
DEFAULT_TABLE = "pga-2023"


class Average(NamedTuple):
    """The published averages of one club, SI.

    Attributes
    ----------
    club
        Its name, that of a built-in club.
    club_speed, attack
        Delivery [m/s, rad].
    ball_speed, launch, spin
        Launch [m/s, rad, rad/s].
    apex, landing_angle, carry
        Flight [m, rad, m].
    """

    club: str
    club_speed: float
    attack: float
    ball_speed: float
    launch: float
    spin: float
    apex: float
    landing_angle: float
    carry: float


def averages(table: str = DEFAULT_TABLE) -> list[Average]:
    """Return the rows of a table of ``TABLES``, driver to pitching wedge, for which there is a built-in club."""
    found = published_table(table)
    rows = zip(*(found[name].tolist() for name in Average._fields), strict=True)
    return [row for row in map(Average._make, rows) if row.club in TOUR_CLUBS]


def published_lofts(table: str) -> dict[str, float]:
    """Return the published dynamic lofts [rad] that belong to a table of ``TABLES``, by club."""
    published_table(table)
    lofts = measurements.table("dynamic-lofts")
    rows = zip(lofts["group"], lofts["club"], lofts["dynamic_loft"], strict=True)
    return {str(club): float(loft) for group, club, loft in rows if group == TABLES[table]}


def published_table(name: str) -> PublishedTable:
    """Return a table of ``TABLES``."""
    check_choice("table of tour averages", name, TABLES)
    return measurements.table(name)
