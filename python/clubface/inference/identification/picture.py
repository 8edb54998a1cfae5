"""How well parameters are identified: profile likelihoods, bootstrapped fits and their intervals."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from clubface import units
from clubface.equipment.models import model
from clubface.inference.identification.intervals import CHI_SQUARE_95
from clubface.plots import COLOURS, WIDTH, legend_above, styled
from clubface.quantities import display_unit
from clubface.support.arrays import Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from clubface.inference.identification.result import Identification


COLUMNS = 4
"""Panels in a row."""
HIGHEST = 3.0 * CHI_SQUARE_95
"""Rise at the top of a panel."""
BINS = 24
FINE = 16
"""Points of a curve between two places of a profile."""


@styled
def identification_figure(of: Identification) -> Figure:
    """Draw one panel for each free parameter: its profile likelihood with the 95% level, samples and interval."""
    rows = math.ceil(len(of.free) / COLUMNS)
    columns = min(len(of.free), COLUMNS)
    figure = Figure(figsize=(WIDTH, 0.5 + 1.75 * rows), layout="constrained")
    grid = figure.subplots(rows, columns, squeeze=False, sharey=True)
    for axes in grid.flat[len(of.free) :]:
        axes.remove()
    for place, (axes, name) in enumerate(zip(grid.flat, of.free, strict=False)):
        _draw(axes, of, place, name)
    for axes in grid[:, 0]:
        axes.set_ylabel("-2 log likelihood,\nrise")
    handles = [Line2D([], [], color=COLOURS[0], label="profile"), Line2D([], [], color=COLOURS[1], label="fit")]
    handles += [Patch(color=COLOURS[1], alpha=0.18, label=f"{100 * of.confidence:g}% interval")]
    if len(of.samples):
        handles += [Patch(color="0.75", label="bootstrap")]
    handles += [Line2D([], [], color="0.3", linestyle=":", linewidth=1.0, label="3.84: 95% of the likelihood")]
    legend_above(figure, handles, title=f"{of.model}, {of.club}, {of.shots} shots")
    return figure


def _draw(axes: Axes, of: Identification, place: int, name: str) -> None:
    unit = display_unit(name, model(of.model).parameter(name).unit)
    low, high = (float(units.from_si(end, unit)) for end in of.intervals[name])
    value = float(units.from_si(of.parameters.values[name], unit))
    axes.axvspan(low, high, color=COLOURS[1], alpha=0.18, linewidth=0.0)
    axes.axvline(value, color=COLOURS[1], linewidth=1.0)
    shown = [low, high, value]
    profile = of.profiles.get(name)
    if profile is not None:
        where = units.from_si(profile.values, unit)
        axes.plot(*_between(where, profile.rise), color=COLOURS[0])
        axes.plot(where, profile.rise, color=COLOURS[0], marker="o", markersize=2.2, linestyle="none")
        near = where[profile.rise <= HIGHEST]
        shown += [float(near.min()), float(near.max())]
    span = max(shown) - min(shown) or abs(value) or 1.0
    left, right = min(shown) - 0.08 * span, max(shown) + 0.08 * span
    if len(of.samples):
        counts, edges = np.histogram(units.from_si(of.samples[:, place], unit), bins=BINS, range=(left, right))
        heights = counts / max(counts.max(), 1) * 0.45 * HIGHEST
        axes.stairs(heights, edges, fill=True, color="0.75", zorder=0.5)
    axes.axhline(CHI_SQUARE_95, color="0.3", linestyle=":", linewidth=1.0)
    axes.set_xlim(left, right)
    axes.set_ylim(0.0, HIGHEST)
    axes.set_xlabel(name.replace("_", " ") + ("" if unit == "1" else f" [{unit}]"))
    axes.locator_params(axis="x", nbins=4)


def _between(where: Floats, rise: Floats) -> tuple[Floats, Floats]:
    """Return a curve through the places of a profile, its root linear between them as where its interval ends."""
    place = np.linspace(0.0, len(where) - 1.0, FINE * (len(where) - 1) + 1)
    lowest = float(np.argmin(rise))
    roots = np.sqrt(rise) * np.sign(np.arange(len(rise)) - lowest)
    counted = np.arange(len(where))
    return np.interp(place, counted, where), np.interp(place, counted, roots) ** 2
