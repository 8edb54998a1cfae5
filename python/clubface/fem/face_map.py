"""Restitution and characteristic time over the face of a meshed head, a point a core."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from typing import Any

from clubface import units
from clubface.errors import InputError, RunError
from clubface.fem import head_tests
from clubface.fem.balls import Ball, ball
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead
from clubface.fem.run import rigid_ball
from clubface.fem.side_by_side import side_by_side
from clubface.impact import impact

COLUMNS = ("toe_mm", "high_mm", "restitution", "characteristic_time_us", "stopped")
"""Columns of the table, one row a point."""
MOST = 1_000


def face_map(
    head: MeshedHead,
    *,
    toes: Sequence[float],
    highs: Sequence[float],
    which: str | os.PathLike[str] | Ball = "modern",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> list[dict[str, Any]]:
    """Measure a head at points of its face.

    Parameters
    ----------
    head
        The head.
    toes, highs
        Offsets from the face centre [m].
    which
        The ball of the test of restitution.
    workers
        Points at a time, each on one core; left out, as many as there are cores.
    progress
        Called with the points done and the points in all.

    Returns
    -------
    list
        One mapping of ``COLUMNS`` a point, in the order of ``highs``, then ``toes``: what
        :func:`clubface.fem.head_tests.restitution` and :func:`clubface.fem.head_tests.characteristic_time` find there.
        Where a run failed both are NaN, and ``stopped`` tells why.

    Raises
    ------
    ShotError
        A point outside the face.
    """
    struck = ball(which)
    points = [(float(toe), float(high)) for high in highs for toe in toes]
    if not 1 <= len(points) <= MOST:
        raise InputError("the points of a face", len(points), f"1 to {MOST}")
    for toe, high in points:
        # The quickest model refuses points outside the face.
        impact(head.club, speed=head_tests.COR_SPEED, loft=0.0, toe=toe, high=high, ball=rigid_ball(struck))
    rows: dict[tuple[float, float], dict[str, Any]] = {}

    def measure(point: tuple[float, float], keep_going: Progress) -> dict[str, Any]:
        where: dict[str, Any] = {"toe": point[0], "high": point[1], "threads": 1, "progress": keep_going}
        try:
            restitution = head_tests.restitution(head, which=struck, **where)
            return _row(point, restitution, head_tests.characteristic_time(head, **where))
        except RunError as error:
            return _row(point, math.nan, math.nan, str(error))

    def ended(point: tuple[float, float], row: dict[str, Any]) -> None:
        rows[point] = row
        if progress is not None:
            progress(len(rows), len(points))

    side_by_side(dict.fromkeys(points), measure, ended, workers=workers)
    return [rows[point] for point in points]


def _row(point: tuple[float, float], restitution: float, time: float, stopped: str = "") -> dict[str, Any]:
    places = (round(units.from_si(value, "mm"), 9) for value in point)
    return dict(zip(COLUMNS, (*places, restitution, time * 1e6, stopped), strict=True))
