"""Which inputs task i of a study has: a pure function of the study and i, so that any worker can compute any task."""

from __future__ import annotations

import copy
import math
import threading
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError, Told
from clubface.studies.axes import FORMS, INTERVAL, MOST, Axis
from clubface.support.checks import is_count

GRID, HYPERCUBE, SOBOL, TABLE = DESIGNS = ("grid", "latin-hypercube", "sobol", "table")
"""Every combination of values, two ways to fill the space between ends, and the rows of a file."""
MOST_HYPERCUBE = 1_000_000
"""Samples of a Latin hypercube, which is drawn as a whole by every worker."""
BITS = 32
"""Of a coordinate of a Sobol point: the sequence has 2**32 points. SciPy passes over points of no more bits."""


class Design(Protocol):
    """What is computed.

    Attributes
    ----------
    axes
        The swept inputs.
    count
        The number of tasks.
    """

    axes: tuple[Axis, ...]
    count: int

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name: SI, or the places of names among an axis's choices."""
        ...


STRIDE = 2**22
"""Points of a Sobol sequence after which its state is kept; it takes 10 ms to pass over them."""


class Grid:
    """Every combination of the values of some axes, the last of which changes first. See :class:`Design`."""

    def __init__(self, axes: Sequence[Axis]) -> None:
        self.axes = tuple(axes)
        for each in self.axes:
            if each.count is None:
                wanted = "evenly spaced values, with a count or a step, in a grid; an interval is for samples"
                raise InputError(each.name, Told("an interval"), wanted)
        self.count = _checked(math.prod(each.count or 1 for each in self.axes))

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        return self.at(np.arange(tasks.start, tasks.stop))

    def at(self, places: NDArray[Any]) -> dict[str, NDArray[Any]]:
        """Return the inputs of combinations by name."""
        found = {}
        for each in reversed(self.axes):
            places, place = np.divmod(places, each.count or 1)
            found[each.name] = each.at(place)
        return {each.name: found[each.name] for each in self.axes}


class Samples:
    """Points that fill the space between the ends of some axes evenly, of SciPy's generators. See :class:`Design`."""

    def __init__(self, axes: Sequence[Axis], samples: Any, method: str, seed: int) -> None:
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
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # that a chunk is not balanced: the whole is what counts
            return made.random(len(tasks))

    def _sequence(self, start: int) -> Any:
        """Return the sequence at a point. It is only passed over forwards, so that states on the way are kept."""
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


class Rows:
    """The rows of a table, for each combination of the values of other axes. See :class:`Design`."""

    def __init__(self, columns: Mapping[str, tuple[str, NDArray[Any]]], others: Sequence[Axis]) -> None:
        self._columns = {name: values for name, (_, values) in columns.items()}
        self._rows = len(next(iter(self._columns.values())))
        self._others = Grid(others)
        of_table = (Axis(name=name, unit=unit, count=self._rows) for name, (unit, _) in columns.items())
        self.axes = (*self._others.axes, *of_table)
        self.count = _checked(self._rows * self._others.count)

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        blocks, rows = np.divmod(np.arange(tasks.start, tasks.stop), self._rows)
        return self._others.at(blocks) | {name: values[rows] for name, values in self._columns.items()}


class Remembered:
    """A design that keeps what it last returned to each thread: the task and the part of a chunk both ask for it."""

    def __init__(self, of: Design) -> None:
        self.axes, self.count = of.axes, of.count
        self._of, self._last = of, threading.local()

    def values(self, tasks: range) -> dict[str, NDArray[Any]]:
        """Return the inputs of consecutive tasks by name."""
        if getattr(self._last, "tasks", None) != tasks:
            self._last.tasks, self._last.values = None, self._of.values(tasks)
            self._last.tasks = tasks
        return dict(self._last.values)


def design(method: str, axes: Sequence[Axis], samples: Any, seed: int) -> Design:
    """Return a design of axes alone: a grid, or ``samples`` of a generator."""
    if not axes:
        raise InputError("sweep", Told("empty"), "a table with at least one input, as in speed = " + FORMS)
    if method == GRID:
        return Grid(axes)
    for each in axes:
        if each.count is not None and not each.values and not each.choices:
            raise InputError(each.name, Told("evenly spaced values"), f"{INTERVAL}, for the design {method}")
    return Samples(axes, samples, method, seed)


def _checked(count: int) -> int:
    if count > MOST:
        raise InputError("the number of tasks", count, f"at most {MOST}")
    return count
