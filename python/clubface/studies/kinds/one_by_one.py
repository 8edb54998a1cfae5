"""Tasks of studies that are computed one after the other, each by one call of the package."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from clubface.errors import ClubfaceError
from clubface.studies.kinds.kind import Column, Computed, Described
from clubface.support.processors import vector_units
from clubface.support.warning import without_warnings

Values = Mapping[str, Any]
"""What is swept, of one task: numbers [SI] and names."""


class OneByOne:
    """Tasks that are computed one after the other. See :class:`clubface.studies.kinds.kind.Task`.

    Parameters
    ----------
    study
        The study.
    columns
        What is kept of a task.
    compute
        From what is swept to all figures [SI] by name, or to what computes each of them; what has none is an error.
    elements
        Whether finite elements compute it, whose last digits depend on the processor.
    """

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(
        self,
        study: Described,
        columns: Mapping[str, Column],
        compute: Callable[[Values], Mapping[str, float | Callable[[], float]]],
        *,
        elements: bool = False,
    ) -> None:
        self._design, self._compute = study.design, compute
        self._choices = {each.name: each.choices for each in study.design.axes if each.choices}
        self.columns = columns
        self.depends_on = {"processor": vector_units()} if elements else {}

    def run(self, indices: range) -> Computed:
        """Compute one task after the other; why one has no result is told."""
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
