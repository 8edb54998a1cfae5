"""Landings of shots with a variable club, and the objectives computed from them, with derivatives.

The core differentiates launch and flight with dual numbers for all shots at once; the chain rule joins them. Every club
hits the same shots, so differences between clubs are free of sampling noise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from clubface import _core as core, units
from clubface.design.feasibility import MASS_PROPERTIES
from clubface.design.strokes import Hole, expected
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError
from clubface.quantities import Quantity, Reading, format_value
from clubface.simulation.flight import BALL, SPIN, VELOCITY, AirLike, GroundLike, WindLike, conditions
from clubface.simulation.inputs import broadcast, equipped, shots
from clubface.simulation.results import flight_inputs, flight_outputs, input_columns, outputs
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

SPEED_EXPONENT = 0.18
"""Exponent with which clubhead speed falls with head mass: 26 g more, from 174 to 200 g, cost golfers with about 110
mph some 2.7 mph (MacKenzie, Ryan and Rice, 2015)."""
FACE = ("loft", "bulge", "roll", "characteristic_time")
FREE = (*MASS_PROPERTIES, *FACE, "lie")
"""Variable fields of a club; the lie is a change of the lie at impact."""
LANDING = ("carry", "side", "total", "total_side")
"""Rows of all landings: where a shot comes down, and where it comes to rest."""
LAUNCH = (*VELOCITY, *SPIN)


@dataclass(frozen=True, kw_only=True)
class Setting:
    """Options common to all clubs, as for :func:`clubface.impact` and :func:`clubface.fly`; 0 threads means all cores.

    Clubhead speed is proportional to head mass to the power of minus ``speed_exponent``.
    """

    model: str
    parameters: Any = None
    ball: str | Ball | None = None
    air: AirLike | None = None
    wind: WindLike | None = None
    ground: GroundLike | None = None
    speed_exponent: float = SPEED_EXPONENT
    threads: int = 0


DEFAULT_SETTING = Setting(model=DEFAULT_MODEL)


def own_value(club: Club, field: str) -> float:
    """Return a club's value of a variable field [SI]; 0 for the lie, which is a change."""
    return 0.0 if field == "lie" else getattr(club, field)


class Slopes:
    """Derivatives of the landings with respect to club fields, as the two factors of the chain rule."""

    def __init__(self, flight: Floats, launch: Floats) -> None:
        self._flight, self._launch = flight, launch

    def gradient(self, weights: Floats) -> Floats:
        """Return the derivatives, shape (variables,), of landings summed with ``weights``, shape (landings, shots)."""
        by_launch = np.einsum("on,oin->in", weights, self._flight)
        return np.einsum("in,ijn->j", by_launch, self._launch)


class Landings:
    """The shots of one golfer with clubs that differ from a base club in some fields.

    ``deliveries`` of the base club are values by name [SI], each of shape (shots,); the loft defaults to the club's.
    Shots that miss the face of the base club are left out: ``missed`` is their number, ``count`` the number of the
    others and ``kept`` the indices of the others.
    """

    def __init__(self, base: Club, deliveries: Mapping[str, Any], setting: Setting) -> None:
        self.base, self.setting = base, setting
        equipment, self._parameters = equipped(setting.model, base, setting.ball, setting.parameters)
        values = {"loft": base.loft, "lie": 0.0, **deliveries}
        setup, parameters = broadcast(
            shots(equipment, values), self._parameters.columns(), tuple(self._parameters.values), len(outputs())
        )
        (number,) = setup.shape or (1,)
        result, problems = core.impact(setting.model, setup.columns, parameters, number, None, setting.threads)
        good = ~np.isnan(result[0])
        self.missed = int(number - good.sum())
        if not good.any():
            name, message = problems[0][1:]
            raise InputError("golfer", name, f"one whose shots can be computed: {message}")
        self._columns = [each if isinstance(each, float) else each[good] for each in setup.columns]
        self._own = parameters
        self.kept = np.flatnonzero(good)
        self.count = len(self.kept)
        self.ball = equipment.ball

    def _inputs(self, club: Mapping[str, float]) -> list[Any]:
        """Return the impact inputs, by column, for the base club with changed fields."""
        columns, place = list(self._columns), input_columns()
        for name, value in club.items():
            if name == "loft":
                columns[place["static_loft"]] = value
                columns[place["loft"]] = columns[place["loft"]] + (value - self.base.loft)
            elif name == "lie":
                columns[place["lie"]] = columns[place["lie"]] + value
            elif name == "mass":
                columns[place["club_mass"]] = value
                slower = (value / self.base.mass) ** -self.setting.speed_exponent
                columns[place["speed"]] = columns[place["speed"]] * slower
            else:
                columns[place[name]] = value
        return columns

    def _flights(self, launches: Floats, columns: list[Any]) -> list[Any]:
        """Return the flight inputs, by column, for launches with rows in the order of ``LAUNCH``."""
        place = input_columns()
        given: dict[str, Any] = {name: each.default for name, each in flight_inputs().items()}
        given |= {name: columns[place[name]] for name in BALL}
        given |= conditions(self.setting.air, self.setting.wind, self.setting.ground)
        given |= dict(zip(LAUNCH, launches, strict=True))
        return list(given.values())

    def of(self, club: Mapping[str, float]) -> Floats:
        """Return the landings [m] with changed club fields, shape (landings, shots); all NaN if no such club exists."""
        columns = self._inputs(club)
        result, _ = core.impact(self.setting.model, columns, self._own, self.count, None, self.setting.threads)
        names = list(outputs())
        launches = result[[names.index(name) for name in LAUNCH]]
        if np.isnan(launches).any():
            return np.full((len(LANDING), self.count), np.nan)
        flown, _ = core.fly(self._flights(launches, columns), self.count, self.setting.threads)
        return flown[[list(flight_outputs()).index(name) for name in LANDING]]

    def split(self, landed: Floats, sets: int) -> list[Floats]:
        """Return the landings of consecutive sets of deliveries, which are the same for every club."""
        ends = np.linspace(0, self.count + self.missed, sets + 1).round()[1:-1]
        return np.split(landed, np.searchsorted(self.kept, ends), axis=1)

    def differentiated(self, club: Mapping[str, float], variables: tuple[str, ...]) -> tuple[Floats, Slopes]:
        """Return the landings as :meth:`of` does, and their derivatives with respect to club fields."""
        columns, place = self._inputs(club), input_columns()
        wanted = [self._driven_inputs(name, club, columns) for name in variables]
        flat = [place[driven] for each in wanted for driven, _ in each]
        names = list(outputs())
        result, _ = core.sensitivities(
            self.setting.model, columns, self._own, self.count, [names.index(name) for name in LAUNCH], flat, None,
            self.setting.threads,
        )  # fmt: skip
        table = result.reshape(len(LAUNCH), 1 + len(flat), self.count)
        launch = np.empty((len(LAUNCH), len(variables), self.count))
        start = 1
        for index, each in enumerate(wanted):
            launch[:, index] = sum(table[:, start + i] * factor for i, (_, factor) in enumerate(each))
            start += len(each)
        known, flights = list(flight_outputs()), list(flight_inputs())
        flown, _ = core.fly_sensitivities(
            self._flights(np.ascontiguousarray(table[:, 0]), columns), self.count,
            [known.index(name) for name in LANDING], [flights.index(name) for name in LAUNCH], self.setting.threads,
        )  # fmt: skip
        flown = flown.reshape(len(LANDING), 1 + len(LAUNCH), self.count)
        return flown[:, 0], Slopes(flown[:, 1:], launch)

    def _driven_inputs(self, name: str, club: Mapping[str, float], columns: list[Any]) -> list[tuple[str, Any]]:
        """Return the impact inputs that a club field changes, with their derivatives."""
        if name == "loft":
            return [("loft", 1.0), ("static_loft", 1.0)]
        if name == "mass":
            speed = columns[input_columns()["speed"]]
            slower = -self.setting.speed_exponent * speed / club.get("mass", self.base.mass)
            return [("club_mass", 1.0), ("speed", slower)]
        return [(name, 1.0)]


SHARE = 0.9
"""Share of normally distributed shots inside the landing ellipse."""
FINE, ROUGH = 1e-8, 1e-6
"""Relative precision of smooth objectives (flight steps add noise of 1e-9), and of those with kinks: strokes are
piecewise linear in distance, and a bouncing ball may begin to slide."""

Judgement = tuple[float, Floats]
"""A value and its derivatives with respect to every landing, in the shape of the landings."""


class Objective(NamedTuple):
    """A quantity to optimise, computed from landings [m] with the rows ``LANDING``."""

    name: str
    meaning: str
    unit: str
    sign: float  # -1 if more is better, +1 if less is
    judge: Callable[[Floats], Judgement]
    one_shot: bool  # whether it is defined for a single shot
    precision: float = FINE  # of its optimum, relative

    @property
    def quantity(self) -> Quantity:
        """Quantity for tables and pictures."""
        si = units.SI_UNITS[units.unit(self.unit).dimension]
        digits = {"1": 4, "m2": 0}.get(self.unit, 2)
        label = _HEADINGS.get(self.name, self.name)
        return Quantity(self.name, si, Reading(si, digits), Reading(self.unit, digits), label, meaning=self.meaning)

    def show(self, value: float) -> str:
        """Return a value as text with its unit."""
        return format_value(value, self.quantity)


_HEADINGS = {"side_spread": "side ±", "ellipse": "90% ellipse"}
"""Headings of objectives whose names are not readable."""


def _mean_of(row: int) -> Callable[[Floats], Judgement]:
    """Return the judge of the mean of a row of ``LANDING``."""

    def judge(landed: Floats) -> Judgement:
        weights = np.zeros_like(landed)
        weights[row] = 1.0 / landed.shape[1]
        return float(landed[row].mean()), weights

    return judge


def side_spread(landed: Floats) -> Judgement:
    """Return the standard deviation of the side [m] with derivatives; 0 for a single shot."""
    weights, deviation = np.zeros_like(landed), landed[1] - landed[1].mean()
    spread = math.sqrt(float(np.mean(deviation**2)))
    if spread > 0.0:
        weights[1] = deviation / (spread * landed.shape[1])
    return spread, weights


def ellipse(landed: Floats) -> Judgement:
    """Return the area [m2], with derivatives, of the ellipse containing ``SHARE`` of normally distributed shots.

    For the covariance C of distance along the target line and side, it is pi q sqrt(det C), where q is the quantile of
    chi squared with two degrees of freedom, -2 log(1 - SHARE).
    """
    down = np.sqrt(np.maximum(landed[0] ** 2 - landed[1] ** 2, 1e-12))
    around = np.array([down - down.mean(), landed[1] - landed[1].mean()])
    covariance = around @ around.T / landed.shape[1]
    determinant = covariance[0, 0] * covariance[1, 1] - covariance[0, 1] ** 2
    area = math.pi * -2.0 * math.log1p(-SHARE) * math.sqrt(max(determinant, 0.0))
    if area == 0.0:
        return 0.0, np.zeros_like(landed)
    # d sqrt(det C) = sqrt(det C) / 2 trace(C^-1 dC), and dC = 2 / n (around)(d around)'
    by_place = area / landed.shape[1] * np.linalg.solve(covariance, around)
    by_down, by_side = by_place
    weights = np.zeros_like(landed)
    weights[:2] = by_down * landed[0] / down, by_side - by_down * landed[1] / down
    return area, weights


OBJECTIVES = {
    each.name: each
    for each in (
        Objective("carry", "mean carry", "yd", -1.0, _mean_of(0), True),
        Objective("total", "mean total distance", "yd", -1.0, _mean_of(2), True, ROUGH),
        Objective("side_spread", "standard deviation of the side", "yd", 1.0, side_spread, False),
        Objective("ellipse", f"area of the ellipse of {SHARE:.0%} of the landings", "m2", 1.0, ellipse, False),
    )
}
"""Objectives that need only landings."""
JUDGED = {**{name: each.unit for name, each in OBJECTIVES.items()}, "strokes": "1"}
"""Unit of every objective."""


EDGE = 4.0
"""Width [m] of the transition between two lies, so that expected strokes are differentiable; assumed."""
_STEP = 1e-3
"""Step [m] of the central differences of expected strokes, which are piecewise linear in distance."""


def strokes(hole: Hole) -> Objective:
    """Return the objective of the strokes expected after the shot, from where balls come to rest on a hole."""

    def judge(landed: Floats) -> Judgement:
        total, side = landed[2], landed[3]
        ahead = np.sqrt(np.maximum(total**2 - side**2, 1e-12))
        value, by_ahead, by_side = _strokes_with_derivatives(hole, ahead, side)
        weights = np.zeros_like(landed)
        weights[2] = by_ahead * total / ahead
        weights[3] = by_side - by_ahead * side / ahead
        return float(value.mean()), weights / landed.shape[1]

    meaning = f"mean strokes to hole out after the shot, {units.fixed(hole.length, 'yd', 0)} hole"
    return Objective("strokes", meaning, "1", 1.0, judge, True, ROUGH)


def _strokes_with_derivatives(hole: Hole, ahead: Floats, side: Floats) -> tuple[Floats, Floats, Floats]:
    """Return expected strokes from where balls lie, and their derivatives with respect to position.

    They equal ``Hole.after`` except in a band of width ``EDGE`` between two lies, where they are blended.
    """
    off, left = np.abs(side), np.maximum(np.hypot(hole.length - ahead, side), 1e-6)
    rough, by_rough = _smooth_step(off - 0.5 * hole.fairway)
    trees, by_trees = _smooth_step(off - 0.5 * hole.fairway - hole.rough)
    away, by_away = _smooth_step(left - hole.green)
    lies = {name: _strokes_from_lie(name, left) for name in ("fairway", "rough", "recovery", "green")}
    (fair, fair_left), (deep, deep_left), (wild, wild_left), (putt, putt_left) = lies.values()
    off_green = fair + rough * (deep - fair) + trees * (wild - deep)
    value = putt + away * (off_green - putt)
    by_left = putt_left + away * (
        fair_left + rough * (deep_left - fair_left) + trees * (wild_left - deep_left) - putt_left
    ) + by_away * (off_green - putt)  # fmt: skip
    by_off = away * (by_rough * (deep - fair) + by_trees * (wild - deep))
    return value, -by_left * (hole.length - ahead) / left, by_left * side / left + by_off * np.sign(side)


def _smooth_step(beyond: Floats) -> tuple[Floats, Floats]:
    """Return the smooth step from 0 to 1 across an edge, and its derivative."""
    part = np.clip(beyond / EDGE + 0.5, 0.0, 1.0)
    return part**2 * (3.0 - 2.0 * part), 6.0 * part * (1.0 - part) / EDGE


def _strokes_from_lie(name: str, left: Floats) -> tuple[Floats, Floats]:
    above, below = expected(name, left + _STEP), expected(name, np.maximum(left - _STEP, 0.0))
    return 0.5 * (above + below), (above - below) / (2.0 * _STEP)


def objectives(hole: Hole | None) -> tuple[Objective, ...]:
    """Return all objectives that can be computed; strokes need a hole."""
    return (*OBJECTIVES.values(), *(() if hole is None else (strokes(hole),)))


def objective(name: str, hole: Hole | None = None) -> Objective:
    """Return an objective by name."""
    if name == "strokes" and hole is None:
        raise InputError("hole", None, 'give [hole] with its length, as in length = "400 yd", for expected strokes')
    known = {each.name: each for each in objectives(hole)}
    check_choice("objective", name, known)
    return known[name]
