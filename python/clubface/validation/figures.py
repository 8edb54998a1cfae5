"""Models beside published figures as a picture: every error in units of its tolerance."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure as Picture
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from clubface.plots.style import WIDTH, legend_above, marker, styled
from clubface.validation.tables import tolerances

if TYPE_CHECKING:
    from clubface.validation.run import Validation

LIMIT = 4.0
"""Errors beyond so many tolerances stand at the edge."""


@styled
def validation_figure(result: Validation) -> Picture:
    """Draw a row for each quantity of each check: every figure's error over its tolerance, by model."""
    rows = [
        (check, each) for check in result.checks for each in result.summary(result.models[0], check.name)
    ]  # fmt: skip
    figure = Picture(figsize=(WIDTH, 0.8 + 0.235 * len(rows)), layout="constrained")
    axes = figure.subplots()
    axes.axvspan(-1.0, 1.0, color="0.90", zorder=0)
    axes.axvline(0.0, color="0.55", linewidth=0.7, zorder=1)
    places = np.arange(len(rows))
    shift = 0.56 / max(len(result.models), 2)
    for index, model in enumerate(result.models):
        offset = (index - 0.5 * (len(result.models) - 1)) * shift
        for place, (check, quantity) in zip(places, rows, strict=True):
            figures = [each for each in result.figures[model][check.name] if each.quantity == quantity.quantity]
            errors = np.array([each.error / each.tolerance for each in figures if each.within is not None])
            axes.plot(
                np.clip(errors, -LIMIT, LIMIT), np.full(errors.size, place + offset), **marker(model),
                markersize=2.6, alpha=0.75, clip_on=False,
            )  # fmt: skip
    for place, (check, _) in zip(places[1:], rows[1:], strict=True):
        if check is not rows[place - 1][0]:
            axes.axhline(place - 0.5, color="0.80", linewidth=0.5, zorder=0)
    axes.set_yticks(places, [f"{check.name}: {each.quantity}, ± {tolerances(each)}" for check, each in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlim(-LIMIT, LIMIT)
    axes.set_xticks(np.arange(-LIMIT, LIMIT + 0.5), [f"{each:+.0f}" if each else "0" for each in np.arange(-4, 5)])
    axes.set_xlabel("computed less published, over the tolerance")
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0.0)
    lines = [Line2D([], [], label=model, **marker(model)) for model in result.models]
    legend_above(figure, [*lines, Patch(facecolor="0.90", label="within the tolerance")])
    return figure
