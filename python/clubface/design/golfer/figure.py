"""The picture of a golfer: how much more or less the landings spread if a figure of his delivery is off."""

from __future__ import annotations

from matplotlib.figure import Figure

from clubface.design.golfer.doubt import QUANTITIES, Doubts
from clubface.plots.style import COLOURS, WIDTH, styled

SHOWN = 8
"""Figures that are drawn: those that change the landings most."""


@styled
def golfer_figure(of: Doubts) -> Figure:
    """Draw the change of the spread of carry and side, a bar a figure, hatched where it is assumed."""
    figures = of.figures[:SHOWN]
    figure = Figure(figsize=(WIDTH, 0.9 + 0.27 * len(figures)), layout="constrained")
    for axes, name in zip(figure.subplots(1, 2, sharey=True), QUANTITIES, strict=True):
        for row, each in enumerate(figures):
            less, more = (100.0 * change for change in of.changes(each, name))
            hatch = "////" if each.assumed else None
            for value, colour in ((less, COLOURS[6]), (more, COLOURS[1])):
                axes.barh(row, value, color=colour, hatch=hatch, edgecolor="white", linewidth=0.0)
        axes.axvline(0.0, color="0.3", linewidth=0.8)
        axes.set_yticks(range(len(figures)), [each.figure.replace("_", " ") for each in figures])
        axes.set_ylim(len(figures) - 0.5, -0.5)
        axes.set_xlabel(f"change of the spread of {name} (%)")
        axes.set_title({"carry": "Short and long", "side": "Left and right"}[name])
    handles = [
        figure.axes[0].barh(-5, 0, color=colour, label=label)
        for colour, label in ((COLOURS[6], f"{of.off:.0%} smaller"), (COLOURS[1], f"{of.off:.0%} larger"))
    ]
    handles.append(figure.axes[0].barh(-5, 0, color="0.7", hatch="////", edgecolor="white", label="assumed"))
    figure.legend(handles=handles, loc="outside lower right", ncols=3)
    return figure
