"""A picture of what a study found: every quantity along every input, its mean, spread and extremes."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from clubface.equipment.described import FLAT
from clubface.plots import COLOURS, WIDTH, legend_above, styled
from clubface.shots.tables.headings import heading_of
from clubface.studies.summaries import Along, Summary, shown_unit
from clubface.units import from_si, size

MOST_ROWS, MOST_COLUMNS = 8, 6
"""Quantities and inputs of a picture; the first of more."""
HEIGHT = 1.25
"""Inches of a panel."""


@styled
def draw(found: Summary) -> Figure:
    """Draw the first quantities of a study, a row each, along the first inputs, a column each."""
    quantities, inputs = list(found.quantities.items())[:MOST_ROWS], list(found.along)[:MOST_COLUMNS]
    figure = Figure(figsize=(WIDTH, 0.7 + HEIGHT * max(len(quantities), 2)), layout="constrained")
    axes = figure.subplots(len(quantities), len(inputs), sharex="col", sharey="row", squeeze=False)
    for row, (name, unit) in enumerate(quantities):
        shown = shown_unit(name, unit)
        for column, along in enumerate(inputs):
            _panel(axes[row, column], along, row, shown)
        axes[row, 0].set_ylabel(_label(name, shown))
    for column, along in enumerate(inputs):
        axes[-1, column].set_xlabel(_label(along.name, heading_of(along.name, along.unit)[1] if along.unit else "1"))
    legend_above(
        figure,
        [
            Line2D([], [], color=COLOURS[0], label="mean"),
            Patch(color=COLOURS[0], alpha=0.2, linewidth=0, label="mean ± deviation"),
            Line2D([], [], color="0.5", linewidth=0.7, linestyle="--", label="extremes"),
        ],
        title=f"{found.name}: {found.tasks} tasks",
    )
    return figure


def _panel(panel: Any, along: Along, place: int, unit: str) -> None:
    mean, least, most = (
        from_si(np.array([getattr(each, key)[place] for each in along.figures]), unit)
        for key in ("mean", "least", "most")
    )
    spread = np.array([each.deviation[place] for each in along.figures]) / size(unit)
    if along.unit is None:
        x = np.arange(len(along.levels))
        panel.set_xticks(x, along.levels, rotation=20 if len(along.levels) > 3 else 0)
        panel.set_xlim(-0.5, len(x) - 0.5)
        panel.vlines(x, least, most, color="0.5", linewidth=0.7, linestyle="--")
        panel.errorbar(x, mean, spread, fmt="o", color=COLOURS[0], capsize=2.5, linewidth=1.0)
        return
    middles = [sum(each) / 2.0 if isinstance(each, tuple) else each for each in along.levels]
    x = from_si(np.array(middles), heading_of(along.name, along.unit)[1])
    if np.isposinf(x[-1]):  # a flat face stands at the right of the numbers
        at = x[-2] + 0.15 * max(x[-2] - x[0], 1e-3) if len(x) > 1 else 0.0
        panel.vlines(at, least[-1], most[-1], color="0.5", linewidth=0.7, linestyle="--")
        panel.errorbar(at, mean[-1], spread[-1], fmt="o", color=COLOURS[0], capsize=2.5, linewidth=1.0)
        panel.annotate(FLAT, (at, mean[-1]), (0.0, 6.0), textcoords="offset points", ha="center", fontsize="x-small")
        x, mean, spread, least, most = (each[:-1] for each in (x, mean, spread, least, most))
    panel.fill_between(x, mean - spread, mean + spread, color=COLOURS[0], alpha=0.2, linewidth=0)
    panel.plot(x, mean, color=COLOURS[0], marker="o" if len(x) < 12 else None, markersize=2.5)
    for each in (least, most):
        panel.plot(x, each, color="0.5", linewidth=0.7, linestyle="--")


def _label(name: str, unit: str) -> str:
    return name.replace("_", " ") + ("" if unit == "1" else f", {unit}")
