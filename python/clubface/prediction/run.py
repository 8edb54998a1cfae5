"""One run over a file of deliveries: what each chunk becomes, and how an interrupted run goes on."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from clubface.equipment.balls import Ball
from clubface.equipment.models import model as model_named
from clubface.errors import FileError, RangeWarning
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.outside import Tally
from clubface.support.resuming import Journal, fingerprint, unfinished
from clubface.support.warning import without_warnings
from clubface.tables.headings import HAND, Layout
from clubface.tables.rows import Chunk, Reader, Reject
from clubface.tables.writer import CsvWriter, RejectsWriter, Writer, is_parquet
from clubface.units import from_si, to_si

if TYPE_CHECKING:
    from numpy.typing import NDArray

LAUNCH_COLUMNS = {
    "ball_speed_mps": ("ball_speed", "m/s"), "smash": ("smash", "1"), "launch_deg": ("launch", "deg"),
    "azimuth_deg": ("azimuth", "deg"), "backspin_rpm": ("backspin", "rpm"), "sidespin_rpm": ("sidespin", "rpm"),
    "total_spin_rpm": ("total_spin", "rpm"), "spin_axis_deg": ("spin_axis", "deg"),
}  # fmt: skip
FLIGHT_COLUMNS = {
    "carry_m": ("carry", "m"), "side_m": ("side", "m"), "apex_m": ("apex", "m"),
    "landing_deg": ("landing_angle", "deg"),
}  # fmt: skip
CONTACT_COLUMNS = {"contact_time_s": ("contact_time", "s"), "peak_force_n": ("peak_force", "N")}
"""Columns written: quantity and unit by heading."""

STATE: tuple[str, ...] = ("rows", "written", "rejected", "output_bytes", "rejects_bytes")
"""What a journal counts: rows read, written and rejected, and the length of both files."""

PREFIX = "predicted_"
"""Put before the headings written where the file has one of them already."""

SHOWN = 20
"""Rejects a report shows."""


def results_of(model: str, carry: bool) -> dict[str, tuple[str, str]]:
    """Return the columns to write: quantity and unit by heading."""
    found = dict(LAUNCH_COLUMNS)
    if carry:
        found |= FLIGHT_COLUMNS
    if model_named(model).kind == "contact":
        found |= CONTACT_COLUMNS
    return found


class Task:
    """From a chunk of a file to the columns of its launches."""

    def __init__(
        self,
        shot: dict[str, Any],
        flight: dict[str, Any] | None,
        hand: float,
        columns: Layout,
        results: Mapping[str, tuple[str, str]],
        provenance: Mapping[str, Any],
        content: str = "",
    ) -> None:
        self.content = content
        self.shot = shot
        self.provenance = provenance
        self.flight = flight
        self.hand = hand
        self.columns = columns
        self.results = results
        self.tally = Tally()
        prefix = ""
        while any(prefix + heading in columns.headings for heading in results):
            prefix += PREFIX
        self.headings = tuple(prefix + heading for heading in results)

    def settings(self, source: Path, output: Path) -> str:
        """Return a text that is the same only for the same file and settings."""
        shot, flight = self.shot, self.flight or {}
        ball = shot["ball"]
        told_ball = ball.inputs() if isinstance(ball, Ball) else ball.values()
        told = [
            os.path.abspath(source), os.stat(source).st_size, output.suffix, self.columns, list(self.results.items()),
            shot["model"], dict(shot["parameters"].values), shot["parameters"].characteristic_time,
            shot["club"].inputs(), told_ball, shot["accuracy"], self.hand,
            repr(flight.get("air")), repr(flight.get("wind")), self.content,
        ]  # fmt: skip
        return fingerprint(told)

    def compute(self, chunk: Chunk) -> tuple[list[int] | None, list[NDArray[Any]], list[Reject]]:
        """Return the rows that have a launch (None: all), their results, and the other rows."""
        import numpy as np

        reasons: dict[int, str] = {}
        values: dict[str, NDArray[Any]] = {}
        for column in self.columns.used:
            numbers, bad = chunk.numbers(column)
            for row, reason in bad.items():
                reasons.setdefault(row, reason)
            values[column.quantity] = to_si(numbers, column.unit)
        count = len(chunk.lines)
        kept = np.array([row for row in range(count) if row not in reasons], dtype=np.intp) if reasons else None
        if kept is not None:
            values = {name: each[kept] for name, each in values.items()}
        hand = values.pop(HAND, self.hand)
        with without_warnings(RangeWarning):
            launch = impact(delivery=values, hand=hand, on_error="nan", **self.shot)
        self.tally.add(launch)
        sources: list[Any] = [launch]
        problems = {each.row[0]: f"{each.parameter}: {each.reason}" for each in launch.problems}
        if self.flight is not None:
            sources.append(flight := fly(launch, on_error="nan", **self.flight))
            for each in flight.problems:
                problems.setdefault(each.row[0], f"flight: {each.parameter}: {each.reason}")
        results = [
            from_si(next(each for each in sources if name in each.quantities()).get(name), symbol)
            for name, symbol in self.results.values()
        ]
        if problems:
            good = np.array([row for row in range(launch.shape[0]) if row not in problems], dtype=np.intp)
            for row, reason in problems.items():
                reasons[int(kept[row]) if kept is not None else row] = reason
            kept = good if kept is None else kept[good]
            results = [each[good] for each in results]
        rows = None if kept is None else kept.tolist()
        bad_rows = sorted(reasons)
        cells = chunk.texts(bad_rows) if bad_rows else []
        rejects = [Reject(chunk.lines[row], reasons[row], text) for row, text in zip(bad_rows, cells, strict=True)]
        return rows, results, sorted([*rejects, *chunk.ragged], key=lambda each: each.line)


class Outcome(NamedTuple):
    """What a run has done.

    Attributes
    ----------
    counts
        Rows read, written and rejected, by earlier runs as well.
    first_rejects
        Line and reason of the first rejects of this run.
    resumed
        Rows done by earlier runs.
    """

    counts: Mapping[str, int]
    first_rejects: tuple[tuple[int, str], ...]
    resumed: int


def run(
    reader: Reader,
    task: Task,
    paths: tuple[Path, Path, Path],
    chunk_rows: int,
    progress: Callable[[float, int], object] | None,
    resume: bool,
) -> Outcome:
    """Compute the rows of a file; ``paths`` are those of the file, the output and the rejects."""
    source, target, aside = paths
    part, aside_part = unfinished(target), unfinished(aside)
    journal = Journal(unfinished(target, ".json"), task.settings(source, target))
    state = journal.read(lambda told: {name: int(told[name]) for name in STATE}) if resume else None
    begun = state or dict.fromkeys(STATE, 0)
    done, shown = dict(begun), []
    writer = _open_writer(part, reader, task, begun if state else None)
    aside_writer = RejectsWriter(aside_part, reader, task.columns.headings, begun["rejects_bytes"] or None)
    try:
        for chunk in reader.chunks(chunk_rows, begun["rows"]):
            rows, results, rejects = task.compute(chunk)
            with _undisturbed():
                writer.write(chunk, rows, results)
                aside_writer.write(rejects)
                written = len(chunk.lines) + len(chunk.ragged) - len(rejects)
                done["rows"] += written + len(rejects)
                done["written"] += written
                done["rejected"] += len(rejects)
                done["output_bytes"], done["rejects_bytes"] = writer.place(), aside_writer.place()
                journal.write(done)
            shown += [(each.line, each.reason) for each in rejects[: SHOWN - len(shown)]]
            if progress is not None:
                progress(reader.progress(), done["rows"])
        if not done["rows"]:
            raise FileError(reader.path, reader.header_line, "there is no delivery below the names of the columns")
    except BaseException as error:
        writer.close()
        aside_writer.close()
        if not done["rows"]:
            for path in (part, aside_part, journal.path):
                path.unlink(missing_ok=True)
        elif isinstance(error, KeyboardInterrupt):
            message = f"interrupted: {done['rows']} rows are done and kept in {part}; resume goes on after them"
            raise KeyboardInterrupt(message) from None
        raise
    writer.close()
    aside_writer.close()
    _finish(part, target, aside_part, aside, done["rejected"])
    journal.remove()
    return Outcome(done, tuple(shown), begun["rows"])


def _open_writer(part: Path, reader: Reader, task: Task, begun: Mapping[str, int] | None) -> Writer:
    """Open the output, new or to go on with."""
    headings = task.columns.headings
    if not is_parquet(part):
        keep = begun["output_bytes"] if begun else None
        if keep is not None and not (part.exists() and part.stat().st_size >= keep):
            raise FileError(str(part), None, "the unfinished file is gone; start again without resuming")
        return CsvWriter(part, [*headings, *task.headings], reader, keep)
    from clubface.tables.parquet import ParquetWriter

    types = [reader.schema(place) for place in range(len(headings))]
    if begun is None:
        return ParquetWriter(part, headings, types, task.headings, task.provenance)
    earlier = part.with_name(f"{part.stem}.earlier{part.suffix}")
    if part.exists():
        os.replace(part, earlier)
    writer = ParquetWriter(part, headings, types, task.headings, task.provenance)
    writer.copy(earlier)
    earlier.unlink()
    return writer


def _finish(part: Path, target: Path, aside_part: Path, aside: Path, rejected: int) -> None:
    """Give the files their names; rejects of an earlier run do not stay beside a file they do not belong to."""
    if rejected:
        os.replace(aside_part, aside)
    else:
        aside.unlink(missing_ok=True)
    os.replace(part, target)


@contextmanager
def _undisturbed() -> Any:
    """Put off Ctrl-C until what must be done as a whole is done."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    caught: list[Any] = []
    before = signal.signal(signal.SIGINT, lambda *_: caught.append(True))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if caught:
        raise KeyboardInterrupt
