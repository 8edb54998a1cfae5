"""Predicting launches for a file of deliveries of any length, a chunk at a time."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, model as model_named
from clubface.errors import FileError, InputError, RangeWarning, Wording
from clubface.jobs.store import Store, unfinished_folder
from clubface.results.notes import Note, free_text, note
from clubface.results.result import Computation, Described, Provenance, Result
from clubface.results.table import table, text
from clubface.shots.prediction_source import Source, open_source
from clubface.shots.recorded import SIDES
from clubface.shots.summary_rows import summaries_in
from clubface.shots.tables.cells import PARTS_MISSING, Chunk, Reject
from clubface.shots.tables.headings import HAND, ColumnLayout
from clubface.shots.tables.parquet import ParquetForm
from clubface.shots.tables.writer import CsvForm, csv_lines, is_parquet, join_csv
from clubface.simulation.flight import AirLike, WindLike, check_conditions, conditions, fly
from clubface.simulation.impact import Parameters, Tally, backend_of, impact
from clubface.simulation.inputs import HandLike, equipped, hand_value, thread_count, tolerance
from clubface.simulation.launch import computed_with, variant_caveats
from clubface.simulation.own_law import source_of
from clubface.simulation.provenance import model_sources
from clubface.support.arrays import ValueLike
from clubface.support.checks import check_count, without_warnings
from clubface.support.files import input_file, recorded, same_file
from clubface.units import from_si, show, to_si

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
"""Quantity and unit of the columns written, by heading."""

COUNTS = ("rows", "written", "rejected")
"""Names of the counts: rows read, written and rejected."""

PREFIX = "predicted_"
"""Prefix of the headings written if the file already has one of them."""

REJECTS = ".rejects.csv"
"""Ending of the file of a chunk's rejects."""

SHOWN = 20
"""Maximum number of rejects in a report."""


def results_of(model: str, carry: bool) -> dict[str, tuple[str, str]]:
    """Return the columns to write: quantity and unit by heading."""
    is_contact = model_named(model).kind == "contact"
    return LAUNCH_COLUMNS | (FLIGHT_COLUMNS if carry else {}) | (CONTACT_COLUMNS if is_contact else {})


@dataclass(frozen=True, kw_only=True)
class PredictionTask:
    """Computes the columns of launches for a chunk of a file."""

    shot: dict[str, Any]  # arguments of impact
    flight: dict[str, Any] | None  # arguments of fly, None for no flights
    hand: float
    columns: ColumnLayout
    results: Mapping[str, tuple[str, str]]  # quantity and unit of each column to write
    provenance: Mapping[str, Any]
    content: str = ""  # fingerprint of recorded shots

    @cached_property
    def headings(self) -> tuple[str, ...]:
        """Headings of the columns to write, with a prefix if the file already has one of them."""
        prefix = ""
        while any(prefix + heading in self.columns.headings for heading in self.results):
            prefix += PREFIX
        return tuple(prefix + heading for heading in self.results)

    def content_of(self, source: Path) -> dict[str, Any]:
        """Return everything a run depends on, by the names used in errors."""
        shot, ball = self.shot, self.shot["ball"]
        law = source_of(shot["model"])
        # The club itself rather than its inputs: a meshed club is more than its mass and inertia.
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
        """Return the rows with a launch (None: all), their results, the rejected rows, and shots out of range."""
        # Recorded shots have no summary rows left.
        reasons = {} if self.content else summaries_in(chunk, self.columns)
        values: dict[str, NDArray[Any]] = {}
        for column in self.columns.used:
            if chunk.deliveries is None:
                numbers, bad = chunk.numbers(column)
                values[column.quantity] = to_si(numbers, column.unit)
            else:
                values[column.quantity] = known = chunk.deliveries[column.quantity]
                reason = f'{column.heading}: not measured; --assume "{column.quantity}=..." states a value'
                bad = dict.fromkeys(np.flatnonzero(np.isnan(known)).tolist(), reason)
            for row, reason in bad.items():
                reasons.setdefault(row, reason)
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
        cells = chunk.texts(bad_rows)
        rejects = [Reject(chunk.lines[row], reasons[row], text) for row, text in zip(bad_rows, cells, strict=True)]
        return rows, results, sorted([*rejects, *chunk.ragged], key=lambda each: each.line), tally


def run(
    opened: Source,
    task: PredictionTask,
    paths: tuple[Path, Path, Path],
    chunk_rows: int,
    progress: Callable[[float, int], object] | None,
    resume: bool,
) -> tuple[dict[str, Any], Tally]:
    """Compute the rows of a file, and return fields of the report and a tally of shots outside the model's range.

    ``paths`` are the source, the output and the rejects. Counts include the rows of earlier runs.
    """
    source, target, rejects_path = paths
    table, headings = opened.table, task.columns.headings
    form = (
        ParquetForm(target, headings, table.types, task.headings, task.provenance)
        if is_parquet(target)
        else CsvForm([*headings, *task.headings], table.delimiter, table.decimal_comma)
    )
    rejects_headings = [table.counts, "reason", *headings]
    folder = unfinished_folder(target, [source, rejects_path])
    with Store(folder, task.content_of(source), output=target, resume=resume) as store:
        names = _stored_chunks(store, target.suffix)
        resumed = done = sum(store[each]["rows"] for each in names)
        try:
            for chunk in opened.chunks(chunk_rows, done):
                read = len(chunk.lines) + len(chunk.ragged)
                names.append(name := f"{done:012d}+{read}")
                if _chunk_files(store, name, target.suffix) is None:
                    rows, results, rejects, tally = task.compute(chunk)
                    sums = [store.keep_part(name + target.suffix, form.piece(chunk, rows, results))]
                    if rejects:
                        lines = csv_lines([[each.line, each.reason, *each.cells] for each in rejects], table.delimiter)
                        sums.append(store.keep_part(name + REJECTS, lines))
                    store.keep(name, {
                        "first": done, "rows": read, "written": read - len(rejects), "rejected": len(rejects),
                        "shown": [(each.line, each.reason) for each in rejects[:SHOWN]], "outside": tally.counts(),
                        "sums": sums,
                    })  # fmt: skip
                done += read
                if progress is not None:
                    progress(table.progress(), done)
        except KeyboardInterrupt:
            message = f"interrupted: {done} rows are done and kept in {folder}; the same command continues from there"
            raise KeyboardInterrupt(message) if done else KeyboardInterrupt from None
        if not done:
            raise FileError(table.path, table.header_line, "there are no deliveries below the header")
        chunks = [store[name] for name in names]
        counts = {name: sum(chunk[name] for chunk in chunks) for name in COUNTS}
        shown = [tuple(each) for chunk in chunks for each in chunk["shown"]]
        tally = Tally()
        for chunk in chunks:
            tally.add_counts(chunk["outside"])
        if counts["rejected"]:
            pieces = _all_chunk_files(store, names, target.suffix, 1)
            store.write_result(rejects_path, lambda file: join_csv(file, rejects_headings, table.delimiter, pieces))
        else:
            # Rejects of an earlier run belong to another file and are removed.
            rejects_path.unlink(missing_ok=True)
        store.write_result(target, lambda file: form.whole(file, _all_chunk_files(store, names, target.suffix, 0)))
        store.remove()
    return {**counts, "first_rejects": tuple(shown[:SHOWN]), "resumed": resumed}, tally


def _stored_chunks(store: Store, ending: str) -> list[str]:
    """Return the names of the stored chunks that follow each other from the first row."""
    firsts = {store[name]["first"]: name for name in store if store[name]["rows"] and _chunk_files(store, name, ending)}
    names, row = [], 0
    while row in firsts:
        names.append(firsts[row])
        row += store[firsts[row]]["rows"]
    return names


def _chunk_files(store: Store, name: str, ending: str) -> list[Path] | None:
    """Return a chunk's files of launches and, if any, rejects; None unless they are stored unchanged."""
    if name not in store:
        return None
    sums = zip((name + ending, name + REJECTS), store[name]["sums"], strict=False)
    result = [store.part(*each) for each in sums]
    return None if None in result else [each for each in result if each is not None]


def _all_chunk_files(store: Store, names: Sequence[str], ending: str, place: int) -> Iterator[Path]:
    """Yield the files of one kind of all chunks that have it, after checking that they are unchanged."""
    for name in names:
        if place < len(store[name]["sums"]):
            result = _chunk_files(store, name, ending)
            if result is None:
                raise FileError(str(store.folder), None, PARTS_MISSING)
            yield result[place]


CHUNK_ROWS = 16384
MOST_ROWS = 1_000_000
"""Maximum number of rows held in memory."""


@dataclass(frozen=True, kw_only=True)
class PredictReport(Described):
    """The outcome of predicting a file of deliveries.

    Attributes
    ----------
    source, output
        The files read and written.
    rejects
        The file of rows that could not be used, or None if there are none.
    rows
        Number of rows read; each is either written or rejected.
    written, rejected, blank
        Number of rows with and without a launch, and of blank lines skipped.
    used
        Quantity and unit of each column used, by heading.
    passed, added
        Headings of the columns passed through, and of those added after them.
    notes, first_rejects
        Remarks on the result, and line and reason of the first rejects.
    resumed
        Number of rows done by an earlier run.
    provenance
        The model, its parameters with source and caveats, club, ball and version.
    hand
        The player's hand, "right" or "left", if no column gives it.
    assumptions
        Assumptions about the deliveries, such as static loft in place of a missing dynamic loft, and the caveats of a
        variant of a published set.
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
    notes: tuple[Note, ...] = ()
    first_rejects: tuple[tuple[int, str], ...] = ()
    resumed: int = 0
    provenance: Mapping[str, Any] = field(default_factory=dict, repr=False)
    hand: str = "right"
    assumptions: tuple[Note, ...] = ()

    def __str__(self) -> str:
        lines = [each.sentence for each in self.assumptions]
        lines.append(f"{self.written} of {self.rows} deliveries computed: {self.output}")
        if self.rejected:
            lines.append(f"{self.rejected} rejected: {self.rejects}")
            lines += [f"  {line}: {reason}" for line, reason in self.first_rejects]
        lines += [f"note: {each}" for each in self.notes]
        return "\n".join(lines)

    def to_result(self) -> Result:
        """Return the counts, the columns and the first rejects as a result."""
        columns = [
            *(("used", heading, quantity, unit) for heading, (quantity, unit) in self.used.items()),
            *(("passed through", heading, "", "") for heading in self.passed),
            *(("added", heading, "", "") for heading in self.added),
        ]
        names = ("rows", "written", "rejected", "blank", "resumed", "output", "rejects")
        labels = {"rows": "deliveries", "blank": "blank lines", "resumed": "of an earlier run"}
        made = self.provenance
        return Result(
            "prediction",
            f"Launches of {self.source}",
            assumptions=self.assumptions,
            values=tuple(
                text(name, [getattr(self, name)], label=labels.get(name, ""),
                     printed=name in ("rows", "written") or bool(getattr(self, name)))
                for name in names
            ),
            tables=(
                table("columns", *(text(name, list(each)) for name, each in zip(
                    ("use", "heading", "quantity", "unit"), zip(*columns, strict=True), strict=True)), printed=False),
                table("parameters", text("name", list(made["parameters"]["values"])),
                      text("value", list(made["parameters"]["values"].values())), printed=False),
                table("first_rejects", text("line", [line for line, _ in self.first_rejects]),
                      text("reason", [reason for _, reason in self.first_rejects]),
                      title=f"{self.rejected} rejected{f'; the first {SHOWN}' if self.rejected > SHOWN else ''}"),
            ),
            notes=self.notes,
            provenance=Provenance(
                inputs={"deliveries": self.source},
                computations=(Computation(made["club"]["name"], made["ball"]["name"], made["model"]["name"],
                                          made["parameters"]["name"], self.hand),),
                sources=tuple(model_sources(made)),
                caveats=tuple(map(str, made["parameters"]["caveats"])),
            ),
        )  # fmt: skip


@recorded
def predict(
    source: str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club,
    model: str = DEFAULT_MODEL,
    ball: str | os.PathLike[str] | Ball | None = None,
    parameters: Parameters | None = None,
    hand: HandLike | None = None,
    accuracy: float | None = None,
    carry: bool = True,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    output: str | os.PathLike[str] | None = None,
    rejects: str | os.PathLike[str] | None = None,
    format: str | None = None,
    mapping: str | os.PathLike[str] | None = None,
    units: Mapping[str, str] | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, ValueLike] | None = None,
    chunk_rows: int = CHUNK_ROWS,
    threads: int | None = None,
    progress: Callable[[float, int], object] | None = None,
    resume: bool = False,
) -> PredictReport:
    """Compute the launch of every delivery in a CSV or Parquet file.

    Columns are recognised by name and carry their unit, as in ``club_speed_mph`` or ``club_speed [mph]``, unless
    ``units`` gives it. Other columns are passed through. A row that cannot be used goes to the file of rejects, with
    its line and the reason.

    A launch monitor's file, or a table that names clubs or the reference points of club data, is read as recorded shots
    by :func:`clubface.shots.read`; shots of another club are refused, and club data are converted to clubface's
    reference points.

    Both files appear only when they are complete. Until then, finished chunks are kept in the folder
    ``<output>.unfinished``, and the same call resumes, however the run ended.

    Parameters
    ----------
    source
        A file whose first row names the columns: CSV (with commas, semicolons or tabs; decimal commas unless they are
        the delimiter), an Excel workbook, or Parquet by its ending.
    club, model, ball, parameters, hand, accuracy, threads
        As for :func:`impact`. A column named after an input overrides the club, ball or hand given here.
    carry, air, wind
        Whether to compute flights too, and their conditions as for :func:`fly`.
    output
        The file to write, CSV or Parquet by its ending; default ``<source>-launches.csv`` next to the source.
    rejects
        The CSV file for rows that cannot be used, written only if there are any; default ``<output>.rejects.csv`` next
        to the output.
    format, mapping, units, only, where, mismatch, assume
        As for :func:`clubface.shots.read` and :func:`clubface.shots.measured.ready_shots`.
    chunk_rows
        Number of rows held in memory.
    progress
        Called with the share of the file read, 0 to 1, and the number of rows done.
    resume
        Whether finding an interrupted run with other content or settings is an error; otherwise the run starts over. A
        run with the same ones always resumes.

    Raises
    ------
    FileError
        A file cannot be read or written (the message names the line), is empty, has no speed column or a column twice,
        or a unit has the wrong dimension. Another process is writing the output with other settings, or the run to
        resume was started with another source or other settings.
    KeyboardInterrupt
        Ctrl-C was pressed; the message says where the finished rows are kept.
    """
    path = Path(source)
    target = Path(output) if output is not None else path.with_name(f"{path.stem}-launches.csv")
    rejects_path = Path(rejects) if rejects is not None else target.with_name(f"{target.stem}.rejects.csv")
    _check_paths(path, target, rejects_path)
    chunk_rows = check_count("chunk_rows", chunk_rows, 1, MOST_ROWS)
    threads, accuracy = thread_count(threads) or None, tolerance(accuracy)
    own, ball = backend_of(model).balls(ball, accuracy)
    equipment, chosen = equipped(model, club, ball, parameters)
    arrays = [name for name, value in chosen.values.items() if not isinstance(value, float)]
    if arrays:
        raise InputError(arrays[0], Wording("an array"), "a single number for a file of deliveries")
    side = float(equipment.club.hand) if hand is None else hand_value(hand)
    if side not in (1.0, -1.0):
        raise InputError("hand", hand, "right or left")
    provenance = computed_with(model, chosen, equipment.club, equipment.ball, accuracy)
    shot = {
        "club": equipment.club,
        "model": model,
        "ball": own or equipment.ball,
        "parameters": chosen,
        "accuracy": accuracy,
        "threads": threads,
    }
    if carry:
        check_conditions(air, wind)
    flight = {"air": air, "wind": wind, "threads": threads} if carry else None
    opened = open_source(
        path, equipment.club, hand=None if hand is None else SIDES[side],
        reading={"format": format, "mapping": mapping, "units": units},
        choice={"only": only, "where": where, "assume": assume, "mismatch": mismatch},
    )  # fmt: skip
    try:
        task = PredictionTask(
            shot=shot, flight=flight, hand=side, columns=opened.columns._replace(used=opened.used),
            results=results_of(model, carry), provenance=provenance, content=opened.content,
        )  # fmt: skip
        outcome, tally = run(opened, task, (path, target, rejects_path), chunk_rows, progress, resume)
    finally:
        opened.table.close()
    loft = f"{equipment.club.name} {show(equipment.club.loft, 'deg', 4)}"
    loft_given = any(each.quantity == "loft" for each in opened.used)
    used = {each.quantity: each for each in (*opened.used, *opened.columns.used)}.values()
    return PredictReport(
        source=str(path),
        output=str(target),
        rejects=str(rejects_path) if outcome["rejected"] else None,
        **outcome,
        blank=opened.table.blank,
        used={each.heading: (each.quantity, each.unit) for each in used},
        passed=opened.columns.passed,
        added=task.headings,
        notes=(*opened.notes, *free_text([remark] if (remark := tally.remark()) else [])),
        provenance=provenance,
        hand=SIDES[side],
        assumptions=(*(() if loft_given else (note("static-loft", clubs=[loft]),)), *variant_caveats(chosen)),
    )


def _check_paths(source: Path, target: Path, rejects_path: Path) -> None:
    is_parquet(target)
    for path, what in ((target, "output"), (rejects_path, "rejects")):
        if same_file(path, source):
            raise FileError(str(path), None, f"the {what} must not be the file that is read")
        if not path.parent.is_dir():
            raise FileError(str(path), None, f"there is no folder {str(path.parent)!r}")
        if path.is_dir():
            raise FileError(str(path), None, f"the {what} is a folder; give the name of a file")
    if same_file(rejects_path, target):
        raise FileError(str(rejects_path), None, "the rejects must go to a different file from the output")
