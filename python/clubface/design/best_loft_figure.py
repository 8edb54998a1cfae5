"""The picture of best lofts: by club speed, a line an attack angle, or beside a published chart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure

from clubface.design.best_loft import Beside, BestLoft
from clubface.plots.style import COLOURS, DASHES, MARKERS, WIDTH, styled
from clubface.units import from_si


@styled
def best_loft_figure(of: BestLoft) -> Figure:
    """Draw loft and carry over the club speed; bars reach as far as a yard of carry is lost."""
    figure = Figure(figsize=(WIDTH, 3.2), layout="constrained")
    lofts, carries = figure.subplots(1, 2)
    for place, attack in enumerate(np.unique(of.attack)):
        rows = of.attack == attack
        order = np.argsort(of.speed[rows], kind="stable")
        speed, loft, carry = (from_si(each[rows][order], unit) for each, unit in
                              ((of.speed, "mph"), (of.loft, "deg"), (of.carry, "yd")))  # fmt: skip
        look = {
            "color": COLOURS[place % len(COLOURS)], "linestyle": DASHES[place % len(DASHES)],
            "marker": MARKERS[place % len(MARKERS)], "label": f"attack {from_si(attack, 'deg') + 0.0:.3g}°",
        }  # fmt: skip
        lofts.errorbar(speed, loft, yerr=from_si(of.within[rows][order], "deg").T, capsize=2.0, elinewidth=0.7, **look)
        carries.plot(speed, carry, **look)
    lofts.set_ylabel("best dynamic loft (deg)")
    lofts.set_title("Bars: within them less than a yard is lost")
    carries.set_ylabel("carry (yd)")
    carries.set_title("How far the ball carries with it")
    for axes in (lofts, carries):
        axes.set_xlabel("club speed (mph)")
    lofts.legend()
    return figure


@styled
def chart_figure(of: Beside, shown: Mapping[str, tuple[str, str, str]], chart: str) -> Figure:
    """Draw what was found over what a chart has.

    ``shown`` gives name in the chart, name of what was found and unit, by title.
    """
    panels: Sequence[tuple[str, tuple[str, str, str]]] = list(shown.items())
    figure = Figure(figsize=(WIDTH, 2.4 * ((len(panels) + 1) // 2)), layout="constrained")
    for axes, (title, (published, own, unit)) in zip(
        figure.subplots((len(panels) + 1) // 2, 2).ravel(), panels, strict=False
    ):
        theirs, ours = from_si(of.published[published], unit), from_si(getattr(of.found, own), unit)
        ends = [min(theirs.min(), ours.min()), max(theirs.max(), ours.max())]
        axes.plot(ends, ends, color="0.6", linewidth=0.8)
        axes.plot(theirs, ours, "o", color=COLOURS[0], alpha=0.8)
        axes.set_xlabel(f"{chart} ({unit})")
        axes.set_ylabel(f"found here ({unit})")
        axes.set_title(title)
    return figure
