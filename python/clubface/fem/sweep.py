"""Sweeps of a case over speeds and lofts, one run on each core, and tables of long computations that resume."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from clubface import units
from clubface.errors import FileError, InputError
from clubface.fem import paper
from clubface.fem.case import Case, case
from clubface.fem.core import Progress
from clubface.fem.impact_result import columns_of
from clubface.fem.pictures import sweep_picture
from clubface.fem.result import Impact
from clubface.jobs.engine import Job, run as run_job
from clubface.jobs.store import Finished, Store, unfinished_folder
from clubface.jobs.workers import in_threads, worker_count
from clubface.results.result import Result
from clubface.results.table import Table
from clubface.support.files import prepared_folder
from clubface.support.fingerprint import fingerprint

__all__ = ["grid", "sweep", "sweep_result"]

P = TypeVar("P")


class ResumableTable:
    """Rows by their first two columns, in a CSV file where one is given; its first line has a fingerprint of the case.

    Rows that are finished are kept in a store next to the file until all are, and then written together, those of the
    file that were not asked for this time after them.

    Parameters
    ----------
    path
        The file; None keeps the rows for this run alone.
    content
        The inputs that the rows depend on, by the names that messages use: numbers, texts, arrays, data classes, and
        lists and mappings of these. A table of anything else is refused.
    columns
        Names of the columns.
    kinds
        How to read columns that are no floats.
    """

    def __init__(
        self,
        path: str | os.PathLike[str] | None,
        content: Mapping[str, Any],
        columns: Sequence[str],
        kinds: Mapping[str, Callable[[str], Any]],
    ) -> None:
        self._path = None if path is None else Path(path)
        self._content = content
        self._columns, self._kinds = tuple(columns), kinds
        self._rows: dict[tuple[float, ...], dict[str, Any]] = {}
        self._mark = "# case " + fingerprint(list(content.values()))[:16]
        if self._path is not None:
            prepared_folder(self._path.parent)
            if self._path.exists():
                self._read(self._path)

    def _read(self, path: Path) -> None:
        lines = path.read_bytes().decode(errors="replace").split("\n")[:-1]
        if lines[:1] != [self._mark] or lines[1:2] != [",".join(self._columns)]:
            raise FileError(str(path), 1, "this is not the table of this case; give another file, or remove it")
        # Each line by itself: a quotation mark in a damaged one must not swallow the others.
        for number, line in enumerate(lines[2:], 3):
            try:
                (cells,) = csv.reader([line], strict=True)
                pairs = zip(self._columns, cells, strict=True)
                self._keep({name: self._kinds.get(name, float)(text) for name, text in pairs})
            except (ValueError, csv.Error):
                raise FileError(str(path), number, "this is not a row of the table; remove it") from None

    def fill(
        self,
        places: Mapping[P, tuple[float, float]],
        run: Callable[[P, Progress, int], dict[str, Any]],
        *,
        what: str,
        workers: int | None,
        progress: Callable[[int, int], object] | None,
        is_of: Callable[[P, Mapping[str, Any]], bool] = lambda point, row: True,
    ) -> list[dict[str, Any]]:
        """Run what has no row yet, side by side, a row kept as each ends; return the rows of all.

        Parameters
        ----------
        places
            What is run, and the values of the first two columns of its row.
        run
            As for :func:`clubface.jobs.workers.in_threads`; returns a row.
        what
            What is run, in the plural, for people.
        workers
            Runs at a time; left out, as many as there are cores.
        progress
            Called with the rows there are and the rows in all.
        is_of
            Whether a row that is there is of what is run now; if not, it is run again.
        """
        rows = {point: self._rows[_key(place)] for point, place in places.items() if _key(place) in self._rows}
        rows = {point: row for point, row in rows.items() if is_of(point, row)}
        with self._store(len(rows) == len(places)) as store:
            job = Job(what, list(places), run, lambda point: ",".join(map(repr, places[point])), is_of)
            rows = run_job(job, partial(in_threads, workers=workers), store=store, finished=rows, progress=progress)
            for name in store:
                self._keep(store[name])
            for row in rows.values():
                self._keep(row)
            if self._path is not None and store.folder is not None:
                store.write_result(self._path, lambda file: file.write(self._text(list(rows.values()))))
                store.remove()
        return list(rows.values())

    def _store(self, complete: bool) -> Finished:
        """Return the store of what is not in the table yet."""
        if self._path is None:
            return Finished()
        folder = unfinished_folder(self._path)
        if complete and not folder.exists():
            return Finished()
        remedy = f"finish that with the same command, or remove {folder}"
        return Store(folder, self._content, output=self._path, remedy=remedy)

    def _text(self, first: Sequence[dict[str, Any]]) -> bytes:
        """Return the table, some rows first."""
        text = io.StringIO()
        out = csv.writer(text, lineterminator="\n")
        keys = dict.fromkeys([*map(self._key_of, first), *self._rows])
        for row in (self._rows[key] for key in keys):
            out.writerow([row[name] if isinstance(row[name], str) else repr(row[name]) for name in self._columns])
        return f"{self._mark}\n{','.join(self._columns)}\n{text.getvalue()}".encode()

    def _keep(self, row: dict[str, Any]) -> None:
        self._rows[self._key_of(row)] = row

    def _key_of(self, row: Mapping[str, Any]) -> tuple[float, ...]:
        return _key([row[name] for name in self._columns[:2]])


def _key(place: Sequence[float]) -> tuple[float, ...]:
    """Return values without the rounding of units on their way."""
    return tuple(round(value, 9) for value in place)


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
    source: str | os.PathLike[str] | Case,
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
    source
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
    base = case(source)
    worker_count(workers)
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


def sweep_result(rows: Sequence[Mapping[str, Any]], *, published: bool = False) -> Result:
    """Return a sweep as a result; ``published`` says whether its picture has the numbers of Roh and Lee."""
    shown = ("speed", "loft", "ball_speed", "launch", "spin", "club_speed_after", "peak_force", "f")
    columns = [replace(each, printed=each.name in shown) for each in columns_of(rows, COLUMNS, unit="m/s")]
    return Result(
        kind="sweep", title="Sweep of speeds and lofts", tables=(Table("sweep", tuple(columns)),),
        draw=lambda: [sweep_picture(rows, published=published)],
    )  # fmt: skip


def row_of(point: tuple[float, float], impact: Impact) -> dict[str, Any]:
    """Return one row of the table."""
    values = {
        **paper.figures(impact),
        "speed_mps": point[0],
        "loft_deg": _degrees(point[1]),
        "contact_time_s": impact.contact_time,
        "stopped": impact.stopped or "",
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
