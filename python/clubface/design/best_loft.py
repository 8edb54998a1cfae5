"""The dynamic loft for the longest carry, by club speed and attack angle, compared with fitters' charts.

Total distance has no such optimum here: on level ground a ball that barely leaves the turf rolls farthest.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from clubface import published_data, units
from clubface.design.dispersion import ImpactSetup
from clubface.design.optimisation.advice import WORTH, worth_of
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, Wording
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, row_names
from clubface.simulation.flight import AirLike, GroundLike, WindLike
from clubface.simulation.impact import Parameters
from clubface.simulation.launch import Launch
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import check_choice

SHOWN = {"loft": "loft", "ball_speed": "ball_speed", "launch": "launch", "spin": "total_spin", "carry": "carry"}
"""Printed columns and the quantity each one holds."""
SAME_ANGLE = 9e-4
"""Attack angles smaller than this count as level [rad]."""
LEAST, MOST = np.radians(-2.0), np.radians(50.0)
"""Range of lofts searched [rad]."""
POINTS, ROUNDS = 27, 4
"""Lofts tried per round, and number of rounds; each round makes the step around the best loft 13 times finer."""


class PublishedChart(NamedTuple):
    """A published chart: its owner, the name of its table, and the values of :class:`BestLoft` it gives."""

    owner: str
    table: str
    compared: tuple[str, ...]


CHARTS = {
    "trackman": PublishedChart("TrackMan", "optimum-trackman-2010", ("loft", "launch", "spin", "carry")),
    "ping": PublishedChart("PING", "optimum-ping-2019", ("launch", "spin")),
}
BEYOND = np.radians(15.0)
"""Loft minus attack angle [rad] of the shot that is hit to explain why no loft gets the ball airborne."""
HALVINGS = 14
"""Number of bisection steps for the loft at which too much carry is lost."""
SMASH = 1.46
"""Initial guess of the smash factor, for charts that give ball speed only."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BestLoft(Described):
    """The shots with the longest carry; each value is an array over the cases, in SI units and radians.

    Attributes
    ----------
    speed, attack, loft
        Club speed, attack angle and the best dynamic loft.
    ball_speed, launch, spin, carry, total
        The shot at that loft; the spin is the total spin.
    within
        How far the loft may be below and above the best before the loss of carry is worth a change, shape (cases, 2).
    worth
        The smallest difference of carry worth a change [m].
    flown, air, wind
        The launches, and air and wind of their flights.
    """

    speed: Floats
    attack: Floats
    loft: Floats
    ball_speed: Floats
    launch: Floats
    spin: Floats
    carry: Floats
    total: Floats
    within: Floats
    flown: Launch
    worth: float = WORTH["carry"]
    air: AirLike | None = None
    wind: WindLike | None = None

    def to_result(self) -> Result:
        """Return the best lofts as a result."""
        columns = (*_case_columns(self), *(_value_column(self, name) for name in SHOWN), *_extra_columns(self))
        return Result(
            kind="best-loft", title=f"Best dynamic loft for carry: {self.flown.club.name}, {self.flown.model}",
            tables=(Table("best_lofts", columns),), summary=(*_summary(self), note("best-loft-delivered")),
            notes=(note("best-loft-within", worth_carry=self.worth), note("best-loft-carry")),
            provenance=provenance_of([self.flown], flight_conditions(self.air, self.wind)),
            draw=lambda: [best_loft_picture(self)],
        )  # fmt: skip


def best_loft(
    speed: ValueLike,
    attack: ValueLike = 0.0,
    *,
    club: str | os.PathLike[str] | Club = "driver",
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    worth: Mapping[str, float | str] | None = None,
    progress: Callable[[int, int], object] | None = None,
    **delivery: float | str,
) -> BestLoft:
    """Find the dynamic loft that carries the ball farthest.

    Lofts from -2 to 50 degrees are tried in steps that become finer around the best.

    Parameters
    ----------
    speed, attack
        Club speed and attack angle: text with a unit, SI numbers or arrays, which broadcast.
    club, model, parameters, ball, accuracy, air, wind, ground
        As for :func:`impact` and :func:`fly`.
    worth
        The smallest difference worth a change, by objective: text with a unit or SI numbers. The value for "carry" sets
        the width of the optimum.
    progress
        Called with the number of shots done and the total.
    **delivery
        Other delivery values, such as ``high``; single numbers.

    Raises
    ------
    InputError
        There are no cases, a case cannot be computed, or no ball can fly in this air or wind.
    """
    given = (units.parse_values(speed, "speed", name="speed"), units.parse_values(attack, "angle", name="attack"))
    try:
        speeds, attacks = np.broadcast_arrays(*map(np.atleast_1d, given))
    except ValueError:
        shapes = Wording(f"of shapes {np.shape(given[0])} and {np.shape(given[1])}")
        raise InputError("speed and attack", shapes, "of shapes that broadcast") from None
    speeds, attacks = (np.ascontiguousarray(each, dtype=np.float64).reshape(-1) for each in (speeds, attacks))
    if not speeds.size:
        raise InputError("speed and attack", Wording("empty"), "at least one of each")
    for name in ("loft", "speed", "attack"):
        if name in delivery:
            raise InputError(name, delivery[name], "leave it out of the other delivery values")

    enough = worth_of(worth)["carry"]
    setup = ImpactSetup(club_named(club), model, parameters, ball, air, wind, ground, accuracy=accuracy)
    done, shots = 0, len(speeds) * (ROUNDS * POINTS + 1 + 2 * HALVINGS)
    counted = progress and (lambda before, now: progress(before + now, shots))

    def strike(lofts: Floats) -> tuple[Launch, Any]:
        nonlocal done
        values = {**delivery, "speed": speeds[:, None], "attack": attacks[:, None], "loft": lofts}
        result = setup.strike(values, progress=counted and partial(counted, done))
        done += lofts.size
        return result

    low, high = np.full_like(speeds, LEAST), np.full_like(speeds, MOST)
    best = low
    for _ in range(ROUNDS):
        lofts = np.linspace(low, high, POINTS, axis=1)
        reached = np.nan_to_num(strike(lofts)[1].carry, nan=-np.inf)
        if (lost := np.flatnonzero(np.isneginf(reached).all(axis=1))).size:
            speed, attack = float(speeds[lost[0]]), float(attacks[lost[0]])
            values = {"speed": speed, "attack": attack, "loft": float(np.clip(attack + BEYOND, LEAST, MOST))}
            setup.strike({**delivery, **values}, "raise")  # the error explains it
        place = np.argmax(reached, axis=1)
        step = (high - low) / (POINTS - 1)
        best = lofts[np.arange(len(place)), place]
        low, high = np.maximum(best - step, LEAST), np.minimum(best + step, MOST)
    launch, flight = strike(best[:, None])
    ball_speed, launched, spin = (launch.get(name)[:, 0] for name in ("ball_speed", "launch", "total_spin"))
    return BestLoft(
        speed=speeds, attack=attacks, loft=best, ball_speed=ball_speed, launch=launched, spin=spin,
        carry=flight.carry[:, 0], total=flight.total[:, 0], flown=launch, air=air, wind=wind,
        within=_flat_range(lambda lofts: strike(lofts)[1].carry, best, flight.carry[:, 0], enough), worth=enough,
    )  # fmt: skip


def _flat_range(distance: Callable[[Floats], Floats], best: Floats, reached: Floats, worth: float) -> Floats:
    """Return how far below and above the best loft the loss is worth a change, by bisection, up to 15 degrees."""
    result = []
    for side in (-1.0, 1.0):
        near, far = np.zeros_like(best), np.full_like(best, np.radians(15.0))
        for _ in range(HALVINGS):
            middle = 0.5 * (near + far)
            lost = reached - np.nan_to_num(distance((best + side * middle)[:, None])[:, 0], nan=-np.inf) > worth
            near, far = np.where(lost, near, middle), np.where(lost, middle, far)
        result.append(0.5 * (near + far))
    return np.stack(result, axis=1)


@dataclass(frozen=True, eq=False)
class ChartComparison(Described):
    """Best lofts computed here next to those of a published chart, in the chart's order.

    Attributes
    ----------
    name
        Name of the chart: one of ``CHARTS``.
    best
        The best lofts for the chart's speeds and attack angles.
    published
        Columns of the chart [SI].
    """

    name: str
    best: BestLoft
    published: Mapping[str, Floats]

    @property
    def chart(self) -> str:
        """Owner of the chart."""
        return CHARTS[self.name].owner

    @property
    def table(self) -> str:
        """Name of the published table."""
        return CHARTS[self.name].table

    @property
    def compared(self) -> tuple[str, ...]:
        """Values of :class:`BestLoft` that the chart gives too."""
        return CHARTS[self.name].compared

    def quantity(self, key: str) -> str:
        """Return this package's name for a column of the chart."""
        return {"dynamic_loft": "loft", "club_speed": "speed"}.get(key, key)

    def column(self, name: str) -> Floats:
        """Return the chart's column for a value of :class:`BestLoft`."""
        return next(values for key, values in self.published.items() if self.quantity(key) == name)

    def to_result(self) -> Result:
        """Return best lofts and chart as a result."""
        best, chart = self.best, self.chart
        columns = _case_columns(best)
        for name in self.compared:
            published = column(f"published_{name}", self.column(name), SHOWN[name], label=chart)
            columns += [_value_column(best, name), published]
        columns += [_value_column(best, name, printed=False) for name in SHOWN if name not in self.compared]
        columns += _extra_columns(best, printed=False)
        published = {self.quantity(name): name for name in self.published}
        columns += [
            column(f"published_{name}", self.published[key], SHOWN.get(name, name), printed=False)
            for name, key in published.items()
            if name not in self.compared
        ]
        kinds = [quantity(SHOWN[name]) for name in self.compared]
        away = [getattr(best, name) - self.column(name) for name in self.compared]
        differences = (
            *row_names("quantity", self.compared, [each.label for each in kinds]),
            *(Column(word, [float(pick(each)) for each in away], kinds, difference=True)
              for word, pick in (("mean", np.mean), ("least", np.min), ("greatest", np.max))),
        )  # fmt: skip
        launch = "best-loft-launch-difference" if self.compared[0] == "launch" else "best-loft-loft-difference"
        source = published_data.table(self.table).source
        return Result(
            kind="best-loft", title=f"Best dynamic loft for carry and the chart of {chart}: {best.flown.club.name}, "
            f"{best.flown.model}",
            tables=(
                Table("best_lofts", tuple(columns)), Table("differences", differences, "Computed minus published"),
            ),
            summary=(
                *_summary(best), note("best-loft-delivered"), note(launch, chart=chart, loft=float(np.mean(away[0]))),
            ),
            provenance=provenance_of(
                [best.flown], flight_conditions(best.air, best.wind), [f"Chart of {chart}: {source}"]
            ),
            draw=lambda: [chart_picture(self)],
        )  # fmt: skip


def compare_with_chart(chart: str, **options: Any) -> ChartComparison:
    """Return the best loft for each row of a published chart.

    PING's chart gives ball speeds and no lofts. Club speeds are chosen so that the longest drive has the published ball
    speed, by two corrections of a first guess.

    ``chart`` is "trackman" (TrackMan's chart of 2010) or "ping" (PING's of 2019); ``options`` are those of
    :func:`best_loft`.
    """
    check_choice("chart", chart, CHARTS)
    table = published_data.table(CHARTS[chart].table)
    rows = table["optimum_of"] == "carry" if "optimum_of" in table.columns else slice(None)
    published = {name: table[name][rows] for name in table.columns if name != "optimum_of"}
    if "club_speed" in published:
        return ChartComparison(chart, best_loft(published["club_speed"], published["attack"], **options), published)
    speed = published["ball_speed"] / SMASH
    best = best_loft(speed, published["attack"], **options)
    for _ in range(2):
        speed = speed * published["ball_speed"] / best.ball_speed
        best = best_loft(speed, published["attack"], **options)
    return ChartComparison(chart, best, published)


def _case_columns(best_loft: BestLoft) -> list[Column]:
    return [column("speed", best_loft.speed, digits=1), column("attack", best_loft.attack)]


def _value_column(best_loft: BestLoft, name: str, *, printed: bool = True) -> Column:
    label = "best loft" if name == "loft" else quantity(SHOWN[name]).label
    return column(name, getattr(best_loft, name), SHOWN[name], label=label, printed=printed)


def _extra_columns(best_loft: BestLoft, *, printed: bool = True) -> list[Column]:
    return [
        column("total", best_loft.total, printed=False),
        column("within_below", best_loft.within[:, 0], "loft", label="margin, less loft", printed=printed),
        column("within_above", best_loft.within[:, 1], "loft", label="margin, more loft", printed=printed),
    ]


def _summary(best_loft: BestLoft) -> Iterator[Note]:
    """Yield the best loft at the lowest and highest club speed, for the attack angle closest to level."""
    level = abs(best_loft.attack) == abs(best_loft.attack).min()
    for speed in sorted({float(best_loft.speed[level].min()), float(best_loft.speed[level].max())}):
        place = int((level & (best_loft.speed == speed)).argmax())
        attack = float(best_loft.attack[place])
        less, more = map(float, best_loft.within[place])
        yield note(
            "best-loft-level" if abs(attack) < SAME_ANGLE else "best-loft-inclined", attack=attack, speed=speed,
            loft=float(best_loft.loft[place]), carry=float(best_loft.carry[place]), less_loft=less, more_loft=more,
            worth_carry=best_loft.worth,
        )  # fmt: skip


def best_loft_picture(best_loft: BestLoft) -> Picture:
    """Return the picture of loft and carry over club speed; bars span the lofts that are practically as good."""
    lofts, carries = [], []
    for place, attack in enumerate(np.unique(best_loft.attack)):
        rows = np.flatnonzero(best_loft.attack == attack)
        rows = rows[np.argsort(best_loft.speed[rows], kind="stable")]
        speed, loft, carry = best_loft.speed[rows], best_loft.loft[rows], best_loft.carry[rows]
        label = f"attack {np.degrees(attack) + 0.0:.3g}°"
        lofts += [
            Mark("line", speed, loft, style=place, label=label),
            Mark("intervals", speed, loft, y0=loft - best_loft.within[rows, 0],
                 y1=loft + best_loft.within[rows, 1], style=place, symbol=str(place), label=label),
        ]  # fmt: skip
        carries += [
            Mark("line", speed, carry, style=place, label=label),
            Mark("points", speed, carry, style=place, symbol=str(place), label=label),
        ]
    panels: list[Panel | None] = [
        Panel(
            lofts,
            axis("speed"),
            axis("loft", "best dynamic loft"),
            "Best dynamic loft; bars show lofts practically as good",
        ),
        Panel(carries, axis("speed"), axis("carry"), "Carry at the best loft"),
    ]
    return Picture("best-loft", "Best loft and its carry over the club speed", [panels], height=3.4, legend=True)


def chart_picture(comparison: ChartComparison) -> Picture:
    """Return the picture of computed values over the chart's."""
    panels: list[Panel | None] = []
    for name in comparison.compared:
        theirs, ours = comparison.column(name), getattr(comparison.best, name)
        ends = [min(theirs.min(), ours.min()), max(theirs.max(), ours.max())]
        marks = [Mark("line", ends, ends, style=-1, size=0.8, dash=0), Mark("points", theirs, ours)]
        kind = SHOWN[name]
        panels.append(Panel(marks, axis(kind, comparison.chart), axis(kind, "computed"), quantity(kind).label))
    panels += [None] * (len(panels) % 2)
    rows = [panels[place : place + 2] for place in range(0, len(panels), 2)]
    caption = f"Computed values over those of the chart of {comparison.chart}"
    return Picture("best-loft-chart", caption, rows, height=2.5 * len(rows))
