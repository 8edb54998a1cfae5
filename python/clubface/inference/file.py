"""Inference for a whole file of launches: one row a shot, written as it is found, and resumable."""

from __future__ import annotations

import csv
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import FileError, InputError
from clubface.inference.rows import REMARK, Rows
from clubface.recorded.shots import RecordedShots
from clubface.support.resuming import Journal, complete_lines, cut_incomplete_line, fingerprint, unfinished

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
    used
        The quantities of the delivery that were measured and counted, too.
    """

    output: str
    shots: int
    resumed: int
    without: int
    warned: int
    used: tuple[str, ...]


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
        Recorded shots with at least one launch quantity. What they hold of the delivery counts as measured, too.
    output
        Path of a CSV file.
    resume
        Continue where an interrupted run with the same settings stopped.
    progress
        Called with the number of shots done and the number of shots.
    **options
        As for :func:`infer`; ``samples`` are 400 if left out.

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
    rows = Rows(shots, **options)
    part = unfinished(target)
    content = [shots.source, shots.rows, shots.launches, shots.deliveries, repr(sorted(rows.options.items()))]
    journal = Journal(unfinished(target, ".json"), fingerprint(content), others=OTHERS)
    done = 0
    if resume and part.exists() and journal.read(lambda state: state) is not None:
        cut_incomplete_line(part)
        done = max(0, _finished(part, rows.headings) - 1)
    try:
        if not done:
            journal.write({})
        with part.open("a" if done else "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file, lineterminator="\n")
            if not done:
                out.writerow(rows.headings)
            for place in range(done, len(shots)):
                out.writerow(rows.of(place))
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
        written = list(csv.DictReader(file))
    without = sum(not row["effective"] for row in written)
    warned = sum(bool(row[REMARK]) for row in written) - without
    return InferReport(str(target), len(written), done, without, warned, tuple(rows.club))


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
