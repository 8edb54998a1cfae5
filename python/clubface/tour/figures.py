"""Models beside the published tour averages: launches, and the errors as they are."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from clubface import units
from clubface.plots.style import WIDTH, legend_above, marker, styled
from clubface.tour.tables import DIGITS, FLIGHT_ONLY, is_fitted

if TYPE_CHECKING:
    from clubface.tour.averages import Tour

TITLES = {"ball_speed": "ball speed", "launch": "launch angle", "spin": "spin", "carry": "carry"}


@styled
def launch_figure(tour: Tour) -> Figure:
    """Draw ball speed, launch angle, spin and carry of every club: published, and by each model."""
    figure = Figure(figsize=(WIDTH, 5.4), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    places = np.arange(len(tour.clubs))
    for axes, (quantity, unit) in zip(panels, tour.units.items(), strict=True):
        axes.plot(places, units.from_si(tour.published[quantity], unit), color="0.55", linewidth=1.0, zorder=1)
        for model in tour.models:
            offsets = places + _dodge(tour, model)
            axes.plot(offsets, units.from_si(tour.values[model][quantity], unit), **marker(model), markersize=3.2)
        if quantity == "carry":
            axes.plot(places, units.from_si(tour.carry_of_published, unit), **_FLIGHT_LOOK)
        axes.set_ylabel(f"{TITLES[quantity]} ({unit})")
        axes.set_ylim(bottom=0.0)
    _name_clubs(panels[2:], tour)
    _legend(figure, tour, Line2D([], [], color="0.55", linewidth=1.0, label="published"))
    return figure


@styled
def error_figure(tour: Tour) -> Figure:
    """Draw the signed error of every model and club, and beside it each model's mean absolute error."""
    figure = Figure(figsize=(WIDTH, 7.6), layout="constrained")
    grid = figure.subplots(len(tour.units), 2, width_ratios=[3.6, 1.0], squeeze=False)
    places = np.arange(len(tour.clubs))
    for (axes, bars), (quantity, unit) in zip(grid, tour.units.items(), strict=True):
        axes.axhline(0.0, color="0.35", linewidth=0.7, zorder=1)
        for model in tour.models:
            error = units.from_si(tour.errors(model)[quantity], unit)
            hollow = _fitted(tour, model, quantity)
            offsets = places + _dodge(tour, model)
            axes.plot(offsets[~hollow], error[~hollow], **marker(model), markersize=3.2)
            axes.plot(offsets[hollow], error[hollow], **marker(model), markersize=3.2, fillstyle="none")
        if quantity == "carry":
            axes.plot(places, units.from_si(tour.carry_of_published - tour.published["carry"], unit), **_FLIGHT_LOOK)
        axes.set_title(f"{TITLES[quantity]}: model less published ({unit})")
        axes.set_xlim(-0.6, len(places) - 0.4)
        axes.grid(axis="x", visible=False)
        for edge in places[1:] - 0.5:
            axes.axvline(edge, color="0.92", linewidth=0.5, zorder=0)
        if axes is not grid[-1][0]:
            axes.set_xticks(places, [])
        _draw_means(bars, tour, quantity, unit)
    _name_clubs([grid[-1][0]], tour)
    _legend(figure, tour)
    return figure


_FLIGHT_LOOK: dict[str, Any] = {
    "color": "0.35", "marker": "_", "linestyle": "none", "markersize": 9.0, "markeredgewidth": 1.4, "zorder": 4,
}  # fmt: skip


def _draw_means(axes: Axes, tour: Tour, quantity: str, unit: str) -> None:
    names = list(tour.models)
    means = [units.from_si(tour.mean_absolute_error(model)[quantity], unit) for model in names]
    rows = np.arange(len(names))
    digits = DIGITS[quantity]
    for row, (model, mean) in enumerate(zip(names, means, strict=True)):
        colour, fitted = marker(model)["color"], _fitted(tour, model, quantity).any()
        axes.barh(row, mean, height=0.62, edgecolor=colour, facecolor="none" if fitted else colour)
        text = f"{mean:.{digits}f}" + (" (loft fitted)" if fitted else "")
        axes.annotate(text, (mean, row), (2.0, 0.0), textcoords="offset points", va="center", fontsize=7.0)
    axes.set_yticks(rows, names)
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(means) * 1.25)
    axes.set_title(f"mean absolute ({unit})")
    axes.grid(visible=False)
    axes.tick_params(axis="y", length=0.0)


def _fitted(tour: Tour, model: str, quantity: str) -> np.ndarray:
    """Return for which clubs the loft was chosen so that this error vanishes."""
    return np.array([is_fitted(tour, index, model, quantity) for index in range(len(tour.clubs))])


def _dodge(tour: Tour, model: str) -> float:
    """Return the sideways shift that keeps the points of one club apart."""
    count = len(tour.models)
    return 0.0 if count == 1 else 0.7 * (list(tour.models).index(model) / (count - 1) - 0.5)


def _name_clubs(panels: Iterable[Axes], tour: Tour) -> None:
    for axes in panels:
        axes.set_xticks(np.arange(len(tour.clubs)), tour.clubs, rotation=40, ha="right", rotation_mode="anchor")


def _legend(figure: Figure, tour: Tour, *more: Line2D) -> None:
    models = [Line2D([], [], label=model, **marker(model)) for model in tour.models]
    legend_above(figure, [*models, *more, Line2D([], [], label=FLIGHT_ONLY, **_FLIGHT_LOOK)])
