"""One shot by one or several models: the forces during contact, and the flight."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from clubface import units
from clubface.plots.style import WIDTH, legend_above, look, styled

FORCES = {
    "normal_force": "normal force (kN)",
    "force_y": "friction along y' (kN)",
    "force_z": "friction along z' (kN)",
}
"""Columns of a history and their axis labels; y' points up the face, z' to the toe."""

_FLATTEST, _TALLEST = 0.11, 0.5
"""Height over width of a view: below the first it is stretched, above the second it does not fill the width."""
_VIEW_WIDTH = WIDTH - 0.7
"""Inches, about."""
_TITLE_LETTERS = 95
"""In a line of the title."""


@styled
def force_histories(histories: Mapping[str, Any]) -> Figure:
    """Draw the force on the ball over time, normal and along the face, one line a model.

    Parameters
    ----------
    histories
        A :class:`clubface.History` (or its columns by name) for each model.
    """
    figure = Figure(figsize=(WIDTH, 2.5), layout="constrained")
    _draw_forces(figure.subplots(1, len(FORCES)), histories)
    legend_above(figure, _keys(histories))
    return figure


@styled
def trajectories(flights: Mapping[str, Any]) -> Figure:
    """Draw flights from the side and from above.

    Parameters
    ----------
    flights
        For each model (or other name) the positions of the ball [m], shape [n, 3], axes x, y, z.
    """
    return _figure(flights, {}, "")


@styled
def shot_figure(flights: Mapping[str, Any], histories: Mapping[str, Any] | None = None, *, title: str = "") -> Figure:
    """Draw one shot: forces above, the flight from the side and from above below.

    Models without a history are left out of the panels of force, which a line below says.

    Parameters
    ----------
    flights
        As :func:`trajectories`.
    histories
        As :func:`force_histories`; may be empty.
    title
        What was hit and how.
    """
    return _figure(flights, histories or {}, title)


class _View(NamedTuple):
    """One projection of the flights.

    Attributes
    ----------
    name
        For its heading.
    axis
        The coordinate drawn upwards: 1 (height) or 2 (right of the target).
    limits
        Of that coordinate [yd], from the lower edge to the upper.
    stretch
        By how much its scale exceeds that of the distance.
    shape
        Height over width of the panel.
    """

    name: str
    axis: int
    limits: tuple[float, float]
    stretch: float
    shape: float


def _figure(flights: Mapping[str, Any], histories: Mapping[str, Any], title: str) -> Figure:
    flights = {name: units.from_si(np.asarray(each, dtype=float), "yd") for name, each in flights.items()}
    positions = np.concatenate(list(flights.values()))
    length = 1.03 * max(float(positions[:, 0].max()), 1.0)
    margin = 0.06 * float(np.ptp(positions[:, 2])) + 0.5
    right, left = max(float(positions[:, 2].max()), 0.0), min(float(positions[:, 2].min()), 0.0)
    views = (
        _view("from the side", 1, (0.0, 1.06 * max(float(positions[:, 1].max()), 0.5)), length),
        _view("from above", 2, (right + margin, left - margin), length),
    )
    heights = [each.shape * _VIEW_WIDTH for each in views]
    forces = 2.2 if histories else 0.0
    lines = textwrap.wrap(title, _TITLE_LETTERS)
    figure = Figure(figsize=(WIDTH, forces + sum(heights) + 1.35 + 0.18 * len(lines)), layout="constrained")
    if histories:
        parts: Any = figure.subfigures(2, 1, height_ratios=[forces, sum(heights) + 0.95])
        top, bottom = parts
        _draw_forces(top.subplots(1, len(FORCES)), histories)
        without = [name for name in flights if name not in histories]
        if without:
            top.supxlabel(f"no force history (impulse models): {', '.join(without)}", fontsize=7.0, color="0.35")
    else:
        bottom = figure
    for axes, view in zip(bottom.subplots(2, 1, height_ratios=heights, sharex=True), views, strict=True):
        _draw_view(axes, view, flights, length)
    legend_above(figure, _keys(flights), title="\n".join(lines) or None)
    return figure


def _view(name: str, axis: int, limits: tuple[float, float], length: float) -> _View:
    span, stretch = abs(limits[1] - limits[0]), 1.0
    steps = iter((2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0))
    while span * stretch < _FLATTEST * length:
        stretch = next(steps, _FLATTEST * length / span + 1.0)
    return _View(name, axis, limits, stretch, min(span * stretch / length, _TALLEST))


def _draw_forces(panels: Sequence[Axes], histories: Mapping[str, Any]) -> None:
    for axes, (column, label) in zip(panels, FORCES.items(), strict=True):
        for model, history in histories.items():
            axes.plot(
                units.from_si(_column(history, "time"), "us"),
                units.from_si(_column(history, column), "kN"),
                **look(model),
            )
        axes.set(xlabel="time (µs)", ylabel=label)
        axes.set_xlim(left=0.0)
        if column == "normal_force":
            axes.set_ylim(bottom=0.0)
            continue
        axes.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
        low, high = axes.get_ylim()
        if high - low < _LEAST_FORCE:
            axes.set_ylim(-_LEAST_FORCE / 2.0, _LEAST_FORCE / 2.0)


_LEAST_FORCE = 0.04
"""kN over which an axis of friction extends at least, so that noise does not fill a panel."""


def _draw_view(axes: Axes, view: _View, flights: Mapping[str, Any], length: float) -> None:
    for name, points in flights.items():
        axes.plot(points[:, 0], points[:, view.axis], **look(name))
    axes.set_xlim(0.0, length)
    axes.set_ylim(*view.limits)
    axes.set_aspect(view.stretch)
    scale = "equal scales" if view.stretch == 1.0 else f"stretched {view.stretch:g} times sideways"
    axes.set_title(f"{view.name}, {scale if view.axis == 2 else scale.replace('sideways', 'upwards')}")
    if view.axis == 1:
        axes.set_ylabel("height (yd)")
        return
    axes.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
    axes.set(xlabel="distance along the target line (yd)", ylabel="right (yd)")


def _keys(names: Iterable[str]) -> list[Line2D]:
    return [Line2D([], [], label=name, **look(name)) for name in names]


def _column(history: Any, name: str) -> Any:
    return np.asarray(history[name] if isinstance(history, Mapping) else getattr(history, name), dtype=float)
