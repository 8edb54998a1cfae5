"""The interface of kinds of studies, and tasks computed one after the other.

A study names its kind, gives it a table of its own, and sweeps what the kind says may be swept. From the study the kind
makes a task, whose columns at any index follow from the study and the index alone. Another kind is a ``Kind`` in a
module next to this one, and a line in ``KINDS`` of :mod:`clubface.studies.study`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError
from clubface.schema import TEXT, Items, Simple, Value
from clubface.studies.axes import Swept
from clubface.studies.designs import Design
from clubface.support.checks import check_choice, without_warnings
from clubface.support.files import is_path
from clubface.support.processes import vector_units

__all__ = ["Column", "Computed", "DescribedStudy", "Histories", "Kind", "Task"]

T = TypeVar("T")
TASK = "task"
"""The column of a history that holds the index of the task."""


class Column(NamedTuple):
    """A column that a task computes: its SI unit ("1" for none), and its meaning in one line."""

    unit: str
    meaning: str


Histories = Mapping[str, Mapping[str, Column]]
"""Histories by name, with their columns."""
NO_HISTORIES: Histories = {}


class Computed(NamedTuple):
    """What a task computes at some indices.

    Attributes
    ----------
    columns
        Numbers by name [SI], float64, shape (indices,); NaN where there is no result.
    failed
        The indices without a result, and why; rising.
    outside
        The shots outside the range of their model, as :meth:`clubface.simulation.impact.Tally.counts` tells them.
    histories
        The histories that the study keeps, by name: columns [SI] of equal length, the index of the task, ``task``,
        among them; tasks without a result have none.
    """

    columns: Mapping[str, NDArray[Any]]
    failed: Sequence[tuple[int, str]] = ()
    outside: Sequence[Any] = ({}, [])
    histories: Mapping[str, Mapping[str, NDArray[Any]]] = {}


class Task(Protocol):
    """What is computed: its columns and histories, and what besides study and version may change bits of them."""

    columns: Mapping[str, Column]
    histories: Histories
    depends_on: Mapping[str, str]

    def run(self, indices: range) -> Computed:
        """Compute consecutive indices on one thread; the result must not depend on which are computed together."""
        ...


@dataclass(frozen=True)
class DescribedStudy:
    """What a kind knows of a study.

    Relative names of files begin in the ``folder``, and ``wrap`` puts file and line on an error about the ``table``.
    """

    table: Mapping[str, Any]
    sweep: Mapping[str, Any]
    design: Design
    folder: Path
    wrap: Callable[[ClubfaceError], FileError]

    def load(self, key: str, read: Callable[[Any], T], default: str | None = None) -> dict[Any, T]:
        """Return what is named under a key of the kind's table, or swept there, by that name, each read now.

        ``read`` takes a name, or the path of a file from the folder of the study.
        """
        swept = next((each.choices for each in self.design.axes if each.name == key), None)
        return {each: read(resolved(each, self.folder)) for each in swept or [self.table.get(key, default)]}

    def columns(self, every: Mapping[str, Column], usual: Sequence[str]) -> dict[str, Column]:
        """Return the columns that the kind's table asks for by ``outputs``, or the usual ones."""
        names = self.table.get("outputs", usual)
        for place, name in enumerate(names):
            check_choice(f"outputs[{place}]", name, every)
        return {name: every[name] for name in names}


@dataclass(frozen=True, kw_only=True)
class Kind:
    """A kind of study.

    Attributes
    ----------
    name
        As in the file of a study, and the name of the table that the kind has there.
    keys
        The kinds of value under the keys of that table, which stays as it is in the file.
    swept
        From the kind's table, its names of files as paths, and [sweep], to the inputs that may be swept.
    task
        From a study to its task; what is wrong with the study is an error here, before any work. It reads all files
        that the tasks need, since none is read later.
    apart
        Those of the keys whose tables may hold what is swept, as the kind says what that means.
    """

    name: str
    keys: Mapping[str, Value]
    swept: Callable[[Mapping[str, Any], Mapping[str, Any]], Mapping[str, Swept]]
    task: Callable[[DescribedStudy], Task]
    apart: tuple[str, ...] = ()

    def prepare(self, study: DescribedStudy) -> Task:
        """Return the task of a study; an error about a value of the kind's table names file and line."""
        try:
            return self.task(study)
        except ClubfaceError as error:
            raise study.wrap(error) from None


def resolved(named: Any, folder: Path) -> Any:
    """Return a name as it is, and the path of a file from the folder of the study."""
    return folder / named if isinstance(named, str) and is_path(named) else named


ONE_NAME = Simple("one name in quotes; several go to [sweep]", lambda given: isinstance(given, str), {"type": "string"})
OUTPUTS = Items(TEXT, 1, allowed='a list of quantities, as in ["carry"]')
"""Kinds of value that the tables of several kinds have."""


class OneByOne:
    """Tasks that are computed one after the other. See :class:`clubface.studies.kinds.kind.Task`.

    Parameters
    ----------
    study
        The study.
    columns
        What is kept of a task.
    compute
        From what is swept, numbers [SI] and names, to all figures [SI] by name, or to what computes each of them; what
        has none is an error. Under the name of a history it has the arrays of its columns.
    elements
        Whether finite elements compute it, whose last digits depend on the processor.
    histories
        The histories that are kept.
    """

    columns: Mapping[str, Column]
    histories: Histories
    depends_on: Mapping[str, str]

    def __init__(
        self,
        study: DescribedStudy,
        columns: Mapping[str, Column],
        compute: Callable[[Mapping[str, Any]], Mapping[str, Any]],
        *,
        elements: bool = False,
        histories: Histories | None = None,
    ) -> None:
        self._design, self._compute = study.design, compute
        self._choices = {each.name: each.choices for each in study.design.axes if each.choices}
        self.columns, self.histories = columns, histories or NO_HISTORIES
        self.depends_on = {"processor": vector_units()} if elements else {}

    def run(self, indices: range) -> Computed:
        """Compute one task after the other; the reason why one has no result is kept."""
        values = {name: each.tolist() for name, each in self._design.values(indices).items()}
        columns = {name: np.full(len(indices), math.nan) for name in self.columns}
        failed: list[tuple[int, str]] = []
        kept: dict[str, dict[str, list[NDArray[Any]]]] = {
            name: {each: [np.empty(0)] for each in (TASK, *history)} for name, history in self.histories.items()
        }
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
                columns[name][place] = each
            for name, history in kept.items():
                series = figures[name]
                history[TASK].append(np.full(len(next(iter(series.values()))), float(index)))
                for column in self.histories[name]:
                    history[column].append(series[column])
        joined = {
            name: {each: np.concatenate(arrays) for each, arrays in history.items()} for name, history in kept.items()
        }
        return Computed(columns, failed, histories=joined)
