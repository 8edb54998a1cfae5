"""The picture of a dispersion: where the balls come down, how far and how wide, and what spreads them."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse as Outline

from clubface.design.dispersion.indices import Indices
from clubface.design.dispersion.sampling import SHARES, Dispersion
from clubface.design.golfer.golfer import told
from clubface.plots.style import COLOURS, WIDTH, legend_above, styled
from clubface.units import from_si, size

MARKED = (0.1, 0.5, 0.9)
"""Shares of the shots that fall short of the dashed lines."""
BARS = 6
"""Variables of which a bar is drawn: those with the greatest shares."""
LAUNCHES = (("ball_speed", "mph", "ball speed (mph)", 0.5), ("launch", "deg", "launch angle (deg)", 0.25))
FLIGHTS = (("carry", "yd", "carry (yd)", 2.0), ("side", "yd", "side (yd), right is positive", 2.0))


@styled
def dispersion_figure(of: Dispersion, shares: Indices | None = None, ellipses: tuple[float, ...] = SHARES) -> Figure:
    """Draw landings with ellipses that hold 50 and 90 % of them, histograms, and shares of the variance.

    Parameters
    ----------
    of
        The dispersion; of one without flight, launches alone are drawn.
    shares
        Which variables spread the outcomes; left out, no bars are drawn.
    ellipses
        Shares of the landings that the ellipses hold.
    """
    flies = bool(of.points.size)
    figure = Figure(figsize=(WIDTH, 4.6), layout="constrained")
    columns = 2 if flies else 1
    every = columns + (shares is not None)
    grid = figure.add_gridspec(2, every, width_ratios=[1.25, 1.0, 1.0][:every])
    lines: list[Any] = []
    if flies:
        lines = _landings(figure.add_subplot(grid[:, 0]), of, ellipses)
    for row, (name, unit, label, width) in enumerate(FLIGHTS if flies else LAUNCHES):
        panel = figure.add_subplot(grid[row, columns - 1])
        _histogram(panel, of, name, unit, label, width)
        if row == 0:
            panel.set_title(f"lines: {', '.join(f'{100 * each:.0f}' for each in MARKED)}% below")
    if shares is not None:
        for row, name in enumerate(shares.share):
            _bars(figure.add_subplot(grid[row, columns]), shares, name)
    legend_above(figure, lines, title=f"{of.golfer.title or of.golfer.name}: {of.count} shots by {of.model}")
    return figure


def _landings(panel: Any, of: Dispersion, ellipses: tuple[float, ...]) -> list[Any]:
    ahead, aside = from_si(of.points[:, 0], "yd"), from_si(of.points[:, 1], "yd")
    dots = panel.plot(aside, ahead, ".", color=COLOURS[0], markersize=1.5, alpha=0.5, label="landings")
    lines = [dots[0]]
    for place, share in enumerate(ellipses):
        found = of.ellipse(share)
        centre, axes = from_si(found.centre, "yd"), from_si(found.half_axes, "yd")
        # Across is to the right and ahead is up, so that the angle from ahead becomes one from the right.
        line = Outline(
            (centre[1], centre[0]), 2.0 * axes[0], 2.0 * axes[1], angle=90.0 - np.degrees(found.angle), fill=False,
            color=COLOURS[1], linestyle=("-", "--", ":")[place % 3], linewidth=1.3, zorder=3,
            label=f"{share:.0%} of the landings",
        )  # fmt: skip
        panel.add_patch(line)
        lines.append(line)
    panel.axvline(0.0, color="0.4", linewidth=0.8)
    panel.set_aspect("equal")
    # The few that are topped would make everything small.
    least, most = (from_si(of.quantile("carry", share), "yd") for share in (0.002, 0.999))
    panel.set_ylim(least - 0.2 * (most - least), most + 0.2 * (most - least))
    panel.set_xlabel("side (yd), right is positive")
    panel.set_ylabel("ahead (yd)")
    return lines


def _histogram(panel: Any, of: Dispersion, name: str, unit: str, label: str, width: float) -> None:
    edges, counts = of.tally.histogram(name, width * size(unit))
    shown = from_si(edges, unit)
    panel.stairs(counts / max(of.tally.counted, 1), shown, fill=True, color=COLOURS[0], alpha=0.6)
    for share in MARKED:
        panel.axvline(from_si(of.quantile(name, share), unit), color="0.3", linewidth=0.8, linestyle="--")
    least, most = (from_si(of.quantile(name, share), unit) for share in (0.001, 0.999))
    room = 0.15 * (most - least)
    panel.set_xlim(least - room, most + room)
    panel.set_xlabel(label)
    panel.set_ylabel("share of the shots")


def _bars(panel: Any, shares: Indices, name: str) -> None:
    order = np.argsort(shares.share[name])[-BARS:]
    panel.barh(np.arange(len(order)), 100.0 * shares.share[name][order], color=COLOURS[2])
    panel.set_yticks(np.arange(len(order)), [told(shares.variables[place]) for place in order])
    panel.set_xlabel(f"variance of {name} (%)")
    panel.grid(visible=False, axis="y")
