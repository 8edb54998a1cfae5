"""Inference for a whole file of launches: one row a shot, written as it is found, and resumable."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import FileError, InputError
from clubface.inference.rows import Rows
from clubface.recorded.shots import RecordedShots
from clubface.support.input_files import input_file
from clubface.support.resuming import Store, unfinished
from clubface.support.shipped import is_path
from clubface.tables.writer import csv_lines


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
        Whether to refuse to begin anew where a run with other settings was interrupted; that of the same ones goes on.
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
    content = {
        "set of measured shots": [shots.rows, shots.launches, shots.deliveries, shots.hand],
        "point of measurement": [shots.speed_at, shots.face_at],
        "club, prior or option": {name: _with_content(value) for name, value in rows.options.items()},
    }
    folder = unfinished(target, [shots.source])
    with Store(folder, content, of=target, resume=resume) as store:
        resumed = len(store)
        try:
            for place in range(len(shots)):
                store.once(str(place), partial(rows.of, place))
                if progress is not None:
                    progress(place + 1, len(shots))
        except KeyboardInterrupt:
            message = f"interrupted: {len(store)} finished shots are in {folder}; the same command goes on after them"
            raise KeyboardInterrupt(message) if len(store) else KeyboardInterrupt from None
        written = [store[str(place)] for place in range(len(shots))]
        text = csv_lines([rows.headings, *written], ",")
        store.write_result(target, lambda file: file.write(text))
        store.remove()
    without = sum(row[-2] == "" for row in written)
    warned = sum(bool(row[-1]) for row in written) - without
    return InferReport(str(target), len(written), resumed, without, warned, tuple(rows.club))


def _with_content(value: Any) -> Any:
    """Return an option, and for the name of a file what the file holds."""
    return input_file(value).sha256 if is_path(value) else value
