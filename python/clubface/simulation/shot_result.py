"""One shot by one model or several as a result: its launch and flight, its picture, and what it was computed from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from clubface.quantities import format_value, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.flight import Flight
from clubface.simulation.launch import Launch
from clubface.simulation.provenance import flight_conditions, provenance_of

QUANTITIES = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "total_spin", "spin_axis", "carry", "side",
    "total", "apex", "landing_angle", "contact_time", "peak_force",
)  # fmt: skip
"""What is computed of a shot, in the order of its table."""
ONE_MODEL_ONLY = ("total", "apex", "landing_angle")
"""What the table of several models leaves out, so that it fits a terminal."""
_FLATTEST, _TALLEST = 0.11, 0.5
"""Height over width of a view of the flight: it is stretched to the first, and cut at the second."""


def shot_result(
    launches: Mapping[str, Launch],
    flights: Mapping[str, Flight],
    *,
    conditions: Mapping[str, Any] | None = None,
    paths: Callable[[], tuple[Mapping[str, Any], Mapping[str, Any]]] | None = None,
) -> Result:
    """Return a shot as a result; launches and flights go by the name of the model.

    Parameters
    ----------
    conditions
        Air, wind and ground, as :func:`clubface.fly` takes them.
    paths
        Computes what the picture draws: positions of the ball in flight [m], shape [n, 3], and force histories of the
        models that have one, by model.
    """
    first = next(iter(launches.values()))
    alone = len(launches) == 1
    title = f"{first.club.name}, ball {first.ball.name}" + (f", by {first.model}" if alone else "")
    columns = [text("model", list(launches), printed=not alone), *_columns(launches, flights, alone)]
    return Result(
        kind="shot", title=title,
        tables=(Table("shots", tuple(columns), layout="list" if alone else "rows", title=title),),
        summary=tuple(_summary(first, flights[first.model], alone)),
        notes=tuple(_notes(launches, flights)),
        provenance=provenance_of(launches.values(), flight_conditions(**(conditions or {}))),
        draw=None if paths is None else lambda: [shot_picture(*paths(), title=_described(first))],
    )  # fmt: skip


def _columns(launches: Mapping[str, Launch], flights: Mapping[str, Flight], alone: bool) -> list[Column]:
    return [
        column(
            name,
            [getattr(each if name in each.quantities() else flights[model], name) for model, each in launches.items()],
            printed=alone or name not in ONE_MODEL_ONLY,
        )
        for name in QUANTITIES
    ]


def _summary(launch: Launch, flight: Flight, alone: bool) -> list[Note]:
    side = "shot-on-line" if abs(flight.side) < 0.4572 else "shot-off-line"
    sentences = [
        note("shot-delivery", club=launch.club.name, ball=launch.ball.name, speed=launch.delivery["speed"],
             loft=launch.delivery["loft"]),
        note("shot-launch", ball_speed=launch.ball_speed, launch=launch.launch, total_spin=launch.total_spin),
        note(side, carry=flight.carry, side=flight.side, apex=flight.apex, landing_angle=flight.landing_angle),
    ]  # fmt: skip
    return sentences if alone else [*sentences, note("shot-of-first-model", model=launch.model)]


def _notes(launches: Mapping[str, Launch], flights: Mapping[str, Flight]) -> list[Note]:
    notes = []
    if outside := [name for name in launches if flights[name].outside_fit]:
        notes.append(note("outside-aerodynamic-data", models=outside))
    if doubted := [name for name, each in launches.items() if each.parameters.caveats or each.parameters.value_caveats]:
        notes.append(note("caveats-listed", model=doubted[0] if len(doubted) == 1 else "NAME"))
    return notes


def _described(launch: Launch) -> str:
    """Return club and delivery in words, values and units held together by spaces that do not break."""
    parts = [
        f"{name.replace('_', ' ')} {format_value(float(value), quantity(name))}"
        for name, value in launch.delivery.items()
        if value
    ]
    if launch.club.hand < 0:
        parts.append("left-handed")
    return f"{launch.club.name}: {', '.join(each.replace(' ', chr(160)) for each in parts)}"


def shot_picture(flights: Mapping[str, Any], histories: Mapping[str, Any] | None = None, *, title: str = "") -> Picture:
    """Return the picture of a shot: forces above, the flight from the side and from above below.

    Parameters
    ----------
    flights
        Positions of the ball [m], shape [n, 3], by model or other name.
    histories
        A :class:`clubface.History` (or its columns by name) of each model that has one.
    title
        What was hit and how.
    """
    histories = histories or {}
    forces = [_force_panel(name, label, histories) for name, label in _FORCES.items()] if histories else []
    views, heights = _views({name: np.asarray(each, dtype=float) for name, each in flights.items()})
    rows: list[list[Panel | None]] = [*([[*forces]] if forces else []), *([each] for each in views)]
    without = [name for name in flights if name not in histories] if histories else []
    return Picture(
        name="flight", caption="The flight from the side and from above, and the forces where a model has them",
        rows=rows, heights=[*([2.2] if forces else []), *heights], title=title, legend=True,
        height=(2.4 if forces else 0.2) + sum(heights) + 1.5,
        footnote=f"no force history (impulse models): {', '.join(without)}" if without else "",
    )  # fmt: skip


def force_picture(histories: Mapping[str, Any]) -> Picture:
    """Return the picture of the forces on the ball over time; ``histories`` as of :func:`shot_picture`."""
    panels = [_force_panel(name, label, histories, named=True) for name, label in _FORCES.items()]
    return Picture("forces", "The force on the ball over time", [panels], height=2.5, legend=True)


_FORCES = {"normal_force": "normal force", "force_y": "friction along y'", "force_z": "friction along z'"}
"""Columns of a history and their labels; y' points up the face, z' to the toe."""
_LEAST_FORCE = 20.0
"""N over which an axis of friction extends at least to either side, so that noise does not fill a panel."""


def _force_panel(name: str, label: str, histories: Mapping[str, Any], *, named: bool = False) -> Panel:
    marks = [
        Mark("line", _values(each, "time"), _values(each, name), style=model, label=model if named else "")
        for model, each in histories.items()
    ]
    highest = max((float(np.abs(mark.y).max(initial=0.0)) for mark in marks), default=0.0)
    normal = name == "normal_force"
    low = 0.0 if normal else None if highest > _LEAST_FORCE else -_LEAST_FORCE
    high = None if normal or highest > _LEAST_FORCE else _LEAST_FORCE
    rule = [] if normal else [Mark("rule", y=0.0, style=-1)]
    return Panel(
        [*marks, *rule], axis("time", unit="us", limits=(0.0, None)),
        axis(name, label, like="N", unit="kN", limits=(low, high)),
    )  # fmt: skip


def _views(flights: Mapping[str, Any]) -> tuple[list[Panel], list[float]]:
    positions = np.concatenate(list(flights.values()))
    length = 1.03 * max(float(positions[:, 0].max()), 1.0)
    margin = 0.06 * float(np.ptp(positions[:, 2])) + 0.5
    right, left = max(float(positions[:, 2].max()), 0.0) + margin, min(float(positions[:, 2].min()), 0.0) - margin
    views = (
        ("from the side", 1, axis("apex", "height", limits=(0.0, 1.06 * max(float(positions[:, 1].max()), 0.5)))),
        ("from above", 2, axis("side", "right", limits=(left, right), reversed=True)),
    )  # fmt: skip
    panels, heights = [], []
    for name, place, across in views:
        marks = [Mark("line", each[:, 0], each[:, place], style=model, label=model) for model, each in flights.items()]
        rule = [Mark("rule", y=0.0, style=-1)] if place == 2 else []
        low, high = across.limits
        span, stretch = abs((high or 0.0) - (low or 0.0)), 1.0
        steps = iter((2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0))
        while span * stretch < _FLATTEST * length:
            stretch = next(steps, _FLATTEST * length / span + 1.0)
        way = "upwards" if place == 1 else "sideways"
        scale = "equal scales" if stretch == 1.0 else f"stretched {stretch:g} times {way}"
        along = axis("carry", "distance along the target line", limits=(0.0, length))
        panels.append(Panel([*marks, *rule], along, across, title=f"{name}, {scale}", aspect=stretch))
        heights.append(6.5 * min(span * stretch / length, _TALLEST))
    return panels, heights


def _values(history: Any, name: str) -> Any:
    return np.asarray(history[name] if isinstance(history, Mapping) else getattr(history, name), dtype=float)
