"""Impacts at points of a face and the flights after them, by any model."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.design.comparison.quantities import FLOWN, LAUNCHED, QUANTITIES
from clubface.equipment.backends import MODULES
from clubface.equipment.clubs import Club
from clubface.errors import RangeWarning, ShotError
from clubface.simulation.flight import fly
from clubface.simulation.flight_inputs import BALL, SPIN, VELOCITY
from clubface.simulation.impact import impact
from clubface.simulation.outside import Tally
from clubface.simulation.quantities import outputs
from clubface.support.resuming import Store, unfinished
from clubface.support.warning import is_silent, without_warnings

CHUNK = 2**16
"""Points in memory at a time."""


class Struck(NamedTuple):
    """How a face is struck: everything but where.

    Attributes
    ----------
    club, model, parameters, ball, accuracy
        As for :func:`clubface.impact`.
    delivery
        The values [SI] but ``toe`` and ``high``.
    conditions
        Air, wind and ground of the flights.
    """

    club: Club
    model: str
    parameters: Any
    ball: Any
    accuracy: float | None
    delivery: Mapping[str, Any]
    conditions: Mapping[str, Any]

    @property
    def takes_long(self) -> bool:
        """Whether the model takes about a second a shot, so that points of the face are few."""
        return self.model in MODULES

    def at(
        self,
        toe: NDArray[Any],
        high: NDArray[Any],
        *,
        remark: bool = False,
        progress: Callable[[int], object] | None = None,
    ) -> NDArray[Any]:
        """Return ``QUANTITIES`` [SI] at points [m], shape (quantities, points); NaN where there is no shot.

        With ``remark`` it warns of shots outside the range of the model. ``progress`` is called with the number of
        points done.
        """
        found, outside = np.empty((len(QUANTITIES), toe.size)), Tally()
        for start in range(0, toe.size, CHUNK):
            some = slice(start, start + CHUNK)
            with without_warnings(RangeWarning):
                launch = impact(
                    self.club, {**self.delivery, "toe": toe[some], "high": high[some]}, model=self.model,
                    parameters=self.parameters, ball=self.ball, accuracy=self.accuracy, on_error="nan",
                    progress=progress and partial(_told, progress, start),
                )  # fmt: skip
                flight = fly(launch, **self.conditions, on_error="nan")
            outside.add(launch)
            found[:, some] = [(launch if name in LAUNCHED else flight).get(name) for name in QUANTITIES]
        if remark and not is_silent(RangeWarning):
            outside.warn()
        return found


def run_points(
    struck: Struck,
    toe: NDArray[Any],
    high: NDArray[Any],
    *,
    output: str | os.PathLike[str] | None,
    workers: int | None,
    progress: Callable[[int, int], object] | None,
) -> NDArray[Any]:
    """Return what :meth:`Struck.at` does, point after point by finite elements, one point on each core.

    Parameters
    ----------
    struck
        How the face is struck, by finite elements.
    toe, high
        Points [m].
    output
        A file. What is finished is kept in a folder beside it, and the same call goes on after it.
    workers
        Points at a time; left out, one for each core.
    progress
        Called with the number of points done and the number of points.
    """
    from clubface.fem.run import strike
    from clubface.fem.settings import Settings
    from clubface.fem.side_by_side import side_by_side, workers_of

    workers_of(workers)
    places = list(zip(toe.tolist(), high.tolist(), strict=True))
    friction = struck.parameters.values["friction"]
    found: dict[tuple[float, float], list[float | None]] = {}

    def run(
        place: tuple[float, float], keep_going: Callable[[float, float], object], threads: int
    ) -> list[float | None]:
        try:
            result = strike(
                struck.club, {**struck.delivery, "toe": place[0], "high": place[1]}, which=struck.ball,
                friction=friction, settings=Settings(until_separation=True, threads=threads), progress=keep_going,
            )  # fmt: skip
        except ShotError:
            return [None] * len(outputs())
        launch = result.launch
        if launch is None or result.stopped is not None:
            return [None] * len(outputs())
        return [_or_none(float(launch.get(name))) for name in outputs()]

    with _store(output, struck, places) as store:
        if store is not None:
            found = {place: store[_name(place)] for place in places if _name(place) in store}

        def ended(place: tuple[float, float], row: list[float | None]) -> None:
            found[place] = row
            if store is not None:
                store.keep(_name(place), row)
            if progress is not None:
                progress(len(found), len(places))

        try:
            side_by_side([place for place in places if place not in found], run, ended, workers=workers)
        except KeyboardInterrupt:
            kept = f"; they are in {store.folder}, and the same command goes on after them" if store else ""
            raise KeyboardInterrupt(f"{len(found)} of {len(places)} points are done{kept}") from None
    table = np.array([[np.nan if each is None else each for each in found[place]] for place in places]).T
    return _with_flights(struck, table)


def _told(progress: Callable[[int], object], before: int, done: int) -> None:
    progress(before + done)


def finished(output: str | os.PathLike[str] | None) -> None:
    """Remove what was kept of the points of a file that is written."""
    if output is not None and (folder := unfinished(Path(output))).exists():
        import shutil

        shutil.rmtree(folder, ignore_errors=True)


def _with_flights(struck: Struck, table: NDArray[Any]) -> NDArray[Any]:
    """Return ``QUANTITIES`` for outputs of launches, shape (outputs, points)."""
    from clubface.fem.balls import ball

    by_name = dict(zip(outputs(), table, strict=True))
    good = np.isfinite(by_name["velocity_x"])
    found = np.full((len(QUANTITIES), table.shape[1]), np.nan)
    found[: len(LAUNCHED)] = [by_name[name] for name in LAUNCHED]
    if good.any():
        given: dict[str, Any] = {name: by_name[name][good] for name in (*VELOCITY, *SPIN)}
        rigid = ball(struck.ball).rigid.inputs()
        flight = fly({**given, **{name: rigid[name] for name in BALL}}, **struck.conditions, on_error="nan")
        found[len(LAUNCHED) :, good] = [flight.get(name) for name in FLOWN]
    return found


def _store(
    output: str | os.PathLike[str] | None, struck: Struck, places: list[tuple[float, float]]
) -> AbstractContextManager[Store | None]:
    """Return what keeps the points that are done, or nothing where no file is written."""
    if output is None:
        return nullcontext()
    from clubface.fem.balls import ball
    from clubface.fem.heads.meshed import mesh_of

    folder = unfinished(Path(output))
    head = mesh_of(struck.club)
    content = {
        "club": [struck.club.inputs(), None if head is None else head.values()],
        "ball": ball(struck.ball).values(),
        "delivery": dict(struck.delivery),
        "parameters": dict(struck.parameters.values),
        "grid": places,
    }
    return Store(folder, content, of=Path(output), otherwise=f"finish that with the same command, or remove {folder}")


def _name(place: tuple[float, float]) -> str:
    return f"{place[0]!r},{place[1]!r}"


def _or_none(value: float) -> float | None:
    return value if value == value else None
