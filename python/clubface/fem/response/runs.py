"""The table of strikes: each run by finite elements once, in a file that grows row by row."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from clubface.fem.balls import Ball
from clubface.fem.response.design import Part, Strike, strikes
from clubface.fem.resumable import ResumableTable
from clubface.fem.run import strike
from clubface.fem.settings import Settings
from clubface.simulation.quantities import inputs

if TYPE_CHECKING:
    from numpy.typing import NDArray

TARGETS = (
    "velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z", "contact_time", "peak_force",
)  # fmt: skip
"""What the model must give."""
_SETTINGS = Settings(until_separation=True, threads=1)


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


def columns() -> tuple[str, ...]:
    """Return the columns of the table."""
    return ("part", "number", *inputs(), "friction", *TARGETS, "stopped")


def run(
    ball: Ball,
    parts: Mapping[str, Part],
    path: str | os.PathLike[str],
    *,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Strikes:
    """Run the strikes of some parts that the table does not have yet, several at a time, and return all."""
    planned = strikes(dict(parts))

    def one(place: tuple[int, int], keep_going: Any, threads: int) -> dict[str, Any]:
        return _row(place, planned[place], ball, keep_going)

    table = ResumableTable(path, [ball.values(), sorted(parts)], columns(), {"stopped": str})
    rows = table.fill(
        {place: (float(place[0]), float(place[1])) for place in planned},
        one, what="strikes", workers=workers, progress=progress,
    )  # fmt: skip
    return _of_rows([row for row in rows if not row["stopped"]])


def read(path: str | os.PathLike[str]) -> Strikes:
    """Return the strikes of a finished table."""
    import csv

    with Path(path).open(encoding="utf-8", newline="") as file:
        lines = [line for line in file if not line.startswith("#")]
    rows = [{key: value if key == "stopped" else float(value) for key, value in row.items()} for row in csv.DictReader(lines)]
    return _of_rows([row for row in rows if not row["stopped"]])


def _row(place: tuple[int, int], planned: Strike, ball: Ball, keep_going: Any) -> dict[str, Any]:
    result = strike(
        planned.club, planned.delivery, which=ball, friction=planned.friction, settings=_SETTINGS, progress=keep_going
    )
    out = result.outcome()
    assert result.hit is not None
    given = dict(zip(inputs(), map(float, result.hit.columns), strict=True))
    return {
        "part": float(place[0]),
        "number": float(place[1]),
        **given,
        "friction": planned.friction,
        **{name: float(out[name]) for name in TARGETS},
        "stopped": result.stopped or "",
    }


def _of_rows(rows: list[dict[str, Any]]) -> Strikes:
    import numpy as np

    def of(*names: str) -> Any:
        return np.array([[row[name] for name in names] for row in rows])

    return Strikes(of("part")[:, 0].astype(int), of(*inputs()), of("friction")[:, 0], of(*TARGETS))
