"""Pictures of inferred deliveries: every pair of quantities that the launch narrows or ties together."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from clubface import units
from clubface.inference.posterior import CLOSE, NOT_LEARNED, unit_of
from clubface.plots import COLOURS, WIDTH, legend_above, styled

if TYPE_CHECKING:
    from collections.abc import Mapping

    from clubface.inference.posterior import Posterior


MOST_QUANTITIES = 7
MOST_POINTS = 2000
BINS = 30


def worth_drawing(of: Posterior) -> list[str]:
    """Return the quantities that the launch narrows or ties to others; if they are too many, the narrowest ones."""
    tied = np.abs(of.correlation - np.eye(len(of.names))).max(axis=0) >= CLOSE
    learned = of.learned
    names = [name for name, each in zip(of.names, tied, strict=True) if each or learned[name] >= NOT_LEARNED]
    kept = sorted(names, key=lambda name: -learned[name])[:MOST_QUANTITIES]
    return [name for name in of.names if name in kept] or list(of.names[:MOST_QUANTITIES])


@styled
def pairs_figure(of: Posterior, *, truth: Mapping[str, float] | None = None) -> Figure:
    """Draw every pair of quantities, the prior of each, and the correlations; ``truth`` [SI] is marked if known."""
    names = worth_drawing(of)
    count = len(names)
    values = {name: units.from_si(of.deliveries[name], unit_of(name)) for name in names}
    figure = Figure(figsize=(WIDTH, WIDTH), layout="constrained")
    grid = figure.subplots(count, count, squeeze=False, sharex="col")
    correlation = of.correlation
    places = [of.names.index(name) for name in names]
    for row, below in enumerate(names):
        for column, beside in enumerate(names):
            axes = grid[row][column]
            axes.grid(visible=False)
            axes.tick_params(labelsize=6.5)
            axes.locator_params(nbins=3)
            if row == column:
                _draw_alone(axes, of, below, values[below], truth)
            elif row > column:
                points = (values[beside][:MOST_POINTS], values[below][:MOST_POINTS])
                axes.plot(
                    *points, ".", color=COLOURS[0], markersize=1.6, alpha=0.35, markeredgewidth=0.0, rasterized=True
                )
                if truth and below in truth and beside in truth:
                    known = [units.from_si(truth[name], unit_of(name)) for name in (beside, below)]
                    axes.plot(*known, "+", color=COLOURS[1], markersize=8.0, markeredgewidth=1.4)
            else:
                together = correlation[places[row], places[column]]
                axes.set_axis_off()
                size, strength = 6.0 + 5.0 * abs(together), 0.25 + 0.75 * abs(together)
                place: dict[str, Any] = {"transform": axes.transAxes, "ha": "center", "va": "center"}
                axes.text(0.5, 0.5, f"{together:+.2f}", fontsize=size, alpha=strength, **place)
            if row == count - 1:
                axes.set_xlabel(f"{beside} ({unit_of(beside)})")
            if column > 0 or row == column:
                axes.set_yticklabels([])
            else:
                axes.set_ylabel(f"{below} ({unit_of(below)})")
    handles = [
        Line2D([], [], color=COLOURS[0], marker=".", linestyle="none", label="deliveries that make this launch"),
        Line2D([], [], color="0.45", label="before"),
    ]
    if truth:
        handles.append(Line2D([], [], color=COLOURS[1], marker="+", linestyle="none", label="truth"))
    legend_above(figure, handles)
    return figure


def _draw_alone(axes: Axes, of: Posterior, name: str, values: np.ndarray, truth: Mapping[str, float] | None) -> None:
    """Draw the distribution of one quantity, and what was believed before."""
    axes.hist(values, bins=BINS, density=True, color=COLOURS[0], alpha=0.6)
    mean, deviation = (float(units.from_si(each[name], unit_of(name))) for each in (of.prior.mean, of.prior.deviation))
    low, high = axes.get_xlim()
    x = np.linspace(low, high, 200)
    density = np.exp(-0.5 * ((x - mean) / deviation) ** 2) / (deviation * np.sqrt(2.0 * np.pi))
    axes.plot(x, density, color="0.45", linewidth=1.0)
    axes.set_xlim(low, high)
    axes.set_yticks([])
    if truth and name in truth:
        axes.axvline(float(units.from_si(truth[name], unit_of(name))), color=COLOURS[1], linewidth=1.2)
