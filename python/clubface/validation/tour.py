"""The published averages of the tours, club by club, and what every model makes of them.

Each club is delivered at its published speed and attack angle. Where its dynamic loft is published, every model uses
that. For every other club each model gets the loft with which it launches the ball at the published angle: its launch
angle is then no prediction, but ball speed, spin and carry are, and the loft carries no other model's errors.

The spin of a ball beside its speed along the face: I w / (m R v_t), angular over linear momentum and radius.

A force along the face that acts at the distance R from the centre of a resting ball gives it m v_t along the face and I
w = R m v_t: the ratio is 1, whether the ball slides, sticks or rolls off. The centre of a ball that is flattened is
nearer to the face while the force acts, which makes it 0.85 to 0.95. That is for a face that does not turn, or nearly
for the face at maximum compression, whose loft TrackMan calls the dynamic loft. Until then a free head turns up by 0.5
to 0.9 degrees (irons) or less than 0.3 (woods), so that over the face of first touch the ratio is larger: for irons by
0.1 to 0.2, for a driver, along which the ball hardly moves, by up to as much as itself.

So a published speed, launch angle and spin belong to a narrow range of dynamic lofts, and with a loft that is further
off than the head turns they cannot be those of one shot.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import published_data, units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import TOUR_CLUBS
from clubface.equipment.models import model, models
from clubface.errors import InputError, RangeWarning
from clubface.published_data import PublishedTable
from clubface.results.result import Described, Result
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact, warn_if_outside
from clubface.simulation.launch import Launch
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.spin import rolling_speed
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, without_warnings
from clubface.validation.tour_result import tour_result

TABLES = {"pga-2023": None, "pga-2019": "PGA Tour", "lpga-2019": "LPGA Tour"}
"""The published tables that models are compared with, each with the group whose published dynamic lofts belong to it.
The LPGA Tour's of 2023 is not among them, since one of its spins looks misprinted."""
DEFAULT_TABLE = "pga-2023"


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
    found = published_table(table)
    rows = zip(*(found[name].tolist() for name in Average._fields), strict=True)
    return [row for row in map(Average._make, rows) if row.club in TOUR_CLUBS]


def published_lofts(table: str) -> dict[str, float]:
    """Return the published dynamic lofts [rad] that belong to a table of ``TABLES``, by club."""
    published_table(table)
    lofts = published_data.table("dynamic-lofts")
    rows = zip(lofts["group"], lofts["club"], lofts["dynamic_loft"], strict=True)
    return {str(club): float(loft) for group, club, loft in rows if group == TABLES[table]}


def published_table(name: str) -> PublishedTable:
    """Return a table of ``TABLES``."""
    check_choice("table of tour averages", name, TABLES)
    return published_data.table(name)


def solve_loft(
    club: str,
    speed: float,
    attack: float,
    launch: float,
    *,
    high: float = 0.0,
    model: str,
    ball: str | os.PathLike[str] | Ball | None = None,
) -> float:
    """Return the dynamic loft [rad] with which a model launches the ball at the angle ``launch`` [rad].

    The ball is struck ``high`` [m] above the face centre. A launch angle out of reach is an :class:`InputError`.
    """
    with without_warnings(RangeWarning):
        found = impact_at_launch(
            club, speed=speed, attack=attack, high=high, launch=launch, model=model, ball=ball
        )  # fmt: skip
    if math.isnan(found.loft):
        raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
    return found.loft


RIGID = 1.0
"""The ratio of a ball that stays round."""
FLATTENED = 0.85
"""The least ratio that a flattened ball has, in throws of finite elements at a plane."""


def spin_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, loft: Any) -> Any:
    """Return I w / (m R v_t) of launches [m/s, rad, rad/s] in the vertical plane of a face of dynamic loft [rad]."""
    return rolling_speed(ball, spin) / (speed * np.sin(loft - np.asarray(launch)))


def loft_of_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, ratio: float) -> NDArray[np.float64]:
    """Return the dynamic lofts [rad] with which launches have this ratio; NaN where no loft gives so much spin."""
    share = rolling_speed(ball, spin) / (np.asarray(speed) * ratio)
    return launch + np.arcsin(np.where(np.abs(share) <= 1.0, share, np.nan))


def spin_ratio_of(found: Launch, loft: float) -> float:
    """Return the ratio of one launch over a square face of loft [rad] at first touch, all directions taken together."""
    normal = np.array([np.cos(loft), np.sin(loft), 0.0])
    velocity = np.array([found.velocity_x, found.velocity_y, found.velocity_z])
    along = velocity - normal * (velocity @ normal)
    return float(rolling_speed(found.ball, found.total_spin) / np.linalg.norm(along))


QUANTITIES = ("ball_speed", "launch", "spin", "carry")
"""What is compared. Spin is the total spin, as launch monitors report it."""


@dataclass(frozen=True)
class Tour(Described):
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

    @cached_property
    def published(self) -> dict[str, Floats]:
        """The published value of each quantity."""
        return {name: np.array([getattr(each, name) for each in self.averages]) for name in QUANTITIES}

    def to_result(self) -> Result:
        """Return it as a result."""
        return tour_result([self])

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

    def _over_launches(self, compute: Callable[..., object], balls: Iterable[Ball], last: object) -> Floats:
        rows = zip(balls, self.averages, np.broadcast_to(np.asarray(last), len(self.averages)).tolist(), strict=True)
        return np.array([compute(ball, each.ball_speed, each.launch, each.spin, value) for ball, each, value in rows])


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
        table=published_table(table),
        averages=rows,
        loft_is_published=~np.isnan(given),
        lofts=lofts,
        solved_lofts=solved,
        launches=launches,
        values={name: _compared(hits) for name, hits in launches.items()},
        carry_of_published=_flown(rows),
    )


def _compared(launches: list[Launch]) -> dict[str, Floats]:
    return {
        "ball_speed": np.array([each.ball_speed for each in launches]),
        "launch": np.array([each.launch for each in launches]),
        "spin": np.array([each.total_spin for each in launches]),
        "carry": np.array([fly(each).carry for each in launches]),
    }


def _flown(rows: Iterable[Average]) -> Floats:
    """Return the carry from each published launch, taken as straight and with pure backspin."""
    launches = ({"ball_speed": each.ball_speed, "launch": each.launch, "backspin": each.spin} for each in rows)
    return np.array([fly({**each, "sidespin": 0.0}).carry for each in launches])
