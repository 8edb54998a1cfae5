"""Sweeps: one case over a grid of speeds and lofts, a run a core, resumable."""

from __future__ import annotations

import csv
import hashlib
import json
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from clubface import units
from clubface.errors import FileError, InputError
from clubface.fem import paper
from clubface.fem.case import Case, case
from clubface.fem.core import Progress
from clubface.fem.result import Impact
from clubface.fem.side_by_side import side_by_side, workers_of

COLUMNS = (
    "speed_mps", "loft_deg", "ball_speed_mps", "launch_deg", "spin_rpm", "club_speed_after_mps", "peak_force_n",
    "peak_force_time_s", "contact_time_s", "reversal_time_s", "contraction", "f_prime", "f", "energy_error", "steps",
    "wall_s", "stopped",
)  # fmt: skip
"""Columns of the table, one row a run."""

_KINDS: dict[str, Callable[[str], Any]] = {"steps": int, "stopped": str}
MOST = 10_000


def grid(text: str, dimension: str, name: str) -> list[float]:
    """Return the values [SI] of "first:last:step", or of values with commas, in m/s, degrees or mm."""
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
        [m/s], [rad].
    output
        A CSV file: each run is added as it ends, and runs found there are not repeated.
    workers
        Runs at a time, each on one core; left out, as many as there are cores.
    progress
        Called with the runs done and the runs in all.

    Returns
    -------
    list
        One mapping of ``COLUMNS`` a run, in the order of speeds, then lofts.
    """
    base = case(which)
    workers = workers_of(workers)
    points = [(speed, loft) for speed in speeds for loft in lofts]
    if not 1 <= len(points) <= MOST:
        raise InputError("the runs of a sweep", len(points), f"1 to {MOST}")
    for speed in (min(speeds), max(speeds)):
        for loft in (min(lofts), max(lofts)):
            base.replace(speed=speed, loft=loft)
    table = _Table(base, output)
    done = {point: table.find(point) for point in points}

    def run(point: tuple[float, float], keep_going: Progress) -> Impact:
        return base.replace(speed=point[0], loft=point[1], settings={"threads": 1}).run(keep_going)

    def ended(point: tuple[float, float], found: Impact) -> None:
        done[point] = table.add(point, found)
        if progress is not None:
            progress(sum(row is not None for row in done.values()), len(points))

    try:
        side_by_side([point for point, row in done.items() if row is None], run, ended, workers=workers)
    except KeyboardInterrupt:
        count = sum(row is not None for row in done.values())
        kept = "" if output is None else f"; they are in {os.fspath(output)}, and the same sweep goes on after them"
        raise KeyboardInterrupt(f"{count} of {len(points)} runs are done{kept}") from None
    return [row for row in done.values() if row is not None]


def row_of(point: tuple[float, float], found: Impact) -> dict[str, Any]:
    """Return one row of the table."""
    values = {
        **paper.document(found),
        "speed_mps": point[0],
        "loft_deg": _degrees(point[1]),
        "contact_time_s": found.contact_time,
        "stopped": found.stopped or "",
    }
    return {name: values[name] for name in COLUMNS}


class _Table:
    """Runs already done, in a file where one is given; its first line tells which case they belong to."""

    def __init__(self, base: Case, path: str | os.PathLike[str] | None) -> None:
        self._path = None if path is None else Path(path)
        self._rows: dict[tuple[float, float], dict[str, Any]] = {}
        self._mark = "# case " + _fingerprint(base)
        if self._path is None:
            return
        if self._path.exists():
            self._read(self._path)
        else:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._path.write_text(f"{self._mark}\n{','.join(COLUMNS)}\n", encoding="utf-8")

    def _read(self, path: Path) -> None:
        lines = path.read_text(encoding="utf-8").split("\n")
        if lines[:1] != [self._mark] or lines[1:2] != [",".join(COLUMNS)]:
            raise FileError(str(path), 1, "this is not the table of this case; give another file, or remove it")
        # A last line without its end was being written when the run was cut off.
        complete = lines[2:-1]
        for number, line in enumerate(csv.reader(complete), 3):
            try:
                row = {name: _KINDS.get(name, float)(text) for name, text in zip(COLUMNS, line, strict=True)}
            except ValueError:
                raise FileError(str(path), number, "this is not a row of a sweep; remove it") from None
            self._rows[row["speed_mps"], round(row["loft_deg"], 9)] = row
        path.write_text("\n".join([*lines[:2], *complete, ""]), encoding="utf-8")

    def find(self, point: tuple[float, float]) -> dict[str, Any] | None:
        return self._rows.get((point[0], _degrees(point[1])))

    def add(self, point: tuple[float, float], found: Impact) -> dict[str, Any]:
        row = row_of(point, found)
        if self._path is not None:
            with self._path.open("a", encoding="utf-8", newline="") as file:
                texts = [value if isinstance(value, str) else repr(value) for value in row.values()]
                csv.writer(file, lineterminator="\n").writerow(texts)
        return row


def _degrees(angle: float) -> float:
    """Return an angle [deg] as it was given: without the rounding of the way to rad and back."""
    return round(units.from_si(angle, "deg"), 9)


def _fingerprint(base: Case) -> str:
    """Return a mark of everything in a case but what is swept."""
    delivery = {key: str(value) for key, value in base.delivery.items() if key not in ("speed", "loft")}
    club = None if base.club is None else str(base.club)
    content = [base.ball.values(), base.head, club, delivery, base.friction, base.settings.values()]
    return hashlib.sha256(json.dumps(content, default=str, sort_keys=True).encode()).hexdigest()[:16]
