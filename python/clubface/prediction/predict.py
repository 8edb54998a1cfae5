"""Launches for a file of deliveries of any length: read, computed and written a chunk at a time."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import FileError, InputError, Told
from clubface.prediction.run import Task, results_of, run
from clubface.prediction.source import open_source
from clubface.recorded.shots import SIDES
from clubface.simulation.air import Air
from clubface.simulation.backends import backend_of
from clubface.simulation.flight_inputs import check_conditions
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import equipped, hand_value
from clubface.simulation.launch import computed_with
from clubface.simulation.run_options import thread_count, tolerance
from clubface.support.checks import check_count
from clubface.support.input_files import recorded, same_file
from clubface.tables.headings import Column
from clubface.tables.writer import is_parquet

CHUNK_ROWS = 16384
MOST_ROWS = 1_000_000
"""In memory at a time."""


@dataclass(frozen=True, kw_only=True)
class PredictReport:
    """What became of a file of deliveries.

    Attributes
    ----------
    source, output
        The files read and written.
    rejects
        The file with the rows that could not be used, or None where there were none.
    rows
        Rows read; each is either written or rejected.
    written, rejected
        Rows with a launch, and rows without.
    blank
        Blank lines passed over.
    used
        Heading of each column used: its quantity and unit.
    passed
        Headings of the columns only passed through.
    added
        Headings of the columns written after them.
    notes
        What a reader of the result should know.
    first_rejects
        Line and reason of the first rejects.
    resumed
        Rows done by an earlier run.
    provenance
        The model, its parameters with source and caveats, club, ball and version.
    """

    source: str
    output: str
    rejects: str | None
    rows: int
    written: int
    rejected: int
    blank: int
    used: Mapping[str, tuple[str, str]]
    passed: tuple[str, ...]
    added: tuple[str, ...]
    notes: tuple[str, ...] = ()
    first_rejects: tuple[tuple[int, str], ...] = ()
    resumed: int = 0
    provenance: Mapping[str, Any] = field(default_factory=dict, repr=False)

    def __str__(self) -> str:
        lines = [f"{self.written} of {self.rows} deliveries computed: {self.output}"]
        if self.rejected:
            lines.append(f"{self.rejected} rejected: {self.rejects}")
            lines += [f"  {line}: {reason}" for line, reason in self.first_rejects]
        lines += [f"note: {note}" for note in self.notes]
        return "\n".join(lines)


@recorded
def predict(
    source: str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club,
    model: str = DEFAULT_MODEL,
    ball: str | os.PathLike[str] | Ball | None = None,
    parameters: Parameters | None = None,
    hand: Any = None,
    accuracy: float | None = None,
    carry: bool = True,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    output: str | os.PathLike[str] | None = None,
    rejects: str | os.PathLike[str] | None = None,
    format: str | None = None,
    mapping: str | os.PathLike[str] | None = None,
    units: Mapping[str, str] | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, Any] | None = None,
    chunk_rows: int = CHUNK_ROWS,
    threads: int | None = None,
    progress: Callable[[float, int], object] | None = None,
    resume: bool = False,
) -> PredictReport:
    """Compute the launch of every delivery in a CSV or Parquet file.

    Columns are found by name and carry their unit, as in ``club_speed_mph`` or ``club_speed [mph]``, or
    ``units`` gives it. Columns of other names are passed through untouched. A row that cannot be used goes to the
    file of rejects with its line and the reason.

    A launch monitor's file, and a table that names clubs or says where on the club its data was taken, is one of
    recorded shots: it is read by :func:`clubface.launch_monitor.read`, and shots of another club are refused. Club data
    that was taken elsewhere is referred to the points of clubface.

    Both files have their names only once they are complete. Until then, what is finished is kept in the folder
    ``<output>.unfinished``, and the same call goes on after it, however the run ended.

    Parameters
    ----------
    source
        A file whose first row names the columns: CSV (commas, semicolons or tabs; decimal commas where the
        delimiter is another), an Excel workbook, or Parquet by its ending.
    club, model, ball, parameters, hand, accuracy, threads
        As for :func:`impact`. A column named like an input wins over the club, ball or hand given here.
    carry
        Whether to compute the flight too.
    air, wind
        As for :func:`fly`.
    output
        The file to write, CSV or Parquet by its ending; ``<source>-launches.csv`` beside the source if left out.
    rejects
        The CSV file for rows that cannot be used; ``<output>.rejects.csv`` beside the output if left out. It is
        written only if there are such rows.
    format, mapping, units
        How a launch monitor's file is laid out, as for :func:`clubface.launch_monitor.read`.
    only, where, mismatch, assume
        Which of the recorded shots to take and what to state for values that were not measured, as for
        :func:`clubface.measured.ready.ready_shots`.
    chunk_rows
        Rows held in memory at a time.
    progress
        Called with the part of the file read, 0 to 1, and the rows done.
    resume
        Whether to refuse to begin anew where a run of other content or settings was interrupted; that of the same ones
        goes on where it stopped.

    Returns
    -------
    PredictReport
        How many rows were written and rejected, which columns were used, and what to know about them.

    Raises
    ------
    FileError
        A file cannot be read or written; the message names the line. It is empty, has no column for the speed or one
        column twice, or a unit has another dimension. Another process is writing the output with other settings,
        or what is to be resumed was begun with another source or other settings.
    KeyboardInterrupt
        Ctrl-C was pressed; the message says where the finished rows are.
    """
    path = Path(source)
    target = Path(output) if output is not None else path.with_name(f"{path.stem}-launches.csv")
    aside = Path(rejects) if rejects is not None else target.with_name(f"{target.stem}.rejects.csv")
    _check_paths(path, target, aside)
    chunk_rows = check_count("chunk_rows", chunk_rows, 1, MOST_ROWS)
    threads, accuracy = thread_count(threads) or None, tolerance(accuracy)
    own, ball = backend_of(model).balls(ball, accuracy)
    with_, chosen = equipped(model, club, ball, parameters)
    arrays = [name for name, value in chosen.values.items() if not isinstance(value, float)]
    if arrays:
        raise InputError(arrays[0], Told("an array"), "a single number for a file of deliveries")
    side = float(with_.club.hand) if hand is None else hand_value(hand)
    if side not in (1.0, -1.0):
        raise InputError("hand", hand, "right or left")
    provenance = computed_with(model, chosen, with_.club, with_.ball, accuracy)
    shot = {
        "club": with_.club,
        "model": model,
        "ball": own or with_.ball,
        "parameters": chosen,
        "accuracy": accuracy,
        "threads": threads,
    }
    if carry:
        check_conditions(air, wind)
    flight = {"air": air, "wind": wind, "threads": threads} if carry else None
    opened = open_source(
        path, with_.club, hand=None if hand is None else SIDES[side], mismatch=mismatch, format=format,
        mapping=mapping, units=units, only=only, where=where, assume=assume,
    )  # fmt: skip
    reader, columns = opened.reader, opened.columns
    try:
        used = columns._replace(used=opened.used)
        task = Task(shot, flight, side, used, results_of(model, carry), provenance, opened.content)
        outcome = run(reader, task, (path, target, aside), chunk_rows, progress, resume)
    finally:
        reader.close()
    rows, written, rejected = outcome.counts["rows"], outcome.counts["written"], outcome.counts["rejected"]
    return PredictReport(
        source=str(path),
        output=str(target),
        rejects=str(aside) if rejected else None,
        rows=rows,
        written=written,
        rejected=rejected,
        blank=reader.blank,
        used={
            each.heading: (each.quantity, each.unit)
            for each in {**_by_quantity(opened.used), **_by_quantity(columns.used)}.values()
        },
        passed=columns.passed,
        added=task.headings,
        notes=(*opened.notes, *([remark] if (remark := outcome.tally.remark()) else [])),
        first_rejects=outcome.first_rejects,
        resumed=outcome.resumed,
        provenance=provenance,
    )


def _by_quantity(columns: Iterable[Column]) -> dict[str, Column]:
    return {each.quantity: each for each in columns}


def _check_paths(source: Path, target: Path, aside: Path) -> None:
    is_parquet(target)
    for path, what in ((target, "output"), (aside, "rejects")):
        if same_file(path, source):
            raise FileError(str(path), None, f"the {what} must be another file than the one that is read")
        if not path.parent.is_dir():
            raise FileError(str(path), None, f"there is no folder {str(path.parent)!r}")
        if path.is_dir():
            raise FileError(str(path), None, f"the {what} is a folder; give the name of a file")
    if same_file(aside, target):
        raise FileError(str(aside), None, "the rejects must go to another file than the output")
