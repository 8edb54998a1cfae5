"""Sweeps: one case over a grid of speeds and lofts, one run on each core, resumable."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem import paper
from clubface.fem.case import Case, case
from clubface.fem.core import Progress
from clubface.fem.result import Impact
from clubface.fem.resumable import ResumableTable
from clubface.fem.side_by_side import workers_of

COLUMNS = (
    "speed_mps", "loft_deg", "ball_speed_mps", "launch_deg", "spin_rpm", "club_speed_after_mps", "peak_force_n",
    "peak_force_time_s", "contact_time_s", "reversal_time_s", "contraction", "f_prime", "f", "energy_error", "steps",
    "stopped",
)  # fmt: skip
"""Columns of the table, one row a run."""

_KINDS: dict[str, Callable[[str], Any]] = {"steps": int, "stopped": str}
MOST = 10_000


def grid(text: str, dimension: str, name: str) -> list[float]:
    """Return the values [SI] of "first:last:step", or of values separated by commas, in m/s, degrees or mm."""
    unit = {"speed": "m/s", "angle": "deg", "length": "mm"}[dimension]
    try:
        if ":" in text:
            first, last, step = (float(each) for each in text.split(":"))
            count = int((last - first) / step + 1.0 + 1e-9) if step > 0.0 else 0
            values = [first + i * step for i in range(min(count, MOST + 1))]
        else:
            values = [float(each) for each in text.split(",")]
    except (ValueError, OverflowError):
        values = []
    if not 1 <= len(values) <= MOST:
        raise InputError(name, text, f'"first:last:step" in {unit}, as in "30:60:5", or values with commas')
    return [units.parse(f"{value!r} {unit}", dimension, name=name) for value in values]


def sweep(
    which: str | os.PathLike[str] | Case,
    *,
    speeds: Sequence[float],
    lofts: Sequence[float],
    output: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> list[dict[str, Any]]:
    """Run a case at every speed and loft.

    Parameters
    ----------
    which
        A :class:`Case`, the name of a built-in one, or the path of a TOML file.
    speeds, lofts
        Clubhead speeds [m/s] and lofts [rad].
    output
        A CSV file. Runs found in the file are not repeated, nor those that an interrupted run has finished.
    workers
        Number of runs at a time, each on one core; the last runs share the cores that are left. If left out: one for
        each core.
    progress
        Called with the number of runs done and the number of runs.

    Returns
    -------
    list
        One mapping of ``COLUMNS`` for each run, in the order of speeds, then lofts.
    """
    base = case(which)
    workers_of(workers)
    points = [(speed, loft) for speed in speeds for loft in lofts]
    if not 1 <= len(points) <= MOST:
        raise InputError("the number of runs of a sweep", len(points), f"1 to {MOST}")
    for speed in (min(speeds), max(speeds)):
        for loft in (min(lofts), max(lofts)):
            base.replace(speed=speed, loft=loft)
    table = ResumableTable(output, _content(base), COLUMNS, _KINDS)

    def run(point: tuple[float, float], keep_going: Progress, threads: int) -> dict[str, Any]:
        each = base.replace(speed=point[0], loft=point[1], settings={"threads": threads})
        return row_of(point, each.run(keep_going))

    places = {point: (point[0], _degrees(point[1])) for point in points}
    return table.fill(places, run, what="runs", workers=workers, progress=progress)


def row_of(point: tuple[float, float], found: Impact) -> dict[str, Any]:
    """Return one row of the table."""
    values = {
        **paper.figures(found),
        "speed_mps": point[0],
        "loft_deg": _degrees(point[1]),
        "contact_time_s": found.contact_time,
        "stopped": found.stopped or "",
    }
    return {name: values[name] for name in COLUMNS}


def _degrees(angle: float) -> float:
    """Return an angle [deg] as it was given: without the rounding of the way to rad and back."""
    return round(units.from_si(angle, "deg"), 9)


def _content(base: Case) -> dict[str, Any]:
    """Return everything in a case but what is swept."""
    delivery = {key: str(value) for key, value in base.delivery.items() if key not in ("speed", "loft")}
    return {
        "ball": base.ball.values(),
        "head": [base.head, base.club],
        "delivery": delivery,
        "friction": base.friction,
        "setting": base.settings.values(),
    }
