"""The published averages of the tours, club by club, and what every model makes of them.

Each club is delivered at its published speed and attack angle. Where its dynamic loft is published, every model uses
that. For every other club each model gets the loft with which it launches the ball at the published angle: its launch
angle is then no prediction, but ball speed, spin and carry are, and the loft carries no other model's errors.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import measurements, units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import CLUB_NAMES
from clubface.equipment.models import model, models
from clubface.errors import InputError, RangeWarning
from clubface.measurements import PublishedTable
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.simulation.outside import warn_if_outside
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice
from clubface.support.warning import without_warnings
from clubface.tour.spin_ratio import FLATTENED, RIGID, loft_of_ratio, spin_ratio, spin_ratio_of

TABLES = {"pga-2023": None, "pga-2019": "PGA Tour", "lpga-2019": "LPGA Tour"}
"""The published tables that models are compared with, each with the group whose published dynamic lofts belong to it.
The LPGA Tour's of 2023 is not among them, since one of its spins looks misprinted."""
DEFAULT_TABLE = "pga-2023"

QUANTITIES = {"ball_speed": "mph", "launch": "deg", "spin": "rpm", "carry": "yd"}
"""What is compared, and the unit it is read in. Spin is the total spin, as launch monitors report it."""

LOWEST, STEEPEST = units.to_si(-20.0, "deg"), units.to_si(78.0, "deg")
"""The dynamic lofts [rad] between which one is looked for."""
SLOPE = 0.85
"""Change of the launch angle with the loft, for the first step of the search."""
FAR_APART = 1e-3
TRIES = 16
RESOLUTION, COARSE_RESOLUTION = 1e-10, 1e-5
"""How closely a solved loft gives its launch angle [rad]: by a reduced model, and by one that takes long."""
REACHED = 2e-5
"""What is further off [rad] after all tries is out of reach; the steps of contact models alone make some 1e-6."""


class Average(NamedTuple):
    """The published averages of one club, SI.

    Attributes
    ----------
    club
        Its name, that of a built-in club.
    club_speed, attack
        Delivery [m/s, rad].
    ball_speed, launch, spin
        Launch [m/s, rad, rad/s].
    apex, landing_angle, carry
        Flight [m, rad, m].
    """

    club: str
    club_speed: float
    attack: float
    ball_speed: float
    launch: float
    spin: float
    apex: float
    landing_angle: float
    carry: float


def averages(table: str = DEFAULT_TABLE) -> list[Average]:
    """Return the rows of a table of ``TABLES``, driver to pitching wedge, for which there is a built-in club."""
    found = _table(table)
    rows = zip(*(found[name].tolist() for name in Average._fields), strict=True)
    return [row for row in map(Average._make, rows) if row.club in CLUB_NAMES]


def published_lofts(table: str) -> dict[str, float]:
    """Return the published dynamic lofts [rad] that belong to a table of ``TABLES``, by club."""
    _table(table)
    lofts = measurements.table("dynamic-lofts")
    rows = zip(lofts["group"], lofts["club"], lofts["dynamic_loft"], strict=True)
    return {str(club): float(loft) for group, club, loft in rows if group == TABLES[table]}


def _table(name: str) -> PublishedTable:
    check_choice("table of tour averages", name, TABLES)
    return measurements.table(name)


@dataclass(frozen=True)
class Tour:
    """Published averages and models, SI; every array holds one value a club.

    Attributes
    ----------
    table
        The published table.
    averages
        Its rows.
    loft_is_published
        For which clubs the dynamic loft is published; for the others each model has its own.
    lofts
        Dynamic loft with which each club is delivered [rad], by model: published, or solved.
    solved_lofts
        Dynamic loft [rad] with which each model launches as published, of every club.
    launches
        The launches of each model, one a club.
    values
        Each quantity of ``QUANTITIES`` by model, the carry from the model's own launch.
    carry_of_published
        Carry [m] of the flight model from the published ball speed, launch angle and spin.
    """

    table: PublishedTable
    averages: tuple[Average, ...]
    loft_is_published: NDArray[np.bool_]
    lofts: dict[str, Floats]
    solved_lofts: dict[str, Floats]
    launches: dict[str, list[Launch]]
    values: dict[str, dict[str, Floats]]
    carry_of_published: Floats

    @property
    def clubs(self) -> list[str]:
        """The clubs, in the order of the published table."""
        return [each.club for each in self.averages]

    @property
    def left_out(self) -> list[str]:
        """The clubs of the published table that have no built-in head."""
        return [str(club) for club in self.table["club"] if club not in self.clubs]

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

    def is_fitted(self, quantity: str) -> NDArray[np.bool_]:
        """Return for which clubs a quantity is no prediction: the launch angle from which the loft was solved."""
        return ~self.loft_is_published if quantity == "launch" else np.zeros(len(self.averages), dtype=bool)

    def errors(self, model_name: str) -> dict[str, Floats]:
        """Return model less published, by quantity."""
        return {name: self.values[model_name][name] - self.published[name] for name in QUANTITIES}

    def predicted(self, model_name: str, quantity: str) -> Floats:
        """Return the errors of one quantity for the clubs for which it is a prediction."""
        return self.errors(model_name)[quantity][~self.is_fitted(quantity)]

    def mean_absolute_error(self, model_name: str) -> dict[str, float]:
        """Return the mean of the absolute error over the clubs, by quantity; NaN where none of them is a prediction."""
        return mean_absolute_error([self], model_name)

    def published_ratios(self, model_name: str) -> Floats:
        """Return I w / (m R v_t) of the published launches along faces of the model's lofts."""
        balls = [each.ball for each in self.launches[model_name]]
        return self._over_launches(spin_ratio, balls, self.lofts[model_name])

    def own_ratios(self, model_name: str) -> Floats:
        """Return I w / (m R v_t) of the model's launches."""
        pairs = zip(self.launches[model_name], self.lofts[model_name].tolist(), strict=True)
        return np.array([spin_ratio_of(launch, loft) for launch, loft in pairs])

    @cached_property
    def possible_lofts(self) -> tuple[Floats, Floats]:
        """The least and the largest dynamic loft [rad] that the published launch allows a ball, flattened or round."""
        balls = [each.ball for each in self.launches[self.models[0]]]
        low, high = (self._over_launches(loft_of_ratio, balls, limit) for limit in (RIGID, FLATTENED))
        return low, high

    def _over_launches(self, of: Callable[..., object], balls: Iterable[Ball], last: object) -> Floats:
        rows = zip(balls, self.averages, np.broadcast_to(np.asarray(last), len(self.averages)).tolist(), strict=True)
        return np.array([of(ball, each.ball_speed, each.launch, each.spin, value) for ball, each, value in rows])


def mean_absolute_error(results: Iterable[Tour], model_name: str) -> dict[str, float]:
    """Return the mean absolute error of a model over all rows of several tables, by quantity."""
    results = list(results)
    found = {}
    for name in QUANTITIES:
        errors = np.concatenate([each.predicted(model_name, name) for each in results])
        found[name] = float(np.abs(errors).mean()) if errors.size else float("nan")
    return found


def tour(
    model_names: Iterable[str] | None = None,
    *,
    table: str = DEFAULT_TABLE,
    ball: str | os.PathLike[str] | Ball | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Tour:
    """Deliver every club of the published averages and compute its launch and flight by every model.

    Parameters
    ----------
    model_names
        Which models; all of the registry unless given.
    table
        A table of ``TABLES``.
    ball
        As for :func:`clubface.impact`.
    progress
        Called with the number of clubs done and of all, over all models.
    """
    names = [model(name).name for name in (models() if model_names is None else model_names)]
    if not names:
        raise InputError("model_names", names, "at least one model")
    rows, known = tuple(averages(table)), published_lofts(table)
    given = np.array([known.get(each.club, np.nan) for each in rows])
    solved: dict[str, Floats] = {}
    lofts: dict[str, Floats] = {}
    launches: dict[str, list[Launch]] = {}
    for place, name in enumerate(names):
        found = []
        for index, each in enumerate(rows):
            found.append(solve_loft(each.club, each.club_speed, each.attack, each.launch, model=name, ball=ball))
            if progress is not None:
                progress(place * len(rows) + index + 1, len(names) * len(rows))
        solved[name] = np.array(found)
        lofts[name] = np.where(np.isnan(given), solved[name], given)
        with without_warnings(RangeWarning):
            launches[name] = [
                impact(each.club, speed=each.club_speed, attack=each.attack, loft=loft, model=name, ball=ball)
                for each, loft in zip(rows, lofts[name].tolist(), strict=True)
            ]
    warn_if_outside(launch for found in launches.values() for launch in found)
    return Tour(
        table=_table(table),
        averages=rows,
        loft_is_published=~np.isnan(given),
        lofts=lofts,
        solved_lofts=solved,
        launches=launches,
        values={name: _compared(hits) for name, hits in launches.items()},
        carry_of_published=_flown(rows),
    )


def solve_loft(
    club: str,
    speed: float,
    attack: float,
    launch: float,
    *,
    model: str,
    ball: str | os.PathLike[str] | Ball | None = None,
) -> float:
    """Return the dynamic loft [rad] with which a model launches the ball at the angle ``launch`` [rad].

    Secants; tries closer together than ``FAR_APART`` keep the slope, which the steps of contact models would spoil.
    """
    resolution = RESOLUTION if model in models() else COARSE_RESOLUTION
    loft, slope = _within(launch + (1.0 / SLOPE - 1.0) * (launch - attack)), SLOPE
    tried: list[tuple[float, float]] = []
    while len(tried) < TRIES:
        with without_warnings(RangeWarning):  # of tries
            found = impact(club, speed=speed, attack=attack, loft=loft, model=model, ball=ball)
        tried.append((float(found.launch) - launch, loft))
        missing = tried[-1][0]
        if abs(missing) <= resolution:
            break
        if len(tried) > 1 and abs(loft - tried[-2][1]) > FAR_APART:
            slope = (missing - tried[-2][0]) / (loft - tried[-2][1])
        following = _within(loft - missing / slope)
        if following == loft:
            break
        loft = following
    missing, loft = min(tried, key=lambda each: abs(each[0]))
    if abs(missing) > REACHED:
        raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
    return loft


def _within(loft: float) -> float:
    return min(max(loft, LOWEST), STEEPEST)


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
