"""The published tour averages, club by club, and what every model makes of them.

Each club of the built-in set is delivered at its published speed and attack angle. Its dynamic loft is published
for two clubs only; for the others it is that with which the ``standard`` model gives the published launch angle, and
every model uses it. For those clubs the launch angle of ``standard`` is thus no prediction.
"""

from __future__ import annotations

import csv
import os
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.models import model, models
from clubface.errors import InputError
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats
from clubface.support.shipped import DATA

SOURCE = "PGA Tour averages published by TrackMan (2023): trackman.com/blog/golf/introducing-updated-tour-averages"
LOFT_MODEL = "standard"
"""The model whose launch angle fixes the lofts that are not published."""

QUANTITIES = {"ball_speed": "mph", "launch": "deg", "spin": "rpm", "carry": "yd"}
"""What is compared, and the unit it is read in. Spin is the total spin, as launch monitors report it."""
STEEPEST = units.to_si(78.0, "deg")
"""The largest dynamic loft [rad] that is tried."""
_DIMENSIONS = {
    "club_speed": "speed", "attack": "angle", "ball_speed": "speed", "smash": "dimensionless", "launch": "angle",
    "spin": "angular rate", "loft": "angle", "height": "length", "land": "angle", "carry": "length",
}  # fmt: skip


class Average(NamedTuple):
    """The published averages of one club, SI.

    Attributes
    ----------
    club
        Its name, that of a built-in club.
    club_speed, attack
        Delivery [m/s, rad].
    ball_speed, smash, launch, spin
        Launch [m/s, 1, rad, rad/s].
    height, land, carry
        Flight: apex [m], landing angle [rad], carry [m].
    """

    club: str
    club_speed: float
    attack: float
    ball_speed: float
    smash: float
    launch: float
    spin: float
    height: float
    land: float
    carry: float


def averages() -> list[Average]:
    """Read the published averages that come with the package, driver to pitching wedge."""
    return [Average(**row) for row in _rows("tour_averages.csv")]


@cache
def published_lofts() -> dict[str, float]:
    """Return the dynamic lofts [rad] that are published, by club; those of the other clubs are not."""
    return {row["club"]: row["loft"] for row in _rows("tour_lofts.csv")}


def _rows(name: str) -> list[dict[str, Any]]:
    """Read a table of clubs, SI."""
    with (DATA / name).open(newline="") as file:
        return [_row(row) for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def _row(row: dict[str, str]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for heading, text in row.items():
        name, unit = units.parse_column_name(heading, ("club",))
        found[name] = text if name == "club" else units.parse(f"{text} {unit or ''}", _DIMENSIONS[name], name=heading)
    return found


@dataclass(frozen=True)
class Tour:
    """Published averages and models, SI; every array holds one value a club.

    Attributes
    ----------
    averages
        The published averages.
    lofts
        Dynamic loft of each club [rad].
    loft_is_published
        Whether it is published, or solved with ``LOFT_MODEL``.
    launches
        The launches of each model, one a club.
    values
        Each quantity of ``QUANTITIES`` by model, the carry from the model's own launch.
    carry_of_published
        Carry [m] of the flight model from the published ball speed, launch angle and spin.
    """

    averages: tuple[Average, ...]
    lofts: Floats
    loft_is_published: tuple[bool, ...]
    launches: dict[str, list[Launch]]
    values: dict[str, dict[str, Floats]]
    carry_of_published: Floats

    @property
    def clubs(self) -> list[str]:
        """The clubs, in the order of the published table."""
        return [each.club for each in self.averages]

    @property
    def models(self) -> list[str]:
        """The models, in the order asked for."""
        return list(self.values)

    @property
    def units(self) -> dict[str, str]:
        """The quantities compared and the unit each is read in."""
        return QUANTITIES

    @cached_property
    def published(self) -> dict[str, Floats]:
        """The published value of each quantity."""
        return {name: np.array([getattr(each, name) for each in self.averages]) for name in QUANTITIES}

    def errors(self, model_name: str) -> dict[str, Floats]:
        """Return model less published, by quantity."""
        return {name: self.values[model_name][name] - self.published[name] for name in QUANTITIES}

    def mean_absolute_error(self, model_name: str) -> dict[str, float]:
        """Return the mean over the clubs of the absolute error, by quantity."""
        return {name: float(np.abs(error).mean()) for name, error in self.errors(model_name).items()}


def tour(model_names: Iterable[str] | None = None, *, ball: str | os.PathLike[str] | Ball | None = None) -> Tour:
    """Deliver every club of the published averages and compute its launch and flight by every model.

    Parameters
    ----------
    model_names
        Which models; all of the registry unless given.
    ball
        As for :func:`clubface.impact`.
    """
    names = [model(name).name for name in (models() if model_names is None else model_names)]
    if not names:
        raise InputError("model_names", names, "at least one model")
    rows = tuple(averages())
    is_published = tuple(each.club in published_lofts() for each in rows)
    lofts = np.array([dynamic_loft(each) for each in rows])
    launches = {
        name: [
            impact(each.club, speed=each.club_speed, attack=each.attack, loft=loft, model=name, ball=ball)
            for each, loft in zip(rows, lofts.tolist(), strict=True)
        ]
        for name in names
    }
    return Tour(rows, lofts, is_published, launches, {k: _compared(v) for k, v in launches.items()}, _flown(rows))


def dynamic_loft(average: Average) -> float:
    """Return the dynamic loft [rad]: published, or that with which ``standard`` gives the published launch angle."""
    if average.club in published_lofts():
        return published_lofts()[average.club]
    return solve_loft(average.club, average.club_speed, average.attack, average.launch)


def solve_loft(club: str, speed: float, attack: float, launch: float, *, resolution: float = 1e-10) -> float:
    """Return the dynamic loft [rad] with which ``standard`` launches the ball at the angle ``launch`` [rad].

    Each round computes a row of lofts in one batch and keeps the interval in which the launch angle passes its target,
    until it is narrower than ``resolution`` [rad].
    """
    low, high = launch, max(launch, STEEPEST)
    while high - low > resolution or high <= launch:
        tried = np.linspace(low, high, 65)
        found = impact(club, speed=speed, attack=attack, loft=tried, model=LOFT_MODEL).launch
        above = np.flatnonzero(found >= launch)
        if not above.size or above[0] == 0:
            raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
        low, high = float(tried[above[0] - 1]), float(tried[above[0]])
    return 0.5 * (low + high)


def _compared(launches: list[Launch]) -> dict[str, Floats]:
    return {
        "ball_speed": np.array([each.ball_speed for each in launches]),
        "launch": np.array([each.launch for each in launches]),
        "spin": np.array([each.total_spin for each in launches]),
        "carry": np.array([fly(each).carry for each in launches]),
    }


def _flown(rows: Iterable[Average]) -> Floats:
    """Return the carry from each published launch, taken as straight and with pure backspin."""
    return np.array(
        [fly({"ball_speed": each.ball_speed, "launch": each.launch, "backspin": each.spin}).carry for each in rows]
    )
