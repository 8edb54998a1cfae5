"""The comparison with the tour averages as a result: launches, lofts, ratios, errors, and their pictures."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.equipment.balls import DEFAULT_BALL
from clubface.equipment.models import DEFAULT_MODEL
from clubface.quantities import format_number, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.simulation.provenance import provenance_of
from clubface.support.arrays import Floats
from clubface.units import from_si

if TYPE_CHECKING:
    from clubface.validation.tour import Tour

FLIGHT_ONLY = "flight only"
"""The carry from the published launch: the share of the flight model in the errors of carry."""


def tour_result(tours: Sequence[Tour]) -> Result:
    """Return one or several tables of averages beside models as a result."""
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
    """Return the model whose launches are shown club by club: the default one, where it is among them."""
    return DEFAULT_MODEL if DEFAULT_MODEL in tour.models else tour.models[0]


def compared(tours: Sequence[Tour]) -> list[str]:
    """Return the quantities of which at least one club is a prediction."""
    return [name for name in tours[0].published if not all(each.is_fitted(name).all() for each in tours)]


def _names(tours: Sequence[Tour]) -> tuple[Column, Column]:
    """Return the columns of averages and clubs, a row a club."""
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
        title=f"By {first}, beside what is published",
        shown_rows=[place for place, (_, model, _) in enumerate(rows) if model == first],
    )  # fmt: skip


def _model_table(
    name: str, title: str, tours: Sequence[Tour], get: Callable[[Tour, str], Floats], like: str, *more: Column,
    **options: Any,
) -> Table:  # fmt: skip
    """Return a table of one column a model and one row a club, with ``more`` columns before the models."""
    columns = (
        column(model, np.concatenate([get(each, model) for each in tours]), like, label=model, **options)
        for model in tours[0].models
    )
    return table(name, *_names(tours), *more, *columns, title=title)


def _loft_table(tours: Sequence[Tour]) -> Table:
    """Return the dynamic lofts: published, possible, and with which each model launches as published."""
    published = [np.where(each.loft_is_published, each.lofts[each.models[0]], np.nan) for each in tours]
    least, most = (np.concatenate([each.possible_lofts[end] for each in tours]) for end in (0, 1))
    return _model_table(
        "lofts", "Dynamic loft: published, possible with the published launch, and with which a model launches so",
        tours, lambda each, model: each.solved_lofts[model], "loft",
        column("published_loft", np.concatenate(published), label="published"),
        column("least_loft", least, label="possible from"), column("most_loft", most, label="to"),
    )  # fmt: skip


def _error_table(tours: Sequence[Tour], name: str) -> Table:
    """Return what is published of a quantity, and the errors of the models; those of solved lofts are left out."""
    published = column("published", np.concatenate([each.published[name] for each in tours]), name, label="published")
    flight = np.concatenate([each.carry_of_published - each.published["carry"] for each in tours])
    more = [column("flight_only", flight, "carry", difference=True, label=FLIGHT_ONLY)] if name == "carry" else []
    return _model_table(
        name, f"{quantity(name).label.capitalize()}: published, and models less published", tours,
        lambda each, model: np.where(each.is_fitted(name), np.nan, each.errors(model)[name]), name, published, *more,
        difference=True,
    )  # fmt: skip


def mean_table(tours: Sequence[Tour]) -> Table:
    """Return the mean absolute errors of each model by table of averages, then over all their rows."""
    from clubface.validation.tour import mean_absolute_error

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
    """Yield what a reader of the comparison must know."""
    from clubface.validation.tour import FLATTENED, RIGID, TABLES

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
    for model, every in tour.launches.items():
        for caveat in dict.fromkeys(one for each in every for one in each.parameters.caveats):
            caveats.setdefault(caveat, []).append(model)
    for caveat, models in caveats.items():
        yield note("caveat-of-model", model=models, caveat=f"{caveat}.")


def launch_picture(tour: Tour) -> Picture:
    """Return ball speed, spin and carry of every club, published and by each model, and the lofts of the deliveries.

    Lofts are shown from the launch angle up, since what spin tells of them is some degrees at most.
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
    """Return dynamic loft less launch angle: possible, with which each model launches as published, and published."""
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
    """Return the signed error of every model and club, and beside it each model's mean absolute error.

    A launch angle from which the loft was solved is hollow and has no part in the mean; where all are, there is no row.
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
    """Return the points of each model, shifted sideways so that those of one club do not cover each other."""
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
