"""One run over a file of deliveries: what each chunk becomes, and how an interrupted run goes on."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.equipment.models import model as model_named
from clubface.errors import FileError, RangeWarning
from clubface.launch_monitor.summary_rows import summaries_in
from clubface.simulation.flight import fly
from clubface.simulation.flight_inputs import conditions
from clubface.simulation.impact import impact
from clubface.simulation.outside import Tally
from clubface.simulation.own_law import source_of
from clubface.support.input_files import input_file
from clubface.support.resuming import Store, unfinished
from clubface.support.warning import without_warnings
from clubface.tables.headings import HAND, Layout
from clubface.tables.parquet import ParquetForm
from clubface.tables.rows import GONE, Chunk, Reader, Reject
from clubface.tables.writer import CsvForm, Form, RejectsForm, is_parquet
from clubface.units import from_si, to_si

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

COUNTS = ("rows", "written", "rejected")
"""What is counted: rows read, written and rejected."""

PREFIX = "predicted_"
"""Put before the headings written where the file has one of them already."""

REJECTS = ".rejects.csv"
"""How the name of the rejects of a chunk ends."""

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
        prefix = ""
        while any(prefix + heading in columns.headings for heading in results):
            prefix += PREFIX
        self.headings = tuple(prefix + heading for heading in results)

    def content_of(self, source: Path) -> dict[str, Any]:
        """Return what a run is of, by what a person calls it."""
        shot, ball = self.shot, self.shot["ball"]
        law = source_of(shot["model"])
        # The club itself and not its inputs: a meshed one is more than the mass and inertia of its mesh.
        equipment = [shot["club"], ball.inputs() if isinstance(ball, Ball) else ball.values()]
        return {
            "source": input_file(source).sha256,
            "choice of shots": self.content,
            "layout of columns": [self.columns, list(self.results.items())],
            "model": [shot["model"], dict(shot["parameters"].values), shot["parameters"].characteristic_time, law],
            "club or ball": [equipment, self.hand, json.dumps(self.provenance, default=str)],
            "accuracy": shot["accuracy"],
            "air or wind": self.flight and conditions(self.flight["air"], self.flight["wind"]),
        }

    def compute(self, chunk: Chunk) -> tuple[list[int] | None, list[NDArray[Any]], list[Reject], Tally]:
        """Return the rows that have a launch (None: all), their results, the other rows, and those out of range."""
        # Of recorded shots they are left out already.
        reasons = {} if self.content else summaries_in(chunk, self.columns)
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
        tally = Tally().add_all([launch])
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
        return rows, results, sorted([*rejects, *chunk.ragged], key=lambda each: each.line), tally


class Outcome(NamedTuple):
    """What a run has done.

    Attributes
    ----------
    counts
        Rows read, written and rejected, by earlier runs as well.
    first_rejects
        Line and reason of the first rejects.
    tally
        Of shots outside the range of the model.
    resumed
        Rows done by earlier runs.
    """

    counts: Mapping[str, int]
    first_rejects: tuple[tuple[int, str], ...]
    tally: Tally
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
    form, rejects_form = _form(target, reader, task), RejectsForm(task.columns.headings, reader)
    folder = unfinished(target, [source, aside])
    with Store(folder, task.content_of(source), of=target, resume=resume) as store:
        names = _kept(store, target.suffix)
        resumed = done = sum(store[each]["rows"] for each in names)
        try:
            for chunk in reader.chunks(chunk_rows, done):
                read = len(chunk.lines) + len(chunk.ragged)
                names.append(name := f"{done:012d}+{read}")
                if _pieces(store, name, target.suffix) is None:
                    rows, results, rejects, tally = task.compute(chunk)
                    with BytesIO() as file:
                        form.piece(file, chunk, rows, results)
                        sums = [store.keep_part(name + target.suffix, file.getvalue())]
                    if rejects:
                        with BytesIO() as file:
                            rejects_form.piece(file, rejects)
                            sums.append(store.keep_part(name + REJECTS, file.getvalue()))
                    counts = {"rows": read, "written": read - len(rejects), "rejected": len(rejects)}
                    shown = [(each.line, each.reason) for each in rejects[:SHOWN]]
                    told = {"first": done, **counts, "shown": shown, "outside": tally.counts(), "sums": sums}
                    store.keep(name, told)
                done += read
                if progress is not None:
                    progress(reader.progress(), done)
        except KeyboardInterrupt:
            message = f"interrupted: {done} rows are done and kept in {folder}; the same command goes on after them"
            raise KeyboardInterrupt(message) if done else KeyboardInterrupt from None
        if not done:
            raise FileError(reader.path, reader.header_line, "there is no delivery below the names of the columns")
        outcome = _outcome([store[name] for name in names], resumed)
        if outcome.counts["rejected"]:
            store.write_result(
                aside, lambda file: rejects_form.whole(file, _whole_pieces(store, names, target.suffix, 1))
            )
        else:
            # Rejects of an earlier run do not stay beside a file they do not belong to.
            aside.unlink(missing_ok=True)
        store.write_result(target, lambda file: form.whole(file, _whole_pieces(store, names, target.suffix, 0)))
        store.remove()
    return outcome


def _kept(store: Store, ending: str) -> list[str]:
    """Return the names of the chunks that are kept, one after the other from the first row on."""
    by_first = {store[name]["first"]: name for name in store if store[name]["rows"] and _pieces(store, name, ending)}
    names, row = [], 0
    while row in by_first:
        names.append(by_first[row])
        row += store[by_first[row]]["rows"]
    return names


def _pieces(store: Store, name: str, ending: str) -> list[Path] | None:
    """Return the files of a chunk, of launches and of rejects if it has some; None unless it is kept as it was."""
    if name not in store:
        return None
    sums = zip((name + ending, name + REJECTS), store[name]["sums"], strict=False)
    found = [store.part(*each) for each in sums]
    return None if None in found else [each for each in found if each is not None]


def _whole_pieces(store: Store, names: Sequence[str], ending: str, place: int) -> Iterator[Path]:
    """Yield the files of the chunks that have one, each when it is found to be what was written."""
    for name in names:
        if place < len(store[name]["sums"]):
            found = _pieces(store, name, ending)
            if found is None:
                raise FileError(str(store.folder), None, GONE)
            yield found[place]


def _outcome(chunks: Sequence[Mapping[str, Any]], resumed: int) -> Outcome:
    """Return what all chunks come to."""
    tally, shown = Tally(), [tuple(each) for chunk in chunks for each in chunk["shown"]]
    for chunk in chunks:
        tally.add_counts(chunk["outside"])
    counts = {name: sum(chunk[name] for chunk in chunks) for name in COUNTS}
    return Outcome(counts, tuple(shown[:SHOWN]), tally, resumed)


def _form(target: Path, reader: Reader, task: Task) -> Form:
    """Return how the output is written."""
    headings = task.columns.headings
    if not is_parquet(target):
        return CsvForm([*headings, *task.headings], reader)

    types = [reader.schema(place) for place in range(len(headings))]
    return ParquetForm(target, headings, types, task.headings, task.provenance)
