"""Studies of two shots side by side, such as two clubs, at every input that is swept."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError, InputError, Told
from clubface.simulation.outside import Tally
from clubface.studies.axes import inputs_named
from clubface.studies.designs import Design
from clubface.studies.kinds.impacts import KIND as IMPACT, Impacts
from clubface.studies.kinds.kind import Column, Computed, Described, Kind
from clubface.studies.kinds.shot_inputs import (
    KEYS,
    changed_table,
    is_parameter,
    replaced_by,
    swept_shots,
)
from clubface.support.checks import check_names

OTHER = "other"
"""The table of what is different in the second shot."""


class DesignWithout:
    """A design that leaves some inputs out. See :class:`clubface.studies.designs.Design`."""

    def __init__(self, of: Design, names: Collection[str]) -> None:
        self.axes = tuple(each for each in of.axes if each.name not in names)
        self.count = of.count
        self._of = of

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        found = self._of.values(tasks)
        return {each.name: found[each.name] for each in self.axes}


@dataclass(frozen=True)
class OneShot:
    """One of the two shots. See :class:`clubface.studies.kinds.kind.Described`."""

    of: Described
    table: Mapping[str, Any]
    design: Design

    @property
    def sweep(self) -> Mapping[str, Any]:
        """What is swept of it."""
        return {each.name: self.of.sweep.get(each.name) for each in self.design.axes}

    @property
    def folder(self) -> Path:
        """The folder of the study."""
        return self.of.folder

    def wrap(self, error: ClubfaceError) -> FileError:
        """Return an error with file and line."""
        return self.of.wrap(error)


def _first(study: Described) -> OneShot:
    return OneShot(study, {name: each for name, each in study.table.items() if name != OTHER}, study.design)


def _second(study: Described) -> OneShot:
    """Return the second shot: what it has itself is not swept in it."""
    other = study.table.get(OTHER)
    if not isinstance(other, Mapping) or not other:
        raise InputError(OTHER, other, 'a table of what is different, as in other = { club = "3-wood" }')
    check_names(f"key of {OTHER}", other, KEYS)
    table = changed_table(_first(study).table, other)
    swept = {each.name for each in study.design.axes}
    own = {name: place for name, place, _ in inputs_named(other, swept)}
    for name, place in own.items():
        if name in swept and place.count(".") == 2:
            wanted = "given in one of both places alone, or for all models"
            raise InputError(name, Told(f"in [sweep] and for one model as {OTHER}.{place}"), wanted)
    shot = OneShot(study, table, DesignWithout(study.design, replaced_by(own)))
    if isinstance(given := other.get("parameters"), str) and (both := [*filter(is_parameter, shot.sweep)]):
        raise InputError("parameters", given, f"a table of values: {both[0]} is swept, and a whole set has it, too")
    return shot


class Comparisons:
    """Two shots and their difference. See :class:`clubface.studies.kinds.kind.Task`."""

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, study: Described) -> None:
        first = Impacts(_first(study))
        try:
            self._both = (first, Impacts(_second(study)))
        except InputError as error:
            if error.parameter in (study.table[OTHER] if isinstance(study.table.get(OTHER), Mapping) else ()):
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
        found, tally = {}, Tally()
        for each in (first, second):
            tally.add_counts(each.outside)
        for name in self._names:
            one, other = first.columns[name], second.columns[name]
            found |= {name: one, f"{name}_other": other, f"{name}_difference": other - one}
        return Computed(found, sorted(({**dict(second.failed), **dict(first.failed)}).items()), tally.counts())


KIND = Kind(name="comparison", keys=(*IMPACT.keys, OTHER), swept=swept_shots, task=Comparisons, apart=(OTHER,))
