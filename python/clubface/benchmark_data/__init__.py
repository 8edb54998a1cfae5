"""Benchmark shots: 550 drives and 120 7-iron shots with known truth, in place of measured ones that are not public.

Deliveries and launches are as motion capture and a launch monitor would show them; true deliveries, true launches and
the model that made each shot stand beside. ``recipe.toml`` holds every number they were made with.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.benchmark_data.recipe import CLUBS as CLUBS, FOLDER, HEADS
from clubface.launch_monitor.reading import read_shots
from clubface.recorded.shots import RecordedShots
from clubface.support.checks import check_choice
from clubface.tables.parquet import pyarrow_for


@dataclass(frozen=True, kw_only=True, eq=False)
class BenchmarkShots:
    """The benchmark shots of one club.

    Attributes
    ----------
    club
        "driver" or "7-iron".
    head
        The built-in head they were hit with: "driver-as-printed" or "7-iron".
    measured
        Deliveries of motion capture and launches of a monitor, with their errors.
    truth
        The same shots as they truly were.
    player
        Number of the player of each shot, from 1.
    model
        Name of the model that made each launch.
    restitution_offset
        What was added to the model's restitution: scatter of the ball, and the place on the face.
    """

    club: str
    head: str
    measured: RecordedShots
    truth: RecordedShots
    player: NDArray[np.int64]
    model: NDArray[Any]
    restitution_offset: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.measured)

    def __repr__(self) -> str:
        return f"{len(self)} benchmark shots of the {self.club} by {len(set(self.player.tolist()))} players"


def load(club: str) -> BenchmarkShots:
    """Return the benchmark shots of ``club``, "driver" (550) or "7-iron" (120). Needs pyarrow."""
    check_choice("benchmark club", club, CLUBS)

    true_file = FOLDER / f"{club}-truth.parquet"
    beside = pyarrow_for(true_file).parquet.read_table(true_file, columns=["player", "model", "restitution_offset"])
    return BenchmarkShots(
        club=club,
        head=HEADS[club],
        measured=read_shots(FOLDER / f"{club}.parquet"),
        truth=read_shots(true_file),
        player=beside["player"].to_numpy(),
        model=beside["model"].to_numpy(),
        restitution_offset=beside["restitution_offset"].to_numpy(),
    )
