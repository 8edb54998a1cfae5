"""Studies of impacts and flights, of the loft of the longest carry, and of nothing, by which overhead is measured."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError, RangeWarning, RuleWarning
from clubface.schema import PhysicalValue
from clubface.simulation.flight import fly
from clubface.simulation.impact import Tally, impact
from clubface.simulation.results import flight_outputs, outputs
from clubface.studies.axes import Swept
from clubface.studies.kinds.kind import NO_HISTORIES, OUTPUTS, Column, Computed, DescribedStudy, Kind, OneByOne
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, swept_shots
from clubface.support.checks import without_warnings

USUAL = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "carry", "side", "total")
"""The quantities kept by default."""


class Impacts:
    """Launches and flights of a study. See :class:`clubface.studies.kinds.kind.Task`."""

    columns: Mapping[str, Column]
    histories = NO_HISTORIES
    depends_on: Mapping[str, str]

    def __init__(self, study: DescribedStudy) -> None:
        self._design, self._shot_inputs = study.design, ShotInputs(study)
        every = {name: Column(each.unit, each.meaning) for name, each in {**outputs(), **flight_outputs()}.items()}
        self.columns = study.columns(every, USUAL)
        self._flies = any(name in flight_outputs() for name in self.columns)
        self.depends_on = self._shot_inputs.depends_on

    def run(self, indices: range) -> Computed:
        """Compute shots, those of the same club, ball, hand and model together."""
        values = self._design.values(indices)
        codes = {name: values.pop(name) for name in self._shot_inputs.choices}
        columns = {name: np.full(len(indices), np.nan) for name in self.columns}
        failed: list[tuple[int, str]] = []
        tally = Tally()
        for chosen, rows in _alike(codes, len(indices)):
            names = {name: self._shot_inputs.choices[name][code] for name, code in chosen.items()}
            launch, flight = self._shots(names, {name: each[rows] for name, each in values.items()})
            tally.add(launch)
            for name in self.columns:
                columns[name][rows] = (launch if name in outputs() else flight).get(name)
            reasons = {}
            for each in (*launch.problems, *(flight.problems if flight is not None else ())):
                reasons.setdefault(each.row[0] if each.row else 0, f"{each.parameter}: {each.reason}")
            places = np.arange(len(indices))[rows]
            failed += [(indices.start + int(places[row]), reason) for row, reason in reasons.items()]
        return Computed(columns, sorted(failed), tally.counts())

    def _shots(self, names: Mapping[str, str], values: Mapping[str, NDArray[Any]]) -> tuple[Any, Any]:
        """Return launches and flights, None where none are asked for, with what has names held."""
        options = self._shot_inputs.equipped(names, values)
        with without_warnings(RangeWarning), without_warnings(RuleWarning):
            launch = impact(
                options.pop("club"), self._shot_inputs.delivered(names, values), **options, threads=1, on_error="nan"
            )
        if not self._flies:
            return launch, None
        return launch, fly(launch, **self._shot_inputs.conditions.at(values), threads=1, on_error="nan")


def _alike(codes: Mapping[str, NDArray[Any]], count: int) -> list[tuple[dict[str, int], Any]]:
    """Return each combination of names that occurs, and its rows."""
    if not codes:
        return [({}, slice(None))]
    rows, rows_of = np.unique(np.stack([*codes.values()], axis=1), axis=0, return_inverse=True)
    return [
        (dict(zip(codes, map(int, row), strict=True)), np.flatnonzero(rows_of.reshape(count) == place))
        for place, row in enumerate(rows)
    ]


IMPACTS = Kind(name="impact", keys={**KEYS, "outputs": OUTPUTS}, swept=swept_shots, task=Impacts)


COLUMNS = {
    "best_loft": Column("rad", "dynamic loft of the longest carry"),
    "ball_speed": Column("m/s", "ball speed with it"),
    "launch": Column("rad", "launch angle with it"),
    "spin": Column("rad/s", "total spin with it"),
    "carry": Column("m", "carry with it"),
    "total": Column("m", "total distance with it"),
    "within_below": Column("rad", "how much less loft costs the smallest difference of carry worth a change, 2 yd"),
    "within_above": Column("rad", "how much more loft costs the same"),
}


def _swept_best_lofts(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    return {name: each for name, each in swept_shots(table, sweep).items() if name != "loft"}


def _best_loft_task(study: DescribedStudy) -> OneByOne:
    from clubface.design.best_loft import best_loft

    shot_inputs = ShotInputs(study)
    if "loft" in study.table.get("held", {}):
        raise InputError("loft", study.table["held"]["loft"], "left out: the best is looked for")

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        options = shot_inputs.single(task)
        best = best_loft(**options.pop("delivery"), **options, **shot_inputs.conditions.at(task))
        within = best.within[0]
        figures = {name: getattr(best, name)[0] for name in ("ball_speed", "launch", "spin", "carry", "total")}
        return {**figures, "best_loft": best.loft[0], "within_below": within[0], "within_above": within[1]}

    return OneByOne(study, study.columns(COLUMNS, tuple(COLUMNS)), compute)


BEST_LOFTS = Kind(name="best-loft", keys={**KEYS, "outputs": OUTPUTS}, swept=_swept_best_lofts, task=_best_loft_task)


class Empty:
    """The square of one input, after a time of work that the study asks for.

    See :class:`clubface.studies.kinds.kind.Task`.

    Parameters
    ----------
    study
        The study.
    seconds
        Time of a processor that each task takes [s].
    """

    columns: Mapping[str, Column]
    histories = NO_HISTORIES
    depends_on: Mapping[str, str]

    def __init__(self, study: DescribedStudy, seconds: float) -> None:
        self._design, self._seconds = study.design, seconds
        self.columns = {"square": Column("1", "square of the input x")}
        self.depends_on = {}

    def run(self, indices: range) -> Computed:
        """Square the inputs, and work on for the time that was asked for."""
        ends = time.thread_time() + self._seconds * len(indices)
        (x,) = self._design.values(indices).values()
        while time.thread_time() < ends:
            pass
        return Computed({"square": x * x})


def _swept_empty(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    return {"x": Swept("1")}


def _empty_task(study: DescribedStudy) -> Empty:
    return Empty(study, units.parse(study.table.get("seconds", 0.0), "time", name="seconds"))


EMPTY = Kind(name="empty", keys={"seconds": PhysicalValue("s", 0.0, 3600.0)}, swept=_swept_empty, task=_empty_task)
