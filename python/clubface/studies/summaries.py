"""Means, spreads and extremes of a study's results, over all tasks and along every swept input."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError
from clubface.results.result import Described, Result
from clubface.studies.running import ChunkTally
from clubface.studies.store import Names, open_store
from clubface.support.checks import check_names

MOST_LEVELS = 40
"""Maximum number of values of an input listed individually; more are grouped into classes."""
CLASSES = 10


@dataclass(frozen=True)
class Figures:
    """Statistics of every quantity over some tasks, without those that have no result; all of shape (quantities,).

    Attributes
    ----------
    count
        Number of tasks with a result.
    mean, deviation
        Mean and population standard deviation [SI]; NaN without a result.
    least, most
        Extremes [SI].
    """

    count: NDArray[Any]
    mean: NDArray[Any]
    deviation: NDArray[Any]
    least: NDArray[Any]
    most: NDArray[Any]


@dataclass(frozen=True)
class Along:
    """Statistics along one swept input.

    Attributes
    ----------
    name, unit
        The input and its SI unit; None for names.
    levels
        The names, the values [SI], or the ends (from, to) of classes [SI]; a flat face, with infinite bulge or roll, is
        a separate level.
    figures
        Statistics of the tasks at each level.
    """

    name: str
    unit: str | None
    levels: Sequence[Any]
    figures: Sequence[Figures]


@dataclass(frozen=True, kw_only=True)
class Summary(Described):
    """Summary of a study's results.

    Attributes
    ----------
    quantities
        SI units of the summarised quantities, by name.
    overall
        Statistics over all tasks.
    along
        Statistics along each swept input.
    failed, remark
        As in :class:`clubface.studies.Joined`.
    study
        The study file, or the folder of its store.
    """

    name: str
    tasks: int
    quantities: Mapping[str, str]
    overall: Figures
    along: Sequence[Along]
    failed: tuple[int, str]
    remark: str
    study: str

    def to_result(self) -> Result:
        """Return means, spreads and extremes, over all tasks and along every input, as a result."""
        from clubface.studies.study_result import summary_result

        return summary_result(self)


class _Sums:
    """Means and spreads by level, accumulated part by part in a fixed order (Chan, Golub and LeVeque, 1983)."""

    def __init__(self, levels: int, quantities: int) -> None:
        shape = (levels, quantities)
        self._count, self._mean, self._squares = np.zeros(shape), np.zeros(shape), np.zeros(shape)
        self._least, self._most = np.full(shape, math.inf), np.full(shape, -math.inf)

    def add(self, level: NDArray[Any], values: NDArray[Any]) -> None:
        """Add tasks with their levels (from 0) and values, shape (quantities, tasks)."""
        levels = len(self._count)
        for place, every in enumerate(values):
            there = np.isfinite(every)
            at, finite = level[there], every[there]
            count = np.bincount(at, minlength=levels)
            some = np.maximum(count, 1)
            mean = np.bincount(at, finite, levels) / some
            squares = np.bincount(at, (finite - mean[at]) ** 2, levels)
            before, whole = self._count[:, place].copy(), self._count[:, place] + count
            shift = (mean - self._mean[:, place]) * (count > 0)
            self._mean[:, place] += shift * count / np.maximum(whole, 1)
            self._squares[:, place] += squares + shift**2 * before * count / np.maximum(whole, 1)
            self._count[:, place] = whole
            np.minimum.at(self._least[:, place], at, finite)
            np.maximum.at(self._most[:, place], at, finite)

    def figures(self) -> list[Figures]:
        """Return the statistics of each level."""
        none = self._count == 0
        some = np.where(none, np.nan, self._count)
        columns = (
            self._count.astype(int), np.where(none, np.nan, self._mean), np.sqrt(self._squares / some),
            np.where(none, np.nan, self._least), np.where(none, np.nan, self._most),
        )  # fmt: skip
        return [Figures(*each) for each in zip(*columns, strict=True)]


class _Levels:
    """The levels of one swept input: its values if they are few, otherwise classes."""

    def __init__(self, name: str, unit: str | None, choices: Sequence[str]) -> None:
        self.name, self.unit, self._choices = name, unit, tuple(choices)
        self._values: set[float] = set()
        self._least, self._most = math.inf, -math.inf
        self._holds_flat = False

    def look(self, values: NDArray[Any] | Names) -> None:
        """Collect values, before any are counted."""
        if isinstance(values, Names):
            return
        if len(self._values) <= MOST_LEVELS:
            self._values.update(np.unique(values)[: MOST_LEVELS + 1].tolist())
        finite = values[np.isfinite(values)]
        self._holds_flat |= bool(np.isposinf(values).any())
        if finite.size:
            self._least, self._most = min(self._least, float(finite.min())), max(self._most, float(finite.max()))

    @property
    def levels(self) -> list[Any]:
        """The names, values, or ends of classes."""
        if self.unit is None:
            return list(self._choices)
        if len(self._values) <= MOST_LEVELS:
            return sorted(self._values)
        width = (self._most - self._least) / CLASSES
        ends = [self._least + width * place for place in range(CLASSES)] + [self._most]
        return [*pairwise(ends), *([math.inf] if self._holds_flat else [])]

    def places(self, values: NDArray[Any] | Names) -> NDArray[Any]:
        """Return the level of each value."""
        if isinstance(values, Names):
            return values.codes
        if len(self._values) <= MOST_LEVELS:
            return np.searchsorted(self.levels, values)
        inner = [first for first, _ in self.levels[1:CLASSES]]
        return np.where(np.isposinf(values), CLASSES, np.searchsorted(inner, values, side="right"))


def summary(
    study: str | os.PathLike[str],
    *,
    quantities: Sequence[str] | None = None,
    store: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Summary:
    """Summarise a study, all of whose parts must exist, in constant memory.

    Parameters
    ----------
    study, store
        As for :func:`clubface.studies.status`.
    quantities
        The quantities to summarise; default all.
    progress
        Called with the number of parts read and the total; every part is read twice.
    """
    if isinstance(quantities, str) or not isinstance(quantities, Iterable | None):
        raise InputError("quantities", quantities, 'a list of quantities, as in ["carry"]')
    opened = open_store(study, store)
    known = {name: unit for name, (unit, _) in opened.record["columns"].items()}
    names = list(dict.fromkeys(quantities if quantities is not None else known))
    check_names("quantity of the study", names, known)
    if not names:
        raise InputError("quantities", names, "at least one")
    along = [_Levels(each["name"], each["unit"], each["choices"]) for each in opened.record["axes"]]
    for number, (columns, _) in enumerate(opened.parts(), 1):
        for each in along:
            each.look(columns[each.name])
        if progress is not None:
            progress(number, 2 * opened.chunks)
    overall = _Sums(1, len(names))
    sums = [_Sums(len(each.levels), len(names)) for each in along]
    tally = ChunkTally()
    for number, (columns, metadata) in enumerate(opened.parts(), 1):
        values = np.stack([columns[name] for name in names])  # pyright: ignore[reportArgumentType, reportCallIssue]
        overall.add(np.zeros(metadata["tasks"], dtype=np.int64), values)
        for each, levels in zip(sums, along, strict=True):
            each.add(levels.places(columns[levels.name]), values)
        tally.add_notes(metadata)
        if progress is not None:
            progress(opened.chunks + number, 2 * opened.chunks)
    return Summary(
        name=opened.record["name"], tasks=opened.count, quantities={name: known[name] for name in names},
        overall=overall.figures()[0], failed=tally.failed, remark=tally.remark, study=os.fspath(study),
        along=[
            Along(each.name, each.unit, each.levels, levels.figures()) for each, levels in zip(along, sums, strict=True)
        ],
    )  # fmt: skip
