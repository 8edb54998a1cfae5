"""The interface of kinds of studies, and tasks computed one by one.

A study names its kind, gives it a table, and sweeps inputs that the kind allows. From the study the kind makes a task,
whose columns at any index depend only on the study and the index. To add a kind, write a ``Kind`` in a module next to
this one and add a line to ``KINDS`` in :mod:`clubface.studies.study`.
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
"""Name of the history column with the task index."""


class Column(NamedTuple):
    """A computed column: SI unit ("1" for none), and meaning in one line."""

    unit: str
    meaning: str


Histories = Mapping[str, Mapping[str, Column]]
"""Histories by name, with their columns."""
NO_HISTORIES: Histories = {}


class Computed(NamedTuple):
    """The results of a task at some indices.

    Attributes
    ----------
    columns
        Numbers by name [SI], float64, shape (indices,); NaN without a result.
    failed
        Indices without a result, in increasing order, and the reasons.
    outside
        Shots outside the model's range, as from :meth:`clubface.simulation.impact.Tally.counts`.
    histories
        Histories kept by the study, by name: columns [SI] of equal length, including the task index, ``task``; tasks
        without a result have none.
    """

    columns: Mapping[str, NDArray[Any]]
    failed: Sequence[tuple[int, str]] = ()
    outside: Sequence[Any] = ({}, [])
    histories: Mapping[str, Mapping[str, NDArray[Any]]] = {}


class Task(Protocol):
    """A computation: columns, histories, and what else may change their last bits besides study and version."""

    columns: Mapping[str, Column]
    histories: Histories = NO_HISTORIES
    depends_on: Mapping[str, str]

    def run(self, indices: range) -> Computed:
        """Compute consecutive indices on one thread; results must not depend on how indices are grouped."""
        ...


@dataclass(frozen=True)
class DescribedStudy:
    """A study as seen by its kind.

    File names are relative to ``folder``, and ``wrap`` adds file and line to an error about the ``table``.
    """

    table: Mapping[str, Any]
    sweep: Mapping[str, Any]
    design: Design
    folder: Path
    wrap: Callable[[ClubfaceError], FileError]

    def load(self, key: str, read: Callable[[Any], T], default: str | None = None) -> dict[Any, T]:
        """Return the objects named under a key of the kind's table, or swept, by name; they are read now.

        ``read`` takes a name, or a file's path relative to the study's folder.
        """
        swept = next((each.choices for each in self.design.axes if each.name == key), None)
        return {each: read(resolved(each, self.folder)) for each in swept or [self.table.get(key, default)]}

    def columns(self, every: Mapping[str, Column], usual: Sequence[str]) -> dict[str, Column]:
        """Return the columns requested by ``outputs`` in the kind's table, or the usual ones."""
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
        Name in study files, and of the kind's table there.
    keys
        Schemas of the keys in that table, which is kept as in the file.
    swept
        Returns the sweepable inputs from the kind's table (with file names as paths) and [sweep].
    task
        Returns the task of a study, and raises errors in the study before any work. It reads all files the tasks need,
        since none are read later.
    apart
        Keys whose tables may contain swept inputs, with a meaning defined by the kind.
    """

    name: str
    keys: Mapping[str, Value]
    swept: Callable[[Mapping[str, Any], Mapping[str, Any]], Mapping[str, Swept]]
    task: Callable[[DescribedStudy], Task]
    apart: tuple[str, ...] = ()

    def prepare(self, study: DescribedStudy) -> Task:
        """Return the task of a study; errors about values in the kind's table name file and line."""
        try:
            return self.task(study)
        except ClubfaceError as error:
            raise study.wrap(error) from None


def resolved(named: Any, folder: Path) -> Any:
    """Return a name unchanged, and a file's path relative to the study's folder."""
    return folder / named if isinstance(named, str) and is_path(named) else named


ONE_NAME = Simple("one name in quotes; several go to [sweep]", lambda given: isinstance(given, str), {"type": "string"})
OUTPUTS = Items(TEXT, 1, allowed='a list of quantities, as in ["carry"]')
"""Schemas used in the tables of several kinds."""


class OneByOne(Task):
    """Tasks computed one by one.

    ``compute`` takes the swept inputs, numbers [SI] and names, and returns all results [SI] by name, or functions that
    compute them; without a result it raises an error. A history's name holds the arrays of its columns. ``columns`` and
    ``histories`` are those to keep. ``elements`` says that it uses finite elements, whose last digits depend on the
    processor.
    """

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
        """Compute the tasks one by one, recording why one has no result."""
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
