"""Restitution and characteristic time over the face of a meshed head, one point on each core."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from typing import Any

from clubface import units
from clubface.errors import InputError, RangeWarning, RunError
from clubface.fem import head_tests
from clubface.fem.balls import ball
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead, head
from clubface.fem.heads.read import Design
from clubface.fem.resumable import ResumableTable
from clubface.fem.run import AnyBall
from clubface.fem.side_by_side import workers_of
from clubface.simulation.impact import impact
from clubface.support.warning import without_warnings

COLUMNS = ("toe_mm", "high_mm", "restitution", "characteristic_time_us", "stopped")
"""Columns of the table, one row a point."""
MOST = 1_000


def face_map(
    which: str | os.PathLike[str] | MeshedHead | Design,
    *,
    toes: Sequence[float],
    highs: Sequence[float],
    with_ball: AnyBall = None,
    output: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> list[dict[str, Any]]:
    """Simulate restitution and characteristic time of a head at points of its face.

    Parameters
    ----------
    which
        The head, as for :func:`clubface.fem.head`.
    toes, highs
        Distances of the points from the face centre [m], towards the toe and upwards.
    with_ball
        The ball for the restitution, as for :func:`clubface.fem.ball`.
    output
        A CSV file. Points found in the file are not computed again, nor those that an interrupted run has finished.
    workers
        Number of points at a time, each on one core; the last points share the cores that are left. If left out: one
        for each core.
    progress
        Called with the number of points done and the number of points.

    Returns
    -------
    list
        One mapping of ``COLUMNS`` for each point, in the order of ``highs``, then ``toes``: the results of
        :func:`clubface.fem.head_tests.restitution` and :func:`clubface.fem.head_tests.characteristic_time`. If a run
        failed, both are NaN, and ``stopped`` says why.

    Raises
    ------
    ShotError
        A point lies outside the face.
    """
    workers_of(workers)
    made, struck = head(which), ball(with_ball)
    points = [(float(toe), float(high)) for high in highs for toe in toes]
    if not 1 <= len(points) <= MOST:
        raise InputError("the number of points of a face", len(points), f"1 to {MOST}")
    with without_warnings(RangeWarning):
        for toe, high in points:
            # A reduced model refuses points outside the face.
            impact(made.club, speed=head_tests.COR_SPEED, loft=0.0, toe=toe, high=high, ball=struck.rigid)

    def measure(point: tuple[float, float], keep_going: Progress, threads: int) -> dict[str, Any]:
        where: dict[str, Any] = {"toe": point[0], "high": point[1], "threads": threads, "progress": keep_going}
        try:
            restitution = head_tests.restitution(made, which=struck, **where)
            return _row(point, restitution, head_tests.characteristic_time(made, **where))
        except RunError as error:
            return _row(point, math.nan, math.nan, str(error))

    # What the tests are of is part of what a row means.
    tests = [head_tests.COR_SPEED, head_tests.STRIKER_SPEED, head_tests.striker().values()]
    content = {"head": made, "ball": struck.values(), "test": tests}
    table = ResumableTable(output, content, COLUMNS, {"stopped": str})
    places = {point: _millimetres(point) for point in points}
    return table.fill(places, measure, what="points", workers=workers, progress=progress)


def _row(point: tuple[float, float], restitution: float, time: float, stopped: str = "") -> dict[str, Any]:
    return dict(zip(COLUMNS, (*_millimetres(point), restitution, units.from_si(time, "us"), stopped), strict=True))


def _millimetres(point: tuple[float, float]) -> tuple[float, float]:
    """Return a point [mm] as it was given: without the rounding of the way to m and back."""
    toe, high = (round(units.from_si(value, "mm"), 9) for value in point)
    return toe, high
