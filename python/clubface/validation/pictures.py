"""Models beside the published tour averages: launches, and the errors as they are."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from clubface import units
from clubface.plots import WIDTH, legend_above, marker, styled
from clubface.validation.tour_tables import DIGITS, FLIGHT_ONLY, compared

if TYPE_CHECKING:
    from clubface.validation.tour import Tour


TITLES = {"ball_speed": "ball speed", "launch": "launch angle", "spin": "spin", "carry": "carry"}


@styled
def launch_figure(tour: Tour) -> Figure:
    """Draw ball speed, spin and carry of every club, published and by each model, and the lofts they are delivered at.

    Lofts are shown from the launch angle up, since what spin tells of them is some degrees at most.
    """
    figure = Figure(figsize=(WIDTH, 5.4), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    places = np.arange(len(tour.clubs))
    quantities = [name for name in tour.units if name != "launch"]
    for axes, quantity in zip(panels, quantities, strict=False):
        unit = tour.units[quantity]
        axes.plot(places, units.from_si(tour.published[quantity], unit), color="0.55", linewidth=1.0, zorder=1)
        for model in tour.models:
            offsets = places + _dodge(tour, model)
            axes.plot(offsets, units.from_si(tour.values[model][quantity], unit), **marker(model), markersize=3.2)
        if quantity == "carry":
            axes.plot(places, units.from_si(tour.carry_of_published, unit), **_FLIGHT_LOOK)
        axes.set_ylabel(f"{TITLES[quantity]} ({unit})")
        axes.set_ylim(bottom=0.0)
    _draw_lofts(panels[-1], tour)
    _name_clubs(panels[2:], tour)
    published = Line2D([], [], color="0.55", linewidth=1.0, label="published")
    loft = [Line2D([], [], label="published loft", **_LOFT_LOOK)] if tour.loft_is_published.any() else []
    possible = Patch(facecolor="0.80", label="possible loft")
    _legend(figure, tour, published, *loft, possible)
    return figure


def _draw_lofts(axes: Axes, tour: Tour) -> None:
    """Draw dynamic loft less launch angle: published, possible, and with which each model launches as published."""
    places, launch = np.arange(len(tour.clubs)), tour.published["launch"]
    low, high = (units.from_si(each - launch, "deg") for each in tour.possible_lofts)
    axes.bar(places, high - low, 0.84, bottom=low, color="0.80", zorder=1)
    for model in tour.models:
        solved = units.from_si(tour.solved_lofts[model] - launch, "deg")
        axes.plot(places + _dodge(tour, model), solved, **marker(model), markersize=3.2)
    known = tour.loft_is_published
    given = units.from_si((tour.lofts[tour.models[0]] - launch)[known], "deg")
    axes.plot(places[known], given, **_LOFT_LOOK)
    axes.set_ylabel("loft less launch angle (deg)")
    axes.set_ylim(bottom=0.0)


@styled
def error_figure(tour: Tour) -> Figure:
    """Draw the signed error of every model and club, and beside it each model's mean absolute error.

    A launch angle from which the loft was solved is hollow and has no part in the mean; where all are, there is no row.
    """
    shown = compared(tour)
    figure = Figure(figsize=(WIDTH, 0.4 + 1.8 * len(shown)), layout="constrained")
    grid = figure.subplots(len(shown), 2, width_ratios=[3.6, 1.0], squeeze=False)
    places = np.arange(len(tour.clubs))
    for (axes, bars), (quantity, unit) in zip(grid, shown.items(), strict=True):
        hollow = tour.is_fitted(quantity)
        axes.axhline(0.0, color="0.35", linewidth=0.7, zorder=1)
        for model in tour.models:
            error = units.from_si(tour.errors(model)[quantity], unit)
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
_LOFT_LOOK: dict[str, Any] = {
    "color": "0.15", "marker": "_", "linestyle": "none", "markersize": 14.0, "markeredgewidth": 1.8, "zorder": 4,
}  # fmt: skip


def _draw_means(axes: Axes, tour: Tour, quantity: str, unit: str) -> None:
    names = list(tour.models)
    means = [units.from_si(tour.mean_absolute_error(model)[quantity], unit) for model in names]
    rows = np.arange(len(names))
    digits = DIGITS[quantity]
    for row, (model, mean) in enumerate(zip(names, means, strict=True)):
        axes.barh(row, mean, height=0.62, color=marker(model)["color"])
        axes.annotate(
            f"{mean:.{digits}f}", (mean, row), (2.0, 0.0), textcoords="offset points", va="center", fontsize=7.0
        )
    axes.set_yticks(rows, names)
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(means) * 1.25)
    axes.set_title(f"mean absolute ({unit})")
    axes.grid(visible=False)
    axes.tick_params(axis="y", length=0.0)


def _dodge(tour: Tour, model: str) -> float:
    """Return the sideways shift that keeps the points of one club apart."""
    count = len(tour.models)
    return 0.0 if count == 1 else 0.7 * (list(tour.models).index(model) / (count - 1) - 0.5)


def _name_clubs(panels: Iterable[Axes], tour: Tour) -> None:
    for axes in panels:
        axes.set_xticks(np.arange(len(tour.clubs)), tour.clubs, rotation=40, ha="right", rotation_mode="anchor")


def _legend(figure: Figure, tour: Tour, *more: Artist) -> None:
    models = [Line2D([], [], label=model, **marker(model)) for model in tour.models]
    legend_above(figure, [*models, *more, Line2D([], [], label=FLIGHT_ONLY, **_FLIGHT_LOOK)])
