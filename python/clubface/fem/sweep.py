"""Sweeps of a case over speeds and lofts, one run per core."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem import paper
from clubface.fem.case import Case, case
from clubface.fem.core import Progress
from clubface.fem.impact_result import columns_of
from clubface.fem.pictures import sweep_picture
from clubface.jobs.engine import Job, Place, Row, run_table
from clubface.jobs.workers import worker_count
from clubface.results.result import Result
from clubface.results.table import Table

__all__ = ["grid", "sweep", "sweep_result"]

COLUMNS = (
    "speed_mps", "loft_deg", "ball_speed_mps", "launch_deg", "spin_rpm", "club_speed_after_mps", "peak_force_n",
    "peak_force_time_s", "contact_time_s", "reversal_time_s", "contraction", "f_prime", "f", "energy_error", "steps",
    "stopped",
)  # fmt: skip
"""Columns of the table, one row per run."""
MOST = 10_000


def grid(text: str, dimension: str, name: str) -> list[float]:
    """Return the values [SI] of a list "first:last:step" or "a,b,c", given in m/s, degrees or mm."""
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
        raise InputError(name, text, f'"first:last:step" in {unit}, as in "30:60:5", or values separated by commas')
    return [units.parse(f"{value!r} {unit}", dimension, name=name) for value in values]


def sweep(
    source: str | os.PathLike[str] | Case,
    *,
    speeds: Sequence[float],
    lofts: Sequence[float],
    output: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> list[Row]:
    """Run a case at every speed and loft.

    Parameters
    ----------
    source
        A :class:`Case`, the name of a built-in one, or the path of a TOML file.
    speeds, lofts
        Clubhead speeds [m/s] and lofts [rad].
    output, workers, progress
        As for :func:`clubface.fem.head_tests.face_map`, with runs in place of points.

    Returns
    -------
    list
        One mapping of ``COLUMNS`` per run, in the order of speeds, then lofts.
    """
    base = case(source)
    worker_count(workers)
    points = [(speed, loft) for speed in speeds for loft in lofts]
    if not 1 <= len(points) <= MOST:
        raise InputError("number of runs in the sweep", len(points), f"1 to {MOST}")
    for speed in (min(speeds), max(speeds)):
        for loft in (min(lofts), max(lofts)):
            base.replace(speed=speed, loft=loft)
    # Lofts in deg as entered, without rounding errors from the conversion to rad and back.
    lofts_of = {(speed, round(units.from_si(loft, "deg"), 9)): loft for speed, loft in points}
    content = {
        "ball": base.ball.values(), "head": [base.head, base.club],
        "delivery": {key: str(value) for key, value in base.delivery.items() if key not in ("speed", "loft")},
        "friction": base.friction, "setting": base.settings.values(),
    }  # fmt: skip

    def run(place: Place, keep_going: Progress, threads: int) -> Row:
        loft = lofts_of[place]
        impact = base.replace(speed=place[0], loft=loft, settings={"threads": threads}).run(keep_going)
        values = paper.figures(impact) | {
            "speed_mps": place[0], "loft_deg": place[1], "contact_time_s": impact.contact_time,
            "stopped": impact.stopped or "",
        }  # fmt: skip
        return {name: values[name] for name in COLUMNS}

    columns: dict[str, Callable[[str], Any]] = {**dict.fromkeys(COLUMNS, float), "steps": int, "stopped": str}
    job = Job("runs", list(lofts_of), run)
    return run_table(job, output, content, columns, workers=workers, progress=progress)


def sweep_result(rows: Sequence[Mapping[str, Any]], *, published: bool = False) -> Result:
    """Return a sweep as a result; ``published`` adds Roh and Lee's values to its picture."""
    shown = ("speed", "loft", "ball_speed", "launch", "spin", "club_speed_after", "peak_force", "f")
    columns = [replace(each, printed=each.name in shown) for each in columns_of(rows, COLUMNS, unit="m/s")]
    return Result(
        kind="sweep", title="Sweep of speeds and lofts", tables=(Table("sweep", tuple(columns)),),
        draw=lambda: [sweep_picture(rows, published=published)],
    )  # fmt: skip
