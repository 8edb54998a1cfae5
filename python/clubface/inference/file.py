"""Inference for a whole file of launches: one row a shot, kept as it is found, and resumable."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.clubs import club
from clubface.errors import FileError, InputError, RangeWarning
from clubface.inference.expectation import UnreachableLaunchError
from clubface.inference.posterior import unit_of
from clubface.inference.prior import prior_of
from clubface.inference.run import infer
from clubface.measured.shots import QUANTITIES
from clubface.recorded.shots import RecordedShots
from clubface.support.resuming import Store, fingerprint_of_file, unfinished
from clubface.support.warning import without_warnings

REMARK = "remark"


class InferReport(NamedTuple):
    """Result of the inference for a file of launches.

    Attributes
    ----------
    output
        The file written.
    shots
        Number of rows in it.
    resumed
        Number of rows that an earlier run found.
    without
        Number of rows without a delivery; their remark says why.
    warned
        Number of rows with a delivery and a warning.
    """

    output: str
    shots: int
    resumed: int
    without: int
    warned: int


def infer_shots(
    shots: RecordedShots,
    output: str | os.PathLike[str],
    *,
    resume: bool = False,
    progress: Callable[[int, int], object] | None = None,
    **options: Any,
) -> InferReport:
    """Infer the delivery of every shot, and write mean, standard deviation and 95% interval of each quantity as CSV.

    The file has its name only once it is complete. Until then, the shots that are finished are kept in the folder
    ``<output>.unfinished``.

    Parameters
    ----------
    shots
        Recorded shots with at least one launch quantity.
    output
        Path of a CSV file.
    resume
        Continue where an interrupted run with the same shots and settings stopped.
    progress
        Called with the number of shots done and the number of shots.
    **options
        As for :func:`infer`.

    Raises
    ------
    FileError
        The file cannot be written, another process is writing it, or an unfinished one belongs to other shots or
        settings.
    KeyboardInterrupt
        On Ctrl-C; the message says where the finished rows are.
    """
    target = Path(output)
    if target.suffix.lower() != ".csv":
        raise InputError("output", str(output), "a file ending in .csv")
    if target.exists() and os.path.exists(shots.source) and target.samefile(shots.source):
        raise FileError(str(target), None, "the output must be another file than the one that is read")
    if not target.parent.is_dir():
        raise FileError(str(target), None, f"there is no folder {str(target.parent)!r}")
    wanted = [name for name in QUANTITIES if name in shots.launches]
    if not wanted:
        raise InputError("shots", shots.source, f"shots with a measured launch: {', '.join(QUANTITIES)}")
    head = club(options.pop("club"))
    options = {**options, "club": head, "prior": prior_of(options.get("prior"), head)}
    content = {
        "source": _with_content(shots.source),
        "set of launches": [shots.rows, shots.launches],
        "club, prior or option": {name: _with_content(value) for name, value in options.items()},
    }
    folder = unfinished(target, [shots.source])
    with Store(folder, content, of=target, resume=resume) as store:
        resumed = len(store)
        try:
            for place in range(resumed, len(shots)):
                store.keep(str(place), _row(shots, place, wanted, options))
                if progress is not None:
                    progress(place + 1, len(shots))
        except KeyboardInterrupt:
            message = f"interrupted: {len(store)} finished shots are in {folder}; --resume goes on after them"
            raise KeyboardInterrupt(message) if len(store) else KeyboardInterrupt from None
        rows = [store[str(place)] for place in range(len(shots))]
        headings = ["row", *_headings(wanted, options["prior"].names), "effective", REMARK]
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([headings, *rows])
        with store.result(target) as file:
            file.write(text.getvalue().encode())
        store.remove()
    without = sum(row[-2] == "" for row in rows)
    return InferReport(str(target), len(rows), resumed, without, sum(bool(row[-1]) for row in rows) - without)


def _with_content(value: Any) -> Any:
    """Return an option, and for the name of a file what the file holds."""
    named = isinstance(value, (str, os.PathLike)) and os.path.isfile(value)
    return fingerprint_of_file(value) if named else value


def _headings(wanted: list[str], names: Iterable[str]) -> list[str]:
    """Return the headings of measured quantities, and four of each uncertain one."""
    found = [_heading(name, QUANTITIES[name]) for name in wanted]
    for name in names:
        column = _heading(name, unit_of(name))
        found += [
            column,
            *(column.replace(_spelled(name), f"{_spelled(name)}_{each}", 1) for each in ("std", "from", "to")),
        ]
    return found


def _spelled(name: str) -> str:
    return "club_speed" if name == "speed" else name


def _heading(name: str, unit: str) -> str:
    return f"{_spelled(name)}_{unit}" if unit.isalnum() else f"{_spelled(name)} [{unit}]"


def _row(shots: RecordedShots, place: int, wanted: list[str], options: Mapping[str, Any]) -> list[Any]:
    """Return the cells of one shot; one that cannot be inferred says why in its last."""
    launch = {name: float(shots.launches[name][place]) for name in wanted}
    cells: list[Any] = [int(shots.rows[place]), *(_cell(launch[name], QUANTITIES[name]) for name in wanted)]
    names = options["prior"].names
    measured = {name: value for name, value in launch.items() if np.isfinite(value)}
    if not measured:
        return [*cells, *[""] * (4 * len(names)), "", "nothing of the launch was measured"]
    try:
        with without_warnings(RangeWarning):
            found = infer(measured, **options)
    except UnreachableLaunchError as error:
        return [*cells, *[""] * (4 * len(names)), "", str(error)]
    for name in names:
        values = (found.mean[name], found.deviation[name], *found.interval(name))
        cells += [_cell(value, unit_of(name)) for value in values]
    remarks = [*found.warnings, *([found.outside] if found.outside else [])]
    return [*cells, round(found.effective), "; ".join(remarks)]


def _cell(value: float, unit: str) -> str:
    return "" if math.isnan(value) else f"{float(units.from_si(value, unit)):.6g}"
