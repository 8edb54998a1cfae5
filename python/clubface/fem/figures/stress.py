"""The picture of a blow: the largest stress of every part of a head beside the stress at which its metal yields."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from clubface.fem.stress import PartStress
from clubface.plots.style import COLOURS, WIDTH, styled
from clubface.units import from_si


@styled
def stress_figure(parts: Sequence[PartStress]) -> Figure:
    """Draw a bar a part, and a line across it where the metal yields, if that is known."""
    figure = Figure(figsize=(WIDTH, 1.1 + 0.32 * len(parts)), layout="constrained")
    axes = figure.subplots()
    for row, part in enumerate(parts):
        yields = part.margin is not None and part.margin < 0.0
        axes.barh(row, from_si(part.stress, "MPa"), height=0.6, color=COLOURS[1 if yields else 0],
                  hatch="////" if yields else None, edgecolor="white", linewidth=0.0)  # fmt: skip
        if part.yield_stress is not None:
            at = from_si(part.yield_stress, "MPa")
            axes.plot([at, at], [row - 0.42, row + 0.42], color="black", linewidth=2.0)
    axes.set_yticks(range(len(parts)), [part.part for part in parts])
    axes.set_ylim(len(parts) - 0.4, -0.6)
    axes.set_xlabel("largest stress (MPa); the black line is where the metal yields, hatched bars are beyond it")
    return figure
