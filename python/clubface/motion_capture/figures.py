"""Pictures of the errors of the estimators of motion capture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from clubface import units
from clubface.motion_capture.reduction import QUANTITIES
from clubface.plots.style import COLOURS, WIDTH, legend_above, styled

if TYPE_CHECKING:
    from clubface.motion_capture.study import Study

SHOWN = {
    "speed": "speed", "attack": "attack angle", "path": "path", "loft": "dynamic loft", "face": "face angle",
    "toe": "towards the toe", "high": "high", "closure": "closure rate",
}  # fmt: skip


@styled
def study_figure(studies: Mapping[str, Study]) -> Figure:
    """Draw bias and spread of every estimator: one panel a quantity, one group of lines a study.

    Parameters
    ----------
    studies
        The studies by the text written beside each group, such as "no noise".
    """
    from clubface.motion_capture.study import UNITS

    figure = Figure(figsize=(WIDTH, 4.0), layout="constrained")
    panels = figure.subplots(2, 4, sharey=True).ravel()
    names = list(next(iter(studies.values())).errors)
    for axes, (quantity, label) in zip(panels, SHOWN.items(), strict=True):
        column = QUANTITIES.index(quantity)
        axes.axvline(0.0, color="0.35", linewidth=0.7, zorder=1)
        for group, found in enumerate(studies.values()):
            for place, name in enumerate(names):
                error = units.from_si(found.errors[name][:, column], UNITS[quantity])
                low, first, last, high = np.quantile(error, [0.025, 0.25, 0.75, 0.975])
                y = group * (len(names) + 1.2) + place
                colour = COLOURS[place % len(COLOURS)]
                axes.plot([low, high], [y, y], color=colour, linewidth=1.0)
                axes.plot([first, last], [y, y], color=colour, linewidth=3.6, solid_capstyle="butt")
                axes.plot(error.mean(), y, marker="o", color="white", markeredgecolor=colour, markersize=3.6)
        axes.set_title(f"{label} ({UNITS[quantity]})")
        axes.grid(visible=False, axis="y")
    middle = [group * (len(names) + 1.2) + 0.5 * (len(names) - 1) for group in range(len(studies))]
    for axes in panels:
        axes.set_yticks(middle, list(studies))
        axes.tick_params(axis="y", length=0)
    panels[0].invert_yaxis()
    lines = [
        Line2D([], [], color=COLOURS[place % len(COLOURS)], linewidth=3.0, label=each)
        for place, each in enumerate(names)
    ]
    how = "captured less true: mean, middle half and 95% of the swings"
    legend_above(figure, lines, title=how)
    return figure
