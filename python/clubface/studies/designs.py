"""The inputs of each task of a study, a pure function of its number, so that any worker can compute any task."""

from __future__ import annotations

import copy
import math
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError, Wording
from clubface.shots.summary_rows import summaries_in
from clubface.shots.tables.headings import Vocabulary, check_units, delivery_words, layout, plain, plain_name
from clubface.shots.tables.row_source import open_table
from clubface.studies.axes import FORMS, INTERVAL, MOST, SweepAxis, Swept, whole_flaw
from clubface.support.checks import is_count, without_foreign_warnings

GRID, HYPERCUBE, SOBOL, TABLE = DESIGNS = ("grid", "latin-hypercube", "sobol", "table")
"""All combinations of values, two space-filling samples, and the rows of a file."""
MOST_HYPERCUBE = 1_000_000
"""Maximum number of Latin hypercube samples, which every worker draws as a whole."""
BITS = 32
"""Bits of a Sobol coordinate: the sequence has 2**32 points, the most that SciPy can fast-forward."""


class Design(Protocol):
    """The tasks of a study."""

    axes: tuple[SweepAxis, ...]  # the swept inputs
    count: int  # number of tasks

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name: SI values, or indices into an axis's choices."""
        ...


STRIDE = 2**22
"""Interval, in points, at which the state of a Sobol sequence is kept; skipping it takes 10 ms."""


class Grid:
    """All combinations of the values of some axes; the last axis varies fastest. See :class:`Design`."""

    def __init__(self, axes: Sequence[SweepAxis]) -> None:
        self.axes = tuple(axes)
        for each in self.axes:
            if each.count is None:
                wanted = "evenly spaced values, with a count or a step, in a grid; an interval is for samples"
                raise InputError(each.name, Wording("an interval"), wanted)
        self.count = _checked(math.prod(each.count or 1 for each in self.axes))

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        return self.at(np.arange(tasks.start, tasks.stop))

    def at(self, places: NDArray[Any]) -> dict[str, NDArray[Any]]:
        """Return the inputs of combinations by name."""
        values = {}
        for each in reversed(self.axes):
            places, place = np.divmod(places, each.count or 1)
            values[each.name] = each.at(place)
        return {each.name: values[each.name] for each in self.axes}


class Samples:
    """Space-filling samples between the ends of some axes, from SciPy's generators. See :class:`Design`."""

    def __init__(self, axes: Sequence[SweepAxis], samples: Any, method: str, seed: int) -> None:
        self.axes = tuple(axes)
        most = 2**BITS if method == SOBOL else MOST_HYPERCUBE
        if not is_count(samples, 1, most):
            more = "" if method == SOBOL else "; sobol takes more"
            raise InputError("samples", samples, f"a whole number from 1 to {most} for the design {method}{more}")
        self.count = samples
        self._method, self._seed = method, seed
        self._lock = threading.Lock()  # Dask may run several chunks in one process
        self._drawn: Any = None
        self._passed: list[Any] = []

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        with self._lock:
            shares = self._sobol(tasks) if self._method == SOBOL else self._hypercube()[tasks.start : tasks.stop]
        return {each.name: each.drawn(shares[:, place]) for place, each in enumerate(self.axes)}

    def _sobol(self, tasks: range) -> NDArray[Any]:
        made = self._sequence(tasks.start)
        with without_foreign_warnings(UserWarning):  # ignore that a single chunk is not balanced: the whole sequence is
            return made.random(len(tasks))

    def _sequence(self, start: int) -> Any:
        """Return the sequence advanced to a point; as it only moves forwards, intermediate states are kept."""
        from scipy.stats import qmc

        if not self._passed:
            self._passed.append(qmc.Sobol(len(self.axes), scramble=True, bits=BITS, rng=self._seed))
        while len(self._passed) <= start // STRIDE:
            self._passed.append(copy.deepcopy(self._passed[-1]).fast_forward(STRIDE))
        made = copy.deepcopy(self._passed[start // STRIDE])
        return made.fast_forward(start % STRIDE) if start % STRIDE else made

    def _hypercube(self) -> NDArray[Any]:
        from scipy.stats import qmc

        if self._drawn is None:
            self._drawn = qmc.LatinHypercube(len(self.axes), rng=self._seed).random(self.count)
        return self._drawn


class DesignRows:
    """The rows of a table, repeated for each combination of other axes. See :class:`Design`."""

    def __init__(self, columns: Mapping[str, tuple[str, NDArray[Any]]], others: Sequence[SweepAxis]) -> None:
        self._columns = {name: values for name, (_, values) in columns.items()}
        self._rows = len(next(iter(self._columns.values())))
        self._others = Grid(others)
        of_table = (SweepAxis(name=name, unit=unit, count=self._rows) for name, (unit, _) in columns.items())
        self.axes = (*self._others.axes, *of_table)
        self.count = _checked(self._rows * self._others.count)

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        blocks, rows = np.divmod(np.arange(tasks.start, tasks.stop), self._rows)
        return self._others.at(blocks) | {name: values[rows] for name, values in self._columns.items()}


class CachedDesign:
    """A design that caches the last result per thread, since a chunk's task and its part both need it."""

    def __init__(self, design: Design) -> None:
        self.axes, self.count = design.axes, design.count
        self._design, self._last = design, threading.local()

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        if getattr(self._last, "tasks", None) != tasks:
            self._last.tasks, self._last.values = None, self._design.values(tasks)
            self._last.tasks = tasks
        return dict(self._last.values)


def design(method: str, axes: Sequence[SweepAxis], samples: Any, seed: int) -> Design:
    """Return a design without a table: a grid, or ``samples`` of a generator."""
    if not axes:
        raise InputError("sweep", Wording("empty"), "a table with at least one input, as in speed = " + FORMS)
    if method == GRID:
        return Grid(axes)
    for each in axes:
        if each.count is not None and not each.values and not each.choices:
            raise InputError(each.name, Wording("evenly spaced values"), f"{INTERVAL}, for the design {method}")
    return Samples(axes, samples, method, seed)


def _checked(count: int) -> int:
    if count > MOST:
        raise InputError("the number of tasks", count, f"at most {MOST}")
    return count


AT_A_TIME = 100_000
"""Number of table rows read at a time."""


def table_columns(
    path: Path, known: Mapping[str, Swept], given_units: Mapping[str, str] | None = None
) -> dict[str, tuple[str, NDArray[Any]]]:
    """Return the columns of a CSV or Parquet file that give inputs: SI unit and values [SI] by name.

    ``given_units`` gives units of columns without one, by input or dimension. A :class:`FileError` says that no column
    gives a ``known`` input, a column is named after an input with names, or rows or numbers are missing.
    """
    reader = open_table(path)
    try:
        words = _words(known)
        units_of = check_units(given_units or {}, words.dimensions)
        columns = layout(reader.headings, reader.path, reader.header_line, words, units_of, _as_key)
        used = columns.used
        for heading in columns.passed:
            if plain_name(heading) in known:  # inputs with names cannot be read from a table
                name = plain_name(heading)
                message = f'this column is not read; sweep it next to the table, as in {name} = ["..."], or rename it'
                raise FileError(str(path), reader.header_line, message, heading)
        if not used:
            raise FileError(str(path), reader.header_line, "no column of this table is an input that can be swept")
        parts: dict[str, list[NDArray[Any]]] = {each.quantity: [] for each in used}
        for chunk in reader.chunks(AT_A_TIME, 0):
            if chunk.ragged:
                raise FileError(str(path), chunk.ragged[0].line, chunk.ragged[0].reason)
            for row, reason in summaries_in(chunk, columns).items():
                raise FileError(str(path), chunk.lines[row], f"{reason}; remove it")
            for column in used:
                numbers, bad = chunk.numbers(column)
                if bad:
                    row = min(bad)
                    raise FileError(str(path), chunk.lines[row], bad[row], column.quantity)
                values = units.to_si(numbers, column.unit)
                flaws = (whole_flaw(each, known[column.quantity]) for each in values.tolist())
                if flaw := next(((row, each) for row, each in enumerate(flaws) if each), None):
                    message = f"{column.quantity} must be {flaw[1]}"
                    raise FileError(str(path), chunk.lines[flaw[0]], message, column.quantity)
                parts[column.quantity].append(values)
    finally:
        reader.close()
    if not any(map(len, parts.values())):
        raise FileError(str(path), reader.header_line, "there are no rows below the header")
    return {
        name: (units.SI_UNITS[units.unit(known[name].unit or "1").dimension], np.concatenate(each))
        for name, each in parts.items()
    }


def _as_key(given: Mapping[str, str]) -> str:
    """Return how to give these units in a study file."""
    pairs = ", ".join(f'{name} = "{symbol}"' for name, symbol in given.items())
    return f"units = {{ {pairs} }} under [study]"


def _words(known: Mapping[str, Swept]) -> Vocabulary:
    """Return the words for numeric inputs: their names, and those used by launch monitors."""
    numbers = {name: units.unit(each.unit).dimension for name, each in known.items() if each.unit is not None}
    others = {word: name for word, name in delivery_words().names.items() if name in numbers}
    grouped = {plain(f"{known[name].group}_{name}"): name for name in numbers}
    return Vocabulary({**others, **grouped, **{plain(name): name for name in numbers}}, numbers)
