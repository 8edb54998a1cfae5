"""Studies of impacts: one shot, or two compared, for every swept input; the best loft for carry; and face maps.

The kind ``empty`` computes next to nothing and serves to measure overhead.
"""

from __future__ import annotations

import time
from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import MODULES
from clubface.errors import InputError, RangeWarning, RuleWarning, Wording
from clubface.schema import PhysicalValue, Record, Simple
from clubface.simulation.flight import fly
from clubface.simulation.impact import Tally, impact
from clubface.simulation.results import flight_outputs, outputs
from clubface.studies.axes import Swept, inputs_named, number
from clubface.studies.designs import Design
from clubface.studies.kinds.kind import OUTPUTS, Column, Computed, DescribedStudy, Kind, OneByOne, Task
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, changed_table, is_parameter, replaced_by, swept_shots
from clubface.support.checks import without_warnings

USUAL = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "carry", "side", "total")
"""The quantities kept by default."""
OTHER = "other"
"""The table with the changes in the second shot."""


class Impacts(Task):
    """Launches and flights of a study."""

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
        """Return launches and flights (None if not needed), for fixed names."""
        options = self._shot_inputs.equipped(names, values)
        with without_warnings(RangeWarning), without_warnings(RuleWarning):
            launch = impact(
                options.pop("club"), self._shot_inputs.delivered(names, values), **options, threads=1, on_error="nan"
            )
        if not self._flies:
            return launch, None
        return launch, fly(launch, **self._shot_inputs.conditions.at(values), threads=1, on_error="nan")


def _alike(codes: Mapping[str, NDArray[Any]], count: int) -> list[tuple[dict[str, int], Any]]:
    """Return each occurring combination of names, with its rows."""
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
        raise InputError("loft", study.table["held"]["loft"], "left out: it is optimised")

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        options = shot_inputs.single(task)
        best = best_loft(**options.pop("delivery"), **options, **shot_inputs.conditions.at(task))
        within = best.within[0]
        figures = {name: getattr(best, name)[0] for name in ("ball_speed", "launch", "spin", "carry", "total")}
        return {**figures, "best_loft": best.loft[0], "within_below": within[0], "within_above": within[1]}

    return OneByOne(study, study.columns(COLUMNS, tuple(COLUMNS)), compute)


BEST_LOFTS = Kind(name="best-loft", keys={**KEYS, "outputs": OUTPUTS}, swept=_swept_best_lofts, task=_best_loft_task)


class Empty(Task):
    """The square of one input, after a given amount of work."""

    def __init__(self, study: DescribedStudy) -> None:
        self._design = study.design
        self._seconds = units.parse(study.table.get("seconds", 0.0), "time", name="seconds")
        self.columns = {"square": Column("1", "square of the input x")}
        self.depends_on = {}

    def run(self, indices: range) -> Computed:
        """Square the inputs, and keep working for the given time."""
        ends = time.thread_time() + self._seconds * len(indices)
        (x,) = self._design.values(indices).values()
        while time.thread_time() < ends:
            pass
        return Computed({"square": x * x})


EMPTY = Kind(
    name="empty", keys={"seconds": PhysicalValue("s", 0.0, 3600.0)}, swept=lambda table, sweep: {"x": Swept("1")},
    task=Empty,
)  # fmt: skip


class DesignWithout:
    """A design that leaves some inputs out. See :class:`clubface.studies.designs.Design`."""

    def __init__(self, design: Design, names: Collection[str]) -> None:
        self.axes = tuple(each for each in design.axes if each.name not in names)
        self.count = design.count
        self._design = design

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        values = self._design.values(tasks)
        return {each.name: values[each.name] for each in self.axes}


def _first(study: DescribedStudy) -> DescribedStudy:
    return replace(study, table={name: each for name, each in study.table.items() if name != OTHER})


def _second(study: DescribedStudy) -> DescribedStudy:
    """Return the study of the second shot; inputs that it sets itself are not swept."""
    other = study.table.get(OTHER)
    if not other:
        raise InputError(OTHER, other, 'a table of what is different, as in other = { club = "3-wood" }')
    table = changed_table(_first(study).table, other)
    swept = {each.name for each in study.design.axes}
    own = {name: place for name, place, _ in inputs_named(other, swept)}
    for name, place in own.items():
        if name in swept and place.count(".") == 2:
            wanted = "given in only one of the two places, or for all models"
            raise InputError(name, Wording(f"in [sweep] and for one model as {OTHER}.{place}"), wanted)
    design = DesignWithout(study.design, replaced_by(own))
    sweep = {each.name: study.sweep.get(each.name) for each in design.axes}
    if isinstance(given := other.get("parameters"), str) and (both := [*filter(is_parameter, sweep)]):
        raise InputError("parameters", given, f"a table of values: {both[0]} is swept, and a whole set has it, too")
    return replace(study, table=table, sweep=sweep, design=design)


class Comparisons(Task):
    """Two shots and their difference."""

    def __init__(self, study: DescribedStudy) -> None:
        first = Impacts(_first(study))
        try:
            self._both = (first, Impacts(_second(study)))
        except InputError as error:
            if error.parameter in study.table.get(OTHER, ()):
                raise InputError(f"{OTHER}.{error.parameter}", error.value, error.allowed) from None
            raise
        self._names = tuple(self._both[0].columns)
        self.depends_on = {**self._both[0].depends_on, **self._both[1].depends_on}
        self.columns = {}
        for name, each in self._both[0].columns.items():
            self.columns |= {name: each, f"{name}_other": Column(each.unit, f"of the other: {each.meaning}")}
            self.columns[f"{name}_difference"] = Column(each.unit, f"of the other less of the first: {each.meaning}")

    def run(self, indices: range) -> Computed:
        """Compute both shots of every task."""
        first, second = (each.run(indices) for each in self._both)
        columns, tally = {}, Tally()
        for each in (first, second):
            tally.add_counts(each.outside)
        for name in self._names:
            one, other = first.columns[name], second.columns[name]
            columns |= {name: one, f"{name}_other": other, f"{name}_difference": other - one}
        return Computed(columns, sorted(({**dict(second.failed), **dict(first.failed)}).items()), tally.counts())


OTHER_SHOT = Record(
    {name: Record(Simple()) if name == "held" else each for name, each in KEYS.items()},
    example='other = { club = "3-wood" }',
)
COMPARISONS = Kind(
    name="comparison", keys={**IMPACTS.keys, OTHER: OTHER_SHOT}, swept=swept_shots, task=Comparisons, apart=(OTHER,)
)


PLACE = {"spread_toe": "m", "spread_high": "m", "about_toe": "m", "about_high": "m", "share": "1"}
"""Units of the scatter of impacts, its centre, and the share of the best ball speed."""
FACE = {
    "face_area": Column("m2", "area of the face"),
    "area": Column("m2", "area on which the ball speed is at least a share of the best, 0.98 unless given"),
    "sweet_spot_toe": Column("m", "where the ball speed is greatest, towards the toe"),
    "sweet_spot_high": Column("m", "the same, upwards"),
    "best_ball_speed": Column("m/s", "ball speed there"),
    "longest_toe": Column("m", "where the carry is greatest, towards the toe"),
    "longest_high": Column("m", "the same, upwards"),
    "longest_carry": Column("m", "carry there"),
}
SCATTERED = ("missed", "ball_speed_loss", "carry_mean", "carry_deviation", "carry_loss", "side_deviation")


def _columns() -> dict[str, Column]:
    from clubface.design.contributions import quantities

    columns = {**FACE, "missed": Column("1", "share of the swings that miss the face")}
    for name, each in quantities().items():
        columns[f"{name}_mean"] = Column(each.unit, f"mean over impacts that scatter: {each.meaning}")
        columns[f"{name}_deviation"] = Column(each.unit, f"standard deviation over them: {each.meaning}")
        columns[f"{name}_loss"] = Column(each.unit, f"drop of the mean from the value at the centre: {each.meaning}")
    return columns


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    shots = {name: each for name, each in swept_shots(table, sweep).items() if name not in ("toe", "high")}
    return {**shots, **{name: Swept(unit) for name, unit in PLACE.items()}}


def _task(study: DescribedStudy) -> OneByOne:
    from clubface.design.face_map import SHARE, checked_grid, map_face

    shot_inputs, table = ShotInputs(study), study.table
    for name in ("toe", "high"):
        if name in table.get("held", {}):
            raise InputError(name, table["held"][name], "left out: a map strikes the whole face")
    held = {"share": SHARE, "about_toe": 0.0, "about_high": 0.0}
    held |= {name: number(name, table[name], unit) for name, unit in PLACE.items() if name in table}
    given = {*held, *(each.name for each in study.design.axes)}
    scatters = {"spread_toe", "spread_high"} <= given
    columns = study.columns(_columns(), (*FACE, *(SCATTERED if scatters else ())))
    if not scatters and (named := [name for name in columns if name not in FACE]):
        raise InputError("spread_toe", None, f'give it and spread_high, as in spread_toe = "10 mm", for {named[0]}')
    if not scatters and (idle := [each for each in PLACE if each != "share" and each in {*table, *study.sweep}]):
        raise InputError(idle[0], Wording("given"), "left out unless both spread_toe and spread_high are given")
    if (grid := table.get("grid")) is not None:
        grid = checked_grid(grid)

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        place = {**held, **task}
        shot = shot_inputs.single(task)
        alone: dict[str, Any] = {"workers": 1} if shot["model"] in MODULES else {}
        face_map = map_face(**shot, **shot_inputs.conditions.at(task), grid=grid, **alone)
        best, longest = face_map.best(), face_map.best("carry")
        figures: dict[str, Any] = {
            "face_area": face_map.outline.area, "area": lambda: face_map.area(place["share"]),
            "sweet_spot_toe": best.toe, "sweet_spot_high": best.high, "best_ball_speed": best.value,
            "longest_toe": longest.toe, "longest_high": longest.high, "longest_carry": longest.value,
        }  # fmt: skip
        if scatters:
            spread = (place["spread_toe"], place["spread_high"])
            forgiveness = face_map.forgiveness(spread, toe=place["about_toe"], high=place["about_high"])
            for part in ("mean", "deviation", "loss"):
                figures |= {f"{name}_{part}": each for name, each in getattr(forgiveness, part).items()}
            figures["missed"] = forgiveness.missed
        return figures

    return OneByOne(study, columns, compute, elements=bool(shot_inputs.depends_on))


MAP_KEYS = {**KEYS, **{name: PhysicalValue(unit) for name, unit in PLACE.items()}, "grid": Simple(), "outputs": OUTPUTS}
MAPS = Kind(name="map", keys=MAP_KEYS, swept=_swept, task=_task)
