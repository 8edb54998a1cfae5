"""Inference of deliveries for a file of launches, one row per shot; resumable."""

from __future__ import annotations

import math
import os
import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.clubs import club
from clubface.equipment.described import HANDS
from clubface.errors import FileError, InputError, RangeWarning
from clubface.inference.evaluation.statistics import standard_deviations
from clubface.inference.prior import UnreachableLaunchError, prior_of, shown, unit_of
from clubface.inference.run import CLUB_NOISE, Inference
from clubface.jobs.engine import Job, run
from clubface.jobs.store import Store, unfinished_folder
from clubface.jobs.workers import in_processes, in_sequence
from clubface.results.notes import note
from clubface.results.result import Described, Result
from clubface.results.table import text
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.writer import csv_lines
from clubface.simulation.inputs import OF_CLUB
from clubface.support.checks import without_warnings
from clubface.support.files import input_file, is_path
from clubface.support.processes import processors

REMARK = "remark"
SAMPLES = 400
"""Draws per shot of a file, resampled from at least twice as many effective draws. They give the mean to 4% of the
standard deviation, and the ends of the interval to about 10%."""


class ShotRows:
    """The rows of a file of shots that have at least one launch quantity.

    Delivery values in the rows count as measured. Options are those of :func:`clubface.infer`.
    """

    def __init__(self, shots: RecordedShots, **options: Any) -> None:
        self._shots = shots
        self.launch = [name for name in QUANTITIES if name in shots.launches]
        """The measured launch quantities."""
        if not self.launch:
            raise InputError("shots", shots.source, f"shots with a measured launch: {', '.join(QUANTITIES)}")
        self.club = [name for name in OF_CLUB if np.isfinite(shots.deliveries.get(name, np.nan)).any()]
        """The measured delivery quantities."""
        delivery_noise = {**CLUB_NOISE, **standard_deviations(options.get("delivery_noise"), OF_CLUB, "delivery_noise")}
        self.club_noise = {name: float(delivery_noise[name]) for name in self.club}
        """Their standard deviations [SI]."""
        head = club(options.pop("club"))
        self.options = {"samples": SAMPLES, **options, "club": head, "prior": prior_of(options.get("prior"), head)}
        """The options of the inference."""
        self._given = {"samples": SAMPLES, **options, "speed_at": shots.speed_at, "face_at": shots.face_at}
        self._head = head
        self._prepared: dict[int, Inference] = {}
        self.names = self.options["prior"].names
        """The inferred quantities."""
        self._for(head.hand)  # wrong options are reported before any work

    @property
    def headings(self) -> list[str]:
        """The column headings: measured launch quantities, four for each inferred quantity, and a remark."""
        headings = ["row", *(_heading(name, QUANTITIES[name]) for name in self.launch)]
        for name in self.names:
            headings += [_heading(name, unit_of(name), end) for end in ("", "_std", "_from", "_to")]
        return [*headings, "effective", REMARK]

    def of(self, place: int) -> list[Any]:
        """Return the cells of one shot; the last one gives the reason if no delivery can be inferred."""
        shots = self._shots
        launch = {name: float(shots.launches[name][place]) for name in self.launch}
        cells: list[Any] = [int(shots.rows[place]), *(_cell(launch[name], QUANTITIES[name]) for name in self.launch)]
        measured = {name: value for name, value in launch.items() if np.isfinite(value)}
        club_data = {name: each for name in self.club if np.isfinite(each := float(shots.deliveries[name][place]))}
        nothing = [""] * (4 * len(self.names) + 1)
        if not measured:
            return [*cells, *nothing, "no launch quantity was measured"]
        hand = self._head.hand if shots.hand is None else HANDS[shots.hand[place]]
        try:
            with without_warnings(RangeWarning):
                posterior = self._for(hand).of(measured, club_data)
        except UnreachableLaunchError as error:
            return [*cells, *nothing, str(error)]
        for name in self.names:
            values = (posterior.mean[name], posterior.deviation[name], *posterior.interval(name))
            cells += [_cell(value, unit_of(name)) for value in values]
        remarks = [*(each.sentence for each in posterior.warnings), *([posterior.outside] if posterior.outside else [])]
        return [*cells, round(posterior.effective), "; ".join(remarks)]

    def _for(self, hand: int) -> Inference:
        """Return the inference for shots of one hand."""
        if hand not in self._prepared:
            self._prepared[hand] = Inference(club=replace(self._head, hand=hand), **self._given)
        return self._prepared[hand]


def _spell_name(name: str) -> str:
    return "club_speed" if name == "speed" else name


def _heading(name: str, unit: str, end: str = "") -> str:
    return f"{_spell_name(name)}{end}_{unit}" if unit.isalnum() else f"{_spell_name(name)}{end} [{unit}]"


def _cell(value: float, unit: str) -> str:
    return "" if math.isnan(value) else f"{float(units.from_si(value, unit)):.6g}"


@dataclass(frozen=True)
class InferReport(Described):
    """Result of the inference for a file of launches.

    Attributes
    ----------
    output
        The file written.
    shots, resumed
        Number of rows in the file, and of those finished by an earlier run.
    without, warned
        Number of rows without a delivery, for a reason given in the remark, and with a delivery and a warning.
    used, club_noise
        The measured delivery quantities that were used as well, and their standard deviations [SI].
    """

    output: str
    shots: int
    resumed: int
    without: int
    warned: int
    used: tuple[str, ...]
    club_noise: Mapping[str, float] = field(default_factory=dict)

    def to_result(self) -> Result:
        """Return the counts, with notes on the inputs used and on remarks."""
        noise = [f"{name} {shown(name, value, 3)}" for name, value in self.club_noise.items()]
        notes = [note("club-data-used", names=list(self.used), noise=noise)] if self.used else []
        notes += [note("rows-with-remarks", rows=self.warned)] if self.warned else []
        counts = [text(name, [getattr(self, name)]) for name in ("shots", "resumed", "without", "warned")]
        return Result(
            "inferred-shots", f"{self.shots - self.without} of {self.shots} launches inferred: {self.output}",
            values=(text("output", [self.output], printed=False), *counts, text("used", [self.used], printed=False)),
            notes=tuple(notes),
        )  # fmt: skip


def infer_shots(
    shots: RecordedShots,
    output: str | os.PathLike[str],
    *,
    resume: bool = False,
    progress: Callable[[int, int], object] | None = None,
    **options: Any,
) -> InferReport:
    """Infer the delivery of every shot, and write mean, standard deviation and 95% interval of each quantity as CSV.

    The file has ``.part`` in its name until it is complete. After an interruption it holds the finished shots.

    Parameters
    ----------
    shots
        Recorded shots with at least one launch quantity. Their delivery values count as measured.
    output
        Path of a CSV file.
    resume
        True raises FileError if an unfinished run has other settings; False starts it again. An unfinished run with the
        same settings always continues.
    progress
        Function called with the number of shots done and the number of shots.
    **options
        As for :func:`infer`, with a default of 400 ``samples``.

    Raises
    ------
    FileError
        The file cannot be written, or belongs to an unfinished run with other settings.
    KeyboardInterrupt
        On Ctrl-C; the message names the file with the finished rows.
    """
    target = Path(output)
    if target.suffix.lower() != ".csv":
        raise InputError("output", str(output), "a file ending in .csv")
    if target.exists() and os.path.exists(shots.source) and target.samefile(shots.source):
        raise FileError(str(target), None, "this is the input file; give another output file")
    if not target.parent.is_dir():
        raise FileError(str(target), None, f"there is no folder {str(target.parent)!r}")
    rows = ShotRows(shots, **options)
    content = {
        "set of measured shots": [shots.rows, shots.launches, shots.deliveries, shots.hand],
        "point of measurement": [shots.speed_at, shots.face_at],
        "club, prior or option": {  # of a file, its content
            name: input_file(value).sha256 if is_path(value) else value for name, value in rows.options.items()
        },
    }
    folder = unfinished_folder(target, [shots.source])
    with Store(folder, content, output=target, resume=resume) as store:
        job = Job("shots", range(len(shots)), rows.of)
        if len(shots) - len(store) >= FEWEST_FOR_PROCESSES and processors() > 1:
            job, how = replace(job, compute=partial(_row, pickle.dumps((shots, rows.options)))), in_processes
        else:
            how = in_sequence
        written = list(run(job, how, store=store, progress=progress).values())
        content_of_file = csv_lines([rows.headings, *written], ",")
        store.write_result(target, lambda file: file.write(content_of_file))
        store.remove()
    without = sum(row[-2] == "" for row in written)
    warned = sum(bool(row[-1]) for row in written) - without
    return InferReport(
        str(target), len(written), len(store.resumed), without, warned, tuple(rows.club), rows.club_noise
    )


FEWEST_FOR_PROCESSES = 100
"""Number of shots above which worker processes pay off their start-up time of a few seconds."""


def _row(data: bytes, place: int) -> list[Any]:
    """Return the cells of one shot, in a worker process."""
    return _rows(data).of(place)


@lru_cache(maxsize=1)
def _rows(data: bytes) -> ShotRows:
    shots, options = pickle.loads(data)
    return ShotRows(shots, **{**options, "threads": 1})
