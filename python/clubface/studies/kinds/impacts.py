"""Studies of impacts and the flights that follow: any input of a shot swept, by any model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import RangeWarning, RuleWarning
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.outside import Tally
from clubface.simulation.quantities import flight_outputs, outputs
from clubface.studies.kinds.kind import Column, Computed, Described, Kind, chosen_columns
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, swept_shots
from clubface.support.warning import without_warnings

USUAL = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "carry", "side", "total")
"""The quantities that are kept where nothing is said."""


class Impacts:
    """Launches and flights of a study. See :class:`clubface.studies.kinds.kind.Task`."""

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, study: Described) -> None:
        self._design, self._shot_inputs = study.design, ShotInputs(study)
        every = {name: Column(each.unit, each.meaning) for name, each in {**outputs(), **flight_outputs()}.items()}
        self.columns = chosen_columns(study.table, every, USUAL)
        self._flies = any(name in flight_outputs() for name in self.columns)
        self.depends_on = self._shot_inputs.depends_on

    def run(self, indices: range) -> Computed:
        """Compute shots, those of the same club, ball, hand and model together."""
        values = self._design.values(indices)
        codes = {name: values.pop(name) for name in self._shot_inputs.choices}
        found = {name: np.full(len(indices), np.nan) for name in self.columns}
        failed: list[tuple[int, str]] = []
        tally = Tally()
        for chosen, rows in _alike(codes, len(indices)):
            names = {name: self._shot_inputs.choices[name][code] for name, code in chosen.items()}
            launch, flight = self._shots(names, {name: each[rows] for name, each in values.items()})
            tally.add(launch)
            for name in self.columns:
                found[name][rows] = (launch if name in outputs() else flight).get(name)
            reasons = {}
            for each in (*launch.problems, *(flight.problems if flight is not None else ())):
                reasons.setdefault(each.row[0] if each.row else 0, f"{each.parameter}: {each.reason}")
            places = np.arange(len(indices))[rows]
            failed += [(indices.start + int(places[row]), reason) for row, reason in reasons.items()]
        return Computed(found, sorted(failed), tally.counts())

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
    rows, which = np.unique(np.stack([*codes.values()], axis=1), axis=0, return_inverse=True)
    return [
        (dict(zip(codes, map(int, row), strict=True)), np.flatnonzero(which.reshape(count) == place))
        for place, row in enumerate(rows)
    ]


KIND = Kind(name="impact", keys=(*KEYS, "outputs"), swept=swept_shots, task=Impacts)
