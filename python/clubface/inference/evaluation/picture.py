"""Pictures of an evaluation: sizes of errors, what they depend on, and model over measured values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from clubface import units
from clubface.inference.evaluation.statistics import COVARIATES
from clubface.inference.evaluation.tables import DIGITS, name_of
from clubface.plots import WIDTH, legend_above, look, marker, styled
from clubface.shots.measured import QUANTITIES

if TYPE_CHECKING:
    from clubface.inference.evaluation.model_errors import ModelErrors


TREND_COVARIATES = ("speed", "path", "toe", "high")
"""Those drawn; the tables have all."""
_NUMBER: dict[str, Any] = {"ha": "right", "va": "center", "fontsize": 7.0}
MOST_BINS, FEWEST_IN_BIN = 8, 8
MOST_POINTS = 2000
"""Shots drawn one by one; of more, every so-manieth."""


@styled
def error_figure(of: ModelErrors) -> Figure:
    """Draw the mean absolute error of each model with its interval, the published error, and the effect of noise."""
    count = len(of.quantities)
    figure = Figure(figsize=(WIDTH, 0.5 + (0.35 + 0.17 * len(of.models)) * ((count + 1) // 2)), layout="constrained")
    panels = figure.subplots((count + 1) // 2, 2, squeeze=False).ravel()
    rows = np.arange(len(of.models))
    for axes, name in zip(panels, of.quantities, strict=False):
        unit = QUANTITIES[name]
        ends = []
        for row, model in enumerate(of.models):
            size = of.sizes[name][model]
            mae, low, high = (float(units.from_si(each, unit)) for each in (size.mae, *size.mae_interval))
            colour = marker(model)["color"]
            axes.barh(row, mae, height=0.6, color=colour, alpha=0.6, linewidth=0.0)
            axes.plot([low, high], [row, row], color="0.1", linewidth=0.9, solid_capstyle="butt")
            given = of.published.get(model)
            shown = float(units.from_si(given.mae[name], unit)) if given else 0.0
            if given:
                axes.plot(shown, row, marker="D", markersize=4.5, markerfacecolor="white", markeredgecolor="0.1")
            ends.append(np.nanmax([mae, high, shown]))
            axes.text(1.0, row, f"{mae:.{DIGITS[name]}f}", transform=axes.get_yaxis_transform(), **_NUMBER)
        if name in of.floor:
            axes.axvspan(0.0, float(units.from_si(of.floor[name], unit)), color="0.80", zorder=0, linewidth=0.0)
        axes.set_yticks(rows, of.models)
        axes.invert_yaxis()
        axes.set_xlim(0.0, 1.2 * max(ends))
        axes.grid(axis="y", visible=False)
        axes.tick_params(axis="y", length=0.0)
        axes.set_title(name_of(name))
    for axes in panels[count:]:
        axes.set_axis_off()
    handles = [
        Patch(facecolor="0.55", label="mean absolute error"),
        Line2D([], [], color="0.1", linewidth=0.9, label="95% interval"),
    ]
    if of.published:
        look_of_published = {"marker": "D", "markersize": 4.5, "markerfacecolor": "white", "markeredgecolor": "0.1"}
        handles.append(Line2D([], [], linestyle="none", label="as published, on other shots", **look_of_published))
    if of.floor:
        handles.append(Patch(facecolor="0.80", label="what measurement alone explains"))
    legend_above(figure, handles)
    return figure


@styled
def trend_figure(of: ModelErrors) -> Figure:
    """Draw the error of each model over speed, path and place on the face, as means of equal numbers of shots."""
    names = [name for name in TREND_COVARIATES if _varies(of, name)]
    figure = Figure(figsize=(WIDTH, 0.6 + 1.45 * len(of.quantities)), layout="constrained")
    if not names:
        figure.text(0.5, 0.5, "nothing of the delivery varies", ha="center")
        return figure
    grid = figure.subplots(len(of.quantities), len(names), sharex="col", sharey="row", squeeze=False)
    for panels, quantity in zip(grid, of.quantities, strict=True):
        for axes, name in zip(panels, names, strict=True):
            x = units.from_si(of.shots.delivery[name], COVARIATES[name])
            axes.axhline(0.0, color="0.35", linewidth=0.7, zorder=1)
            for model in of.models:
                error = units.from_si(of.errors(model, quantity), QUANTITIES[quantity])
                axes.plot(*_binned(x, error), **look(model), linewidth=1.1)
            axes.locator_params(axis="x", nbins=5)
        panels[0].set_ylabel(name_of(quantity).replace(" (", "\n("))
    for axes, name in zip(grid[-1], names, strict=True):
        axes.set_xlabel(f"{name} ({COVARIATES[name]})")
    legend_above(figure, [Line2D([], [], label=model, **look(model)) for model in of.models])
    return figure


@styled
def agreement_figure(of: ModelErrors) -> Figure:
    """Draw the computed value of each shot over the measured one, for the best model of each quantity."""
    count = len(of.quantities)
    figure = Figure(figsize=(WIDTH, 2.5 * ((count + 2) // 3)), layout="constrained")
    panels = figure.subplots((count + 2) // 3, min(count, 3), squeeze=False).ravel()
    step = max(1, -(-len(of.shots) // MOST_POINTS))
    for axes, name in zip(panels, of.quantities, strict=False):
        model, unit = of.best[name].model, QUANTITIES[name]
        measured = units.from_si(of.shots.launch[name], unit)[::step]
        computed = units.from_si(of.predicted[model][name], unit)[::step]
        axes.plot(
            measured, computed, **{**marker(model), "markersize": 1.8}, alpha=0.6, markeredgewidth=0.0, rasterized=True
        )
        ends = [np.nanmin([measured, computed]), np.nanmax([measured, computed])]
        axes.plot(ends, ends, color="0.35", linewidth=0.8, zorder=1)
        axes.set_aspect("equal", adjustable="datalim")
        axes.locator_params(nbins=5)
        axes.set_title(f"{name_of(name)}: {model}")
        axes.set_xlabel("measured")
        axes.set_ylabel("model")
    for axes in panels[count:]:
        axes.set_axis_off()
    return figure


def _varies(of: ModelErrors, name: str) -> bool:
    values = of.shots.delivery.get(name)
    return values is not None and float(np.ptp(values)) > 0.0


def _binned(x: np.ndarray, error: np.ndarray) -> tuple[list[float], list[float]]:
    """Return the means of ``x`` and ``error`` over equal numbers of shots in the order of ``x``."""
    there = np.isfinite(error)
    order = np.argsort(x[there], kind="stable")
    bins = min(MOST_BINS, max(1, order.size // FEWEST_IN_BIN))
    parts = [each for each in np.array_split(order, bins) if each.size]
    return [float(x[there][part].mean()) for part in parts], [float(error[there][part].mean()) for part in parts]
