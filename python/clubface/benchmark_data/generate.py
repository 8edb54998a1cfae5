"""The benchmark files from their recipe, bit for bit: ``python -m clubface.benchmark_data.generate``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.benchmark_data import impacts, measured, swings
from clubface.benchmark_data.recipe import CLUBS, FOLDER, Recipe, recipe
from clubface.simulation.quantities import inputs, outputs
from clubface.support.arrays import Floats
from clubface.support.whole_file import whole_file
from clubface.tables.headings import heading_of
from clubface.tables.parquet import pyarrow_for

CAPTURE_DIGITS = {"mm": 1, "deg/s": 0}
"""Decimals of a measured delivery in the unit of its column; 2 for speed and angles."""
MONITOR_DIGITS = {"rpm": 0}
"""Decimals of a measured launch; 1 for speed and angles, as monitors show them."""
TRUE_DIGITS = 5
"""Decimals of a true value, so that its file is the same on every machine."""


class Made(NamedTuple):
    """The shots of one club, SI, one element a shot.

    Attributes
    ----------
    player
        Number of the player, from 1.
    model
        The model that made the launch.
    restitution
        What was added to its restitution: the ball, and the place on the face.
    true_delivery, true_launch
        What happened.
    delivery, launch
        What was measured.
    """

    player: NDArray[np.int64]
    model: NDArray[Any]
    restitution: Floats
    true_delivery: dict[str, Floats]
    true_launch: dict[str, Floats]
    delivery: dict[str, Floats]
    launch: dict[str, Floats]


def make(of: Recipe) -> Made:
    """Return the shots of one club."""
    random = np.random.default_rng(of.seed)
    player = swings.players_of(of) + 1
    truth = _rounded(swings.deliveries(of, random), {}, TRUE_DIGITS)
    names = list(of.mixture)
    model = np.array(names, dtype=object)[(random.random(of.shots) * len(names)).astype(int)]
    scatter = of.ball_scatter * random.standard_normal(of.shots)
    restitution = np.round(impacts.restitution_offsets(of, truth, scatter), 9)
    launch = {name: np.empty(of.shots) for name in impacts.LAUNCH}
    for name in names:
        own = model == name
        found = impacts.launches(of, name, {key: each[own] for key, each in truth.items()}, restitution[own])
        for key, values in found.items():
            launch[key][own] = values
    launch = _rounded(launch, {}, TRUE_DIGITS)
    delivery = _rounded(measured.captured(of, truth, random), CAPTURE_DIGITS, 2)
    monitored = _rounded(measured.monitored(of, launch, random), MONITOR_DIGITS, 1)
    return Made(player, model, restitution, truth, launch, delivery, monitored)


def tables(of: Recipe) -> dict[str, dict[str, Any]]:
    """Return the columns of the two files of one club, by the name of the file."""
    made = make(of)
    first: dict[str, Any] = {"club": [of.head] * of.shots, "player": made.player}
    kept = {"model": made.model.tolist(), "restitution_offset": made.restitution}
    return {
        f"{of.club}.parquet": first | _columns(made.delivery | made.launch),
        f"{of.club}-truth.parquet": first | kept | _columns(made.true_delivery | made.true_launch),
    }


def write(folder: Path = FOLDER) -> list[Path]:
    """Write the files of all clubs; return them."""
    files = []
    for club in CLUBS:
        for name, columns in tables(recipe(club)).items():
            path = folder / name
            arrow = pyarrow_for(path)
            with whole_file(path) as file:
                arrow.parquet.write_table(arrow.table(columns), file, compression="zstd")
            files.append(path)
    return files


def _unit(name: str) -> tuple[str, str]:
    """Return heading and unit of the column of a quantity."""
    return heading_of(name, (inputs()[name] if name in inputs() else outputs()[name]).unit)


def _rounded(values: dict[str, Floats], digits: dict[str, int], otherwise: int) -> dict[str, Floats]:
    """Return SI values as they are read back from a column with so many decimals."""
    found = {}
    for name, each in values.items():
        shown = _unit(name)[1]
        cells = np.round(units.from_si(each, shown), digits.get(shown, otherwise)) + 0.0  # no negative zero
        found[name] = units.to_si(cells, shown)
    return found


def _columns(values: dict[str, Floats]) -> dict[str, Floats]:
    """Return columns in the units of their headings; what conversion and back leaves behind is rounded away."""
    return {_unit(name)[0]: np.round(units.from_si(each, _unit(name)[1]), 9) for name, each in values.items()}


if __name__ == "__main__":
    for file in write(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER):
        print(f"{file}: {file.stat().st_size} bytes")
