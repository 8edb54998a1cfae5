"""Inference for a whole file of launches: one row a shot, written as it is found, and resumable."""

from __future__ import annotations

import csv
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
from clubface.support.resuming import Journal, complete_lines, cut_incomplete_line, fingerprint, unfinished
from clubface.support.warning import without_warnings

REMARK = "remark"
OTHERS = "of an unfinished file of other settings; finish it with those, or start again without --resume"


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

    The file has ``.part`` in its name until it is complete. After an interruption it holds the shots that are finished.

    Parameters
    ----------
    shots
        Recorded shots with at least one launch quantity.
    output
        Path of a CSV file.
    resume
        Continue where an interrupted run with the same settings stopped.
    progress
        Called with the number of shots done and the number of shots.
    **options
        As for :func:`infer`.

    Raises
    ------
    FileError
        The file cannot be written, or an unfinished one belongs to other settings.
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
    part = unfinished(target)
    content = [shots.source, shots.rows, shots.launches, repr(sorted(options.items()))]
    journal = Journal(unfinished(target, ".json"), fingerprint(content), others=OTHERS)
    headings = ["row", *_headings(wanted, options["prior"].names), "effective", REMARK]
    done = 0
    if resume and part.exists() and journal.read(lambda state: state) is not None:
        cut_incomplete_line(part)
        done = max(0, _finished(part, headings) - 1)
    try:
        if not done:
            journal.write({})
        with part.open("a" if done else "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file, lineterminator="\n")
            if not done:
                out.writerow(headings)
            for place in range(done, len(shots)):
                out.writerow(_row(shots, place, wanted, options))
                file.flush()
                if progress is not None:
                    progress(place + 1, len(shots))
        os.replace(part, target)
        journal.remove()
    except OSError as error:
        raise FileError(str(target), None, f"cannot be written: {error.strerror or error}") from None
    except KeyboardInterrupt:
        message = f"interrupted: finished shots are in {part}; --resume goes on after them"
        raise KeyboardInterrupt(message) from None
    with target.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    without = sum(not row["effective"] for row in rows)
    return InferReport(str(target), len(rows), done, without, sum(bool(row[REMARK]) for row in rows) - without)


def _finished(part: Path, headings: list[str]) -> int:
    """Return the number of rows in an unfinished file, the headings among them; refuse a damaged one."""
    lines = complete_lines(part)
    for number, line in enumerate(lines, 1):
        try:
            (cells,) = csv.reader([line], strict=True)
        except (csv.Error, ValueError):
            cells = []
        if len(cells) != len(headings) or (number == 1 and cells != headings):
            raise FileError(str(part), number, "this is no row of the table; start again without --resume")
    return len(lines)


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
