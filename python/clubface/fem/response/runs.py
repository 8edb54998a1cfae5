"""The table of strikes: each run by finite elements once, also where the design or an interrupted run goes on later."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.fem.balls import Ball
from clubface.fem.response.design import Part, Strike, strikes
from clubface.fem.resumable import ResumableTable
from clubface.fem.run import inputs_of, one_shot, strike
from clubface.fem.settings import Settings
from clubface.support.fingerprint import fingerprint
from clubface.support.warning import without_warnings

TARGETS = (
    "velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z", "contact_time", "peak_force",
)  # fmt: skip
"""What the model must give, SI."""
COLUMNS = ("part", "number", *TARGETS, "stopped", "inputs")
"""Of the table: which strike it is (the design tells how it is delivered), its results, and a sum of its inputs, by
which a row is run again where the design gives its number to another strike."""
DIGITS = 9
_SETTINGS = Settings(duration=2.5e-3, interval=2e-5, until_separation=True, threads=1)


class Strikes(NamedTuple):
    """Strikes and their results, one row each.

    Attributes
    ----------
    part
        Number of the part they belong to.
    inputs
        Inputs in the order of the core, shape (strikes, inputs).
    friction
        Coefficients of friction.
    found
        ``TARGETS`` by the finite elements, shape (strikes, targets).
    """

    part: NDArray[Any]
    inputs: NDArray[Any]
    friction: NDArray[Any]
    found: NDArray[Any]

    def where(self, chosen: NDArray[Any]) -> Strikes:
        """Return the chosen rows."""
        return Strikes(*(column[chosen] for column in self))


def run(
    ball: Ball,
    parts: Mapping[str, Part],
    path: str | os.PathLike[str],
    *,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Strikes:
    """Run the strikes of some parts that the table does not have yet, several at a time, and return all that ended.

    Parameters
    ----------
    ball
        The ball of pieces.
    parts
        The strikes, by what they are.
    path
        The table. It belongs to one ball, and is refused with another. Strikes that have changed are run again.
    workers
        Runs at a time; left out, as many as there are cores.
    progress
        Called with the rows there are and the rows in all.
    """
    planned = strikes(parts)

    with without_warnings():
        shots = {place: inputs_of(one_shot(each.club, each.delivery, ball)) for place, each in planned.items()}
    sums = {place: _sum([*inputs, planned[place].friction]) for place, inputs in shots.items()}

    def one(place: tuple[int, int], keep_going: Any, threads: int) -> dict[str, Any]:
        return {**_row(place, planned[place], ball, keep_going), "inputs": sums[place]}

    places = {place: (float(place[0]), float(place[1])) for place in planned}
    rows = ResumableTable(path, {"ball": ball.values()}, COLUMNS, {"stopped": str, "inputs": str}).fill(
        places, one, what="strikes", workers=workers, progress=progress,
        is_of=lambda place, row: row["inputs"] == sums[place],
    )  # fmt: skip
    pairs = [(place, row) for place, row in zip(planned, rows, strict=True) if not row["stopped"]]
    return Strikes(
        np.array([place[0] for place, _ in pairs]),
        np.array([shots[place] for place, _ in pairs]),
        np.array([planned[place].friction for place, _ in pairs]),
        np.array([[row[name] for name in TARGETS] for _, row in pairs]),
    )


def in_fit(of: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes the coefficients are fitted to: those that are not held out."""
    return np.isin(of.part, [place for place, part in enumerate(parts.values()) if not part.held_out])


def of_clubs(of: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes are with built-in clubs."""
    return np.isin(of.part, [place for place, part in enumerate(parts.values()) if part.built_in])


def _sum(values: Iterable[float]) -> str:
    """Return a text that tells inputs apart; another machine may differ in their last digits."""
    return fingerprint([f"{value + 0.0:.{DIGITS}g}" for value in values])[:8]


def _row(place: tuple[int, int], planned: Strike, ball: Ball, keep_going: Any) -> dict[str, Any]:
    club, delivery, friction = planned
    with without_warnings():
        found = strike(club, delivery, which=ball, friction=friction, settings=_SETTINGS, progress=keep_going)
    out = found.outcome()
    results = {name: float(f"{out[name]:.{DIGITS}g}") for name in TARGETS}
    return {"part": float(place[0]), "number": float(place[1]), **results, "stopped": found.stopped or ""}
