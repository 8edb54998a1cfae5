"""Published tour averages, club by club, compared with every model.

Each club is delivered at its published speed and attack angle. If its dynamic loft is published, every model uses it.
Otherwise each model gets the loft with which it launches the ball at the published angle. The launch angle is then not
a prediction, but ball speed, spin and carry are, and the loft carries no other model's errors.

The spin of a ball relative to its speed along the face is I w / (m R v_t), angular momentum over linear momentum and
radius. A force along the face at the distance R from the centre of a resting ball gives it m v_t along the face and I w
= R m v_t, so the ratio is 1 whether the ball slides, sticks or rolls off. While the force acts, the centre of a
flattened ball is closer to the face, which reduces the ratio to 0.85 to 0.95. This holds for a face that does not
rotate, and nearly for the face at maximum compression, whose loft TrackMan calls dynamic loft. Until then a free head
rotates upwards by 0.5 to 0.8 degrees (irons) or less than 0.3 (woods), so that relative to the face at first touch the
ratio is larger: by 0.1 to 0.2 for irons, and by up to a factor of two for a driver, along which the ball hardly moves.

A published speed, launch angle and spin therefore imply a narrow range of dynamic lofts. If a published loft differs
from it by more than the head rotates, the values cannot belong to one shot.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import published_data, units
from clubface.equipment.balls import DEFAULT_BALL, Ball
from clubface.equipment.clubs import TOUR_CLUBS
from clubface.equipment.models import DEFAULT_MODEL, model, models
from clubface.errors import InputError, RangeWarning
from clubface.published_data import PublishedTable
from clubface.quantities import format_number, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact, warn_if_outside
from clubface.simulation.launch import Launch
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.provenance import provenance_of
from clubface.simulation.spin import rolling_speed
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, without_warnings
from clubface.units import from_si

__all__ = ["TABLES", "Average", "Tour", "averages", "mean_absolute_error", "solve_loft", "tour", "tour_result"]

TABLES = {"pga-2023": None, "pga-2019": "PGA Tour", "lpga-2019": "LPGA Tour"}
"""Published tables to compare with, each with the group whose published dynamic lofts belong to it. The LPGA Tour's
table of 2023 is left out, since one of its spins looks misprinted."""
DEFAULT_TABLE = "pga-2023"


class Average(NamedTuple):
    """The published averages of one club, in SI units.

    Attributes
    ----------
    club
        Name of the built-in club.
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
    """Return the rows of a table of ``TABLES``, driver to pitching wedge, that have a built-in club."""
    published = published_table(table)
    rows = zip(*(published[name].tolist() for name in Average._fields), strict=True)
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
    """Return the dynamic loft [rad] at which a model launches the ball at the angle ``launch`` [rad].

    The ball is struck ``high`` [m] above the face centre. An unreachable launch angle raises an :class:`InputError`.
    """
    with without_warnings(RangeWarning):
        solved = impact_at_launch(
            club, speed=speed, attack=attack, high=high, launch=launch, model=model, ball=ball
        )  # fmt: skip
    if math.isnan(solved.loft):
        raise InputError("launch", units.show(launch, "deg", 4), f"a launch angle {club} can reach at this speed")
    return solved.loft


RIGID = 1.0
"""Ratio for a ball that stays round."""
FLATTENED = 0.85
"""Smallest ratio for a flattened ball, from finite element impacts on a plane."""


def spin_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, loft: Any) -> Any:
    """Return I w / (m R v_t) of launches [m/s, rad, rad/s] in the vertical plane, for dynamic lofts [rad]."""
    return rolling_speed(ball, spin) / (speed * np.sin(loft - np.asarray(launch)))


def loft_of_ratio(ball: Ball, speed: Any, launch: Any, spin: Any, ratio: float) -> NDArray[np.float64]:
    """Return the dynamic lofts [rad] at which launches have this ratio; NaN if no loft gives so much spin."""
    share = rolling_speed(ball, spin) / (np.asarray(speed) * ratio)
    return launch + np.arcsin(np.where(np.abs(share) <= 1.0, share, np.nan))


def spin_ratio_of(launch: Launch, loft: float) -> float:
    """Return the ratio of one launch in three dimensions, for a square face with loft [rad] at first touch."""
    normal = np.array([np.cos(loft), np.sin(loft), 0.0])
    velocity = np.array([launch.velocity_x, launch.velocity_y, launch.velocity_z])
    along = velocity - normal * (velocity @ normal)
    return float(rolling_speed(launch.ball, launch.total_spin) / np.linalg.norm(along))


QUANTITIES = ("ball_speed", "launch", "spin", "carry")
"""Quantities compared. Spin is total spin, as launch monitors report it."""


@dataclass(frozen=True)
class Tour(Described):
    """Published averages and models, in SI units; every array has one value per club.

    Attributes
    ----------
    averages
        The rows of the published table.
    loft_is_published
        Whether the dynamic loft is published for each club; otherwise each model has its own.
    lofts
        Delivered dynamic loft [rad] by model, published or solved.
    solved_lofts
        Dynamic loft [rad] by model that reproduces the published launch angle.
    launches
        The launches of each model, one per club.
    values
        The ``QUANTITIES`` by model, with the carry of the model's own launch.
    carry_of_published
        Carry [m] computed by the flight model from the published ball speed, launch angle and spin.
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
        """The clubs of the published table without a built-in head."""
        return [str(club) for club in self.table["club"] if club not in self.clubs]

    @property
    def models(self) -> list[str]:
        """The models, in the order requested."""
        return list(self.values)

    @cached_property
    def published(self) -> dict[str, Floats]:
        """The published value of each quantity."""
        return {name: np.array([getattr(each, name) for each in self.averages]) for name in QUANTITIES}

    def to_result(self) -> Result:
        """Return the comparison as a result."""
        return tour_result([self])

    def is_fitted(self, quantity: str) -> NDArray[np.bool_]:
        """Return for which clubs a quantity is fitted, not predicted: the launch angle, if the loft was solved."""
        return ~self.loft_is_published if quantity == "launch" else np.zeros(len(self.averages), dtype=bool)

    def errors(self, model_name: str) -> dict[str, Floats]:
        """Return model minus published value, by quantity."""
        return {name: self.values[model_name][name] - self.published[name] for name in QUANTITIES}

    def predicted(self, model_name: str, quantity: str) -> Floats:
        """Return the errors of one quantity for the clubs for which it is predicted."""
        return self.errors(model_name)[quantity][~self.is_fitted(quantity)]

    def mean_absolute_error(self, model_name: str) -> dict[str, float]:
        """Return the mean absolute error over the clubs, by quantity; NaN if it is predicted for none."""
        return mean_absolute_error([self], model_name)

    def published_ratios(self, model_name: str) -> Floats:
        """Return I w / (m R v_t) of the published launches at the model's lofts."""
        balls = [each.ball for each in self.launches[model_name]]
        return self._over_launches(spin_ratio, balls, self.lofts[model_name])

    def own_ratios(self, model_name: str) -> Floats:
        """Return I w / (m R v_t) of the model's launches."""
        pairs = zip(self.launches[model_name], self.lofts[model_name].tolist(), strict=True)
        return np.array([spin_ratio_of(launch, loft) for launch, loft in pairs])

    @cached_property
    def possible_lofts(self) -> tuple[Floats, Floats]:
        """Range of dynamic lofts [rad] compatible with the published launch, for a round to a flattened ball."""
        balls = [each.ball for each in self.launches[self.models[0]]]
        low, high = (self._over_launches(loft_of_ratio, balls, limit) for limit in (RIGID, FLATTENED))
        return low, high

    def _over_launches(self, compute: Callable[..., object], balls: Iterable[Ball], last: object) -> Floats:
        rows = zip(balls, self.averages, np.broadcast_to(np.asarray(last), len(self.averages)).tolist(), strict=True)
        return np.array([compute(ball, each.ball_speed, each.launch, each.spin, value) for ball, each, value in rows])


def mean_absolute_error(results: Iterable[Tour], model_name: str) -> dict[str, float]:
    """Return the mean absolute error of a model over all rows of several tables, by quantity."""
    results = list(results)
    means = {}
    for name in QUANTITIES:
        errors = np.concatenate([each.predicted(model_name, name) for each in results])
        means[name] = float(np.abs(errors).mean()) if errors.size else float("nan")
    return means


def tour(
    model_names: Iterable[str] | None = None,
    *,
    table: str = DEFAULT_TABLE,
    ball: str | os.PathLike[str] | Ball | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Tour:
    """Compute launch and flight of every club in the published averages by every model.

    Parameters
    ----------
    model_names
        Names of models; default all in the registry.
    table
        A table of ``TABLES``.
    ball
        As for :func:`clubface.impact`.
    progress
        Called with the number of clubs done and the total, over all models.
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
        own_lofts = []
        for index, each in enumerate(rows):
            own_lofts.append(solve_loft(each.club, each.club_speed, each.attack, each.launch, model=name, ball=ball))
            if progress is not None:
                progress(place * len(rows) + index + 1, len(names) * len(rows))
        solved[name] = np.array(own_lofts)
        lofts[name] = np.where(np.isnan(given), solved[name], given)
        with without_warnings(RangeWarning):
            launches[name] = [
                impact(each.club, speed=each.club_speed, attack=each.attack, loft=loft, model=name, ball=ball)
                for each, loft in zip(rows, lofts[name].tolist(), strict=True)
            ]
    warn_if_outside(launch for by_club in launches.values() for launch in by_club)
    straight = {"sidespin": 0.0}  # the published launches, with pure backspin
    published = (
        {"ball_speed": each.ball_speed, "launch": each.launch, "backspin": each.spin, **straight} for each in rows
    )
    return Tour(
        table=published_table(table),
        averages=rows,
        loft_is_published=~np.isnan(given),
        lofts=lofts,
        solved_lofts=solved,
        launches=launches,
        values={name: _launch_values(hits) for name, hits in launches.items()},
        carry_of_published=np.array([fly(each).carry for each in published]),
    )


def _launch_values(launches: list[Launch]) -> dict[str, Floats]:
    return {
        "ball_speed": np.array([each.ball_speed for each in launches]),
        "launch": np.array([each.launch for each in launches]),
        "spin": np.array([each.total_spin for each in launches]),
        "carry": np.array([fly(each).carry for each in launches]),
    }


FLIGHT_ONLY = "flight only"
"""Label of the carry from the published launch, which shows the flight model's part of the carry error."""


def tour_result(tours: Sequence[Tour]) -> Result:
    """Return the comparison with one or several tables of averages as a result."""
    first = first_model(tours[0])
    titles = " and ".join(each.table.title for each in tours)
    return Result(
        kind="tour", title=f"{titles}, by {first}",
        tables=(
            _club_table(tours, first), _loft_table(tours),
            _model_table("published_ratios", "I w / (m R v_t) of the published launch from the delivered loft", tours,
                         lambda each, model: each.published_ratios(model), "1", digits=2),
            _model_table("own_ratios", "I w / (m R v_t) of the model's own launch", tours,
                         lambda each, model: each.own_ratios(model), "1", digits=2),
            *(_error_table(tours, name) for name in compared(tours)),
            mean_table(tours),
        ),
        notes=tuple({each.sentence: each for one in tours for each in _notes(one)}.values()),
        provenance=provenance_of(
            (launch for each in tours for launches in each.launches.values() for launch in launches),
            sources=[f"{each.table.title}: {each.table.source}" for each in tours],
        ),
        draw=lambda: [picture for each in tours for picture in (launch_picture(each), error_picture(each))],
    )  # fmt: skip


def first_model(tour: Tour) -> str:
    """Return the model shown club by club: the default model, if it is among them."""
    return DEFAULT_MODEL if DEFAULT_MODEL in tour.models else tour.models[0]


def compared(tours: Sequence[Tour]) -> list[str]:
    """Return the quantities predicted for at least one club."""
    return [name for name in tours[0].published if not all(each.is_fitted(name).all() for each in tours)]


def _names(tours: Sequence[Tour]) -> tuple[Column, Column]:
    """Return the columns with table and club, one row per club."""
    return (
        text("averages", [each.table.name for each in tours for _ in each.clubs], printed=len(tours) > 1),
        text("club", [club for each in tours for club in each.clubs]),
    )


def _club_table(tours: Sequence[Tour], first: str) -> Table:
    """Return the main table: delivery, published launch and computed launch of every club and model."""
    rows = [(each, model, place) for each in tours for model in each.models for place in range(len(each.clubs))]

    def by_club(get: Callable[[Tour, str], Any]) -> list[Any]:
        return [value for each in tours for model in each.models for value in get(each, model)]

    launches = []
    for name in tours[0].published:
        launches += [
            column(name, by_club(lambda each, model, name=name: each.values[model][name])),
            column(f"published_{name}", by_club(lambda each, model, name=name: each.published[name]),
                   label="as published"),
            column(f"{name}_error", by_club(lambda each, model, name=name: each.errors(model)[name]), name,
                   difference=True, printed=False),
        ]  # fmt: skip
    return table(
        "clubs", text("averages", [each.table.name for each, _, _ in rows], printed=len(tours) > 1),
        text("club", [each.clubs[place] for each, _, place in rows]),
        text("model", [model for _, model, _ in rows], printed=False),
        column("club_speed", [each.averages[place].club_speed for each, _, place in rows], "speed", printed=False),
        column("attack", [each.averages[place].attack for each, _, place in rows], printed=False),
        column("loft", by_club(lambda each, model: each.lofts[model])),
        text("loft_source", ["published" if each.loft_is_published[place] else f"solved with {model}"
                             for each, model, place in rows], printed=False),
        *launches,
        column("published_launch_carry", by_club(lambda each, model: each.carry_of_published), "carry", printed=False),
        title=f"By {first}, compared with what is published",
        shown_rows=[place for place, (_, model, _) in enumerate(rows) if model == first],
    )  # fmt: skip


def _model_table(
    name: str, title: str, tours: Sequence[Tour], get: Callable[[Tour, str], Floats], like: str, *more: Column,
    **options: Any,
) -> Table:  # fmt: skip
    """Return a table with one column per model and one row per club; ``more`` columns come before the models."""
    columns = (
        column(model, np.concatenate([get(each, model) for each in tours]), like, label=model, **options)
        for model in tours[0].models
    )
    return table(name, *_names(tours), *more, *columns, title=title)


def _loft_table(tours: Sequence[Tour]) -> Table:
    """Return the table of dynamic lofts: published, possible, and solved with each model."""
    published = [np.where(each.loft_is_published, each.lofts[each.models[0]], np.nan) for each in tours]
    least, most = (np.concatenate([each.possible_lofts[end] for each in tours]) for end in (0, 1))
    return _model_table(
        "lofts", "Dynamic loft: published, possible with the published launch, and with which a model launches so",
        tours, lambda each, model: each.solved_lofts[model], "loft",
        column("published_loft", np.concatenate(published), label="published"),
        column("least_loft", least, label="possible from"), column("most_loft", most, label="to"),
    )  # fmt: skip


def _error_table(tours: Sequence[Tour], name: str) -> Table:
    """Return the table of a quantity's published values and the models' errors, without fitted values."""
    published = column("published", np.concatenate([each.published[name] for each in tours]), name, label="published")
    flight = np.concatenate([each.carry_of_published - each.published["carry"] for each in tours])
    more = [column("flight_only", flight, "carry", difference=True, label=FLIGHT_ONLY)] if name == "carry" else []
    return _model_table(
        name, f"{quantity(name).label.capitalize()}: published, and models less published", tours,
        lambda each, model: np.where(each.is_fitted(name), np.nan, each.errors(model)[name]), name, published, *more,
        difference=True,
    )  # fmt: skip


def mean_table(tours: Sequence[Tour]) -> Table:
    """Return the table of mean absolute errors of each model, by table of averages and over all of them."""
    groups = {each.table.name: [each] for each in tours} | ({"all": list(tours)} if len(tours) > 1 else {})
    rows: list[tuple[str, str, dict[str, float]]] = []
    for name, group in groups.items():
        rows += [(name, model, mean_absolute_error(group, model)) for model in tours[0].models]
        flight = np.concatenate([each.carry_of_published - each.published["carry"] for each in group])
        rows.append((name, FLIGHT_ONLY, {"carry": float(np.abs(flight).mean())}))
    return table(
        "mean_absolute_error", text("averages", [name for name, _, _ in rows], printed=len(tours) > 1),
        text("model", [model for _, model, _ in rows]),
        *(column(name, [means.get(name) for _, _, means in rows]) for name in tours[0].published),
        title="Mean absolute error",
    )  # fmt: skip


def _notes(tour: Tour) -> Iterator[Note]:
    """Yield the notes on the comparison."""
    name = tour.table.name
    yield note("published-table", title=tour.table.title, source=tour.table.source)
    if tour.table.caveat:
        yield note("tour-in-doubt", averages=name, caveat=tour.table.caveat)
    if tour.left_out:
        yield note("tour-left-out", averages=name, clubs=tour.left_out)
    launches = [each for every in tour.launches.values() for each in every]
    if (balls := list(dict.fromkeys(each.ball.name for each in launches))) != [DEFAULT_BALL]:
        yield note("tour-ball", balls=balls)
    if tour.loft_is_published.any():
        clubs = [club for club, given in zip(tour.clubs, tour.loft_is_published, strict=True) if given]
        yield note("tour-lofts-published", averages=name, clubs=clubs)
    else:
        others = [each for each, group in TABLES.items() if group is not None]
        yield note("tour-lofts-solved", averages=name, others=others)
    yield note("tour-ratio", rigid=RIGID, flattened=FLATTENED)
    yield note("tour-heads")
    yield note("tour-strike")
    caveats: dict[str, list[str]] = {}
    for name, every in tour.launches.items():
        for caveat in dict.fromkeys(one for each in every for one in each.parameters.caveats):
            caveats.setdefault(caveat, []).append(name)
    for caveat, names in caveats.items():
        yield note("caveat-of-model", model=names, caveat=f"{caveat}.")


def launch_picture(tour: Tour) -> Picture:
    """Return the picture of ball speed, spin and carry by club, published and by each model, and of dynamic lofts.

    Lofts are shown relative to the launch angle, as differences are a few degrees at most.
    """
    places, clubs = np.arange(len(tour.clubs)), _club_axis(tour)
    panels = []
    for name in ("ball_speed", "spin", "carry"):
        marks = [
            Mark("line", places, tour.published[name], label="published", style=-1, dash=0),
            *_points(tour, {model: tour.values[model][name] for model in tour.models}),
        ]
        if name == "carry":
            marks.append(_flight_mark(places, tour.carry_of_published))
        panels.append(Panel(marks, clubs, axis(name, limits=(0.0, None))))
    panels.append(Panel(_loft_marks(tour), clubs, axis("loft", "loft less launch angle", limits=(0.0, None))))
    return Picture(
        "tour-launch", "Ball speed, spin, carry and dynamic loft of every club, published and by each model",
        [panels[:2], panels[2:]], height=5.4, share_x=True, legend=True,
    )  # fmt: skip


def _loft_marks(tour: Tour) -> list[Mark]:
    """Return the marks of dynamic loft minus launch angle: possible, solved with each model, and published."""
    places, launch = np.arange(len(tour.clubs)), tour.published["launch"]
    low, high = (each - launch for each in tour.possible_lofts)
    marks = [
        Mark("intervals", places, 0.5 * (low + high), y0=low, y1=high, style=-1, symbol="", label="possible loft"),
        *_points(tour, {model: tour.solved_lofts[model] - launch for model in tour.models}),
    ]
    if (known := tour.loft_is_published).any():
        given = (tour.lofts[tour.models[0]] - launch)[known]
        marks.append(Mark("points", places[known], given, label="published loft", style=-2, symbol="_", size=14.0))
    return marks


def error_picture(tour: Tour) -> Picture:
    """Return the picture of the errors of every model and club, and each model's mean absolute error.

    Fitted launch angles are hollow and not part of the mean; if all are fitted, the row is left out.
    """
    places, rows = np.arange(len(tour.clubs)), []
    names = compared([tour])
    for name in names:
        hollow = tour.is_fitted(name)
        errors = {model: tour.errors(model)[name] for model in tour.models}
        marks = [Mark("rule", y=0.0, style=-2), *_points(tour, errors, ~hollow), *_points(tour, errors, hollow, True)]
        if name == "carry":
            marks.append(_flight_mark(places, tour.carry_of_published - tour.published["carry"]))
        clubs = _club_axis(tour, named=name == names[-1])
        models = Axis(names=tour.models, reversed=True)
        rows.append([
            Panel(marks, clubs, axis(name), f"{quantity(name).label}: model less published"),
            Panel(_mean_bars(tour, name), axis(name, limits=(0.0, None)), models, "mean absolute", grid=False),
        ])  # fmt: skip
    return Picture(
        "tour-errors", "Error of every model and club, and the mean absolute error of each model", rows,
        widths=(3.6, 1.0), height=0.9 + 1.9 * len(rows), legend=True,
    )  # fmt: skip


def _mean_bars(tour: Tour, name: str) -> list[Mark]:
    digits = quantity(name).golf.digits
    means = [tour.mean_absolute_error(model)[name] for model in tour.models]
    return [
        Mark("bars", [mean], [place], style=model, size=0.62,
             texts=[format_number(float(from_si(mean, quantity(name).golf.unit)), digits)])
        for place, (model, mean) in enumerate(zip(tour.models, means, strict=True))
    ]  # fmt: skip


def _points(tour: Tour, values: dict[str, Floats], chosen: Any = slice(None), hollow: bool = False) -> list[Mark]:
    """Return the points of each model, shifted sideways so that they do not overlap."""
    places, count = np.arange(len(tour.clubs)), len(tour.models)
    return [
        Mark("points", (places + (0.7 * (index / (count - 1) - 0.5) if count > 1 else 0.0))[chosen],
             values[model][chosen], label=model, style=model, size=3.2, hollow=hollow)
        for index, model in enumerate(tour.models)
        if np.size(places[chosen])
    ]  # fmt: skip


def _flight_mark(places: Any, carries: Floats) -> Mark:
    return Mark("points", places, carries, label=FLIGHT_ONLY, style=-1, symbol="_", size=9.0)


def _club_axis(tour: Tour, *, named: bool = True) -> Axis:
    return Axis(names=tour.clubs if named else [""] * len(tour.clubs), limits=(-0.6, len(tour.clubs) - 0.4))
