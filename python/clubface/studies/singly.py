"""Kinds of studies whose tasks are computed one after the other, each by one call of the package."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import ClubfaceError
from clubface.studies.axes import Swept
from clubface.studies.kinds import Column, Computed, Described, Task
from clubface.support.processor import vector_units
from clubface.support.warning import without_warnings

Values = Mapping[str, Any]
"""What is swept, of one task: numbers [SI] and names."""


class Prepared(NamedTuple):
    """How the tasks of a study are computed.

    Attributes
    ----------
    columns
        What is kept of a task.
    compute
        From what is swept to all figures [SI] by name, or to what computes each of them; what has none is an error.
    elements
        Whether finite elements compute it, whose last digits depend on the processor.
    """

    columns: Mapping[str, Column]
    compute: Callable[[Values], Mapping[str, float | Callable[[], float]]]
    elements: bool = False


class OneByOne:
    """See :class:`clubface.studies.kinds.Task`."""

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, study: Described, prepared: Prepared) -> None:
        self._design, self._compute = study.design, prepared.compute
        self._choices = {each.name: each.choices for each in study.design.axes if each.choices}
        self.columns = prepared.columns
        self.depends_on = {"processor": vector_units()} if prepared.elements else {}

    def run(self, indices: range) -> Computed:
        """Compute one task after the other; why one has no result is told."""
        import numpy as np

        values = {name: each.tolist() for name, each in self._design.values(indices).items()}
        found = {name: np.full(len(indices), math.nan) for name in self.columns}
        failed: list[tuple[int, str]] = []
        for place, index in enumerate(indices):
            task = {name: self._choices[name][each[place]] if name in self._choices else float(each[place])
                    for name, each in values.items()}  # fmt: skip
            try:
                with without_warnings():
                    figures = self._compute(task)
                    row = {name: figures[name] for name in self.columns}
                    row = {name: each() if callable(each) else each for name, each in row.items()}
            except ClubfaceError as error:
                failed.append((index, str(error)))
                continue
            for name, each in row.items():
                found[name][place] = each
        return Computed(found, failed)


@dataclass(frozen=True, kw_only=True)
class SinglyKind:
    """See :class:`clubface.studies.kinds.Kind`.

    Attributes
    ----------
    name, keys, swept, files
        As there.
    begin
        How the tasks of a study are computed.
    """

    name: str
    keys: tuple[str, ...]
    swept: Callable[[Mapping[str, Any], Mapping[str, Any]], Mapping[str, Swept]]
    files: Callable[[Described], Sequence[Path]]
    begin: Callable[[Described], Prepared]

    def prepare(self, study: Described) -> Task:
        """Return the task; what is wrong with the study is an error here."""
        try:
            return OneByOne(study, self.begin(study))
        except ClubfaceError as error:
            raise study.wrap(error) from None
